# Generated from physics.dynamics: do not edit. Written again by: python -m upright.compiled.generate
# ruff: noqa
# fmt: off
# pyright: basic

from upright.compiled.generated import WORK
from upright.compiled.jit import absolute, align_stack, fma, get, inlined, put, sqrt
from upright.compiled.lane_math import sincos, sincos_any

@inlined
def ended(h, sixth, angle, rate, one, two, three, four):
    middle = two + three
    all_four = one + middle
    mean = fma(sixth, all_four, rate)
    new = fma(h, mean, angle)
    weighted = all_four + middle + four
    new_rate = fma(sixth, weighted, rate)
    return new, new_rate



@inlined
def held_smooth(left, right, force, moment, moment_response, motor_torque, force_response, yaw_motor_torque):
    t3 = -left - right
    t4 = motor_torque * t3
    held_pitch = t4
    t5 = force_response * force
    t6 = left + right
    t7 = fma(motor_torque, t6, t5)
    held_wheel = t7
    t8 = -left + right
    t9 = yaw_motor_torque * t8
    held_yaw = t9
    t10 = moment_response * moment
    return held_pitch, held_wheel, held_yaw, t10



@inlined
def moved_smooth(pitch, pitch_rate, wheel_rate, yaw_rate, held_pitch, held_wheel, held_yaw, t10, motor_damping, centrifugal, weight, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, rotor_coupling, pitch_inertia, yaw_swing):
    s, c = sincos(pitch)
    t0 = fma(lever, c, -rotor_coupling)
    a12 = t0
    a22 = pitch_inertia
    t1 = s * s
    t2 = fma(yaw_swing, t1, 1.0)
    a33 = t2
    determinant = fma(-a12, a12, a22)
    before_0 = determinant * a33
    over = 1.0 / before_0
    over_1 = over * determinant
    rest_1 = over * a33
    t11 = -pitch_rate + wheel_rate
    t12 = centrifugal * c
    t13 = yaw_rate * yaw_rate
    t14 = fma(t12, t13, weight)
    t15 = fma(t14, s, fma(motor_damping, t11, fma(t10, c, held_pitch)))
    t16 = pitch_rate * pitch_rate
    t17 = lever * t16
    t18 = fma(turning_lever, t13, t17)
    t19 = fma(t18, s, fma(-rolling_damping, wheel_rate, fma(motor_damping, pitch_rate, held_wheel)))
    t20 = yaw_coriolis * c
    t21 = t20 * pitch_rate
    t22 = fma(-yaw_lever, wheel_rate, -t21)
    t23 = fma(t22, s, -yaw_damping)
    t24 = fma(t23, yaw_rate, held_yaw)
    pitch_alone = fma(-a12, t19, t15)
    pitch_acc = pitch_alone * rest_1
    wheel_acc = fma(-a12, pitch_acc, t19)
    yaw_acc = t24 * over_1
    return pitch_acc, wheel_acc, yaw_acc



@inlined
def accelerations_smooth(pitch, pitch_rate, wheel_rate, yaw_rate, left, right, force, moment, motor_damping, centrifugal, weight, moment_response, motor_torque, lever, rolling_damping, turning_lever, force_response, yaw_coriolis, yaw_lever, yaw_damping, yaw_motor_torque, rotor_coupling, pitch_inertia, yaw_swing):
    held_pitch, held_wheel, held_yaw, t10 = held_smooth(left, right, force, moment, moment_response, motor_torque, force_response, yaw_motor_torque)
    return moved_smooth(pitch, pitch_rate, wheel_rate, yaw_rate, held_pitch, held_wheel, held_yaw, t10, motor_damping, centrifugal, weight, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, rotor_coupling, pitch_inertia, yaw_swing)



@inlined
def constants_smooth(w, i):
    return get(w, 17, i), get(w, 18, i), get(w, 19, i), get(w, 20, i), get(w, 22, i), get(w, 23, i), get(w, 24, i), get(w, 25, i), get(w, 27, i), get(w, 28, i), get(w, 29, i), get(w, 30, i), get(w, 35, i), get(w, 36, i), get(w, 37, i), get(w, 38, i)



@inlined
def rk4_smooth(pitch, pitch_rate, wheel, wheel_rate, yaw, yaw_rate, h, left, right, force, moment, motor_damping, centrifugal, weight, moment_response, motor_torque, lever, rolling_damping, turning_lever, force_response, yaw_coriolis, yaw_lever, yaw_damping, yaw_motor_torque, rotor_coupling, pitch_inertia, yaw_swing):
    held_pitch, held_wheel, held_yaw, t10 = held_smooth(left, right, force, moment, moment_response, motor_torque, force_response, yaw_motor_torque)
    pitch_acc1, wheel_acc1, yaw_acc1 = moved_smooth(pitch, pitch_rate, wheel_rate, yaw_rate, held_pitch, held_wheel, held_yaw, t10, motor_damping, centrifugal, weight, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, rotor_coupling, pitch_inertia, yaw_swing)
    half = 0.5 * h
    pitch2 = fma(half, pitch_rate, pitch)
    pitch_rate2 = fma(half, pitch_acc1, pitch_rate)
    wheel_rate2 = fma(half, wheel_acc1, wheel_rate)
    yaw_rate2 = fma(half, yaw_acc1, yaw_rate)
    pitch_acc2, wheel_acc2, yaw_acc2 = moved_smooth(pitch2, pitch_rate2, wheel_rate2, yaw_rate2, held_pitch, held_wheel, held_yaw, t10, motor_damping, centrifugal, weight, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, rotor_coupling, pitch_inertia, yaw_swing)
    pitch3 = fma(half, pitch_rate2, pitch)
    pitch_rate3 = fma(half, pitch_acc2, pitch_rate)
    wheel_rate3 = fma(half, wheel_acc2, wheel_rate)
    yaw_rate3 = fma(half, yaw_acc2, yaw_rate)
    pitch_acc3, wheel_acc3, yaw_acc3 = moved_smooth(pitch3, pitch_rate3, wheel_rate3, yaw_rate3, held_pitch, held_wheel, held_yaw, t10, motor_damping, centrifugal, weight, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, rotor_coupling, pitch_inertia, yaw_swing)
    pitch4 = fma(h, pitch_rate3, pitch)
    pitch_rate4 = fma(h, pitch_acc3, pitch_rate)
    wheel_rate4 = fma(h, wheel_acc3, wheel_rate)
    yaw_rate4 = fma(h, yaw_acc3, yaw_rate)
    pitch_acc4, wheel_acc4, yaw_acc4 = moved_smooth(pitch4, pitch_rate4, wheel_rate4, yaw_rate4, held_pitch, held_wheel, held_yaw, t10, motor_damping, centrifugal, weight, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, rotor_coupling, pitch_inertia, yaw_swing)
    sixth = 1 / 6 * h
    new_pitch, new_pitch_rate = ended(h, sixth, pitch, pitch_rate, pitch_acc1, pitch_acc2, pitch_acc3, pitch_acc4)
    new_wheel, new_wheel_rate = ended(h, sixth, wheel, wheel_rate, wheel_acc1, wheel_acc2, wheel_acc3, wheel_acc4)
    new_yaw, new_yaw_rate = ended(h, sixth, yaw, yaw_rate, yaw_acc1, yaw_acc2, yaw_acc3, yaw_acc4)
    return new_pitch, new_pitch_rate, new_wheel, new_wheel_rate, new_yaw, new_yaw_rate



def step_smooth(w, count, fallen, now):
    i = 0
    pitch, pitch_rate, wheel, wheel_rate, yaw, yaw_rate, h, lived, left, right, force, moment = get(w, 0, i), get(w, 1, i), get(w, 2, i), get(w, 3, i), get(w, 4, i), get(w, 5, i), get(w, 6, i), get(w, 7, i), get(w, 8, i), get(w, 9, i), get(w, 10, i), get(w, 11, i)
    new_pitch, new_pitch_rate, new_wheel, new_wheel_rate, new_yaw, new_yaw_rate = rk4_smooth(pitch, pitch_rate, wheel, wheel_rate, yaw, yaw_rate, h, left, right, force, moment, *constants_smooth(w, i))
    put(w, 0, i, new_pitch)
    put(w, 1, i, new_pitch_rate)
    put(w, 2, i, new_wheel)
    put(w, 3, i, new_wheel_rate)
    put(w, 4, i, new_yaw)
    put(w, 5, i, new_yaw_rate)
    put(w, 7, i, now if h > 0.0 else lived)
    put(w, 6, i, h if absolute(new_pitch) <= fallen else 0.0)



def advance_smooth(w, count, fallen, now):
    align_stack()
    for i in range(count):
        pitch, pitch_rate, wheel_rate, yaw_rate, left, right, force, moment, motor_damping, centrifugal, weight, moment_response, motor_torque, lever, rolling_damping, turning_lever, force_response, yaw_coriolis, yaw_lever, yaw_damping, yaw_motor_torque, rotor_coupling, pitch_inertia, yaw_swing = get(w, 0, i), get(w, 1, i), get(w, 3, i), get(w, 5, i), get(w, 8, i), get(w, 9, i), get(w, 10, i), get(w, 11, i), get(w, 17, i), get(w, 18, i), get(w, 19, i), get(w, 20, i), get(w, 22, i), get(w, 23, i), get(w, 24, i), get(w, 25, i), get(w, 27, i), get(w, 28, i), get(w, 29, i), get(w, 30, i), get(w, 35, i), get(w, 36, i), get(w, 37, i), get(w, 38, i)
        held_pitch, held_wheel, held_yaw, t10 = held_smooth(left, right, force, moment, moment_response, motor_torque, force_response, yaw_motor_torque)
        pitch_acc1, wheel_acc1, yaw_acc1 = moved_smooth(pitch, pitch_rate, wheel_rate, yaw_rate, held_pitch, held_wheel, held_yaw, t10, motor_damping, centrifugal, weight, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, rotor_coupling, pitch_inertia, yaw_swing)
        put(w, WORK + 0, i, pitch_acc1)
        put(w, WORK + 1, i, wheel_acc1)
        put(w, WORK + 2, i, yaw_acc1)
        put(w, WORK + 11, i, held_pitch)
        put(w, WORK + 12, i, held_wheel)
        put(w, WORK + 13, i, held_yaw)
        put(w, WORK + 14, i, t10)
    for i in range(count):
        pitch, pitch_rate, wheel_rate, yaw_rate, h, motor_damping, centrifugal, weight, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, rotor_coupling, pitch_inertia, yaw_swing, pitch_acc1, wheel_acc1, yaw_acc1, held_pitch, held_wheel, held_yaw, t10 = get(w, 0, i), get(w, 1, i), get(w, 3, i), get(w, 5, i), get(w, 6, i), get(w, 17, i), get(w, 18, i), get(w, 19, i), get(w, 23, i), get(w, 24, i), get(w, 25, i), get(w, 28, i), get(w, 29, i), get(w, 30, i), get(w, 36, i), get(w, 37, i), get(w, 38, i), get(w, WORK + 0, i), get(w, WORK + 1, i), get(w, WORK + 2, i), get(w, WORK + 11, i), get(w, WORK + 12, i), get(w, WORK + 13, i), get(w, WORK + 14, i)
        half = 0.5 * h
        pitch2 = fma(half, pitch_rate, pitch)
        pitch_rate2 = fma(half, pitch_acc1, pitch_rate)
        wheel_rate2 = fma(half, wheel_acc1, wheel_rate)
        yaw_rate2 = fma(half, yaw_acc1, yaw_rate)
        pitch_acc2, wheel_acc2, yaw_acc2 = moved_smooth(pitch2, pitch_rate2, wheel_rate2, yaw_rate2, held_pitch, held_wheel, held_yaw, t10, motor_damping, centrifugal, weight, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, rotor_coupling, pitch_inertia, yaw_swing)
        put(w, WORK + 3, i, pitch_acc2)
        put(w, WORK + 4, i, wheel_acc2)
        put(w, WORK + 5, i, yaw_acc2)
        put(w, WORK + 9, i, pitch_rate2)
    for i in range(count):
        pitch, pitch_rate, wheel_rate, yaw_rate, h, motor_damping, centrifugal, weight, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, rotor_coupling, pitch_inertia, yaw_swing, pitch_acc2, wheel_acc2, yaw_acc2, pitch_rate2, held_pitch, held_wheel, held_yaw, t10 = get(w, 0, i), get(w, 1, i), get(w, 3, i), get(w, 5, i), get(w, 6, i), get(w, 17, i), get(w, 18, i), get(w, 19, i), get(w, 23, i), get(w, 24, i), get(w, 25, i), get(w, 28, i), get(w, 29, i), get(w, 30, i), get(w, 36, i), get(w, 37, i), get(w, 38, i), get(w, WORK + 3, i), get(w, WORK + 4, i), get(w, WORK + 5, i), get(w, WORK + 9, i), get(w, WORK + 11, i), get(w, WORK + 12, i), get(w, WORK + 13, i), get(w, WORK + 14, i)
        half = 0.5 * h
        pitch3 = fma(half, pitch_rate2, pitch)
        pitch_rate3 = fma(half, pitch_acc2, pitch_rate)
        wheel_rate3 = fma(half, wheel_acc2, wheel_rate)
        yaw_rate3 = fma(half, yaw_acc2, yaw_rate)
        pitch_acc3, wheel_acc3, yaw_acc3 = moved_smooth(pitch3, pitch_rate3, wheel_rate3, yaw_rate3, held_pitch, held_wheel, held_yaw, t10, motor_damping, centrifugal, weight, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, rotor_coupling, pitch_inertia, yaw_swing)
        put(w, WORK + 6, i, pitch_acc3)
        put(w, WORK + 7, i, wheel_acc3)
        put(w, WORK + 8, i, yaw_acc3)
        put(w, WORK + 10, i, pitch_rate3)
    for i in range(count):
        pitch, pitch_rate, wheel, wheel_rate, yaw, yaw_rate, h, lived, motor_damping, centrifugal, weight, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, rotor_coupling, pitch_inertia, yaw_swing, pitch_acc1, wheel_acc1, yaw_acc1, pitch_acc2, wheel_acc2, yaw_acc2, pitch_acc3, wheel_acc3, yaw_acc3, pitch_rate3, held_pitch, held_wheel, held_yaw, t10 = get(w, 0, i), get(w, 1, i), get(w, 2, i), get(w, 3, i), get(w, 4, i), get(w, 5, i), get(w, 6, i), get(w, 7, i), get(w, 17, i), get(w, 18, i), get(w, 19, i), get(w, 23, i), get(w, 24, i), get(w, 25, i), get(w, 28, i), get(w, 29, i), get(w, 30, i), get(w, 36, i), get(w, 37, i), get(w, 38, i), get(w, WORK + 0, i), get(w, WORK + 1, i), get(w, WORK + 2, i), get(w, WORK + 3, i), get(w, WORK + 4, i), get(w, WORK + 5, i), get(w, WORK + 6, i), get(w, WORK + 7, i), get(w, WORK + 8, i), get(w, WORK + 10, i), get(w, WORK + 11, i), get(w, WORK + 12, i), get(w, WORK + 13, i), get(w, WORK + 14, i)
        pitch4 = fma(h, pitch_rate3, pitch)
        pitch_rate4 = fma(h, pitch_acc3, pitch_rate)
        wheel_rate4 = fma(h, wheel_acc3, wheel_rate)
        yaw_rate4 = fma(h, yaw_acc3, yaw_rate)
        pitch_acc4, wheel_acc4, yaw_acc4 = moved_smooth(pitch4, pitch_rate4, wheel_rate4, yaw_rate4, held_pitch, held_wheel, held_yaw, t10, motor_damping, centrifugal, weight, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, rotor_coupling, pitch_inertia, yaw_swing)
        sixth = 1 / 6 * h
        new_pitch, new_pitch_rate = ended(h, sixth, pitch, pitch_rate, pitch_acc1, pitch_acc2, pitch_acc3, pitch_acc4)
        new_wheel, new_wheel_rate = ended(h, sixth, wheel, wheel_rate, wheel_acc1, wheel_acc2, wheel_acc3, wheel_acc4)
        new_yaw, new_yaw_rate = ended(h, sixth, yaw, yaw_rate, yaw_acc1, yaw_acc2, yaw_acc3, yaw_acc4)
        put(w, 0, i, new_pitch)
        put(w, 1, i, new_pitch_rate)
        put(w, 2, i, new_wheel)
        put(w, 3, i, new_wheel_rate)
        put(w, 4, i, new_yaw)
        put(w, 5, i, new_yaw_rate)
        put(w, 7, i, now if h > 0.0 else lived)
        put(w, 6, i, h if absolute(new_pitch) <= fallen else 0.0)



def specific_force_smooth(w, count, out):
    for i in range(count):
        pitch, pitch_rate, wheel_rate, yaw_rate, left, right, force, moment, wheel_radius, gravity, motor_damping, centrifugal, weight, moment_response, motor_torque, lever, rolling_damping, turning_lever, force_response, yaw_coriolis, yaw_lever, yaw_damping, yaw_motor_torque, rotor_coupling, pitch_inertia, yaw_swing = get(w, 0, i), get(w, 1, i), get(w, 3, i), get(w, 5, i), get(w, 8, i), get(w, 9, i), get(w, 10, i), get(w, 11, i), get(w, 15, i), get(w, 16, i), get(w, 17, i), get(w, 18, i), get(w, 19, i), get(w, 20, i), get(w, 22, i), get(w, 23, i), get(w, 24, i), get(w, 25, i), get(w, 27, i), get(w, 28, i), get(w, 29, i), get(w, 30, i), get(w, 35, i), get(w, 36, i), get(w, 37, i), get(w, 38, i)
        held_pitch, held_wheel, held_yaw, t10 = held_smooth(left, right, force, moment, moment_response, motor_torque, force_response, yaw_motor_torque)
        _, wheel_acc, _ = moved_smooth(pitch, pitch_rate, wheel_rate, yaw_rate, held_pitch, held_wheel, held_yaw, t10, motor_damping, centrifugal, weight, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, rotor_coupling, pitch_inertia, yaw_swing)
        s, c = sincos(pitch)
        t0 = wheel_acc * wheel_radius
        t1 = t0 * c
        t2 = fma(-gravity, s, t1)
        forward = t2
        t3 = gravity * c
        t4 = fma(t0, s, t3)
        up = t4
        put(w, out + 0, i, forward)
        put(w, out + 1, i, up)



@inlined
def held_coulomb(left, right, force, moment, moment_response, motor_torque, force_response, yaw_motor_torque):
    t5 = -left - right
    t6 = motor_torque * t5
    held_pitch = t6
    t7 = force_response * force
    t8 = left + right
    t9 = fma(motor_torque, t8, t7)
    held_wheel = t9
    t10 = -left + right
    t11 = yaw_motor_torque * t10
    held_yaw = t11
    t12 = moment_response * moment
    return held_pitch, held_wheel, held_yaw, t12



@inlined
def moved_coulomb(pitch, pitch_rate, wheel_rate, yaw_rate, held_pitch, held_wheel, held_yaw, t12, half_track, motor_damping, centrifugal, weight, coulomb_torque, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, yaw_coulomb_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared):
    s, c = sincos(pitch)
    t0 = fma(lever, c, -rotor_coupling)
    a12 = t0
    a22 = pitch_inertia
    t1 = s * s
    t2 = fma(yaw_swing, t1, 1.0)
    a33 = t2
    determinant = fma(-a12, a12, a22)
    t3 = fma(-half_track, yaw_rate, -pitch_rate + wheel_rate)
    rate_slip_left = t3
    square_slip_left = fma(rate_slip_left, rate_slip_left, stiction_rate_squared)
    root_slip_left = sqrt(square_slip_left)
    t4 = fma(half_track, yaw_rate, -pitch_rate + wheel_rate)
    rate_slip_right = t4
    square_slip_right = fma(rate_slip_right, rate_slip_right, stiction_rate_squared)
    root_slip_right = sqrt(square_slip_right)
    before_0 = determinant * a33
    before_1 = before_0 * root_slip_left
    before_2 = before_1 * root_slip_right
    over = 1.0 / before_2
    over_3 = over * before_1
    rest_3 = over * root_slip_right
    over_2 = rest_3 * before_0
    rest_2 = rest_3 * root_slip_left
    over_1 = rest_2 * determinant
    rest_1 = rest_2 * a33
    slip_left = rate_slip_left * over_2
    slip_right = rate_slip_right * over_3
    t13 = slip_left + slip_right
    t14 = -pitch_rate + wheel_rate
    t15 = centrifugal * c
    t16 = yaw_rate * yaw_rate
    t17 = fma(t15, t16, weight)
    t18 = fma(t17, s, fma(motor_damping, t14, fma(coulomb_torque, t13, fma(t12, c, held_pitch))))
    t19 = -slip_left - slip_right
    t20 = pitch_rate * pitch_rate
    t21 = lever * t20
    t22 = fma(turning_lever, t16, t21)
    t23 = fma(t22, s, fma(-rolling_damping, wheel_rate, fma(coulomb_torque, t19, fma(motor_damping, pitch_rate, held_wheel))))
    t24 = slip_left - slip_right
    t25 = yaw_coriolis * c
    t26 = t25 * pitch_rate
    t27 = fma(-yaw_lever, wheel_rate, -t26)
    t28 = fma(t27, s, -yaw_damping)
    t29 = fma(t28, yaw_rate, fma(yaw_coulomb_torque, t24, held_yaw))
    pitch_alone = fma(-a12, t23, t18)
    pitch_acc = pitch_alone * rest_1
    wheel_acc = fma(-a12, pitch_acc, t23)
    yaw_acc = t29 * over_1
    return pitch_acc, wheel_acc, yaw_acc



@inlined
def accelerations_coulomb(pitch, pitch_rate, wheel_rate, yaw_rate, left, right, force, moment, half_track, motor_damping, centrifugal, weight, moment_response, coulomb_torque, motor_torque, lever, rolling_damping, turning_lever, force_response, yaw_coriolis, yaw_lever, yaw_damping, yaw_coulomb_torque, yaw_motor_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared):
    held_pitch, held_wheel, held_yaw, t12 = held_coulomb(left, right, force, moment, moment_response, motor_torque, force_response, yaw_motor_torque)
    return moved_coulomb(pitch, pitch_rate, wheel_rate, yaw_rate, held_pitch, held_wheel, held_yaw, t12, half_track, motor_damping, centrifugal, weight, coulomb_torque, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, yaw_coulomb_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared)



@inlined
def constants_coulomb(w, i):
    return get(w, 14, i), get(w, 17, i), get(w, 18, i), get(w, 19, i), get(w, 20, i), get(w, 21, i), get(w, 22, i), get(w, 23, i), get(w, 24, i), get(w, 25, i), get(w, 27, i), get(w, 28, i), get(w, 29, i), get(w, 30, i), get(w, 32, i), get(w, 35, i), get(w, 36, i), get(w, 37, i), get(w, 38, i), get(w, 39, i)



@inlined
def rk4_coulomb(pitch, pitch_rate, wheel, wheel_rate, yaw, yaw_rate, h, left, right, force, moment, half_track, motor_damping, centrifugal, weight, moment_response, coulomb_torque, motor_torque, lever, rolling_damping, turning_lever, force_response, yaw_coriolis, yaw_lever, yaw_damping, yaw_coulomb_torque, yaw_motor_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared):
    held_pitch, held_wheel, held_yaw, t12 = held_coulomb(left, right, force, moment, moment_response, motor_torque, force_response, yaw_motor_torque)
    pitch_acc1, wheel_acc1, yaw_acc1 = moved_coulomb(pitch, pitch_rate, wheel_rate, yaw_rate, held_pitch, held_wheel, held_yaw, t12, half_track, motor_damping, centrifugal, weight, coulomb_torque, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, yaw_coulomb_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared)
    half = 0.5 * h
    pitch2 = fma(half, pitch_rate, pitch)
    pitch_rate2 = fma(half, pitch_acc1, pitch_rate)
    wheel_rate2 = fma(half, wheel_acc1, wheel_rate)
    yaw_rate2 = fma(half, yaw_acc1, yaw_rate)
    pitch_acc2, wheel_acc2, yaw_acc2 = moved_coulomb(pitch2, pitch_rate2, wheel_rate2, yaw_rate2, held_pitch, held_wheel, held_yaw, t12, half_track, motor_damping, centrifugal, weight, coulomb_torque, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, yaw_coulomb_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared)
    pitch3 = fma(half, pitch_rate2, pitch)
    pitch_rate3 = fma(half, pitch_acc2, pitch_rate)
    wheel_rate3 = fma(half, wheel_acc2, wheel_rate)
    yaw_rate3 = fma(half, yaw_acc2, yaw_rate)
    pitch_acc3, wheel_acc3, yaw_acc3 = moved_coulomb(pitch3, pitch_rate3, wheel_rate3, yaw_rate3, held_pitch, held_wheel, held_yaw, t12, half_track, motor_damping, centrifugal, weight, coulomb_torque, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, yaw_coulomb_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared)
    pitch4 = fma(h, pitch_rate3, pitch)
    pitch_rate4 = fma(h, pitch_acc3, pitch_rate)
    wheel_rate4 = fma(h, wheel_acc3, wheel_rate)
    yaw_rate4 = fma(h, yaw_acc3, yaw_rate)
    pitch_acc4, wheel_acc4, yaw_acc4 = moved_coulomb(pitch4, pitch_rate4, wheel_rate4, yaw_rate4, held_pitch, held_wheel, held_yaw, t12, half_track, motor_damping, centrifugal, weight, coulomb_torque, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, yaw_coulomb_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared)
    sixth = 1 / 6 * h
    new_pitch, new_pitch_rate = ended(h, sixth, pitch, pitch_rate, pitch_acc1, pitch_acc2, pitch_acc3, pitch_acc4)
    new_wheel, new_wheel_rate = ended(h, sixth, wheel, wheel_rate, wheel_acc1, wheel_acc2, wheel_acc3, wheel_acc4)
    new_yaw, new_yaw_rate = ended(h, sixth, yaw, yaw_rate, yaw_acc1, yaw_acc2, yaw_acc3, yaw_acc4)
    return new_pitch, new_pitch_rate, new_wheel, new_wheel_rate, new_yaw, new_yaw_rate



def step_coulomb(w, count, fallen, now):
    i = 0
    pitch, pitch_rate, wheel, wheel_rate, yaw, yaw_rate, h, lived, left, right, force, moment = get(w, 0, i), get(w, 1, i), get(w, 2, i), get(w, 3, i), get(w, 4, i), get(w, 5, i), get(w, 6, i), get(w, 7, i), get(w, 8, i), get(w, 9, i), get(w, 10, i), get(w, 11, i)
    new_pitch, new_pitch_rate, new_wheel, new_wheel_rate, new_yaw, new_yaw_rate = rk4_coulomb(pitch, pitch_rate, wheel, wheel_rate, yaw, yaw_rate, h, left, right, force, moment, *constants_coulomb(w, i))
    put(w, 0, i, new_pitch)
    put(w, 1, i, new_pitch_rate)
    put(w, 2, i, new_wheel)
    put(w, 3, i, new_wheel_rate)
    put(w, 4, i, new_yaw)
    put(w, 5, i, new_yaw_rate)
    put(w, 7, i, now if h > 0.0 else lived)
    put(w, 6, i, h if absolute(new_pitch) <= fallen else 0.0)



def advance_coulomb(w, count, fallen, now):
    align_stack()
    for i in range(count):
        pitch, pitch_rate, wheel_rate, yaw_rate, left, right, force, moment, half_track, motor_damping, centrifugal, weight, moment_response, coulomb_torque, motor_torque, lever, rolling_damping, turning_lever, force_response, yaw_coriolis, yaw_lever, yaw_damping, yaw_coulomb_torque, yaw_motor_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared = get(w, 0, i), get(w, 1, i), get(w, 3, i), get(w, 5, i), get(w, 8, i), get(w, 9, i), get(w, 10, i), get(w, 11, i), get(w, 14, i), get(w, 17, i), get(w, 18, i), get(w, 19, i), get(w, 20, i), get(w, 21, i), get(w, 22, i), get(w, 23, i), get(w, 24, i), get(w, 25, i), get(w, 27, i), get(w, 28, i), get(w, 29, i), get(w, 30, i), get(w, 32, i), get(w, 35, i), get(w, 36, i), get(w, 37, i), get(w, 38, i), get(w, 39, i)
        held_pitch, held_wheel, held_yaw, t12 = held_coulomb(left, right, force, moment, moment_response, motor_torque, force_response, yaw_motor_torque)
        pitch_acc1, wheel_acc1, yaw_acc1 = moved_coulomb(pitch, pitch_rate, wheel_rate, yaw_rate, held_pitch, held_wheel, held_yaw, t12, half_track, motor_damping, centrifugal, weight, coulomb_torque, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, yaw_coulomb_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared)
        put(w, WORK + 0, i, pitch_acc1)
        put(w, WORK + 1, i, wheel_acc1)
        put(w, WORK + 2, i, yaw_acc1)
        put(w, WORK + 11, i, held_pitch)
        put(w, WORK + 12, i, held_wheel)
        put(w, WORK + 13, i, held_yaw)
        put(w, WORK + 14, i, t12)
    for i in range(count):
        pitch, pitch_rate, wheel_rate, yaw_rate, h, half_track, motor_damping, centrifugal, weight, coulomb_torque, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, yaw_coulomb_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared, pitch_acc1, wheel_acc1, yaw_acc1, held_pitch, held_wheel, held_yaw, t12 = get(w, 0, i), get(w, 1, i), get(w, 3, i), get(w, 5, i), get(w, 6, i), get(w, 14, i), get(w, 17, i), get(w, 18, i), get(w, 19, i), get(w, 21, i), get(w, 23, i), get(w, 24, i), get(w, 25, i), get(w, 28, i), get(w, 29, i), get(w, 30, i), get(w, 32, i), get(w, 36, i), get(w, 37, i), get(w, 38, i), get(w, 39, i), get(w, WORK + 0, i), get(w, WORK + 1, i), get(w, WORK + 2, i), get(w, WORK + 11, i), get(w, WORK + 12, i), get(w, WORK + 13, i), get(w, WORK + 14, i)
        half = 0.5 * h
        pitch2 = fma(half, pitch_rate, pitch)
        pitch_rate2 = fma(half, pitch_acc1, pitch_rate)
        wheel_rate2 = fma(half, wheel_acc1, wheel_rate)
        yaw_rate2 = fma(half, yaw_acc1, yaw_rate)
        pitch_acc2, wheel_acc2, yaw_acc2 = moved_coulomb(pitch2, pitch_rate2, wheel_rate2, yaw_rate2, held_pitch, held_wheel, held_yaw, t12, half_track, motor_damping, centrifugal, weight, coulomb_torque, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, yaw_coulomb_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared)
        put(w, WORK + 3, i, pitch_acc2)
        put(w, WORK + 4, i, wheel_acc2)
        put(w, WORK + 5, i, yaw_acc2)
        put(w, WORK + 9, i, pitch_rate2)
    for i in range(count):
        pitch, pitch_rate, wheel_rate, yaw_rate, h, half_track, motor_damping, centrifugal, weight, coulomb_torque, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, yaw_coulomb_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared, pitch_acc2, wheel_acc2, yaw_acc2, pitch_rate2, held_pitch, held_wheel, held_yaw, t12 = get(w, 0, i), get(w, 1, i), get(w, 3, i), get(w, 5, i), get(w, 6, i), get(w, 14, i), get(w, 17, i), get(w, 18, i), get(w, 19, i), get(w, 21, i), get(w, 23, i), get(w, 24, i), get(w, 25, i), get(w, 28, i), get(w, 29, i), get(w, 30, i), get(w, 32, i), get(w, 36, i), get(w, 37, i), get(w, 38, i), get(w, 39, i), get(w, WORK + 3, i), get(w, WORK + 4, i), get(w, WORK + 5, i), get(w, WORK + 9, i), get(w, WORK + 11, i), get(w, WORK + 12, i), get(w, WORK + 13, i), get(w, WORK + 14, i)
        half = 0.5 * h
        pitch3 = fma(half, pitch_rate2, pitch)
        pitch_rate3 = fma(half, pitch_acc2, pitch_rate)
        wheel_rate3 = fma(half, wheel_acc2, wheel_rate)
        yaw_rate3 = fma(half, yaw_acc2, yaw_rate)
        pitch_acc3, wheel_acc3, yaw_acc3 = moved_coulomb(pitch3, pitch_rate3, wheel_rate3, yaw_rate3, held_pitch, held_wheel, held_yaw, t12, half_track, motor_damping, centrifugal, weight, coulomb_torque, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, yaw_coulomb_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared)
        put(w, WORK + 6, i, pitch_acc3)
        put(w, WORK + 7, i, wheel_acc3)
        put(w, WORK + 8, i, yaw_acc3)
        put(w, WORK + 10, i, pitch_rate3)
    for i in range(count):
        pitch, pitch_rate, wheel, wheel_rate, yaw, yaw_rate, h, lived, half_track, motor_damping, centrifugal, weight, coulomb_torque, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, yaw_coulomb_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared, pitch_acc1, wheel_acc1, yaw_acc1, pitch_acc2, wheel_acc2, yaw_acc2, pitch_acc3, wheel_acc3, yaw_acc3, pitch_rate3, held_pitch, held_wheel, held_yaw, t12 = get(w, 0, i), get(w, 1, i), get(w, 2, i), get(w, 3, i), get(w, 4, i), get(w, 5, i), get(w, 6, i), get(w, 7, i), get(w, 14, i), get(w, 17, i), get(w, 18, i), get(w, 19, i), get(w, 21, i), get(w, 23, i), get(w, 24, i), get(w, 25, i), get(w, 28, i), get(w, 29, i), get(w, 30, i), get(w, 32, i), get(w, 36, i), get(w, 37, i), get(w, 38, i), get(w, 39, i), get(w, WORK + 0, i), get(w, WORK + 1, i), get(w, WORK + 2, i), get(w, WORK + 3, i), get(w, WORK + 4, i), get(w, WORK + 5, i), get(w, WORK + 6, i), get(w, WORK + 7, i), get(w, WORK + 8, i), get(w, WORK + 10, i), get(w, WORK + 11, i), get(w, WORK + 12, i), get(w, WORK + 13, i), get(w, WORK + 14, i)
        pitch4 = fma(h, pitch_rate3, pitch)
        pitch_rate4 = fma(h, pitch_acc3, pitch_rate)
        wheel_rate4 = fma(h, wheel_acc3, wheel_rate)
        yaw_rate4 = fma(h, yaw_acc3, yaw_rate)
        pitch_acc4, wheel_acc4, yaw_acc4 = moved_coulomb(pitch4, pitch_rate4, wheel_rate4, yaw_rate4, held_pitch, held_wheel, held_yaw, t12, half_track, motor_damping, centrifugal, weight, coulomb_torque, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, yaw_coulomb_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared)
        sixth = 1 / 6 * h
        new_pitch, new_pitch_rate = ended(h, sixth, pitch, pitch_rate, pitch_acc1, pitch_acc2, pitch_acc3, pitch_acc4)
        new_wheel, new_wheel_rate = ended(h, sixth, wheel, wheel_rate, wheel_acc1, wheel_acc2, wheel_acc3, wheel_acc4)
        new_yaw, new_yaw_rate = ended(h, sixth, yaw, yaw_rate, yaw_acc1, yaw_acc2, yaw_acc3, yaw_acc4)
        put(w, 0, i, new_pitch)
        put(w, 1, i, new_pitch_rate)
        put(w, 2, i, new_wheel)
        put(w, 3, i, new_wheel_rate)
        put(w, 4, i, new_yaw)
        put(w, 5, i, new_yaw_rate)
        put(w, 7, i, now if h > 0.0 else lived)
        put(w, 6, i, h if absolute(new_pitch) <= fallen else 0.0)



def specific_force_coulomb(w, count, out):
    for i in range(count):
        pitch, pitch_rate, wheel_rate, yaw_rate, left, right, force, moment, half_track, wheel_radius, gravity, motor_damping, centrifugal, weight, moment_response, coulomb_torque, motor_torque, lever, rolling_damping, turning_lever, force_response, yaw_coriolis, yaw_lever, yaw_damping, yaw_coulomb_torque, yaw_motor_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared = get(w, 0, i), get(w, 1, i), get(w, 3, i), get(w, 5, i), get(w, 8, i), get(w, 9, i), get(w, 10, i), get(w, 11, i), get(w, 14, i), get(w, 15, i), get(w, 16, i), get(w, 17, i), get(w, 18, i), get(w, 19, i), get(w, 20, i), get(w, 21, i), get(w, 22, i), get(w, 23, i), get(w, 24, i), get(w, 25, i), get(w, 27, i), get(w, 28, i), get(w, 29, i), get(w, 30, i), get(w, 32, i), get(w, 35, i), get(w, 36, i), get(w, 37, i), get(w, 38, i), get(w, 39, i)
        held_pitch, held_wheel, held_yaw, t12 = held_coulomb(left, right, force, moment, moment_response, motor_torque, force_response, yaw_motor_torque)
        _, wheel_acc, _ = moved_coulomb(pitch, pitch_rate, wheel_rate, yaw_rate, held_pitch, held_wheel, held_yaw, t12, half_track, motor_damping, centrifugal, weight, coulomb_torque, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, yaw_coulomb_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared)
        s, c = sincos(pitch)
        t0 = wheel_acc * wheel_radius
        t1 = t0 * c
        t2 = fma(-gravity, s, t1)
        forward = t2
        t3 = gravity * c
        t4 = fma(t0, s, t3)
        up = t4
        put(w, out + 0, i, forward)
        put(w, out + 1, i, up)



@inlined
def held_rolling(left, right, force, moment, moment_response, motor_torque, force_response, yaw_motor_torque):
    t7 = -left - right
    t8 = motor_torque * t7
    held_pitch = t8
    t9 = force_response * force
    t10 = left + right
    t11 = fma(motor_torque, t10, t9)
    held_wheel = t11
    t12 = -left + right
    t13 = yaw_motor_torque * t12
    held_yaw = t13
    t14 = moment_response * moment
    return held_pitch, held_wheel, held_yaw, t14



@inlined
def moved_rolling(pitch, pitch_rate, wheel_rate, yaw_rate, held_pitch, held_wheel, held_yaw, t14, half_track, motor_damping, centrifugal, weight, coulomb_torque, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, yaw_coulomb_torque, rolling_torque, yaw_rolling_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared):
    s, c = sincos(pitch)
    t0 = fma(lever, c, -rotor_coupling)
    a12 = t0
    a22 = pitch_inertia
    t1 = s * s
    t2 = fma(yaw_swing, t1, 1.0)
    a33 = t2
    determinant = fma(-a12, a12, a22)
    t3 = fma(-half_track, yaw_rate, -pitch_rate + wheel_rate)
    rate_slip_left = t3
    square_slip_left = fma(rate_slip_left, rate_slip_left, stiction_rate_squared)
    root_slip_left = sqrt(square_slip_left)
    t4 = fma(half_track, yaw_rate, -pitch_rate + wheel_rate)
    rate_slip_right = t4
    square_slip_right = fma(rate_slip_right, rate_slip_right, stiction_rate_squared)
    root_slip_right = sqrt(square_slip_right)
    t5 = fma(-half_track, yaw_rate, wheel_rate)
    rate_roll_left = t5
    square_roll_left = fma(rate_roll_left, rate_roll_left, stiction_rate_squared)
    root_roll_left = sqrt(square_roll_left)
    t6 = fma(half_track, yaw_rate, wheel_rate)
    rate_roll_right = t6
    square_roll_right = fma(rate_roll_right, rate_roll_right, stiction_rate_squared)
    root_roll_right = sqrt(square_roll_right)
    before_0 = determinant * a33
    before_1 = before_0 * root_slip_left
    before_2 = before_1 * root_slip_right
    before_3 = before_2 * root_roll_left
    before_4 = before_3 * root_roll_right
    over = 1.0 / before_4
    over_5 = over * before_3
    rest_5 = over * root_roll_right
    over_4 = rest_5 * before_2
    rest_4 = rest_5 * root_roll_left
    over_3 = rest_4 * before_1
    rest_3 = rest_4 * root_slip_right
    over_2 = rest_3 * before_0
    rest_2 = rest_3 * root_slip_left
    over_1 = rest_2 * determinant
    rest_1 = rest_2 * a33
    slip_left = rate_slip_left * over_2
    slip_right = rate_slip_right * over_3
    roll_left = rate_roll_left * over_4
    roll_right = rate_roll_right * over_5
    t15 = slip_left + slip_right
    t16 = -pitch_rate + wheel_rate
    t17 = centrifugal * c
    t18 = yaw_rate * yaw_rate
    t19 = fma(t17, t18, weight)
    t20 = fma(t19, s, fma(motor_damping, t16, fma(coulomb_torque, t15, fma(t14, c, held_pitch))))
    t21 = -roll_left - roll_right
    t22 = -slip_left - slip_right
    t23 = pitch_rate * pitch_rate
    t24 = lever * t23
    t25 = fma(turning_lever, t18, t24)
    t26 = fma(t25, s, fma(-rolling_damping, wheel_rate, fma(coulomb_torque, t22, fma(rolling_torque, t21, fma(motor_damping, pitch_rate, held_wheel)))))
    t27 = roll_left - roll_right
    t28 = slip_left - slip_right
    t29 = yaw_coriolis * c
    t30 = t29 * pitch_rate
    t31 = fma(-yaw_lever, wheel_rate, -t30)
    t32 = fma(t31, s, -yaw_damping)
    t33 = fma(t32, yaw_rate, fma(yaw_coulomb_torque, t28, fma(yaw_rolling_torque, t27, held_yaw)))
    pitch_alone = fma(-a12, t26, t20)
    pitch_acc = pitch_alone * rest_1
    wheel_acc = fma(-a12, pitch_acc, t26)
    yaw_acc = t33 * over_1
    return pitch_acc, wheel_acc, yaw_acc



@inlined
def accelerations_rolling(pitch, pitch_rate, wheel_rate, yaw_rate, left, right, force, moment, half_track, motor_damping, centrifugal, weight, moment_response, coulomb_torque, motor_torque, lever, rolling_damping, turning_lever, force_response, yaw_coriolis, yaw_lever, yaw_damping, yaw_coulomb_torque, rolling_torque, yaw_rolling_torque, yaw_motor_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared):
    held_pitch, held_wheel, held_yaw, t14 = held_rolling(left, right, force, moment, moment_response, motor_torque, force_response, yaw_motor_torque)
    return moved_rolling(pitch, pitch_rate, wheel_rate, yaw_rate, held_pitch, held_wheel, held_yaw, t14, half_track, motor_damping, centrifugal, weight, coulomb_torque, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, yaw_coulomb_torque, rolling_torque, yaw_rolling_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared)



@inlined
def constants_rolling(w, i):
    return get(w, 14, i), get(w, 17, i), get(w, 18, i), get(w, 19, i), get(w, 20, i), get(w, 21, i), get(w, 22, i), get(w, 23, i), get(w, 24, i), get(w, 25, i), get(w, 27, i), get(w, 28, i), get(w, 29, i), get(w, 30, i), get(w, 32, i), get(w, 33, i), get(w, 34, i), get(w, 35, i), get(w, 36, i), get(w, 37, i), get(w, 38, i), get(w, 39, i)



@inlined
def rk4_rolling(pitch, pitch_rate, wheel, wheel_rate, yaw, yaw_rate, h, left, right, force, moment, half_track, motor_damping, centrifugal, weight, moment_response, coulomb_torque, motor_torque, lever, rolling_damping, turning_lever, force_response, yaw_coriolis, yaw_lever, yaw_damping, yaw_coulomb_torque, rolling_torque, yaw_rolling_torque, yaw_motor_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared):
    held_pitch, held_wheel, held_yaw, t14 = held_rolling(left, right, force, moment, moment_response, motor_torque, force_response, yaw_motor_torque)
    pitch_acc1, wheel_acc1, yaw_acc1 = moved_rolling(pitch, pitch_rate, wheel_rate, yaw_rate, held_pitch, held_wheel, held_yaw, t14, half_track, motor_damping, centrifugal, weight, coulomb_torque, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, yaw_coulomb_torque, rolling_torque, yaw_rolling_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared)
    half = 0.5 * h
    pitch2 = fma(half, pitch_rate, pitch)
    pitch_rate2 = fma(half, pitch_acc1, pitch_rate)
    wheel_rate2 = fma(half, wheel_acc1, wheel_rate)
    yaw_rate2 = fma(half, yaw_acc1, yaw_rate)
    pitch_acc2, wheel_acc2, yaw_acc2 = moved_rolling(pitch2, pitch_rate2, wheel_rate2, yaw_rate2, held_pitch, held_wheel, held_yaw, t14, half_track, motor_damping, centrifugal, weight, coulomb_torque, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, yaw_coulomb_torque, rolling_torque, yaw_rolling_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared)
    pitch3 = fma(half, pitch_rate2, pitch)
    pitch_rate3 = fma(half, pitch_acc2, pitch_rate)
    wheel_rate3 = fma(half, wheel_acc2, wheel_rate)
    yaw_rate3 = fma(half, yaw_acc2, yaw_rate)
    pitch_acc3, wheel_acc3, yaw_acc3 = moved_rolling(pitch3, pitch_rate3, wheel_rate3, yaw_rate3, held_pitch, held_wheel, held_yaw, t14, half_track, motor_damping, centrifugal, weight, coulomb_torque, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, yaw_coulomb_torque, rolling_torque, yaw_rolling_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared)
    pitch4 = fma(h, pitch_rate3, pitch)
    pitch_rate4 = fma(h, pitch_acc3, pitch_rate)
    wheel_rate4 = fma(h, wheel_acc3, wheel_rate)
    yaw_rate4 = fma(h, yaw_acc3, yaw_rate)
    pitch_acc4, wheel_acc4, yaw_acc4 = moved_rolling(pitch4, pitch_rate4, wheel_rate4, yaw_rate4, held_pitch, held_wheel, held_yaw, t14, half_track, motor_damping, centrifugal, weight, coulomb_torque, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, yaw_coulomb_torque, rolling_torque, yaw_rolling_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared)
    sixth = 1 / 6 * h
    new_pitch, new_pitch_rate = ended(h, sixth, pitch, pitch_rate, pitch_acc1, pitch_acc2, pitch_acc3, pitch_acc4)
    new_wheel, new_wheel_rate = ended(h, sixth, wheel, wheel_rate, wheel_acc1, wheel_acc2, wheel_acc3, wheel_acc4)
    new_yaw, new_yaw_rate = ended(h, sixth, yaw, yaw_rate, yaw_acc1, yaw_acc2, yaw_acc3, yaw_acc4)
    return new_pitch, new_pitch_rate, new_wheel, new_wheel_rate, new_yaw, new_yaw_rate



def step_rolling(w, count, fallen, now):
    i = 0
    pitch, pitch_rate, wheel, wheel_rate, yaw, yaw_rate, h, lived, left, right, force, moment = get(w, 0, i), get(w, 1, i), get(w, 2, i), get(w, 3, i), get(w, 4, i), get(w, 5, i), get(w, 6, i), get(w, 7, i), get(w, 8, i), get(w, 9, i), get(w, 10, i), get(w, 11, i)
    new_pitch, new_pitch_rate, new_wheel, new_wheel_rate, new_yaw, new_yaw_rate = rk4_rolling(pitch, pitch_rate, wheel, wheel_rate, yaw, yaw_rate, h, left, right, force, moment, *constants_rolling(w, i))
    put(w, 0, i, new_pitch)
    put(w, 1, i, new_pitch_rate)
    put(w, 2, i, new_wheel)
    put(w, 3, i, new_wheel_rate)
    put(w, 4, i, new_yaw)
    put(w, 5, i, new_yaw_rate)
    put(w, 7, i, now if h > 0.0 else lived)
    put(w, 6, i, h if absolute(new_pitch) <= fallen else 0.0)



def advance_rolling(w, count, fallen, now):
    align_stack()
    for i in range(count):
        pitch, pitch_rate, wheel_rate, yaw_rate, left, right, force, moment, half_track, motor_damping, centrifugal, weight, moment_response, coulomb_torque, motor_torque, lever, rolling_damping, turning_lever, force_response, yaw_coriolis, yaw_lever, yaw_damping, yaw_coulomb_torque, rolling_torque, yaw_rolling_torque, yaw_motor_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared = get(w, 0, i), get(w, 1, i), get(w, 3, i), get(w, 5, i), get(w, 8, i), get(w, 9, i), get(w, 10, i), get(w, 11, i), get(w, 14, i), get(w, 17, i), get(w, 18, i), get(w, 19, i), get(w, 20, i), get(w, 21, i), get(w, 22, i), get(w, 23, i), get(w, 24, i), get(w, 25, i), get(w, 27, i), get(w, 28, i), get(w, 29, i), get(w, 30, i), get(w, 32, i), get(w, 33, i), get(w, 34, i), get(w, 35, i), get(w, 36, i), get(w, 37, i), get(w, 38, i), get(w, 39, i)
        held_pitch, held_wheel, held_yaw, t14 = held_rolling(left, right, force, moment, moment_response, motor_torque, force_response, yaw_motor_torque)
        pitch_acc1, wheel_acc1, yaw_acc1 = moved_rolling(pitch, pitch_rate, wheel_rate, yaw_rate, held_pitch, held_wheel, held_yaw, t14, half_track, motor_damping, centrifugal, weight, coulomb_torque, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, yaw_coulomb_torque, rolling_torque, yaw_rolling_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared)
        put(w, WORK + 0, i, pitch_acc1)
        put(w, WORK + 1, i, wheel_acc1)
        put(w, WORK + 2, i, yaw_acc1)
        put(w, WORK + 11, i, held_pitch)
        put(w, WORK + 12, i, held_wheel)
        put(w, WORK + 13, i, held_yaw)
        put(w, WORK + 14, i, t14)
    for i in range(count):
        pitch, pitch_rate, wheel_rate, yaw_rate, h, half_track, motor_damping, centrifugal, weight, coulomb_torque, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, yaw_coulomb_torque, rolling_torque, yaw_rolling_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared, pitch_acc1, wheel_acc1, yaw_acc1, held_pitch, held_wheel, held_yaw, t14 = get(w, 0, i), get(w, 1, i), get(w, 3, i), get(w, 5, i), get(w, 6, i), get(w, 14, i), get(w, 17, i), get(w, 18, i), get(w, 19, i), get(w, 21, i), get(w, 23, i), get(w, 24, i), get(w, 25, i), get(w, 28, i), get(w, 29, i), get(w, 30, i), get(w, 32, i), get(w, 33, i), get(w, 34, i), get(w, 36, i), get(w, 37, i), get(w, 38, i), get(w, 39, i), get(w, WORK + 0, i), get(w, WORK + 1, i), get(w, WORK + 2, i), get(w, WORK + 11, i), get(w, WORK + 12, i), get(w, WORK + 13, i), get(w, WORK + 14, i)
        half = 0.5 * h
        pitch2 = fma(half, pitch_rate, pitch)
        pitch_rate2 = fma(half, pitch_acc1, pitch_rate)
        wheel_rate2 = fma(half, wheel_acc1, wheel_rate)
        yaw_rate2 = fma(half, yaw_acc1, yaw_rate)
        pitch_acc2, wheel_acc2, yaw_acc2 = moved_rolling(pitch2, pitch_rate2, wheel_rate2, yaw_rate2, held_pitch, held_wheel, held_yaw, t14, half_track, motor_damping, centrifugal, weight, coulomb_torque, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, yaw_coulomb_torque, rolling_torque, yaw_rolling_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared)
        put(w, WORK + 3, i, pitch_acc2)
        put(w, WORK + 4, i, wheel_acc2)
        put(w, WORK + 5, i, yaw_acc2)
        put(w, WORK + 9, i, pitch_rate2)
    for i in range(count):
        pitch, pitch_rate, wheel_rate, yaw_rate, h, half_track, motor_damping, centrifugal, weight, coulomb_torque, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, yaw_coulomb_torque, rolling_torque, yaw_rolling_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared, pitch_acc2, wheel_acc2, yaw_acc2, pitch_rate2, held_pitch, held_wheel, held_yaw, t14 = get(w, 0, i), get(w, 1, i), get(w, 3, i), get(w, 5, i), get(w, 6, i), get(w, 14, i), get(w, 17, i), get(w, 18, i), get(w, 19, i), get(w, 21, i), get(w, 23, i), get(w, 24, i), get(w, 25, i), get(w, 28, i), get(w, 29, i), get(w, 30, i), get(w, 32, i), get(w, 33, i), get(w, 34, i), get(w, 36, i), get(w, 37, i), get(w, 38, i), get(w, 39, i), get(w, WORK + 3, i), get(w, WORK + 4, i), get(w, WORK + 5, i), get(w, WORK + 9, i), get(w, WORK + 11, i), get(w, WORK + 12, i), get(w, WORK + 13, i), get(w, WORK + 14, i)
        half = 0.5 * h
        pitch3 = fma(half, pitch_rate2, pitch)
        pitch_rate3 = fma(half, pitch_acc2, pitch_rate)
        wheel_rate3 = fma(half, wheel_acc2, wheel_rate)
        yaw_rate3 = fma(half, yaw_acc2, yaw_rate)
        pitch_acc3, wheel_acc3, yaw_acc3 = moved_rolling(pitch3, pitch_rate3, wheel_rate3, yaw_rate3, held_pitch, held_wheel, held_yaw, t14, half_track, motor_damping, centrifugal, weight, coulomb_torque, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, yaw_coulomb_torque, rolling_torque, yaw_rolling_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared)
        put(w, WORK + 6, i, pitch_acc3)
        put(w, WORK + 7, i, wheel_acc3)
        put(w, WORK + 8, i, yaw_acc3)
        put(w, WORK + 10, i, pitch_rate3)
    for i in range(count):
        pitch, pitch_rate, wheel, wheel_rate, yaw, yaw_rate, h, lived, half_track, motor_damping, centrifugal, weight, coulomb_torque, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, yaw_coulomb_torque, rolling_torque, yaw_rolling_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared, pitch_acc1, wheel_acc1, yaw_acc1, pitch_acc2, wheel_acc2, yaw_acc2, pitch_acc3, wheel_acc3, yaw_acc3, pitch_rate3, held_pitch, held_wheel, held_yaw, t14 = get(w, 0, i), get(w, 1, i), get(w, 2, i), get(w, 3, i), get(w, 4, i), get(w, 5, i), get(w, 6, i), get(w, 7, i), get(w, 14, i), get(w, 17, i), get(w, 18, i), get(w, 19, i), get(w, 21, i), get(w, 23, i), get(w, 24, i), get(w, 25, i), get(w, 28, i), get(w, 29, i), get(w, 30, i), get(w, 32, i), get(w, 33, i), get(w, 34, i), get(w, 36, i), get(w, 37, i), get(w, 38, i), get(w, 39, i), get(w, WORK + 0, i), get(w, WORK + 1, i), get(w, WORK + 2, i), get(w, WORK + 3, i), get(w, WORK + 4, i), get(w, WORK + 5, i), get(w, WORK + 6, i), get(w, WORK + 7, i), get(w, WORK + 8, i), get(w, WORK + 10, i), get(w, WORK + 11, i), get(w, WORK + 12, i), get(w, WORK + 13, i), get(w, WORK + 14, i)
        pitch4 = fma(h, pitch_rate3, pitch)
        pitch_rate4 = fma(h, pitch_acc3, pitch_rate)
        wheel_rate4 = fma(h, wheel_acc3, wheel_rate)
        yaw_rate4 = fma(h, yaw_acc3, yaw_rate)
        pitch_acc4, wheel_acc4, yaw_acc4 = moved_rolling(pitch4, pitch_rate4, wheel_rate4, yaw_rate4, held_pitch, held_wheel, held_yaw, t14, half_track, motor_damping, centrifugal, weight, coulomb_torque, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, yaw_coulomb_torque, rolling_torque, yaw_rolling_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared)
        sixth = 1 / 6 * h
        new_pitch, new_pitch_rate = ended(h, sixth, pitch, pitch_rate, pitch_acc1, pitch_acc2, pitch_acc3, pitch_acc4)
        new_wheel, new_wheel_rate = ended(h, sixth, wheel, wheel_rate, wheel_acc1, wheel_acc2, wheel_acc3, wheel_acc4)
        new_yaw, new_yaw_rate = ended(h, sixth, yaw, yaw_rate, yaw_acc1, yaw_acc2, yaw_acc3, yaw_acc4)
        put(w, 0, i, new_pitch)
        put(w, 1, i, new_pitch_rate)
        put(w, 2, i, new_wheel)
        put(w, 3, i, new_wheel_rate)
        put(w, 4, i, new_yaw)
        put(w, 5, i, new_yaw_rate)
        put(w, 7, i, now if h > 0.0 else lived)
        put(w, 6, i, h if absolute(new_pitch) <= fallen else 0.0)



def specific_force_rolling(w, count, out):
    for i in range(count):
        pitch, pitch_rate, wheel_rate, yaw_rate, left, right, force, moment, half_track, wheel_radius, gravity, motor_damping, centrifugal, weight, moment_response, coulomb_torque, motor_torque, lever, rolling_damping, turning_lever, force_response, yaw_coriolis, yaw_lever, yaw_damping, yaw_coulomb_torque, rolling_torque, yaw_rolling_torque, yaw_motor_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared = get(w, 0, i), get(w, 1, i), get(w, 3, i), get(w, 5, i), get(w, 8, i), get(w, 9, i), get(w, 10, i), get(w, 11, i), get(w, 14, i), get(w, 15, i), get(w, 16, i), get(w, 17, i), get(w, 18, i), get(w, 19, i), get(w, 20, i), get(w, 21, i), get(w, 22, i), get(w, 23, i), get(w, 24, i), get(w, 25, i), get(w, 27, i), get(w, 28, i), get(w, 29, i), get(w, 30, i), get(w, 32, i), get(w, 33, i), get(w, 34, i), get(w, 35, i), get(w, 36, i), get(w, 37, i), get(w, 38, i), get(w, 39, i)
        held_pitch, held_wheel, held_yaw, t14 = held_rolling(left, right, force, moment, moment_response, motor_torque, force_response, yaw_motor_torque)
        _, wheel_acc, _ = moved_rolling(pitch, pitch_rate, wheel_rate, yaw_rate, held_pitch, held_wheel, held_yaw, t14, half_track, motor_damping, centrifugal, weight, coulomb_torque, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, yaw_coulomb_torque, rolling_torque, yaw_rolling_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared)
        s, c = sincos(pitch)
        t0 = wheel_acc * wheel_radius
        t1 = t0 * c
        t2 = fma(-gravity, s, t1)
        forward = t2
        t3 = gravity * c
        t4 = fma(t0, s, t3)
        up = t4
        put(w, out + 0, i, forward)
        put(w, out + 1, i, up)



@inlined
def held_slope(left, right, force, moment, sin_slope, cos_slope, weight, moment_response, motor_torque, slope_weight, force_response, yaw_weight, yaw_motor_torque):
    t3 = -left - right
    t4 = motor_torque * t3
    held_pitch = t4
    t5 = force_response * force
    t6 = left + right
    t7 = fma(motor_torque, t6, t5)
    held_wheel = t7
    t8 = -left + right
    t9 = yaw_motor_torque * t8
    held_yaw = t9
    t10 = weight * cos_slope
    t12 = moment_response * moment
    t13 = weight * sin_slope
    t18 = slope_weight * sin_slope
    t23 = yaw_weight * sin_slope
    return held_pitch, held_wheel, held_yaw, t10, t12, t13, t18, t23



@inlined
def moved_slope(pitch, pitch_rate, wheel_rate, yaw, yaw_rate, held_pitch, held_wheel, held_yaw, t10, t12, t13, t18, t23, motor_damping, centrifugal, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, rotor_coupling, pitch_inertia, yaw_swing):
    s, c = sincos(pitch)
    sin_yaw, cos_yaw = sincos_any(yaw)
    t0 = fma(lever, c, -rotor_coupling)
    a12 = t0
    a22 = pitch_inertia
    t1 = s * s
    t2 = fma(yaw_swing, t1, 1.0)
    a33 = t2
    determinant = fma(-a12, a12, a22)
    before_0 = determinant * a33
    over = 1.0 / before_0
    over_1 = over * determinant
    rest_1 = over * a33
    t11 = -pitch_rate + wheel_rate
    t14 = centrifugal * s
    t15 = yaw_rate * yaw_rate
    t16 = fma(t14, t15, fma(-t13, cos_yaw, t12))
    t17 = fma(c, t16, fma(motor_damping, t11, fma(t10, s, held_pitch)))
    t19 = pitch_rate * pitch_rate
    t20 = lever * t19
    t21 = fma(turning_lever, t15, t20)
    t22 = fma(t21, s, fma(-rolling_damping, wheel_rate, fma(motor_damping, pitch_rate, fma(-t18, cos_yaw, held_wheel))))
    t24 = t23 * sin_yaw
    t25 = yaw_coriolis * c
    t26 = t25 * pitch_rate
    t27 = fma(-yaw_lever, wheel_rate, -t26)
    t28 = fma(t27, yaw_rate, t24)
    t29 = fma(-yaw_damping, yaw_rate, fma(s, t28, held_yaw))
    pitch_alone = fma(-a12, t22, t17)
    pitch_acc = pitch_alone * rest_1
    wheel_acc = fma(-a12, pitch_acc, t22)
    yaw_acc = t29 * over_1
    return pitch_acc, wheel_acc, yaw_acc



@inlined
def accelerations_slope(pitch, pitch_rate, wheel_rate, yaw, yaw_rate, left, right, force, moment, sin_slope, cos_slope, motor_damping, centrifugal, weight, moment_response, motor_torque, lever, rolling_damping, turning_lever, slope_weight, force_response, yaw_coriolis, yaw_lever, yaw_damping, yaw_weight, yaw_motor_torque, rotor_coupling, pitch_inertia, yaw_swing):
    held_pitch, held_wheel, held_yaw, t10, t12, t13, t18, t23 = held_slope(left, right, force, moment, sin_slope, cos_slope, weight, moment_response, motor_torque, slope_weight, force_response, yaw_weight, yaw_motor_torque)
    return moved_slope(pitch, pitch_rate, wheel_rate, yaw, yaw_rate, held_pitch, held_wheel, held_yaw, t10, t12, t13, t18, t23, motor_damping, centrifugal, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, rotor_coupling, pitch_inertia, yaw_swing)



@inlined
def constants_slope(w, i):
    return get(w, 17, i), get(w, 18, i), get(w, 19, i), get(w, 20, i), get(w, 22, i), get(w, 23, i), get(w, 24, i), get(w, 25, i), get(w, 26, i), get(w, 27, i), get(w, 28, i), get(w, 29, i), get(w, 30, i), get(w, 31, i), get(w, 35, i), get(w, 36, i), get(w, 37, i), get(w, 38, i)



@inlined
def rk4_slope(pitch, pitch_rate, wheel, wheel_rate, yaw, yaw_rate, h, left, right, force, moment, sin_slope, cos_slope, motor_damping, centrifugal, weight, moment_response, motor_torque, lever, rolling_damping, turning_lever, slope_weight, force_response, yaw_coriolis, yaw_lever, yaw_damping, yaw_weight, yaw_motor_torque, rotor_coupling, pitch_inertia, yaw_swing):
    held_pitch, held_wheel, held_yaw, t10, t12, t13, t18, t23 = held_slope(left, right, force, moment, sin_slope, cos_slope, weight, moment_response, motor_torque, slope_weight, force_response, yaw_weight, yaw_motor_torque)
    pitch_acc1, wheel_acc1, yaw_acc1 = moved_slope(pitch, pitch_rate, wheel_rate, yaw, yaw_rate, held_pitch, held_wheel, held_yaw, t10, t12, t13, t18, t23, motor_damping, centrifugal, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, rotor_coupling, pitch_inertia, yaw_swing)
    half = 0.5 * h
    pitch2 = fma(half, pitch_rate, pitch)
    pitch_rate2 = fma(half, pitch_acc1, pitch_rate)
    wheel_rate2 = fma(half, wheel_acc1, wheel_rate)
    yaw2 = fma(half, yaw_rate, yaw)
    yaw_rate2 = fma(half, yaw_acc1, yaw_rate)
    pitch_acc2, wheel_acc2, yaw_acc2 = moved_slope(pitch2, pitch_rate2, wheel_rate2, yaw2, yaw_rate2, held_pitch, held_wheel, held_yaw, t10, t12, t13, t18, t23, motor_damping, centrifugal, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, rotor_coupling, pitch_inertia, yaw_swing)
    pitch3 = fma(half, pitch_rate2, pitch)
    pitch_rate3 = fma(half, pitch_acc2, pitch_rate)
    wheel_rate3 = fma(half, wheel_acc2, wheel_rate)
    yaw3 = fma(half, yaw_rate2, yaw)
    yaw_rate3 = fma(half, yaw_acc2, yaw_rate)
    pitch_acc3, wheel_acc3, yaw_acc3 = moved_slope(pitch3, pitch_rate3, wheel_rate3, yaw3, yaw_rate3, held_pitch, held_wheel, held_yaw, t10, t12, t13, t18, t23, motor_damping, centrifugal, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, rotor_coupling, pitch_inertia, yaw_swing)
    pitch4 = fma(h, pitch_rate3, pitch)
    pitch_rate4 = fma(h, pitch_acc3, pitch_rate)
    wheel_rate4 = fma(h, wheel_acc3, wheel_rate)
    yaw4 = fma(h, yaw_rate3, yaw)
    yaw_rate4 = fma(h, yaw_acc3, yaw_rate)
    pitch_acc4, wheel_acc4, yaw_acc4 = moved_slope(pitch4, pitch_rate4, wheel_rate4, yaw4, yaw_rate4, held_pitch, held_wheel, held_yaw, t10, t12, t13, t18, t23, motor_damping, centrifugal, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, rotor_coupling, pitch_inertia, yaw_swing)
    sixth = 1 / 6 * h
    new_pitch, new_pitch_rate = ended(h, sixth, pitch, pitch_rate, pitch_acc1, pitch_acc2, pitch_acc3, pitch_acc4)
    new_wheel, new_wheel_rate = ended(h, sixth, wheel, wheel_rate, wheel_acc1, wheel_acc2, wheel_acc3, wheel_acc4)
    new_yaw, new_yaw_rate = ended(h, sixth, yaw, yaw_rate, yaw_acc1, yaw_acc2, yaw_acc3, yaw_acc4)
    return new_pitch, new_pitch_rate, new_wheel, new_wheel_rate, new_yaw, new_yaw_rate



def step_slope(w, count, fallen, now):
    i = 0
    pitch, pitch_rate, wheel, wheel_rate, yaw, yaw_rate, h, lived, left, right, force, moment, sin_slope, cos_slope = get(w, 0, i), get(w, 1, i), get(w, 2, i), get(w, 3, i), get(w, 4, i), get(w, 5, i), get(w, 6, i), get(w, 7, i), get(w, 8, i), get(w, 9, i), get(w, 10, i), get(w, 11, i), get(w, 12, i), get(w, 13, i)
    new_pitch, new_pitch_rate, new_wheel, new_wheel_rate, new_yaw, new_yaw_rate = rk4_slope(pitch, pitch_rate, wheel, wheel_rate, yaw, yaw_rate, h, left, right, force, moment, sin_slope, cos_slope, *constants_slope(w, i))
    put(w, 0, i, new_pitch)
    put(w, 1, i, new_pitch_rate)
    put(w, 2, i, new_wheel)
    put(w, 3, i, new_wheel_rate)
    put(w, 4, i, new_yaw)
    put(w, 5, i, new_yaw_rate)
    put(w, 7, i, now if h > 0.0 else lived)
    put(w, 6, i, h if absolute(new_pitch) <= fallen else 0.0)



def advance_slope(w, count, fallen, now):
    align_stack()
    for i in range(count):
        pitch, pitch_rate, wheel_rate, yaw, yaw_rate, left, right, force, moment, sin_slope, cos_slope, motor_damping, centrifugal, weight, moment_response, motor_torque, lever, rolling_damping, turning_lever, slope_weight, force_response, yaw_coriolis, yaw_lever, yaw_damping, yaw_weight, yaw_motor_torque, rotor_coupling, pitch_inertia, yaw_swing = get(w, 0, i), get(w, 1, i), get(w, 3, i), get(w, 4, i), get(w, 5, i), get(w, 8, i), get(w, 9, i), get(w, 10, i), get(w, 11, i), get(w, 12, i), get(w, 13, i), get(w, 17, i), get(w, 18, i), get(w, 19, i), get(w, 20, i), get(w, 22, i), get(w, 23, i), get(w, 24, i), get(w, 25, i), get(w, 26, i), get(w, 27, i), get(w, 28, i), get(w, 29, i), get(w, 30, i), get(w, 31, i), get(w, 35, i), get(w, 36, i), get(w, 37, i), get(w, 38, i)
        held_pitch, held_wheel, held_yaw, t10, t12, t13, t18, t23 = held_slope(left, right, force, moment, sin_slope, cos_slope, weight, moment_response, motor_torque, slope_weight, force_response, yaw_weight, yaw_motor_torque)
        pitch_acc1, wheel_acc1, yaw_acc1 = moved_slope(pitch, pitch_rate, wheel_rate, yaw, yaw_rate, held_pitch, held_wheel, held_yaw, t10, t12, t13, t18, t23, motor_damping, centrifugal, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, rotor_coupling, pitch_inertia, yaw_swing)
        put(w, WORK + 0, i, pitch_acc1)
        put(w, WORK + 1, i, wheel_acc1)
        put(w, WORK + 2, i, yaw_acc1)
        put(w, WORK + 13, i, held_pitch)
        put(w, WORK + 14, i, held_wheel)
        put(w, WORK + 15, i, held_yaw)
        put(w, WORK + 16, i, t10)
        put(w, WORK + 17, i, t12)
        put(w, WORK + 18, i, t13)
        put(w, WORK + 19, i, t18)
        put(w, WORK + 20, i, t23)
    for i in range(count):
        pitch, pitch_rate, wheel_rate, yaw, yaw_rate, h, motor_damping, centrifugal, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, rotor_coupling, pitch_inertia, yaw_swing, pitch_acc1, wheel_acc1, yaw_acc1, held_pitch, held_wheel, held_yaw, t10, t12, t13, t18, t23 = get(w, 0, i), get(w, 1, i), get(w, 3, i), get(w, 4, i), get(w, 5, i), get(w, 6, i), get(w, 17, i), get(w, 18, i), get(w, 23, i), get(w, 24, i), get(w, 25, i), get(w, 28, i), get(w, 29, i), get(w, 30, i), get(w, 36, i), get(w, 37, i), get(w, 38, i), get(w, WORK + 0, i), get(w, WORK + 1, i), get(w, WORK + 2, i), get(w, WORK + 13, i), get(w, WORK + 14, i), get(w, WORK + 15, i), get(w, WORK + 16, i), get(w, WORK + 17, i), get(w, WORK + 18, i), get(w, WORK + 19, i), get(w, WORK + 20, i)
        half = 0.5 * h
        pitch2 = fma(half, pitch_rate, pitch)
        pitch_rate2 = fma(half, pitch_acc1, pitch_rate)
        wheel_rate2 = fma(half, wheel_acc1, wheel_rate)
        yaw2 = fma(half, yaw_rate, yaw)
        yaw_rate2 = fma(half, yaw_acc1, yaw_rate)
        pitch_acc2, wheel_acc2, yaw_acc2 = moved_slope(pitch2, pitch_rate2, wheel_rate2, yaw2, yaw_rate2, held_pitch, held_wheel, held_yaw, t10, t12, t13, t18, t23, motor_damping, centrifugal, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, rotor_coupling, pitch_inertia, yaw_swing)
        put(w, WORK + 3, i, pitch_acc2)
        put(w, WORK + 4, i, wheel_acc2)
        put(w, WORK + 5, i, yaw_acc2)
        put(w, WORK + 9, i, pitch_rate2)
        put(w, WORK + 10, i, yaw_rate2)
    for i in range(count):
        pitch, pitch_rate, wheel_rate, yaw, yaw_rate, h, motor_damping, centrifugal, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, rotor_coupling, pitch_inertia, yaw_swing, pitch_acc2, wheel_acc2, yaw_acc2, pitch_rate2, yaw_rate2, held_pitch, held_wheel, held_yaw, t10, t12, t13, t18, t23 = get(w, 0, i), get(w, 1, i), get(w, 3, i), get(w, 4, i), get(w, 5, i), get(w, 6, i), get(w, 17, i), get(w, 18, i), get(w, 23, i), get(w, 24, i), get(w, 25, i), get(w, 28, i), get(w, 29, i), get(w, 30, i), get(w, 36, i), get(w, 37, i), get(w, 38, i), get(w, WORK + 3, i), get(w, WORK + 4, i), get(w, WORK + 5, i), get(w, WORK + 9, i), get(w, WORK + 10, i), get(w, WORK + 13, i), get(w, WORK + 14, i), get(w, WORK + 15, i), get(w, WORK + 16, i), get(w, WORK + 17, i), get(w, WORK + 18, i), get(w, WORK + 19, i), get(w, WORK + 20, i)
        half = 0.5 * h
        pitch3 = fma(half, pitch_rate2, pitch)
        pitch_rate3 = fma(half, pitch_acc2, pitch_rate)
        wheel_rate3 = fma(half, wheel_acc2, wheel_rate)
        yaw3 = fma(half, yaw_rate2, yaw)
        yaw_rate3 = fma(half, yaw_acc2, yaw_rate)
        pitch_acc3, wheel_acc3, yaw_acc3 = moved_slope(pitch3, pitch_rate3, wheel_rate3, yaw3, yaw_rate3, held_pitch, held_wheel, held_yaw, t10, t12, t13, t18, t23, motor_damping, centrifugal, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, rotor_coupling, pitch_inertia, yaw_swing)
        put(w, WORK + 6, i, pitch_acc3)
        put(w, WORK + 7, i, wheel_acc3)
        put(w, WORK + 8, i, yaw_acc3)
        put(w, WORK + 11, i, pitch_rate3)
        put(w, WORK + 12, i, yaw_rate3)
    for i in range(count):
        pitch, pitch_rate, wheel, wheel_rate, yaw, yaw_rate, h, lived, motor_damping, centrifugal, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, rotor_coupling, pitch_inertia, yaw_swing, pitch_acc1, wheel_acc1, yaw_acc1, pitch_acc2, wheel_acc2, yaw_acc2, pitch_acc3, wheel_acc3, yaw_acc3, pitch_rate3, yaw_rate3, held_pitch, held_wheel, held_yaw, t10, t12, t13, t18, t23 = get(w, 0, i), get(w, 1, i), get(w, 2, i), get(w, 3, i), get(w, 4, i), get(w, 5, i), get(w, 6, i), get(w, 7, i), get(w, 17, i), get(w, 18, i), get(w, 23, i), get(w, 24, i), get(w, 25, i), get(w, 28, i), get(w, 29, i), get(w, 30, i), get(w, 36, i), get(w, 37, i), get(w, 38, i), get(w, WORK + 0, i), get(w, WORK + 1, i), get(w, WORK + 2, i), get(w, WORK + 3, i), get(w, WORK + 4, i), get(w, WORK + 5, i), get(w, WORK + 6, i), get(w, WORK + 7, i), get(w, WORK + 8, i), get(w, WORK + 11, i), get(w, WORK + 12, i), get(w, WORK + 13, i), get(w, WORK + 14, i), get(w, WORK + 15, i), get(w, WORK + 16, i), get(w, WORK + 17, i), get(w, WORK + 18, i), get(w, WORK + 19, i), get(w, WORK + 20, i)
        pitch4 = fma(h, pitch_rate3, pitch)
        pitch_rate4 = fma(h, pitch_acc3, pitch_rate)
        wheel_rate4 = fma(h, wheel_acc3, wheel_rate)
        yaw4 = fma(h, yaw_rate3, yaw)
        yaw_rate4 = fma(h, yaw_acc3, yaw_rate)
        pitch_acc4, wheel_acc4, yaw_acc4 = moved_slope(pitch4, pitch_rate4, wheel_rate4, yaw4, yaw_rate4, held_pitch, held_wheel, held_yaw, t10, t12, t13, t18, t23, motor_damping, centrifugal, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, rotor_coupling, pitch_inertia, yaw_swing)
        sixth = 1 / 6 * h
        new_pitch, new_pitch_rate = ended(h, sixth, pitch, pitch_rate, pitch_acc1, pitch_acc2, pitch_acc3, pitch_acc4)
        new_wheel, new_wheel_rate = ended(h, sixth, wheel, wheel_rate, wheel_acc1, wheel_acc2, wheel_acc3, wheel_acc4)
        new_yaw, new_yaw_rate = ended(h, sixth, yaw, yaw_rate, yaw_acc1, yaw_acc2, yaw_acc3, yaw_acc4)
        put(w, 0, i, new_pitch)
        put(w, 1, i, new_pitch_rate)
        put(w, 2, i, new_wheel)
        put(w, 3, i, new_wheel_rate)
        put(w, 4, i, new_yaw)
        put(w, 5, i, new_yaw_rate)
        put(w, 7, i, now if h > 0.0 else lived)
        put(w, 6, i, h if absolute(new_pitch) <= fallen else 0.0)



def specific_force_slope(w, count, out):
    for i in range(count):
        pitch, pitch_rate, wheel_rate, yaw, yaw_rate, left, right, force, moment, sin_slope, cos_slope, wheel_radius, gravity, motor_damping, centrifugal, weight, moment_response, motor_torque, lever, rolling_damping, turning_lever, slope_weight, force_response, yaw_coriolis, yaw_lever, yaw_damping, yaw_weight, yaw_motor_torque, rotor_coupling, pitch_inertia, yaw_swing = get(w, 0, i), get(w, 1, i), get(w, 3, i), get(w, 4, i), get(w, 5, i), get(w, 8, i), get(w, 9, i), get(w, 10, i), get(w, 11, i), get(w, 12, i), get(w, 13, i), get(w, 15, i), get(w, 16, i), get(w, 17, i), get(w, 18, i), get(w, 19, i), get(w, 20, i), get(w, 22, i), get(w, 23, i), get(w, 24, i), get(w, 25, i), get(w, 26, i), get(w, 27, i), get(w, 28, i), get(w, 29, i), get(w, 30, i), get(w, 31, i), get(w, 35, i), get(w, 36, i), get(w, 37, i), get(w, 38, i)
        held_pitch, held_wheel, held_yaw, t10, t12, t13, t18, t23 = held_slope(left, right, force, moment, sin_slope, cos_slope, weight, moment_response, motor_torque, slope_weight, force_response, yaw_weight, yaw_motor_torque)
        _, wheel_acc, _ = moved_slope(pitch, pitch_rate, wheel_rate, yaw, yaw_rate, held_pitch, held_wheel, held_yaw, t10, t12, t13, t18, t23, motor_damping, centrifugal, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, rotor_coupling, pitch_inertia, yaw_swing)
        s, c = sincos(pitch)
        sin_yaw, cos_yaw = sincos_any(yaw)
        t0 = wheel_acc * wheel_radius
        t1 = gravity * sin_slope
        t2 = fma(t1, cos_yaw, t0)
        t3 = c * t2
        t4 = gravity * cos_slope
        t5 = fma(-t4, s, t3)
        forward = t5
        t6 = t4 * c
        t7 = fma(t2, s, t6)
        up = t7
        put(w, out + 0, i, forward)
        put(w, out + 1, i, up)



@inlined
def held_coulomb_slope(left, right, force, moment, sin_slope, cos_slope, weight, moment_response, motor_torque, slope_weight, force_response, yaw_weight, yaw_motor_torque):
    t5 = -left - right
    t6 = motor_torque * t5
    held_pitch = t6
    t7 = force_response * force
    t8 = left + right
    t9 = fma(motor_torque, t8, t7)
    held_wheel = t9
    t10 = -left + right
    t11 = yaw_motor_torque * t10
    held_yaw = t11
    t12 = weight * cos_slope
    t15 = moment_response * moment
    t16 = weight * sin_slope
    t21 = slope_weight * sin_slope
    t28 = yaw_weight * sin_slope
    return held_pitch, held_wheel, held_yaw, t12, t15, t16, t21, t28



@inlined
def moved_coulomb_slope(pitch, pitch_rate, wheel_rate, yaw, yaw_rate, held_pitch, held_wheel, held_yaw, t12, t15, t16, t21, t28, half_track, motor_damping, centrifugal, coulomb_torque, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, yaw_coulomb_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared):
    s, c = sincos(pitch)
    sin_yaw, cos_yaw = sincos_any(yaw)
    t0 = fma(lever, c, -rotor_coupling)
    a12 = t0
    a22 = pitch_inertia
    t1 = s * s
    t2 = fma(yaw_swing, t1, 1.0)
    a33 = t2
    determinant = fma(-a12, a12, a22)
    t3 = fma(-half_track, yaw_rate, -pitch_rate + wheel_rate)
    rate_slip_left = t3
    square_slip_left = fma(rate_slip_left, rate_slip_left, stiction_rate_squared)
    root_slip_left = sqrt(square_slip_left)
    t4 = fma(half_track, yaw_rate, -pitch_rate + wheel_rate)
    rate_slip_right = t4
    square_slip_right = fma(rate_slip_right, rate_slip_right, stiction_rate_squared)
    root_slip_right = sqrt(square_slip_right)
    before_0 = determinant * a33
    before_1 = before_0 * root_slip_left
    before_2 = before_1 * root_slip_right
    over = 1.0 / before_2
    over_3 = over * before_1
    rest_3 = over * root_slip_right
    over_2 = rest_3 * before_0
    rest_2 = rest_3 * root_slip_left
    over_1 = rest_2 * determinant
    rest_1 = rest_2 * a33
    slip_left = rate_slip_left * over_2
    slip_right = rate_slip_right * over_3
    t13 = slip_left + slip_right
    t14 = -pitch_rate + wheel_rate
    t17 = centrifugal * s
    t18 = yaw_rate * yaw_rate
    t19 = fma(t17, t18, fma(-t16, cos_yaw, t15))
    t20 = fma(c, t19, fma(motor_damping, t14, fma(coulomb_torque, t13, fma(t12, s, held_pitch))))
    t22 = -slip_left - slip_right
    t23 = pitch_rate * pitch_rate
    t24 = lever * t23
    t25 = fma(turning_lever, t18, t24)
    t26 = fma(t25, s, fma(-rolling_damping, wheel_rate, fma(coulomb_torque, t22, fma(motor_damping, pitch_rate, fma(-t21, cos_yaw, held_wheel)))))
    t27 = slip_left - slip_right
    t29 = t28 * sin_yaw
    t30 = yaw_coriolis * c
    t31 = t30 * pitch_rate
    t32 = fma(-yaw_lever, wheel_rate, -t31)
    t33 = fma(t32, yaw_rate, t29)
    t34 = fma(-yaw_damping, yaw_rate, fma(s, t33, fma(yaw_coulomb_torque, t27, held_yaw)))
    pitch_alone = fma(-a12, t26, t20)
    pitch_acc = pitch_alone * rest_1
    wheel_acc = fma(-a12, pitch_acc, t26)
    yaw_acc = t34 * over_1
    return pitch_acc, wheel_acc, yaw_acc



@inlined
def accelerations_coulomb_slope(pitch, pitch_rate, wheel_rate, yaw, yaw_rate, left, right, force, moment, sin_slope, cos_slope, half_track, motor_damping, centrifugal, weight, moment_response, coulomb_torque, motor_torque, lever, rolling_damping, turning_lever, slope_weight, force_response, yaw_coriolis, yaw_lever, yaw_damping, yaw_weight, yaw_coulomb_torque, yaw_motor_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared):
    held_pitch, held_wheel, held_yaw, t12, t15, t16, t21, t28 = held_coulomb_slope(left, right, force, moment, sin_slope, cos_slope, weight, moment_response, motor_torque, slope_weight, force_response, yaw_weight, yaw_motor_torque)
    return moved_coulomb_slope(pitch, pitch_rate, wheel_rate, yaw, yaw_rate, held_pitch, held_wheel, held_yaw, t12, t15, t16, t21, t28, half_track, motor_damping, centrifugal, coulomb_torque, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, yaw_coulomb_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared)



@inlined
def constants_coulomb_slope(w, i):
    return get(w, 14, i), get(w, 17, i), get(w, 18, i), get(w, 19, i), get(w, 20, i), get(w, 21, i), get(w, 22, i), get(w, 23, i), get(w, 24, i), get(w, 25, i), get(w, 26, i), get(w, 27, i), get(w, 28, i), get(w, 29, i), get(w, 30, i), get(w, 31, i), get(w, 32, i), get(w, 35, i), get(w, 36, i), get(w, 37, i), get(w, 38, i), get(w, 39, i)



@inlined
def rk4_coulomb_slope(pitch, pitch_rate, wheel, wheel_rate, yaw, yaw_rate, h, left, right, force, moment, sin_slope, cos_slope, half_track, motor_damping, centrifugal, weight, moment_response, coulomb_torque, motor_torque, lever, rolling_damping, turning_lever, slope_weight, force_response, yaw_coriolis, yaw_lever, yaw_damping, yaw_weight, yaw_coulomb_torque, yaw_motor_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared):
    held_pitch, held_wheel, held_yaw, t12, t15, t16, t21, t28 = held_coulomb_slope(left, right, force, moment, sin_slope, cos_slope, weight, moment_response, motor_torque, slope_weight, force_response, yaw_weight, yaw_motor_torque)
    pitch_acc1, wheel_acc1, yaw_acc1 = moved_coulomb_slope(pitch, pitch_rate, wheel_rate, yaw, yaw_rate, held_pitch, held_wheel, held_yaw, t12, t15, t16, t21, t28, half_track, motor_damping, centrifugal, coulomb_torque, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, yaw_coulomb_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared)
    half = 0.5 * h
    pitch2 = fma(half, pitch_rate, pitch)
    pitch_rate2 = fma(half, pitch_acc1, pitch_rate)
    wheel_rate2 = fma(half, wheel_acc1, wheel_rate)
    yaw2 = fma(half, yaw_rate, yaw)
    yaw_rate2 = fma(half, yaw_acc1, yaw_rate)
    pitch_acc2, wheel_acc2, yaw_acc2 = moved_coulomb_slope(pitch2, pitch_rate2, wheel_rate2, yaw2, yaw_rate2, held_pitch, held_wheel, held_yaw, t12, t15, t16, t21, t28, half_track, motor_damping, centrifugal, coulomb_torque, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, yaw_coulomb_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared)
    pitch3 = fma(half, pitch_rate2, pitch)
    pitch_rate3 = fma(half, pitch_acc2, pitch_rate)
    wheel_rate3 = fma(half, wheel_acc2, wheel_rate)
    yaw3 = fma(half, yaw_rate2, yaw)
    yaw_rate3 = fma(half, yaw_acc2, yaw_rate)
    pitch_acc3, wheel_acc3, yaw_acc3 = moved_coulomb_slope(pitch3, pitch_rate3, wheel_rate3, yaw3, yaw_rate3, held_pitch, held_wheel, held_yaw, t12, t15, t16, t21, t28, half_track, motor_damping, centrifugal, coulomb_torque, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, yaw_coulomb_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared)
    pitch4 = fma(h, pitch_rate3, pitch)
    pitch_rate4 = fma(h, pitch_acc3, pitch_rate)
    wheel_rate4 = fma(h, wheel_acc3, wheel_rate)
    yaw4 = fma(h, yaw_rate3, yaw)
    yaw_rate4 = fma(h, yaw_acc3, yaw_rate)
    pitch_acc4, wheel_acc4, yaw_acc4 = moved_coulomb_slope(pitch4, pitch_rate4, wheel_rate4, yaw4, yaw_rate4, held_pitch, held_wheel, held_yaw, t12, t15, t16, t21, t28, half_track, motor_damping, centrifugal, coulomb_torque, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, yaw_coulomb_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared)
    sixth = 1 / 6 * h
    new_pitch, new_pitch_rate = ended(h, sixth, pitch, pitch_rate, pitch_acc1, pitch_acc2, pitch_acc3, pitch_acc4)
    new_wheel, new_wheel_rate = ended(h, sixth, wheel, wheel_rate, wheel_acc1, wheel_acc2, wheel_acc3, wheel_acc4)
    new_yaw, new_yaw_rate = ended(h, sixth, yaw, yaw_rate, yaw_acc1, yaw_acc2, yaw_acc3, yaw_acc4)
    return new_pitch, new_pitch_rate, new_wheel, new_wheel_rate, new_yaw, new_yaw_rate



def step_coulomb_slope(w, count, fallen, now):
    i = 0
    pitch, pitch_rate, wheel, wheel_rate, yaw, yaw_rate, h, lived, left, right, force, moment, sin_slope, cos_slope = get(w, 0, i), get(w, 1, i), get(w, 2, i), get(w, 3, i), get(w, 4, i), get(w, 5, i), get(w, 6, i), get(w, 7, i), get(w, 8, i), get(w, 9, i), get(w, 10, i), get(w, 11, i), get(w, 12, i), get(w, 13, i)
    new_pitch, new_pitch_rate, new_wheel, new_wheel_rate, new_yaw, new_yaw_rate = rk4_coulomb_slope(pitch, pitch_rate, wheel, wheel_rate, yaw, yaw_rate, h, left, right, force, moment, sin_slope, cos_slope, *constants_coulomb_slope(w, i))
    put(w, 0, i, new_pitch)
    put(w, 1, i, new_pitch_rate)
    put(w, 2, i, new_wheel)
    put(w, 3, i, new_wheel_rate)
    put(w, 4, i, new_yaw)
    put(w, 5, i, new_yaw_rate)
    put(w, 7, i, now if h > 0.0 else lived)
    put(w, 6, i, h if absolute(new_pitch) <= fallen else 0.0)



def advance_coulomb_slope(w, count, fallen, now):
    align_stack()
    for i in range(count):
        pitch, pitch_rate, wheel_rate, yaw, yaw_rate, left, right, force, moment, sin_slope, cos_slope, half_track, motor_damping, centrifugal, weight, moment_response, coulomb_torque, motor_torque, lever, rolling_damping, turning_lever, slope_weight, force_response, yaw_coriolis, yaw_lever, yaw_damping, yaw_weight, yaw_coulomb_torque, yaw_motor_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared = get(w, 0, i), get(w, 1, i), get(w, 3, i), get(w, 4, i), get(w, 5, i), get(w, 8, i), get(w, 9, i), get(w, 10, i), get(w, 11, i), get(w, 12, i), get(w, 13, i), get(w, 14, i), get(w, 17, i), get(w, 18, i), get(w, 19, i), get(w, 20, i), get(w, 21, i), get(w, 22, i), get(w, 23, i), get(w, 24, i), get(w, 25, i), get(w, 26, i), get(w, 27, i), get(w, 28, i), get(w, 29, i), get(w, 30, i), get(w, 31, i), get(w, 32, i), get(w, 35, i), get(w, 36, i), get(w, 37, i), get(w, 38, i), get(w, 39, i)
        held_pitch, held_wheel, held_yaw, t12, t15, t16, t21, t28 = held_coulomb_slope(left, right, force, moment, sin_slope, cos_slope, weight, moment_response, motor_torque, slope_weight, force_response, yaw_weight, yaw_motor_torque)
        pitch_acc1, wheel_acc1, yaw_acc1 = moved_coulomb_slope(pitch, pitch_rate, wheel_rate, yaw, yaw_rate, held_pitch, held_wheel, held_yaw, t12, t15, t16, t21, t28, half_track, motor_damping, centrifugal, coulomb_torque, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, yaw_coulomb_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared)
        put(w, WORK + 0, i, pitch_acc1)
        put(w, WORK + 1, i, wheel_acc1)
        put(w, WORK + 2, i, yaw_acc1)
        put(w, WORK + 13, i, held_pitch)
        put(w, WORK + 14, i, held_wheel)
        put(w, WORK + 15, i, held_yaw)
        put(w, WORK + 16, i, t12)
        put(w, WORK + 17, i, t15)
        put(w, WORK + 18, i, t16)
        put(w, WORK + 19, i, t21)
        put(w, WORK + 20, i, t28)
    for i in range(count):
        pitch, pitch_rate, wheel_rate, yaw, yaw_rate, h, half_track, motor_damping, centrifugal, coulomb_torque, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, yaw_coulomb_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared, pitch_acc1, wheel_acc1, yaw_acc1, held_pitch, held_wheel, held_yaw, t12, t15, t16, t21, t28 = get(w, 0, i), get(w, 1, i), get(w, 3, i), get(w, 4, i), get(w, 5, i), get(w, 6, i), get(w, 14, i), get(w, 17, i), get(w, 18, i), get(w, 21, i), get(w, 23, i), get(w, 24, i), get(w, 25, i), get(w, 28, i), get(w, 29, i), get(w, 30, i), get(w, 32, i), get(w, 36, i), get(w, 37, i), get(w, 38, i), get(w, 39, i), get(w, WORK + 0, i), get(w, WORK + 1, i), get(w, WORK + 2, i), get(w, WORK + 13, i), get(w, WORK + 14, i), get(w, WORK + 15, i), get(w, WORK + 16, i), get(w, WORK + 17, i), get(w, WORK + 18, i), get(w, WORK + 19, i), get(w, WORK + 20, i)
        half = 0.5 * h
        pitch2 = fma(half, pitch_rate, pitch)
        pitch_rate2 = fma(half, pitch_acc1, pitch_rate)
        wheel_rate2 = fma(half, wheel_acc1, wheel_rate)
        yaw2 = fma(half, yaw_rate, yaw)
        yaw_rate2 = fma(half, yaw_acc1, yaw_rate)
        pitch_acc2, wheel_acc2, yaw_acc2 = moved_coulomb_slope(pitch2, pitch_rate2, wheel_rate2, yaw2, yaw_rate2, held_pitch, held_wheel, held_yaw, t12, t15, t16, t21, t28, half_track, motor_damping, centrifugal, coulomb_torque, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, yaw_coulomb_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared)
        put(w, WORK + 3, i, pitch_acc2)
        put(w, WORK + 4, i, wheel_acc2)
        put(w, WORK + 5, i, yaw_acc2)
        put(w, WORK + 9, i, pitch_rate2)
        put(w, WORK + 10, i, yaw_rate2)
    for i in range(count):
        pitch, pitch_rate, wheel_rate, yaw, yaw_rate, h, half_track, motor_damping, centrifugal, coulomb_torque, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, yaw_coulomb_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared, pitch_acc2, wheel_acc2, yaw_acc2, pitch_rate2, yaw_rate2, held_pitch, held_wheel, held_yaw, t12, t15, t16, t21, t28 = get(w, 0, i), get(w, 1, i), get(w, 3, i), get(w, 4, i), get(w, 5, i), get(w, 6, i), get(w, 14, i), get(w, 17, i), get(w, 18, i), get(w, 21, i), get(w, 23, i), get(w, 24, i), get(w, 25, i), get(w, 28, i), get(w, 29, i), get(w, 30, i), get(w, 32, i), get(w, 36, i), get(w, 37, i), get(w, 38, i), get(w, 39, i), get(w, WORK + 3, i), get(w, WORK + 4, i), get(w, WORK + 5, i), get(w, WORK + 9, i), get(w, WORK + 10, i), get(w, WORK + 13, i), get(w, WORK + 14, i), get(w, WORK + 15, i), get(w, WORK + 16, i), get(w, WORK + 17, i), get(w, WORK + 18, i), get(w, WORK + 19, i), get(w, WORK + 20, i)
        half = 0.5 * h
        pitch3 = fma(half, pitch_rate2, pitch)
        pitch_rate3 = fma(half, pitch_acc2, pitch_rate)
        wheel_rate3 = fma(half, wheel_acc2, wheel_rate)
        yaw3 = fma(half, yaw_rate2, yaw)
        yaw_rate3 = fma(half, yaw_acc2, yaw_rate)
        pitch_acc3, wheel_acc3, yaw_acc3 = moved_coulomb_slope(pitch3, pitch_rate3, wheel_rate3, yaw3, yaw_rate3, held_pitch, held_wheel, held_yaw, t12, t15, t16, t21, t28, half_track, motor_damping, centrifugal, coulomb_torque, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, yaw_coulomb_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared)
        put(w, WORK + 6, i, pitch_acc3)
        put(w, WORK + 7, i, wheel_acc3)
        put(w, WORK + 8, i, yaw_acc3)
        put(w, WORK + 11, i, pitch_rate3)
        put(w, WORK + 12, i, yaw_rate3)
    for i in range(count):
        pitch, pitch_rate, wheel, wheel_rate, yaw, yaw_rate, h, lived, half_track, motor_damping, centrifugal, coulomb_torque, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, yaw_coulomb_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared, pitch_acc1, wheel_acc1, yaw_acc1, pitch_acc2, wheel_acc2, yaw_acc2, pitch_acc3, wheel_acc3, yaw_acc3, pitch_rate3, yaw_rate3, held_pitch, held_wheel, held_yaw, t12, t15, t16, t21, t28 = get(w, 0, i), get(w, 1, i), get(w, 2, i), get(w, 3, i), get(w, 4, i), get(w, 5, i), get(w, 6, i), get(w, 7, i), get(w, 14, i), get(w, 17, i), get(w, 18, i), get(w, 21, i), get(w, 23, i), get(w, 24, i), get(w, 25, i), get(w, 28, i), get(w, 29, i), get(w, 30, i), get(w, 32, i), get(w, 36, i), get(w, 37, i), get(w, 38, i), get(w, 39, i), get(w, WORK + 0, i), get(w, WORK + 1, i), get(w, WORK + 2, i), get(w, WORK + 3, i), get(w, WORK + 4, i), get(w, WORK + 5, i), get(w, WORK + 6, i), get(w, WORK + 7, i), get(w, WORK + 8, i), get(w, WORK + 11, i), get(w, WORK + 12, i), get(w, WORK + 13, i), get(w, WORK + 14, i), get(w, WORK + 15, i), get(w, WORK + 16, i), get(w, WORK + 17, i), get(w, WORK + 18, i), get(w, WORK + 19, i), get(w, WORK + 20, i)
        pitch4 = fma(h, pitch_rate3, pitch)
        pitch_rate4 = fma(h, pitch_acc3, pitch_rate)
        wheel_rate4 = fma(h, wheel_acc3, wheel_rate)
        yaw4 = fma(h, yaw_rate3, yaw)
        yaw_rate4 = fma(h, yaw_acc3, yaw_rate)
        pitch_acc4, wheel_acc4, yaw_acc4 = moved_coulomb_slope(pitch4, pitch_rate4, wheel_rate4, yaw4, yaw_rate4, held_pitch, held_wheel, held_yaw, t12, t15, t16, t21, t28, half_track, motor_damping, centrifugal, coulomb_torque, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, yaw_coulomb_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared)
        sixth = 1 / 6 * h
        new_pitch, new_pitch_rate = ended(h, sixth, pitch, pitch_rate, pitch_acc1, pitch_acc2, pitch_acc3, pitch_acc4)
        new_wheel, new_wheel_rate = ended(h, sixth, wheel, wheel_rate, wheel_acc1, wheel_acc2, wheel_acc3, wheel_acc4)
        new_yaw, new_yaw_rate = ended(h, sixth, yaw, yaw_rate, yaw_acc1, yaw_acc2, yaw_acc3, yaw_acc4)
        put(w, 0, i, new_pitch)
        put(w, 1, i, new_pitch_rate)
        put(w, 2, i, new_wheel)
        put(w, 3, i, new_wheel_rate)
        put(w, 4, i, new_yaw)
        put(w, 5, i, new_yaw_rate)
        put(w, 7, i, now if h > 0.0 else lived)
        put(w, 6, i, h if absolute(new_pitch) <= fallen else 0.0)



def specific_force_coulomb_slope(w, count, out):
    for i in range(count):
        pitch, pitch_rate, wheel_rate, yaw, yaw_rate, left, right, force, moment, sin_slope, cos_slope, half_track, wheel_radius, gravity, motor_damping, centrifugal, weight, moment_response, coulomb_torque, motor_torque, lever, rolling_damping, turning_lever, slope_weight, force_response, yaw_coriolis, yaw_lever, yaw_damping, yaw_weight, yaw_coulomb_torque, yaw_motor_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared = get(w, 0, i), get(w, 1, i), get(w, 3, i), get(w, 4, i), get(w, 5, i), get(w, 8, i), get(w, 9, i), get(w, 10, i), get(w, 11, i), get(w, 12, i), get(w, 13, i), get(w, 14, i), get(w, 15, i), get(w, 16, i), get(w, 17, i), get(w, 18, i), get(w, 19, i), get(w, 20, i), get(w, 21, i), get(w, 22, i), get(w, 23, i), get(w, 24, i), get(w, 25, i), get(w, 26, i), get(w, 27, i), get(w, 28, i), get(w, 29, i), get(w, 30, i), get(w, 31, i), get(w, 32, i), get(w, 35, i), get(w, 36, i), get(w, 37, i), get(w, 38, i), get(w, 39, i)
        held_pitch, held_wheel, held_yaw, t12, t15, t16, t21, t28 = held_coulomb_slope(left, right, force, moment, sin_slope, cos_slope, weight, moment_response, motor_torque, slope_weight, force_response, yaw_weight, yaw_motor_torque)
        _, wheel_acc, _ = moved_coulomb_slope(pitch, pitch_rate, wheel_rate, yaw, yaw_rate, held_pitch, held_wheel, held_yaw, t12, t15, t16, t21, t28, half_track, motor_damping, centrifugal, coulomb_torque, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, yaw_coulomb_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared)
        s, c = sincos(pitch)
        sin_yaw, cos_yaw = sincos_any(yaw)
        t0 = wheel_acc * wheel_radius
        t1 = gravity * sin_slope
        t2 = fma(t1, cos_yaw, t0)
        t3 = c * t2
        t4 = gravity * cos_slope
        t5 = fma(-t4, s, t3)
        forward = t5
        t6 = t4 * c
        t7 = fma(t2, s, t6)
        up = t7
        put(w, out + 0, i, forward)
        put(w, out + 1, i, up)



@inlined
def held_rolling_slope(left, right, force, moment, sin_slope, cos_slope, weight, moment_response, motor_torque, slope_weight, force_response, yaw_weight, yaw_motor_torque):
    t7 = -left - right
    t8 = motor_torque * t7
    held_pitch = t8
    t9 = force_response * force
    t10 = left + right
    t11 = fma(motor_torque, t10, t9)
    held_wheel = t11
    t12 = -left + right
    t13 = yaw_motor_torque * t12
    held_yaw = t13
    t14 = weight * cos_slope
    t17 = moment_response * moment
    t18 = weight * sin_slope
    t23 = slope_weight * sin_slope
    t32 = yaw_weight * sin_slope
    return held_pitch, held_wheel, held_yaw, t14, t17, t18, t23, t32



@inlined
def moved_rolling_slope(pitch, pitch_rate, wheel_rate, yaw, yaw_rate, held_pitch, held_wheel, held_yaw, t14, t17, t18, t23, t32, half_track, motor_damping, centrifugal, coulomb_torque, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, yaw_coulomb_torque, rolling_torque, yaw_rolling_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared):
    s, c = sincos(pitch)
    sin_yaw, cos_yaw = sincos_any(yaw)
    t0 = fma(lever, c, -rotor_coupling)
    a12 = t0
    a22 = pitch_inertia
    t1 = s * s
    t2 = fma(yaw_swing, t1, 1.0)
    a33 = t2
    determinant = fma(-a12, a12, a22)
    t3 = fma(-half_track, yaw_rate, -pitch_rate + wheel_rate)
    rate_slip_left = t3
    square_slip_left = fma(rate_slip_left, rate_slip_left, stiction_rate_squared)
    root_slip_left = sqrt(square_slip_left)
    t4 = fma(half_track, yaw_rate, -pitch_rate + wheel_rate)
    rate_slip_right = t4
    square_slip_right = fma(rate_slip_right, rate_slip_right, stiction_rate_squared)
    root_slip_right = sqrt(square_slip_right)
    t5 = fma(-half_track, yaw_rate, wheel_rate)
    rate_roll_left = t5
    square_roll_left = fma(rate_roll_left, rate_roll_left, stiction_rate_squared)
    root_roll_left = sqrt(square_roll_left)
    t6 = fma(half_track, yaw_rate, wheel_rate)
    rate_roll_right = t6
    square_roll_right = fma(rate_roll_right, rate_roll_right, stiction_rate_squared)
    root_roll_right = sqrt(square_roll_right)
    before_0 = determinant * a33
    before_1 = before_0 * root_slip_left
    before_2 = before_1 * root_slip_right
    before_3 = before_2 * root_roll_left
    before_4 = before_3 * root_roll_right
    over = 1.0 / before_4
    over_5 = over * before_3
    rest_5 = over * root_roll_right
    over_4 = rest_5 * before_2
    rest_4 = rest_5 * root_roll_left
    over_3 = rest_4 * before_1
    rest_3 = rest_4 * root_slip_right
    over_2 = rest_3 * before_0
    rest_2 = rest_3 * root_slip_left
    over_1 = rest_2 * determinant
    rest_1 = rest_2 * a33
    slip_left = rate_slip_left * over_2
    slip_right = rate_slip_right * over_3
    roll_left = rate_roll_left * over_4
    roll_right = rate_roll_right * over_5
    t15 = slip_left + slip_right
    t16 = -pitch_rate + wheel_rate
    t19 = centrifugal * s
    t20 = yaw_rate * yaw_rate
    t21 = fma(t19, t20, fma(-t18, cos_yaw, t17))
    t22 = fma(c, t21, fma(motor_damping, t16, fma(coulomb_torque, t15, fma(t14, s, held_pitch))))
    t24 = -roll_left - roll_right
    t25 = -slip_left - slip_right
    t26 = pitch_rate * pitch_rate
    t27 = lever * t26
    t28 = fma(turning_lever, t20, t27)
    t29 = fma(t28, s, fma(-rolling_damping, wheel_rate, fma(coulomb_torque, t25, fma(rolling_torque, t24, fma(motor_damping, pitch_rate, fma(-t23, cos_yaw, held_wheel))))))
    t30 = roll_left - roll_right
    t31 = slip_left - slip_right
    t33 = t32 * sin_yaw
    t34 = yaw_coriolis * c
    t35 = t34 * pitch_rate
    t36 = fma(-yaw_lever, wheel_rate, -t35)
    t37 = fma(t36, yaw_rate, t33)
    t38 = fma(-yaw_damping, yaw_rate, fma(s, t37, fma(yaw_coulomb_torque, t31, fma(yaw_rolling_torque, t30, held_yaw))))
    pitch_alone = fma(-a12, t29, t22)
    pitch_acc = pitch_alone * rest_1
    wheel_acc = fma(-a12, pitch_acc, t29)
    yaw_acc = t38 * over_1
    return pitch_acc, wheel_acc, yaw_acc



@inlined
def accelerations_rolling_slope(pitch, pitch_rate, wheel_rate, yaw, yaw_rate, left, right, force, moment, sin_slope, cos_slope, half_track, motor_damping, centrifugal, weight, moment_response, coulomb_torque, motor_torque, lever, rolling_damping, turning_lever, slope_weight, force_response, yaw_coriolis, yaw_lever, yaw_damping, yaw_weight, yaw_coulomb_torque, rolling_torque, yaw_rolling_torque, yaw_motor_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared):
    held_pitch, held_wheel, held_yaw, t14, t17, t18, t23, t32 = held_rolling_slope(left, right, force, moment, sin_slope, cos_slope, weight, moment_response, motor_torque, slope_weight, force_response, yaw_weight, yaw_motor_torque)
    return moved_rolling_slope(pitch, pitch_rate, wheel_rate, yaw, yaw_rate, held_pitch, held_wheel, held_yaw, t14, t17, t18, t23, t32, half_track, motor_damping, centrifugal, coulomb_torque, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, yaw_coulomb_torque, rolling_torque, yaw_rolling_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared)



@inlined
def constants_rolling_slope(w, i):
    return get(w, 14, i), get(w, 17, i), get(w, 18, i), get(w, 19, i), get(w, 20, i), get(w, 21, i), get(w, 22, i), get(w, 23, i), get(w, 24, i), get(w, 25, i), get(w, 26, i), get(w, 27, i), get(w, 28, i), get(w, 29, i), get(w, 30, i), get(w, 31, i), get(w, 32, i), get(w, 33, i), get(w, 34, i), get(w, 35, i), get(w, 36, i), get(w, 37, i), get(w, 38, i), get(w, 39, i)



@inlined
def rk4_rolling_slope(pitch, pitch_rate, wheel, wheel_rate, yaw, yaw_rate, h, left, right, force, moment, sin_slope, cos_slope, half_track, motor_damping, centrifugal, weight, moment_response, coulomb_torque, motor_torque, lever, rolling_damping, turning_lever, slope_weight, force_response, yaw_coriolis, yaw_lever, yaw_damping, yaw_weight, yaw_coulomb_torque, rolling_torque, yaw_rolling_torque, yaw_motor_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared):
    held_pitch, held_wheel, held_yaw, t14, t17, t18, t23, t32 = held_rolling_slope(left, right, force, moment, sin_slope, cos_slope, weight, moment_response, motor_torque, slope_weight, force_response, yaw_weight, yaw_motor_torque)
    pitch_acc1, wheel_acc1, yaw_acc1 = moved_rolling_slope(pitch, pitch_rate, wheel_rate, yaw, yaw_rate, held_pitch, held_wheel, held_yaw, t14, t17, t18, t23, t32, half_track, motor_damping, centrifugal, coulomb_torque, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, yaw_coulomb_torque, rolling_torque, yaw_rolling_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared)
    half = 0.5 * h
    pitch2 = fma(half, pitch_rate, pitch)
    pitch_rate2 = fma(half, pitch_acc1, pitch_rate)
    wheel_rate2 = fma(half, wheel_acc1, wheel_rate)
    yaw2 = fma(half, yaw_rate, yaw)
    yaw_rate2 = fma(half, yaw_acc1, yaw_rate)
    pitch_acc2, wheel_acc2, yaw_acc2 = moved_rolling_slope(pitch2, pitch_rate2, wheel_rate2, yaw2, yaw_rate2, held_pitch, held_wheel, held_yaw, t14, t17, t18, t23, t32, half_track, motor_damping, centrifugal, coulomb_torque, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, yaw_coulomb_torque, rolling_torque, yaw_rolling_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared)
    pitch3 = fma(half, pitch_rate2, pitch)
    pitch_rate3 = fma(half, pitch_acc2, pitch_rate)
    wheel_rate3 = fma(half, wheel_acc2, wheel_rate)
    yaw3 = fma(half, yaw_rate2, yaw)
    yaw_rate3 = fma(half, yaw_acc2, yaw_rate)
    pitch_acc3, wheel_acc3, yaw_acc3 = moved_rolling_slope(pitch3, pitch_rate3, wheel_rate3, yaw3, yaw_rate3, held_pitch, held_wheel, held_yaw, t14, t17, t18, t23, t32, half_track, motor_damping, centrifugal, coulomb_torque, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, yaw_coulomb_torque, rolling_torque, yaw_rolling_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared)
    pitch4 = fma(h, pitch_rate3, pitch)
    pitch_rate4 = fma(h, pitch_acc3, pitch_rate)
    wheel_rate4 = fma(h, wheel_acc3, wheel_rate)
    yaw4 = fma(h, yaw_rate3, yaw)
    yaw_rate4 = fma(h, yaw_acc3, yaw_rate)
    pitch_acc4, wheel_acc4, yaw_acc4 = moved_rolling_slope(pitch4, pitch_rate4, wheel_rate4, yaw4, yaw_rate4, held_pitch, held_wheel, held_yaw, t14, t17, t18, t23, t32, half_track, motor_damping, centrifugal, coulomb_torque, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, yaw_coulomb_torque, rolling_torque, yaw_rolling_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared)
    sixth = 1 / 6 * h
    new_pitch, new_pitch_rate = ended(h, sixth, pitch, pitch_rate, pitch_acc1, pitch_acc2, pitch_acc3, pitch_acc4)
    new_wheel, new_wheel_rate = ended(h, sixth, wheel, wheel_rate, wheel_acc1, wheel_acc2, wheel_acc3, wheel_acc4)
    new_yaw, new_yaw_rate = ended(h, sixth, yaw, yaw_rate, yaw_acc1, yaw_acc2, yaw_acc3, yaw_acc4)
    return new_pitch, new_pitch_rate, new_wheel, new_wheel_rate, new_yaw, new_yaw_rate



def step_rolling_slope(w, count, fallen, now):
    i = 0
    pitch, pitch_rate, wheel, wheel_rate, yaw, yaw_rate, h, lived, left, right, force, moment, sin_slope, cos_slope = get(w, 0, i), get(w, 1, i), get(w, 2, i), get(w, 3, i), get(w, 4, i), get(w, 5, i), get(w, 6, i), get(w, 7, i), get(w, 8, i), get(w, 9, i), get(w, 10, i), get(w, 11, i), get(w, 12, i), get(w, 13, i)
    new_pitch, new_pitch_rate, new_wheel, new_wheel_rate, new_yaw, new_yaw_rate = rk4_rolling_slope(pitch, pitch_rate, wheel, wheel_rate, yaw, yaw_rate, h, left, right, force, moment, sin_slope, cos_slope, *constants_rolling_slope(w, i))
    put(w, 0, i, new_pitch)
    put(w, 1, i, new_pitch_rate)
    put(w, 2, i, new_wheel)
    put(w, 3, i, new_wheel_rate)
    put(w, 4, i, new_yaw)
    put(w, 5, i, new_yaw_rate)
    put(w, 7, i, now if h > 0.0 else lived)
    put(w, 6, i, h if absolute(new_pitch) <= fallen else 0.0)



def advance_rolling_slope(w, count, fallen, now):
    align_stack()
    for i in range(count):
        pitch, pitch_rate, wheel_rate, yaw, yaw_rate, left, right, force, moment, sin_slope, cos_slope, half_track, motor_damping, centrifugal, weight, moment_response, coulomb_torque, motor_torque, lever, rolling_damping, turning_lever, slope_weight, force_response, yaw_coriolis, yaw_lever, yaw_damping, yaw_weight, yaw_coulomb_torque, rolling_torque, yaw_rolling_torque, yaw_motor_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared = get(w, 0, i), get(w, 1, i), get(w, 3, i), get(w, 4, i), get(w, 5, i), get(w, 8, i), get(w, 9, i), get(w, 10, i), get(w, 11, i), get(w, 12, i), get(w, 13, i), get(w, 14, i), get(w, 17, i), get(w, 18, i), get(w, 19, i), get(w, 20, i), get(w, 21, i), get(w, 22, i), get(w, 23, i), get(w, 24, i), get(w, 25, i), get(w, 26, i), get(w, 27, i), get(w, 28, i), get(w, 29, i), get(w, 30, i), get(w, 31, i), get(w, 32, i), get(w, 33, i), get(w, 34, i), get(w, 35, i), get(w, 36, i), get(w, 37, i), get(w, 38, i), get(w, 39, i)
        held_pitch, held_wheel, held_yaw, t14, t17, t18, t23, t32 = held_rolling_slope(left, right, force, moment, sin_slope, cos_slope, weight, moment_response, motor_torque, slope_weight, force_response, yaw_weight, yaw_motor_torque)
        pitch_acc1, wheel_acc1, yaw_acc1 = moved_rolling_slope(pitch, pitch_rate, wheel_rate, yaw, yaw_rate, held_pitch, held_wheel, held_yaw, t14, t17, t18, t23, t32, half_track, motor_damping, centrifugal, coulomb_torque, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, yaw_coulomb_torque, rolling_torque, yaw_rolling_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared)
        put(w, WORK + 0, i, pitch_acc1)
        put(w, WORK + 1, i, wheel_acc1)
        put(w, WORK + 2, i, yaw_acc1)
        put(w, WORK + 13, i, held_pitch)
        put(w, WORK + 14, i, held_wheel)
        put(w, WORK + 15, i, held_yaw)
        put(w, WORK + 16, i, t14)
        put(w, WORK + 17, i, t17)
        put(w, WORK + 18, i, t18)
        put(w, WORK + 19, i, t23)
        put(w, WORK + 20, i, t32)
    for i in range(count):
        pitch, pitch_rate, wheel_rate, yaw, yaw_rate, h, half_track, motor_damping, centrifugal, coulomb_torque, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, yaw_coulomb_torque, rolling_torque, yaw_rolling_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared, pitch_acc1, wheel_acc1, yaw_acc1, held_pitch, held_wheel, held_yaw, t14, t17, t18, t23, t32 = get(w, 0, i), get(w, 1, i), get(w, 3, i), get(w, 4, i), get(w, 5, i), get(w, 6, i), get(w, 14, i), get(w, 17, i), get(w, 18, i), get(w, 21, i), get(w, 23, i), get(w, 24, i), get(w, 25, i), get(w, 28, i), get(w, 29, i), get(w, 30, i), get(w, 32, i), get(w, 33, i), get(w, 34, i), get(w, 36, i), get(w, 37, i), get(w, 38, i), get(w, 39, i), get(w, WORK + 0, i), get(w, WORK + 1, i), get(w, WORK + 2, i), get(w, WORK + 13, i), get(w, WORK + 14, i), get(w, WORK + 15, i), get(w, WORK + 16, i), get(w, WORK + 17, i), get(w, WORK + 18, i), get(w, WORK + 19, i), get(w, WORK + 20, i)
        half = 0.5 * h
        pitch2 = fma(half, pitch_rate, pitch)
        pitch_rate2 = fma(half, pitch_acc1, pitch_rate)
        wheel_rate2 = fma(half, wheel_acc1, wheel_rate)
        yaw2 = fma(half, yaw_rate, yaw)
        yaw_rate2 = fma(half, yaw_acc1, yaw_rate)
        pitch_acc2, wheel_acc2, yaw_acc2 = moved_rolling_slope(pitch2, pitch_rate2, wheel_rate2, yaw2, yaw_rate2, held_pitch, held_wheel, held_yaw, t14, t17, t18, t23, t32, half_track, motor_damping, centrifugal, coulomb_torque, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, yaw_coulomb_torque, rolling_torque, yaw_rolling_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared)
        put(w, WORK + 3, i, pitch_acc2)
        put(w, WORK + 4, i, wheel_acc2)
        put(w, WORK + 5, i, yaw_acc2)
        put(w, WORK + 9, i, pitch_rate2)
        put(w, WORK + 10, i, yaw_rate2)
    for i in range(count):
        pitch, pitch_rate, wheel_rate, yaw, yaw_rate, h, half_track, motor_damping, centrifugal, coulomb_torque, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, yaw_coulomb_torque, rolling_torque, yaw_rolling_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared, pitch_acc2, wheel_acc2, yaw_acc2, pitch_rate2, yaw_rate2, held_pitch, held_wheel, held_yaw, t14, t17, t18, t23, t32 = get(w, 0, i), get(w, 1, i), get(w, 3, i), get(w, 4, i), get(w, 5, i), get(w, 6, i), get(w, 14, i), get(w, 17, i), get(w, 18, i), get(w, 21, i), get(w, 23, i), get(w, 24, i), get(w, 25, i), get(w, 28, i), get(w, 29, i), get(w, 30, i), get(w, 32, i), get(w, 33, i), get(w, 34, i), get(w, 36, i), get(w, 37, i), get(w, 38, i), get(w, 39, i), get(w, WORK + 3, i), get(w, WORK + 4, i), get(w, WORK + 5, i), get(w, WORK + 9, i), get(w, WORK + 10, i), get(w, WORK + 13, i), get(w, WORK + 14, i), get(w, WORK + 15, i), get(w, WORK + 16, i), get(w, WORK + 17, i), get(w, WORK + 18, i), get(w, WORK + 19, i), get(w, WORK + 20, i)
        half = 0.5 * h
        pitch3 = fma(half, pitch_rate2, pitch)
        pitch_rate3 = fma(half, pitch_acc2, pitch_rate)
        wheel_rate3 = fma(half, wheel_acc2, wheel_rate)
        yaw3 = fma(half, yaw_rate2, yaw)
        yaw_rate3 = fma(half, yaw_acc2, yaw_rate)
        pitch_acc3, wheel_acc3, yaw_acc3 = moved_rolling_slope(pitch3, pitch_rate3, wheel_rate3, yaw3, yaw_rate3, held_pitch, held_wheel, held_yaw, t14, t17, t18, t23, t32, half_track, motor_damping, centrifugal, coulomb_torque, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, yaw_coulomb_torque, rolling_torque, yaw_rolling_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared)
        put(w, WORK + 6, i, pitch_acc3)
        put(w, WORK + 7, i, wheel_acc3)
        put(w, WORK + 8, i, yaw_acc3)
        put(w, WORK + 11, i, pitch_rate3)
        put(w, WORK + 12, i, yaw_rate3)
    for i in range(count):
        pitch, pitch_rate, wheel, wheel_rate, yaw, yaw_rate, h, lived, half_track, motor_damping, centrifugal, coulomb_torque, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, yaw_coulomb_torque, rolling_torque, yaw_rolling_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared, pitch_acc1, wheel_acc1, yaw_acc1, pitch_acc2, wheel_acc2, yaw_acc2, pitch_acc3, wheel_acc3, yaw_acc3, pitch_rate3, yaw_rate3, held_pitch, held_wheel, held_yaw, t14, t17, t18, t23, t32 = get(w, 0, i), get(w, 1, i), get(w, 2, i), get(w, 3, i), get(w, 4, i), get(w, 5, i), get(w, 6, i), get(w, 7, i), get(w, 14, i), get(w, 17, i), get(w, 18, i), get(w, 21, i), get(w, 23, i), get(w, 24, i), get(w, 25, i), get(w, 28, i), get(w, 29, i), get(w, 30, i), get(w, 32, i), get(w, 33, i), get(w, 34, i), get(w, 36, i), get(w, 37, i), get(w, 38, i), get(w, 39, i), get(w, WORK + 0, i), get(w, WORK + 1, i), get(w, WORK + 2, i), get(w, WORK + 3, i), get(w, WORK + 4, i), get(w, WORK + 5, i), get(w, WORK + 6, i), get(w, WORK + 7, i), get(w, WORK + 8, i), get(w, WORK + 11, i), get(w, WORK + 12, i), get(w, WORK + 13, i), get(w, WORK + 14, i), get(w, WORK + 15, i), get(w, WORK + 16, i), get(w, WORK + 17, i), get(w, WORK + 18, i), get(w, WORK + 19, i), get(w, WORK + 20, i)
        pitch4 = fma(h, pitch_rate3, pitch)
        pitch_rate4 = fma(h, pitch_acc3, pitch_rate)
        wheel_rate4 = fma(h, wheel_acc3, wheel_rate)
        yaw4 = fma(h, yaw_rate3, yaw)
        yaw_rate4 = fma(h, yaw_acc3, yaw_rate)
        pitch_acc4, wheel_acc4, yaw_acc4 = moved_rolling_slope(pitch4, pitch_rate4, wheel_rate4, yaw4, yaw_rate4, held_pitch, held_wheel, held_yaw, t14, t17, t18, t23, t32, half_track, motor_damping, centrifugal, coulomb_torque, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, yaw_coulomb_torque, rolling_torque, yaw_rolling_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared)
        sixth = 1 / 6 * h
        new_pitch, new_pitch_rate = ended(h, sixth, pitch, pitch_rate, pitch_acc1, pitch_acc2, pitch_acc3, pitch_acc4)
        new_wheel, new_wheel_rate = ended(h, sixth, wheel, wheel_rate, wheel_acc1, wheel_acc2, wheel_acc3, wheel_acc4)
        new_yaw, new_yaw_rate = ended(h, sixth, yaw, yaw_rate, yaw_acc1, yaw_acc2, yaw_acc3, yaw_acc4)
        put(w, 0, i, new_pitch)
        put(w, 1, i, new_pitch_rate)
        put(w, 2, i, new_wheel)
        put(w, 3, i, new_wheel_rate)
        put(w, 4, i, new_yaw)
        put(w, 5, i, new_yaw_rate)
        put(w, 7, i, now if h > 0.0 else lived)
        put(w, 6, i, h if absolute(new_pitch) <= fallen else 0.0)



def specific_force_rolling_slope(w, count, out):
    for i in range(count):
        pitch, pitch_rate, wheel_rate, yaw, yaw_rate, left, right, force, moment, sin_slope, cos_slope, half_track, wheel_radius, gravity, motor_damping, centrifugal, weight, moment_response, coulomb_torque, motor_torque, lever, rolling_damping, turning_lever, slope_weight, force_response, yaw_coriolis, yaw_lever, yaw_damping, yaw_weight, yaw_coulomb_torque, rolling_torque, yaw_rolling_torque, yaw_motor_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared = get(w, 0, i), get(w, 1, i), get(w, 3, i), get(w, 4, i), get(w, 5, i), get(w, 8, i), get(w, 9, i), get(w, 10, i), get(w, 11, i), get(w, 12, i), get(w, 13, i), get(w, 14, i), get(w, 15, i), get(w, 16, i), get(w, 17, i), get(w, 18, i), get(w, 19, i), get(w, 20, i), get(w, 21, i), get(w, 22, i), get(w, 23, i), get(w, 24, i), get(w, 25, i), get(w, 26, i), get(w, 27, i), get(w, 28, i), get(w, 29, i), get(w, 30, i), get(w, 31, i), get(w, 32, i), get(w, 33, i), get(w, 34, i), get(w, 35, i), get(w, 36, i), get(w, 37, i), get(w, 38, i), get(w, 39, i)
        held_pitch, held_wheel, held_yaw, t14, t17, t18, t23, t32 = held_rolling_slope(left, right, force, moment, sin_slope, cos_slope, weight, moment_response, motor_torque, slope_weight, force_response, yaw_weight, yaw_motor_torque)
        _, wheel_acc, _ = moved_rolling_slope(pitch, pitch_rate, wheel_rate, yaw, yaw_rate, held_pitch, held_wheel, held_yaw, t14, t17, t18, t23, t32, half_track, motor_damping, centrifugal, coulomb_torque, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, yaw_coulomb_torque, rolling_torque, yaw_rolling_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared)
        s, c = sincos(pitch)
        sin_yaw, cos_yaw = sincos_any(yaw)
        t0 = wheel_acc * wheel_radius
        t1 = gravity * sin_slope
        t2 = fma(t1, cos_yaw, t0)
        t3 = c * t2
        t4 = gravity * cos_slope
        t5 = fma(-t4, s, t3)
        forward = t5
        t6 = t4 * c
        t7 = fma(t2, s, t6)
        up = t7
        put(w, out + 0, i, forward)
        put(w, out + 1, i, up)



@inlined
def held_free(left, right, roll_left, roll_right, motor_torque, rolling_torque, yaw_rolling_torque, yaw_motor_torque):
    t3 = -left - right
    t4 = motor_torque * t3
    held_pitch = t4
    t5 = left + right
    t6 = motor_torque * t5
    t7 = -roll_left - roll_right
    t8 = fma(rolling_torque, t7, t6)
    held_wheel = t8
    t9 = -left + right
    t10 = yaw_motor_torque * t9
    t11 = roll_left - roll_right
    t12 = fma(yaw_rolling_torque, t11, t10)
    held_yaw = t12
    return held_pitch, held_wheel, held_yaw



@inlined
def moved_free(pitch, pitch_rate, wheel_rate, yaw_rate, held_pitch, held_wheel, held_yaw, motor_damping, centrifugal, weight, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, rotor_coupling, pitch_inertia, yaw_swing):
    s, c = sincos(pitch)
    t0 = fma(lever, c, -rotor_coupling)
    a12 = t0
    a22 = pitch_inertia
    t1 = s * s
    t2 = fma(yaw_swing, t1, 1.0)
    a33 = t2
    determinant = fma(-a12, a12, a22)
    before_0 = determinant * a33
    over = 1.0 / before_0
    over_1 = over * determinant
    rest_1 = over * a33
    t13 = -pitch_rate + wheel_rate
    t14 = centrifugal * c
    t15 = yaw_rate * yaw_rate
    t16 = fma(t14, t15, weight)
    t17 = fma(t16, s, fma(motor_damping, t13, held_pitch))
    t18 = pitch_rate * pitch_rate
    t19 = lever * t18
    t20 = fma(turning_lever, t15, t19)
    t21 = fma(t20, s, fma(-rolling_damping, wheel_rate, fma(motor_damping, pitch_rate, held_wheel)))
    t22 = yaw_coriolis * c
    t23 = t22 * pitch_rate
    t24 = fma(-yaw_lever, wheel_rate, -t23)
    t25 = fma(t24, s, -yaw_damping)
    t26 = fma(t25, yaw_rate, held_yaw)
    pitch_alone = fma(-a12, t21, t17)
    pitch_acc = pitch_alone * rest_1
    wheel_acc = fma(-a12, pitch_acc, t21)
    yaw_acc = t26 * over_1
    return pitch_acc, wheel_acc, yaw_acc



@inlined
def accelerations_free(pitch, pitch_rate, wheel_rate, yaw_rate, left, right, roll_left, roll_right, motor_damping, centrifugal, weight, motor_torque, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, rolling_torque, yaw_rolling_torque, yaw_motor_torque, rotor_coupling, pitch_inertia, yaw_swing):
    held_pitch, held_wheel, held_yaw = held_free(left, right, roll_left, roll_right, motor_torque, rolling_torque, yaw_rolling_torque, yaw_motor_torque)
    return moved_free(pitch, pitch_rate, wheel_rate, yaw_rate, held_pitch, held_wheel, held_yaw, motor_damping, centrifugal, weight, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, rotor_coupling, pitch_inertia, yaw_swing)



@inlined
def constants_free(w, i):
    return get(w, 17, i), get(w, 18, i), get(w, 19, i), get(w, 22, i), get(w, 23, i), get(w, 24, i), get(w, 25, i), get(w, 28, i), get(w, 29, i), get(w, 30, i), get(w, 33, i), get(w, 34, i), get(w, 35, i), get(w, 36, i), get(w, 37, i), get(w, 38, i)



@inlined
def rk4_free(pitch, pitch_rate, wheel, wheel_rate, yaw, yaw_rate, h, left, right, roll_left, roll_right, motor_damping, centrifugal, weight, motor_torque, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, rolling_torque, yaw_rolling_torque, yaw_motor_torque, rotor_coupling, pitch_inertia, yaw_swing):
    held_pitch, held_wheel, held_yaw = held_free(left, right, roll_left, roll_right, motor_torque, rolling_torque, yaw_rolling_torque, yaw_motor_torque)
    pitch_acc1, wheel_acc1, yaw_acc1 = moved_free(pitch, pitch_rate, wheel_rate, yaw_rate, held_pitch, held_wheel, held_yaw, motor_damping, centrifugal, weight, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, rotor_coupling, pitch_inertia, yaw_swing)
    half = 0.5 * h
    pitch2 = fma(half, pitch_rate, pitch)
    pitch_rate2 = fma(half, pitch_acc1, pitch_rate)
    wheel_rate2 = fma(half, wheel_acc1, wheel_rate)
    yaw_rate2 = fma(half, yaw_acc1, yaw_rate)
    pitch_acc2, wheel_acc2, yaw_acc2 = moved_free(pitch2, pitch_rate2, wheel_rate2, yaw_rate2, held_pitch, held_wheel, held_yaw, motor_damping, centrifugal, weight, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, rotor_coupling, pitch_inertia, yaw_swing)
    pitch3 = fma(half, pitch_rate2, pitch)
    pitch_rate3 = fma(half, pitch_acc2, pitch_rate)
    wheel_rate3 = fma(half, wheel_acc2, wheel_rate)
    yaw_rate3 = fma(half, yaw_acc2, yaw_rate)
    pitch_acc3, wheel_acc3, yaw_acc3 = moved_free(pitch3, pitch_rate3, wheel_rate3, yaw_rate3, held_pitch, held_wheel, held_yaw, motor_damping, centrifugal, weight, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, rotor_coupling, pitch_inertia, yaw_swing)
    pitch4 = fma(h, pitch_rate3, pitch)
    pitch_rate4 = fma(h, pitch_acc3, pitch_rate)
    wheel_rate4 = fma(h, wheel_acc3, wheel_rate)
    yaw_rate4 = fma(h, yaw_acc3, yaw_rate)
    pitch_acc4, wheel_acc4, yaw_acc4 = moved_free(pitch4, pitch_rate4, wheel_rate4, yaw_rate4, held_pitch, held_wheel, held_yaw, motor_damping, centrifugal, weight, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, rotor_coupling, pitch_inertia, yaw_swing)
    sixth = 1 / 6 * h
    new_pitch, new_pitch_rate = ended(h, sixth, pitch, pitch_rate, pitch_acc1, pitch_acc2, pitch_acc3, pitch_acc4)
    new_wheel, new_wheel_rate = ended(h, sixth, wheel, wheel_rate, wheel_acc1, wheel_acc2, wheel_acc3, wheel_acc4)
    new_yaw, new_yaw_rate = ended(h, sixth, yaw, yaw_rate, yaw_acc1, yaw_acc2, yaw_acc3, yaw_acc4)
    return new_pitch, new_pitch_rate, new_wheel, new_wheel_rate, new_yaw, new_yaw_rate



@inlined
def held_speed(left, right, force, moment, moment_response, force_response):
    speed_left = left
    speed_right = right
    t5 = force_response * force
    held_wheel = t5
    t6 = moment_response * moment
    return speed_left, speed_right, held_wheel, t6



@inlined
def moved_speed(pitch, pitch_rate, wheel_rate, yaw_rate, speed_left, speed_right, held_wheel, t6, half_track, motor_damping, centrifugal, weight, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, rolling_torque, yaw_rolling_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared, speed_lag, acceleration_limit, slip_torque, yaw_inertia):
    s, c = sincos(pitch)
    t0 = fma(lever, c, -rotor_coupling)
    a12 = t0
    a22 = pitch_inertia
    t1 = s * s
    t2 = fma(yaw_swing, t1, 1.0)
    a33 = t2
    determinant = fma(-a12, a12, a22)
    t3 = fma(-half_track, yaw_rate, wheel_rate)
    rate_roll_left = t3
    square_roll_left = fma(rate_roll_left, rate_roll_left, stiction_rate_squared)
    root_roll_left = sqrt(square_roll_left)
    t4 = fma(half_track, yaw_rate, wheel_rate)
    rate_roll_right = t4
    square_roll_right = fma(rate_roll_right, rate_roll_right, stiction_rate_squared)
    root_roll_right = sqrt(square_roll_right)
    before_0 = determinant * a33
    before_1 = before_0 * root_roll_left
    before_2 = before_1 * root_roll_right
    over = 1.0 / before_2
    over_3 = over * before_1
    rest_3 = over * root_roll_right
    over_2 = rest_3 * before_0
    rest_2 = rest_3 * root_roll_left
    over_1 = rest_2 * determinant
    rest_1 = rest_2 * a33
    roll_left = rate_roll_left * over_2
    roll_right = rate_roll_right * over_3
    held_pitch = 0.0
    held_yaw = 0.0
    t7 = -pitch_rate + wheel_rate
    t8 = centrifugal * c
    t9 = yaw_rate * yaw_rate
    t10 = fma(t8, t9, weight)
    t11 = fma(t10, s, fma(motor_damping, t7, fma(t6, c, held_pitch)))
    t12 = -roll_left - roll_right
    t13 = pitch_rate * pitch_rate
    t14 = lever * t13
    t15 = fma(turning_lever, t9, t14)
    t16 = fma(t15, s, fma(-rolling_damping, wheel_rate, fma(rolling_torque, t12, fma(motor_damping, pitch_rate, held_wheel))))
    t17 = roll_left - roll_right
    t18 = yaw_coriolis * c
    t19 = t18 * pitch_rate
    t20 = fma(-yaw_lever, wheel_rate, -t19)
    t21 = fma(t20, s, -yaw_damping)
    t22 = fma(t21, yaw_rate, fma(yaw_rolling_torque, t17, held_yaw))
    pitch_alone = fma(-a12, t16, t11)
    free_pitch_acc = pitch_alone * rest_1
    free_wheel_acc = fma(-a12, free_pitch_acc, t16)
    free_yaw_acc = t22 * over_1
    drive_0 = half_track * yaw_rate
    drive_1 = wheel_rate - drive_0
    drive_2 = drive_1 - pitch_rate
    drive_3 = wheel_rate + drive_0
    drive_4 = drive_3 - pitch_rate
    drive_5 = a33 * yaw_inertia
    drive_6 = speed_left - drive_2
    drive_7 = 1.0 / speed_lag
    drive_8 = drive_6 * drive_7
    drive_9 = drive_8 * drive_8
    drive_10 = absolute(drive_8)
    drive_11 = 1.0 / acceleration_limit
    drive_12 = drive_10 * drive_11
    drive_13 = 2.0 * drive_8
    drive_14 = drive_12 + 1.0
    drive_15 = drive_12 - 1.0
    drive_16 = drive_15 * drive_15
    drive_17 = absolute(drive_15)
    drive_18 = drive_14 + drive_17
    drive_19 = drive_13 / drive_18
    drive_20 = speed_right - drive_4
    drive_21 = drive_20 * drive_7
    drive_22 = drive_21 * drive_21
    drive_23 = absolute(drive_21)
    drive_24 = drive_23 * drive_11
    drive_25 = 2.0 * drive_21
    drive_26 = drive_24 + 1.0
    drive_27 = drive_24 - 1.0
    drive_28 = drive_27 * drive_27
    drive_29 = absolute(drive_27)
    drive_30 = drive_26 + drive_29
    drive_31 = drive_25 / drive_30
    drive_32 = drive_19 + drive_31
    drive_33 = 0.5 * drive_32
    drive_34 = free_wheel_acc - free_pitch_acc
    drive_35 = drive_33 - drive_34
    drive_36 = a22
    drive_37 = a12 * a12
    drive_38 = drive_36 - drive_37
    drive_39 = drive_35 * drive_38
    drive_40 = 2.0 * a12
    drive_41 = drive_40 + 1.0
    drive_42 = drive_41 + a22
    drive_43 = drive_39 / drive_42
    drive_44 = drive_31 - drive_19
    drive_45 = 0.5 / half_track
    drive_46 = drive_44 * drive_45
    drive_47 = drive_46 - free_yaw_acc
    drive_48 = drive_47 * drive_5
    drive_49 = 1.0 / half_track
    drive_50 = drive_48 * drive_49
    drive_51 = drive_43 - drive_50
    drive_52 = 0.5 * drive_51
    drive_53 = drive_43 + drive_50
    drive_54 = 0.5 * drive_53
    drive_55 = drive_52 * drive_52
    drive_56 = absolute(drive_52)
    drive_57 = 1.0 / slip_torque
    drive_58 = drive_56 * drive_57
    drive_59 = 2.0 * drive_52
    drive_60 = drive_58 + 1.0
    drive_61 = drive_58 - 1.0
    drive_62 = drive_61 * drive_61
    drive_63 = absolute(drive_61)
    drive_64 = drive_60 + drive_63
    drive_65 = drive_59 / drive_64
    drive_66 = drive_54 * drive_54
    drive_67 = absolute(drive_54)
    drive_68 = drive_67 * drive_57
    drive_69 = 2.0 * drive_54
    drive_70 = drive_68 + 1.0
    drive_71 = drive_68 - 1.0
    drive_72 = drive_71 * drive_71
    drive_73 = absolute(drive_71)
    drive_74 = drive_70 + drive_73
    drive_75 = drive_69 / drive_74
    drive_76 = drive_65 + drive_75
    drive_77 = drive_76 / drive_38
    drive_78 = a12 + 1.0
    drive_79 = drive_78 * drive_77
    drive_80 = free_pitch_acc - drive_79
    drive_81 = a12 + a22
    drive_82 = drive_81 * drive_77
    drive_83 = free_wheel_acc + drive_82
    drive_84 = drive_75 - drive_65
    drive_85 = half_track * drive_84
    drive_86 = drive_85 / drive_5
    drive_87 = free_yaw_acc + drive_86
    pitch_acc = drive_80
    wheel_acc = drive_83
    yaw_acc = drive_87
    return pitch_acc, wheel_acc, yaw_acc



@inlined
def accelerations_speed(pitch, pitch_rate, wheel_rate, yaw_rate, left, right, force, moment, half_track, motor_damping, centrifugal, weight, moment_response, lever, rolling_damping, turning_lever, force_response, yaw_coriolis, yaw_lever, yaw_damping, rolling_torque, yaw_rolling_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared, speed_lag, acceleration_limit, slip_torque, yaw_inertia):
    speed_left, speed_right, held_wheel, t6 = held_speed(left, right, force, moment, moment_response, force_response)
    return moved_speed(pitch, pitch_rate, wheel_rate, yaw_rate, speed_left, speed_right, held_wheel, t6, half_track, motor_damping, centrifugal, weight, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, rolling_torque, yaw_rolling_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared, speed_lag, acceleration_limit, slip_torque, yaw_inertia)



@inlined
def constants_speed(w, i):
    return get(w, 14, i), get(w, 17, i), get(w, 18, i), get(w, 19, i), get(w, 20, i), get(w, 23, i), get(w, 24, i), get(w, 25, i), get(w, 27, i), get(w, 28, i), get(w, 29, i), get(w, 30, i), get(w, 33, i), get(w, 34, i), get(w, 36, i), get(w, 37, i), get(w, 38, i), get(w, 39, i), get(w, 40, i), get(w, 41, i), get(w, 42, i), get(w, 43, i)



@inlined
def rk4_speed(pitch, pitch_rate, wheel, wheel_rate, yaw, yaw_rate, h, left, right, force, moment, half_track, motor_damping, centrifugal, weight, moment_response, lever, rolling_damping, turning_lever, force_response, yaw_coriolis, yaw_lever, yaw_damping, rolling_torque, yaw_rolling_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared, speed_lag, acceleration_limit, slip_torque, yaw_inertia):
    speed_left, speed_right, held_wheel, t6 = held_speed(left, right, force, moment, moment_response, force_response)
    pitch_acc1, wheel_acc1, yaw_acc1 = moved_speed(pitch, pitch_rate, wheel_rate, yaw_rate, speed_left, speed_right, held_wheel, t6, half_track, motor_damping, centrifugal, weight, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, rolling_torque, yaw_rolling_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared, speed_lag, acceleration_limit, slip_torque, yaw_inertia)
    half = 0.5 * h
    pitch2 = fma(half, pitch_rate, pitch)
    pitch_rate2 = fma(half, pitch_acc1, pitch_rate)
    wheel_rate2 = fma(half, wheel_acc1, wheel_rate)
    yaw_rate2 = fma(half, yaw_acc1, yaw_rate)
    pitch_acc2, wheel_acc2, yaw_acc2 = moved_speed(pitch2, pitch_rate2, wheel_rate2, yaw_rate2, speed_left, speed_right, held_wheel, t6, half_track, motor_damping, centrifugal, weight, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, rolling_torque, yaw_rolling_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared, speed_lag, acceleration_limit, slip_torque, yaw_inertia)
    pitch3 = fma(half, pitch_rate2, pitch)
    pitch_rate3 = fma(half, pitch_acc2, pitch_rate)
    wheel_rate3 = fma(half, wheel_acc2, wheel_rate)
    yaw_rate3 = fma(half, yaw_acc2, yaw_rate)
    pitch_acc3, wheel_acc3, yaw_acc3 = moved_speed(pitch3, pitch_rate3, wheel_rate3, yaw_rate3, speed_left, speed_right, held_wheel, t6, half_track, motor_damping, centrifugal, weight, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, rolling_torque, yaw_rolling_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared, speed_lag, acceleration_limit, slip_torque, yaw_inertia)
    pitch4 = fma(h, pitch_rate3, pitch)
    pitch_rate4 = fma(h, pitch_acc3, pitch_rate)
    wheel_rate4 = fma(h, wheel_acc3, wheel_rate)
    yaw_rate4 = fma(h, yaw_acc3, yaw_rate)
    pitch_acc4, wheel_acc4, yaw_acc4 = moved_speed(pitch4, pitch_rate4, wheel_rate4, yaw_rate4, speed_left, speed_right, held_wheel, t6, half_track, motor_damping, centrifugal, weight, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, rolling_torque, yaw_rolling_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared, speed_lag, acceleration_limit, slip_torque, yaw_inertia)
    sixth = 1 / 6 * h
    new_pitch, new_pitch_rate = ended(h, sixth, pitch, pitch_rate, pitch_acc1, pitch_acc2, pitch_acc3, pitch_acc4)
    new_wheel, new_wheel_rate = ended(h, sixth, wheel, wheel_rate, wheel_acc1, wheel_acc2, wheel_acc3, wheel_acc4)
    new_yaw, new_yaw_rate = ended(h, sixth, yaw, yaw_rate, yaw_acc1, yaw_acc2, yaw_acc3, yaw_acc4)
    return new_pitch, new_pitch_rate, new_wheel, new_wheel_rate, new_yaw, new_yaw_rate



def step_speed(w, count, fallen, now):
    i = 0
    pitch, pitch_rate, wheel, wheel_rate, yaw, yaw_rate, h, lived, left, right, force, moment = get(w, 0, i), get(w, 1, i), get(w, 2, i), get(w, 3, i), get(w, 4, i), get(w, 5, i), get(w, 6, i), get(w, 7, i), get(w, 8, i), get(w, 9, i), get(w, 10, i), get(w, 11, i)
    new_pitch, new_pitch_rate, new_wheel, new_wheel_rate, new_yaw, new_yaw_rate = rk4_speed(pitch, pitch_rate, wheel, wheel_rate, yaw, yaw_rate, h, left, right, force, moment, *constants_speed(w, i))
    put(w, 0, i, new_pitch)
    put(w, 1, i, new_pitch_rate)
    put(w, 2, i, new_wheel)
    put(w, 3, i, new_wheel_rate)
    put(w, 4, i, new_yaw)
    put(w, 5, i, new_yaw_rate)
    put(w, 7, i, now if h > 0.0 else lived)
    put(w, 6, i, h if absolute(new_pitch) <= fallen else 0.0)



def advance_speed(w, count, fallen, now):
    align_stack()
    for i in range(count):
        pitch, pitch_rate, wheel_rate, yaw_rate, left, right, force, moment, half_track, motor_damping, centrifugal, weight, moment_response, lever, rolling_damping, turning_lever, force_response, yaw_coriolis, yaw_lever, yaw_damping, rolling_torque, yaw_rolling_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared, speed_lag, acceleration_limit, slip_torque, yaw_inertia = get(w, 0, i), get(w, 1, i), get(w, 3, i), get(w, 5, i), get(w, 8, i), get(w, 9, i), get(w, 10, i), get(w, 11, i), get(w, 14, i), get(w, 17, i), get(w, 18, i), get(w, 19, i), get(w, 20, i), get(w, 23, i), get(w, 24, i), get(w, 25, i), get(w, 27, i), get(w, 28, i), get(w, 29, i), get(w, 30, i), get(w, 33, i), get(w, 34, i), get(w, 36, i), get(w, 37, i), get(w, 38, i), get(w, 39, i), get(w, 40, i), get(w, 41, i), get(w, 42, i), get(w, 43, i)
        speed_left, speed_right, held_wheel, t6 = held_speed(left, right, force, moment, moment_response, force_response)
        pitch_acc1, wheel_acc1, yaw_acc1 = moved_speed(pitch, pitch_rate, wheel_rate, yaw_rate, speed_left, speed_right, held_wheel, t6, half_track, motor_damping, centrifugal, weight, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, rolling_torque, yaw_rolling_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared, speed_lag, acceleration_limit, slip_torque, yaw_inertia)
        put(w, WORK + 0, i, pitch_acc1)
        put(w, WORK + 1, i, wheel_acc1)
        put(w, WORK + 2, i, yaw_acc1)
        put(w, WORK + 11, i, speed_left)
        put(w, WORK + 12, i, speed_right)
        put(w, WORK + 13, i, held_wheel)
        put(w, WORK + 14, i, t6)
    for i in range(count):
        pitch, pitch_rate, wheel_rate, yaw_rate, h, half_track, motor_damping, centrifugal, weight, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, rolling_torque, yaw_rolling_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared, speed_lag, acceleration_limit, slip_torque, yaw_inertia, pitch_acc1, wheel_acc1, yaw_acc1, speed_left, speed_right, held_wheel, t6 = get(w, 0, i), get(w, 1, i), get(w, 3, i), get(w, 5, i), get(w, 6, i), get(w, 14, i), get(w, 17, i), get(w, 18, i), get(w, 19, i), get(w, 23, i), get(w, 24, i), get(w, 25, i), get(w, 28, i), get(w, 29, i), get(w, 30, i), get(w, 33, i), get(w, 34, i), get(w, 36, i), get(w, 37, i), get(w, 38, i), get(w, 39, i), get(w, 40, i), get(w, 41, i), get(w, 42, i), get(w, 43, i), get(w, WORK + 0, i), get(w, WORK + 1, i), get(w, WORK + 2, i), get(w, WORK + 11, i), get(w, WORK + 12, i), get(w, WORK + 13, i), get(w, WORK + 14, i)
        half = 0.5 * h
        pitch2 = fma(half, pitch_rate, pitch)
        pitch_rate2 = fma(half, pitch_acc1, pitch_rate)
        wheel_rate2 = fma(half, wheel_acc1, wheel_rate)
        yaw_rate2 = fma(half, yaw_acc1, yaw_rate)
        pitch_acc2, wheel_acc2, yaw_acc2 = moved_speed(pitch2, pitch_rate2, wheel_rate2, yaw_rate2, speed_left, speed_right, held_wheel, t6, half_track, motor_damping, centrifugal, weight, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, rolling_torque, yaw_rolling_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared, speed_lag, acceleration_limit, slip_torque, yaw_inertia)
        put(w, WORK + 3, i, pitch_acc2)
        put(w, WORK + 4, i, wheel_acc2)
        put(w, WORK + 5, i, yaw_acc2)
        put(w, WORK + 9, i, pitch_rate2)
    for i in range(count):
        pitch, pitch_rate, wheel_rate, yaw_rate, h, half_track, motor_damping, centrifugal, weight, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, rolling_torque, yaw_rolling_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared, speed_lag, acceleration_limit, slip_torque, yaw_inertia, pitch_acc2, wheel_acc2, yaw_acc2, pitch_rate2, speed_left, speed_right, held_wheel, t6 = get(w, 0, i), get(w, 1, i), get(w, 3, i), get(w, 5, i), get(w, 6, i), get(w, 14, i), get(w, 17, i), get(w, 18, i), get(w, 19, i), get(w, 23, i), get(w, 24, i), get(w, 25, i), get(w, 28, i), get(w, 29, i), get(w, 30, i), get(w, 33, i), get(w, 34, i), get(w, 36, i), get(w, 37, i), get(w, 38, i), get(w, 39, i), get(w, 40, i), get(w, 41, i), get(w, 42, i), get(w, 43, i), get(w, WORK + 3, i), get(w, WORK + 4, i), get(w, WORK + 5, i), get(w, WORK + 9, i), get(w, WORK + 11, i), get(w, WORK + 12, i), get(w, WORK + 13, i), get(w, WORK + 14, i)
        half = 0.5 * h
        pitch3 = fma(half, pitch_rate2, pitch)
        pitch_rate3 = fma(half, pitch_acc2, pitch_rate)
        wheel_rate3 = fma(half, wheel_acc2, wheel_rate)
        yaw_rate3 = fma(half, yaw_acc2, yaw_rate)
        pitch_acc3, wheel_acc3, yaw_acc3 = moved_speed(pitch3, pitch_rate3, wheel_rate3, yaw_rate3, speed_left, speed_right, held_wheel, t6, half_track, motor_damping, centrifugal, weight, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, rolling_torque, yaw_rolling_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared, speed_lag, acceleration_limit, slip_torque, yaw_inertia)
        put(w, WORK + 6, i, pitch_acc3)
        put(w, WORK + 7, i, wheel_acc3)
        put(w, WORK + 8, i, yaw_acc3)
        put(w, WORK + 10, i, pitch_rate3)
    for i in range(count):
        pitch, pitch_rate, wheel, wheel_rate, yaw, yaw_rate, h, lived, half_track, motor_damping, centrifugal, weight, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, rolling_torque, yaw_rolling_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared, speed_lag, acceleration_limit, slip_torque, yaw_inertia, pitch_acc1, wheel_acc1, yaw_acc1, pitch_acc2, wheel_acc2, yaw_acc2, pitch_acc3, wheel_acc3, yaw_acc3, pitch_rate3, speed_left, speed_right, held_wheel, t6 = get(w, 0, i), get(w, 1, i), get(w, 2, i), get(w, 3, i), get(w, 4, i), get(w, 5, i), get(w, 6, i), get(w, 7, i), get(w, 14, i), get(w, 17, i), get(w, 18, i), get(w, 19, i), get(w, 23, i), get(w, 24, i), get(w, 25, i), get(w, 28, i), get(w, 29, i), get(w, 30, i), get(w, 33, i), get(w, 34, i), get(w, 36, i), get(w, 37, i), get(w, 38, i), get(w, 39, i), get(w, 40, i), get(w, 41, i), get(w, 42, i), get(w, 43, i), get(w, WORK + 0, i), get(w, WORK + 1, i), get(w, WORK + 2, i), get(w, WORK + 3, i), get(w, WORK + 4, i), get(w, WORK + 5, i), get(w, WORK + 6, i), get(w, WORK + 7, i), get(w, WORK + 8, i), get(w, WORK + 10, i), get(w, WORK + 11, i), get(w, WORK + 12, i), get(w, WORK + 13, i), get(w, WORK + 14, i)
        pitch4 = fma(h, pitch_rate3, pitch)
        pitch_rate4 = fma(h, pitch_acc3, pitch_rate)
        wheel_rate4 = fma(h, wheel_acc3, wheel_rate)
        yaw_rate4 = fma(h, yaw_acc3, yaw_rate)
        pitch_acc4, wheel_acc4, yaw_acc4 = moved_speed(pitch4, pitch_rate4, wheel_rate4, yaw_rate4, speed_left, speed_right, held_wheel, t6, half_track, motor_damping, centrifugal, weight, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, rolling_torque, yaw_rolling_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared, speed_lag, acceleration_limit, slip_torque, yaw_inertia)
        sixth = 1 / 6 * h
        new_pitch, new_pitch_rate = ended(h, sixth, pitch, pitch_rate, pitch_acc1, pitch_acc2, pitch_acc3, pitch_acc4)
        new_wheel, new_wheel_rate = ended(h, sixth, wheel, wheel_rate, wheel_acc1, wheel_acc2, wheel_acc3, wheel_acc4)
        new_yaw, new_yaw_rate = ended(h, sixth, yaw, yaw_rate, yaw_acc1, yaw_acc2, yaw_acc3, yaw_acc4)
        put(w, 0, i, new_pitch)
        put(w, 1, i, new_pitch_rate)
        put(w, 2, i, new_wheel)
        put(w, 3, i, new_wheel_rate)
        put(w, 4, i, new_yaw)
        put(w, 5, i, new_yaw_rate)
        put(w, 7, i, now if h > 0.0 else lived)
        put(w, 6, i, h if absolute(new_pitch) <= fallen else 0.0)



def specific_force_speed(w, count, out):
    for i in range(count):
        pitch, pitch_rate, wheel_rate, yaw_rate, left, right, force, moment, half_track, wheel_radius, gravity, motor_damping, centrifugal, weight, moment_response, lever, rolling_damping, turning_lever, force_response, yaw_coriolis, yaw_lever, yaw_damping, rolling_torque, yaw_rolling_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared, speed_lag, acceleration_limit, slip_torque, yaw_inertia = get(w, 0, i), get(w, 1, i), get(w, 3, i), get(w, 5, i), get(w, 8, i), get(w, 9, i), get(w, 10, i), get(w, 11, i), get(w, 14, i), get(w, 15, i), get(w, 16, i), get(w, 17, i), get(w, 18, i), get(w, 19, i), get(w, 20, i), get(w, 23, i), get(w, 24, i), get(w, 25, i), get(w, 27, i), get(w, 28, i), get(w, 29, i), get(w, 30, i), get(w, 33, i), get(w, 34, i), get(w, 36, i), get(w, 37, i), get(w, 38, i), get(w, 39, i), get(w, 40, i), get(w, 41, i), get(w, 42, i), get(w, 43, i)
        speed_left, speed_right, held_wheel, t6 = held_speed(left, right, force, moment, moment_response, force_response)
        _, wheel_acc, _ = moved_speed(pitch, pitch_rate, wheel_rate, yaw_rate, speed_left, speed_right, held_wheel, t6, half_track, motor_damping, centrifugal, weight, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, rolling_torque, yaw_rolling_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared, speed_lag, acceleration_limit, slip_torque, yaw_inertia)
        s, c = sincos(pitch)
        t0 = wheel_acc * wheel_radius
        t1 = t0 * c
        t2 = fma(-gravity, s, t1)
        forward = t2
        t3 = gravity * c
        t4 = fma(t0, s, t3)
        up = t4
        put(w, out + 0, i, forward)
        put(w, out + 1, i, up)



@inlined
def held_speed_slope(left, right, force, moment, sin_slope, cos_slope, weight, moment_response, slope_weight, force_response, yaw_weight):
    speed_left = left
    speed_right = right
    t5 = force_response * force
    held_wheel = t5
    t6 = weight * cos_slope
    t8 = moment_response * moment
    t9 = weight * sin_slope
    t14 = slope_weight * sin_slope
    t21 = yaw_weight * sin_slope
    return speed_left, speed_right, held_wheel, t6, t8, t9, t14, t21



@inlined
def moved_speed_slope(pitch, pitch_rate, wheel_rate, yaw, yaw_rate, speed_left, speed_right, held_wheel, t6, t8, t9, t14, t21, half_track, motor_damping, centrifugal, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, rolling_torque, yaw_rolling_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared, speed_lag, acceleration_limit, slip_torque, yaw_inertia):
    s, c = sincos(pitch)
    sin_yaw, cos_yaw = sincos_any(yaw)
    t0 = fma(lever, c, -rotor_coupling)
    a12 = t0
    a22 = pitch_inertia
    t1 = s * s
    t2 = fma(yaw_swing, t1, 1.0)
    a33 = t2
    determinant = fma(-a12, a12, a22)
    t3 = fma(-half_track, yaw_rate, wheel_rate)
    rate_roll_left = t3
    square_roll_left = fma(rate_roll_left, rate_roll_left, stiction_rate_squared)
    root_roll_left = sqrt(square_roll_left)
    t4 = fma(half_track, yaw_rate, wheel_rate)
    rate_roll_right = t4
    square_roll_right = fma(rate_roll_right, rate_roll_right, stiction_rate_squared)
    root_roll_right = sqrt(square_roll_right)
    before_0 = determinant * a33
    before_1 = before_0 * root_roll_left
    before_2 = before_1 * root_roll_right
    over = 1.0 / before_2
    over_3 = over * before_1
    rest_3 = over * root_roll_right
    over_2 = rest_3 * before_0
    rest_2 = rest_3 * root_roll_left
    over_1 = rest_2 * determinant
    rest_1 = rest_2 * a33
    roll_left = rate_roll_left * over_2
    roll_right = rate_roll_right * over_3
    held_pitch = 0.0
    held_yaw = 0.0
    t7 = -pitch_rate + wheel_rate
    t10 = centrifugal * s
    t11 = yaw_rate * yaw_rate
    t12 = fma(t10, t11, fma(-t9, cos_yaw, t8))
    t13 = fma(c, t12, fma(motor_damping, t7, fma(t6, s, held_pitch)))
    t15 = -roll_left - roll_right
    t16 = pitch_rate * pitch_rate
    t17 = lever * t16
    t18 = fma(turning_lever, t11, t17)
    t19 = fma(t18, s, fma(-rolling_damping, wheel_rate, fma(rolling_torque, t15, fma(motor_damping, pitch_rate, fma(-t14, cos_yaw, held_wheel)))))
    t20 = roll_left - roll_right
    t22 = t21 * sin_yaw
    t23 = yaw_coriolis * c
    t24 = t23 * pitch_rate
    t25 = fma(-yaw_lever, wheel_rate, -t24)
    t26 = fma(t25, yaw_rate, t22)
    t27 = fma(-yaw_damping, yaw_rate, fma(s, t26, fma(yaw_rolling_torque, t20, held_yaw)))
    pitch_alone = fma(-a12, t19, t13)
    free_pitch_acc = pitch_alone * rest_1
    free_wheel_acc = fma(-a12, free_pitch_acc, t19)
    free_yaw_acc = t27 * over_1
    drive_0 = half_track * yaw_rate
    drive_1 = wheel_rate - drive_0
    drive_2 = drive_1 - pitch_rate
    drive_3 = wheel_rate + drive_0
    drive_4 = drive_3 - pitch_rate
    drive_5 = a33 * yaw_inertia
    drive_6 = speed_left - drive_2
    drive_7 = 1.0 / speed_lag
    drive_8 = drive_6 * drive_7
    drive_9 = drive_8 * drive_8
    drive_10 = absolute(drive_8)
    drive_11 = 1.0 / acceleration_limit
    drive_12 = drive_10 * drive_11
    drive_13 = 2.0 * drive_8
    drive_14 = drive_12 + 1.0
    drive_15 = drive_12 - 1.0
    drive_16 = drive_15 * drive_15
    drive_17 = absolute(drive_15)
    drive_18 = drive_14 + drive_17
    drive_19 = drive_13 / drive_18
    drive_20 = speed_right - drive_4
    drive_21 = drive_20 * drive_7
    drive_22 = drive_21 * drive_21
    drive_23 = absolute(drive_21)
    drive_24 = drive_23 * drive_11
    drive_25 = 2.0 * drive_21
    drive_26 = drive_24 + 1.0
    drive_27 = drive_24 - 1.0
    drive_28 = drive_27 * drive_27
    drive_29 = absolute(drive_27)
    drive_30 = drive_26 + drive_29
    drive_31 = drive_25 / drive_30
    drive_32 = drive_19 + drive_31
    drive_33 = 0.5 * drive_32
    drive_34 = free_wheel_acc - free_pitch_acc
    drive_35 = drive_33 - drive_34
    drive_36 = a22
    drive_37 = a12 * a12
    drive_38 = drive_36 - drive_37
    drive_39 = drive_35 * drive_38
    drive_40 = 2.0 * a12
    drive_41 = drive_40 + 1.0
    drive_42 = drive_41 + a22
    drive_43 = drive_39 / drive_42
    drive_44 = drive_31 - drive_19
    drive_45 = 0.5 / half_track
    drive_46 = drive_44 * drive_45
    drive_47 = drive_46 - free_yaw_acc
    drive_48 = drive_47 * drive_5
    drive_49 = 1.0 / half_track
    drive_50 = drive_48 * drive_49
    drive_51 = drive_43 - drive_50
    drive_52 = 0.5 * drive_51
    drive_53 = drive_43 + drive_50
    drive_54 = 0.5 * drive_53
    drive_55 = drive_52 * drive_52
    drive_56 = absolute(drive_52)
    drive_57 = 1.0 / slip_torque
    drive_58 = drive_56 * drive_57
    drive_59 = 2.0 * drive_52
    drive_60 = drive_58 + 1.0
    drive_61 = drive_58 - 1.0
    drive_62 = drive_61 * drive_61
    drive_63 = absolute(drive_61)
    drive_64 = drive_60 + drive_63
    drive_65 = drive_59 / drive_64
    drive_66 = drive_54 * drive_54
    drive_67 = absolute(drive_54)
    drive_68 = drive_67 * drive_57
    drive_69 = 2.0 * drive_54
    drive_70 = drive_68 + 1.0
    drive_71 = drive_68 - 1.0
    drive_72 = drive_71 * drive_71
    drive_73 = absolute(drive_71)
    drive_74 = drive_70 + drive_73
    drive_75 = drive_69 / drive_74
    drive_76 = drive_65 + drive_75
    drive_77 = drive_76 / drive_38
    drive_78 = a12 + 1.0
    drive_79 = drive_78 * drive_77
    drive_80 = free_pitch_acc - drive_79
    drive_81 = a12 + a22
    drive_82 = drive_81 * drive_77
    drive_83 = free_wheel_acc + drive_82
    drive_84 = drive_75 - drive_65
    drive_85 = half_track * drive_84
    drive_86 = drive_85 / drive_5
    drive_87 = free_yaw_acc + drive_86
    pitch_acc = drive_80
    wheel_acc = drive_83
    yaw_acc = drive_87
    return pitch_acc, wheel_acc, yaw_acc



@inlined
def accelerations_speed_slope(pitch, pitch_rate, wheel_rate, yaw, yaw_rate, left, right, force, moment, sin_slope, cos_slope, half_track, motor_damping, centrifugal, weight, moment_response, lever, rolling_damping, turning_lever, slope_weight, force_response, yaw_coriolis, yaw_lever, yaw_damping, yaw_weight, rolling_torque, yaw_rolling_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared, speed_lag, acceleration_limit, slip_torque, yaw_inertia):
    speed_left, speed_right, held_wheel, t6, t8, t9, t14, t21 = held_speed_slope(left, right, force, moment, sin_slope, cos_slope, weight, moment_response, slope_weight, force_response, yaw_weight)
    return moved_speed_slope(pitch, pitch_rate, wheel_rate, yaw, yaw_rate, speed_left, speed_right, held_wheel, t6, t8, t9, t14, t21, half_track, motor_damping, centrifugal, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, rolling_torque, yaw_rolling_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared, speed_lag, acceleration_limit, slip_torque, yaw_inertia)



@inlined
def constants_speed_slope(w, i):
    return get(w, 14, i), get(w, 17, i), get(w, 18, i), get(w, 19, i), get(w, 20, i), get(w, 23, i), get(w, 24, i), get(w, 25, i), get(w, 26, i), get(w, 27, i), get(w, 28, i), get(w, 29, i), get(w, 30, i), get(w, 31, i), get(w, 33, i), get(w, 34, i), get(w, 36, i), get(w, 37, i), get(w, 38, i), get(w, 39, i), get(w, 40, i), get(w, 41, i), get(w, 42, i), get(w, 43, i)



@inlined
def rk4_speed_slope(pitch, pitch_rate, wheel, wheel_rate, yaw, yaw_rate, h, left, right, force, moment, sin_slope, cos_slope, half_track, motor_damping, centrifugal, weight, moment_response, lever, rolling_damping, turning_lever, slope_weight, force_response, yaw_coriolis, yaw_lever, yaw_damping, yaw_weight, rolling_torque, yaw_rolling_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared, speed_lag, acceleration_limit, slip_torque, yaw_inertia):
    speed_left, speed_right, held_wheel, t6, t8, t9, t14, t21 = held_speed_slope(left, right, force, moment, sin_slope, cos_slope, weight, moment_response, slope_weight, force_response, yaw_weight)
    pitch_acc1, wheel_acc1, yaw_acc1 = moved_speed_slope(pitch, pitch_rate, wheel_rate, yaw, yaw_rate, speed_left, speed_right, held_wheel, t6, t8, t9, t14, t21, half_track, motor_damping, centrifugal, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, rolling_torque, yaw_rolling_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared, speed_lag, acceleration_limit, slip_torque, yaw_inertia)
    half = 0.5 * h
    pitch2 = fma(half, pitch_rate, pitch)
    pitch_rate2 = fma(half, pitch_acc1, pitch_rate)
    wheel_rate2 = fma(half, wheel_acc1, wheel_rate)
    yaw2 = fma(half, yaw_rate, yaw)
    yaw_rate2 = fma(half, yaw_acc1, yaw_rate)
    pitch_acc2, wheel_acc2, yaw_acc2 = moved_speed_slope(pitch2, pitch_rate2, wheel_rate2, yaw2, yaw_rate2, speed_left, speed_right, held_wheel, t6, t8, t9, t14, t21, half_track, motor_damping, centrifugal, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, rolling_torque, yaw_rolling_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared, speed_lag, acceleration_limit, slip_torque, yaw_inertia)
    pitch3 = fma(half, pitch_rate2, pitch)
    pitch_rate3 = fma(half, pitch_acc2, pitch_rate)
    wheel_rate3 = fma(half, wheel_acc2, wheel_rate)
    yaw3 = fma(half, yaw_rate2, yaw)
    yaw_rate3 = fma(half, yaw_acc2, yaw_rate)
    pitch_acc3, wheel_acc3, yaw_acc3 = moved_speed_slope(pitch3, pitch_rate3, wheel_rate3, yaw3, yaw_rate3, speed_left, speed_right, held_wheel, t6, t8, t9, t14, t21, half_track, motor_damping, centrifugal, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, rolling_torque, yaw_rolling_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared, speed_lag, acceleration_limit, slip_torque, yaw_inertia)
    pitch4 = fma(h, pitch_rate3, pitch)
    pitch_rate4 = fma(h, pitch_acc3, pitch_rate)
    wheel_rate4 = fma(h, wheel_acc3, wheel_rate)
    yaw4 = fma(h, yaw_rate3, yaw)
    yaw_rate4 = fma(h, yaw_acc3, yaw_rate)
    pitch_acc4, wheel_acc4, yaw_acc4 = moved_speed_slope(pitch4, pitch_rate4, wheel_rate4, yaw4, yaw_rate4, speed_left, speed_right, held_wheel, t6, t8, t9, t14, t21, half_track, motor_damping, centrifugal, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, rolling_torque, yaw_rolling_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared, speed_lag, acceleration_limit, slip_torque, yaw_inertia)
    sixth = 1 / 6 * h
    new_pitch, new_pitch_rate = ended(h, sixth, pitch, pitch_rate, pitch_acc1, pitch_acc2, pitch_acc3, pitch_acc4)
    new_wheel, new_wheel_rate = ended(h, sixth, wheel, wheel_rate, wheel_acc1, wheel_acc2, wheel_acc3, wheel_acc4)
    new_yaw, new_yaw_rate = ended(h, sixth, yaw, yaw_rate, yaw_acc1, yaw_acc2, yaw_acc3, yaw_acc4)
    return new_pitch, new_pitch_rate, new_wheel, new_wheel_rate, new_yaw, new_yaw_rate



def step_speed_slope(w, count, fallen, now):
    i = 0
    pitch, pitch_rate, wheel, wheel_rate, yaw, yaw_rate, h, lived, left, right, force, moment, sin_slope, cos_slope = get(w, 0, i), get(w, 1, i), get(w, 2, i), get(w, 3, i), get(w, 4, i), get(w, 5, i), get(w, 6, i), get(w, 7, i), get(w, 8, i), get(w, 9, i), get(w, 10, i), get(w, 11, i), get(w, 12, i), get(w, 13, i)
    new_pitch, new_pitch_rate, new_wheel, new_wheel_rate, new_yaw, new_yaw_rate = rk4_speed_slope(pitch, pitch_rate, wheel, wheel_rate, yaw, yaw_rate, h, left, right, force, moment, sin_slope, cos_slope, *constants_speed_slope(w, i))
    put(w, 0, i, new_pitch)
    put(w, 1, i, new_pitch_rate)
    put(w, 2, i, new_wheel)
    put(w, 3, i, new_wheel_rate)
    put(w, 4, i, new_yaw)
    put(w, 5, i, new_yaw_rate)
    put(w, 7, i, now if h > 0.0 else lived)
    put(w, 6, i, h if absolute(new_pitch) <= fallen else 0.0)



def advance_speed_slope(w, count, fallen, now):
    align_stack()
    for i in range(count):
        pitch, pitch_rate, wheel_rate, yaw, yaw_rate, left, right, force, moment, sin_slope, cos_slope, half_track, motor_damping, centrifugal, weight, moment_response, lever, rolling_damping, turning_lever, slope_weight, force_response, yaw_coriolis, yaw_lever, yaw_damping, yaw_weight, rolling_torque, yaw_rolling_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared, speed_lag, acceleration_limit, slip_torque, yaw_inertia = get(w, 0, i), get(w, 1, i), get(w, 3, i), get(w, 4, i), get(w, 5, i), get(w, 8, i), get(w, 9, i), get(w, 10, i), get(w, 11, i), get(w, 12, i), get(w, 13, i), get(w, 14, i), get(w, 17, i), get(w, 18, i), get(w, 19, i), get(w, 20, i), get(w, 23, i), get(w, 24, i), get(w, 25, i), get(w, 26, i), get(w, 27, i), get(w, 28, i), get(w, 29, i), get(w, 30, i), get(w, 31, i), get(w, 33, i), get(w, 34, i), get(w, 36, i), get(w, 37, i), get(w, 38, i), get(w, 39, i), get(w, 40, i), get(w, 41, i), get(w, 42, i), get(w, 43, i)
        speed_left, speed_right, held_wheel, t6, t8, t9, t14, t21 = held_speed_slope(left, right, force, moment, sin_slope, cos_slope, weight, moment_response, slope_weight, force_response, yaw_weight)
        pitch_acc1, wheel_acc1, yaw_acc1 = moved_speed_slope(pitch, pitch_rate, wheel_rate, yaw, yaw_rate, speed_left, speed_right, held_wheel, t6, t8, t9, t14, t21, half_track, motor_damping, centrifugal, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, rolling_torque, yaw_rolling_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared, speed_lag, acceleration_limit, slip_torque, yaw_inertia)
        put(w, WORK + 0, i, pitch_acc1)
        put(w, WORK + 1, i, wheel_acc1)
        put(w, WORK + 2, i, yaw_acc1)
        put(w, WORK + 13, i, speed_left)
        put(w, WORK + 14, i, speed_right)
        put(w, WORK + 15, i, held_wheel)
        put(w, WORK + 16, i, t6)
        put(w, WORK + 17, i, t8)
        put(w, WORK + 18, i, t9)
        put(w, WORK + 19, i, t14)
        put(w, WORK + 20, i, t21)
    for i in range(count):
        pitch, pitch_rate, wheel_rate, yaw, yaw_rate, h, half_track, motor_damping, centrifugal, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, rolling_torque, yaw_rolling_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared, speed_lag, acceleration_limit, slip_torque, yaw_inertia, pitch_acc1, wheel_acc1, yaw_acc1, speed_left, speed_right, held_wheel, t6, t8, t9, t14, t21 = get(w, 0, i), get(w, 1, i), get(w, 3, i), get(w, 4, i), get(w, 5, i), get(w, 6, i), get(w, 14, i), get(w, 17, i), get(w, 18, i), get(w, 23, i), get(w, 24, i), get(w, 25, i), get(w, 28, i), get(w, 29, i), get(w, 30, i), get(w, 33, i), get(w, 34, i), get(w, 36, i), get(w, 37, i), get(w, 38, i), get(w, 39, i), get(w, 40, i), get(w, 41, i), get(w, 42, i), get(w, 43, i), get(w, WORK + 0, i), get(w, WORK + 1, i), get(w, WORK + 2, i), get(w, WORK + 13, i), get(w, WORK + 14, i), get(w, WORK + 15, i), get(w, WORK + 16, i), get(w, WORK + 17, i), get(w, WORK + 18, i), get(w, WORK + 19, i), get(w, WORK + 20, i)
        half = 0.5 * h
        pitch2 = fma(half, pitch_rate, pitch)
        pitch_rate2 = fma(half, pitch_acc1, pitch_rate)
        wheel_rate2 = fma(half, wheel_acc1, wheel_rate)
        yaw2 = fma(half, yaw_rate, yaw)
        yaw_rate2 = fma(half, yaw_acc1, yaw_rate)
        pitch_acc2, wheel_acc2, yaw_acc2 = moved_speed_slope(pitch2, pitch_rate2, wheel_rate2, yaw2, yaw_rate2, speed_left, speed_right, held_wheel, t6, t8, t9, t14, t21, half_track, motor_damping, centrifugal, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, rolling_torque, yaw_rolling_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared, speed_lag, acceleration_limit, slip_torque, yaw_inertia)
        put(w, WORK + 3, i, pitch_acc2)
        put(w, WORK + 4, i, wheel_acc2)
        put(w, WORK + 5, i, yaw_acc2)
        put(w, WORK + 9, i, pitch_rate2)
        put(w, WORK + 10, i, yaw_rate2)
    for i in range(count):
        pitch, pitch_rate, wheel_rate, yaw, yaw_rate, h, half_track, motor_damping, centrifugal, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, rolling_torque, yaw_rolling_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared, speed_lag, acceleration_limit, slip_torque, yaw_inertia, pitch_acc2, wheel_acc2, yaw_acc2, pitch_rate2, yaw_rate2, speed_left, speed_right, held_wheel, t6, t8, t9, t14, t21 = get(w, 0, i), get(w, 1, i), get(w, 3, i), get(w, 4, i), get(w, 5, i), get(w, 6, i), get(w, 14, i), get(w, 17, i), get(w, 18, i), get(w, 23, i), get(w, 24, i), get(w, 25, i), get(w, 28, i), get(w, 29, i), get(w, 30, i), get(w, 33, i), get(w, 34, i), get(w, 36, i), get(w, 37, i), get(w, 38, i), get(w, 39, i), get(w, 40, i), get(w, 41, i), get(w, 42, i), get(w, 43, i), get(w, WORK + 3, i), get(w, WORK + 4, i), get(w, WORK + 5, i), get(w, WORK + 9, i), get(w, WORK + 10, i), get(w, WORK + 13, i), get(w, WORK + 14, i), get(w, WORK + 15, i), get(w, WORK + 16, i), get(w, WORK + 17, i), get(w, WORK + 18, i), get(w, WORK + 19, i), get(w, WORK + 20, i)
        half = 0.5 * h
        pitch3 = fma(half, pitch_rate2, pitch)
        pitch_rate3 = fma(half, pitch_acc2, pitch_rate)
        wheel_rate3 = fma(half, wheel_acc2, wheel_rate)
        yaw3 = fma(half, yaw_rate2, yaw)
        yaw_rate3 = fma(half, yaw_acc2, yaw_rate)
        pitch_acc3, wheel_acc3, yaw_acc3 = moved_speed_slope(pitch3, pitch_rate3, wheel_rate3, yaw3, yaw_rate3, speed_left, speed_right, held_wheel, t6, t8, t9, t14, t21, half_track, motor_damping, centrifugal, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, rolling_torque, yaw_rolling_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared, speed_lag, acceleration_limit, slip_torque, yaw_inertia)
        put(w, WORK + 6, i, pitch_acc3)
        put(w, WORK + 7, i, wheel_acc3)
        put(w, WORK + 8, i, yaw_acc3)
        put(w, WORK + 11, i, pitch_rate3)
        put(w, WORK + 12, i, yaw_rate3)
    for i in range(count):
        pitch, pitch_rate, wheel, wheel_rate, yaw, yaw_rate, h, lived, half_track, motor_damping, centrifugal, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, rolling_torque, yaw_rolling_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared, speed_lag, acceleration_limit, slip_torque, yaw_inertia, pitch_acc1, wheel_acc1, yaw_acc1, pitch_acc2, wheel_acc2, yaw_acc2, pitch_acc3, wheel_acc3, yaw_acc3, pitch_rate3, yaw_rate3, speed_left, speed_right, held_wheel, t6, t8, t9, t14, t21 = get(w, 0, i), get(w, 1, i), get(w, 2, i), get(w, 3, i), get(w, 4, i), get(w, 5, i), get(w, 6, i), get(w, 7, i), get(w, 14, i), get(w, 17, i), get(w, 18, i), get(w, 23, i), get(w, 24, i), get(w, 25, i), get(w, 28, i), get(w, 29, i), get(w, 30, i), get(w, 33, i), get(w, 34, i), get(w, 36, i), get(w, 37, i), get(w, 38, i), get(w, 39, i), get(w, 40, i), get(w, 41, i), get(w, 42, i), get(w, 43, i), get(w, WORK + 0, i), get(w, WORK + 1, i), get(w, WORK + 2, i), get(w, WORK + 3, i), get(w, WORK + 4, i), get(w, WORK + 5, i), get(w, WORK + 6, i), get(w, WORK + 7, i), get(w, WORK + 8, i), get(w, WORK + 11, i), get(w, WORK + 12, i), get(w, WORK + 13, i), get(w, WORK + 14, i), get(w, WORK + 15, i), get(w, WORK + 16, i), get(w, WORK + 17, i), get(w, WORK + 18, i), get(w, WORK + 19, i), get(w, WORK + 20, i)
        pitch4 = fma(h, pitch_rate3, pitch)
        pitch_rate4 = fma(h, pitch_acc3, pitch_rate)
        wheel_rate4 = fma(h, wheel_acc3, wheel_rate)
        yaw4 = fma(h, yaw_rate3, yaw)
        yaw_rate4 = fma(h, yaw_acc3, yaw_rate)
        pitch_acc4, wheel_acc4, yaw_acc4 = moved_speed_slope(pitch4, pitch_rate4, wheel_rate4, yaw4, yaw_rate4, speed_left, speed_right, held_wheel, t6, t8, t9, t14, t21, half_track, motor_damping, centrifugal, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, rolling_torque, yaw_rolling_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared, speed_lag, acceleration_limit, slip_torque, yaw_inertia)
        sixth = 1 / 6 * h
        new_pitch, new_pitch_rate = ended(h, sixth, pitch, pitch_rate, pitch_acc1, pitch_acc2, pitch_acc3, pitch_acc4)
        new_wheel, new_wheel_rate = ended(h, sixth, wheel, wheel_rate, wheel_acc1, wheel_acc2, wheel_acc3, wheel_acc4)
        new_yaw, new_yaw_rate = ended(h, sixth, yaw, yaw_rate, yaw_acc1, yaw_acc2, yaw_acc3, yaw_acc4)
        put(w, 0, i, new_pitch)
        put(w, 1, i, new_pitch_rate)
        put(w, 2, i, new_wheel)
        put(w, 3, i, new_wheel_rate)
        put(w, 4, i, new_yaw)
        put(w, 5, i, new_yaw_rate)
        put(w, 7, i, now if h > 0.0 else lived)
        put(w, 6, i, h if absolute(new_pitch) <= fallen else 0.0)



def specific_force_speed_slope(w, count, out):
    for i in range(count):
        pitch, pitch_rate, wheel_rate, yaw, yaw_rate, left, right, force, moment, sin_slope, cos_slope, half_track, wheel_radius, gravity, motor_damping, centrifugal, weight, moment_response, lever, rolling_damping, turning_lever, slope_weight, force_response, yaw_coriolis, yaw_lever, yaw_damping, yaw_weight, rolling_torque, yaw_rolling_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared, speed_lag, acceleration_limit, slip_torque, yaw_inertia = get(w, 0, i), get(w, 1, i), get(w, 3, i), get(w, 4, i), get(w, 5, i), get(w, 8, i), get(w, 9, i), get(w, 10, i), get(w, 11, i), get(w, 12, i), get(w, 13, i), get(w, 14, i), get(w, 15, i), get(w, 16, i), get(w, 17, i), get(w, 18, i), get(w, 19, i), get(w, 20, i), get(w, 23, i), get(w, 24, i), get(w, 25, i), get(w, 26, i), get(w, 27, i), get(w, 28, i), get(w, 29, i), get(w, 30, i), get(w, 31, i), get(w, 33, i), get(w, 34, i), get(w, 36, i), get(w, 37, i), get(w, 38, i), get(w, 39, i), get(w, 40, i), get(w, 41, i), get(w, 42, i), get(w, 43, i)
        speed_left, speed_right, held_wheel, t6, t8, t9, t14, t21 = held_speed_slope(left, right, force, moment, sin_slope, cos_slope, weight, moment_response, slope_weight, force_response, yaw_weight)
        _, wheel_acc, _ = moved_speed_slope(pitch, pitch_rate, wheel_rate, yaw, yaw_rate, speed_left, speed_right, held_wheel, t6, t8, t9, t14, t21, half_track, motor_damping, centrifugal, lever, rolling_damping, turning_lever, yaw_coriolis, yaw_lever, yaw_damping, rolling_torque, yaw_rolling_torque, rotor_coupling, pitch_inertia, yaw_swing, stiction_rate_squared, speed_lag, acceleration_limit, slip_torque, yaw_inertia)
        s, c = sincos(pitch)
        sin_yaw, cos_yaw = sincos_any(yaw)
        t0 = wheel_acc * wheel_radius
        t1 = gravity * sin_slope
        t2 = fma(t1, cos_yaw, t0)
        t3 = c * t2
        t4 = gravity * cos_slope
        t5 = fma(-t4, s, t3)
        forward = t5
        t6 = t4 * c
        t7 = fma(t2, s, t6)
        up = t7
        put(w, out + 0, i, forward)
        put(w, out + 1, i, up)
