/**
 * Texts and hints of the server's messages, from their codes and arguments.
 *
 * The catalogue is in ICU MessageFormat like the page's own texts. An argument with an ending is
 * derived from one that the server sends: `reason__hint` is the hint of a message, `names__or` a
 * list with "or", `size__mm` a length with useful decimals, `unit__unit` the name of a unit.
 */

import { ServiceError } from "../api/errors";
import { formatText } from "../language/translate";
import type { Message, Names } from "./catalogue";

/** A message as the server sends it; `text` and `hint` are its own English. */
export interface ServerMessage {
  readonly code: string;
  readonly arguments: Readonly<Record<string, unknown>>;
  readonly text?: string;
  readonly hint?: string;
}

interface Entry {
  readonly text: string;
  readonly hint: string;
}

/** A generated catalogue: texts by code, names of words, and the words in lists. */
export interface Loaded {
  readonly TEXTS: Readonly<Record<string, Entry>>;
  readonly NAMES: Names;
  readonly AND: string;
  readonly OR: string;
}

/** Empty until a view sets it: the start page shows the texts that the server sends. */
let texts: Loaded = { TEXTS: {}, NAMES: {}, AND: "", OR: "" };
let locale = "en";

/** Set the texts with which messages are rendered, and the language of their numbers. */
export function setTexts(language: string, loaded: Loaded): void {
  locale = language;
  texts = loaded;
}

/** Entry of a code; undefined for a code that only a newer server has. */
const entryOf = (code: string): Entry | undefined => texts.TEXTS[code];

/** The text of a message; it may end with a sentence that is empty. */
export const messageText = (message: ServerMessage): string =>
  (format(entryOf(message.code)?.text, message) ?? message.text ?? "").trim();

/** What to do about a message; empty if nothing. */
export const messageHint = (message: ServerMessage): string =>
  // A hint may begin or end with the empty hint of an argument.
  (format(entryOf(message.code)?.hint, message) ?? message.hint ?? "").trim();

/** What an error reports: the problem of the server, or its own message. */
export const errorText = (error: Error): string =>
  error instanceof ServiceError ? messageText(error.problem) : error.message;

/** A message with the types of its arguments, to look into them by its code. */
export const typed = (message: ServerMessage): Message => message as Message;

/** The rendered message; undefined for a code or arguments that only another version has. */
function format(
  text: string | undefined,
  { arguments: values }: ServerMessage,
): string | undefined {
  if (text === undefined) return undefined;
  try {
    return formatText(
      text,
      locale,
      Object.fromEntries(Object.entries(values).flatMap(derivedValues)),
    );
  } catch {
    return undefined;
  }
}

/** An argument, and what is derived from it. */
function derivedValues([name, value]: [string, unknown]): [string, string | number][] {
  if (typeof value === "number")
    return [
      [name, value],
      [`${name}__mm`, lengthText(value)],
    ];
  if (typeof value === "string")
    return [
      [name, value],
      ...Object.entries(texts.NAMES).map(([kind, names]): [string, string] => [
        `${name}__${kind}`,
        names[value] ?? value,
      ]),
    ];
  const items = Array.isArray(value) ? value : value === null ? [] : [value];
  const words = items.map(itemText);
  const hints = items.filter(isMessage).map(messageHint);
  return [
    [name, words.join(", ")],
    ...Object.entries(texts.NAMES).map(([kind, names]): [string, string] => [
      `${name}__${kind}`,
      alternatives(words.map((word) => names[word] ?? word)),
    ]),
    [`${name}__or`, alternatives(words)],
    [`${name}__each_or`, words.join(` ${texts.OR} `)],
    [`${name}__and`, words.join(` ${texts.AND} `)],
    [`${name}__semicolon`, words.join("; ")],
    [`${name}__space`, words.join(" ")],
    [`${name}__hint`, [...new Set(hints)].filter((hint) => hint !== "").join(" ")],
  ];
}

const isMessage = (value: unknown): value is ServerMessage =>
  typeof value === "object" && value !== null && "code" in value && "arguments" in value;

const itemText = (item: unknown): string => (isMessage(item) ? messageText(item) : String(item));

/** The items of a list of alternatives: "A, B or C". */
const alternatives = (words: readonly string[]): string =>
  words.length < 2
    ? words.join("")
    : `${words.slice(0, -1).join(", ")} ${texts.OR} ${words[words.length - 1]}`;

/** A length with useful decimals. */
function lengthText(value: number): string {
  const size = Math.abs(value);
  const digits = size >= 1000 ? 0 : 1;
  return new Intl.NumberFormat(
    locale,
    size < 1
      ? { maximumSignificantDigits: 3 }
      : { minimumFractionDigits: digits, maximumFractionDigits: digits },
  ).format(value);
}
