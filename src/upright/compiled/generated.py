# Generated from physics.dynamics: do not edit. Written again by: python -m upright.compiled.generate
# ruff: noqa
# fmt: off
# pyright: basic

LANES, ROW, SIZE = 64, 80, 59 * 80
CONSTANTS = 24
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
C0 = 14
WORK, WORK_ROWS = 38, 21


def constants(p, complete):
    wheel_mass = p[0]
    wheel_radius = p[1]
    wheel_inertia = p[2]
    body_mass = p[3]
    track = p[4]
    com_height = p[5]
    pitch_inertia = p[6]
    yaw_inertia = p[7]
    roll_inertia = p[8]
    rotor_inertia = p[9]
    gear_ratio = p[10]
    motor_resistance = p[11]
    back_emf = p[12]
    torque_constant = p[13]
    motor_friction = p[14]
    wheel_friction = p[15]
    coulomb_friction = p[16]
    stiction_rate = p[17]
    gravity = p[18]
    body_depth = p[19]
    body_height = p[20]
    t0 = (1/2)*track/wheel_radius
    t1 = gear_ratio*torque_constant
    t2 = back_emf*t1 + motor_friction*motor_resistance
    t3 = (wheel_radius * wheel_radius)
    t4 = (gear_ratio * gear_ratio)*rotor_inertia
    t5 = 2*t4
    t6 = 2*wheel_mass
    t7 = 1/(body_mass*t3 + t3*t6 + t5 + 2*wheel_inertia)
    t8 = 1/motor_resistance
    t9 = t7*t8
    t10 = 2*t9
    t11 = body_mass*(com_height * com_height)
    t12 = complete*roll_inertia - complete*yaw_inertia + t11
    t13 = body_mass*com_height
    t14 = gravity*t13
    t15 = t7*wheel_radius
    t16 = t13*t15
    t17 = motor_resistance*wheel_friction + t2
    t18 = (1/2)*(track * track)
    t19 = t18/t3
    t20 = 1/(t18*wheel_mass + t19*t4 + t19*wheel_inertia + yaw_inertia)
    t21 = t0*t20
    return (t0, wheel_radius, gravity, -t10*t2, t12*t7, t14*t7, t7, coulomb_friction*t7, -t1*t9, t16, -t10*t17, complete*t16, -gravity*t15*(body_mass + t6), t15, -2*t12*t20, -complete*t13*t20*wheel_radius, -t17*t19*t20*t8, t14*t20, coulomb_friction*t21, -t1*t21*t8, -t5*t7, t7*(pitch_inertia + t11 + t5), t12*t20, (stiction_rate * stiction_rate))
