/** The largest rectangle of board that stays whole beside the blanks of a sheet. */

import type { Box } from "../../geometry/records";
import { boxOfCopy, type Copy } from "./shapes";

export interface Size {
  readonly width: number;
  readonly height: number;
}

/** Sides below which a remnant is waste (mm). */
const LEAST = 100;

/**
 * The larger of the strips to the right of all copies and above them, at a gap from the copies;
 * null if it is too small to be used.
 */
export function remnantOf(copies: readonly Copy[], sheet: Size, gap: number): Size | null {
  if (copies.length === 0) return null;
  const boxes: Box[] = copies.map(boxOfCopy);
  const right = Math.max(...boxes.map((box) => box[2])) + gap;
  const above = Math.max(...boxes.map((box) => box[3])) + gap;
  const strips = [
    { width: Math.floor(sheet.width - right), height: sheet.height },
    { width: sheet.width, height: Math.floor(sheet.height - above) },
  ].filter(({ width, height }) => Math.min(width, height) >= LEAST);
  const area = ({ width, height }: Size) => width * height;
  return strips.sort((a, b) => area(b) - area(a))[0] ?? null;
}
