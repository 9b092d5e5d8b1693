# Generated from physics.dynamics: do not edit. Written again by: python -m upright.fleet.trace
# ruff: noqa
# fmt: off
# pyright: basic

from upright.fleet.generated import ROW, SIZE
from upright.fleet.kernel_jit import absolute, align_stack, fma, inlined, mul, reciprocal, rows_of, sqrt
from upright.fleet.kernel_math import sincos, sincos_any

@inlined
def accelerations_smooth(pitch, pitch_rate, wheel_rate, yaw, yaw_rate, left, right, force, moment, sin_slope, cos_slope, c0, c1, c2, c3, c4, c5, c6, c7, c8, c9, c10, c11, c12, c13, c14, c15, c16, c17, c18, c19, c20, c21, c22, c23):
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



def advance_smooth(block, count, fallen, now):
    w = rows_of(block, SIZE)
    align_stack()
    for i in range(count):
        pitch = w[0 * ROW + i]
        pitch_rate = w[1 * ROW + i]
        wheel = w[2 * ROW + i]
        wheel_rate = w[3 * ROW + i]
        yaw = w[4 * ROW + i]
        yaw_rate = w[5 * ROW + i]
        h = w[6 * ROW + i]
        lived = w[7 * ROW + i]
        left = w[8 * ROW + i]
        right = w[9 * ROW + i]
        force = w[10 * ROW + i]
        moment = w[11 * ROW + i]
        sin_slope = w[12 * ROW + i]
        cos_slope = w[13 * ROW + i]
        c0 = w[14 * ROW + i]
        c1 = w[15 * ROW + i]
        c2 = w[16 * ROW + i]
        c3 = w[17 * ROW + i]
        c4 = w[18 * ROW + i]
        c5 = w[19 * ROW + i]
        c6 = w[20 * ROW + i]
        c7 = w[21 * ROW + i]
        c8 = w[22 * ROW + i]
        c9 = w[23 * ROW + i]
        c10 = w[24 * ROW + i]
        c11 = w[25 * ROW + i]
        c12 = w[26 * ROW + i]
        c13 = w[27 * ROW + i]
        c14 = w[28 * ROW + i]
        c15 = w[29 * ROW + i]
        c16 = w[30 * ROW + i]
        c17 = w[31 * ROW + i]
        c18 = w[32 * ROW + i]
        c19 = w[33 * ROW + i]
        c20 = w[34 * ROW + i]
        c21 = w[35 * ROW + i]
        c22 = w[36 * ROW + i]
        c23 = w[37 * ROW + i]
        half, sixth = mul(h, 0.5), mul(h, 1 / 6)
        pitch_acc1, wheel_acc1, yaw_acc1 = accelerations_smooth(pitch, pitch_rate, wheel_rate, yaw, yaw_rate, left, right, force, moment, sin_slope, cos_slope, c0, c1, c2, c3, c4, c5, c6, c7, c8, c9, c10, c11, c12, c13, c14, c15, c16, c17, c18, c19, c20, c21, c22, c23)
        pitch2 = fma(half, pitch_rate, pitch)
        pitch_rate2 = fma(half, pitch_acc1, pitch_rate)
        wheel_rate2 = fma(half, wheel_acc1, wheel_rate)
        yaw_rate2 = fma(half, yaw_acc1, yaw_rate)
        pitch_acc2, wheel_acc2, yaw_acc2 = accelerations_smooth(pitch2, pitch_rate2, wheel_rate2, yaw, yaw_rate2, left, right, force, moment, sin_slope, cos_slope, c0, c1, c2, c3, c4, c5, c6, c7, c8, c9, c10, c11, c12, c13, c14, c15, c16, c17, c18, c19, c20, c21, c22, c23)
        pitch3 = fma(half, pitch_rate2, pitch)
        pitch_rate3 = fma(half, pitch_acc2, pitch_rate)
        wheel_rate3 = fma(half, wheel_acc2, wheel_rate)
        yaw_rate3 = fma(half, yaw_acc2, yaw_rate)
        pitch_acc3, wheel_acc3, yaw_acc3 = accelerations_smooth(pitch3, pitch_rate3, wheel_rate3, yaw, yaw_rate3, left, right, force, moment, sin_slope, cos_slope, c0, c1, c2, c3, c4, c5, c6, c7, c8, c9, c10, c11, c12, c13, c14, c15, c16, c17, c18, c19, c20, c21, c22, c23)
        pitch4 = fma(h, pitch_rate3, pitch)
        pitch_rate4 = fma(h, pitch_acc3, pitch_rate)
        wheel_rate4 = fma(h, wheel_acc3, wheel_rate)
        yaw_rate4 = fma(h, yaw_acc3, yaw_rate)
        pitch_acc4, wheel_acc4, yaw_acc4 = accelerations_smooth(pitch4, pitch_rate4, wheel_rate4, yaw, yaw_rate4, left, right, force, moment, sin_slope, cos_slope, c0, c1, c2, c3, c4, c5, c6, c7, c8, c9, c10, c11, c12, c13, c14, c15, c16, c17, c18, c19, c20, c21, c22, c23)
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
        w[0 * ROW + i] = new_pitch
        w[1 * ROW + i] = new_pitch_rate
        w[2 * ROW + i] = new_wheel
        w[3 * ROW + i] = new_wheel_rate
        w[4 * ROW + i] = new_yaw
        w[5 * ROW + i] = new_yaw_rate
        w[7 * ROW + i] = now if h > 0 else lived
        w[6 * ROW + i] = h if absolute(new_pitch) <= fallen else mul(h, 0.0)



def specific_force_smooth(block, count, out):
    w = rows_of(block, SIZE)
    for i in range(count):
        pitch = w[0 * ROW + i]
        pitch_rate = w[1 * ROW + i]
        wheel = w[2 * ROW + i]
        wheel_rate = w[3 * ROW + i]
        yaw = w[4 * ROW + i]
        yaw_rate = w[5 * ROW + i]
        h = w[6 * ROW + i]
        lived = w[7 * ROW + i]
        left = w[8 * ROW + i]
        right = w[9 * ROW + i]
        force = w[10 * ROW + i]
        moment = w[11 * ROW + i]
        sin_slope = w[12 * ROW + i]
        cos_slope = w[13 * ROW + i]
        c0 = w[14 * ROW + i]
        c1 = w[15 * ROW + i]
        c2 = w[16 * ROW + i]
        c3 = w[17 * ROW + i]
        c4 = w[18 * ROW + i]
        c5 = w[19 * ROW + i]
        c6 = w[20 * ROW + i]
        c7 = w[21 * ROW + i]
        c8 = w[22 * ROW + i]
        c9 = w[23 * ROW + i]
        c10 = w[24 * ROW + i]
        c11 = w[25 * ROW + i]
        c12 = w[26 * ROW + i]
        c13 = w[27 * ROW + i]
        c14 = w[28 * ROW + i]
        c15 = w[29 * ROW + i]
        c16 = w[30 * ROW + i]
        c17 = w[31 * ROW + i]
        c18 = w[32 * ROW + i]
        c19 = w[33 * ROW + i]
        c20 = w[34 * ROW + i]
        c21 = w[35 * ROW + i]
        c22 = w[36 * ROW + i]
        c23 = w[37 * ROW + i]
        _, wheel_acc, _ = accelerations_smooth(pitch, pitch_rate, wheel_rate, yaw, yaw_rate, left, right, force, moment, sin_slope, cos_slope, c0, c1, c2, c3, c4, c5, c6, c7, c8, c9, c10, c11, c12, c13, c14, c15, c16, c17, c18, c19, c20, c21, c22, c23)
        s, c = sincos(pitch)
        t0 = c1 * wheel_acc
        t1 = t0 * c
        t2 = fma(-c2, s, t1)
        t3 = c2 * c
        t4 = fma(t0, s, t3)
        w[(out + 0) * ROW + i] = t2
        w[(out + 1) * ROW + i] = t4



@inlined
def accelerations_coulomb(pitch, pitch_rate, wheel_rate, yaw, yaw_rate, left, right, force, moment, sin_slope, cos_slope, c0, c1, c2, c3, c4, c5, c6, c7, c8, c9, c10, c11, c12, c13, c14, c15, c16, c17, c18, c19, c20, c21, c22, c23):
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



def advance_coulomb(block, count, fallen, now):
    w = rows_of(block, SIZE)
    align_stack()
    for i in range(count):
        pitch = w[0 * ROW + i]
        pitch_rate = w[1 * ROW + i]
        wheel = w[2 * ROW + i]
        wheel_rate = w[3 * ROW + i]
        yaw = w[4 * ROW + i]
        yaw_rate = w[5 * ROW + i]
        h = w[6 * ROW + i]
        lived = w[7 * ROW + i]
        left = w[8 * ROW + i]
        right = w[9 * ROW + i]
        force = w[10 * ROW + i]
        moment = w[11 * ROW + i]
        sin_slope = w[12 * ROW + i]
        cos_slope = w[13 * ROW + i]
        c0 = w[14 * ROW + i]
        c1 = w[15 * ROW + i]
        c2 = w[16 * ROW + i]
        c3 = w[17 * ROW + i]
        c4 = w[18 * ROW + i]
        c5 = w[19 * ROW + i]
        c6 = w[20 * ROW + i]
        c7 = w[21 * ROW + i]
        c8 = w[22 * ROW + i]
        c9 = w[23 * ROW + i]
        c10 = w[24 * ROW + i]
        c11 = w[25 * ROW + i]
        c12 = w[26 * ROW + i]
        c13 = w[27 * ROW + i]
        c14 = w[28 * ROW + i]
        c15 = w[29 * ROW + i]
        c16 = w[30 * ROW + i]
        c17 = w[31 * ROW + i]
        c18 = w[32 * ROW + i]
        c19 = w[33 * ROW + i]
        c20 = w[34 * ROW + i]
        c21 = w[35 * ROW + i]
        c22 = w[36 * ROW + i]
        c23 = w[37 * ROW + i]
        half, sixth = mul(h, 0.5), mul(h, 1 / 6)
        pitch_acc1, wheel_acc1, yaw_acc1 = accelerations_coulomb(pitch, pitch_rate, wheel_rate, yaw, yaw_rate, left, right, force, moment, sin_slope, cos_slope, c0, c1, c2, c3, c4, c5, c6, c7, c8, c9, c10, c11, c12, c13, c14, c15, c16, c17, c18, c19, c20, c21, c22, c23)
        pitch2 = fma(half, pitch_rate, pitch)
        pitch_rate2 = fma(half, pitch_acc1, pitch_rate)
        wheel_rate2 = fma(half, wheel_acc1, wheel_rate)
        yaw_rate2 = fma(half, yaw_acc1, yaw_rate)
        pitch_acc2, wheel_acc2, yaw_acc2 = accelerations_coulomb(pitch2, pitch_rate2, wheel_rate2, yaw, yaw_rate2, left, right, force, moment, sin_slope, cos_slope, c0, c1, c2, c3, c4, c5, c6, c7, c8, c9, c10, c11, c12, c13, c14, c15, c16, c17, c18, c19, c20, c21, c22, c23)
        pitch3 = fma(half, pitch_rate2, pitch)
        pitch_rate3 = fma(half, pitch_acc2, pitch_rate)
        wheel_rate3 = fma(half, wheel_acc2, wheel_rate)
        yaw_rate3 = fma(half, yaw_acc2, yaw_rate)
        pitch_acc3, wheel_acc3, yaw_acc3 = accelerations_coulomb(pitch3, pitch_rate3, wheel_rate3, yaw, yaw_rate3, left, right, force, moment, sin_slope, cos_slope, c0, c1, c2, c3, c4, c5, c6, c7, c8, c9, c10, c11, c12, c13, c14, c15, c16, c17, c18, c19, c20, c21, c22, c23)
        pitch4 = fma(h, pitch_rate3, pitch)
        pitch_rate4 = fma(h, pitch_acc3, pitch_rate)
        wheel_rate4 = fma(h, wheel_acc3, wheel_rate)
        yaw_rate4 = fma(h, yaw_acc3, yaw_rate)
        pitch_acc4, wheel_acc4, yaw_acc4 = accelerations_coulomb(pitch4, pitch_rate4, wheel_rate4, yaw, yaw_rate4, left, right, force, moment, sin_slope, cos_slope, c0, c1, c2, c3, c4, c5, c6, c7, c8, c9, c10, c11, c12, c13, c14, c15, c16, c17, c18, c19, c20, c21, c22, c23)
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
        w[0 * ROW + i] = new_pitch
        w[1 * ROW + i] = new_pitch_rate
        w[2 * ROW + i] = new_wheel
        w[3 * ROW + i] = new_wheel_rate
        w[4 * ROW + i] = new_yaw
        w[5 * ROW + i] = new_yaw_rate
        w[7 * ROW + i] = now if h > 0 else lived
        w[6 * ROW + i] = h if absolute(new_pitch) <= fallen else mul(h, 0.0)



def specific_force_coulomb(block, count, out):
    w = rows_of(block, SIZE)
    for i in range(count):
        pitch = w[0 * ROW + i]
        pitch_rate = w[1 * ROW + i]
        wheel = w[2 * ROW + i]
        wheel_rate = w[3 * ROW + i]
        yaw = w[4 * ROW + i]
        yaw_rate = w[5 * ROW + i]
        h = w[6 * ROW + i]
        lived = w[7 * ROW + i]
        left = w[8 * ROW + i]
        right = w[9 * ROW + i]
        force = w[10 * ROW + i]
        moment = w[11 * ROW + i]
        sin_slope = w[12 * ROW + i]
        cos_slope = w[13 * ROW + i]
        c0 = w[14 * ROW + i]
        c1 = w[15 * ROW + i]
        c2 = w[16 * ROW + i]
        c3 = w[17 * ROW + i]
        c4 = w[18 * ROW + i]
        c5 = w[19 * ROW + i]
        c6 = w[20 * ROW + i]
        c7 = w[21 * ROW + i]
        c8 = w[22 * ROW + i]
        c9 = w[23 * ROW + i]
        c10 = w[24 * ROW + i]
        c11 = w[25 * ROW + i]
        c12 = w[26 * ROW + i]
        c13 = w[27 * ROW + i]
        c14 = w[28 * ROW + i]
        c15 = w[29 * ROW + i]
        c16 = w[30 * ROW + i]
        c17 = w[31 * ROW + i]
        c18 = w[32 * ROW + i]
        c19 = w[33 * ROW + i]
        c20 = w[34 * ROW + i]
        c21 = w[35 * ROW + i]
        c22 = w[36 * ROW + i]
        c23 = w[37 * ROW + i]
        _, wheel_acc, _ = accelerations_coulomb(pitch, pitch_rate, wheel_rate, yaw, yaw_rate, left, right, force, moment, sin_slope, cos_slope, c0, c1, c2, c3, c4, c5, c6, c7, c8, c9, c10, c11, c12, c13, c14, c15, c16, c17, c18, c19, c20, c21, c22, c23)
        s, c = sincos(pitch)
        t0 = c1 * wheel_acc
        t1 = t0 * c
        t2 = fma(-c2, s, t1)
        t3 = c2 * c
        t4 = fma(t0, s, t3)
        w[(out + 0) * ROW + i] = t2
        w[(out + 1) * ROW + i] = t4



@inlined
def accelerations_slope(pitch, pitch_rate, wheel_rate, yaw, yaw_rate, left, right, force, moment, sin_slope, cos_slope, c0, c1, c2, c3, c4, c5, c6, c7, c8, c9, c10, c11, c12, c13, c14, c15, c16, c17, c18, c19, c20, c21, c22, c23):
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
    t11 = pitch_rate - wheel_rate
    t12 = c6 * moment
    t13 = c5 * sin_slope
    t14 = c4 * s
    t15 = yaw_rate * yaw_rate
    t16 = fma(t14, t15, fma(-t13, cos_yaw, t12))
    t17 = fma(c, t16, fma(c3, t11, fma(t10, s, held_pitch)))
    t18 = c12 * sin_slope
    t19 = pitch_rate * pitch_rate
    t20 = c9 * t19
    t21 = fma(c11, t15, t20)
    t22 = fma(t21, s, fma(c10, wheel_rate, fma(-c3, pitch_rate, fma(t18, cos_yaw, held_wheel))))
    t23 = c17 * sin_slope
    t24 = t23 * sin_yaw
    t25 = c14 * c
    t26 = t25 * pitch_rate
    t27 = fma(c15, wheel_rate, t26)
    t28 = fma(t27, yaw_rate, t24)
    t29 = fma(t28, s, fma(c16, yaw_rate, held_yaw))
    pitch_acc = fma(-a12, t22, t17) * rest_1
    return pitch_acc, fma(-a12, pitch_acc, t22), t29 * over_1



def advance_slope(block, count, fallen, now):
    w = rows_of(block, SIZE)
    align_stack()
    for i in range(count):
        pitch = w[0 * ROW + i]
        pitch_rate = w[1 * ROW + i]
        wheel = w[2 * ROW + i]
        wheel_rate = w[3 * ROW + i]
        yaw = w[4 * ROW + i]
        yaw_rate = w[5 * ROW + i]
        h = w[6 * ROW + i]
        lived = w[7 * ROW + i]
        left = w[8 * ROW + i]
        right = w[9 * ROW + i]
        force = w[10 * ROW + i]
        moment = w[11 * ROW + i]
        sin_slope = w[12 * ROW + i]
        cos_slope = w[13 * ROW + i]
        c0 = w[14 * ROW + i]
        c1 = w[15 * ROW + i]
        c2 = w[16 * ROW + i]
        c3 = w[17 * ROW + i]
        c4 = w[18 * ROW + i]
        c5 = w[19 * ROW + i]
        c6 = w[20 * ROW + i]
        c7 = w[21 * ROW + i]
        c8 = w[22 * ROW + i]
        c9 = w[23 * ROW + i]
        c10 = w[24 * ROW + i]
        c11 = w[25 * ROW + i]
        c12 = w[26 * ROW + i]
        c13 = w[27 * ROW + i]
        c14 = w[28 * ROW + i]
        c15 = w[29 * ROW + i]
        c16 = w[30 * ROW + i]
        c17 = w[31 * ROW + i]
        c18 = w[32 * ROW + i]
        c19 = w[33 * ROW + i]
        c20 = w[34 * ROW + i]
        c21 = w[35 * ROW + i]
        c22 = w[36 * ROW + i]
        c23 = w[37 * ROW + i]
        half, sixth = mul(h, 0.5), mul(h, 1 / 6)
        pitch_acc1, wheel_acc1, yaw_acc1 = accelerations_slope(pitch, pitch_rate, wheel_rate, yaw, yaw_rate, left, right, force, moment, sin_slope, cos_slope, c0, c1, c2, c3, c4, c5, c6, c7, c8, c9, c10, c11, c12, c13, c14, c15, c16, c17, c18, c19, c20, c21, c22, c23)
        pitch2 = fma(half, pitch_rate, pitch)
        pitch_rate2 = fma(half, pitch_acc1, pitch_rate)
        wheel_rate2 = fma(half, wheel_acc1, wheel_rate)
        yaw2 = fma(half, yaw_rate, yaw)
        yaw_rate2 = fma(half, yaw_acc1, yaw_rate)
        pitch_acc2, wheel_acc2, yaw_acc2 = accelerations_slope(pitch2, pitch_rate2, wheel_rate2, yaw2, yaw_rate2, left, right, force, moment, sin_slope, cos_slope, c0, c1, c2, c3, c4, c5, c6, c7, c8, c9, c10, c11, c12, c13, c14, c15, c16, c17, c18, c19, c20, c21, c22, c23)
        pitch3 = fma(half, pitch_rate2, pitch)
        pitch_rate3 = fma(half, pitch_acc2, pitch_rate)
        wheel_rate3 = fma(half, wheel_acc2, wheel_rate)
        yaw3 = fma(half, yaw_rate2, yaw)
        yaw_rate3 = fma(half, yaw_acc2, yaw_rate)
        pitch_acc3, wheel_acc3, yaw_acc3 = accelerations_slope(pitch3, pitch_rate3, wheel_rate3, yaw3, yaw_rate3, left, right, force, moment, sin_slope, cos_slope, c0, c1, c2, c3, c4, c5, c6, c7, c8, c9, c10, c11, c12, c13, c14, c15, c16, c17, c18, c19, c20, c21, c22, c23)
        pitch4 = fma(h, pitch_rate3, pitch)
        pitch_rate4 = fma(h, pitch_acc3, pitch_rate)
        wheel_rate4 = fma(h, wheel_acc3, wheel_rate)
        yaw4 = fma(h, yaw_rate3, yaw)
        yaw_rate4 = fma(h, yaw_acc3, yaw_rate)
        pitch_acc4, wheel_acc4, yaw_acc4 = accelerations_slope(pitch4, pitch_rate4, wheel_rate4, yaw4, yaw_rate4, left, right, force, moment, sin_slope, cos_slope, c0, c1, c2, c3, c4, c5, c6, c7, c8, c9, c10, c11, c12, c13, c14, c15, c16, c17, c18, c19, c20, c21, c22, c23)
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
        w[0 * ROW + i] = new_pitch
        w[1 * ROW + i] = new_pitch_rate
        w[2 * ROW + i] = new_wheel
        w[3 * ROW + i] = new_wheel_rate
        w[4 * ROW + i] = new_yaw
        w[5 * ROW + i] = new_yaw_rate
        w[7 * ROW + i] = now if h > 0 else lived
        w[6 * ROW + i] = h if absolute(new_pitch) <= fallen else mul(h, 0.0)



def specific_force_slope(block, count, out):
    w = rows_of(block, SIZE)
    for i in range(count):
        pitch = w[0 * ROW + i]
        pitch_rate = w[1 * ROW + i]
        wheel = w[2 * ROW + i]
        wheel_rate = w[3 * ROW + i]
        yaw = w[4 * ROW + i]
        yaw_rate = w[5 * ROW + i]
        h = w[6 * ROW + i]
        lived = w[7 * ROW + i]
        left = w[8 * ROW + i]
        right = w[9 * ROW + i]
        force = w[10 * ROW + i]
        moment = w[11 * ROW + i]
        sin_slope = w[12 * ROW + i]
        cos_slope = w[13 * ROW + i]
        c0 = w[14 * ROW + i]
        c1 = w[15 * ROW + i]
        c2 = w[16 * ROW + i]
        c3 = w[17 * ROW + i]
        c4 = w[18 * ROW + i]
        c5 = w[19 * ROW + i]
        c6 = w[20 * ROW + i]
        c7 = w[21 * ROW + i]
        c8 = w[22 * ROW + i]
        c9 = w[23 * ROW + i]
        c10 = w[24 * ROW + i]
        c11 = w[25 * ROW + i]
        c12 = w[26 * ROW + i]
        c13 = w[27 * ROW + i]
        c14 = w[28 * ROW + i]
        c15 = w[29 * ROW + i]
        c16 = w[30 * ROW + i]
        c17 = w[31 * ROW + i]
        c18 = w[32 * ROW + i]
        c19 = w[33 * ROW + i]
        c20 = w[34 * ROW + i]
        c21 = w[35 * ROW + i]
        c22 = w[36 * ROW + i]
        c23 = w[37 * ROW + i]
        _, wheel_acc, _ = accelerations_slope(pitch, pitch_rate, wheel_rate, yaw, yaw_rate, left, right, force, moment, sin_slope, cos_slope, c0, c1, c2, c3, c4, c5, c6, c7, c8, c9, c10, c11, c12, c13, c14, c15, c16, c17, c18, c19, c20, c21, c22, c23)
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
        w[(out + 0) * ROW + i] = t5
        w[(out + 1) * ROW + i] = t7



@inlined
def accelerations_coulomb_slope(pitch, pitch_rate, wheel_rate, yaw, yaw_rate, left, right, force, moment, sin_slope, cos_slope, c0, c1, c2, c3, c4, c5, c6, c7, c8, c9, c10, c11, c12, c13, c14, c15, c16, c17, c18, c19, c20, c21, c22, c23):
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
    t13 = slip_left + slip_right
    t14 = pitch_rate - wheel_rate
    t15 = c6 * moment
    t16 = c5 * sin_slope
    t17 = c4 * s
    t18 = yaw_rate * yaw_rate
    t19 = fma(t17, t18, fma(-t16, cos_yaw, t15))
    t20 = fma(c, t19, fma(c3, t14, fma(c7, t13, fma(t12, s, held_pitch))))
    t21 = c12 * sin_slope
    t22 = -slip_left - slip_right
    t23 = pitch_rate * pitch_rate
    t24 = c9 * t23
    t25 = fma(c11, t18, t24)
    t26 = fma(t25, s, fma(c10, wheel_rate, fma(c7, t22, fma(-c3, pitch_rate, fma(t21, cos_yaw, held_wheel)))))
    t27 = slip_left - slip_right
    t28 = c17 * sin_slope
    t29 = t28 * sin_yaw
    t30 = c14 * c
    t31 = t30 * pitch_rate
    t32 = fma(c15, wheel_rate, t31)
    t33 = fma(t32, yaw_rate, t29)
    t34 = fma(t33, s, fma(c16, yaw_rate, fma(c18, t27, held_yaw)))
    pitch_acc = fma(-a12, t26, t20) * rest_1
    return pitch_acc, fma(-a12, pitch_acc, t26), t34 * over_1



def advance_coulomb_slope(block, count, fallen, now):
    w = rows_of(block, SIZE)
    align_stack()
    for i in range(count):
        pitch = w[0 * ROW + i]
        pitch_rate = w[1 * ROW + i]
        wheel = w[2 * ROW + i]
        wheel_rate = w[3 * ROW + i]
        yaw = w[4 * ROW + i]
        yaw_rate = w[5 * ROW + i]
        h = w[6 * ROW + i]
        lived = w[7 * ROW + i]
        left = w[8 * ROW + i]
        right = w[9 * ROW + i]
        force = w[10 * ROW + i]
        moment = w[11 * ROW + i]
        sin_slope = w[12 * ROW + i]
        cos_slope = w[13 * ROW + i]
        c0 = w[14 * ROW + i]
        c1 = w[15 * ROW + i]
        c2 = w[16 * ROW + i]
        c3 = w[17 * ROW + i]
        c4 = w[18 * ROW + i]
        c5 = w[19 * ROW + i]
        c6 = w[20 * ROW + i]
        c7 = w[21 * ROW + i]
        c8 = w[22 * ROW + i]
        c9 = w[23 * ROW + i]
        c10 = w[24 * ROW + i]
        c11 = w[25 * ROW + i]
        c12 = w[26 * ROW + i]
        c13 = w[27 * ROW + i]
        c14 = w[28 * ROW + i]
        c15 = w[29 * ROW + i]
        c16 = w[30 * ROW + i]
        c17 = w[31 * ROW + i]
        c18 = w[32 * ROW + i]
        c19 = w[33 * ROW + i]
        c20 = w[34 * ROW + i]
        c21 = w[35 * ROW + i]
        c22 = w[36 * ROW + i]
        c23 = w[37 * ROW + i]
        half, sixth = mul(h, 0.5), mul(h, 1 / 6)
        pitch_acc1, wheel_acc1, yaw_acc1 = accelerations_coulomb_slope(pitch, pitch_rate, wheel_rate, yaw, yaw_rate, left, right, force, moment, sin_slope, cos_slope, c0, c1, c2, c3, c4, c5, c6, c7, c8, c9, c10, c11, c12, c13, c14, c15, c16, c17, c18, c19, c20, c21, c22, c23)
        pitch2 = fma(half, pitch_rate, pitch)
        pitch_rate2 = fma(half, pitch_acc1, pitch_rate)
        wheel_rate2 = fma(half, wheel_acc1, wheel_rate)
        yaw2 = fma(half, yaw_rate, yaw)
        yaw_rate2 = fma(half, yaw_acc1, yaw_rate)
        pitch_acc2, wheel_acc2, yaw_acc2 = accelerations_coulomb_slope(pitch2, pitch_rate2, wheel_rate2, yaw2, yaw_rate2, left, right, force, moment, sin_slope, cos_slope, c0, c1, c2, c3, c4, c5, c6, c7, c8, c9, c10, c11, c12, c13, c14, c15, c16, c17, c18, c19, c20, c21, c22, c23)
        pitch3 = fma(half, pitch_rate2, pitch)
        pitch_rate3 = fma(half, pitch_acc2, pitch_rate)
        wheel_rate3 = fma(half, wheel_acc2, wheel_rate)
        yaw3 = fma(half, yaw_rate2, yaw)
        yaw_rate3 = fma(half, yaw_acc2, yaw_rate)
        pitch_acc3, wheel_acc3, yaw_acc3 = accelerations_coulomb_slope(pitch3, pitch_rate3, wheel_rate3, yaw3, yaw_rate3, left, right, force, moment, sin_slope, cos_slope, c0, c1, c2, c3, c4, c5, c6, c7, c8, c9, c10, c11, c12, c13, c14, c15, c16, c17, c18, c19, c20, c21, c22, c23)
        pitch4 = fma(h, pitch_rate3, pitch)
        pitch_rate4 = fma(h, pitch_acc3, pitch_rate)
        wheel_rate4 = fma(h, wheel_acc3, wheel_rate)
        yaw4 = fma(h, yaw_rate3, yaw)
        yaw_rate4 = fma(h, yaw_acc3, yaw_rate)
        pitch_acc4, wheel_acc4, yaw_acc4 = accelerations_coulomb_slope(pitch4, pitch_rate4, wheel_rate4, yaw4, yaw_rate4, left, right, force, moment, sin_slope, cos_slope, c0, c1, c2, c3, c4, c5, c6, c7, c8, c9, c10, c11, c12, c13, c14, c15, c16, c17, c18, c19, c20, c21, c22, c23)
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
        w[0 * ROW + i] = new_pitch
        w[1 * ROW + i] = new_pitch_rate
        w[2 * ROW + i] = new_wheel
        w[3 * ROW + i] = new_wheel_rate
        w[4 * ROW + i] = new_yaw
        w[5 * ROW + i] = new_yaw_rate
        w[7 * ROW + i] = now if h > 0 else lived
        w[6 * ROW + i] = h if absolute(new_pitch) <= fallen else mul(h, 0.0)



def specific_force_coulomb_slope(block, count, out):
    w = rows_of(block, SIZE)
    for i in range(count):
        pitch = w[0 * ROW + i]
        pitch_rate = w[1 * ROW + i]
        wheel = w[2 * ROW + i]
        wheel_rate = w[3 * ROW + i]
        yaw = w[4 * ROW + i]
        yaw_rate = w[5 * ROW + i]
        h = w[6 * ROW + i]
        lived = w[7 * ROW + i]
        left = w[8 * ROW + i]
        right = w[9 * ROW + i]
        force = w[10 * ROW + i]
        moment = w[11 * ROW + i]
        sin_slope = w[12 * ROW + i]
        cos_slope = w[13 * ROW + i]
        c0 = w[14 * ROW + i]
        c1 = w[15 * ROW + i]
        c2 = w[16 * ROW + i]
        c3 = w[17 * ROW + i]
        c4 = w[18 * ROW + i]
        c5 = w[19 * ROW + i]
        c6 = w[20 * ROW + i]
        c7 = w[21 * ROW + i]
        c8 = w[22 * ROW + i]
        c9 = w[23 * ROW + i]
        c10 = w[24 * ROW + i]
        c11 = w[25 * ROW + i]
        c12 = w[26 * ROW + i]
        c13 = w[27 * ROW + i]
        c14 = w[28 * ROW + i]
        c15 = w[29 * ROW + i]
        c16 = w[30 * ROW + i]
        c17 = w[31 * ROW + i]
        c18 = w[32 * ROW + i]
        c19 = w[33 * ROW + i]
        c20 = w[34 * ROW + i]
        c21 = w[35 * ROW + i]
        c22 = w[36 * ROW + i]
        c23 = w[37 * ROW + i]
        _, wheel_acc, _ = accelerations_coulomb_slope(pitch, pitch_rate, wheel_rate, yaw, yaw_rate, left, right, force, moment, sin_slope, cos_slope, c0, c1, c2, c3, c4, c5, c6, c7, c8, c9, c10, c11, c12, c13, c14, c15, c16, c17, c18, c19, c20, c21, c22, c23)
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
        w[(out + 0) * ROW + i] = t5
        w[(out + 1) * ROW + i] = t7
