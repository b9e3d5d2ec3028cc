/** Texts with elements in them, such as "Board: <b>{title}</b>". */

import { createElement, Fragment, type ReactElement, type ReactNode } from "react";
import type { TagsOf } from "./arguments";
import { richFormat, type TextId, type TextOf, type ValuesOf } from "./translate";

type Value = string | number | ((children: ReactNode[]) => ReactNode);

type Elements<Id extends TextId> = Readonly<
  Record<TagsOf<TextOf<Id>>, (children: ReactNode[]) => ReactNode>
>;

/** The text of an identifier whose tags become elements. */
export function translateRich<Id extends TextId>(
  id: Id,
  values: ValuesOf<Id> & Elements<Id>,
): ReactElement {
  const parts = richFormat(id).format<ReactNode>(
    Object.fromEntries(
      Object.entries<Value>(values).map(([name, value]) => [
        name,
        typeof value === "function" ? withoutKeys(value) : value,
      ]),
    ),
  );
  return createElement(Fragment, null, ...(Array.isArray(parts) ? parts : [parts]));
}

/** A function of children that have no keys, since a text has them in a fixed order. */
const withoutKeys =
  (element: (children: ReactNode[]) => ReactNode) =>
  (children: ReactNode[]): ReactNode =>
    element([createElement(Fragment, { key: 0 }, ...children)]);
