/** Texts of the options of a job: their identifiers follow from the names of the options. */

import { formatNumber } from "../../language/numbers";
import { type TextId, translate } from "../../language/translate";
import { type OptionName, optionField } from "../../state/order/options";

export const optionLabel = (name: OptionName): string => translate(`option.${name}`);

export const descriptionText = (name: OptionName): string =>
  translate(`option.${name}.description`);

/** The value of an option. The compiler checks that each language has the texts of the choices. */
export function valueLabel(name: OptionName, value: string | number | boolean): string {
  if (typeof value === "number") return formatNumber(value);
  if (typeof value === "boolean") return value ? translate("option.on") : translate("option.off");
  if (optionField(name).kind !== "choice") return value;
  return translate(`option.${name}.${value}` as TextId & `option.${string}`);
}
