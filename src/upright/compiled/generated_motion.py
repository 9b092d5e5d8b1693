# Generated from physics.dynamics: do not edit. Written again by: python -m upright.compiled.generate
# ruff: noqa
# fmt: off
# pyright: basic

from upright.compiled.generated import WORK
from upright.compiled.jit import absolute, align_stack, fma, get, inlined, mul, positive, put, reciprocal, sqrt
from upright.compiled.lane_math import sincos, sincos_any

@inlined
def held_smooth(left, right, force, moment, sin_slope, cos_slope, c6, c8, c13, c19):
    t3 = left + right
    t4 = c8 * t3
    held_pitch = t4
    t5 = c13 * force
    t6 = -left - right
    t7 = fma(c8, t6, t5)
    held_wheel = t7
    t8 = left - right
    t9 = c19 * t8
    held_yaw = t9
    t10 = c6 * moment
    return held_pitch, held_wheel, held_yaw, t10



@inlined
def moved_smooth(pitch, pitch_rate, wheel_rate, yaw, yaw_rate, held_pitch, held_wheel, held_yaw, t10, c3, c4, c5, c9, c10, c11, c14, c15, c16, c20, c21, c22):
    s, c = sincos(pitch)
    t0 = fma(c9, c, c20)
    a12 = t0
    a22 = c21
    t1 = s * s
    t2 = fma(c22, t1, 1.0)
    a33 = t2
    determinant = fma(-a12, a12, a22)
    before_0 = determinant * a33
    over = reciprocal(before_0)
    over_1 = over * determinant
    rest_1 = over * a33
    t11 = pitch_rate - wheel_rate
    t12 = c4 * c
    t13 = yaw_rate * yaw_rate
    t14 = fma(t12, t13, c5)
    t15 = fma(t14, s, fma(c3, t11, fma(t10, c, held_pitch)))
    t16 = pitch_rate * pitch_rate
    t17 = c9 * t16
    t18 = fma(c11, t13, t17)
    t19 = fma(t18, s, fma(c10, wheel_rate, fma(-c3, pitch_rate, held_wheel)))
    t20 = c14 * c
    t21 = t20 * pitch_rate
    t22 = fma(c15, wheel_rate, t21)
    t23 = fma(t22, s, c16)
    t24 = fma(t23, yaw_rate, held_yaw)
    pitch_acc = fma(-a12, t19, t15) * rest_1
    return pitch_acc, fma(-a12, pitch_acc, t19), t24 * over_1



@inlined
def accelerations_smooth(pitch, pitch_rate, wheel_rate, yaw, yaw_rate, left, right, force, moment, sin_slope, cos_slope, c0, c1, c2, c3, c4, c5, c6, c7, c8, c9, c10, c11, c12, c13, c14, c15, c16, c17, c18, c19, c20, c21, c22, c23):
    held_pitch, held_wheel, held_yaw, t10 = held_smooth(left, right, force, moment, sin_slope, cos_slope, c6, c8, c13, c19)
    return moved_smooth(pitch, pitch_rate, wheel_rate, yaw, yaw_rate, held_pitch, held_wheel, held_yaw, t10, c3, c4, c5, c9, c10, c11, c14, c15, c16, c20, c21, c22)



def step_smooth(w, count, fallen, now):
    i = 0
    pitch = get(w, 0, i)
    pitch_rate = get(w, 1, i)
    wheel = get(w, 2, i)
    wheel_rate = get(w, 3, i)
    yaw = get(w, 4, i)
    yaw_rate = get(w, 5, i)
    h = get(w, 6, i)
    lived = get(w, 7, i)
    left = get(w, 8, i)
    right = get(w, 9, i)
    force = get(w, 10, i)
    moment = get(w, 11, i)
    sin_slope = get(w, 12, i)
    cos_slope = get(w, 13, i)
    c3 = get(w, 17, i)
    c4 = get(w, 18, i)
    c5 = get(w, 19, i)
    c6 = get(w, 20, i)
    c8 = get(w, 22, i)
    c9 = get(w, 23, i)
    c10 = get(w, 24, i)
    c11 = get(w, 25, i)
    c13 = get(w, 27, i)
    c14 = get(w, 28, i)
    c15 = get(w, 29, i)
    c16 = get(w, 30, i)
    c19 = get(w, 33, i)
    c20 = get(w, 34, i)
    c21 = get(w, 35, i)
    c22 = get(w, 36, i)
    held_pitch, held_wheel, held_yaw, t10 = held_smooth(left, right, force, moment, sin_slope, cos_slope, c6, c8, c13, c19)
    pitch_acc1, wheel_acc1, yaw_acc1 = moved_smooth(pitch, pitch_rate, wheel_rate, yaw, yaw_rate, held_pitch, held_wheel, held_yaw, t10, c3, c4, c5, c9, c10, c11, c14, c15, c16, c20, c21, c22)
    half = mul(h, 0.5)
    pitch2 = fma(half, pitch_rate, pitch)
    pitch_rate2 = fma(half, pitch_acc1, pitch_rate)
    wheel_rate2 = fma(half, wheel_acc1, wheel_rate)
    yaw_rate2 = fma(half, yaw_acc1, yaw_rate)
    pitch_acc2, wheel_acc2, yaw_acc2 = moved_smooth(pitch2, pitch_rate2, wheel_rate2, yaw, yaw_rate2, held_pitch, held_wheel, held_yaw, t10, c3, c4, c5, c9, c10, c11, c14, c15, c16, c20, c21, c22)
    pitch3 = fma(half, pitch_rate2, pitch)
    pitch_rate3 = fma(half, pitch_acc2, pitch_rate)
    wheel_rate3 = fma(half, wheel_acc2, wheel_rate)
    yaw_rate3 = fma(half, yaw_acc2, yaw_rate)
    pitch_acc3, wheel_acc3, yaw_acc3 = moved_smooth(pitch3, pitch_rate3, wheel_rate3, yaw, yaw_rate3, held_pitch, held_wheel, held_yaw, t10, c3, c4, c5, c9, c10, c11, c14, c15, c16, c20, c21, c22)
    pitch4 = fma(h, pitch_rate3, pitch)
    pitch_rate4 = fma(h, pitch_acc3, pitch_rate)
    wheel_rate4 = fma(h, wheel_acc3, wheel_rate)
    yaw_rate4 = fma(h, yaw_acc3, yaw_rate)
    pitch_acc4, wheel_acc4, yaw_acc4 = moved_smooth(pitch4, pitch_rate4, wheel_rate4, yaw, yaw_rate4, held_pitch, held_wheel, held_yaw, t10, c3, c4, c5, c9, c10, c11, c14, c15, c16, c20, c21, c22)
    sixth = mul(h, 1 / 6)
    pitch_middle = pitch_acc2 + pitch_acc3
    pitch_sum = pitch_acc1 + pitch_middle
    new_pitch = fma(h, fma(sixth, pitch_sum, pitch_rate), pitch)
    new_pitch_rate = fma(sixth, (pitch_sum + pitch_middle) + pitch_acc4, pitch_rate)
    wheel_middle = wheel_acc2 + wheel_acc3
    wheel_sum = wheel_acc1 + wheel_middle
    new_wheel = fma(h, fma(sixth, wheel_sum, wheel_rate), wheel)
    new_wheel_rate = fma(sixth, (wheel_sum + wheel_middle) + wheel_acc4, wheel_rate)
    yaw_middle = yaw_acc2 + yaw_acc3
    yaw_sum = yaw_acc1 + yaw_middle
    new_yaw = fma(h, fma(sixth, yaw_sum, yaw_rate), yaw)
    new_yaw_rate = fma(sixth, (yaw_sum + yaw_middle) + yaw_acc4, yaw_rate)
    put(w, 0, i, new_pitch)
    put(w, 1, i, new_pitch_rate)
    put(w, 2, i, new_wheel)
    put(w, 3, i, new_wheel_rate)
    put(w, 4, i, new_yaw)
    put(w, 5, i, new_yaw_rate)
    put(w, 7, i, now if positive(h) else lived)
    put(w, 6, i, h if absolute(new_pitch) <= fallen else mul(h, 0.0))



def advance_smooth(w, count, fallen, now):
    align_stack()
    for i in range(count):
        pitch = get(w, 0, i)
        pitch_rate = get(w, 1, i)
        wheel_rate = get(w, 3, i)
        yaw = get(w, 4, i)
        yaw_rate = get(w, 5, i)
        left = get(w, 8, i)
        right = get(w, 9, i)
        force = get(w, 10, i)
        moment = get(w, 11, i)
        sin_slope = get(w, 12, i)
        cos_slope = get(w, 13, i)
        c3 = get(w, 17, i)
        c4 = get(w, 18, i)
        c5 = get(w, 19, i)
        c6 = get(w, 20, i)
        c8 = get(w, 22, i)
        c9 = get(w, 23, i)
        c10 = get(w, 24, i)
        c11 = get(w, 25, i)
        c13 = get(w, 27, i)
        c14 = get(w, 28, i)
        c15 = get(w, 29, i)
        c16 = get(w, 30, i)
        c19 = get(w, 33, i)
        c20 = get(w, 34, i)
        c21 = get(w, 35, i)
        c22 = get(w, 36, i)
        held_pitch, held_wheel, held_yaw, t10 = held_smooth(left, right, force, moment, sin_slope, cos_slope, c6, c8, c13, c19)
        pitch_acc1, wheel_acc1, yaw_acc1 = moved_smooth(pitch, pitch_rate, wheel_rate, yaw, yaw_rate, held_pitch, held_wheel, held_yaw, t10, c3, c4, c5, c9, c10, c11, c14, c15, c16, c20, c21, c22)
        put(w, WORK + 0, i, pitch_acc1)
        put(w, WORK + 1, i, wheel_acc1)
        put(w, WORK + 2, i, yaw_acc1)
        put(w, WORK + 11, i, held_pitch)
        put(w, WORK + 12, i, held_wheel)
        put(w, WORK + 13, i, held_yaw)
        put(w, WORK + 14, i, t10)
    for i in range(count):
        pitch = get(w, 0, i)
        pitch_rate = get(w, 1, i)
        wheel_rate = get(w, 3, i)
        yaw = get(w, 4, i)
        yaw_rate = get(w, 5, i)
        h = get(w, 6, i)
        c3 = get(w, 17, i)
        c4 = get(w, 18, i)
        c5 = get(w, 19, i)
        c9 = get(w, 23, i)
        c10 = get(w, 24, i)
        c11 = get(w, 25, i)
        c14 = get(w, 28, i)
        c15 = get(w, 29, i)
        c16 = get(w, 30, i)
        c20 = get(w, 34, i)
        c21 = get(w, 35, i)
        c22 = get(w, 36, i)
        pitch_acc1 = get(w, WORK + 0, i)
        wheel_acc1 = get(w, WORK + 1, i)
        yaw_acc1 = get(w, WORK + 2, i)
        held_pitch = get(w, WORK + 11, i)
        held_wheel = get(w, WORK + 12, i)
        held_yaw = get(w, WORK + 13, i)
        t10 = get(w, WORK + 14, i)
        half = mul(h, 0.5)
        pitch2 = fma(half, pitch_rate, pitch)
        pitch_rate2 = fma(half, pitch_acc1, pitch_rate)
        wheel_rate2 = fma(half, wheel_acc1, wheel_rate)
        yaw_rate2 = fma(half, yaw_acc1, yaw_rate)
        pitch_acc2, wheel_acc2, yaw_acc2 = moved_smooth(pitch2, pitch_rate2, wheel_rate2, yaw, yaw_rate2, held_pitch, held_wheel, held_yaw, t10, c3, c4, c5, c9, c10, c11, c14, c15, c16, c20, c21, c22)
        put(w, WORK + 3, i, pitch_acc2)
        put(w, WORK + 4, i, wheel_acc2)
        put(w, WORK + 5, i, yaw_acc2)
        put(w, WORK + 9, i, pitch_rate2)
    for i in range(count):
        pitch = get(w, 0, i)
        pitch_rate = get(w, 1, i)
        wheel_rate = get(w, 3, i)
        yaw = get(w, 4, i)
        yaw_rate = get(w, 5, i)
        h = get(w, 6, i)
        c3 = get(w, 17, i)
        c4 = get(w, 18, i)
        c5 = get(w, 19, i)
        c9 = get(w, 23, i)
        c10 = get(w, 24, i)
        c11 = get(w, 25, i)
        c14 = get(w, 28, i)
        c15 = get(w, 29, i)
        c16 = get(w, 30, i)
        c20 = get(w, 34, i)
        c21 = get(w, 35, i)
        c22 = get(w, 36, i)
        pitch_acc2 = get(w, WORK + 3, i)
        wheel_acc2 = get(w, WORK + 4, i)
        yaw_acc2 = get(w, WORK + 5, i)
        pitch_rate2 = get(w, WORK + 9, i)
        held_pitch = get(w, WORK + 11, i)
        held_wheel = get(w, WORK + 12, i)
        held_yaw = get(w, WORK + 13, i)
        t10 = get(w, WORK + 14, i)
        half = mul(h, 0.5)
        pitch3 = fma(half, pitch_rate2, pitch)
        pitch_rate3 = fma(half, pitch_acc2, pitch_rate)
        wheel_rate3 = fma(half, wheel_acc2, wheel_rate)
        yaw_rate3 = fma(half, yaw_acc2, yaw_rate)
        pitch_acc3, wheel_acc3, yaw_acc3 = moved_smooth(pitch3, pitch_rate3, wheel_rate3, yaw, yaw_rate3, held_pitch, held_wheel, held_yaw, t10, c3, c4, c5, c9, c10, c11, c14, c15, c16, c20, c21, c22)
        put(w, WORK + 6, i, pitch_acc3)
        put(w, WORK + 7, i, wheel_acc3)
        put(w, WORK + 8, i, yaw_acc3)
        put(w, WORK + 10, i, pitch_rate3)
    for i in range(count):
        pitch = get(w, 0, i)
        pitch_rate = get(w, 1, i)
        wheel = get(w, 2, i)
        wheel_rate = get(w, 3, i)
        yaw = get(w, 4, i)
        yaw_rate = get(w, 5, i)
        h = get(w, 6, i)
        lived = get(w, 7, i)
        c3 = get(w, 17, i)
        c4 = get(w, 18, i)
        c5 = get(w, 19, i)
        c9 = get(w, 23, i)
        c10 = get(w, 24, i)
        c11 = get(w, 25, i)
        c14 = get(w, 28, i)
        c15 = get(w, 29, i)
        c16 = get(w, 30, i)
        c20 = get(w, 34, i)
        c21 = get(w, 35, i)
        c22 = get(w, 36, i)
        pitch_acc1 = get(w, WORK + 0, i)
        wheel_acc1 = get(w, WORK + 1, i)
        yaw_acc1 = get(w, WORK + 2, i)
        pitch_acc2 = get(w, WORK + 3, i)
        wheel_acc2 = get(w, WORK + 4, i)
        yaw_acc2 = get(w, WORK + 5, i)
        pitch_acc3 = get(w, WORK + 6, i)
        wheel_acc3 = get(w, WORK + 7, i)
        yaw_acc3 = get(w, WORK + 8, i)
        pitch_rate3 = get(w, WORK + 10, i)
        held_pitch = get(w, WORK + 11, i)
        held_wheel = get(w, WORK + 12, i)
        held_yaw = get(w, WORK + 13, i)
        t10 = get(w, WORK + 14, i)
        pitch4 = fma(h, pitch_rate3, pitch)
        pitch_rate4 = fma(h, pitch_acc3, pitch_rate)
        wheel_rate4 = fma(h, wheel_acc3, wheel_rate)
        yaw_rate4 = fma(h, yaw_acc3, yaw_rate)
        pitch_acc4, wheel_acc4, yaw_acc4 = moved_smooth(pitch4, pitch_rate4, wheel_rate4, yaw, yaw_rate4, held_pitch, held_wheel, held_yaw, t10, c3, c4, c5, c9, c10, c11, c14, c15, c16, c20, c21, c22)
        sixth = mul(h, 1 / 6)
        pitch_middle = pitch_acc2 + pitch_acc3
        pitch_sum = pitch_acc1 + pitch_middle
        new_pitch = fma(h, fma(sixth, pitch_sum, pitch_rate), pitch)
        new_pitch_rate = fma(sixth, (pitch_sum + pitch_middle) + pitch_acc4, pitch_rate)
        wheel_middle = wheel_acc2 + wheel_acc3
        wheel_sum = wheel_acc1 + wheel_middle
        new_wheel = fma(h, fma(sixth, wheel_sum, wheel_rate), wheel)
        new_wheel_rate = fma(sixth, (wheel_sum + wheel_middle) + wheel_acc4, wheel_rate)
        yaw_middle = yaw_acc2 + yaw_acc3
        yaw_sum = yaw_acc1 + yaw_middle
        new_yaw = fma(h, fma(sixth, yaw_sum, yaw_rate), yaw)
        new_yaw_rate = fma(sixth, (yaw_sum + yaw_middle) + yaw_acc4, yaw_rate)
        put(w, 0, i, new_pitch)
        put(w, 1, i, new_pitch_rate)
        put(w, 2, i, new_wheel)
        put(w, 3, i, new_wheel_rate)
        put(w, 4, i, new_yaw)
        put(w, 5, i, new_yaw_rate)
        put(w, 7, i, now if positive(h) else lived)
        put(w, 6, i, h if absolute(new_pitch) <= fallen else mul(h, 0.0))



def specific_force_smooth(w, count, out):
    for i in range(count):
        pitch = get(w, 0, i)
        pitch_rate = get(w, 1, i)
        wheel_rate = get(w, 3, i)
        yaw = get(w, 4, i)
        yaw_rate = get(w, 5, i)
        left = get(w, 8, i)
        right = get(w, 9, i)
        force = get(w, 10, i)
        moment = get(w, 11, i)
        sin_slope = get(w, 12, i)
        cos_slope = get(w, 13, i)
        c1 = get(w, 15, i)
        c2 = get(w, 16, i)
        c3 = get(w, 17, i)
        c4 = get(w, 18, i)
        c5 = get(w, 19, i)
        c6 = get(w, 20, i)
        c8 = get(w, 22, i)
        c9 = get(w, 23, i)
        c10 = get(w, 24, i)
        c11 = get(w, 25, i)
        c13 = get(w, 27, i)
        c14 = get(w, 28, i)
        c15 = get(w, 29, i)
        c16 = get(w, 30, i)
        c19 = get(w, 33, i)
        c20 = get(w, 34, i)
        c21 = get(w, 35, i)
        c22 = get(w, 36, i)
        held_pitch, held_wheel, held_yaw, t10 = held_smooth(left, right, force, moment, sin_slope, cos_slope, c6, c8, c13, c19)
        _, wheel_acc, _ = moved_smooth(pitch, pitch_rate, wheel_rate, yaw, yaw_rate, held_pitch, held_wheel, held_yaw, t10, c3, c4, c5, c9, c10, c11, c14, c15, c16, c20, c21, c22)
        s, c = sincos(pitch)
        t0 = c1 * wheel_acc
        t1 = t0 * c
        t2 = fma(-c2, s, t1)
        t3 = c2 * c
        t4 = fma(t0, s, t3)
        put(w, out + 0, i, t2)
        put(w, out + 1, i, t4)



@inlined
def held_coulomb(left, right, force, moment, sin_slope, cos_slope, c6, c8, c13, c19):
    t5 = left + right
    t6 = c8 * t5
    held_pitch = t6
    t7 = c13 * force
    t8 = -left - right
    t9 = fma(c8, t8, t7)
    held_wheel = t9
    t10 = left - right
    t11 = c19 * t10
    held_yaw = t11
    t12 = c6 * moment
    return held_pitch, held_wheel, held_yaw, t12



@inlined
def moved_coulomb(pitch, pitch_rate, wheel_rate, yaw, yaw_rate, held_pitch, held_wheel, held_yaw, t12, c0, c3, c4, c5, c7, c9, c10, c11, c14, c15, c16, c18, c20, c21, c22, c23):
    s, c = sincos(pitch)
    t0 = fma(c9, c, c20)
    a12 = t0
    a22 = c21
    t1 = s * s
    t2 = fma(c22, t1, 1.0)
    a33 = t2
    determinant = fma(-a12, a12, a22)
    t3 = fma(-c0, yaw_rate, -pitch_rate + wheel_rate)
    rate_left = t3
    root_left = sqrt(fma(rate_left, rate_left, c23))
    t4 = fma(c0, yaw_rate, -pitch_rate + wheel_rate)
    rate_right = t4
    root_right = sqrt(fma(rate_right, rate_right, c23))
    before_0 = determinant * a33
    before_1 = before_0 * root_left
    before_2 = before_1 * root_right
    over = reciprocal(before_2)
    over_3 = over * before_1
    rest_3 = over * root_right
    over_2 = rest_3 * before_0
    rest_2 = rest_3 * root_left
    over_1 = rest_2 * determinant
    rest_1 = rest_2 * a33
    slip_left = rate_left * over_2
    slip_right = rate_right * over_3
    t13 = slip_left + slip_right
    t14 = pitch_rate - wheel_rate
    t15 = c4 * c
    t16 = yaw_rate * yaw_rate
    t17 = fma(t15, t16, c5)
    t18 = fma(t17, s, fma(c3, t14, fma(c7, t13, fma(t12, c, held_pitch))))
    t19 = -slip_left - slip_right
    t20 = pitch_rate * pitch_rate
    t21 = c9 * t20
    t22 = fma(c11, t16, t21)
    t23 = fma(t22, s, fma(c10, wheel_rate, fma(c7, t19, fma(-c3, pitch_rate, held_wheel))))
    t24 = slip_left - slip_right
    t25 = c14 * c
    t26 = t25 * pitch_rate
    t27 = fma(c15, wheel_rate, t26)
    t28 = fma(t27, s, c16)
    t29 = fma(t28, yaw_rate, fma(c18, t24, held_yaw))
    pitch_acc = fma(-a12, t23, t18) * rest_1
    return pitch_acc, fma(-a12, pitch_acc, t23), t29 * over_1



@inlined
def accelerations_coulomb(pitch, pitch_rate, wheel_rate, yaw, yaw_rate, left, right, force, moment, sin_slope, cos_slope, c0, c1, c2, c3, c4, c5, c6, c7, c8, c9, c10, c11, c12, c13, c14, c15, c16, c17, c18, c19, c20, c21, c22, c23):
    held_pitch, held_wheel, held_yaw, t12 = held_coulomb(left, right, force, moment, sin_slope, cos_slope, c6, c8, c13, c19)
    return moved_coulomb(pitch, pitch_rate, wheel_rate, yaw, yaw_rate, held_pitch, held_wheel, held_yaw, t12, c0, c3, c4, c5, c7, c9, c10, c11, c14, c15, c16, c18, c20, c21, c22, c23)



def step_coulomb(w, count, fallen, now):
    i = 0
    pitch = get(w, 0, i)
    pitch_rate = get(w, 1, i)
    wheel = get(w, 2, i)
    wheel_rate = get(w, 3, i)
    yaw = get(w, 4, i)
    yaw_rate = get(w, 5, i)
    h = get(w, 6, i)
    lived = get(w, 7, i)
    left = get(w, 8, i)
    right = get(w, 9, i)
    force = get(w, 10, i)
    moment = get(w, 11, i)
    sin_slope = get(w, 12, i)
    cos_slope = get(w, 13, i)
    c0 = get(w, 14, i)
    c3 = get(w, 17, i)
    c4 = get(w, 18, i)
    c5 = get(w, 19, i)
    c6 = get(w, 20, i)
    c7 = get(w, 21, i)
    c8 = get(w, 22, i)
    c9 = get(w, 23, i)
    c10 = get(w, 24, i)
    c11 = get(w, 25, i)
    c13 = get(w, 27, i)
    c14 = get(w, 28, i)
    c15 = get(w, 29, i)
    c16 = get(w, 30, i)
    c18 = get(w, 32, i)
    c19 = get(w, 33, i)
    c20 = get(w, 34, i)
    c21 = get(w, 35, i)
    c22 = get(w, 36, i)
    c23 = get(w, 37, i)
    held_pitch, held_wheel, held_yaw, t12 = held_coulomb(left, right, force, moment, sin_slope, cos_slope, c6, c8, c13, c19)
    pitch_acc1, wheel_acc1, yaw_acc1 = moved_coulomb(pitch, pitch_rate, wheel_rate, yaw, yaw_rate, held_pitch, held_wheel, held_yaw, t12, c0, c3, c4, c5, c7, c9, c10, c11, c14, c15, c16, c18, c20, c21, c22, c23)
    half = mul(h, 0.5)
    pitch2 = fma(half, pitch_rate, pitch)
    pitch_rate2 = fma(half, pitch_acc1, pitch_rate)
    wheel_rate2 = fma(half, wheel_acc1, wheel_rate)
    yaw_rate2 = fma(half, yaw_acc1, yaw_rate)
    pitch_acc2, wheel_acc2, yaw_acc2 = moved_coulomb(pitch2, pitch_rate2, wheel_rate2, yaw, yaw_rate2, held_pitch, held_wheel, held_yaw, t12, c0, c3, c4, c5, c7, c9, c10, c11, c14, c15, c16, c18, c20, c21, c22, c23)
    pitch3 = fma(half, pitch_rate2, pitch)
    pitch_rate3 = fma(half, pitch_acc2, pitch_rate)
    wheel_rate3 = fma(half, wheel_acc2, wheel_rate)
    yaw_rate3 = fma(half, yaw_acc2, yaw_rate)
    pitch_acc3, wheel_acc3, yaw_acc3 = moved_coulomb(pitch3, pitch_rate3, wheel_rate3, yaw, yaw_rate3, held_pitch, held_wheel, held_yaw, t12, c0, c3, c4, c5, c7, c9, c10, c11, c14, c15, c16, c18, c20, c21, c22, c23)
    pitch4 = fma(h, pitch_rate3, pitch)
    pitch_rate4 = fma(h, pitch_acc3, pitch_rate)
    wheel_rate4 = fma(h, wheel_acc3, wheel_rate)
    yaw_rate4 = fma(h, yaw_acc3, yaw_rate)
    pitch_acc4, wheel_acc4, yaw_acc4 = moved_coulomb(pitch4, pitch_rate4, wheel_rate4, yaw, yaw_rate4, held_pitch, held_wheel, held_yaw, t12, c0, c3, c4, c5, c7, c9, c10, c11, c14, c15, c16, c18, c20, c21, c22, c23)
    sixth = mul(h, 1 / 6)
    pitch_middle = pitch_acc2 + pitch_acc3
    pitch_sum = pitch_acc1 + pitch_middle
    new_pitch = fma(h, fma(sixth, pitch_sum, pitch_rate), pitch)
    new_pitch_rate = fma(sixth, (pitch_sum + pitch_middle) + pitch_acc4, pitch_rate)
    wheel_middle = wheel_acc2 + wheel_acc3
    wheel_sum = wheel_acc1 + wheel_middle
    new_wheel = fma(h, fma(sixth, wheel_sum, wheel_rate), wheel)
    new_wheel_rate = fma(sixth, (wheel_sum + wheel_middle) + wheel_acc4, wheel_rate)
    yaw_middle = yaw_acc2 + yaw_acc3
    yaw_sum = yaw_acc1 + yaw_middle
    new_yaw = fma(h, fma(sixth, yaw_sum, yaw_rate), yaw)
    new_yaw_rate = fma(sixth, (yaw_sum + yaw_middle) + yaw_acc4, yaw_rate)
    put(w, 0, i, new_pitch)
    put(w, 1, i, new_pitch_rate)
    put(w, 2, i, new_wheel)
    put(w, 3, i, new_wheel_rate)
    put(w, 4, i, new_yaw)
    put(w, 5, i, new_yaw_rate)
    put(w, 7, i, now if positive(h) else lived)
    put(w, 6, i, h if absolute(new_pitch) <= fallen else mul(h, 0.0))



def advance_coulomb(w, count, fallen, now):
    align_stack()
    for i in range(count):
        pitch = get(w, 0, i)
        pitch_rate = get(w, 1, i)
        wheel_rate = get(w, 3, i)
        yaw = get(w, 4, i)
        yaw_rate = get(w, 5, i)
        left = get(w, 8, i)
        right = get(w, 9, i)
        force = get(w, 10, i)
        moment = get(w, 11, i)
        sin_slope = get(w, 12, i)
        cos_slope = get(w, 13, i)
        c0 = get(w, 14, i)
        c3 = get(w, 17, i)
        c4 = get(w, 18, i)
        c5 = get(w, 19, i)
        c6 = get(w, 20, i)
        c7 = get(w, 21, i)
        c8 = get(w, 22, i)
        c9 = get(w, 23, i)
        c10 = get(w, 24, i)
        c11 = get(w, 25, i)
        c13 = get(w, 27, i)
        c14 = get(w, 28, i)
        c15 = get(w, 29, i)
        c16 = get(w, 30, i)
        c18 = get(w, 32, i)
        c19 = get(w, 33, i)
        c20 = get(w, 34, i)
        c21 = get(w, 35, i)
        c22 = get(w, 36, i)
        c23 = get(w, 37, i)
        held_pitch, held_wheel, held_yaw, t12 = held_coulomb(left, right, force, moment, sin_slope, cos_slope, c6, c8, c13, c19)
        pitch_acc1, wheel_acc1, yaw_acc1 = moved_coulomb(pitch, pitch_rate, wheel_rate, yaw, yaw_rate, held_pitch, held_wheel, held_yaw, t12, c0, c3, c4, c5, c7, c9, c10, c11, c14, c15, c16, c18, c20, c21, c22, c23)
        put(w, WORK + 0, i, pitch_acc1)
        put(w, WORK + 1, i, wheel_acc1)
        put(w, WORK + 2, i, yaw_acc1)
        put(w, WORK + 11, i, held_pitch)
        put(w, WORK + 12, i, held_wheel)
        put(w, WORK + 13, i, held_yaw)
        put(w, WORK + 14, i, t12)
    for i in range(count):
        pitch = get(w, 0, i)
        pitch_rate = get(w, 1, i)
        wheel_rate = get(w, 3, i)
        yaw = get(w, 4, i)
        yaw_rate = get(w, 5, i)
        h = get(w, 6, i)
        c0 = get(w, 14, i)
        c3 = get(w, 17, i)
        c4 = get(w, 18, i)
        c5 = get(w, 19, i)
        c7 = get(w, 21, i)
        c9 = get(w, 23, i)
        c10 = get(w, 24, i)
        c11 = get(w, 25, i)
        c14 = get(w, 28, i)
        c15 = get(w, 29, i)
        c16 = get(w, 30, i)
        c18 = get(w, 32, i)
        c20 = get(w, 34, i)
        c21 = get(w, 35, i)
        c22 = get(w, 36, i)
        c23 = get(w, 37, i)
        pitch_acc1 = get(w, WORK + 0, i)
        wheel_acc1 = get(w, WORK + 1, i)
        yaw_acc1 = get(w, WORK + 2, i)
        held_pitch = get(w, WORK + 11, i)
        held_wheel = get(w, WORK + 12, i)
        held_yaw = get(w, WORK + 13, i)
        t12 = get(w, WORK + 14, i)
        half = mul(h, 0.5)
        pitch2 = fma(half, pitch_rate, pitch)
        pitch_rate2 = fma(half, pitch_acc1, pitch_rate)
        wheel_rate2 = fma(half, wheel_acc1, wheel_rate)
        yaw_rate2 = fma(half, yaw_acc1, yaw_rate)
        pitch_acc2, wheel_acc2, yaw_acc2 = moved_coulomb(pitch2, pitch_rate2, wheel_rate2, yaw, yaw_rate2, held_pitch, held_wheel, held_yaw, t12, c0, c3, c4, c5, c7, c9, c10, c11, c14, c15, c16, c18, c20, c21, c22, c23)
        put(w, WORK + 3, i, pitch_acc2)
        put(w, WORK + 4, i, wheel_acc2)
        put(w, WORK + 5, i, yaw_acc2)
        put(w, WORK + 9, i, pitch_rate2)
    for i in range(count):
        pitch = get(w, 0, i)
        pitch_rate = get(w, 1, i)
        wheel_rate = get(w, 3, i)
        yaw = get(w, 4, i)
        yaw_rate = get(w, 5, i)
        h = get(w, 6, i)
        c0 = get(w, 14, i)
        c3 = get(w, 17, i)
        c4 = get(w, 18, i)
        c5 = get(w, 19, i)
        c7 = get(w, 21, i)
        c9 = get(w, 23, i)
        c10 = get(w, 24, i)
        c11 = get(w, 25, i)
        c14 = get(w, 28, i)
        c15 = get(w, 29, i)
        c16 = get(w, 30, i)
        c18 = get(w, 32, i)
        c20 = get(w, 34, i)
        c21 = get(w, 35, i)
        c22 = get(w, 36, i)
        c23 = get(w, 37, i)
        pitch_acc2 = get(w, WORK + 3, i)
        wheel_acc2 = get(w, WORK + 4, i)
        yaw_acc2 = get(w, WORK + 5, i)
        pitch_rate2 = get(w, WORK + 9, i)
        held_pitch = get(w, WORK + 11, i)
        held_wheel = get(w, WORK + 12, i)
        held_yaw = get(w, WORK + 13, i)
        t12 = get(w, WORK + 14, i)
        half = mul(h, 0.5)
        pitch3 = fma(half, pitch_rate2, pitch)
        pitch_rate3 = fma(half, pitch_acc2, pitch_rate)
        wheel_rate3 = fma(half, wheel_acc2, wheel_rate)
        yaw_rate3 = fma(half, yaw_acc2, yaw_rate)
        pitch_acc3, wheel_acc3, yaw_acc3 = moved_coulomb(pitch3, pitch_rate3, wheel_rate3, yaw, yaw_rate3, held_pitch, held_wheel, held_yaw, t12, c0, c3, c4, c5, c7, c9, c10, c11, c14, c15, c16, c18, c20, c21, c22, c23)
        put(w, WORK + 6, i, pitch_acc3)
        put(w, WORK + 7, i, wheel_acc3)
        put(w, WORK + 8, i, yaw_acc3)
        put(w, WORK + 10, i, pitch_rate3)
    for i in range(count):
        pitch = get(w, 0, i)
        pitch_rate = get(w, 1, i)
        wheel = get(w, 2, i)
        wheel_rate = get(w, 3, i)
        yaw = get(w, 4, i)
        yaw_rate = get(w, 5, i)
        h = get(w, 6, i)
        lived = get(w, 7, i)
        c0 = get(w, 14, i)
        c3 = get(w, 17, i)
        c4 = get(w, 18, i)
        c5 = get(w, 19, i)
        c7 = get(w, 21, i)
        c9 = get(w, 23, i)
        c10 = get(w, 24, i)
        c11 = get(w, 25, i)
        c14 = get(w, 28, i)
        c15 = get(w, 29, i)
        c16 = get(w, 30, i)
        c18 = get(w, 32, i)
        c20 = get(w, 34, i)
        c21 = get(w, 35, i)
        c22 = get(w, 36, i)
        c23 = get(w, 37, i)
        pitch_acc1 = get(w, WORK + 0, i)
        wheel_acc1 = get(w, WORK + 1, i)
        yaw_acc1 = get(w, WORK + 2, i)
        pitch_acc2 = get(w, WORK + 3, i)
        wheel_acc2 = get(w, WORK + 4, i)
        yaw_acc2 = get(w, WORK + 5, i)
        pitch_acc3 = get(w, WORK + 6, i)
        wheel_acc3 = get(w, WORK + 7, i)
        yaw_acc3 = get(w, WORK + 8, i)
        pitch_rate3 = get(w, WORK + 10, i)
        held_pitch = get(w, WORK + 11, i)
        held_wheel = get(w, WORK + 12, i)
        held_yaw = get(w, WORK + 13, i)
        t12 = get(w, WORK + 14, i)
        pitch4 = fma(h, pitch_rate3, pitch)
        pitch_rate4 = fma(h, pitch_acc3, pitch_rate)
        wheel_rate4 = fma(h, wheel_acc3, wheel_rate)
        yaw_rate4 = fma(h, yaw_acc3, yaw_rate)
        pitch_acc4, wheel_acc4, yaw_acc4 = moved_coulomb(pitch4, pitch_rate4, wheel_rate4, yaw, yaw_rate4, held_pitch, held_wheel, held_yaw, t12, c0, c3, c4, c5, c7, c9, c10, c11, c14, c15, c16, c18, c20, c21, c22, c23)
        sixth = mul(h, 1 / 6)
        pitch_middle = pitch_acc2 + pitch_acc3
        pitch_sum = pitch_acc1 + pitch_middle
        new_pitch = fma(h, fma(sixth, pitch_sum, pitch_rate), pitch)
        new_pitch_rate = fma(sixth, (pitch_sum + pitch_middle) + pitch_acc4, pitch_rate)
        wheel_middle = wheel_acc2 + wheel_acc3
        wheel_sum = wheel_acc1 + wheel_middle
        new_wheel = fma(h, fma(sixth, wheel_sum, wheel_rate), wheel)
        new_wheel_rate = fma(sixth, (wheel_sum + wheel_middle) + wheel_acc4, wheel_rate)
        yaw_middle = yaw_acc2 + yaw_acc3
        yaw_sum = yaw_acc1 + yaw_middle
        new_yaw = fma(h, fma(sixth, yaw_sum, yaw_rate), yaw)
        new_yaw_rate = fma(sixth, (yaw_sum + yaw_middle) + yaw_acc4, yaw_rate)
        put(w, 0, i, new_pitch)
        put(w, 1, i, new_pitch_rate)
        put(w, 2, i, new_wheel)
        put(w, 3, i, new_wheel_rate)
        put(w, 4, i, new_yaw)
        put(w, 5, i, new_yaw_rate)
        put(w, 7, i, now if positive(h) else lived)
        put(w, 6, i, h if absolute(new_pitch) <= fallen else mul(h, 0.0))



def specific_force_coulomb(w, count, out):
    for i in range(count):
        pitch = get(w, 0, i)
        pitch_rate = get(w, 1, i)
        wheel_rate = get(w, 3, i)
        yaw = get(w, 4, i)
        yaw_rate = get(w, 5, i)
        left = get(w, 8, i)
        right = get(w, 9, i)
        force = get(w, 10, i)
        moment = get(w, 11, i)
        sin_slope = get(w, 12, i)
        cos_slope = get(w, 13, i)
        c0 = get(w, 14, i)
        c1 = get(w, 15, i)
        c2 = get(w, 16, i)
        c3 = get(w, 17, i)
        c4 = get(w, 18, i)
        c5 = get(w, 19, i)
        c6 = get(w, 20, i)
        c7 = get(w, 21, i)
        c8 = get(w, 22, i)
        c9 = get(w, 23, i)
        c10 = get(w, 24, i)
        c11 = get(w, 25, i)
        c13 = get(w, 27, i)
        c14 = get(w, 28, i)
        c15 = get(w, 29, i)
        c16 = get(w, 30, i)
        c18 = get(w, 32, i)
        c19 = get(w, 33, i)
        c20 = get(w, 34, i)
        c21 = get(w, 35, i)
        c22 = get(w, 36, i)
        c23 = get(w, 37, i)
        held_pitch, held_wheel, held_yaw, t12 = held_coulomb(left, right, force, moment, sin_slope, cos_slope, c6, c8, c13, c19)
        _, wheel_acc, _ = moved_coulomb(pitch, pitch_rate, wheel_rate, yaw, yaw_rate, held_pitch, held_wheel, held_yaw, t12, c0, c3, c4, c5, c7, c9, c10, c11, c14, c15, c16, c18, c20, c21, c22, c23)
        s, c = sincos(pitch)
        t0 = c1 * wheel_acc
        t1 = t0 * c
        t2 = fma(-c2, s, t1)
        t3 = c2 * c
        t4 = fma(t0, s, t3)
        put(w, out + 0, i, t2)
        put(w, out + 1, i, t4)



@inlined
def held_slope(left, right, force, moment, sin_slope, cos_slope, c5, c6, c8, c12, c13, c17, c19):
    t3 = left + right
    t4 = c8 * t3
    held_pitch = t4
    t5 = c13 * force
    t6 = -left - right
    t7 = fma(c8, t6, t5)
    held_wheel = t7
    t8 = left - right
    t9 = c19 * t8
    held_yaw = t9
    t10 = c5 * cos_slope
    t12 = c6 * moment
    t13 = c5 * sin_slope
    t18 = c12 * sin_slope
    t23 = c17 * sin_slope
    return held_pitch, held_wheel, held_yaw, t10, t12, t13, t18, t23



@inlined
def moved_slope(pitch, pitch_rate, wheel_rate, yaw, yaw_rate, held_pitch, held_wheel, held_yaw, t10, t12, t13, t18, t23, c3, c4, c9, c10, c11, c14, c15, c16, c20, c21, c22):
    s, c = sincos(pitch)
    sin_yaw, cos_yaw = sincos_any(yaw)
    t0 = fma(c9, c, c20)
    a12 = t0
    a22 = c21
    t1 = s * s
    t2 = fma(c22, t1, 1.0)
    a33 = t2
    determinant = fma(-a12, a12, a22)
    before_0 = determinant * a33
    over = reciprocal(before_0)
    over_1 = over * determinant
    rest_1 = over * a33
    t11 = pitch_rate - wheel_rate
    t14 = c4 * s
    t15 = yaw_rate * yaw_rate
    t16 = fma(t14, t15, fma(-t13, cos_yaw, t12))
    t17 = fma(c, t16, fma(c3, t11, fma(t10, s, held_pitch)))
    t19 = pitch_rate * pitch_rate
    t20 = c9 * t19
    t21 = fma(c11, t15, t20)
    t22 = fma(t21, s, fma(c10, wheel_rate, fma(-c3, pitch_rate, fma(t18, cos_yaw, held_wheel))))
    t24 = t23 * sin_yaw
    t25 = c14 * c
    t26 = t25 * pitch_rate
    t27 = fma(c15, wheel_rate, t26)
    t28 = fma(t27, yaw_rate, t24)
    t29 = fma(t28, s, fma(c16, yaw_rate, held_yaw))
    pitch_acc = fma(-a12, t22, t17) * rest_1
    return pitch_acc, fma(-a12, pitch_acc, t22), t29 * over_1



@inlined
def accelerations_slope(pitch, pitch_rate, wheel_rate, yaw, yaw_rate, left, right, force, moment, sin_slope, cos_slope, c0, c1, c2, c3, c4, c5, c6, c7, c8, c9, c10, c11, c12, c13, c14, c15, c16, c17, c18, c19, c20, c21, c22, c23):
    held_pitch, held_wheel, held_yaw, t10, t12, t13, t18, t23 = held_slope(left, right, force, moment, sin_slope, cos_slope, c5, c6, c8, c12, c13, c17, c19)
    return moved_slope(pitch, pitch_rate, wheel_rate, yaw, yaw_rate, held_pitch, held_wheel, held_yaw, t10, t12, t13, t18, t23, c3, c4, c9, c10, c11, c14, c15, c16, c20, c21, c22)



def step_slope(w, count, fallen, now):
    i = 0
    pitch = get(w, 0, i)
    pitch_rate = get(w, 1, i)
    wheel = get(w, 2, i)
    wheel_rate = get(w, 3, i)
    yaw = get(w, 4, i)
    yaw_rate = get(w, 5, i)
    h = get(w, 6, i)
    lived = get(w, 7, i)
    left = get(w, 8, i)
    right = get(w, 9, i)
    force = get(w, 10, i)
    moment = get(w, 11, i)
    sin_slope = get(w, 12, i)
    cos_slope = get(w, 13, i)
    c3 = get(w, 17, i)
    c4 = get(w, 18, i)
    c5 = get(w, 19, i)
    c6 = get(w, 20, i)
    c8 = get(w, 22, i)
    c9 = get(w, 23, i)
    c10 = get(w, 24, i)
    c11 = get(w, 25, i)
    c12 = get(w, 26, i)
    c13 = get(w, 27, i)
    c14 = get(w, 28, i)
    c15 = get(w, 29, i)
    c16 = get(w, 30, i)
    c17 = get(w, 31, i)
    c19 = get(w, 33, i)
    c20 = get(w, 34, i)
    c21 = get(w, 35, i)
    c22 = get(w, 36, i)
    held_pitch, held_wheel, held_yaw, t10, t12, t13, t18, t23 = held_slope(left, right, force, moment, sin_slope, cos_slope, c5, c6, c8, c12, c13, c17, c19)
    pitch_acc1, wheel_acc1, yaw_acc1 = moved_slope(pitch, pitch_rate, wheel_rate, yaw, yaw_rate, held_pitch, held_wheel, held_yaw, t10, t12, t13, t18, t23, c3, c4, c9, c10, c11, c14, c15, c16, c20, c21, c22)
    half = mul(h, 0.5)
    pitch2 = fma(half, pitch_rate, pitch)
    pitch_rate2 = fma(half, pitch_acc1, pitch_rate)
    wheel_rate2 = fma(half, wheel_acc1, wheel_rate)
    yaw2 = fma(half, yaw_rate, yaw)
    yaw_rate2 = fma(half, yaw_acc1, yaw_rate)
    pitch_acc2, wheel_acc2, yaw_acc2 = moved_slope(pitch2, pitch_rate2, wheel_rate2, yaw2, yaw_rate2, held_pitch, held_wheel, held_yaw, t10, t12, t13, t18, t23, c3, c4, c9, c10, c11, c14, c15, c16, c20, c21, c22)
    pitch3 = fma(half, pitch_rate2, pitch)
    pitch_rate3 = fma(half, pitch_acc2, pitch_rate)
    wheel_rate3 = fma(half, wheel_acc2, wheel_rate)
    yaw3 = fma(half, yaw_rate2, yaw)
    yaw_rate3 = fma(half, yaw_acc2, yaw_rate)
    pitch_acc3, wheel_acc3, yaw_acc3 = moved_slope(pitch3, pitch_rate3, wheel_rate3, yaw3, yaw_rate3, held_pitch, held_wheel, held_yaw, t10, t12, t13, t18, t23, c3, c4, c9, c10, c11, c14, c15, c16, c20, c21, c22)
    pitch4 = fma(h, pitch_rate3, pitch)
    pitch_rate4 = fma(h, pitch_acc3, pitch_rate)
    wheel_rate4 = fma(h, wheel_acc3, wheel_rate)
    yaw4 = fma(h, yaw_rate3, yaw)
    yaw_rate4 = fma(h, yaw_acc3, yaw_rate)
    pitch_acc4, wheel_acc4, yaw_acc4 = moved_slope(pitch4, pitch_rate4, wheel_rate4, yaw4, yaw_rate4, held_pitch, held_wheel, held_yaw, t10, t12, t13, t18, t23, c3, c4, c9, c10, c11, c14, c15, c16, c20, c21, c22)
    sixth = mul(h, 1 / 6)
    pitch_middle = pitch_acc2 + pitch_acc3
    pitch_sum = pitch_acc1 + pitch_middle
    new_pitch = fma(h, fma(sixth, pitch_sum, pitch_rate), pitch)
    new_pitch_rate = fma(sixth, (pitch_sum + pitch_middle) + pitch_acc4, pitch_rate)
    wheel_middle = wheel_acc2 + wheel_acc3
    wheel_sum = wheel_acc1 + wheel_middle
    new_wheel = fma(h, fma(sixth, wheel_sum, wheel_rate), wheel)
    new_wheel_rate = fma(sixth, (wheel_sum + wheel_middle) + wheel_acc4, wheel_rate)
    yaw_middle = yaw_acc2 + yaw_acc3
    yaw_sum = yaw_acc1 + yaw_middle
    new_yaw = fma(h, fma(sixth, yaw_sum, yaw_rate), yaw)
    new_yaw_rate = fma(sixth, (yaw_sum + yaw_middle) + yaw_acc4, yaw_rate)
    put(w, 0, i, new_pitch)
    put(w, 1, i, new_pitch_rate)
    put(w, 2, i, new_wheel)
    put(w, 3, i, new_wheel_rate)
    put(w, 4, i, new_yaw)
    put(w, 5, i, new_yaw_rate)
    put(w, 7, i, now if positive(h) else lived)
    put(w, 6, i, h if absolute(new_pitch) <= fallen else mul(h, 0.0))



def advance_slope(w, count, fallen, now):
    align_stack()
    for i in range(count):
        pitch = get(w, 0, i)
        pitch_rate = get(w, 1, i)
        wheel_rate = get(w, 3, i)
        yaw = get(w, 4, i)
        yaw_rate = get(w, 5, i)
        left = get(w, 8, i)
        right = get(w, 9, i)
        force = get(w, 10, i)
        moment = get(w, 11, i)
        sin_slope = get(w, 12, i)
        cos_slope = get(w, 13, i)
        c3 = get(w, 17, i)
        c4 = get(w, 18, i)
        c5 = get(w, 19, i)
        c6 = get(w, 20, i)
        c8 = get(w, 22, i)
        c9 = get(w, 23, i)
        c10 = get(w, 24, i)
        c11 = get(w, 25, i)
        c12 = get(w, 26, i)
        c13 = get(w, 27, i)
        c14 = get(w, 28, i)
        c15 = get(w, 29, i)
        c16 = get(w, 30, i)
        c17 = get(w, 31, i)
        c19 = get(w, 33, i)
        c20 = get(w, 34, i)
        c21 = get(w, 35, i)
        c22 = get(w, 36, i)
        held_pitch, held_wheel, held_yaw, t10, t12, t13, t18, t23 = held_slope(left, right, force, moment, sin_slope, cos_slope, c5, c6, c8, c12, c13, c17, c19)
        pitch_acc1, wheel_acc1, yaw_acc1 = moved_slope(pitch, pitch_rate, wheel_rate, yaw, yaw_rate, held_pitch, held_wheel, held_yaw, t10, t12, t13, t18, t23, c3, c4, c9, c10, c11, c14, c15, c16, c20, c21, c22)
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
        pitch = get(w, 0, i)
        pitch_rate = get(w, 1, i)
        wheel_rate = get(w, 3, i)
        yaw = get(w, 4, i)
        yaw_rate = get(w, 5, i)
        h = get(w, 6, i)
        c3 = get(w, 17, i)
        c4 = get(w, 18, i)
        c9 = get(w, 23, i)
        c10 = get(w, 24, i)
        c11 = get(w, 25, i)
        c14 = get(w, 28, i)
        c15 = get(w, 29, i)
        c16 = get(w, 30, i)
        c20 = get(w, 34, i)
        c21 = get(w, 35, i)
        c22 = get(w, 36, i)
        pitch_acc1 = get(w, WORK + 0, i)
        wheel_acc1 = get(w, WORK + 1, i)
        yaw_acc1 = get(w, WORK + 2, i)
        held_pitch = get(w, WORK + 13, i)
        held_wheel = get(w, WORK + 14, i)
        held_yaw = get(w, WORK + 15, i)
        t10 = get(w, WORK + 16, i)
        t12 = get(w, WORK + 17, i)
        t13 = get(w, WORK + 18, i)
        t18 = get(w, WORK + 19, i)
        t23 = get(w, WORK + 20, i)
        half = mul(h, 0.5)
        pitch2 = fma(half, pitch_rate, pitch)
        pitch_rate2 = fma(half, pitch_acc1, pitch_rate)
        wheel_rate2 = fma(half, wheel_acc1, wheel_rate)
        yaw2 = fma(half, yaw_rate, yaw)
        yaw_rate2 = fma(half, yaw_acc1, yaw_rate)
        pitch_acc2, wheel_acc2, yaw_acc2 = moved_slope(pitch2, pitch_rate2, wheel_rate2, yaw2, yaw_rate2, held_pitch, held_wheel, held_yaw, t10, t12, t13, t18, t23, c3, c4, c9, c10, c11, c14, c15, c16, c20, c21, c22)
        put(w, WORK + 3, i, pitch_acc2)
        put(w, WORK + 4, i, wheel_acc2)
        put(w, WORK + 5, i, yaw_acc2)
        put(w, WORK + 9, i, pitch_rate2)
        put(w, WORK + 10, i, yaw_rate2)
    for i in range(count):
        pitch = get(w, 0, i)
        pitch_rate = get(w, 1, i)
        wheel_rate = get(w, 3, i)
        yaw = get(w, 4, i)
        yaw_rate = get(w, 5, i)
        h = get(w, 6, i)
        c3 = get(w, 17, i)
        c4 = get(w, 18, i)
        c9 = get(w, 23, i)
        c10 = get(w, 24, i)
        c11 = get(w, 25, i)
        c14 = get(w, 28, i)
        c15 = get(w, 29, i)
        c16 = get(w, 30, i)
        c20 = get(w, 34, i)
        c21 = get(w, 35, i)
        c22 = get(w, 36, i)
        pitch_acc2 = get(w, WORK + 3, i)
        wheel_acc2 = get(w, WORK + 4, i)
        yaw_acc2 = get(w, WORK + 5, i)
        pitch_rate2 = get(w, WORK + 9, i)
        yaw_rate2 = get(w, WORK + 10, i)
        held_pitch = get(w, WORK + 13, i)
        held_wheel = get(w, WORK + 14, i)
        held_yaw = get(w, WORK + 15, i)
        t10 = get(w, WORK + 16, i)
        t12 = get(w, WORK + 17, i)
        t13 = get(w, WORK + 18, i)
        t18 = get(w, WORK + 19, i)
        t23 = get(w, WORK + 20, i)
        half = mul(h, 0.5)
        pitch3 = fma(half, pitch_rate2, pitch)
        pitch_rate3 = fma(half, pitch_acc2, pitch_rate)
        wheel_rate3 = fma(half, wheel_acc2, wheel_rate)
        yaw3 = fma(half, yaw_rate2, yaw)
        yaw_rate3 = fma(half, yaw_acc2, yaw_rate)
        pitch_acc3, wheel_acc3, yaw_acc3 = moved_slope(pitch3, pitch_rate3, wheel_rate3, yaw3, yaw_rate3, held_pitch, held_wheel, held_yaw, t10, t12, t13, t18, t23, c3, c4, c9, c10, c11, c14, c15, c16, c20, c21, c22)
        put(w, WORK + 6, i, pitch_acc3)
        put(w, WORK + 7, i, wheel_acc3)
        put(w, WORK + 8, i, yaw_acc3)
        put(w, WORK + 11, i, pitch_rate3)
        put(w, WORK + 12, i, yaw_rate3)
    for i in range(count):
        pitch = get(w, 0, i)
        pitch_rate = get(w, 1, i)
        wheel = get(w, 2, i)
        wheel_rate = get(w, 3, i)
        yaw = get(w, 4, i)
        yaw_rate = get(w, 5, i)
        h = get(w, 6, i)
        lived = get(w, 7, i)
        c3 = get(w, 17, i)
        c4 = get(w, 18, i)
        c9 = get(w, 23, i)
        c10 = get(w, 24, i)
        c11 = get(w, 25, i)
        c14 = get(w, 28, i)
        c15 = get(w, 29, i)
        c16 = get(w, 30, i)
        c20 = get(w, 34, i)
        c21 = get(w, 35, i)
        c22 = get(w, 36, i)
        pitch_acc1 = get(w, WORK + 0, i)
        wheel_acc1 = get(w, WORK + 1, i)
        yaw_acc1 = get(w, WORK + 2, i)
        pitch_acc2 = get(w, WORK + 3, i)
        wheel_acc2 = get(w, WORK + 4, i)
        yaw_acc2 = get(w, WORK + 5, i)
        pitch_acc3 = get(w, WORK + 6, i)
        wheel_acc3 = get(w, WORK + 7, i)
        yaw_acc3 = get(w, WORK + 8, i)
        pitch_rate3 = get(w, WORK + 11, i)
        yaw_rate3 = get(w, WORK + 12, i)
        held_pitch = get(w, WORK + 13, i)
        held_wheel = get(w, WORK + 14, i)
        held_yaw = get(w, WORK + 15, i)
        t10 = get(w, WORK + 16, i)
        t12 = get(w, WORK + 17, i)
        t13 = get(w, WORK + 18, i)
        t18 = get(w, WORK + 19, i)
        t23 = get(w, WORK + 20, i)
        pitch4 = fma(h, pitch_rate3, pitch)
        pitch_rate4 = fma(h, pitch_acc3, pitch_rate)
        wheel_rate4 = fma(h, wheel_acc3, wheel_rate)
        yaw4 = fma(h, yaw_rate3, yaw)
        yaw_rate4 = fma(h, yaw_acc3, yaw_rate)
        pitch_acc4, wheel_acc4, yaw_acc4 = moved_slope(pitch4, pitch_rate4, wheel_rate4, yaw4, yaw_rate4, held_pitch, held_wheel, held_yaw, t10, t12, t13, t18, t23, c3, c4, c9, c10, c11, c14, c15, c16, c20, c21, c22)
        sixth = mul(h, 1 / 6)
        pitch_middle = pitch_acc2 + pitch_acc3
        pitch_sum = pitch_acc1 + pitch_middle
        new_pitch = fma(h, fma(sixth, pitch_sum, pitch_rate), pitch)
        new_pitch_rate = fma(sixth, (pitch_sum + pitch_middle) + pitch_acc4, pitch_rate)
        wheel_middle = wheel_acc2 + wheel_acc3
        wheel_sum = wheel_acc1 + wheel_middle
        new_wheel = fma(h, fma(sixth, wheel_sum, wheel_rate), wheel)
        new_wheel_rate = fma(sixth, (wheel_sum + wheel_middle) + wheel_acc4, wheel_rate)
        yaw_middle = yaw_acc2 + yaw_acc3
        yaw_sum = yaw_acc1 + yaw_middle
        new_yaw = fma(h, fma(sixth, yaw_sum, yaw_rate), yaw)
        new_yaw_rate = fma(sixth, (yaw_sum + yaw_middle) + yaw_acc4, yaw_rate)
        put(w, 0, i, new_pitch)
        put(w, 1, i, new_pitch_rate)
        put(w, 2, i, new_wheel)
        put(w, 3, i, new_wheel_rate)
        put(w, 4, i, new_yaw)
        put(w, 5, i, new_yaw_rate)
        put(w, 7, i, now if positive(h) else lived)
        put(w, 6, i, h if absolute(new_pitch) <= fallen else mul(h, 0.0))



def specific_force_slope(w, count, out):
    for i in range(count):
        pitch = get(w, 0, i)
        pitch_rate = get(w, 1, i)
        wheel_rate = get(w, 3, i)
        yaw = get(w, 4, i)
        yaw_rate = get(w, 5, i)
        left = get(w, 8, i)
        right = get(w, 9, i)
        force = get(w, 10, i)
        moment = get(w, 11, i)
        sin_slope = get(w, 12, i)
        cos_slope = get(w, 13, i)
        c1 = get(w, 15, i)
        c2 = get(w, 16, i)
        c3 = get(w, 17, i)
        c4 = get(w, 18, i)
        c5 = get(w, 19, i)
        c6 = get(w, 20, i)
        c8 = get(w, 22, i)
        c9 = get(w, 23, i)
        c10 = get(w, 24, i)
        c11 = get(w, 25, i)
        c12 = get(w, 26, i)
        c13 = get(w, 27, i)
        c14 = get(w, 28, i)
        c15 = get(w, 29, i)
        c16 = get(w, 30, i)
        c17 = get(w, 31, i)
        c19 = get(w, 33, i)
        c20 = get(w, 34, i)
        c21 = get(w, 35, i)
        c22 = get(w, 36, i)
        held_pitch, held_wheel, held_yaw, t10, t12, t13, t18, t23 = held_slope(left, right, force, moment, sin_slope, cos_slope, c5, c6, c8, c12, c13, c17, c19)
        _, wheel_acc, _ = moved_slope(pitch, pitch_rate, wheel_rate, yaw, yaw_rate, held_pitch, held_wheel, held_yaw, t10, t12, t13, t18, t23, c3, c4, c9, c10, c11, c14, c15, c16, c20, c21, c22)
        s, c = sincos(pitch)
        sin_yaw, cos_yaw = sincos_any(yaw)
        t0 = c1 * wheel_acc
        t1 = c2 * sin_slope
        t2 = fma(t1, cos_yaw, t0)
        t3 = c * t2
        t4 = c2 * cos_slope
        t5 = fma(-t4, s, t3)
        t6 = t4 * c
        t7 = fma(t2, s, t6)
        put(w, out + 0, i, t5)
        put(w, out + 1, i, t7)



@inlined
def held_coulomb_slope(left, right, force, moment, sin_slope, cos_slope, c5, c6, c8, c12, c13, c17, c19):
    t5 = left + right
    t6 = c8 * t5
    held_pitch = t6
    t7 = c13 * force
    t8 = -left - right
    t9 = fma(c8, t8, t7)
    held_wheel = t9
    t10 = left - right
    t11 = c19 * t10
    held_yaw = t11
    t12 = c5 * cos_slope
    t15 = c6 * moment
    t16 = c5 * sin_slope
    t21 = c12 * sin_slope
    t28 = c17 * sin_slope
    return held_pitch, held_wheel, held_yaw, t12, t15, t16, t21, t28



@inlined
def moved_coulomb_slope(pitch, pitch_rate, wheel_rate, yaw, yaw_rate, held_pitch, held_wheel, held_yaw, t12, t15, t16, t21, t28, c0, c3, c4, c7, c9, c10, c11, c14, c15, c16, c18, c20, c21, c22, c23):
    s, c = sincos(pitch)
    sin_yaw, cos_yaw = sincos_any(yaw)
    t0 = fma(c9, c, c20)
    a12 = t0
    a22 = c21
    t1 = s * s
    t2 = fma(c22, t1, 1.0)
    a33 = t2
    determinant = fma(-a12, a12, a22)
    t3 = fma(-c0, yaw_rate, -pitch_rate + wheel_rate)
    rate_left = t3
    root_left = sqrt(fma(rate_left, rate_left, c23))
    t4 = fma(c0, yaw_rate, -pitch_rate + wheel_rate)
    rate_right = t4
    root_right = sqrt(fma(rate_right, rate_right, c23))
    before_0 = determinant * a33
    before_1 = before_0 * root_left
    before_2 = before_1 * root_right
    over = reciprocal(before_2)
    over_3 = over * before_1
    rest_3 = over * root_right
    over_2 = rest_3 * before_0
    rest_2 = rest_3 * root_left
    over_1 = rest_2 * determinant
    rest_1 = rest_2 * a33
    slip_left = rate_left * over_2
    slip_right = rate_right * over_3
    t13 = slip_left + slip_right
    t14 = pitch_rate - wheel_rate
    t17 = c4 * s
    t18 = yaw_rate * yaw_rate
    t19 = fma(t17, t18, fma(-t16, cos_yaw, t15))
    t20 = fma(c, t19, fma(c3, t14, fma(c7, t13, fma(t12, s, held_pitch))))
    t22 = -slip_left - slip_right
    t23 = pitch_rate * pitch_rate
    t24 = c9 * t23
    t25 = fma(c11, t18, t24)
    t26 = fma(t25, s, fma(c10, wheel_rate, fma(c7, t22, fma(-c3, pitch_rate, fma(t21, cos_yaw, held_wheel)))))
    t27 = slip_left - slip_right
    t29 = t28 * sin_yaw
    t30 = c14 * c
    t31 = t30 * pitch_rate
    t32 = fma(c15, wheel_rate, t31)
    t33 = fma(t32, yaw_rate, t29)
    t34 = fma(t33, s, fma(c16, yaw_rate, fma(c18, t27, held_yaw)))
    pitch_acc = fma(-a12, t26, t20) * rest_1
    return pitch_acc, fma(-a12, pitch_acc, t26), t34 * over_1



@inlined
def accelerations_coulomb_slope(pitch, pitch_rate, wheel_rate, yaw, yaw_rate, left, right, force, moment, sin_slope, cos_slope, c0, c1, c2, c3, c4, c5, c6, c7, c8, c9, c10, c11, c12, c13, c14, c15, c16, c17, c18, c19, c20, c21, c22, c23):
    held_pitch, held_wheel, held_yaw, t12, t15, t16, t21, t28 = held_coulomb_slope(left, right, force, moment, sin_slope, cos_slope, c5, c6, c8, c12, c13, c17, c19)
    return moved_coulomb_slope(pitch, pitch_rate, wheel_rate, yaw, yaw_rate, held_pitch, held_wheel, held_yaw, t12, t15, t16, t21, t28, c0, c3, c4, c7, c9, c10, c11, c14, c15, c16, c18, c20, c21, c22, c23)



def step_coulomb_slope(w, count, fallen, now):
    i = 0
    pitch = get(w, 0, i)
    pitch_rate = get(w, 1, i)
    wheel = get(w, 2, i)
    wheel_rate = get(w, 3, i)
    yaw = get(w, 4, i)
    yaw_rate = get(w, 5, i)
    h = get(w, 6, i)
    lived = get(w, 7, i)
    left = get(w, 8, i)
    right = get(w, 9, i)
    force = get(w, 10, i)
    moment = get(w, 11, i)
    sin_slope = get(w, 12, i)
    cos_slope = get(w, 13, i)
    c0 = get(w, 14, i)
    c3 = get(w, 17, i)
    c4 = get(w, 18, i)
    c5 = get(w, 19, i)
    c6 = get(w, 20, i)
    c7 = get(w, 21, i)
    c8 = get(w, 22, i)
    c9 = get(w, 23, i)
    c10 = get(w, 24, i)
    c11 = get(w, 25, i)
    c12 = get(w, 26, i)
    c13 = get(w, 27, i)
    c14 = get(w, 28, i)
    c15 = get(w, 29, i)
    c16 = get(w, 30, i)
    c17 = get(w, 31, i)
    c18 = get(w, 32, i)
    c19 = get(w, 33, i)
    c20 = get(w, 34, i)
    c21 = get(w, 35, i)
    c22 = get(w, 36, i)
    c23 = get(w, 37, i)
    held_pitch, held_wheel, held_yaw, t12, t15, t16, t21, t28 = held_coulomb_slope(left, right, force, moment, sin_slope, cos_slope, c5, c6, c8, c12, c13, c17, c19)
    pitch_acc1, wheel_acc1, yaw_acc1 = moved_coulomb_slope(pitch, pitch_rate, wheel_rate, yaw, yaw_rate, held_pitch, held_wheel, held_yaw, t12, t15, t16, t21, t28, c0, c3, c4, c7, c9, c10, c11, c14, c15, c16, c18, c20, c21, c22, c23)
    half = mul(h, 0.5)
    pitch2 = fma(half, pitch_rate, pitch)
    pitch_rate2 = fma(half, pitch_acc1, pitch_rate)
    wheel_rate2 = fma(half, wheel_acc1, wheel_rate)
    yaw2 = fma(half, yaw_rate, yaw)
    yaw_rate2 = fma(half, yaw_acc1, yaw_rate)
    pitch_acc2, wheel_acc2, yaw_acc2 = moved_coulomb_slope(pitch2, pitch_rate2, wheel_rate2, yaw2, yaw_rate2, held_pitch, held_wheel, held_yaw, t12, t15, t16, t21, t28, c0, c3, c4, c7, c9, c10, c11, c14, c15, c16, c18, c20, c21, c22, c23)
    pitch3 = fma(half, pitch_rate2, pitch)
    pitch_rate3 = fma(half, pitch_acc2, pitch_rate)
    wheel_rate3 = fma(half, wheel_acc2, wheel_rate)
    yaw3 = fma(half, yaw_rate2, yaw)
    yaw_rate3 = fma(half, yaw_acc2, yaw_rate)
    pitch_acc3, wheel_acc3, yaw_acc3 = moved_coulomb_slope(pitch3, pitch_rate3, wheel_rate3, yaw3, yaw_rate3, held_pitch, held_wheel, held_yaw, t12, t15, t16, t21, t28, c0, c3, c4, c7, c9, c10, c11, c14, c15, c16, c18, c20, c21, c22, c23)
    pitch4 = fma(h, pitch_rate3, pitch)
    pitch_rate4 = fma(h, pitch_acc3, pitch_rate)
    wheel_rate4 = fma(h, wheel_acc3, wheel_rate)
    yaw4 = fma(h, yaw_rate3, yaw)
    yaw_rate4 = fma(h, yaw_acc3, yaw_rate)
    pitch_acc4, wheel_acc4, yaw_acc4 = moved_coulomb_slope(pitch4, pitch_rate4, wheel_rate4, yaw4, yaw_rate4, held_pitch, held_wheel, held_yaw, t12, t15, t16, t21, t28, c0, c3, c4, c7, c9, c10, c11, c14, c15, c16, c18, c20, c21, c22, c23)
    sixth = mul(h, 1 / 6)
    pitch_middle = pitch_acc2 + pitch_acc3
    pitch_sum = pitch_acc1 + pitch_middle
    new_pitch = fma(h, fma(sixth, pitch_sum, pitch_rate), pitch)
    new_pitch_rate = fma(sixth, (pitch_sum + pitch_middle) + pitch_acc4, pitch_rate)
    wheel_middle = wheel_acc2 + wheel_acc3
    wheel_sum = wheel_acc1 + wheel_middle
    new_wheel = fma(h, fma(sixth, wheel_sum, wheel_rate), wheel)
    new_wheel_rate = fma(sixth, (wheel_sum + wheel_middle) + wheel_acc4, wheel_rate)
    yaw_middle = yaw_acc2 + yaw_acc3
    yaw_sum = yaw_acc1 + yaw_middle
    new_yaw = fma(h, fma(sixth, yaw_sum, yaw_rate), yaw)
    new_yaw_rate = fma(sixth, (yaw_sum + yaw_middle) + yaw_acc4, yaw_rate)
    put(w, 0, i, new_pitch)
    put(w, 1, i, new_pitch_rate)
    put(w, 2, i, new_wheel)
    put(w, 3, i, new_wheel_rate)
    put(w, 4, i, new_yaw)
    put(w, 5, i, new_yaw_rate)
    put(w, 7, i, now if positive(h) else lived)
    put(w, 6, i, h if absolute(new_pitch) <= fallen else mul(h, 0.0))



def advance_coulomb_slope(w, count, fallen, now):
    align_stack()
    for i in range(count):
        pitch = get(w, 0, i)
        pitch_rate = get(w, 1, i)
        wheel_rate = get(w, 3, i)
        yaw = get(w, 4, i)
        yaw_rate = get(w, 5, i)
        left = get(w, 8, i)
        right = get(w, 9, i)
        force = get(w, 10, i)
        moment = get(w, 11, i)
        sin_slope = get(w, 12, i)
        cos_slope = get(w, 13, i)
        c0 = get(w, 14, i)
        c3 = get(w, 17, i)
        c4 = get(w, 18, i)
        c5 = get(w, 19, i)
        c6 = get(w, 20, i)
        c7 = get(w, 21, i)
        c8 = get(w, 22, i)
        c9 = get(w, 23, i)
        c10 = get(w, 24, i)
        c11 = get(w, 25, i)
        c12 = get(w, 26, i)
        c13 = get(w, 27, i)
        c14 = get(w, 28, i)
        c15 = get(w, 29, i)
        c16 = get(w, 30, i)
        c17 = get(w, 31, i)
        c18 = get(w, 32, i)
        c19 = get(w, 33, i)
        c20 = get(w, 34, i)
        c21 = get(w, 35, i)
        c22 = get(w, 36, i)
        c23 = get(w, 37, i)
        held_pitch, held_wheel, held_yaw, t12, t15, t16, t21, t28 = held_coulomb_slope(left, right, force, moment, sin_slope, cos_slope, c5, c6, c8, c12, c13, c17, c19)
        pitch_acc1, wheel_acc1, yaw_acc1 = moved_coulomb_slope(pitch, pitch_rate, wheel_rate, yaw, yaw_rate, held_pitch, held_wheel, held_yaw, t12, t15, t16, t21, t28, c0, c3, c4, c7, c9, c10, c11, c14, c15, c16, c18, c20, c21, c22, c23)
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
        pitch = get(w, 0, i)
        pitch_rate = get(w, 1, i)
        wheel_rate = get(w, 3, i)
        yaw = get(w, 4, i)
        yaw_rate = get(w, 5, i)
        h = get(w, 6, i)
        c0 = get(w, 14, i)
        c3 = get(w, 17, i)
        c4 = get(w, 18, i)
        c7 = get(w, 21, i)
        c9 = get(w, 23, i)
        c10 = get(w, 24, i)
        c11 = get(w, 25, i)
        c14 = get(w, 28, i)
        c15 = get(w, 29, i)
        c16 = get(w, 30, i)
        c18 = get(w, 32, i)
        c20 = get(w, 34, i)
        c21 = get(w, 35, i)
        c22 = get(w, 36, i)
        c23 = get(w, 37, i)
        pitch_acc1 = get(w, WORK + 0, i)
        wheel_acc1 = get(w, WORK + 1, i)
        yaw_acc1 = get(w, WORK + 2, i)
        held_pitch = get(w, WORK + 13, i)
        held_wheel = get(w, WORK + 14, i)
        held_yaw = get(w, WORK + 15, i)
        t12 = get(w, WORK + 16, i)
        t15 = get(w, WORK + 17, i)
        t16 = get(w, WORK + 18, i)
        t21 = get(w, WORK + 19, i)
        t28 = get(w, WORK + 20, i)
        half = mul(h, 0.5)
        pitch2 = fma(half, pitch_rate, pitch)
        pitch_rate2 = fma(half, pitch_acc1, pitch_rate)
        wheel_rate2 = fma(half, wheel_acc1, wheel_rate)
        yaw2 = fma(half, yaw_rate, yaw)
        yaw_rate2 = fma(half, yaw_acc1, yaw_rate)
        pitch_acc2, wheel_acc2, yaw_acc2 = moved_coulomb_slope(pitch2, pitch_rate2, wheel_rate2, yaw2, yaw_rate2, held_pitch, held_wheel, held_yaw, t12, t15, t16, t21, t28, c0, c3, c4, c7, c9, c10, c11, c14, c15, c16, c18, c20, c21, c22, c23)
        put(w, WORK + 3, i, pitch_acc2)
        put(w, WORK + 4, i, wheel_acc2)
        put(w, WORK + 5, i, yaw_acc2)
        put(w, WORK + 9, i, pitch_rate2)
        put(w, WORK + 10, i, yaw_rate2)
    for i in range(count):
        pitch = get(w, 0, i)
        pitch_rate = get(w, 1, i)
        wheel_rate = get(w, 3, i)
        yaw = get(w, 4, i)
        yaw_rate = get(w, 5, i)
        h = get(w, 6, i)
        c0 = get(w, 14, i)
        c3 = get(w, 17, i)
        c4 = get(w, 18, i)
        c7 = get(w, 21, i)
        c9 = get(w, 23, i)
        c10 = get(w, 24, i)
        c11 = get(w, 25, i)
        c14 = get(w, 28, i)
        c15 = get(w, 29, i)
        c16 = get(w, 30, i)
        c18 = get(w, 32, i)
        c20 = get(w, 34, i)
        c21 = get(w, 35, i)
        c22 = get(w, 36, i)
        c23 = get(w, 37, i)
        pitch_acc2 = get(w, WORK + 3, i)
        wheel_acc2 = get(w, WORK + 4, i)
        yaw_acc2 = get(w, WORK + 5, i)
        pitch_rate2 = get(w, WORK + 9, i)
        yaw_rate2 = get(w, WORK + 10, i)
        held_pitch = get(w, WORK + 13, i)
        held_wheel = get(w, WORK + 14, i)
        held_yaw = get(w, WORK + 15, i)
        t12 = get(w, WORK + 16, i)
        t15 = get(w, WORK + 17, i)
        t16 = get(w, WORK + 18, i)
        t21 = get(w, WORK + 19, i)
        t28 = get(w, WORK + 20, i)
        half = mul(h, 0.5)
        pitch3 = fma(half, pitch_rate2, pitch)
        pitch_rate3 = fma(half, pitch_acc2, pitch_rate)
        wheel_rate3 = fma(half, wheel_acc2, wheel_rate)
        yaw3 = fma(half, yaw_rate2, yaw)
        yaw_rate3 = fma(half, yaw_acc2, yaw_rate)
        pitch_acc3, wheel_acc3, yaw_acc3 = moved_coulomb_slope(pitch3, pitch_rate3, wheel_rate3, yaw3, yaw_rate3, held_pitch, held_wheel, held_yaw, t12, t15, t16, t21, t28, c0, c3, c4, c7, c9, c10, c11, c14, c15, c16, c18, c20, c21, c22, c23)
        put(w, WORK + 6, i, pitch_acc3)
        put(w, WORK + 7, i, wheel_acc3)
        put(w, WORK + 8, i, yaw_acc3)
        put(w, WORK + 11, i, pitch_rate3)
        put(w, WORK + 12, i, yaw_rate3)
    for i in range(count):
        pitch = get(w, 0, i)
        pitch_rate = get(w, 1, i)
        wheel = get(w, 2, i)
        wheel_rate = get(w, 3, i)
        yaw = get(w, 4, i)
        yaw_rate = get(w, 5, i)
        h = get(w, 6, i)
        lived = get(w, 7, i)
        c0 = get(w, 14, i)
        c3 = get(w, 17, i)
        c4 = get(w, 18, i)
        c7 = get(w, 21, i)
        c9 = get(w, 23, i)
        c10 = get(w, 24, i)
        c11 = get(w, 25, i)
        c14 = get(w, 28, i)
        c15 = get(w, 29, i)
        c16 = get(w, 30, i)
        c18 = get(w, 32, i)
        c20 = get(w, 34, i)
        c21 = get(w, 35, i)
        c22 = get(w, 36, i)
        c23 = get(w, 37, i)
        pitch_acc1 = get(w, WORK + 0, i)
        wheel_acc1 = get(w, WORK + 1, i)
        yaw_acc1 = get(w, WORK + 2, i)
        pitch_acc2 = get(w, WORK + 3, i)
        wheel_acc2 = get(w, WORK + 4, i)
        yaw_acc2 = get(w, WORK + 5, i)
        pitch_acc3 = get(w, WORK + 6, i)
        wheel_acc3 = get(w, WORK + 7, i)
        yaw_acc3 = get(w, WORK + 8, i)
        pitch_rate3 = get(w, WORK + 11, i)
        yaw_rate3 = get(w, WORK + 12, i)
        held_pitch = get(w, WORK + 13, i)
        held_wheel = get(w, WORK + 14, i)
        held_yaw = get(w, WORK + 15, i)
        t12 = get(w, WORK + 16, i)
        t15 = get(w, WORK + 17, i)
        t16 = get(w, WORK + 18, i)
        t21 = get(w, WORK + 19, i)
        t28 = get(w, WORK + 20, i)
        pitch4 = fma(h, pitch_rate3, pitch)
        pitch_rate4 = fma(h, pitch_acc3, pitch_rate)
        wheel_rate4 = fma(h, wheel_acc3, wheel_rate)
        yaw4 = fma(h, yaw_rate3, yaw)
        yaw_rate4 = fma(h, yaw_acc3, yaw_rate)
        pitch_acc4, wheel_acc4, yaw_acc4 = moved_coulomb_slope(pitch4, pitch_rate4, wheel_rate4, yaw4, yaw_rate4, held_pitch, held_wheel, held_yaw, t12, t15, t16, t21, t28, c0, c3, c4, c7, c9, c10, c11, c14, c15, c16, c18, c20, c21, c22, c23)
        sixth = mul(h, 1 / 6)
        pitch_middle = pitch_acc2 + pitch_acc3
        pitch_sum = pitch_acc1 + pitch_middle
        new_pitch = fma(h, fma(sixth, pitch_sum, pitch_rate), pitch)
        new_pitch_rate = fma(sixth, (pitch_sum + pitch_middle) + pitch_acc4, pitch_rate)
        wheel_middle = wheel_acc2 + wheel_acc3
        wheel_sum = wheel_acc1 + wheel_middle
        new_wheel = fma(h, fma(sixth, wheel_sum, wheel_rate), wheel)
        new_wheel_rate = fma(sixth, (wheel_sum + wheel_middle) + wheel_acc4, wheel_rate)
        yaw_middle = yaw_acc2 + yaw_acc3
        yaw_sum = yaw_acc1 + yaw_middle
        new_yaw = fma(h, fma(sixth, yaw_sum, yaw_rate), yaw)
        new_yaw_rate = fma(sixth, (yaw_sum + yaw_middle) + yaw_acc4, yaw_rate)
        put(w, 0, i, new_pitch)
        put(w, 1, i, new_pitch_rate)
        put(w, 2, i, new_wheel)
        put(w, 3, i, new_wheel_rate)
        put(w, 4, i, new_yaw)
        put(w, 5, i, new_yaw_rate)
        put(w, 7, i, now if positive(h) else lived)
        put(w, 6, i, h if absolute(new_pitch) <= fallen else mul(h, 0.0))



def specific_force_coulomb_slope(w, count, out):
    for i in range(count):
        pitch = get(w, 0, i)
        pitch_rate = get(w, 1, i)
        wheel_rate = get(w, 3, i)
        yaw = get(w, 4, i)
        yaw_rate = get(w, 5, i)
        left = get(w, 8, i)
        right = get(w, 9, i)
        force = get(w, 10, i)
        moment = get(w, 11, i)
        sin_slope = get(w, 12, i)
        cos_slope = get(w, 13, i)
        c0 = get(w, 14, i)
        c1 = get(w, 15, i)
        c2 = get(w, 16, i)
        c3 = get(w, 17, i)
        c4 = get(w, 18, i)
        c5 = get(w, 19, i)
        c6 = get(w, 20, i)
        c7 = get(w, 21, i)
        c8 = get(w, 22, i)
        c9 = get(w, 23, i)
        c10 = get(w, 24, i)
        c11 = get(w, 25, i)
        c12 = get(w, 26, i)
        c13 = get(w, 27, i)
        c14 = get(w, 28, i)
        c15 = get(w, 29, i)
        c16 = get(w, 30, i)
        c17 = get(w, 31, i)
        c18 = get(w, 32, i)
        c19 = get(w, 33, i)
        c20 = get(w, 34, i)
        c21 = get(w, 35, i)
        c22 = get(w, 36, i)
        c23 = get(w, 37, i)
        held_pitch, held_wheel, held_yaw, t12, t15, t16, t21, t28 = held_coulomb_slope(left, right, force, moment, sin_slope, cos_slope, c5, c6, c8, c12, c13, c17, c19)
        _, wheel_acc, _ = moved_coulomb_slope(pitch, pitch_rate, wheel_rate, yaw, yaw_rate, held_pitch, held_wheel, held_yaw, t12, t15, t16, t21, t28, c0, c3, c4, c7, c9, c10, c11, c14, c15, c16, c18, c20, c21, c22, c23)
        s, c = sincos(pitch)
        sin_yaw, cos_yaw = sincos_any(yaw)
        t0 = c1 * wheel_acc
        t1 = c2 * sin_slope
        t2 = fma(t1, cos_yaw, t0)
        t3 = c * t2
        t4 = c2 * cos_slope
        t5 = fma(-t4, s, t3)
        t6 = t4 * c
        t7 = fma(t2, s, t6)
        put(w, out + 0, i, t5)
        put(w, out + 1, i, t7)
