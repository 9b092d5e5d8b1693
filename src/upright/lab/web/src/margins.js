// What linear theory says of gains by hand, as certify/analysis.py says it of every controller: poles, and the margins of
// the loop broken at both motors. The controller is the printed program itself, run on unit vectors. Plain JavaScript, so
// that a test runs it beside Python.

/**
 * @typedef {Float64Array[]} Matrix its rows
 * @typedef {[number, number]} Complex
 *
 * @typedef {object} Plant ẋ = A x + B u, read as C x by sensors that are late by `delays`, its commands by `dead` [s]
 * @property {number[][]} A
 * @property {number[][]} B
 * @property {number[][]} C
 * @property {number} dead
 * @property {number[]} delays
 * @property {number} period
 *
 * @typedef {object} Analysis null stands for no limit; margins of an unstable loop mean nothing
 * @property {boolean} stable
 * @property {Complex[]} poles
 * @property {number} gain_low
 * @property {number | null} gain_high
 * @property {number | null} phase
 * @property {number | null} delay
 * @property {number[][]} L frequencies, real and imaginary parts
 */

const SAME = 1e-9; // of a period: equal times may differ by rounding
const BORDER = 1 - 1e-9; // a pole beyond does not decay: an integrator that is left alone lies here
const [LATEST, FINEST] = [0.3, 1e-3]; // [s] delays that are tried, as certify/analysis.py
const UNBOUNDED = 1e6; // a response as large is that of a pole
const [GRID, SHOWN] = [3000, 160]; // frequencies looked at, and drawn, of which every second is kept

/** @type {(n: number, m: number) => Matrix} */
const zeros = (n, m) => Array.from({ length: n }, () => new Float64Array(m));

/** @type {(A: Matrix, B: Matrix) => Matrix} */
function product(A, B) {
  const C = zeros(A.length, B[0].length);
  for (let i = 0; i < A.length; i += 1) {
    const [row, sum] = [A[i], C[i]];
    for (let k = 0; k < row.length; k += 1) {
      const [a, other] = [row[k], B[k]];
      if (a) for (let j = 0; j < sum.length; j += 1) sum[j] += a * other[j];
    }
  }
  return C;
}

/** @type {(A: Matrix) => number} */
const size = (A) => Math.max(...A.map((row) => row.reduce((sum, v) => sum + Math.abs(v), 0)));

/**
 * Φ and Γ of a command held over h, side by side: the exponential of [A B; 0 0] h, by scaling and squaring.
 * @param {Plant} plant
 * @param {number} h
 * @returns {Matrix}
 */
function held({ A, B }, h) {
  const M = [...A.map((row, i) => Float64Array.from([...row, ...B[i]], (v) => v * h)), ...zeros(2, 8)];
  const halvings = Math.max(0, Math.ceil(Math.log2(size(M) + 1e-300)) + 2);
  let [sum, term] = [zeros(8, 8), zeros(8, 8)];
  for (let i = 0; i < 8; i += 1) term[i][i] = 1;
  for (let k = 1; k < 20; k += 1) {
    sum = sum.map((row, i) => row.map((v, j) => v + term[i][j]));
    term = product(term, M).map((row) => row.map((v) => v / k / 2 ** halvings));
  }
  for (let k = 0; k < halvings; k += 1) sum = product(sum, sum);
  return sum.slice(0, 6);
}

/** @type {(delay: number, dt: number) => [number, number]} whole periods, and the rest [s] */
function divided(delay, dt) {
  const whole = Math.floor(delay / dt + SAME);
  const rest = delay - whole * dt;
  return [whole, rest > SAME * dt ? rest : 0];
}

/**
 * The loop as one matrix: the robot's state, readings on their way, commands on theirs, the controller's memory, and the
 * commands that it waits for. With `cut` it is broken at both motors: `enters` is what acts there, `leaves` what should.
 * @param {Plant} plant
 * @param {import("./simulator").Law} law
 * @param {ArrayLike<number>} gains
 * @param {number} more [s] dead time that the controller does not know of
 * @param {boolean} cut
 * @returns {Matrix}
 */
export function loopMatrix(plant, law, gains, more = 0, cut = false) {
  const dt = plant.period;
  const [whole, rest] = divided(plant.dead + more, dt);
  const due = divided(plant.dead, dt)[0];
  /** @type {(h: number) => (x: ArrayLike<number>, now: number[], before: number[]) => number[]} */
  const between = (h) => {
    const [one, two] = [held(plant, Math.min(h, rest)), held(plant, Math.max(h - rest, 0))];
    const apply = (/** @type {Matrix} */ M, /** @type {ArrayLike<number>} */ x, /** @type {number[]} */ u) =>
      M.map((row) => row.reduce((sum, m, j) => sum + m * (j < 6 ? x[j] : u[j - 6]), 0));
    return (x, now, before) => apply(two, apply(one, x, before), now);
  };
  const lines = plant.delays.map((delay) => {
    const [count, late] = divided(delay, dt);
    return late ? { count: count + 1, enters: between(dt - late) } : { count, enters: null };
  });
  const move = between(dt);
  const [queue, reference] = [whole + (rest ? 1 : 0), new Float64Array(6)];
  const waiting = 6 + lines.reduce((sum, line) => sum + line.count, 0);
  const memory = waiting + 2 * queue;
  const n = memory + law.start.length + 2 * due;

  /** @type {(s: Float64Array) => Float64Array} one period on */
  const advance = (s) => {
    const next = new Float64Array(n);
    const read = (/** @type {ArrayLike<number>} */ x, /** @type {number} */ i) => plant.C[i].reduce((sum, c, j) => sum + c * x[j], 0);
    let place = 6;
    const y = Float64Array.from(lines, ({ count }, i) => {
      place += count;
      return count ? s[place - 1] : read(s, i);
    });
    const [z, u] = [s.slice(memory, memory + law.start.length), new Float64Array(8)];
    law.command(z, y, reference, u, gains);
    const mean = cut ? (u[0] + u[1]) / 2 : 0;
    const sent = [u[0] - mean, u[1] - mean];
    const at = (/** @type {number} */ k) => (k ? [...s.slice(waiting + 2 * k - 2, waiting + 2 * k)] : sent);
    const [now, before] = [at(whole), rest ? at(whole + 1) : [0, 0]];
    next.set(move(s, now, before));
    place = 6;
    lines.forEach(({ count, enters }, i) => {
      if (count) {
        next.set(s.subarray(place, place + count - 1), place + 1);
        next[place] = read(enters ? enters(s, now, before) : s, i);
      }
      place += count;
    });
    if (queue) next.set([...sent, ...s.subarray(waiting, memory - 2)], waiting);
    const known = memory + law.start.length;
    law.update(z, y, reference, u, gains, due ? s.slice(n - 2) : u.slice(0, 2));
    next.set(z, memory);
    if (due) next.set([...u.subarray(0, 2), ...s.subarray(known, n - 2)], known);
    return next;
  };
  const columns = Array.from({ length: n }, (_, j) => advance(new Float64Array(n).fill(1, j, j + 1)));
  return Array.from({ length: n }, (_, i) => Float64Array.from(columns, (column) => column[i]));
}

/**
 * Whether the powers of a matrix vanish: it is squared until they are small or large.
 * @param {Matrix} A
 */
export function decays(A) {
  let [M, scale] = [A, 0]; // A^(2^k) = M e^scale
  for (let k = 0; k < 34; k += 1) {
    const now = size(M);
    scale += Math.log(now);
    if (!(now > 0) || scale < -1) return true;
    if (scale > 60) return false;
    M = M.map((row) => row.map((v) => v / now));
    M = product(M, M);
    scale *= 2;
  }
  return false;
}

/**
 * Eigenvalues by shifted QR steps on a Hessenberg matrix (Golub and Van Loan 2013, section 7.4), in complex numbers.
 * @param {Matrix} A
 * @returns {Complex[]}
 */
export function eigenvalues(A) {
  const n = A.length;
  const re = A.map((row) => Float64Array.from(row));
  for (let k = 1; k < n - 1; k += 1) { // by elimination, the largest number below the diagonal first
    let best = k;
    for (let i = k + 1; i < n; i += 1) if (Math.abs(re[i][k - 1]) > Math.abs(re[best][k - 1])) best = i;
    if (!re[best][k - 1]) continue;
    [re[k], re[best]] = [re[best], re[k]];
    for (const row of re) [row[k], row[best]] = [row[best], row[k]];
    for (let i = k + 1; i < n; i += 1) {
      const factor = re[i][k - 1] / re[k][k - 1];
      if (!factor) continue;
      for (let j = 0; j < n; j += 1) re[i][j] -= factor * re[k][j];
      for (const row of re) row[k] += factor * row[i];
    }
  }
  const im = A.map(() => new Float64Array(n));
  /** @type {Complex[]} */
  const found = [];
  let [end, tries] = [n - 1, 0];
  while (end >= 0) {
    let start = end;
    const small = (/** @type {number} */ i) => Math.hypot(re[i][i - 1], im[i][i - 1]) <= Number.EPSILON * (Math.hypot(re[i][i], im[i][i]) + Math.hypot(re[i - 1][i - 1], im[i - 1][i - 1]));
    while (start > 0 && !small(start)) start -= 1;
    if (start === end) {
      found.push([re[end][end], im[end][end]]);
      [end, tries] = [end - 1, 0];
      continue;
    }
    const [sr, si] = tries % 11 === 10 ? [Math.abs(re[end][end - 1]) + re[end][end], im[end][end]] : wilkinson(re, im, end);
    sweep(re, im, start, end, sr, si);
    tries += 1;
    if (tries > 300) return found; // of a matrix that is not finite
  }
  return found;
}

/**
 * The eigenvalue of the last two rows that is nearer to the last number.
 * @param {Matrix} re
 * @param {Matrix} im
 * @param {number} k
 * @returns {Complex}
 */
function wilkinson(re, im, k) {
  const at = (/** @type {number} */ i, /** @type {number} */ j) => /** @type {Complex} */ ([re[i][j], im[i][j]]);
  const [a, b, c, d] = [at(k - 1, k - 1), at(k - 1, k), at(k, k - 1), at(k, k)];
  const half = /** @type {Complex} */ ([(a[0] - d[0]) / 2, (a[1] - d[1]) / 2]);
  const root = squareRoot(add(times(half, half), times(b, c)));
  const sign = half[0] * root[0] + half[1] * root[1] < 0 ? -1 : 1;
  const large = add(half, [sign * root[0], sign * root[1]]);
  const away = large[0] || large[1] ? over(times(b, c), large) : large;
  return [d[0] - away[0], d[1] - away[1]];
}

/**
 * One QR step of the rows from start to end, with the shift s, by Givens rotations.
 * @param {Matrix} re
 * @param {Matrix} im
 * @param {number} start
 * @param {number} end
 * @param {number} sr
 * @param {number} si
 */
function sweep(re, im, start, end, sr, si) {
  for (let i = start; i <= end; i += 1) [re[i][i], im[i][i]] = [re[i][i] - sr, im[i][i] - si];
  const turns = [];
  for (let k = start; k < end; k += 1) {
    const [ar, ai, br, bi] = [re[k][k], im[k][k], re[k + 1][k], im[k + 1][k]];
    const r = Math.hypot(ar, ai, br, bi) || 1;
    const [cr, ci, dr, di] = [ar / r, ai / r, br / r, bi / r];
    turns.push([cr, ci, dr, di]);
    for (let j = k; j <= end; j += 1) {
      const [xr, xi, yr, yi] = [re[k][j], im[k][j], re[k + 1][j], im[k + 1][j]];
      re[k][j] = cr * xr + ci * xi + dr * yr + di * yi;
      im[k][j] = cr * xi - ci * xr + dr * yi - di * yr;
      re[k + 1][j] = cr * yr - ci * yi - dr * xr + di * xi;
      im[k + 1][j] = cr * yi + ci * yr - dr * xi - di * xr;
    }
  }
  turns.forEach(([cr, ci, dr, di], t) => {
    const k = start + t;
    for (let i = start; i <= Math.min(k + 1, end); i += 1) {
      const [xr, xi, yr, yi] = [re[i][k], im[i][k], re[i][k + 1], im[i][k + 1]];
      re[i][k] = cr * xr - ci * xi + dr * yr - di * yi;
      im[i][k] = cr * xi + ci * xr + dr * yi + di * yr;
      re[i][k + 1] = cr * yr + ci * yi - dr * xr - di * xi;
      im[i][k + 1] = cr * yi - ci * yr - dr * xi + di * xr;
    }
  });
  for (let i = start; i <= end; i += 1) [re[i][i], im[i][i]] = [re[i][i] + sr, im[i][i] + si];
}

/** @type {(a: Complex, b: Complex) => Complex} */
const add = (a, b) => [a[0] + b[0], a[1] + b[1]];
/** @type {(a: Complex, b: Complex) => Complex} */
const times = (a, b) => [a[0] * b[0] - a[1] * b[1], a[0] * b[1] + a[1] * b[0]];
/** @type {(a: Complex, b: Complex) => Complex} */
const over = (a, b) => [(a[0] * b[0] + a[1] * b[1]) / (b[0] ** 2 + b[1] ** 2), (a[1] * b[0] - a[0] * b[1]) / (b[0] ** 2 + b[1] ** 2)];
/** @type {(a: Complex) => Complex} */
function squareRoot([x, y]) {
  const r = Math.hypot(x, y);
  return [Math.sqrt(Math.max(r + x, 0) / 2), (y < 0 ? -1 : 1) * Math.sqrt(Math.max(r - x, 0) / 2)];
}

/**
 * Where f changes its sign between two of the points, at which it has these values.
 * @param {(w: number) => number} f
 * @param {number[]} points
 * @param {number[]} values
 */
function signChanges(f, points, values) {
  return points.slice(1).flatMap((_, k) => {
    if (values[k] < 0 === values[k + 1] < 0) return [];
    let [low, high] = [points[k], points[k + 1]];
    for (let i = 0; i < 60; i += 1) {
      const middle = (low + high) / 2;
      if (f(middle) < 0 === values[k] < 0) low = middle;
      else high = middle;
    }
    return [(low + high) / 2];
  });
}

/** @type {(low: number, high: number, count: number) => number[]} */
const spaced = (low, high, count) => Array.from({ length: count }, (_, k) => low * (high / low) ** (k / (count - 1)));

/** @type {(period: number) => number[]} the frequencies [rad/s] of a drawing */
export const shown = (period) => spaced(0.05, Math.PI / period, SHOWN).filter((_, k) => k % 2 === 0);

/**
 * How much more dead time [s] the loop survives when its controller does not know of it; infinite beyond `latest`.
 * @param {(more: number) => boolean} stable
 * @param {number} latest
 */
function delayMargin(stable, latest) {
  let [low, high] = [0, 0];
  while (stable(high)) {
    if (low > latest) return Infinity;
    [low, high] = [high, high + FINEST];
  }
  for (let k = 0; high && k < 12; k += 1) {
    const middle = (low + high) / 2;
    if (stable(middle)) low = middle;
    else high = middle;
  }
  return low;
}

/** @type {(value: number) => number | null} */
const finite = (value) => (Number.isFinite(value) ? value : null);

/**
 * @param {Plant} plant
 * @param {import("./simulator").Law} law
 * @param {ArrayLike<number>} gains
 * @returns {Analysis}
 */
export function analysed(plant, law, gains) {
  const [closed, cut] = [false, true].map((broken) => loopMatrix(plant, law, gains, 0, broken));
  const poles = eigenvalues(closed).sort((a, b) => Math.hypot(...b) - Math.hypot(...a));
  const open = eigenvalues(cut);
  /** @type {(w: number) => Complex} 1 + l is the ratio of the characteristic polynomials, closed over open */
  const loop = (w) => {
    const z = [Math.cos(w * plant.period), Math.sin(w * plant.period)];
    let [x, y] = [1, 0];
    for (let i = 0; i < poles.length; i += 1) {
      const [ar, ai, br, bi] = [z[0] - poles[i][0], z[1] - poles[i][1], z[0] - open[i][0], z[1] - open[i][1]];
      const [size, cr, ci] = [br * br + bi * bi, ar * br + ai * bi, ai * br - ar * bi];
      [x, y] = [(x * cr - y * ci) / size, (x * ci + y * cr) / size];
    }
    return [x - 1, y];
  };
  const top = Math.PI / plant.period;
  const drawn = shown(plant.period);
  const L = drawn.map(loop);
  const result = { stable: Math.hypot(...poles[0]) < BORDER, poles, gain_low: 1, gain_high: 1, phase: 0, delay: 0, L: [drawn, L.map(([x]) => x), L.map(([, y]) => y)] };
  if (!result.stable) return result;
  const linear = Array.from({ length: 300 }, (_, k) => ((k + 1) * top) / 300);
  const grid = [...spaced(Math.min(1e-3, top / 1e6), top, GRID), ...linear].sort((a, b) => a - b);
  const there = grid.map(loop);
  const real = [0, top, ...signChanges((w) => loop(w)[1], grid, there.map(([, y]) => y))].map((w) => loop(w)[0]);
  const factors = real.filter((x) => x < 0 && x > -UNBOUNDED).map((x) => -1 / x).sort((a, b) => a - b);
  // beyond a margin the loop is unstable; next to an integrator, rounding turns l through the real axis, too
  const border = (/** @type {number[]} */ some) => some.find((k) => !decays(cut.map((row, i) => row.map((v, j) => v + (k + (k - 1) / 1000) * (closed[i][j] - v)))));
  const beyond = (/** @type {Complex} */ [x, y]) => x * x + y * y - 1;
  const crossings = signChanges((w) => beyond(loop(w)), grid, there.map(beyond));
  const lags = crossings.map((w) => {
    const [x, y] = loop(w);
    return (Math.atan2(y, x) + 3 * Math.PI) % (2 * Math.PI);
  });
  const waits = lags.map((lag, i) => lag / crossings[i]);
  const dead = delayMargin((more) => decays(loopMatrix(plant, law, gains, more)), Math.min(LATEST, ...waits));
  return {
    ...result, gain_low: border(factors.filter((k) => k < 1).reverse()) ?? 0, gain_high: border(factors.filter((k) => k > 1)) ?? null,
    phase: finite(Math.min(...lags.map((lag) => Math.min(lag, 2 * Math.PI - lag)))), delay: finite(Math.min(dead, ...waits)),
  };
}
