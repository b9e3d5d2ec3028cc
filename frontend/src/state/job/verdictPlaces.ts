/** Edges with a figure of the verdict that can be seen. */

/** Shorter lengths are not listed (mm). */
const VISIBLE = 0.05;

/** Rows of the edges with a figure of at least 0.05 mm, the largest first. */
export const placesOf = (figures: readonly number[]): readonly number[] =>
  [...figures.keys()]
    .filter((row) => (figures[row] ?? 0) >= VISIBLE)
    .sort((a, b) => (figures[b] ?? 0) - (figures[a] ?? 0) || a - b);
