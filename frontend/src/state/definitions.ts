/** Fields of machines, boards and tools: their groups, their faults, and differences of versions. */

import type { Shelf } from "../api/client";
import { ServiceError } from "../api/errors";
import { renderText, type ServerMessage } from "../messages/render";
import { queryClient } from "./queries";

export type Fields = Readonly<Record<string, unknown>>;

/** Part of a JSON Schema. */
export interface Schema {
  readonly type?: string;
  readonly description?: string;
  readonly default?: unknown;
  readonly const?: string;
  readonly enum?: readonly string[];
  readonly anyOf?: readonly Schema[];
  readonly oneOf?: readonly Schema[];
  readonly $ref?: string;
  readonly items?: Schema;
  readonly properties?: Readonly<Record<string, Schema>>;
  readonly additionalProperties?: Schema | boolean;
  readonly $defs?: Readonly<Record<string, Schema>>;
}

export const SHELF_TITLES: Readonly<Record<Shelf, string>> = {
  machines: "Machines",
  boards: "Boards",
  tools: "Tools",
};

/** Titles of the groups of a form, with their fields; fields without a group come last. */
export const GROUPS: Readonly<Record<Shelf, Readonly<Record<string, readonly string[]>>>> = {
  machines: {
    "Machine and table": ["title", "width", "height", "dialect", "feed", "origin"],
    "Heights and waiting times": ["travel_z", "clearance", "turn_clearance", "into_mat", "settle"],
    "Stations, tools and outputs": ["station"],
    "Axes and travel": ["axes", "gantry"],
    "Keep-out zones": ["zone"],
  },
  boards: {
    Board: ["title", "material", "caliper", "grain"],
    Creases: ["crease_along", "crease_across", "end_clearance", "short_crease", "double_crease"],
    "V-grooves": [
      ...["groove_depth", "groove_pass", "groove_curve"],
      ...["groove_overcut", "groove_shift", "fold_angle"],
    ],
    "Half-cuts and perforations": ["half_cut_depth", "perforation"],
    Bridges: ["bridge_width", "bridge_spacing"],
    "Deflection of cutters": ["deflection"],
  },
  tools: { Tool: ["title", "tool"] },
};

/** Resolve a reference, and leave out the alternative null. */
export function resolved(schema: Schema, root: Schema): Schema {
  const [one, ...others] = (schema.anyOf ?? []).filter(({ type }) => type !== "null");
  if (one !== undefined && others.length === 0) {
    return { ...schema, anyOf: [], ...resolved(one, root) };
  }
  const name = schema.$ref?.split("/").pop();
  const found = name === undefined ? undefined : root.$defs?.[name];
  return found === undefined ? schema : { ...found, ...schema, properties: found.properties ?? {} };
}

/** Path of a field as faults name it. */
export const pathOf = (parent: string, key: string): string =>
  parent === "" ? key : `${parent} → ${key}`;

/** Texts of the faults of a refused definition, by the path of their field. */
export function faultsOf(error: unknown): Readonly<Record<string, string>> {
  if (!(error instanceof ServiceError)) return {};
  const faults = (error.problem.arguments as { faults?: ServerMessage[] }).faults ?? [];
  return Object.fromEntries(
    faults.map((fault) => [String(fault.arguments.path ?? ""), renderText(fault)]),
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
    for (const [key, one] of Object.entries(value)) flattened(one, pathOf(path, key), into);
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

/** Fetch the library again, and the machines and boards that jobs can choose. */
export async function refreshLibrary(): Promise<void> {
  const keys = ["library", "definition", "definitionVersions", "machines", "boards"];
  await Promise.all(keys.map((key) => queryClient.invalidateQueries({ queryKey: [key] })));
}
