# %% [markdown] lang="en"
# # 2. Identify, and why least squares lies
#
# *For students who know the first notebook and a little probability. You need one to two hours with the exercises.*
#
# You have a robot that balances, and a log of it: commands and sensors. You want the linear model. The obvious way is least squares, and
# many papers take it, that of Herrera et al. (2015) too. On a robot that balances it is wrong, however long the log is. Here you
# see why, and what to do instead.
# %% [markdown] lang="es"
# # 2. Identificar, y por qué los mínimos cuadrados mienten
#
# *Para estudiantes que conocen el primer cuaderno y algo de probabilidad. Con los ejercicios toma de una a dos horas.*
#
# Usted tiene un robot que se equilibra y un registro suyo: mandos y sensores. Quiere el modelo lineal. El camino obvio son los mínimos
# cuadrados, y muchos artículos lo toman, también el de Herrera et al. (2015). En un robot que se equilibra ese camino es falso, por
# largo que sea el registro. Aquí ve por qué, y qué hacer en su lugar.

# %% [markdown] lang="en"
# ## The smallest robot
#
# Take one state, with the falling pole of the paper's robot per period of 10 ms, $a = 1.07$:
#
# $$
# x_{k+1} = a\, x_k + b\, u_k, \qquad y_k = x_k + e_k .
# $$
#
# The sensor adds noise $e_k$ with the standard deviation $\sigma$. A robot that falls must be balanced while it is measured, so a
# controller closes the loop. We add a random excitation $w_k$, so that there is something to see:
#
# $$
# u_k = -k\, y_k + w_k .
# $$
#
# Least squares looks for the $a$ and $b$ that make $y_{k+1} - a\,y_k - b\,u_k$ small.
# %% [markdown] lang="es"
# ## El robot más pequeño
#
# Tome un solo estado, con el polo de la caída del robot del artículo por período de 10 ms, $a = 1.07$:
#
# $$
# x_{k+1} = a\, x_k + b\, u_k, \qquad y_k = x_k + e_k .
# $$
#
# El sensor añade ruido $e_k$ de desviación típica $\sigma$. Un robot que cae hay que equilibrarlo mientras se mide, así que un
# controlador cierra el lazo. Añadimos una excitación aleatoria $w_k$, para que haya algo que ver:
#
# $$
# u_k = -k\, y_k + w_k .
# $$
#
# Los mínimos cuadrados buscan los $a$ y $b$ que hacen pequeño $y_{k+1} - a\,y_k - b\,u_k$.

# %% lang="es"
import upright as up

up.language("es")  # figuras y tablas en español; lo que imprime print queda en inglés

# %%
import numpy as np

import upright as up

a, b, k = 1.07, 1.0, 0.4


def experiment(rows, noise, seed=1):
    rng = np.random.default_rng(seed)
    w, e = rng.standard_normal(rows), noise * rng.standard_normal(rows)
    x, y, u = 0.0, np.empty(rows), np.empty(rows)
    for i in range(rows):
        y[i] = x + e[i]
        u[i] = -k * y[i] + w[i]
        x = a * x + b * u[i]
    return y, u, w


def least_squares(y, u):
    regressors = np.column_stack([y[:-1], u[:-1]])
    return np.linalg.lstsq(regressors, y[1:])[0]


for noise in (0.0, 0.2, 0.5, 1.0):
    y, u, _ = experiment(20_000, noise)
    found = least_squares(y, u)
    print(f"noise {noise:.1f}: a = {found[0]:.3f} (true {a}), b = {found[1]:.3f} (true {b})")

# %% [markdown] lang="en"
# Without noise it is exact. With noise $a$ is too small, and 20 000 rows do not help. From $\sigma = 0.5$ on least squares
# even says $a < 1$: **a robot that does not fall.**
#
# ## Why
#
# Put $x_k = y_k - e_k$ into the model:
#
# $$
# y_{k+1} = a\, y_k + b\, u_k + (e_{k+1} - a\, e_k).
# $$
#
# Least squares is right only if the bracket has nothing to do with the regressors $y_k$ and $u_k$. But $y_k$ contains $e_k$, and through the
# controller so does $u_k$. The correlations are
#
# $$
# \mathrm E[y_k (e_{k+1} - a e_k)] = -a \sigma^2, \qquad \mathrm E[u_k (e_{k+1} - a e_k)] = + k a \sigma^2 .
# $$
#
# Solve the normal equations for the errors of $\hat a$ and $\hat b$ (exercise 1), and you find
#
# $$
# \hat a \to a \left( 1 - \frac{\sigma^2}{\mathrm E[y^2]} \right), \qquad \hat b \to b .
# $$
#
# The share of noise in the reading is missing from the pole. No number of rows is in this formula, so more rows do not correct it.
# %% [markdown] lang="es"
# Sin ruido es exacto. Con ruido $a$ sale demasiado pequeño, y 20 000 filas no ayudan. Desde $\sigma = 0.5$ los mínimos
# cuadrados hasta dicen $a < 1$: **un robot que no se cae.**
#
# ## Por qué
#
# Ponga $x_k = y_k - e_k$ en el modelo:
#
# $$
# y_{k+1} = a\, y_k + b\, u_k + (e_{k+1} - a\, e_k).
# $$
#
# Los mínimos cuadrados aciertan solo si el paréntesis no tiene nada que ver con los regresores $y_k$ y $u_k$. Pero $y_k$ contiene a $e_k$ y,
# por el controlador, también $u_k$. Las correlaciones son
#
# $$
# \mathrm E[y_k (e_{k+1} - a e_k)] = -a \sigma^2, \qquad \mathrm E[u_k (e_{k+1} - a e_k)] = + k a \sigma^2 .
# $$
#
# Resuelva las ecuaciones normales para los errores de $\hat a$ y $\hat b$ (ejercicio 1) y encontrará
#
# $$
# \hat a \to a \left( 1 - \frac{\sigma^2}{\mathrm E[y^2]} \right), \qquad \hat b \to b .
# $$
#
# Al polo le falta la parte de ruido que hay en la lectura. En esta fórmula no está el número de filas: más filas no lo arreglan.

# %%
for noise in (0.2, 0.5, 1.0):
    y, u, _ = experiment(20_000, noise)
    print(
        f"noise {noise:.1f}: least squares {least_squares(y, u)[0]:.3f}, formula {a * (1 - noise**2 / np.mean(y**2)):.3f}"
    )

# %% [markdown] lang="en"
# ## A way out: instruments
#
# We need a signal that moves the robot and knows nothing of the noise: an *instrument*. The excitation is one, since we made it ourselves.
# Instead of the normal equations we ask that the error be uncorrelated with $w_k$ and $w_{k-1}$:
#
# $$
# \sum_k \begin{bmatrix} w_{k-1} \\ w_k \end{bmatrix} \left( y_{k+1} - a\,y_k - b\,u_k \right) = 0 .
# $$
# %% [markdown] lang="es"
# ## Una salida: instrumentos
#
# Necesitamos una señal que mueva al robot y no sepa nada del ruido: un *instrumento*. La excitación lo es, porque la hicimos nosotros.
# En lugar de las ecuaciones normales pedimos que el error no tenga correlación con $w_k$ ni con $w_{k-1}$:
#
# $$
# \sum_k \begin{bmatrix} w_{k-1} \\ w_k \end{bmatrix} \left( y_{k+1} - a\,y_k - b\,u_k \right) = 0 .
# $$


# %%
def instrumental(y, u, w):
    instruments = np.column_stack([w[:-2], w[1:-1]])
    regressors = np.column_stack([y[1:-1], u[1:-1]])
    return np.linalg.solve(instruments.T @ regressors, instruments.T @ y[2:])


for noise in (0.2, 0.5, 1.0):
    y, u, w = experiment(20_000, noise)
    print(f"noise {noise:.1f}: a = {instrumental(y, u, w)[0]:.3f}")

# %% [markdown] lang="en"
# ## A whole robot
#
# Now the same on a log of a LEGO robot with its encoders (1°), its noisy gyro and its battery. It balanced for 12 s while small random
# voltages were added to its commands. The robot is a twin (a simulation in MuJoCo), so here we know the truth.
# %% [markdown] lang="es"
# ## Un robot entero
#
# Ahora lo mismo en un registro de un robot LEGO con sus codificadores (1°), su giróscopo ruidoso y su batería. Se equilibró 12 s
# mientras se sumaban pequeñas tensiones aleatorias a sus mandos. El robot es un gemelo (una simulación en MuJoCo), así que aquí
# conocemos la verdad.

# %%
log, robot = up.example("excited"), up.Robot.preset("nxtway-gs")
log.between(4, 8).plot("sensor/gyro", "command/left", "command/right")

# %% [markdown] lang="en"
# First ask the doctor whether the log is sound. Then try one method after the other. Each *pole* comes with an interval of 95 %, from
# repeated simulations of this very experiment.
# %% [markdown] lang="es"
# Primero pregunte al doctor si el registro está sano. Luego pruebe un método tras otro. Cada polo (*pole*) lleva un intervalo del
# 95 %, que sale de simular repetidas veces este mismo experimento.

# %%
print(up.doctor(log))
truth = up.linearise(robot).poles()[0].real
print(f"true falling pole: {truth:.2f} 1/s")

# %%
found = up.identify(log, robot, method="all", runs=10)
print(found)
found.plot()

# %% [markdown] lang="en"
# Read the picture with care:
#
# - **`least-squares`** says that the robot hardly falls. Its interval is narrow and wrong. An interval tells how much an answer
#   scatters, not whether it is true.
# - **`total-least-squares`** knows that the readings have errors. It does not know that the feedback makes commands of these errors.
# - **`instrumental`** and **`subspace`** take the loop into account, and find the pole.
# - **`calibrate`** fits the physical parameters instead of free matrices. It uses most knowledge, and notebook 5 uses it.
#
# The text also tells whether a regulator that is designed on each model holds the robot. That is the question that counts.
# %% [markdown] lang="es"
# Lea la figura con cuidado:
#
# - **`least-squares`** dice que el robot casi no cae. Su intervalo es angosto y falso. Un intervalo dice cuánto se dispersa una
#   respuesta, no si es verdadera.
# - **`total-least-squares`** sabe que las lecturas tienen errores. No sabe que la realimentación convierte esos errores en mandos.
# - **`instrumental`** y **`subspace`** toman en cuenta el lazo, y encuentran el polo.
# - **`calibrate`** ajusta los parámetros físicos en lugar de matrices libres. Usa más conocimiento; el cuaderno 5 lo emplea.
#
# El texto dice además si un regulador diseñado con cada modelo sostiene al robot. Esa es la pregunta que cuenta.

# %% [markdown] lang="en"
# ## Knowing that you are wrong
#
# Can one see the bias without knowing the truth? Yes: simulate a known robot under the same experiment, and look whether the method finds the pole
# that you put in. `bias` does that.
# %% [markdown] lang="es"
# ## Saber que uno se equivoca
#
# ¿Se puede ver el sesgo sin conocer la verdad? Sí: simule un robot conocido en el mismo experimento y mire si el método encuentra el
# polo que usted puso. Eso hace `bias`.

# %%
for name in ("least-squares", "instrumental", "subspace"):
    pole = found.models[name].pole
    print(
        f"{name:<16} pole {pole.value:5.2f}, estimated bias {pole.bias:+.2f}, real error {pole.value - truth:+.2f} 1/s"
    )

# %% [markdown] lang="en"
# ## Exercises
#
# **1.** Derive the formula of the bias. Write $S_{yy} = \mathrm E[y^2]$ and $S_w = \mathrm E[w^2]$. Hint: $w_k$ knows nothing of $y_k$, so
# $\mathrm E[y u] = -k S_{yy}$ and $\mathrm E[u^2] = k^2 S_{yy} + S_w$.
# %% [markdown] lang="es"
# ## Ejercicios
#
# **1.** Deduzca la fórmula del sesgo. Escriba $S_{yy} = \mathrm E[y^2]$ y $S_w = \mathrm E[w^2]$. Pista: $w_k$ no sabe nada de $y_k$, así
# que $\mathrm E[y u] = -k S_{yy}$ y $\mathrm E[u^2] = k^2 S_{yy} + S_w$.

# %% [markdown] lang="en" tags=["answer"]
# The errors $\delta a, \delta b$ solve
#
# $$
# \begin{bmatrix} S_{yy} & -k S_{yy} \\ -k S_{yy} & k^2 S_{yy} + S_w \end{bmatrix}
# \begin{bmatrix} \delta a \\ \delta b \end{bmatrix} = a \sigma^2 \begin{bmatrix} -1 \\ k \end{bmatrix} .
# $$
#
# Add $k$ times the first row to the second: $S_w\, \delta b = 0$. So $\delta b = 0$, and the first row gives $\delta a = -a \sigma^2 / S_{yy}$.
# %% [markdown] lang="es" tags=["answer"]
# Los errores $\delta a, \delta b$ resuelven
#
# $$
# \begin{bmatrix} S_{yy} & -k S_{yy} \\ -k S_{yy} & k^2 S_{yy} + S_w \end{bmatrix}
# \begin{bmatrix} \delta a \\ \delta b \end{bmatrix} = a \sigma^2 \begin{bmatrix} -1 \\ k \end{bmatrix} .
# $$
#
# Sume $k$ veces la primera fila a la segunda: $S_w\, \delta b = 0$. Entonces $\delta b = 0$, y la primera fila da $\delta a = -a \sigma^2 / S_{yy}$.

# %% [markdown] lang="en"
# **2.** How large a share of the reading's power must be noise before least squares calls this robot stable? Check it with an experiment.
# %% [markdown] lang="es"
# **2.** ¿Qué parte de la potencia de la lectura debe ser ruido para que los mínimos cuadrados llamen estable a este robot? Compruébelo
# con un experimento.

# %% tags=["answer"]
print(f"share of noise: {1 - 1 / a:.3f}")
for noise in np.arange(0.30, 0.46, 0.03):
    y, u, _ = experiment(50_000, noise)
    print(f"noise {noise:.2f}, share {noise**2 / np.mean(y**2):.3f}: a = {least_squares(y, u)[0]:.3f}")

# %% [markdown] lang="en" tags=["answer"]
# $a (1 - s) = 1$ at $s = 1 - 1/a = 6.5\,\%$. The faster a robot is sampled, the nearer $a$ is to 1, and the less noise it takes.
# %% [markdown] lang="es" tags=["answer"]
# $a (1 - s) = 1$ en $s = 1 - 1/a = 6.5\,\%$. Cuanto más rápido se muestrea un robot, más cerca está $a$ de 1, y menos ruido hace falta.

# %% [markdown] lang="en"
# **3.** Instruments are no free lunch. Repeat `instrumental` with $\sigma = 0.5$ on a hundred logs of 500 rows and on a hundred of 5000. How does the
# scatter change, and how the mean?
# %% [markdown] lang="es"
# **3.** Los instrumentos tienen su precio. Repita `instrumental` con $\sigma = 0.5$ en cien registros de 500 filas y en cien de 5000.
# ¿Cómo cambia la dispersión, y cómo la media?

# %% tags=["answer"]
for rows in (500, 5000):
    tries = [experiment(rows, 0.5, seed) for seed in range(100)]
    wise = [instrumental(*each)[0] for each in tries]
    plain = [least_squares(y, u)[0] for y, u, _ in tries]
    print(
        f"{rows} rows: instrumental {np.mean(wise):.3f} ± {np.std(wise):.3f}, least squares {np.mean(plain):.3f} ± {np.std(plain):.3f}"
    )

# %% [markdown] lang="en" tags=["answer"]
# The scatter falls with $1/\sqrt{N}$, the mean stays right. Least squares scatters less and is wrong: a narrow interval round a false number.
# %% [markdown] lang="es" tags=["answer"]
# La dispersión baja con $1/\sqrt{N}$ y la media es correcta. Los mínimos cuadrados se dispersan menos y se equivocan: un intervalo
# angosto alrededor de un número falso.

# %% [markdown] lang="en"
# **4.** What if nobody excites the robot ($w = 0$)? Look at the normal equations first, then try it on the log `"standing"`.
# %% [markdown] lang="es"
# **4.** ¿Y si nadie excita al robot ($w = 0$)? Mire primero las ecuaciones normales, y luego pruébelo en el registro `"standing"`.

# %% tags=["answer"]
try:
    print(up.identify(up.example("standing"), robot, method="subspace", runs=10))
except up.UprightError as error:
    print(error)

# %% [markdown] lang="en" tags=["answer"]
# With $u = -k y$ both regressors are one signal and the matrix is singular: nobody can tell the robot from its controller. On the whole
# robot noise alone moves the loop. The interval is then several times as wide as before, and here it even misses the truth.
# %% [markdown] lang="es" tags=["answer"]
# Con $u = -k y$ los dos regresores son una sola señal y la matriz es singular: nadie puede distinguir al robot de su controlador. En el
# robot entero solo el ruido mueve el lazo. El intervalo es entonces varias veces más ancho que antes, y aquí ni siquiera contiene la verdad.

# %% [markdown] lang="en"
# ## What comes next
#
# We have a model. [The next notebook](3_lqg.ipynb) makes a controller of it.
# %% [markdown] lang="es"
# ## Lo que sigue
#
# Tenemos un modelo. [El siguiente cuaderno](3_lqg.ipynb) hace de él un controlador.
