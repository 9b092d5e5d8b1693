// Generated from physics/electronics.py: do not edit. Written again by: python -m upright.compiled.generate

/**
 * The nearest whole number, halves to the even one.
 * @param {number} v
 */
function nearest(v) {
  const near = Math.round(v);
  return Math.abs(v % 1) === 0.5 && near % 2 ? near - 1 : near;
}

/** @type {(command_left: number, command_right: number, limit: number, dead_zone: number, quantum: number, drop: number, voltage: number, sag: number, out: Float64Array) => void} */
export const driveVolts = (command_left, command_right, limit, dead_zone, quantum, drop, voltage, sag, out) => {
  const t0 = Math.abs(command_left);
  const t1 = dead_zone < t0 ? command_left : 0;
  const t2 = Math.abs(command_right);
  const t3 = dead_zone < t2 ? command_right : 0;
  const t4 = Math.abs(t1);
  const t5 = t4 < voltage ? t4 : voltage;
  const t6 = Math.abs(t3);
  const t7 = t6 < voltage ? t6 : voltage;
  const t8 = t5 + t7;
  const t9 = sag * t8;
  const t10 = voltage - t9;
  const t11 = limit < t10 ? limit : t10;
  const t12 = -t11;
  const t13 = t11 < t1 ? t11 : t1;
  const t14 = t1 < t12 ? t12 : t13;
  const t15 = -quantum;
  const t16 = t15 < 0 ? quantum : 1;
  const t17 = t14 / t16;
  const t18 = Math.trunc(t17);
  const t19 = t18 * t16;
  const t20 = t15 < 0 ? t19 : t14;
  const t21 = t11 < t3 ? t11 : t3;
  const t22 = t3 < t12 ? t12 : t21;
  const t23 = t22 / t16;
  const t24 = Math.trunc(t23);
  const t25 = t24 * t16;
  const t26 = t15 < 0 ? t25 : t22;
  const t27 = -drop;
  const t28 = drop < t20 ? drop : t20;
  const t29 = t20 < t27 ? t27 : t28;
  const t30 = t20 - t29;
  const t31 = t27 < 0 ? t30 : t20;
  const t32 = drop < t26 ? drop : t26;
  const t33 = t26 < t27 ? t27 : t32;
  const t34 = t26 - t33;
  const t35 = t27 < 0 ? t34 : t26;
  const t36 = t4 < t6 ? t6 : t4;
  const t37 = t11 < t36 ? 1 : 0;
  out[0] = t31;
  out[1] = t35;
  out[2] = t10;
  out[3] = t37;
};

/** @type {(command_left: number, command_right: number, limit: number, dead_zone: number, quantum: number, drop: number, voltage: number, sag: number, out: Float64Array) => void} */
export const driveTorque = (command_left, command_right, limit, dead_zone, quantum, drop, voltage, sag, out) => {
  const t0 = Math.abs(command_left);
  const t1 = dead_zone < t0 ? command_left : 0;
  const t2 = Math.abs(command_right);
  const t3 = dead_zone < t2 ? command_right : 0;
  const t4 = Math.abs(t1);
  const t5 = t4 < voltage ? t4 : voltage;
  const t6 = Math.abs(t3);
  const t7 = t6 < voltage ? t6 : voltage;
  const t8 = t5 + t7;
  const t9 = sag * t8;
  const t10 = voltage - t9;
  const t11 = -limit;
  const t12 = limit < t1 ? limit : t1;
  const t13 = t1 < t11 ? t11 : t12;
  const t14 = -quantum;
  const t15 = t14 < 0 ? quantum : 1;
  const t16 = t13 / t15;
  const t17 = Math.trunc(t16);
  const t18 = t17 * t15;
  const t19 = t14 < 0 ? t18 : t13;
  const t20 = limit < t3 ? limit : t3;
  const t21 = t3 < t11 ? t11 : t20;
  const t22 = t21 / t15;
  const t23 = Math.trunc(t22);
  const t24 = t23 * t15;
  const t25 = t14 < 0 ? t24 : t21;
  const t26 = -drop;
  const t27 = drop < t19 ? drop : t19;
  const t28 = t19 < t26 ? t26 : t27;
  const t29 = t19 - t28;
  const t30 = t26 < 0 ? t29 : t19;
  const t31 = drop < t25 ? drop : t25;
  const t32 = t25 < t26 ? t26 : t31;
  const t33 = t25 - t32;
  const t34 = t26 < 0 ? t33 : t25;
  const t35 = t4 < t6 ? t6 : t4;
  const t36 = limit < t35 ? 1 : 0;
  out[0] = t30;
  out[1] = t34;
  out[2] = t10;
  out[3] = t36;
};

/** @type {(applied_left: number, applied_right: number, left: number, right: number, out: Float64Array) => void} */
export const turn = (applied_left, applied_right, left, right, out) => {
  const t0 = applied_left * left;
  const t1 = applied_right * right;
  out[0] = t0;
  out[1] = t1;
};

/** @type {(touch: number, wheel: number, play: number, out: Float64Array) => void} */
export const slacken = (touch, wheel, play, out) => {
  const t0 = wheel - play;
  const t1 = wheel + play;
  const t2 = t1 < touch ? t1 : touch;
  const t3 = touch < t0 ? t0 : t2;
  out[0] = t3;
};

/** @type {(ideal: number, drift: number, normal: number, step: number, sensor: Record<string, any>, out: Float64Array) => void} */
export const measure = (ideal, drift, normal, step, { quantum, noise, bias_walk, range, gain, offset }, out) => {
  const t0 = bias_walk * step;
  const t1 = drift + t0;
  const t2 = gain * ideal;
  const t3 = t2 + offset;
  const t4 = t3 + t1;
  const t5 = noise * normal;
  const t6 = t4 + t5;
  const t7 = -quantum;
  const t8 = t7 < 0 ? quantum : 1;
  const t9 = t6 / t8;
  const t10 = nearest(t9);
  const t11 = t10 * t8;
  const t12 = t7 < 0 ? t11 : t6;
  const t13 = -range;
  const t14 = range < t12 ? range : t12;
  const t15 = t12 < t13 ? t13 : t14;
  out[0] = t15;
  out[1] = t1;
};

/** @type {(rate: number, yaw_rate: number, sensor: Record<string, any>, out: Float64Array) => void} */
export const settle = (rate, yaw_rate, { tilt, b1, b2, a1, a2 }, out) => {
  const t0 = b2 * rate;
  const t1 = a2 * rate;
  const t2 = t0 + t1;
  const t3 = b1 * rate;
  const t4 = a1 * rate;
  const t5 = t3 + t4;
  const t6 = t5 + t2;
  const t7 = tilt * yaw_rate;
  const t8 = rate + t7;
  out[0] = t8;
  out[1] = t6;
  out[2] = t2;
};

/** @type {(rate: number, yaw_rate: number, first: number, second: number, sensor: Record<string, any>, out: Float64Array) => void} */
export const swing = (rate, yaw_rate, first, second, { tilt, b0, b1, b2, a1, a2 }, out) => {
  const t0 = b0 * rate;
  const t1 = t0 + first;
  const t2 = b1 * rate;
  const t3 = a1 * t1;
  const t4 = t2 + t3;
  const t5 = t4 + second;
  const t6 = b2 * rate;
  const t7 = a2 * t1;
  const t8 = t6 + t7;
  const t9 = tilt * yaw_rate;
  const t10 = t1 + t9;
  out[0] = t10;
  out[1] = t5;
  out[2] = t8;
};

/** @type {(angle: number, cosine: number, sine: number, rate: number, forward: number, up: number, gravity: number, sensor: Record<string, any>, out: Float64Array) => void} */
export const fuse = (angle, cosine, sine, rate, forward, up, gravity, { time_constant, spell }, out) => {
  const t0 = forward * cosine;
  const t1 = up * sine;
  const t2 = t0 + t1;
  const t3 = gravity * time_constant;
  const t4 = t2 / t3;
  const t5 = rate - t4;
  const t6 = spell * t5;
  const t7 = angle + t6;
  out[0] = t7;
};
