/** Order of titles for people: numbers by their value, 5 mm before 10 mm. */

const ORDER = new Intl.Collator("en", { numeric: true });

/** Compares two names. */
export const naturalOrder = (a: string, b: string): number => ORDER.compare(a, b);

interface Titled {
  readonly name: string;
  readonly title: string;
}

/** The same entries, ordered by their titles, or by their names where they have none. */
export const byTitle = <Entry extends Titled>(entries: readonly Entry[]): Entry[] =>
  [...entries].sort((a, b) => naturalOrder(a.title || a.name, b.title || b.name));
