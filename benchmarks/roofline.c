/* The roofline of benchmarks/fleet.py: the same closed loop as the kernel's bare loop, written by hand for SIMD.
 *
 * Blocks of LANES robots as structures of arrays, each robot with its own constants; state feedback held over `stride`
 * steps of the classical Runge-Kutta method. Compiled with -O3 -march=native -ffast-math -mprefer-vector-width=512.
 * The constants are those of upright.compiled.generated, chosen by name in fleet.py.
 */
#include <math.h>
#include <string.h>

#ifndef LANES
#define LANES 64
#endif

typedef double real;
typedef struct { real pitch, wheel, yaw; } accelerations;

enum { MOTOR_DAMPING, CENTRIFUGAL, WEIGHT, MOTOR_TORQUE, LEVER, ROLLING_DAMPING, TURNING_LEVER, YAW_CORIOLIS, YAW_LEVER,
       YAW_DAMPING, YAW_MOTOR_TORQUE, ROTOR_COUPLING, PITCH_INERTIA, YAW_SWING, CONSTANTS };

static inline real sine(real x, real z)
{
    return x + x * z * (-0.16666666666666644 + z * (0.008333333333324111 + z * (-0.00019841269835503347 + z *
        (2.7557317871404647e-06 + z * (-2.5051957219467882e-08 + z * (1.605036165533037e-10 + z * -7.399223452318581e-13))))));
}

static inline real cosine(real z)
{
    return 1 + z * (-0.5 + z * (0.04166666666666665 + z * (-0.0013888888888883752 + z * (2.480158729837543e-05 + z *
        (-2.755731847067295e-07 + z * (2.0876672808453326e-09 + z * (-1.1465911985580485e-11 + z * 4.641514219343068e-14)))))));
}

#define C(name) c[name][i]

static inline accelerations motion(real pitch, real pitch_rate, real wheel_rate, real yaw_rate, real drive, real turn,
                                   real (*restrict c)[LANES], int i)
{
    real z = pitch * pitch, s = sine(pitch, z), cs = cosine(z);
    real a12 = C(LEVER) * cs - C(ROTOR_COUPLING), a33 = 1 + C(YAW_SWING) * s * s, det = C(PITCH_INERTIA) - a12 * a12;
    real over = 1 / (det * a33), spin = yaw_rate * yaw_rate;
    real torque = drive + C(MOTOR_DAMPING) * pitch_rate;
    real wheel = torque - C(ROLLING_DAMPING) * wheel_rate + s * (C(LEVER) * pitch_rate * pitch_rate + C(TURNING_LEVER) * spin);
    real lean = C(MOTOR_DAMPING) * wheel_rate - torque + s * (C(WEIGHT) + C(CENTRIFUGAL) * spin * cs);
    real yaw = turn - yaw_rate * (C(YAW_DAMPING) + s * (C(YAW_CORIOLIS) * pitch_rate * cs + C(YAW_LEVER) * wheel_rate));
    accelerations a;
    a.pitch = (lean - a12 * wheel) * (over * a33);
    a.wheel = wheel - a12 * a.pitch;
    a.yaw = yaw * (over * det);
    return a;
}

static void advance(real (*restrict x)[LANES], real (*restrict c)[LANES], real (*restrict u)[LANES], real h)
{
    const real half = h / 2, sixth = h / 6;
    for (int i = 0; i < LANES; i++) {
        real p = x[0][i], dp = x[1][i], dw = x[3][i], dy = x[5][i];
        real drive = C(MOTOR_TORQUE) * (u[0][i] + u[1][i]), turn = C(YAW_MOTOR_TORQUE) * (u[1][i] - u[0][i]);
        accelerations k1 = motion(p, dp, dw, dy, drive, turn, c, i);
        real dp2 = dp + half * k1.pitch;
        accelerations k2 = motion(p + half * dp, dp2, dw + half * k1.wheel, dy + half * k1.yaw, drive, turn, c, i);
        real dp3 = dp + half * k2.pitch;
        accelerations k3 = motion(p + half * dp2, dp3, dw + half * k2.wheel, dy + half * k2.yaw, drive, turn, c, i);
        accelerations k4 = motion(p + h * dp3, dp + h * k3.pitch, dw + h * k3.wheel, dy + h * k3.yaw, drive, turn, c, i);
#define MOVE(angle, rate, of)                                                    \
    {                                                                            \
        real middle = k2.of + k3.of, sum = k1.of + middle;                       \
        x[angle][i] += h * (x[rate][i] + sixth * sum);                           \
        x[rate][i] += sixth * (sum + middle + k4.of);                            \
    }
        MOVE(0, 1, pitch) MOVE(2, 3, wheel) MOVE(4, 5, yaw)
    }
}

static void feedback(real (*restrict x)[LANES], real (*restrict u)[LANES], const real *restrict gain)
{
    for (int m = 0; m < 2; m++)
        for (int i = 0; i < LANES; i++) {
            real sum = 0;
            for (int k = 0; k < 6; k++)
                sum -= gain[6 * m + k] * x[k][i];
            u[m][i] = sum;
        }
}

/* states (n, 6) in and out, constants (n, CONSTANTS), gain (2, 6); n must be a multiple of LANES. */
void simulate(real *states, const real *constants, const real *gain, long n, long periods, long stride, real h)
{
    real x[6][LANES] __attribute__((aligned(64))), c[CONSTANTS][LANES] __attribute__((aligned(64)));
    real u[2][LANES] __attribute__((aligned(64)));
    for (long first = 0; first < n; first += LANES) {
        for (int i = 0; i < LANES; i++) {
            for (int k = 0; k < 6; k++) x[k][i] = states[(first + i) * 6 + k];
            for (int k = 0; k < CONSTANTS; k++) c[k][i] = constants[(first + i) * CONSTANTS + k];
        }
        for (long k = 0; k < periods; k++) {
            feedback(x, u, gain);
            for (long s = 0; s < stride; s++) advance(x, c, u, h);
        }
        for (int i = 0; i < LANES; i++)
            for (int k = 0; k < 6; k++) states[(first + i) * 6 + k] = x[k][i];
    }
}
