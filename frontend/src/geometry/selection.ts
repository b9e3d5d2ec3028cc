/** Selections of rows, and how new rows change them. */

export type SelectMode = "replace" | "add" | "remove" | "toggle";

/** The selection after some rows are chosen; the rows that stay keep their order. */
export function changedSelection(
  selection: ReadonlySet<number>,
  rows: Iterable<number>,
  mode: SelectMode,
): ReadonlySet<number> {
  if (mode === "replace") return new Set(rows);
  const next = new Set(selection);
  for (const row of rows) {
    if (mode === "add") next.add(row);
    else if (!next.delete(row) && mode === "toggle") next.add(row);
  }
  return next;
}

interface Keys {
  readonly shiftKey: boolean;
  readonly ctrlKey: boolean;
  readonly metaKey: boolean;
}

/** What a click with these keys does with what is clicked. */
export const clickMode = ({ shiftKey, ctrlKey, metaKey }: Keys): SelectMode =>
  shiftKey || ctrlKey || metaKey ? "toggle" : "replace";
