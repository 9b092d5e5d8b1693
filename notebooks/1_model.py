# %% [markdown] lang="en"
# # 1. Model and linearisation
#
# *For students who know matrices and derivatives. You need one to two hours with the exercises.*
#
# A robot on two wheels falls like a pencil on its tip. To keep it up we must first know how it falls. In this notebook we write
# its equations of motion, make them linear, and see where the linear model stops being true.
#
# The robot is that of Herrera, Chamorro, Gómez and Camacho (2015): a LEGO NXT, a gyro, two motors. The paper prints a linear model,
# and the numbers below are those that this model fixes.
# %% [markdown] lang="es"
# # 1. Modelo y linealización
#
# *Para estudiantes que conocen matrices y derivadas. Con los ejercicios toma de una a dos horas.*
#
# Un robot de dos ruedas cae como un lápiz parado sobre su punta. Para mantenerlo en pie hay que saber primero cómo cae. En este
# cuaderno escribimos sus ecuaciones de movimiento, las linealizamos y vemos dónde el modelo lineal deja de ser cierto.
#
# El robot es el de Herrera, Chamorro, Gómez y Camacho (2015): un LEGO NXT, un giróscopo y dos motores. El artículo publica un
# modelo lineal; los números de abajo son los que ese modelo determina.

# %% lang="es"
import upright as up

up.language("es")  # figuras y tablas en español; lo que imprime print queda en inglés

# %%
import numpy as np

import upright as up

robot = up.Robot.preset("herrera2015")
robot

# %% [markdown] lang="en"
# Each number has a unit, a source and a spread. A number that nobody measured is called a *guess*: it may be wrong by a factor of two.
#
# ## Three angles
#
# | symbol | meaning |
# |---|---|
# | $\psi$ | pitch: lean of the body, positive forward |
# | $\theta$ | mean angle of the wheels, positive when the robot rolls forward |
# | $\varphi$ | yaw: heading, positive to the left |
#
# The state is $x = [\psi, \dot\psi, \theta, \dot\theta, \varphi, \dot\varphi]$, and the command $u = [v_l, v_r]$ holds the two motor
# voltages. Here we need only pitch and wheels; turning is a problem of its own.
#
# ## From energies to equations
#
# Let the robot roll straight ahead. The axle moves at $R\dot\theta$, and the centre of mass sits at a height $L$ above it. The kinetic and the
# potential energy are
#
# $$
# \begin{aligned}
# T &= \tfrac12 a_{11} \dot\theta^2 + a_{12}(\psi)\, \dot\theta \dot\psi + \tfrac12 a_{22} \dot\psi^2 \\
# V &= M g L \cos\psi
# \end{aligned}
# $$
#
# with
#
# $$
# \begin{aligned}
# a_{11} &= (2m + M) R^2 + 2 J_w + 2 n^2 J_m \\
# a_{12}(\psi) &= M L R \cos\psi - 2 n^2 J_m \\
# a_{22} &= M L^2 + J_\psi + 2 n^2 J_m
# \end{aligned}
# $$
#
# Lagrange's equations $\frac{d}{dt} \frac{\partial T}{\partial \dot q} - \frac{\partial T}{\partial q} + \frac{\partial V}{\partial q} = Q$ give
#
# $$
# \begin{aligned}
# a_{11} \ddot\theta + a_{12}(\psi) \ddot\psi - M L R\, \dot\psi^2 \sin\psi &= \tau \\
# a_{12}(\psi) \ddot\theta + a_{22} \ddot\psi - M g L \sin\psi &= -\tau
# \end{aligned}
# $$
#
# Both motors together give the torque $\tau = \alpha (v_l + v_r) - 2\beta (\dot\theta - \dot\psi)$, where $\alpha = n K_t / R_m$ and
# $\beta = n K_t K_b / R_m + f_m$. The motors sit in the body. What they give to the wheels they take from the body: hence $-\tau$ in the
# second line.
# %% [markdown] lang="es"
# Cada número tiene unidad, procedencia e incertidumbre. Un número que nadie midió se llama *guess* (supuesto): puede estar
# equivocado en un factor de dos.
#
# ## Tres ángulos
#
# | símbolo | significado |
# |---|---|
# | $\psi$ | inclinación (*pitch*) del cuerpo, positiva hacia adelante |
# | $\theta$ | ángulo medio de las ruedas (*wheel*), positivo si el robot avanza |
# | $\varphi$ | rumbo (*yaw*), positivo hacia la izquierda |
#
# El estado es $x = [\psi, \dot\psi, \theta, \dot\theta, \varphi, \dot\varphi]$ y el mando $u = [v_l, v_r]$ contiene las tensiones de los
# dos motores. Aquí bastan la inclinación y las ruedas; girar es un problema aparte.
#
# ## De las energías a las ecuaciones
#
# El robot rueda en línea recta. El eje avanza a $R\dot\theta$ y el centro de masa está a la altura $L$ sobre el eje. Las energías
# cinética y potencial son
#
# $$
# \begin{aligned}
# T &= \tfrac12 a_{11} \dot\theta^2 + a_{12}(\psi)\, \dot\theta \dot\psi + \tfrac12 a_{22} \dot\psi^2 \\
# V &= M g L \cos\psi
# \end{aligned}
# $$
#
# con
#
# $$
# \begin{aligned}
# a_{11} &= (2m + M) R^2 + 2 J_w + 2 n^2 J_m \\
# a_{12}(\psi) &= M L R \cos\psi - 2 n^2 J_m \\
# a_{22} &= M L^2 + J_\psi + 2 n^2 J_m
# \end{aligned}
# $$
#
# Las ecuaciones de Lagrange $\frac{d}{dt} \frac{\partial T}{\partial \dot q} - \frac{\partial T}{\partial q} + \frac{\partial V}{\partial q} = Q$ dan
#
# $$
# \begin{aligned}
# a_{11} \ddot\theta + a_{12}(\psi) \ddot\psi - M L R\, \dot\psi^2 \sin\psi &= \tau \\
# a_{12}(\psi) \ddot\theta + a_{22} \ddot\psi - M g L \sin\psi &= -\tau
# \end{aligned}
# $$
#
# Los dos motores juntos dan el par $\tau = \alpha (v_l + v_r) - 2\beta (\dot\theta - \dot\psi)$, con $\alpha = n K_t / R_m$ y
# $\beta = n K_t K_b / R_m + f_m$. Los motores están en el cuerpo. Lo que dan a las ruedas se lo quitan al cuerpo: de ahí $-\tau$ en la
# segunda línea.

# %%
M, m, R, L = robot.body_mass, robot.wheel_mass, robot.wheel_radius, robot.com_height
g = robot.gravity
n, J_m = robot.gear_ratio, robot.rotor_inertia
a11 = (2 * m + M) * R**2 + 2 * robot.wheel_inertia + 2 * n**2 * J_m
a12 = M * L * R - 2 * n**2 * J_m  # at ψ = 0
a22 = M * L**2 + robot.pitch_inertia + 2 * n**2 * J_m
alpha = n * robot.torque_constant / robot.motor_resistance
beta = alpha * robot.back_emf + robot.motor_friction
print(f"a11 = {a11:.4g}, a12 = {a12:.4g}, a22 = {a22:.4g} kg m²; M g L = {M * g * L:.4g} N m")

# %% [markdown] lang="en"
# ## The linear model
#
# Near $\psi = 0$ we put $\sin\psi \approx \psi$, $\cos\psi \approx 1$ and drop products of small numbers, such as $\dot\psi^2 \sin\psi$. What is left
# is linear:
#
# $$
# \begin{bmatrix} a_{11} & a_{12} \\ a_{12} & a_{22} \end{bmatrix}
# \begin{bmatrix} \ddot\theta \\ \ddot\psi \end{bmatrix}
# = \begin{bmatrix} 0 \\ M g L \end{bmatrix} \psi
# + \begin{bmatrix} -1 \\ 1 \end{bmatrix} 2 \beta (\dot\theta - \dot\psi)
# + \begin{bmatrix} 1 \\ -1 \end{bmatrix} \alpha (v_l + v_r)
# $$
#
# We solve it for the accelerations, and sort them into $\dot x = A x + B u$ for $x = [\psi, \dot\psi, \theta, \dot\theta]$.
# %% [markdown] lang="es"
# ## El modelo lineal
#
# Cerca de $\psi = 0$ ponemos $\sin\psi \approx \psi$, $\cos\psi \approx 1$ y omitimos productos de números pequeños, como $\dot\psi^2 \sin\psi$.
# Lo que queda es lineal:
#
# $$
# \begin{bmatrix} a_{11} & a_{12} \\ a_{12} & a_{22} \end{bmatrix}
# \begin{bmatrix} \ddot\theta \\ \ddot\psi \end{bmatrix}
# = \begin{bmatrix} 0 \\ M g L \end{bmatrix} \psi
# + \begin{bmatrix} -1 \\ 1 \end{bmatrix} 2 \beta (\dot\theta - \dot\psi)
# + \begin{bmatrix} 1 \\ -1 \end{bmatrix} \alpha (v_l + v_r)
# $$
#
# Lo resolvemos para las aceleraciones y lo ordenamos como $\dot x = A x + B u$ con $x = [\psi, \dot\psi, \theta, \dot\theta]$.

# %%
inertia = np.array([[a11, a12], [a12, a22]])
sides = np.array([[0, 2 * beta, 0, -2 * beta], [M * g * L, -2 * beta, 0, 2 * beta]])  # rows θ, ψ
wheel_row, pitch_row = np.linalg.solve(inertia, sides)
A = np.array([[0, 1, 0, 0], pitch_row, [0, 0, 0, 1], wheel_row])
print(np.round(A, 2))

model = up.linearise(robot)
print("by hand equals the library:", np.allclose(A, model.A[:4, :4]))
model

# %% [markdown] lang="en"
# The last two rows of the model are yaw. They do not touch the first four: turning and balancing are independent, to first order.
#
# Look at the column of $B$. A positive voltage gives $\ddot\theta > 0$ and $\ddot\psi < 0$: **to roll forward the robot first leans back.** Every
# controller of such a robot has to live with that.
#
# ## Poles say how it falls
#
# Solutions of $\dot x = A x$ are sums of $e^{\lambda t}$ with the eigenvalues $\lambda$ of $A$, the poles.
# %% [markdown] lang="es"
# Las dos últimas filas del modelo son el rumbo. No tocan a las cuatro primeras: girar y balancearse son independientes, en primer orden.
#
# Mire la columna de $B$. Una tensión positiva da $\ddot\theta > 0$ y $\ddot\psi < 0$: **para avanzar, el robot primero se inclina hacia
# atrás.** Todo controlador de un robot así tiene que convivir con eso.
#
# ## Los polos dicen cómo cae
#
# Las soluciones de $\dot x = A x$ son sumas de $e^{\lambda t}$ con los autovalores $\lambda$ de $A$, los polos.

# %%
falling = model.poles()[0].real
print(np.round(model.poles().real, 2))
print(f"a lean grows e-fold in {1000 / falling:.0f} ms")

# %% [markdown] lang="en"
# One pole is positive: that is the fall. Two are zero: the robot does not care where it stands or where it looks. The pole at $-6.65$ is
# the fall seen backwards in time, and the two fast ones are the motors.
#
# A computer sees the robot every 10 ms. Held over a period $T$, the model becomes $x_{k+1} = A_d x_k + B_d u_k$, and each pole $\lambda$ becomes
# $e^{\lambda T}$. The paper prints such a matrix. Its eigenvalues are 1.0707, 1, 1, 0.9357, 0.0493 and 0.0080:
# %% [markdown] lang="es"
# Un polo es positivo: es la caída. Dos son cero: al robot no le importa dónde está ni hacia dónde mira. El polo en $-6.65$ es la
# caída vista hacia atrás en el tiempo, y los dos rápidos son los motores.
#
# Un computador ve al robot cada 10 ms. Con el mando constante durante un período $T$ el modelo es $x_{k+1} = A_d x_k + B_d u_k$, y cada polo
# $\lambda$ se vuelve $e^{\lambda T}$. El artículo publica una matriz así. Sus autovalores son 1.0707, 1, 1, 0.9357, 0.0493 y 0.0080:

# %%
sampled = model.c2d(0.01)
print(np.round(sampled.poles().real, 4))
print(f"e^(λT) = {np.exp(falling * 0.01):.4f}")

# %% [markdown] lang="en"
# ## Let it fall
#
# A feedback of zeros lets the robot fall, from a lean of 0.02 rad (about 1°). We run the nonlinear equations and the linear model.
# %% [markdown] lang="es"
# ## Déjelo caer
#
# Una realimentación de ceros deja caer al robot, desde una inclinación de 0.02 rad (cerca de 1°). Simulamos las ecuaciones no
# lineales y el modelo lineal.

# %%
idle = up.StateFeedback(np.zeros((2, 6)), period=0.01)


def fall(lean):
    start = (lean, 0, 0, 0, 0, 0)
    bodies = {"nonlinear": up.NonlinearBody(robot), "linear": up.LinearBody(model, robot)}
    return {name: up.run(body, idle, start=start, seconds=1.0) for name, body in bodies.items()}


falls = fall(0.02)
up.compare(falls).plot("pitch", "wheel")

# %% [markdown] lang="en"
# For half a second one cannot tell them apart. Then the lean is large, and the wheels part first. (The pitch hardly does
# here.) This is the usual fate of a linear model: it is true near the point where it was made.
#
# ## Now with a controller
#
# Balanced robots stay near that point. Here a controller (the third notebook makes it) catches the robot from four leans. Look at the
# *fit* of the linear model: 100 % means equal, 0 % means no better than a constant.
# %% [markdown] lang="es"
# Durante medio segundo no se distinguen. Luego la inclinación es grande, y primero se separan las ruedas; las dos
# inclinaciones, aquí casi nada. Es el destino usual de un modelo lineal: es cierto cerca del punto donde se hizo.
#
# ## Ahora con un controlador
#
# Un robot en equilibrio se queda cerca de ese punto. Aquí un controlador (lo hace el tercer cuaderno) recoge al robot desde cuatro
# inclinaciones. Mire el ajuste (*fit*) del modelo lineal: 100 % significa igual, 0 % no mejor que una constante.

# %%
law = up.lqr_state(robot, dt=0.01)


def caught(lean):
    start = (lean, 0, 0, 0, 0, 0)
    bodies = {"nonlinear": up.NonlinearBody(robot), "linear": up.LinearBody(model, robot)}
    return up.compare({name: up.run(body, law, start=start, seconds=3.0) for name, body in bodies.items()})


def fit(one, other):
    return 100 * (1 - np.linalg.norm(one - other) / np.linalg.norm(one - one.mean()))


for lean in (0.02, 0.2, 0.4, 0.6):
    logs = caught(lean).logs
    percent = fit(logs["nonlinear"]["truth/pitch"], logs["linear"]["truth/pitch"])
    print(f"{lean:.2f} rad ({np.degrees(lean):2.0f}°): {percent:.0f} %")

caught(0.6).plot("pitch", "wheel")

# %% [markdown] lang="en"
# Up to 0.2 rad (11°) a linear model is all one needs. At 0.6 rad (34°) it is wrong by a third, and it is wrong on the dangerous side: the
# real robot swings further and rolls further.
#
# ## Exercises
#
# **1.** After how many milliseconds has a small lean doubled? Compute it from the pole, and check it on the log `falls["linear"]`. Why does
# the log need a little longer at first?
# %% [markdown] lang="es"
# Hasta 0.2 rad (11°) basta un modelo lineal. A 0.6 rad (34°) se equivoca en un tercio, y se equivoca del lado peligroso: el robot
# real se inclina más y rueda más lejos.
#
# ## Ejercicios
#
# **1.** ¿Después de cuántos milisegundos se ha duplicado una inclinación pequeña? Calcúlelo con el polo y compruébelo en el registro
# `falls["linear"]`. ¿Por qué el registro necesita un poco más al principio?

# %% tags=["answer"]
print(f"from the pole: {1000 * np.log(2) / falling:.0f} ms")
log = falls["linear"]
times = [log.t[np.argmax(log["truth/pitch"] > 0.02 * 2**k)] for k in range(1, 6)]
print("doubled after [ms]:", np.round(1000 * np.diff([0.0, *times])))

# %% [markdown] lang="en" tags=["answer"]
# $\ln 2 / 6.83 = 101$ ms. The first doubling takes longer, since the robot starts at rest: half of the lean is in the growing mode, the other
# half in the decaying one ($\lambda = -6.65$), which has to die first. The sum is close to $\psi_0 \cosh(\lambda t)$.
# %% [markdown] lang="es" tags=["answer"]
# $\ln 2 / 6.83 = 101$ ms. La primera duplicación toma más, pues el robot parte del reposo: la mitad de la inclinación está en el modo que
# crece y la otra mitad en el que decae ($\lambda = -6.65$), que primero tiene que morir. La suma es casi $\psi_0 \cosh(\lambda t)$.

# %% [markdown] lang="en"
# **2.** Put the centre of mass higher by 20 %: `robot.replace(com_height=...)`. Guess first: does it fall faster or slower? Is it then easier
# or harder to balance?
# %% [markdown] lang="es"
# **2.** Suba el centro de masa en 20 %: `robot.replace(com_height=...)`. Primero adivine: ¿cae más rápido o más lento? ¿Es entonces más
# fácil o más difícil de equilibrar?

# %% tags=["answer"]
for factor in (0.8, 1.0, 1.2, 1.5):
    changed = robot.replace(com_height=factor * robot.com_height)
    print(f"{factor:.1f} L: {up.linearise(changed).poles()[0].real:.2f} 1/s")

# %% [markdown] lang="en" tags=["answer"]
# It falls more slowly, like a broom compared with a pencil: gravity's moment grows with $L$, inertia with $L^2$. A slower fall leaves the
# controller more time. But the motors need more torque to hold a given lean, and they are the limit of a strong push.
# %% [markdown] lang="es" tags=["answer"]
# Cae más despacio, como una escoba comparada con un lápiz: el momento de la gravedad crece con $L$, la inercia con $L^2$. Una caída más
# lenta deja más tiempo al controlador. Pero los motores necesitan más par para sostener una inclinación dada, y son el límite
# ante un empujón fuerte.

# %% [markdown] lang="en"
# **3.** From which lean on is the moment of gravity in the linear model, $M g L \psi$, more than 10 % too large?
# %% [markdown] lang="es"
# **3.** ¿Desde qué inclinación el momento de la gravedad del modelo lineal, $M g L \psi$, es más de 10 % demasiado grande?

# %% tags=["answer"]
lean = np.linspace(0.01, 1.2, 1000)
print(f"from {lean[np.argmax(lean > 1.1 * np.sin(lean))]:.2f} rad on")

# %% [markdown] lang="en" tags=["answer"]
# From 0.75 rad (43°) on. The fit above was already poor at 0.6 rad. There the other terms that we dropped are as large: the coupling
# $a_{12}(\psi)$ shrinks with $\cos\psi$, and $\dot\psi^2 \sin\psi$ pushes the wheels.
# %% [markdown] lang="es" tags=["answer"]
# Desde 0.75 rad (43°). El ajuste de arriba ya era malo a 0.6 rad. Allí los otros términos omitidos son igual de grandes: el acoplamiento
# $a_{12}(\psi)$ se reduce con $\cos\psi$, y $\dot\psi^2 \sin\psi$ empuja las ruedas.

# %% [markdown] lang="en"
# **4.** Take your own robot, or `"nxtway-gs"` or `"twipr"`. How fast does it fall? Which of its numbers are guesses, and which of them
# matters most for the falling pole?
# %% [markdown] lang="es"
# **4.** Tome su propio robot, o `"nxtway-gs"` o `"twipr"`. ¿Cómo de rápido cae? ¿Cuáles de sus números son supuestos, y cuál de
# ellos importa más para el polo de la caída?

# %% tags=["answer"]
mine = up.Robot.preset("nxtway-gs")
pole = up.linearise(mine).poles()[0].real
guesses = [p["name"] for p in mine.parameters() if p["spread"] is None and p["value"]]
print(f"{mine.name} falls with {pole:.2f} 1/s")
for name in guesses:
    doubled = mine.replace(**{name: 2 * getattr(mine, name)})
    print(f"{name:<18} doubled: {up.linearise(doubled).poles()[0].real - pole:+.2f} 1/s")

# %% [markdown] lang="en"
# ## What comes next
#
# The numbers of this robot were given. In [the next notebook](2_identify.ipynb) they come from a log, and the simplest way to get
# them goes wrong.
# %% [markdown] lang="es"
# ## Lo que sigue
#
# Los números de este robot estaban dados. En [el siguiente cuaderno](2_identify.ipynb) salen de un registro, y la manera más
# sencilla de obtenerlos sale mal.
