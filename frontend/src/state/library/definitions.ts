/** Fields of machines, boards and tools: their paths, their faults, and differences of versions. */

import type { ErrorSchema } from "@rjsf/utils";
import { ServiceError } from "../../api/errors";
import type { Shelf } from "../../api/library";
import { translate } from "../../language/translate";
import { messageText, type ServerMessage } from "../../messages/translateMessage";
import { refreshChoices } from "../cacheUpdates";
import { queryClient } from "../queries";

export type Fields = Readonly<Record<string, unknown>>;

export const SHELF_TITLES: Readonly<Record<Shelf, string>> = {
  machines: translate("definitions.machines"),
  boards: translate("definitions.boards"),
  tools: translate("definitions.tools"),
};

/** Path of a field as faults name it: `station 2 → tool → feed`. */
export const pathText = (path: readonly (string | number)[]): string =>
  path.reduce<string>(
    (text, key) =>
      typeof key === "number" ? `${text} ${key + 1}` : text === "" ? key : `${text} → ${key}`,
    "",
  );

/** The faults of a refused definition as rjsf shows them at their fields. */
export function faultTree(faults: Readonly<Record<string, string>>, fields: Fields): ErrorSchema {
  const tree: FaultNode = {};
  for (const [path, text] of Object.entries(faults)) {
    const end = keysOf(path, fields).reduce<FaultNode>((node, key) => {
      node[key] ??= {};
      return node[key] as FaultNode;
    }, tree);
    end.__errors = [text];
  }
  return tree as ErrorSchema;
}

interface FaultNode {
  [key: string | number]: FaultNode | string[] | undefined;
}

/** The keys of a path of a fault; the number of an item follows the name of its list. */
function keysOf(path: string, fields: Fields): (string | number)[] {
  let value: unknown = fields;
  return path.split(" → ").flatMap((word) => {
    const item = /^(.+) (\d+)$/.exec(word);
    const known = (value as Fields | undefined)?.[word];
    if (known !== undefined || item === null) {
      value = known;
      return [word];
    }
    const [list = "", at] = [item[1], Number(item[2]) - 1];
    value = ((value as Fields | undefined)?.[list] as readonly unknown[] | undefined)?.[at];
    return [list, at];
  });
}

/** The fields with another value at a path; undefined removes the key of a table. */
export function withValue(
  fields: Fields,
  path: readonly (string | number)[],
  value: unknown,
): Fields {
  const set = (old: unknown, [key, ...rest]: readonly (string | number)[]): unknown => {
    if (key === undefined) return value;
    if (typeof key === "number") {
      const items = [...((old ?? []) as readonly unknown[])];
      items[key] = set(items[key], rest);
      return items;
    }
    const { [key]: before, ...others } = (old ?? {}) as Fields;
    const changed = set(before, rest);
    if (changed === undefined) return others;
    // The order of the keys stays.
    return before === undefined
      ? { ...others, [key]: changed }
      : { ...(old as Fields), [key]: changed };
  };
  return set(fields, path) as Fields;
}

/** The fields as they are sent: what is empty is left out, also a list of empty items. */
export function sentFields(fields: Fields): Fields {
  return sent(fields) as Fields;
}

function sent(value: unknown): unknown {
  if (Array.isArray(value)) {
    const isEmpty = value.length > 0 && value.every((one) => one === undefined || one === null);
    return isEmpty ? undefined : value.map(sent);
  }
  if (typeof value !== "object" || value === null) return value;
  // A field of a new table is null until it has a value.
  const given = Object.entries(value).filter(([, one]) => one !== null);
  return Object.fromEntries(given.map(([key, one]) => [key, sent(one)]));
}

/** Texts of the faults of a refused definition beside their fields, by the path of the field. */
export function faultsOf(error: unknown): Readonly<Record<string, string>> {
  if (!(error instanceof ServiceError)) return {};
  const faults = (error.problem.arguments as { faults?: ServerMessage[] }).faults ?? [];
  return Object.fromEntries(
    faults.map((fault) => [
      String(fault.arguments.path ?? ""),
      messageText({ ...fault, arguments: { ...fault.arguments, path: "This value" } }),
    ]),
  );
}

export interface Difference {
  readonly path: string;
  readonly before: string;
  readonly after: string;
}

function flattened(value: unknown, path: string, into: Map<string, string>) {
  if (Array.isArray(value) && value.some((one) => typeof one === "object")) {
    value.forEach((one, at) => {
      flattened(one, `${path} ${at + 1}`, into);
    });
  } else if (typeof value === "object" && value !== null && !Array.isArray(value)) {
    for (const [key, one] of Object.entries(value))
      if (one !== undefined && one !== null)
        flattened(one, path === "" ? key : `${path} → ${key}`, into);
  } else {
    into.set(path, Array.isArray(value) ? value.join(", ") : String(value));
  }
}

/** Fields that differ between two versions; a missing field has the text "–". */
export function differences(before: Fields, after: Fields): readonly Difference[] {
  const [left, right] = [new Map<string, string>(), new Map<string, string>()];
  flattened(before, "", left);
  flattened(after, "", right);
  return [...new Set([...left.keys(), ...right.keys()])]
    .filter((path) => left.get(path) !== right.get(path))
    .map((path) => ({ path, before: left.get(path) ?? "–", after: right.get(path) ?? "–" }));
}

/** Fetch the library again, and the definitions on display. */
export async function refreshLibrary(): Promise<void> {
  const keys = ["definition", "definitionVersions"];
  await Promise.all([
    refreshChoices(),
    ...keys.map((key) => queryClient.invalidateQueries({ queryKey: [key] })),
  ]);
}
