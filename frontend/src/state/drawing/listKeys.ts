/** Keys that move in a list. */

/** The place that a key moves to from another one (−1: none yet); null if it moves to none. */
export function movedPlace(key: string, from: number, count: number, page: number): number | null {
  if (count === 0) return null;
  const targets: Readonly<Record<string, number>> = {
    ArrowDown: from + 1,
    ArrowUp: from - 1,
    PageDown: from + page,
    PageUp: from - page,
    Home: 0,
    End: count - 1,
  };
  const to = targets[key];
  return to === undefined ? null : Math.min(count - 1, Math.max(0, to));
}
