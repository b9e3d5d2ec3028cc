/** Search in the names of commands. */

const plain = (text: string): string =>
  text
    .normalize("NFKD")
    .replace(/\p{Mark}/gu, "")
    .toLowerCase();

/** Whether a name contains every word of a query, with or without accents. */
export function foundBy(query: string, name: string): boolean {
  const within = plain(name);
  return plain(query)
    .split(/\s+/)
    .every((word) => within.includes(word));
}
