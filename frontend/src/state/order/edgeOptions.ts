/** Options of a job that concern some edges: what is chosen for an edge, and how it changes. */

import type { Machine } from "../../api/machines";
import { EDGE_OPTIONS } from "../../api/options.gen";
import { pointAt } from "../../geometry/arc";
import { type Edges, type LineType, lineTypeOf, type Point } from "../../geometry/records";

export type EdgeOptionName = keyof typeof EDGE_OPTIONS;
export type FieldValue = number | string | null;

/** A choice for some edges or for a line type, with the fields of its option. */
export interface EdgeChoice {
  readonly edges?: readonly number[] | undefined;
  readonly line_type?: string | null | undefined;
  readonly [field: string]: unknown;
}

/** What a choice is made for: some edges, or all edges of a line type. */
export type Target = readonly number[] | LineType;

export interface NumberField {
  readonly kind: "number";
  readonly min: number;
  readonly max: number;
  readonly whole: boolean;
  readonly default: number | null;
  /** fraction: a place on the edge, 0 at its start; mm: a length; station: a tool of the machine. */
  readonly unit: string;
}

export interface ChoiceField {
  readonly kind: "choice";
  readonly choices: readonly string[];
  readonly default: string;
  /** direction: of the tool along the edge. */
  readonly unit: string;
}

export type EdgeField = NumberField | ChoiceField;
type Fields = Readonly<Record<string, EdgeField>>;

export const EDGE_OPTION_NAMES = Object.keys(EDGE_OPTIONS) as EdgeOptionName[];

/** The fields of an option, by name. */
export const edgeFields = (name: EdgeOptionName): Fields => EDGE_OPTIONS[name].fields;

/** Whether an option may be chosen for a line type as a whole. */
export const isByType = (name: EdgeOptionName): boolean => EDGE_OPTIONS[name].byType;

/** Whether only cutters and lasers can make what an option chooses. */
export const isOfCutters = (name: EdgeOptionName): boolean => EDGE_OPTIONS[name].ofCutters;

/** Whether there is a text about an option. */
export const hasHelp = (name: EdgeOptionName): boolean => EDGE_OPTIONS[name].help;

/** The stations of a machine whose tools may be chosen for all of some edges. */
export const stationsForEdges = (
  machine: Machine | undefined,
  edges: Edges,
  rows: readonly number[],
): Machine["stations"] => {
  const types = new Set(rows.map((row) => lineTypeOf(edges.lineType[row])));
  return (machine?.stations ?? []).filter(({ line_types: made }) =>
    [...types].every((type) => (made as readonly LineType[]).includes(type)),
  );
};

/** The options that some edges may have: each of them has one of the line types of the option. */
export const optionsForEdges = (edges: Edges, rows: readonly number[]): EdgeOptionName[] => {
  const selected = [...new Set(rows.map((row) => lineTypeOf(edges.lineType[row])))];
  return EDGE_OPTION_NAMES.filter((name) => {
    const types: readonly LineType[] = EDGE_OPTIONS[name].types;
    return selected.every((type) => types.includes(type));
  });
};

type Values = Readonly<Record<string, FieldValue>>;

const isDefault = (fields: Fields, values: Values): boolean =>
  Object.entries(fields).every(([key, field]) => values[key] === field.default);

const isFor = (choice: EdgeChoice, target: number | LineType): boolean =>
  typeof target === "number"
    ? choice.edges?.includes(target) === true
    : choice.line_type === target;

/** What is chosen for an edge or a line type; of several choices the last counts. */
export function chosenValues(
  fields: Fields,
  choices: readonly EdgeChoice[],
  target: number | LineType,
): Values {
  const chosen = choices.findLast((choice) => isFor(choice, target));
  return Object.fromEntries(
    Object.entries(fields).map(([key, field]) => [
      key,
      (chosen?.[key] ?? field.default) as FieldValue,
    ]),
  );
}

/** The choices after one field has changed; edges with equal values share a choice. */
export function withValue(
  fields: Fields,
  choices: readonly EdgeChoice[],
  target: Target,
  key: string,
  value: FieldValue,
): EdgeChoice[] {
  const left = withoutTarget(choices, target);
  const changed = (one: number | LineType): Values => ({
    ...chosenValues(fields, choices, one),
    [key]: value,
  });
  if (typeof target === "string") {
    const values = changed(target);
    return isDefault(fields, values) ? left : [...left, { ...values, line_type: target }];
  }
  const groups = new Map<string, { edges: number[]; values: Values }>();
  for (const row of target) {
    const values = changed(row);
    if (isDefault(fields, values)) continue;
    const text = JSON.stringify(values);
    const group = groups.get(text);
    if (group === undefined) groups.set(text, { edges: [row], values });
    else group.edges.push(row);
  }
  return [...left, ...[...groups.values()].map(({ edges, values }) => ({ ...values, edges }))];
}

/** The choices without those for some edges or for a line type. */
export function withoutTarget(choices: readonly EdgeChoice[], target: Target): EdgeChoice[] {
  if (typeof target === "string") return choices.filter((choice) => !isFor(choice, target));
  return choices
    .map((choice) => ({ ...choice, edges: choice.edges?.filter((row) => !target.includes(row)) }))
    .filter(({ edges, line_type: type }) => type != null || (edges?.length ?? 0) > 0);
}

/** The line type of some edges if it is the same for all; null otherwise. */
export function commonType(edges: Edges, rows: readonly number[]): LineType | null {
  const types = new Set(rows.map((row) => lineTypeOf(edges.lineType[row])));
  const [type] = types;
  return types.size === 1 && type !== undefined ? type : null;
}

/** Arrow along an edge from its start to its end, as the drawing is shown; with Y upwards. */
export function arrowAlong(edges: Edges, row: number, reverse = false): string {
  const [x0 = 0, y0 = 0, x1 = 0, y1 = 0] = edges.ends.subarray(row * 4, row * 4 + 4);
  const turn = Math.round((Math.atan2(y1 - y0, x1 - x0) * 4) / Math.PI) + (reverse ? 4 : 0);
  return "→↗↑↖←↙↓↘".charAt(((turn % 8) + 8) % 8);
}

/** The places on edges that are chosen with a field in fractions, for marks in the drawing. */
export function chosenPlaces(
  options: Readonly<Record<EdgeOptionName, readonly EdgeChoice[]>>,
  edges: Edges | null,
): Point[] {
  if (edges === null) return [];
  const places: Point[] = [];
  for (const name of EDGE_OPTION_NAMES) {
    const key = Object.entries(edgeFields(name)).find(([, { unit }]) => unit === "fraction")?.[0];
    for (const choice of key === undefined ? [] : options[name]) {
      const share = choice[key ?? ""];
      if (typeof share !== "number") continue;
      for (const row of choice.edges ?? []) {
        const [x0, y0, x1, y1] = edges.ends.subarray(row * 4, row * 4 + 4);
        const bulge = edges.bulge[row];
        if (x0 === undefined || y0 === undefined || x1 === undefined || y1 === undefined) continue;
        const [x, y] = pointAt(x0, y0, x1, y1, bulge ?? 0, share);
        places.push({ x, y });
      }
    }
  }
  return places;
}
