/** Number formats of texts: numbers that no drawing has are written with an exponent. */

/** Numbers of this size get an exponent, as in `knifetip/messages/numbers.py`. */
const HUGE = 1e15;

type Options = Intl.NumberFormatOptions;

/** A number format that writes 1E200 instead of two hundred zeros. */
class NumberFormat extends Intl.NumberFormat {
  private readonly scientific: Intl.NumberFormat;

  constructor(locales?: string | string[], options?: Options) {
    super(locales, options);
    this.scientific = new Intl.NumberFormat(locales, {
      notation: "scientific",
      maximumSignificantDigits: 6,
    });
  }

  override format(value: number | bigint | Intl.StringNumericLiteral): string {
    return Math.abs(Number(value)) >= HUGE ? this.scientific.format(value) : super.format(value);
  }
}

const formats = new Map<string, NumberFormat>();

/** The format of a language for options, which is made once. */
export function numberFormat(locales?: string | string[], options?: Options): Intl.NumberFormat {
  const key = JSON.stringify([locales, options]);
  let format = formats.get(key);
  if (format === undefined) {
    format = new NumberFormat(locales, options);
    formats.set(key, format);
  }
  return format;
}
