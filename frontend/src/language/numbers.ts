/** Numbers and times in the language of the page. */

import { language, locale } from "./language";

/** A number with separators of thousands, and at most three decimals unless `options` say otherwise. */
export const formatNumber = (value: number, options?: Intl.NumberFormatOptions): string =>
  new Intl.NumberFormat(language, options).format(value);

/** A number with a fixed count of decimals and without separators of thousands. */
export const formatFixed = (value: number, digits: number): string =>
  formatNumber(value, {
    minimumFractionDigits: digits,
    maximumFractionDigits: digits,
    useGrouping: false,
  });

/** A number with a true minus sign, as figures of positions have it. */
export const withMinusSign = (figure: string): string => figure.replace("-", "\u2212");

/** A date as the browser's region writes it. */
export const formatDate = (date: Date, options?: Intl.DateTimeFormatOptions): string =>
  date.toLocaleDateString(locale, options);

/** A date and a time of day as the browser's region writes them. */
export const formatDateTime = (date: Date, options?: Intl.DateTimeFormatOptions): string =>
  date.toLocaleString(locale, options);

/** A title as it is written inside a sentence: English writes it small, German does not. */
export const insideSentence = (title: string): string =>
  language === "en" ? title.toLowerCase() : title;

/** What separates the decimals of a number. */
export const decimalSeparator: string =
  new Intl.NumberFormat(language).formatToParts(1.5).find(({ type }) => type === "decimal")
    ?.value ?? ".";
