/** Settings that follow from the measures of a test piece, in the file of a machine or a board. */

import type { Bench, Figure, Measures, TestPiece } from "../../api/testpieces";
import { type Fields, withValue } from "./definitions";

/** A measure that a person types, from the schema of the server. */
export interface MeasureField {
  readonly name: string;
  readonly title: string;
  readonly description: string;
  readonly whole: boolean;
  readonly required: boolean;
  readonly initial: number | null;
}

interface FieldSchema {
  readonly title?: string;
  readonly description?: string;
  readonly type?: string;
  readonly anyOf?: readonly { readonly type?: string }[];
  readonly default?: unknown;
}

/** The measures of a test piece in their order; the accuracy of reading, which all have, is last. */
export function measureFields(piece: TestPiece): readonly MeasureField[] {
  const schema = piece.measures as {
    readonly properties: Readonly<Record<string, FieldSchema>>;
    readonly required?: readonly string[];
  };
  const fields = Object.entries(schema.properties).map(([name, field]) => ({
    name,
    title: field.title ?? name,
    description: field.description ?? "",
    whole: (field.type ?? field.anyOf?.[0]?.type) === "integer",
    required: schema.required?.includes(name) ?? false,
    initial: typeof field.default === "number" ? field.default : null,
  }));
  return [...fields.slice(1), ...fields.slice(0, 1)];
}

/**
 * The machine or board with a name. Without it the first one, but not while the entry that is
 * measured is still missing in the list: the form would begin anew when it is loaded.
 */
export const chosenEntry = <T extends { readonly name: string }>(
  all: readonly T[],
  name: string | null,
  measured: string | null,
): T | undefined =>
  all.find((one) => one.name === name) ?? (name === measured && name !== null ? undefined : all[0]);

/** What was typed, with the values that fields have from the beginning; null if one is missing. */
export function givenMeasures(
  fields: readonly MeasureField[],
  typed: Readonly<Record<string, number | "">>,
): Measures | null {
  const given: Record<string, number> = {};
  for (const { name, required, initial } of fields) {
    const value = typed[name] ?? initial ?? "";
    if (value !== "") given[name] = value;
    else if (required) return null;
  }
  return given;
}

/** The definition of a machine or a board with the new values of some figures. */
export const withFigures = (fields: Fields, figures: readonly Figure[]): Fields =>
  figures.reduce<Fields>((now, { path, after }) => withValue(now, path, after), fields);

/** The name of the file in which a figure is stored. */
export const ownerOf = (shelf: "machines" | "boards", bench: Bench): string =>
  shelf === "machines" ? bench.machine : bench.board;
