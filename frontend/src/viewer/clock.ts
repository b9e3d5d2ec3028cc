/** Where in its program the head is shown: put there, or on the way there. */

/** A report this much behind the marker is no way back (s of the program). */
const SLACK = 1.5;

export class HeadClock {
  private seconds: number | null = null;
  private run: { from: number; to: number; began: number; lasts: number } | null = null;

  get running(): boolean {
    return this.run !== null;
  }

  /** Be there at once; null takes the head off. */
  put(seconds: number | null): void {
    this.run = null;
    this.seconds = seconds;
  }

  /** Travel there in `lasts` ms from `now` on. */
  send(seconds: number, lasts: number, now: number): void {
    const from = this.at(now);
    // The report may be a little behind where the marker has come to: let it catch up.
    if (from !== null && seconds < from && from - seconds < SLACK) return;
    // Far back is a new copy, or another place altogether: be there at once.
    if (from === null || seconds < from) this.put(seconds);
    else this.run = { from, to: seconds, began: now, lasts: Math.max(1, lasts) };
  }

  at(now: number): number | null {
    if (this.run === null) return this.seconds;
    const { from, to, began, lasts } = this.run;
    return from + (to - from) * Math.min(1, Math.max(0, (now - began) / lasts));
  }

  /** The same, and a way that has come to its end is none any more. */
  tick(now: number): number | null {
    this.seconds = this.at(now);
    if (this.run !== null && now >= this.run.began + this.run.lasts) this.run = null;
    return this.seconds;
  }
}
