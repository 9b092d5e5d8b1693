# %% [markdown] lang="en"
# # 4. Robustness and delay
#
# *For students who know Nyquist's criterion and the third notebook. You need one to two hours with the exercises.*
#
# A controller is designed for a model, and runs on a robot. The battery is weaker, the gyro is late, the centre of mass is elsewhere. How
# much of this does the loop survive? We compute it first, and then let the robot say whether it is true.
# %% [markdown] lang="es"
# # 4. Robustez y retardo
#
# *Para estudiantes que conocen el criterio de Nyquist y el tercer cuaderno. Con los ejercicios toma de una a dos horas.*
#
# Un controlador se diseña para un modelo y corre en un robot. La batería es más débil, el giróscopo llega tarde, el centro de masa está en
# otra parte. ¿Cuánto de esto soporta el lazo? Primero lo calculamos y luego dejamos que el robot diga si es verdad.

# %% lang="es"
import upright as up

up.language("es")  # figuras y tablas en español; lo que imprime print queda en inglés

# %%
import dataclasses

import numpy as np

import upright as up

robot, kit = up.Robot.preset("nxtway-gs"), up.Kit.preset("nxt")
designed = up.design("lqg", robot, kit)
analysis = designed.analysis
analysis

# %% [markdown] lang="en"
# ## One point decides
#
# Cut the loop at the motors and follow a sine once round: it comes back multiplied by the loop gain $L(j\omega)$. If it came back as $-1$ times
# itself, the loop would swing for ever. So everything is in the distance from $-1$:
#
# $$
# \min_\omega |1 + L(j\omega)| = \frac{1}{M_s}, \qquad M_s = \max_\omega |S(j\omega)|, \quad S = \frac{1}{1 + L}.
# $$
# %% [markdown] lang="es"
# ## Un punto decide
#
# Corte el lazo en los motores y siga a un seno una vuelta: vuelve multiplicado por la ganancia de lazo $L(j\omega)$. Si volviera como $-1$ veces él
# mismo, el lazo oscilaría para siempre. Por eso todo está en la distancia a $-1$:
#
# $$
# \min_\omega |1 + L(j\omega)| = \frac{1}{M_s}, \qquad M_s = \max_\omega |S(j\omega)|, \quad S = \frac{1}{1 + L}.
# $$

# %%
both = analysis.both()
print(f"Ms = {both.Ms:.2f}: the curve comes as near as {1 / both.Ms:.2f}")
print(f"motors may have between {100 * both.gain_low:.0f} and {100 * both.gain_high:.0f} % of their strength")
analysis.plot_nyquist()

# %% [markdown] lang="en"
# The robot falls by itself, so the curve has to go *round* $-1$ to hold it. For that reason there are two limits of the gain: too strong and
# too weak. A robot that stands by itself has no lower one.
#
# ## Ask the robot
#
# A motor at 60 % of its strength, is that really too little? We give both motors a factor that the controller does not know.
# %% [markdown] lang="es"
# El robot cae por sí solo, así que la curva tiene que *rodear* a $-1$ para sostenerlo. Por eso la ganancia tiene dos límites: demasiado fuerte y
# demasiado débil. Un robot que se sostiene solo no tiene límite inferior.
#
# ## Pregunte al robot
#
# Un motor al 60 % de su fuerza, ¿es de verdad muy poco? Damos a ambos motores un factor que el controlador no conoce.

# %%
smooth = {
    name: dataclasses.replace(sensor, quantum=0.0, noise=0.0, bias=0.0, bias_walk=0.0)
    for name, sensor in kit.sensors.items()
}


def electronics(strength=1.0, motor_late=0.0, gyro_late=0.0):
    """The kit without steps and noise, as a linear analysis sees it, with weaker motors and later signals [s]."""
    motor = dataclasses.replace(kit.motor, left=strength, right=strength, dead_zone=0.0, quantum=0.0)
    gyro = dataclasses.replace(smooth["sensor/gyro"], delay=gyro_late)
    sensors = {**smooth, "sensor/gyro": gyro}
    return dataclasses.replace(kit, motor=motor, sensors=sensors, delay=kit.delay + motor_late, jitter=0.0)


def growth(controller, parts, seconds=6.0):
    """The swing of the last third of a run over that of the third before: above 1 it grows."""
    body = up.Electronics(up.NonlinearBody(robot), parts)
    log = up.run(body, controller, up.Impulse(impulse=1e-5, start=0.0), seconds=seconds)
    size = np.abs(log["truth/pitch"])
    third = len(size) // 3
    return size[-third:].max() / size[-2 * third : -third].max()


for strength in (0.55, 0.60, 0.66, 1.00, 1.15, 1.40):
    print(f"motors at {100 * strength:3.0f} %: × {growth(designed.controller, electronics(strength), 12.0):.3f}")

# %% [markdown] lang="en"
# The limits of 63 and 129 % are true. Beyond the lower one it falls soon. Beyond the upper one it swings, slowly growing.
#
# Note what was *not* promised: a margin for gains is no margin for delays.
#
# ## Delay
#
# A delay $\tau$ multiplies the loop by $e^{-j\omega\tau}$: the magnitude stays, the phase is late. The table says that the gyro alone may be
# 8.5 ms late, and no more.
# %% [markdown] lang="es"
# Los límites de 63 y 129 % son ciertos. Por debajo del inferior cae pronto. Por encima del superior oscila y crece despacio.
#
# Note lo que *no* se prometió: un margen para ganancias no es un margen para retardos.
#
# ## Retardo
#
# Un retardo $\tau$ multiplica el lazo por $e^{-j\omega\tau}$: la magnitud queda, la fase llega tarde. La tabla dice que el giróscopo solo puede
# llegar 8.5 ms tarde, y no más.

# %%
for late in (0.002, 0.004, 0.006, 0.009, 0.010):
    print(f"gyro {1000 * late:2.0f} ms late: × {growth(designed.controller, electronics(gyro_late=late)):.3f}")

# %% [markdown] lang="en"
# Six milliseconds die out, nine grow. That is less than one period of the controller! Both encoders together with the gyro say where
# the body is. When the gyro alone is late, the two contradict each other, and the filter believes the wrong one.
#
# ## What no controller can do
#
# Let $p$ be the falling pole and $\tau$ the delay of the loop. Whatever the controller, the complementary sensitivity $T = L / (1 + L)$ must have $T(p) = 1$
# and must carry the delay. By the maximum principle
#
# $$
# \max_\omega |T(j\omega)| \ge e^{p \tau}.
# $$
#
# The faster a robot falls and the later the loop, the more it amplifies. No mathematics mends that; a taller robot or a faster
# computer does.
# %% [markdown] lang="es"
# Seis milisegundos se extinguen, nueve crecen. ¡Es menos de un período del controlador! Los codificadores y el giróscopo juntos dicen dónde está
# el cuerpo. Si solo el giróscopo llega tarde, ambos se contradicen, y el filtro le cree al equivocado.
#
# ## Lo que ningún controlador puede
#
# Sea $p$ el polo de la caída y $\tau$ el retardo del lazo. Con cualquier controlador la sensibilidad complementaria $T = L / (1 + L)$ debe cumplir
# $T(p) = 1$ y lleva consigo el retardo. Por el principio del máximo
#
# $$
# \max_\omega |T(j\omega)| \ge e^{p \tau}.
# $$
#
# Cuanto más rápido cae el robot y más tarde llega el lazo, más amplifica. Eso no lo arregla la matemática; sí un robot más alto o un
# computador más rápido.

# %%
falling = up.linearise(robot).poles()[0].real
for tau in (0.005, 0.02, 0.05, 0.1):
    print(f"{1000 * tau:3.0f} ms: at least {np.exp(falling * tau):.2f}")
print(f"this loop: {both.Mt:.2f}")

# %% [markdown] lang="en"
# ## Another method: H∞
#
# LQG minimises a mean. H∞ minimises the worst case, and asks for distance from $-1$.
# %% [markdown] lang="es"
# ## Otro método: H∞
#
# LQG minimiza una media. H∞ minimiza el peor caso, y pide distancia a $-1$.

# %%
robustly = up.design("hinf", robot, kit)
robustly.analysis

# %%
other = robustly.analysis.both()
print(f"Ms {other.Ms:.2f} instead of {both.Ms:.2f}")
print(f"motors between {100 * other.gain_low:.0f} and {100 * other.gain_high:.0f} %")
for late in (0.004, 0.006, 0.008, 0.010, 0.014, 0.020):
    print(f"motors {1000 * late:2.0f} ms later: × {growth(robustly.controller, electronics(motor_late=late), 3.0):.3f}")

# %% [markdown] lang="en"
# It takes motors of a seventh to three times their strength. But the motors may come only 6.5 ms later. Everything has a price. And look at the last
# two rows: at 14 ms the loop is stable *again*. A delay margin speaks of the first limit only.
#
# ## A thousand robots
#
# Margins change one thing at a time. Real robots differ in everything. So we draw a thousand of them, and push each one.
# %% [markdown] lang="es"
# Soporta motores de un séptimo a tres veces su fuerza. Pero los motores solo pueden llegar 6.5 ms más tarde. Todo tiene su precio. Y mire las dos
# últimas filas: con 14 ms el lazo es estable *otra vez*. Un margen de retardo solo habla del primer límite.
#
# ## Mil robots
#
# Los márgenes cambian una cosa a la vez. Los robots reales difieren en todo. Por eso sacamos mil a la suerte y empujamos a cada uno.

# %%
vary = {"com_height": "±40%", "torque_constant": "±40%", "body_mass": "±30%"}
push = up.Impulse(impulse=0.3, start=0.5)  # strong
for design in (designed, robustly):
    many = up.fleet(robot, n=1000, controller=design.controller, vary=vary, pushes=(push,), seconds=4.0)
    print(f"{design.method}: {int(many.data['fell'].sum())} of 1000 fell")
many.plot("travel")

# %% [markdown] lang="en"
# The margins of H∞ are several times as large, and yet as many robots fall. A strong push is a question of the motors, not of margins: who has not got the torque
# falls under every controller.
#
# ## Exercises
#
# **1.** Find the lower limit of the motors' strength on the simulated robot within 1 %, by bisection with `growth`. Compare with `both.gain_low`.
# %% [markdown] lang="es"
# Los márgenes de H∞ son varias veces mayores, y sin embargo caen otros tantos robots. Un empujón fuerte es cuestión de motores, no de márgenes: quien no tiene el par
# se cae con cualquier controlador.
#
# ## Ejercicios
#
# **1.** Encuentre con `growth`, por bisección y con 1 % de exactitud, el límite inferior de la fuerza de los motores en el robot simulado. Compare con
# `both.gain_low`.

# %% tags=["answer"]
low, high = 0.5, 0.8
while high - low > 0.01:
    middle = (low + high) / 2
    grows = growth(designed.controller, electronics(middle), 12.0) > 1
    low, high = (middle, high) if grows else (low, middle)
print(f"between {low:.3f} and {high:.3f}; computed {both.gain_low:.3f}")

# %% [markdown] lang="en"
# **2.** $1/M_s$ bounds both margins: show from the geometry that the gain margin upwards is at least $M_s / (M_s - 1)$, where the curve crosses the real
# axis between $-1$ and $0$. Does our loop obey?
# %% [markdown] lang="es"
# **2.** $1/M_s$ acota los márgenes: muestre por geometría que el margen de ganancia hacia arriba es al menos $M_s / (M_s - 1)$, si la curva cruza el eje
# real entre $-1$ y $0$. ¿Lo cumple nuestro lazo?

# %% tags=["answer"]
print(f"at least {both.Ms / (both.Ms - 1):.3f}, is {both.gain_high:.3f}")

# %% [markdown] lang="en" tags=["answer"]
# Where $L = -x$ is real with $0 < x < 1$, the distance from $-1$ is $1 - x \ge 1/M_s$. So $x \le 1 - 1/M_s$, and the gain may grow by
# $1/x \ge M_s / (M_s - 1)$.
# %% [markdown] lang="es" tags=["answer"]
# Donde $L = -x$ es real con $0 < x < 1$, la distancia a $-1$ es $1 - x \ge 1/M_s$. Entonces $x \le 1 - 1/M_s$, y la ganancia puede crecer
# $1/x \ge M_s / (M_s - 1)$.

# %% [markdown] lang="en"
# **3.** Make the regulator lazier: `up.lqg(robot, kit, Q=..., R=...)` with $R$ a hundred times as large. What happens to the growth at 60 % of the strength? Why can
# a robot that falls by itself not have a lazy controller?
# %% [markdown] lang="es"
# **3.** Haga más perezoso al regulador: `up.lqg(robot, kit, Q=..., R=...)` con $R$ cien veces mayor. ¿Qué pasa con el crecimiento al 60 % de la fuerza? ¿Por
# qué un robot que cae solo no puede tener un controlador perezoso?

# %% tags=["answer"]
largest = np.array([0.15, 1.5, 4.0, 15.0, 0.5, 3.0])
lazy = up.lqg(robot, kit, Q=np.diag(largest**-2), R=100 * np.eye(2) / 4.0**2)
for strength in (0.5, 0.6, 0.7, 1.0):
    print(f"lazy, motors at {100 * strength:3.0f} %: × {growth(lazy, electronics(strength)):.3f}")

# %% [markdown] lang="en" tags=["answer"]
# It stands at 100 % and its lower limit hardly moves: the cheapest gain is the one that mirrors the falling pole (notebook 3), and it is not small. Below
# some strength nothing holds the robot.
# %% [markdown] lang="es" tags=["answer"]
# Queda en pie al 100 % y su límite inferior casi no se mueve: la ganancia más barata es la que refleja el polo de la caída (cuaderno 3), y no es
# pequeña. Por debajo de cierta fuerza nada sostiene al robot.

# %% [markdown] lang="en"
# ## What comes next
#
# Here we knew the robot. [The next notebook](5_certificate.ipynb) begins with a log and ends with a verdict.
# %% [markdown] lang="es"
# ## Lo que sigue
#
# Aquí conocíamos al robot. [El siguiente cuaderno](5_certificate.ipynb) empieza con un registro y termina con un veredicto.
