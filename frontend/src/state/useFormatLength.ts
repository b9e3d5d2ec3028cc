/** Formatter for lengths of the open drawing: in mm, or without unit if its unit is unknown. */

import { formatLength, formatUnitless } from "./format";
import { useDrawing } from "./queries";

export function useFormatLength(): (value: number) => string {
  const { data: drawing } = useDrawing();
  return drawing?.unit === null ? formatUnitless : formatLength;
}
