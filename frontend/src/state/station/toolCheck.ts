/** Checks of the tools of a waiting job: points above the table, and corrections of datums. */

import type { Drawing } from "../../api/drawings";
import { pageProblem } from "../../api/errors";
import { libraryService } from "../../api/library";
import type { Machine } from "../../api/machines";
import { translate } from "../../language/translate";
import { refreshLibrary } from "../library/definitions";
import { AXES, type Axis } from "./station";

/** Trial correction of a datum: X, Y, Z (mm) and C (degrees). */
export type Shift = readonly [number, number, number, number];

export const NO_SHIFT: Shift = [0, 0, 0, 0];

/** Largest correction that the gateway accepts (mm or degrees). */
const LARGEST = 20;
/** Distance of the point beside the sheet from its corner (mm). */
const BESIDE = 15;

/** A shift with one axis changed by a step; sums of steps stay round. */
export function shifted(shift: Shift, axis: Axis, step: number): Shift {
  const [x, y, z, c] = shift.map((value, at) => {
    if (AXES[at] !== axis) return value;
    const wanted = Math.round((value + step) * 100) / 100;
    return Math.min(Math.max(wanted, -LARGEST), LARGEST);
  }) as [number, number, number, number];
  return [x, y, z, c];
}

export const isShifted = (shift: Shift): boolean => shift.some((value) => value !== 0);

export interface Place {
  readonly key: string;
  readonly title: string;
  readonly point: readonly [number, number];
}

/** Points that a tool can be checked at: corners of the drawing, and beside its lower left one. */
export function placesOf({ origin }: Machine, drawing: Drawing | undefined): readonly Place[] {
  const [x = 0, y = 0] = origin;
  const places: Place[] = [
    { key: "corner", title: translate("toolCheck.lowerLeftCorner"), point: [x, y] },
    { key: "beside", title: translate("toolCheck.besideIt"), point: [x - BESIDE, y] },
  ];
  if (drawing !== undefined) {
    const [left, bottom, right, top] = drawing.bounds;
    const point = [x + right - left, y + top - bottom] as const;
    places.push({ key: "opposite", title: translate("toolCheck.upperRightCorner"), point });
  }
  return places;
}

type Fields = Record<string, unknown>;

/** Fields of a machine with a corrected datum of one station. */
export function withCorrection(fields: Fields, station: number, shift: Shift): Fields {
  const stations = (fields.station as readonly Fields[]).map((one) => {
    if (one.number !== station) return one;
    const datum = one.datum as Readonly<Record<string, number>>;
    const corrected = AXES.map((axis, at) => {
      const key = axis.toLowerCase();
      return [key, Math.round(((datum[key] ?? 0) + (shift[at] ?? 0)) * 1000) / 1000] as const;
    });
    return { ...one, datum: Object.fromEntries(corrected) };
  });
  return { ...fields, station: stations };
}

/** Note beside the button that compiles a job again; depends on the controller language. */
export const recompileNote = ({ language }: Machine): string =>
  language === "linuxcnc"
    ? translate("toolCheck.ifTheOffsetOfA")
    : translate("toolCheck.forTheNewestVersionOf");

/**
 * Save a corrected datum as a new version of the machine.
 *
 * Machines of the library cannot be changed; the hint of the error is to copy them.
 */
export async function saveCorrection(
  machine: Machine,
  station: number,
  shift: Shift,
): Promise<void> {
  const definition = await libraryService.definition("machines", machine.name);
  if (definition.shipped) {
    throw pageProblem(
      409,
      translate("toolCheck.theMachineCannotBeChanged"),
      translate("toolCheck.belongsToTheLibraryAnd", { title: machine.title || machine.name }),
      translate("toolCheck.copyItUnderAName"),
    );
  }
  await libraryService.putDefinition(
    { shelf: "machines", name: machine.name },
    withCorrection(definition.fields, station, shift),
    { version: definition.version, note: translate("toolCheck.datumOfStationAfterA", { station }) },
  );
  await refreshLibrary();
}
