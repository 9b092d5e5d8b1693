# %% [markdown] lang="en"
# # 3. From state feedback to LQG
#
# *For students who know eigenvalues and the first notebook. You need two hours with the exercises.*
#
# We have a model of a robot that falls. Now we keep it up: first with the whole state in our hands, then with what its sensors show.
# %% [markdown] lang="es"
# # 3. De la realimentación de estado al LQG
#
# *Para estudiantes que conocen los autovalores y el primer cuaderno. Con los ejercicios toma dos horas.*
#
# Tenemos el modelo de un robot que cae. Ahora lo mantenemos en pie: primero con todo el estado en la mano, luego con lo que muestran sus
# sensores.

# %% lang="es"
import upright as up

up.language(
    "es",
    {
        "stays": "se queda",
        "runs away": "se aleja",
        "cheap": "barata",
        "dear": "cara",
        "LQR, true state": "LQR, estado verdadero",
        "LQG, sensors": "LQG, sensores",
    },
)  # figuras y tablas en español; lo que imprime print queda en inglés

# %%
import dataclasses

import numpy as np
from scipy.linalg import solve_discrete_are

import upright as up

robot, kit = up.Robot.preset("nxtway-gs"), up.Kit.preset("nxt")
period = 0.01  # [s]
model = up.linearise(robot).c2d(period)
print(np.round(np.abs(model.poles()), 4))

# %% [markdown] lang="en"
# ## Feedback by hand
#
# The feedback is $u = -K x$. A robot that leans forward has to drive forward, under its own centre of mass. So the gains of pitch are negative:
# $-K$ makes a positive voltage of a positive lean. Let us feed back the pitch, its rate and the rate of the wheels, and leave out where
# the wheels are.
# %% [markdown] lang="es"
# ## Realimentar a mano
#
# La realimentación es $u = -K x$. Un robot que se inclina hacia adelante tiene que avanzar, hasta quedar bajo su centro de masa. Por eso
# las ganancias de la inclinación son negativas: $-K$ hace de una inclinación positiva una tensión positiva. Realimentemos la inclinación, su
# velocidad y la velocidad de las ruedas, y dejemos fuera dónde están las ruedas.

# %%
push = up.Impulse(impulse=0.05, start=1.0)  # [N s] from behind


def pushed(law):
    return up.run(up.NonlinearBody(robot), law, push, seconds=6.0)


runs_away = up.StateFeedback.symmetric([-25.0, -2.3, 0.0, -1.0, 0.0, 0.0], period)
stays = up.StateFeedback.symmetric([-25.0, -2.3, -0.45, -1.0, 0.0, 0.0], period)
up.compare({"stays": pushed(stays), "runs away": pushed(runs_away)}).plot("pitch", "wheel")

# %% [markdown] lang="en"
# Both stand. But nothing asks the second one to come back: its pole at 1 is still there. A gain on the wheel angle brings it home. Look closely at the
# pitch: to come back the robot must lean back, and to lean back it first drives on.
#
# ## Let mathematics choose: LQR
#
# Four gains can be tried by hand. Better: say what you want. The linear quadratic regulator minimises
#
# $$
# J = \sum_k x_k^{\mathsf T} Q x_k + u_k^{\mathsf T} R u_k .
# $$
#
# Bryson's rule gives the weights: each is one over the square of the largest deviation that you accept. The solution is
#
# $$
# K = (R + B^{\mathsf T} P B)^{-1} B^{\mathsf T} P A, \qquad
# P = Q + A^{\mathsf T} P (A - B K),
# $$
#
# where the second line is Riccati's equation.
# %% [markdown] lang="es"
# Los dos quedan en pie. Pero nadie le dijo al segundo que volviera: su polo en 1 sigue ahí. Una ganancia en el ángulo de las ruedas lo trae a casa.
# Mire bien la inclinación: para volver, el robot debe inclinarse hacia atrás, y para inclinarse hacia atrás primero avanza más.
#
# ## Que elija la matemática: LQR
#
# Cuatro ganancias se pueden buscar a mano. Mejor: diga lo que quiere. El regulador lineal cuadrático minimiza
#
# $$
# J = \sum_k x_k^{\mathsf T} Q x_k + u_k^{\mathsf T} R u_k .
# $$
#
# La regla de Bryson da los pesos: cada uno es uno sobre el cuadrado de la mayor desviación que usted acepta. La solución es
#
# $$
# K = (R + B^{\mathsf T} P B)^{-1} B^{\mathsf T} P A, \qquad
# P = Q + A^{\mathsf T} P (A - B K),
# $$
#
# donde la segunda es la ecuación de Riccati.

# %%
largest = np.array([0.15, 1.5, 4.0, 15.0, 0.5, 3.0])  # accepted: pitch, its rate, wheel, its rate, yaw, its rate
Q, R = np.diag(largest**-2.0), np.eye(2) / 4.0**2  # 4 V


def riccati(Q, R):
    A, B = model.A, model.B
    P = solve_discrete_are(A, B, Q, R)
    return np.linalg.solve(R + B.T @ P @ B, B.T @ P @ A)


by_hand, law = riccati(Q, R), up.lqr_state(robot, period, Q, R)
print("by hand equals the library:", np.allclose(by_hand, law.gain))
print("left motor:", np.round(law.gain[0], 3))
print("poles of the closed loop:", np.round(np.sort(np.abs(np.linalg.eigvals(model.A - model.B @ law.gain))), 3))

# %% [markdown] lang="en"
# All poles are inside the unit circle. A small $R$ makes voltage cheap, a large one dear:
# %% [markdown] lang="es"
# Todos los polos están dentro del círculo unidad. Un $R$ pequeño hace barata la tensión, uno grande la hace cara:

# %%
weights = {"cheap": 0.1 * R, "Bryson": R, "dear": 100 * R}
compared = up.compare({name: pushed(up.lqr_state(robot, period, Q, weight)) for name, weight in weights.items()})
print(compared)
compared.plot("pitch", "wheel")

# %% [markdown] lang="en"
# The effort hardly differs: most of it pays for standing at all. What differs is how soon the robot comes home.
#
# ## What a robot sees
#
# So far we used the true state. A LEGO robot has two encoders (steps of 1°) and a gyro. An encoder sits on the body and reads
# $\theta_l - \psi$. Nothing measures pitch. The gyro measures its rate, so why not integrate?
# %% [markdown] lang="es"
# El esfuerzo casi no cambia: la mayor parte paga el solo estar en pie. Lo que cambia es cuán pronto vuelve el robot a casa.
#
# ## Lo que ve un robot
#
# Hasta aquí usamos el estado verdadero. Un robot LEGO tiene dos codificadores (pasos de 1°) y un giróscopo. Un codificador está en el
# cuerpo y lee $\theta_l - \psi$. Nada mide la inclinación. El giróscopo mide su velocidad: ¿por qué no integrarla?

# %%
body = up.Electronics(up.Twin(robot), kit)
filtered = up.Estimated(law, up.kalman(robot, kit))  # the regulator behind a filter
log = up.run(body, filtered, push, seconds=8.0, seed=1)

integrated = np.cumsum(log["sensor/gyro"]) * log.period
for name, pitch in {"integrated gyro": integrated, "Kalman filter": log["estimate/pitch"]}.items():
    error = np.degrees(pitch - log["truth/pitch"])
    print(f"{name:<16} largest error {np.abs(error).max():.2f}°, at the end {error[-1]:+.2f}°")
log.plot("truth/pitch", "estimate/pitch")

# %% [markdown] lang="en"
# A gyro has a bias: it reads a little turning where there is none, and the integral grows for ever. A *Kalman filter* does better since it knows the
# model. It predicts the next state, compares the predicted readings with the real ones, and corrects by the difference:
#
# $$
# \hat x_k = \hat x_k^- + L\,(y_k - C \hat x_k^-), \qquad \hat x_{k+1}^- = A \hat x_k + B u_k .
# $$
#
# Ours has two states more: the bias of the gyro and a steady push. A leaning robot accelerates, so the encoders know, after a
# while, what the pitch must have been.
#
# ## Two designs that do not disturb each other
#
# Put regulator and filter together. With the error $e = x - \hat x^-$ one finds
#
# $$
# \begin{bmatrix} x_{k+1} \\ e_{k+1} \end{bmatrix} =
# \begin{bmatrix} A - B K & \ast \\ 0 & A (I - L C) \end{bmatrix}
# \begin{bmatrix} x_k \\ e_k \end{bmatrix} .
# $$
#
# The zero is the *separation principle*: the poles of the whole are those of the regulator and those of the filter. We check it with the
# real matrices of our filter.
# %% [markdown] lang="es"
# Un giróscopo tiene un sesgo: lee un pequeño giro donde no lo hay, y la integral crece sin fin. Un *filtro de Kalman* lo hace mejor porque conoce el
# modelo. Predice el siguiente estado, compara las lecturas predichas con las reales y corrige según la diferencia:
#
# $$
# \hat x_k = \hat x_k^- + L\,(y_k - C \hat x_k^-), \qquad \hat x_{k+1}^- = A \hat x_k + B u_k .
# $$
#
# El nuestro tiene dos estados más: el sesgo del giróscopo y un empuje constante. Un robot inclinado acelera, así que los
# codificadores saben, al cabo de un rato, cuál tuvo que ser la inclinación.
#
# ## Dos diseños que no se estorban
#
# Junte el regulador y el filtro. Con el error $e = x - \hat x^-$ resulta
#
# $$
# \begin{bmatrix} x_{k+1} \\ e_{k+1} \end{bmatrix} =
# \begin{bmatrix} A - B K & \ast \\ 0 & A (I - L C) \end{bmatrix}
# \begin{bmatrix} x_k \\ e_k \end{bmatrix} .
# $$
#
# El cero es el *principio de separación*: los polos del conjunto son los del regulador y los del filtro. Lo comprobamos con las
# matrices reales de nuestro filtro.

# %%
kalman = up.kalman(robot, kit)
A, B, C, L = kalman.A, kalman.B, kalman.C, kalman.L
K = np.hstack([law.gain, np.zeros((2, 2))])  # bias and push are not fed back
now = np.eye(8) - L @ C
whole = np.block([[A - B @ K @ L @ C, -B @ K @ now], [A @ L @ C - B @ K @ L @ C, (A - B @ K) @ now]])  # of x and x̂⁻
separate = np.concatenate([np.linalg.eigvals(A - B @ K), np.linalg.eigvals(A @ now)])
together = np.linalg.eigvals(whole)
print("largest distance:", f"{max(np.abs(together - pole).min() for pole in separate):.1e}")

# %% [markdown] lang="en"
# ## LQG
#
# Regulator and filter with the right weights are called LQG. The library's also knows the dead time of the kit:
# %% [markdown] lang="es"
# ## LQG
#
# El regulador y el filtro con los pesos adecuados se llaman LQG. El de la biblioteca conoce además el tiempo muerto del kit:

# %%
lqg = up.lqg(robot, kit)
on_sensors = up.run(body, lqg, push, seconds=6.0, seed=1)
true_state = up.run(up.Twin(robot), up.lqr_state(robot, period), push, seconds=6.0)
up.compare({"LQR, true state": true_state, "LQG, sensors": on_sensors}).plot("pitch", "wheel")

# %% [markdown] lang="en"
# The robot with sensors shivers, since its encoders have steps and its motors a dead zone. It also wanders, until the filter knows the bias of its gyro. But it
# survives, with nothing that a LEGO robot does not have.
#
# ## With your own hand
#
# The same robot as a page: drag its body, or knock it. *Gains by hand* begins with the regulator's. Set the one of $\theta$ to zero: it runs away, as above.
# %% [markdown] lang="es"
# El robot con sensores tiembla, porque sus codificadores tienen pasos y sus motores una zona muerta. También deambula, hasta que el filtro conoce el sesgo del
# giróscopo. Pero sobrevive, sin nada que un robot LEGO no tenga.
#
# ## Con su propia mano
#
# El mismo robot como página: arrastre su cuerpo o golpéelo. *Ganancias a mano* empieza con las del regulador. Ponga en cero la de $\theta$: se escapa, como antes.

# %%
up.lab_page(robot, ["lqg", "lqr"], push="impulse:0.1", folder="lab-lqg")

# %% [markdown] lang="en"
# ## Exercises
#
# **1.** Make voltage dearer and dearer (`1e2 * R`, `1e4 * R`, `1e6 * R`). To which value does the largest pole of the pitch go? Compare with
# $e^{-\lambda T}$, where $\lambda$ is the falling pole.
# %% [markdown] lang="es"
# ## Ejercicios
#
# **1.** Haga la tensión cada vez más cara (`1e2 * R`, `1e4 * R`, `1e6 * R`). ¿A qué valor va el polo de la inclinación? Compare con
# $e^{-\lambda T}$, donde $\lambda$ es el polo de la caída.

# %% tags=["answer"]
falling = up.linearise(robot).poles()[0].real
print(f"e^(-λT) = {np.exp(-falling * period):.4f}")
for factor in (1, 1e2, 1e4, 1e6):
    gain = riccati(Q, factor * R)
    print(f"{factor:8.0f} R:", np.round(np.sort(np.abs(np.linalg.eigvals(model.A - model.B @ gain))), 4))

# %% [markdown] lang="en" tags=["answer"]
# One pole stays at $e^{-\lambda T} = 0.928$: the cheapest way to stop a fall is to mirror its pole. The gain does not go to zero, since some voltage
# is needed to stand at all. The poles of wheel and yaw go to 1: coming back is a luxury. (Two poles near 0.93 belong to the fall mirrored and to
# the stable twin of the fall.)
# %% [markdown] lang="es" tags=["answer"]
# Un polo se queda en $e^{-\lambda T} = 0.928$: la manera más barata de detener una caída es reflejar su polo. La ganancia no va a cero, pues
# alguna tensión hace falta para estar en pie. Los polos de rueda y rumbo van a 1: volver es un lujo. (Dos polos cerca de 0.93 son el de la
# caída reflejado y el gemelo estable de la caída.)

# %% [markdown] lang="en"
# **2.** Give the gyro five times its noise, and do not tell the filter. Does the robot stand? How much larger is the error of the
# estimate?
# %% [markdown] lang="es"
# **2.** Dele al giróscopo cinco veces su ruido y no se lo diga al filtro. ¿Queda en pie el robot? ¿Cuánto mayor es el error de la
# estimación?


# %% tags=["answer"]
def with_gyro(**changes):
    gyro = dataclasses.replace(kit.sensors["sensor/gyro"], **changes)
    return dataclasses.replace(kit, sensors={**kit.sensors, "sensor/gyro": gyro})


noise = kit.sensors["sensor/gyro"].noise
for factor in (1, 5):
    noisy = up.Electronics(up.Twin(robot), with_gyro(noise=factor * noise))
    log = up.run(noisy, up.lqg(robot, kit), push, seconds=6.0, seed=1)
    error = np.degrees(np.std(log["estimate/pitch"] - log["truth/pitch"]))
    print(f"noise × {factor}: fell {log.origin['outcome']['fell']}, error {error:.2f}°")

# %% [markdown] lang="en"
# **3.** Give the gyro a bias of 0.05 rad/s (3°/s). Which survives it: `up.kalman` or `up.complementary`, a filter without a model?
# %% [markdown] lang="es"
# **3.** Dele al giróscopo un sesgo de 0.05 rad/s (3°/s). ¿Cuál lo soporta: `up.kalman` o `up.complementary`, un filtro sin modelo?

# %% tags=["answer"]
biased = up.Electronics(up.Twin(robot), with_gyro(bias=0.05))
for make in (up.kalman, up.complementary):
    log = up.run(biased, up.Estimated(law, make(robot, kit)), seconds=8.0, seed=1)
    travel = np.abs(log["truth/wheel"]).max() * robot.wheel_radius
    print(f"{make.__name__:<13} fell {log.origin['outcome']['fell']}, rolled {travel:.2f} m")

# %% [markdown] lang="en"
# **4.** In the separation principle the filter knew the robot exactly. Move the centre of mass by 30 % in the robot that runs, not in the design.
# What happens? This is where the next notebook begins.
# %% [markdown] lang="es"
# **4.** En el principio de separación el filtro conocía exactamente al robot. Mueva el centro de masa en 30 % en el robot que corre, no en
# el diseño. ¿Qué pasa? Ahí empieza el siguiente cuaderno.

# %% tags=["answer"]
for factor in (0.7, 1.0, 1.3):
    other = robot.replace(com_height=factor * robot.com_height)
    log = up.run(up.Electronics(up.Twin(other), kit), up.lqg(robot, kit), push, seconds=6.0, seed=1)
    print(
        f"{factor:.1f} L: fell {log.origin['outcome']['fell']}, largest lean {np.abs(log['truth/pitch']).max():.3f} rad"
    )

# %% [markdown] lang="en"
# ## What comes next
#
# A model is never exact, and a computer is never on time. [The next notebook](4_robustness.ipynb) asks how much of both a loop survives.
# %% [markdown] lang="es"
# ## Lo que sigue
#
# Un modelo nunca es exacto y un computador nunca es puntual. [El siguiente cuaderno](4_robustness.ipynb) pregunta cuánto de ambas cosas
# soporta un lazo.
