// Sine and cosine, rounded correctly but for one in some thousand arguments, as glibc's are, which Python uses: those of
// browsers err in the last bit of one in fifty. Sums and products keep what they round away in `low` (Dekker 1971).
const { sin, cos } = (() => {
  const low = new Float64Array(1);
  const times = (a, b) => {
    const p = a * b, s = 134217729 * a, t = 134217729 * b;
    const c = s - (s - a), d = t - (t - b);
    low[0] = (a - c) * (b - d) - (p - c * d - (a - c) * d - c * (b - d));
    return p;
  };
  const plus = (a, b) => {
    const s = a + b, v = s - a;
    low[0] = a - (s - v) + (b - v);
    return s;
  };
  const brief = (s, e) => {
    const h = s + e;
    low[0] = e - (h - s);
    return h;
  };
  const product = (a, b, c, d) => {
    const p = times(a, c);
    return brief(p, low[0] + (a * d + b * c));
  };
  const total = (a, b, c, d) => {
    const s = plus(a, c);
    return brief(s, low[0] + (b + d));
  };
  // z (a + b + z (c + d + z q)) for z = h + l
  const series = (h, l, q, a, b, c, d) => {
    let s = product(h, l, q, 0);
    s = total(c, d, s, low[0]);
    s = product(h, l, s, low[0]);
    s = total(a, b, s, low[0]);
    return product(h, l, s, low[0]);
  };
  const sine = (h, l) => {
    const z = times(h, h), e = low[0] + 2 * h * l;
    const q = -1 / 5040 + z * (1 / 362880 + z * (-1 / 39916800 + z * (1 / 6227020800 + z * (-1 / 1307674368000 + z / 355687428096000))));
    const s = series(z, e, q, -1 / 6, -9.25185853854297e-18, 1 / 120, 1.1564823173178714e-19);
    const t = product(h, l, s, low[0]), rest = low[0] + l;
    return plus(h, t) + (low[0] + rest);
  };
  const cosine = (h, l) => {
    const z = times(h, h), e = low[0] + 2 * h * l;
    const q = -1 / 720 + z * (1 / 40320 + z * (-1 / 3628800 + z * (1 / 479001600 + z * (-1 / 87178291200 + z / 20922789888000))));
    const s = series(z, e, q, -1 / 2, 0, 1 / 24, 2.3129646346357427e-18), rest = low[0];
    return plus(1, s) + (low[0] + rest);
  };
  // x − k π/2, with π/2 in three parts (Cody and Waite 1980)
  const turned = (x, quarter, plain) => {
    if (!(Math.abs(x) < 1e5)) return plain(x);
    const k = Math.round(x * 0.6366197723675814);
    const s = plus(x - k * 1.5707963267341256, -k * 6.077100506303966e-11);
    const h = brief(s, low[0] - k * 2.0222662487959506e-21), l = low[0];
    const n = (((k + quarter) % 4) + 4) % 4;
    const v = n % 2 ? cosine(h, l) : sine(h, l);
    return n > 1 ? -v : v;
  };
  return { sin: (x) => turned(x, 0, Math.sin), cos: (x) => turned(x, 1, Math.cos) };
})();
const { sqrt } = Math;
