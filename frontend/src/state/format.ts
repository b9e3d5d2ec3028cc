/** Formatting of figures for display. */

import { formatDate, formatFixed, formatNumber } from "../language/numbers";
import { translate } from "../language/translate";

const THIN = "\u202f";

/** A length in mm, or in m from ten metres up. */
export function formatLength(value: number): string {
  if (!Number.isFinite(value)) return "–";
  if (value === 0) return `0${THIN}mm`;
  if (Math.abs(value) < 0.05) return `<${THIN}${formatNumber(0.1)}${THIN}mm`;
  if (Math.abs(value) >= 10_000) return `${formatFixed(value / 1000, 2)}${THIN}m`;
  return `${formatFixed(value, Math.abs(value) >= 100 ? 0 : 1)}${THIN}mm`;
}

/** A size in bytes, kB or MB. */
export function formatBytes(size: number): string {
  if (size < 1000) return `${formatNumber(size)}${THIN}B`;
  if (size < 1e6) return `${formatFixed(size / 1000, 1)}${THIN}kB`;
  return `${formatFixed(size / 1e6, 1)}${THIN}MB`;
}

/** A length in m. */
export const formatMetres = (value: number): string =>
  `${formatNumber(value, { maximumFractionDigits: value < 100 ? 1 : 0 })}${THIN}m`;

/** A length in an unknown unit. */
export const formatUnitless = (value: number): string =>
  formatNumber(value, { maximumFractionDigits: Math.abs(value) >= 100 ? 1 : 3 });

/** A length in mm, rounded to hundredths. */
export function formatHundredths(value: number): string {
  if (!Number.isFinite(value)) return "–";
  return value < 0.005 ? `0${THIN}mm` : `${formatFixed(value, 2)}${THIN}mm`;
}

/** The width of a line in a file, given in 1/100 mm, or in 1/100 of an unknown unit. */
export function formatLineWidth(hundredths: number, isUnitKnown = true): string {
  if (hundredths === 0) return translate("format.thinnest");
  return isUnitKnown
    ? `${formatNumber(hundredths / 100)}${THIN}mm`
    : formatUnitless(hundredths / 100);
}

/** A deviation in mm, with four decimals. */
export function formatDeviation(value: number): string {
  if (!Number.isFinite(value)) return "–";
  if (value === 0) return `0${THIN}mm`;
  return value < 0.0001
    ? `<${THIN}${formatFixed(0.0001, 4)}${THIN}mm`
    : `${formatFixed(value, 4)}${THIN}mm`;
}

/** An area in mm², or in cm² from ten of those up. */
export function formatArea(value: number): string {
  if (!Number.isFinite(value)) return "–";
  if (value >= 1000) return `${formatFixed(value / 100, 1)}${THIN}cm²`;
  return `${formatFixed(value, value >= 100 ? 0 : value >= 10 ? 1 : 2)}${THIN}mm²`;
}

/** A time in s; minutes and hours from 60 s and 60 min on. The job ticket rounds in the same way. */
export function formatDuration(seconds: number): string {
  if (!Number.isFinite(seconds)) return "–";
  const whole = Math.max(0, Math.round(seconds));
  // 9.95 s and more are rounded to 10 s.
  if (seconds < 9.95) return `${formatFixed(Math.max(0, seconds), 1)}${THIN}s`;
  if (whole < 60) return `${whole}${THIN}s`;
  const minutes = Math.floor(whole / 60);
  if (minutes < 60) return `${minutes}:${String(whole % 60).padStart(2, "0")}${THIN}min`;
  return `${Math.floor(minutes / 60)}:${String(minutes % 60).padStart(2, "0")}${THIN}h`;
}

export function formatAgo(then: number, now: number): string {
  const seconds = Math.max(0, now - then);
  if (seconds < 60) return translate("format.justNow");
  if (seconds < 3600) return translate("format.minutesAgo", { minutes: Math.floor(seconds / 60) });
  if (seconds < 86_400) return translate("format.hoursAgo", { hours: Math.floor(seconds / 3600) });
  return formatDate(new Date(then * 1000));
}

/** Width and height in mm, or in m where either is ten metres or more. */
export const formatSize = (width: number, height: number): string =>
  Math.max(width, height) < 10_000
    ? `${formatFixed(width, 1)} × ${formatFixed(height, 1)}${THIN}mm`
    : `${formatFixed(width / 1000, 2)} × ${formatFixed(height / 1000, 2)}${THIN}m`;
