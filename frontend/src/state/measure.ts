/** Lengths of the drawing that is open: in mm, or bare while nobody knows the unit of the file. */

import { useDrawing } from "./queries";
import { length, unitless } from "./words";

export function useLength(): (value: number) => string {
  const { data: drawing } = useDrawing();
  return drawing?.unit === null ? unitless : length;
}
