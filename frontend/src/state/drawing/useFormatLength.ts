/** Formatters for lengths of the open drawing: in mm, or without unit if its unit is unknown. */

import { formatLength, formatLineWidth, formatUnitless } from "../format";
import { useDrawing } from "../queries";

export function useFormatLength(): (value: number) => string {
  const { data: drawing } = useDrawing();
  return drawing?.unit === null ? formatUnitless : formatLength;
}

/** The formatter for line widths, which are given in hundredths. */
export function useFormatLineWidth(): (hundredths: number) => string {
  const { data: drawing } = useDrawing();
  return (hundredths) => formatLineWidth(hundredths, drawing?.unit !== null);
}
