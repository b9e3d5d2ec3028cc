/**
 * Decides whether many lines are drawn with a width or as thin lines of the graphics card.
 *
 * Lines with a width cost several times as much, above all where a computer has no graphics card.
 * So many lines are thin at first. They get their width if thin frames are quick, and lose it for
 * good if frames with it are slow twice in succession.
 */

/** Up to this number of segments, lines always have a width. */
const FEW = 5000;
/** A thin frame this quick (ms) leaves time for the width … */
const QUICK = 34;
/** … and a frame with a width this slow (ms) takes too long. */
const SLOW = 60;
/** Two slow frames in succession: a single one may have waited for something else. */
const MOST_SLOW = 2;

export class Detail {
  private wide = false;
  private slow = 0;

  /** Begin anew, for another drawing. */
  reset(): void {
    this.wide = false;
    this.slow = 0;
  }

  /** Whether lines are thin in the next frame, which has `count` segments. */
  isThin(count: number): boolean {
    return count > FEW && !this.wide;
  }

  /**
   * Learn from a frame of `count` segments that took some time (ms).
   *
   * Returns whether the next frame differs.
   */
  learn(count: number, milliseconds: number): boolean {
    if (count <= FEW) return false;
    if (this.wide) {
      this.slow = milliseconds > SLOW ? this.slow + 1 : 0;
      if (this.slow < MOST_SLOW) return false;
      this.wide = false;
      return true;
    }
    if (this.slow >= MOST_SLOW || milliseconds > QUICK) return false;
    this.wide = true;
    return true;
  }
}
