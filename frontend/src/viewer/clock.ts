/** Program time at which the head is shown: fixed, or animated to a target. */

/** Reports behind the marker by less than this are ignored (s of the program). */
const SLACK = 1.5;

export class HeadClock {
  private seconds: number | null = null;
  private run: { from: number; to: number; began: number; lasts: number } | null = null;

  get running(): boolean {
    return this.run !== null;
  }

  /** Set the time; null hides the head. */
  set(seconds: number | null): void {
    this.run = null;
    this.seconds = seconds;
  }

  /** Animate to a time in `lasts` ms. */
  travelTo(seconds: number, lasts: number, now: number): void {
    const from = this.timeAt(now);
    // The marker is slightly ahead of the report: wait for the next one.
    if (from !== null && seconds < from && from - seconds < SLACK) return;
    // The report is further back, for example of a new copy: jump there.
    if (from === null || seconds < from) this.set(seconds);
    else this.run = { from, to: seconds, began: now, lasts: Math.max(1, lasts) };
  }

  timeAt(now: number): number | null {
    if (this.run === null) return this.seconds;
    const { from, to, began, lasts } = this.run;
    return from + (to - from) * Math.min(1, Math.max(0, (now - began) / lasts));
  }

  /** Time at `now`; ends the animation if its target is reached. */
  tick(now: number): number | null {
    this.seconds = this.timeAt(now);
    if (this.run !== null && now >= this.run.began + this.run.lasts) this.run = null;
    return this.seconds;
  }
}
