# %% [markdown] lang="en"
# # 5. From a log to a certificate
#
# *For students who know notebooks 2 to 4. You need one to two hours with the exercises.*
#
# A robot stands on the table, and there is one log of it. May your controller drive it? This notebook walks the whole way: is the log sound,
# which robot is it, does that robot predict another log, what does a controller for it do with two hundred robots that could be yours.
# %% [markdown] lang="es"
# # 5. De un registro a un certificado
#
# *Para estudiantes que conocen los cuadernos 2 a 4. Con los ejercicios toma de una a dos horas.*
#
# Un robot está en la mesa y hay un registro suyo. ¿Puede conducirlo su controlador? Este cuaderno recorre todo el camino: si el registro
# está sano, qué robot es, si ese robot predice otro registro, y qué hace un controlador con doscientos robots que podrían ser el suyo.

# %% [markdown] lang="en"
# ## 1. Is the log sound?
#
# Half of all bad models come from bad logs: degrees taken for radians, a sign, a lost row. Here is a log with a planted fault.
# %% [markdown] lang="es"
# ## 1. ¿Está sano el registro?
#
# La mitad de los malos modelos viene de malos registros: grados tomados por radianes, un signo, una fila perdida. He aquí un
# registro con una falta puesta a propósito.

# %% lang="es"
import upright as up

up.language("es")  # figuras y tablas en español; lo que imprime print queda en inglés

# %%
import dataclasses

import numpy as np

import upright as up

robot = up.Robot.preset("nxtway-gs")
broken = up.example("gyro-flipped")
diagnosis = up.doctor(broken, robot)
print(diagnosis)

# %% [markdown] lang="en"
# The doctor does not guess. Encoders and gyro watch one robot, so its equations tie them together, and the sign of one number gives the
# fault away. Each fault comes with its repair:
# %% [markdown] lang="es"
# El doctor no adivina. Los codificadores y el giróscopo observan a un mismo robot; sus ecuaciones los atan, y el signo de un solo número
# delata la falta. Cada falta trae su reparación:

# %%
print("before:", diagnosis.codes())
print("after: ", up.doctor(diagnosis.repaired(), robot).codes())
diagnosis.plot()

# %% [markdown] lang="en"
# ## 2. Which robot is it?
#
# `calibrate` looks for the parameters under which the log is most probable (*maximum likelihood*). A filter with the nonlinear equations runs along the log and
# predicts each reading from those before. The error of the prediction is the *innovation* $e_k$. With its covariance $\Sigma_k$ one minimises
#
# $$
# \sum_k e_k^{\mathsf T} \Sigma_k^{-1} e_k + \ln \det \Sigma_k ,
# $$
#
# plus what was known before (the *prior*). Since the filter knows of noise, the closed loop does no harm: this is the cure for notebook 2.
# %% [markdown] lang="es"
# ## 2. ¿Qué robot es?
#
# `calibrate` busca los parámetros con los que el registro es más probable (*máxima verosimilitud*). Un filtro con las ecuaciones no lineales recorre el
# registro y predice cada lectura a partir de las anteriores. El error de la predicción es la *innovación* $e_k$. Con su covarianza $\Sigma_k$ se minimiza
#
# $$
# \sum_k e_k^{\mathsf T} \Sigma_k^{-1} e_k + \ln \det \Sigma_k ,
# $$
#
# más lo que se sabía antes (el *prior*). Como el filtro sabe del ruido, el lazo cerrado no hace daño: es la cura del cuaderno 2.

# %%
log = up.example("excited")
calibration = up.calibrate(log, robot)
calibration.plot()

# %% [markdown] lang="en"
# *visible* means that the log shows the number. *prior dominates* means that the log adds little: nobody sees a mass in 12 s of balancing. What counts is
# what they do together, and that is well known:
# %% [markdown] lang="es"
# *visible* significa que el registro muestra el número. *prior dominates* significa que el registro añade poco: nadie ve una masa en 12 s de
# equilibrio. Lo que cuenta es lo que hacen juntos, y eso se conoce bien:

# %%
for name in ("body_mass", "com_height", "pitch_inertia", "rotor_inertia"):
    number = calibration[name]
    print(f"{name:<14} {number.value:.4g}, 95 %: {number.low:.4g} to {number.high:.4g}   {number.verdict}")
known = calibration.known_robot()
print(
    f"falling pole {up.linearise(known).poles()[0].real:.2f} 1/s; of the twin {up.linearise(robot).poles()[0].real:.2f} 1/s"
)

# %% [markdown] lang="en"
# ## 3. Does it predict another log?
#
# A model that fits its own log has shown nothing. So we ask for a log that it has not seen.
# %% [markdown] lang="es"
# ## 3. ¿Predice otro registro?
#
# Un modelo que se ajusta a su propio registro no ha demostrado nada. Por eso preguntamos por un registro que no ha visto.

# %%
validation = up.validate(up.example("pushed"), known)
print(validation)
validation.plot()

# %% [markdown] lang="en"
# Over half seconds it predicts gyro and encoders. The free closed loop breaks near the first push at 3 s: no model can know of a push that no channel
# holds. The compass has noise of 1° and the robot does not turn, so there is nothing to predict.
#
# ## 4. May it drive?
#
# A design for the calibrated robot, and then the question that a single simulation cannot answer. The *certificate* draws robots from all that is not known,
# gives each one a full and an empty battery, pushes it, and counts. If $n$ robots stand, the probability of a fall lies below
# $1 - 0.05^{1/n} \approx 3/n$ with 95 % confidence.
# %% [markdown] lang="es"
# En medios segundos predice el giróscopo y los codificadores. El lazo cerrado libre se rompe cerca del primer empujón, a los 3 s: ningún modelo puede saber de un
# empujón que ningún canal contiene. La brújula tiene un ruido de 1° y el robot no gira, así que no hay nada que predecir.
#
# ## 4. ¿Puede conducir?
#
# Un diseño para el robot calibrado, y luego la pregunta que una sola simulación no puede responder. El *certificado* sortea robots según todo lo que no se sabe, da
# a cada uno una batería llena y una vacía, lo empuja y cuenta. Si quedan en pie $n$ robots, la probabilidad de una caída está por debajo de
# $1 - 0.05^{1/n} \approx 3/n$ con 95 % de confianza.

# %%
own = known.kit  # its dead times and motors, as the log shows them
controller = up.lqg(known, own)
certificate = up.certify(controller, known, samples=200, sweeps=False)
print(certificate)
print(f"bound {100 * (1 - 0.05 ** (1 / 200)):.2f} %")
certificate.plot()

# %% [markdown] lang="en"
# A certificate is of *this* controller on *this* robot. For anything else it refuses, and so do the programs for bricks:
# %% [markdown] lang="es"
# Un certificado es de *este* controlador en *este* robot. Para cualquier otra cosa se niega, y los programas para ladrillos también:

# %%
print("the same: ", certificate.refuses(controller, known, own) or "permitted")
print("the other:", certificate.refuses(controller, known.replace(com_height=0.09), own))

# %% [markdown] lang="en"
# ## 5. And if it falls all the same?
#
# Then the log knows why.
# %% [markdown] lang="es"
# ## 5. ¿Y si aun así se cae?
#
# Entonces el registro sabe por qué.

# %%
fall = up.example("fall")
print(up.post_mortem(fall, robot))
fall.between(4.5, 5.5).plot("sensor/gyro", "command/left")

# %% [markdown] lang="en"
# ## Exercises
#
# **1.** What is wrong with the logs `"sides-swapped"`, `"gyro-degrees"`, `"gyro-behind"` and `"rows-lost"`? Which of these faults would you have seen in a plot?
# %% [markdown] lang="es"
# ## Ejercicios
#
# **1.** ¿Qué les pasa a los registros `"sides-swapped"`, `"gyro-degrees"`, `"gyro-behind"` y `"rows-lost"`? ¿Cuáles de estas faltas habría visto usted en un
# gráfico?

# %% tags=["answer"]
for name in ("sides-swapped", "gyro-degrees", "gyro-behind", "rows-lost"):
    print(f"{name:<14} {', '.join(up.doctor(up.example(name), robot).codes())}")

# %% [markdown] lang="en" tags=["answer"]
# Degrees, perhaps, from the size of the gyro. The others hardly: swapped sides look alike while the robot goes straight, and a gyro that is 30 ms late looks like
# a gyro.
# %% [markdown] lang="es" tags=["answer"]
# Los grados, tal vez, por el tamaño del giróscopo. Las otras casi no: los lados cambiados se parecen mientras el robot va recto, y un giróscopo 30 ms tarde
# parece un giróscopo.

# %% [markdown] lang="en"
# **2.** Calibrate from the log `"standing"` instead. What happens to the number of visible parameters? Why?
# %% [markdown] lang="es"
# **2.** Calibre con el registro `"standing"`. ¿Qué pasa con el número de parámetros visibles? ¿Por qué?

# %% tags=["answer"]
quiet = up.calibrate(up.example("standing"), robot)
for name, found in {"excited": calibration, "standing": quiet}.items():
    seen = [each.name for each in found.parameters if each.verdict == "visible"]
    print(f"{name:<9} {len(seen):2d} visible: {', '.join(seen)}")

# %% [markdown] lang="en" tags=["answer"]
# Nothing moves, so nothing shows. Information is in the motion: `upright excite` designs a run that is worth more.
# %% [markdown] lang="es" tags=["answer"]
# Nada se mueve, así que nada se ve. La información está en el movimiento: `upright excite` diseña un experimento que vale más.

# %% [markdown] lang="en"
# **3.** Break it. Find a controller with a red or an amber light: more dead time in the kit (`dataclasses.replace(own, delay=...)`), weak motors, or a robot whose
# parameters are hardly known. Which reason does the certificate give?
# %% [markdown] lang="es"
# **3.** Rómpalo. Encuentre un controlador con luz roja o ámbar: más tiempo muerto en el kit (`dataclasses.replace(own, delay=...)`), motores débiles, o un robot cuyos
# parámetros apenas se conocen. ¿Qué razón da el certificado?

# %% tags=["answer"]
weak = dataclasses.replace(own, motor=dataclasses.replace(own.motor, left=0.65, right=0.65))
slow = dataclasses.replace(own, delay=0.08)
for name, parts in {"weak motors": weak, "80 ms dead time": slow}.items():
    result = up.certify(controller, known, parts, samples=100, sweeps=False)
    print(f"{name}: {result.light}: {result.reasons[0]}")

# %% [markdown] lang="en"
# **4.** How many robots must stand so that the bound is 0.1 %? How long would that take here?
# %% [markdown] lang="es"
# **4.** ¿Cuántos robots deben quedar en pie para que la cota sea 0.1 %? ¿Cuánto tardaría aquí?

# %% tags=["answer"]
print(f"{int(np.ceil(np.log(0.05) / np.log(1 - 0.001)))} robots, fifteen times as many as above")

# %% [markdown] lang="en"
# ## What comes next
#
# All of this was a robot of ours. [The last notebook](6_own_robot.ipynb) is about yours.
# %% [markdown] lang="es"
# ## Lo que sigue
#
# Todo esto fue con un robot nuestro. [El último cuaderno](6_own_robot.ipynb) trata del suyo.
