/**
 * Texts of the page in the chosen language; `translate` returns them.
 *
 * They are ICU MessageFormat. `en.ts` is the source; the compiler checks identifiers and arguments,
 * and that the other languages have the same ones.
 */

import { type Formatters, IntlMessageFormat } from "intl-messageformat";
import type { ArgumentsOf } from "./arguments";
import { en } from "./en";
import { language } from "./language";
import { numberFormat } from "./numberFormat";

type Texts = typeof en;
export type TextId = keyof Texts;
/** Texts of another language: those of `en`. */
export type Translation = { readonly [Id in TextId]: string };
/** The arguments of a text by their names. */
export type ValuesOf<Id extends TextId> = ArgumentsOf<Texts[Id]>;
export type TextOf<Id extends TextId> = Texts[Id];

// The page waits for the texts of its language, so that modules may use them in constants.
const texts: Translation = language === "de" ? (await import("./de")).de : en;
const formats = new Map<string, IntlMessageFormat>();
const formatters: Formatters = {
  getNumberFormat: numberFormat,
  getDateTimeFormat: (...options) => new Intl.DateTimeFormat(...options),
  getPluralRules: (...options) => new Intl.PluralRules(...options),
};

/** The text of an identifier, with its arguments. */
export function translate<Id extends TextId>(
  id: Id,
  ...values: keyof ValuesOf<Id> extends never ? [] : [values: ValuesOf<Id>]
): string {
  return formatText(texts[id], language, values[0]);
}

/** A text in ICU MessageFormat of a language, with its arguments; `<` is a character as any other. */
export const formatText = (
  text: string,
  language: string,
  values?: Readonly<Record<string, string | number>>,
): string => String(parsed(text, language, true).format(values));

/** The format of a text whose tags become elements. */
export const richFormat = (id: TextId): IntlMessageFormat => parsed(texts[id], language, false);

/** The format of a text, which is parsed once. */
function parsed(text: string, language: string, ignoreTag: boolean): IntlMessageFormat {
  const key = `${language} ${text}`;
  let format = formats.get(key);
  if (format === undefined) {
    format = new IntlMessageFormat(text, language, undefined, { ignoreTag, formatters });
    formats.set(key, format);
  }
  return format;
}
