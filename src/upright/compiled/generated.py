# Generated from physics.dynamics: do not edit. Written again by: python -m upright.compiled.generate
# ruff: noqa
# fmt: off
# pyright: basic

from typing import Any, NamedTuple

LANES, ROW, SIZE = 64, 80, 65 * 80
PITCH = 0
PITCH_RATE = 1
WHEEL = 2
WHEEL_RATE = 3
YAW = 4
YAW_RATE = 5
H = 6
LIVED = 7
LEFT = 8
RIGHT = 9
FORCE = 10
MOMENT = 11
SIN_SLOPE = 12
COS_SLOPE = 13
HALF_TRACK = 14
WHEEL_RADIUS = 15
GRAVITY = 16
MOTOR_DAMPING = 17
CENTRIFUGAL = 18
WEIGHT = 19
MOMENT_RESPONSE = 20
COULOMB_TORQUE = 21
MOTOR_TORQUE = 22
LEVER = 23
ROLLING_DAMPING = 24
TURNING_LEVER = 25
SLOPE_WEIGHT = 26
FORCE_RESPONSE = 27
YAW_CORIOLIS = 28
YAW_LEVER = 29
YAW_DAMPING = 30
YAW_WEIGHT = 31
YAW_COULOMB_TORQUE = 32
ROLLING_TORQUE = 33
YAW_ROLLING_TORQUE = 34
YAW_MOTOR_TORQUE = 35
ROTOR_COUPLING = 36
PITCH_INERTIA = 37
YAW_SWING = 38
STICTION_RATE_SQUARED = 39
SPEED_LAG = 40
ACCELERATION_LIMIT = 41
SLIP_TORQUE = 42
YAW_INERTIA = 43
WORK, WORK_ROWS = 44, 21


class Constants(NamedTuple):
    """The products of a robot's parameters in its equations of motion; a11 and a33 of the upright robot."""

    half_track: Any             # W/(2R): wheel angle, from the mean, per angle of yaw
    wheel_radius: Any           # R [m]
    gravity: Any                # g [m/s²]
    motor_damping: Any          # 2β/a11 [1/s]: both motors' torque lost per rate of wheel and body
    centrifugal: Any            # (ML² + J_ρ − J_φ)/a11: pitch acceleration per yaw rate², times sin ψ cos ψ
    weight: Any                 # MgL/a11 [1/s²]: the moment of gravity on the leaning body
    moment_response: Any        # 1/a11 [1/(kg m²)]: what a moment on the body gives
    coulomb_torque: Any         # τ_c/a11 [1/s²]: dry friction of one motor
    motor_torque: Any           # α/a11 [1/(V s²)]: the torque of a volt on one motor
    lever: Any                  # MLR/a11: the coupling of pitch and wheels, times cos ψ
    rolling_damping: Any        # 2(β + f_w)/a11 [1/s]: motors' and wheels' damping of the wheel rate
    turning_lever: Any          # MLR/a11, or 0 in the published model: per yaw rate², times sin ψ
    slope_weight: Any           # (M + 2m)gR/a11 [1/s²]
    force_response: Any         # R/a11 [1/(kg m)]: what a horizontal force on the body gives
    yaw_coriolis: Any           # 2(ML² + J_ρ − J_φ)/a33: yaw acceleration per pitch rate and yaw rate
    yaw_lever: Any              # MLR/a33, or 0 in the published model: per wheel and yaw rate, times sin ψ
    yaw_damping: Any            # 2(W/2R)²(β + f_w)/a33 [1/s]: motors' and wheels' damping of yaw
    yaw_weight: Any             # MgL/a33 [1/s²]: gravity's moment about the vertical on a slope
    yaw_coulomb_torque: Any     # (W/2R)τ_c/a33 [1/s²]: dry friction of one motor, in yaw
    rolling_torque: Any         # τ_w/a11 [1/s²]: dry friction of one wheel on the floor
    yaw_rolling_torque: Any     # (W/2R)τ_w/a33 [1/s²]: that of one wheel, in yaw
    yaw_motor_torque: Any       # (W/2R)α/a33 [1/(V s²)]: the torque of a volt, in yaw
    rotor_coupling: Any         # 2n²J_m/a11: the rotors' part of a12
    pitch_inertia: Any          # a22/a11: inertia in pitch over that of all that rolls
    yaw_swing: Any              # (ML² + J_ρ − J_φ)/a33: what a lean adds to the inertia in yaw, times sin² ψ
    stiction_rate_squared: Any  # ω_c² [rad²/s²]: of the smoothed dry friction
    speed_lag: Any              # T_v [s]: in which a speed drive takes up a speed
    acceleration_limit: Any     # α_max [rad/s²]: of a speed drive
    slip_torque: Any            # τ_max/a11 [1/s²]: what a wheel of a speed drive gets at most
    yaw_inertia: Any            # a33/a11: inertia in yaw over that of all that rolls



def constants(p, complete):
    wheel_mass, wheel_radius, wheel_inertia, body_mass, track, com_height, pitch_inertia, yaw_inertia, roll_inertia, rotor_inertia, gear_ratio, motor_resistance, back_emf, torque_constant, motor_friction, wheel_friction, coulomb_friction, rolling_friction, stiction_rate, gravity, body_depth, body_height, speed_lag, acceleration_limit, slip_torque = p
    t0 = (1/2)*track/wheel_radius
    t1 = gear_ratio*torque_constant/motor_resistance
    t2 = back_emf*t1 + motor_friction
    t3 = (gear_ratio * gear_ratio)*rotor_inertia
    t4 = 2*t3
    t5 = (wheel_radius * wheel_radius)
    t6 = body_mass + 2*wheel_mass
    t7 = 1/(t4 + t5*t6 + 2*wheel_inertia)
    t8 = 2*t7
    t9 = body_mass*(com_height * com_height)
    t10 = complete*(roll_inertia - yaw_inertia) + t9
    t11 = body_mass*com_height
    t12 = gravity*t11
    t13 = t7*wheel_radius
    t14 = t11*t13
    t15 = t2 + wheel_friction
    t16 = 1/t5
    t17 = (1/2)*(track * track)
    t18 = t17*(t16*(t3 + wheel_inertia) + wheel_mass) + yaw_inertia
    t19 = 1/t18
    t20 = t10*t19
    t21 = t0*t19
    return Constants(t0, wheel_radius, gravity, t2*t8, t10*t7, t12*t7, t7, coulomb_friction*t7, t1*t7, t14, t15*t8, complete*t14, gravity*t13*t6, t13, 2*t20, complete*t11*t19*wheel_radius, t15*t16*t17*t19, t12*t19, coulomb_friction*t21, rolling_friction*t7, rolling_friction*t21, t1*t21, t4*t7, t7*(pitch_inertia + t4 + t9), t20, (stiction_rate * stiction_rate), speed_lag, acceleration_limit, slip_torque*t7, t18*t7)
