# %% [markdown] lang="en"
# # 6. Your own robot
#
# *For everybody with a robot, or with a plan for one. You need one to two hours, and kitchen scales if you have a robot.*
#
# In this notebook every number is yours to change. It goes through with a made-up robot, so that you can run it first.
# %% [markdown] lang="es"
# # 6. Su propio robot
#
# *Para todos los que tienen un robot, o el plan de uno. Toma de una a dos horas, y una balanza de cocina si tiene un robot.*
#
# En este cuaderno cada número es suyo y se puede cambiar. Funciona con un robot inventado, para que pueda ejecutarlo primero.

# %% [markdown] lang="en"
# ## 1. Measure
#
# | number | how |
# |---|---|
# | `wheel_radius`, `track` | a ruler; roll ten turns and divide by $20\pi$ |
# | `wheel_mass`, `body_mass` | scales; the body is all but the wheels |
# | `com_height` | lay the body across an edge until it balances; measure from there to the axle |
# | `pitch_inertia` | hang the body by its axle and let it swing |
# | motor | the data sheet: resistance, torque constant, gear |
#
# The swing is worth an explanation. A body that hangs from its axle is a pendulum with the period
#
# $$
# T = 2\pi \sqrt{\frac{J_\psi + M L^2}{M g L}} \quad\Rightarrow\quad J_\psi = M g L \left(\frac{T}{2\pi}\right)^2 - M L^2 .
# $$
# %% [markdown] lang="es"
# ## 1. Mida
#
# | número | cómo |
# |---|---|
# | `wheel_radius`, `track` | una regla; ruede diez vueltas y divida por $20\pi$ |
# | `wheel_mass`, `body_mass` | una balanza; el cuerpo es todo menos las ruedas |
# | `com_height` | ponga el cuerpo sobre un canto hasta que se equilibre; mida de allí al eje |
# | `pitch_inertia` | cuelgue el cuerpo de su eje y déjelo oscilar |
# | motor | la hoja de datos: resistencia, constante de par, reducción |
#
# La oscilación merece una explicación. Un cuerpo que cuelga de su eje es un péndulo de período
#
# $$
# T = 2\pi \sqrt{\frac{J_\psi + M L^2}{M g L}} \quad\Rightarrow\quad J_\psi = M g L \left(\frac{T}{2\pi}\right)^2 - M L^2 .
# $$

# %% lang="es"
import upright as up

up.language("es", {"hand-made": "hecho a mano"})  # figuras y tablas en español; lo que imprime print queda en inglés

# %%
import numpy as np

import upright as up

g = 9.81  # [m/s²]
body_mass, com_height = 0.72, 0.095  # [kg], [m]
ten_swings = 7.1  # [s]
pitch_inertia = body_mass * g * com_height * (ten_swings / 10 / (2 * np.pi)) ** 2 - body_mass * com_height**2
print(f"pitch inertia {pitch_inertia:.2e} kg m²")

# %% [markdown] lang="en"
# ## 2. Write it down
#
# Begin with the nearest preset and replace what you have measured. What you leave keeps the preset's number.
# %% [markdown] lang="es"
# ## 2. Anótelo
#
# Empiece con el robot más parecido de la lista y reemplace lo que midió. Lo demás conserva su número.

# %%
lego = up.Robot.preset("nxtway-gs")
mine = lego.replace(
    name="mine",
    title="My robot",
    wheel_radius=0.028,
    body_mass=body_mass,
    com_height=com_height,
    pitch_inertia=pitch_inertia,
)
mine.save("mine.toml")
print("\n".join(mine.to_toml().splitlines()[:12]))

# %% [markdown] lang="en"
# The file `mine.toml` has each number with its unit, source and spread. Edit it: write where each number is from, and how much you trust it.
# `up.Robot.load("mine.toml")` reads it, and so does every command with `--robot mine.toml`. A number that cannot be is refused:
# %% [markdown] lang="es"
# El archivo `mine.toml` tiene cada número con su unidad, procedencia e incertidumbre. Edítelo: escriba de dónde es cada número y cuánto confía en él.
# `up.Robot.load("mine.toml")` lo lee, y también cada comando con `--robot mine.toml`. Un número imposible se rechaza:

# %%
try:
    mine.replace(wheel_radius=28.0)  # millimetres?
except up.UprightError as error:
    print(error)

# %% [markdown] lang="en"
# ## 3. What will it be like?
#
# Before anything is built: how fast does it fall, and what do the motors have against it? At rest at a lean $\psi$ gravity's moment is $M g L \sin\psi$. Both motors
# at their largest voltage give $2 \alpha v$.
# %% [markdown] lang="es"
# ## 3. ¿Cómo será?
#
# Antes de construir nada: ¿cómo de rápido cae, y qué tienen los motores contra eso? En reposo con inclinación $\psi$ el momento de la gravedad es
# $M g L \sin\psi$. Los dos motores con su mayor tensión dan $2 \alpha v$.

# %%
for robot in (lego, mine):
    pole = up.linearise(robot).poles()[0].real
    alpha = robot.gear_ratio * robot.torque_constant / robot.motor_resistance
    strength = 2 * alpha * 8.0 / (robot.body_mass * g * robot.com_height)
    print(
        f"{robot.name:<10} falls e-fold in {1000 / pole:.0f} ms; its motors have {strength:.1f} times its weight's full moment"
    )

# %% [markdown] lang="en"
# ## 4. A controller of your own
#
# A controller is a class with six methods. This one multiplies four measured numbers by four gains that somebody chose. It reads the true state,
# so it is a first sketch; a real one reads `sensor/…`.
# %% [markdown] lang="es"
# ## 4. Un controlador propio
#
# Un controlador es una clase con seis métodos. Este multiplica cuatro números medidos por cuatro ganancias que alguien eligió. Lee el estado
# verdadero, así que es un primer boceto; uno real lee `sensor/…`.

# %%
from upright.control import ControllerSpec


class HandMade:
    def __init__(self, gains, period=0.01):
        self.gains = gains  # of pitch, pitch rate, wheel, wheel rate
        reads = ("truth/pitch", "truth/pitch_rate", "truth/wheel", "truth/wheel_rate")
        self.spec = ControllerSpec("hand-made", reads, period)

    def reset(self):
        """Nothing is remembered."""

    def step(self, measurement, reference):
        volts = sum(gain * value for gain, value in zip(self.gains, measurement, strict=True))
        return volts, volts

    def estimate(self):
        return ()

    def applied(self, command):
        """What the motors did does not matter to it."""

    def to_json(self):
        return {"kind": "hand-made", "gains": list(self.gains)}


push = up.Impulse(impulse=0.05, start=1.0)
logs = {
    "LQR": up.run(up.Twin(mine), up.lqr_state(mine, 0.01), push, seconds=5.0),
    "hand-made": up.run(up.Twin(mine), HandMade((25.0, 2.5, 0.5, 1.0)), push, seconds=5.0),
}
compared = up.compare(logs)
print(compared)
compared.plot("pitch", "wheel")

# %% [markdown] lang="en"
# ## 5. The verdict
#
# With sensors, battery and dead time, and for all robots that your uncertainty allows. Where a spread is missing, the number counts as right within a factor of
# two, and the certificate is as hard as that.
# %% [markdown] lang="es"
# ## 5. El veredicto
#
# Con sensores, batería y tiempo muerto, y para todos los robots que su incertidumbre permite. Donde falta la incertidumbre, el número vale dentro de un
# factor de dos, y el certificado es así de duro.

# %%
kit = up.Kit.preset("nxt")
controller = up.lqg(mine, kit)
certificate = up.certify(controller, mine, kit, samples=200, sweeps=False)
print(certificate)
certificate.plot()

# %% [markdown] lang="en"
# Now state how well you measured: 1 % for the scales, 3 % for lengths, 10 % for the inertia.
# %% [markdown] lang="es"
# Ahora diga cuán bien midió: 1 % la balanza, 3 % las longitudes, 10 % la inercia.

# %%
text = mine.to_toml()
for name, percent in {"body_mass": 1, "wheel_radius": 3, "com_height": 3, "pitch_inertia": 10}.items():
    head, rest = text.split(f"[{name}]\n")
    value, rest = rest.split("\n", 1)
    size = float(value.split("=")[1]) * percent / 100
    text = f"{head}[{name}]\n{value}\nspread = {size:.3g}\n{rest}"
with open("mine.toml", "w", encoding="utf-8") as file:
    file.write(text)
measured = up.Robot.load("mine.toml")
better = up.certify(up.lqg(measured, kit), measured, kit, samples=200, sweeps=False)
for name, each in {"guessed": certificate, "measured": better}.items():
    print(f"{name:<9} {each.light}: {each.reasons[0]}")

# %% [markdown] lang="en"
# ## 6. Push it
#
# Your robot as a page, which you can also give away: it runs in any browser, without Python.
# %% [markdown] lang="es"
# ## 6. Empújelo
#
# Su robot como página, que también puede regalar: funciona en cualquier navegador, sin Python.

# %%
up.lab_page(measured, ["lqg"], push="impulse:0.05", folder="lab-mine")

# %% [markdown] lang="en"
# ## Exercises
#
# **1.** Enter your own robot, or one that you would like to build. Which single number makes it fall faster if it is 20 % wrong?
# %% [markdown] lang="es"
# ## Ejercicios
#
# **1.** Ponga su propio robot, o uno que le gustaría construir. ¿Qué número, con un error de 20 %, lo hace caer más rápido?

# %% tags=["answer"]
pole = up.linearise(mine).poles()[0].real
changes = {}
for name, value in [(p["name"], p["value"]) for p in mine.parameters()]:
    if value and name not in ("gravity", "body_depth", "body_height", "stiction_rate"):
        changes[name] = max(up.linearise(mine.replace(**{name: f * value})).poles()[0].real - pole for f in (0.8, 1.2))
for name in sorted(changes, key=changes.get, reverse=True)[:5]:
    print(f"{name:<16} {changes[name]:+.2f} 1/s")

# %% [markdown] lang="en"
# **2.** Leave out the third gain of `HandMade`, then the fourth. What does each do for the robot?
# %% [markdown] lang="es"
# **2.** Quite la tercera ganancia de `HandMade`, luego la cuarta. ¿Qué hace cada una por el robot?

# %% tags=["answer"]
for gains in ((25.0, 2.5, 0.5, 1.0), (25.0, 2.5, 0.0, 1.0), (25.0, 2.5, 0.5, 0.0)):
    log = up.run(up.Twin(mine), HandMade(gains), push, seconds=5.0)
    end = log["truth/wheel"][-1] * mine.wheel_radius
    print(f"{gains}: fell {log.origin['outcome']['fell']}, at the end {end:+.2f} m from the start")

# %% [markdown] lang="en" tags=["answer"]
# Without the wheel angle it stands, but nothing calls it back: it stays where the push left it (here a centimetre further). Without the wheel rate nothing brakes the wheels, and it rolls away under the lean or falls.
# %% [markdown] lang="es" tags=["answer"]
# Sin el ángulo de la rueda queda en pie, pero nada lo llama de vuelta: se queda donde lo dejó el empujón (aquí a un centímetro). Sin la velocidad de la rueda nada frena las ruedas, y rueda lejos o se cae.

# %% [markdown] lang="en"
# **3.** Find the largest knock that your robot survives under LQG, to 0.01 N s, by bisection. Is it the motors that limit it? Look at `applied/left` in the log.
# %% [markdown] lang="es"
# **3.** Busque por bisección, con 0.01 N s de exactitud, el mayor golpe que su robot soporta con LQG. ¿Lo limitan los motores? Mire `applied/left` en el registro.


# %% tags=["answer"]
def knocked(impulse):
    body = up.Electronics(up.Twin(mine), kit)
    return up.run(body, controller, up.Impulse(impulse=impulse, start=0.5), seconds=2.5, seed=1)


low, high = 0.0, 1.0
while high - low > 0.01:
    middle = (low + high) / 2
    low, high = (low, middle) if knocked(middle).origin["outcome"]["fell"] else (middle, high)
print(f"largest knock {low:.2f} N s, largest voltage {np.abs(knocked(low)['applied/left']).max():.1f} V")

# %% [markdown] lang="en"
# ## And now
#
# Record a log of the real one: `upright doctor`, `calibrate`, `validate`, `certify`, as in notebook 5. *Programs for bricks* in the documentation says how the
# controller gets onto it.
# %% [markdown] lang="es"
# ## Y ahora
#
# Grabe un registro del robot real: `upright doctor`, `calibrate`, `validate`, `certify`, como en el cuaderno 5. *Programs for bricks* en la documentación dice
# cómo llega el controlador al robot.
