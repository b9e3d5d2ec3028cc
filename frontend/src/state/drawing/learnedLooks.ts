/** Texts and keys of looks that earlier drawings of a customer have taught. */

import type { LookUse, TaughtLook } from "../../api/drawings";
import { translate } from "../../language/translate";
import { colourName } from "./colours";

export type Look = Omit<LookUse, "used">;

/** The fields by which the server finds a look. */
export const lookOf = (one: Look): Look => ({
  layer: one.layer,
  colour: one.colour,
  true_colour: one.true_colour,
  linetype: one.linetype,
  line_width: one.line_width,
});

export const lookKey = (look: Look): string => JSON.stringify(lookOf(look));

/** Layer of a look; layers whose names mean nothing are one. */
export const lookTitle = ({ layer }: Look): string =>
  layer === ""
    ? translate("learnedLooks.layersWithoutAMeaning")
    : translate("learnedLooks.layer", { layer });

/** Colour, line style and line width of a look. */
export function lookFacts({ colour, true_colour, linetype, line_width }: Look): string {
  const hex = `#${true_colour.toString(16).padStart(6, "0")}`;
  const facts = [
    translate("learnedLooks.colour", { colour: true_colour < 0 ? colourName(colour) : hex }),
  ];
  if (linetype !== "") facts.push(translate("learnedLooks.lineStyle", { linetype }));
  if (line_width >= 0)
    facts.push(translate("learnedLooks.lineWidthMm", { lineWidth: line_width / 100 }));
  return facts.join(", ");
}

/** The looks that a user has taken back. */
export const refusedLooks = (answers: readonly TaughtLook[]): TaughtLook[] =>
  answers.filter(({ used }) => !used);
