/** Fields of machines, boards and tools: their groups, their faults, and differences of versions. */

import type { Shelf } from "../api/client";
import { ServiceError } from "../api/errors";
import { renderText, type ServerMessage } from "../messages/render";
import { queryClient, refreshChoices } from "./queries";

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
  readonly required?: readonly string[];
  readonly minItems?: number;
  readonly maxItems?: number;
  readonly maxProperties?: number;
  /** Conditions: fields whose schema depends on the value of another. */
  readonly allOf?: readonly Schema[];
  readonly if?: Schema;
  readonly then?: Schema;
  readonly $defs?: Readonly<Record<string, Schema>>;
}

export const SHELF_TITLES: Readonly<Record<Shelf, string>> = {
  machines: "Machines",
  boards: "Boards",
  tools: "Tools",
};

/** One entry of each kind, in sentences. */
export const SHELF_WORDS: Readonly<Record<Shelf, string>> = {
  machines: "machine",
  boards: "board",
  tools: "tool",
};

/** Titles of the groups of a form, with their fields; fields without a group come last. */
export const GROUPS: Readonly<Record<Shelf, Readonly<Record<string, readonly string[]>>>> = {
  machines: {
    "Machine and table": ["title", "width", "height", "dialect", "feed", "origin"],
    "Heights and waiting times": ["travel_z", "clearance", "turn_clearance", "into_mat", "settle"],
    "Stations, tools and outputs": ["output_count", "station"],
    "Axes and travel": ["axes", "gantry"],
    "Keep-out zones": ["zone"],
    Controller: ["controller"],
  },
  boards: {
    Board: ["title", "material", "caliper", "grain"],
    Creases: [
      ...["crease_along", "crease_across", "crease_tolerance"],
      ...["end_clearance", "short_crease", "double_crease"],
    ],
    "Bends of cuts": ["cut_tolerance", "least_radius"],
    "Limits of tools": ["limits"],
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

/** Names of fields for people; other fields are called as in the TOML file. */
const LABELS: Readonly<Record<string, string>> = {
  area: "Reachable area",
  blade_angle: "Blade angle",
  crease_tolerance: "Tolerance of bent creases",
  cut_tolerance: "Tolerance of bent cuts",
  dialect: "Controller language",
  into_mat: "Depth in the mat",
  datum: "Offset of the station",
  envelope: "Radius of the holder",
  feed: "Loading of sheets",
  grain: "Direction of flute or grain",
  groove_curve: "Tolerance of curved grooves",
  groove_pass: "Depth of one groove pass",
  groove_shift: "Shift of grooves beside cuts",
  gantry: "Gantry with several carriages",
  least_radius: "Least radius of a bend",
  life: "Tool life",
  min_distance: "Least distance of carriages",
  origin: "Place of the drawing",
  park: "Parking position",
  settle: "Waiting time of outputs",
  short_crease: "Creases shorter than the wheel",
  travel_z: "Travel height",
  turn_clearance: "Clearance in turns",
};
/** Names of fields inside tables, where they mean something else. */
const INNER_LABELS: Readonly<Record<string, string>> = { feed: "Feed rate" };
/** Names of the items of lists of fixed length. */
const ITEM_LABELS: Readonly<Record<string, readonly string[]>> = {
  area: ["Left", "Bottom", "Right", "Top"],
  origin: ["Place in X", "Place in Y"],
  perforation: ["Length of cuts", "Length of gaps"],
  speed: ["Least speed", "Greatest speed"],
  force: ["Least force", "Greatest force"],
};

/** Name of a field for people, from its name and its path. */
export function fieldLabel(name: string, path: string): string {
  const inner = path.includes(" → ") ? INNER_LABELS[name] : undefined;
  const words = inner ?? LABELS[name] ?? name.replaceAll("_", " ");
  return words.charAt(0).toUpperCase() + words.slice(1);
}

/** Name of an item of a list, counted from 0. */
export const itemLabel = (list: string, at: number): string =>
  ITEM_LABELS[list]?.[at] ?? `${fieldLabel(list, "")} ${at + 1}`;

/** Fields of a table, with those whose schema depends on the values of others. */
export function fieldsOf(schema: Schema, values: Fields): Readonly<Record<string, Schema>> {
  const met = (schema.allOf ?? []).filter((one) =>
    Object.entries(one.if?.properties ?? {}).every(
      ([name, { const: wanted }]) => values[name] === wanted,
    ),
  );
  const changed = met.flatMap(({ then }) => Object.entries(then?.properties ?? {}));
  const fields = { ...schema.properties };
  for (const [name, one] of changed) fields[name] = { ...fields[name], ...one };
  return fields;
}

/** Whether a field may be left out or null. */
export const isOptional = (schema: Schema): boolean =>
  schema.anyOf?.some(({ type }) => type === "null") === true;

/** First value of a new table: the tables in it that must be there, and nothing else. */
export function emptyTable(schema: Schema, root: Schema): Fields {
  const table = resolved(schema, root);
  const needed = (table.required ?? []).filter(
    (name) => resolved(table.properties?.[name] ?? {}, root).properties !== undefined,
  );
  return Object.fromEntries(
    needed.map((name) => [name, emptyTable(table.properties?.[name] ?? {}, root)]),
  );
}

/** Resolve a reference, and leave out the alternative null. */
export function resolved(schema: Schema, root: Schema): Schema {
  const [one, ...others] = (schema.anyOf ?? []).filter(({ type }) => type !== "null");
  if (one !== undefined && others.length === 0) {
    const found = resolved(one, root);
    const description = schema.description ?? found.description;
    return { ...found, ...(description === undefined ? {} : { description }) };
  }
  const name = schema.$ref?.split("/").pop();
  const found = name === undefined ? undefined : root.$defs?.[name];
  return found === undefined ? schema : { ...found, ...schema, properties: found.properties ?? {} };
}

/** Path of a field as faults name it. */
export const pathOf = (parent: string, key: string): string =>
  parent === "" ? key : `${parent} → ${key}`;

/** Texts of the faults of a refused definition beside their fields, by the path of the field. */
export function faultsOf(error: unknown): Readonly<Record<string, string>> {
  if (!(error instanceof ServiceError)) return {};
  const faults = (error.problem.arguments as { faults?: ServerMessage[] }).faults ?? [];
  return Object.fromEntries(
    faults.map((fault) => [
      String(fault.arguments.path ?? ""),
      renderText({ ...fault, arguments: { ...fault.arguments, path: "This value" } }),
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

/** Fetch the library again, and the definitions on display. */
export async function refreshLibrary(): Promise<void> {
  const keys = ["definition", "definitionVersions"];
  await Promise.all([
    refreshChoices(),
    ...keys.map((key) => queryClient.invalidateQueries({ queryKey: [key] })),
  ]);
}
