/**
 * Renders messages of the server in the language of the page.
 *
 *     {name}                    the argument; a message is rendered, null is left out
 *     {name!r}                  the same in quotes
 *     {names:, }  {names:or}    items of a list, joined with the text after the colon; "a, b or c"
 *     {error:hint}              the hint of a message, or the hints of a list, instead of the text
 *     {n:# edge|# edges}        the first form for 1, else the second; # is the number
 *     {x:,.1f}  {x:.3f}  {x:g}  decimals, with or without separators; significant digits
 *     {size:mm}  {size:MB}      a length with useful decimals; bytes as mebibytes
 *     {unit:unit}  {tool:tool}  name of a unit of length; of a tool
 */

import { ServiceError } from "../api/client";
import type { Message } from "./catalogue";
import { TEXTS, TOOLS, UNITS } from "./en.gen";

/** A message as the server sends it; `text` and `hint` are its own English. */
export interface ServerMessage {
  readonly code: string;
  readonly arguments: Readonly<Record<string, unknown>>;
  readonly text?: string;
  readonly hint?: string;
}

interface Templates {
  readonly text: string;
  readonly hint: string;
}

/** Templates of a code; undefined for a code that only a newer server has. */
const templatesOf = (code: string): Templates | undefined =>
  (TEXTS as Readonly<Record<string, Templates>>)[code];

/** The text of a message. */
export function renderText(message: ServerMessage): string {
  const template = templatesOf(message.code)?.text;
  return template === undefined ? (message.text ?? "") : fill(template, message.arguments);
}

/** What to do about a message; empty if nothing. */
export function renderHint(message: ServerMessage): string {
  const template = templatesOf(message.code)?.hint;
  if (template === undefined) return message.hint ?? "";
  // A hint may begin or end with the empty hint of an argument.
  return fill(template, message.arguments).trim();
}

/** What an error reports: the rendered problem of the server, or its own message. */
export const errorText = (error: Error): string =>
  error instanceof ServiceError ? renderText(error.problem) : error.message;

/** A message with the types of its arguments, to look into them by its code. */
export const typed = (message: ServerMessage): Message => message as Message;

function fill(template: string, values: Readonly<Record<string, unknown>>): string {
  return template.replaceAll(
    /\{(\w+)(!r)?(?::([^{}]*))?\}/g,
    (_, name: string, quoted?: string, format = "") => {
      const value = formatValue(values[name], format);
      return quoted === undefined ? value : `'${value}'`;
    },
  );
}

const isMessage = (value: unknown): value is ServerMessage =>
  typeof value === "object" && value !== null && "code" in value && "arguments" in value;

function formatValue(value: unknown, format: string): string {
  if (value === null || value === undefined) return "";
  if (isMessage(value)) return format === "hint" ? renderHint(value) : renderText(value);
  if (Array.isArray(value)) return joinItems(value, format);
  if (format === "unit") return UNITS[String(value)] ?? String(value);
  if (format === "tool") return TOOLS[String(value)] ?? String(value);
  if (typeof value !== "number") return String(value);
  return formatNumber(value, format);
}

function joinItems(values: readonly unknown[], format: string): string {
  if (format === "hint") {
    const hints = values.map((item) => formatValue(item, format));
    return [...new Set(hints)].filter((hint) => hint !== "").join(" ");
  }
  const items = values.map((item) => formatValue(item, ""));
  if (format !== "or") return items.join(format === "" ? ", " : format);
  const last = items.pop() ?? "";
  return items.length === 0 ? last : `${items.join(", ")} or ${last}`;
}

function formatNumber(value: number, format: string): string {
  if (format === "MB") return (value / 2 ** 20).toFixed(1);
  if (format === "mm") return formatMillimetres(value);
  const [one, many] = format.split("|");
  if (one !== undefined && many !== undefined) {
    return (value === 1 ? one : many).replaceAll("#", value.toLocaleString("en"));
  }
  const digits = Number.parseInt(format.slice(format.indexOf(".") + 1), 10);
  if (format.endsWith("g")) return String(Number(value.toPrecision(digits || 6)));
  if (!format.endsWith("f")) return format === "," ? value.toLocaleString("en") : String(value);
  return value.toLocaleString("en", {
    minimumFractionDigits: digits,
    maximumFractionDigits: digits,
    useGrouping: format.startsWith(","),
  });
}

function formatMillimetres(value: number): string {
  if (Math.abs(value) >= 1000) return value.toFixed(0);
  return value >= 1 ? value.toFixed(1) : String(Number(value.toPrecision(3)));
}
