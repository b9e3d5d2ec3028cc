/** What the service asks, taken apart: much of it stands on the card already. */

/** Which edges are meant: the card shows their layer, colour, linetype and length. */
const WHICH = /^[\d,.]+ edges? on layer .*?: what (?:are they|is it)\?\s*/s;
const LIKELY = /^Most likely [^(]+ \((\d+) %\): (.*)$/s;

export interface Asked {
  /** What a card does not show anyway. */
  readonly text: string;
  /** How sure the likeliest answer is (%); null where nothing speaks for any. */
  readonly share: number | null;
  /** What speaks for it, as a sentence. */
  readonly why: string;
}

export function askedOf(text: string): Asked {
  const left = text.replace(WHICH, "");
  const [, share, why = ""] = LIKELY.exec(left) ?? [];
  if (share === undefined) return { text: left, share: null, why: "" };
  return { text: "", share: Number(share), why: why.slice(0, 1).toUpperCase() + why.slice(1) };
}
