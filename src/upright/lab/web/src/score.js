// What came of a push, and the largest single one: as Score of lab/pushing.py, which a test compares with it.

const [UPRIGHT, STILL, CALM_FOR, SHORT] = [0.05, 0.4, 1.0, 0.5];

export class Score {
  best = 0; // [N s]
  run = 0; // [N s] the same of this run alone
  effort = 0;
  given = 0; // pushes that it has yet to recover from
  impulse = 0;
  lasted = 0;
  calm = 0;
  before = 0;

  /** A push of any kind begins. */
  push() {
    if (!this.given) [this.impulse, this.lasted, this.before] = [0, 0, this.effort];
    this.given += 1;
    this.calm = 0;
  }

  /** Another robot or controller goes on: what it recovers from is nobody's record. */
  exchanged() {
    this.given += this.given ? 1 : 0;
    this.impulse = 0;
  }

  /**
   * That of the next run, which begins at rest or with a `lean` [rad].
   * @param {number} lean
   */
  anew(lean) {
    return Object.assign(new Score(), { best: this.best, given: lean ? 1 : 0 });
  }

  /**
   * One period; what it completes.
   * @param {number} dt @param {number} force @param {number} pitch @param {number} rate
   * @param {ArrayLike<number>} applied @param {boolean} fell
   * @returns {import("./messages").Recovered | null}
   */
  watch(dt, force, pitch, rate, applied, fell) {
    this.effort += (applied[0] ** 2 + applied[1] ** 2) * dt;
    if (force) {
      this.impulse += Math.abs(force) * dt;
      this.lasted += dt;
      this.calm = 0;
    } else if (this.given) {
      this.calm = Math.abs(pitch) < UPRIGHT && Math.abs(rate) < STILL ? this.calm + dt : 0;
      if (fell || this.calm >= CALM_FOR) return this.ended(fell);
    }
    return null;
  }

  /**
   * @param {boolean} fell
   * @returns {import("./messages").Recovered | null}
   */
  ended(fell) {
    const single = this.given === 1;
    this.given = 0;
    if (!this.impulse || (this.lasted > SHORT && !fell)) return null;
    if (single && !fell) this.run = Math.max(this.run, this.impulse);
    this.best = Math.max(this.best, this.run);
    return { kind: "Recovered", impulse: this.impulse, effort: this.effort - this.before, best: this.best, fell, single };
  }
}
