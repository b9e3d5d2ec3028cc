/** The checks of a start in rows that a person at the table signs with one touch each. */

import { translate } from "../../language/translate";
import type { Check } from "./checks";
import { HANDS } from "./handsClear";

export interface CheckGroup {
  /** Id of its only check, or a name of its own. */
  readonly key: string;
  /** Empty for a single check, whose text says all. */
  readonly title: string;
  readonly checks: readonly Check[];
}

const TITLES = {
  material: translate("checkGroups.boardAndSheet"),
  tools: translate("checkGroups.tools"),
  table: translate("checkGroups.tableAndHands"),
} as const;

const PLACES: Readonly<Record<string, keyof typeof TITLES>> = {
  board: "material",
  sheet: "material",
  "table-clear": "table",
  [HANDS]: "table",
};

/** What is unusual is signed by itself: a worn tool, and a sheet that was left on the table. */
function placeOf({ key, station, warns }: Check): keyof typeof TITLES | null {
  if (station !== null) return warns ? null : "tools";
  return PLACES[key] ?? null;
}

/**
 * The rows in the order of the work: what lies on the table, the tools, and the hands last, because
 * that statement counts for a minute only.
 */
export function groupChecks(checks: readonly Check[]): readonly CheckGroup[] {
  const groups = new Map<string, Check[]>();
  for (const check of checks) {
    const place = placeOf(check) ?? check.key;
    groups.set(place, [...(groups.get(place) ?? []), check]);
  }
  return [...groups].map(([place, members]) => {
    const [only] = members;
    return members.length === 1 && only !== undefined
      ? { key: only.key, title: "", checks: members }
      : { key: place, title: TITLES[place as keyof typeof TITLES], checks: members };
  });
}

/** Checks of a row that its touch changes: all that are missing, or all if none is missing. */
export function touched({ checks }: CheckGroup, ticked: ReadonlySet<string>): readonly string[] {
  const missing = checks.map(({ key }) => key).filter((key) => !ticked.has(key));
  return missing.length > 0 ? missing : checks.map(({ key }) => key);
}
