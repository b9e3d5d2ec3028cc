/** Texts of the options of edges: their identifiers follow from the names of options and fields. */

import type { EDGE_OPTIONS } from "../../api/options.gen";
import type { LineType } from "../../geometry/records";
import { formatNumber } from "../../language/numbers";
import { type TextId, translate } from "../../language/translate";
import { LINE_STYLES } from "../../state/drawing/palette";
import {
  type EdgeChoice,
  type EdgeOptionName,
  edgeFields,
  type FieldValue,
  hasHelp,
  type Target,
} from "../../state/order/edgeOptions";

type Options = typeof EDGE_OPTIONS;
type FieldName<Name extends EdgeOptionName> = keyof Options[Name]["fields"] & string;
type ChoicesOf<Field> = Field extends { choices: readonly (infer Choice extends string)[] }
  ? Choice
  : never;

/** The texts that each option needs: its title, and the names of its fields and of their values. */
type Needed = {
  [Name in EdgeOptionName]:
    | `edgeOption.${Name}`
    | `edgeOption.${Name}.${FieldName<Name>}`
    | (Options[Name]["help"] extends true ? `edgeOption.${Name}.help` : never)
    | {
        [Field in FieldName<Name>]: `edgeOption.${Name}.${Field}.${ChoicesOf<
          Options[Name]["fields"][Field & keyof Options[Name]["fields"]]
        >}`;
      }[FieldName<Name>];
}[EdgeOptionName];

/** Translate a text by its composed identifier. The compiler checks that `Needed` are texts. */
const text = (...parts: readonly string[]): string =>
  translate(["edgeOption", ...parts].join(".") as Needed satisfies TextId);

export const optionTitle = (name: EdgeOptionName): string => text(name);

/** Help text of an option; null if it has none. */
export const optionHelp = (name: EdgeOptionName): string | null =>
  hasHelp(name) ? text(name, "help") : null;

export const fieldText = (name: EdgeOptionName, field: string): string => text(name, field);

export const choiceText = (name: EdgeOptionName, field: string, choice: string): string =>
  text(name, field, choice);

/** The value of a field with its unit. */
export function valueText(name: EdgeOptionName, key: string, value: FieldValue): string {
  const field = edgeFields(name)[key];
  if (typeof value === "string") return choiceText(name, key, value);
  if (value === null || field === undefined) return translate("edgeOption.asUsual");
  if (field.unit === "station") return translate("edgeOption.station", { number: value });
  if (field.unit === "fraction") return formatNumber(value, { style: "percent" });
  return field.unit === "mm"
    ? translate("edgeOption.millimetres", { value: formatNumber(value) })
    : `${formatNumber(value)}${field.unit}`;
}

/** The edges or the line type of a choice. */
export const targetOf = ({ edges, line_type: type }: EdgeChoice): Target =>
  type == null ? (edges ?? []) : (type as LineType);

export const targetText = (target: Target): string =>
  typeof target === "string"
    ? translate("edgeOption.allOfType", { type: LINE_STYLES[target].title })
    : translate("edgeOption.edges", { n: target.length, edge: target[0] ?? 0 });

/** The values of a choice that are not the usual ones. */
export const choiceSummary = (name: EdgeOptionName, choice: EdgeChoice): string =>
  Object.entries(edgeFields(name))
    .filter(([key, field]) => (choice[key] ?? field.default) !== field.default)
    .map(([key]) => `${fieldText(name, key)}: ${valueText(name, key, choice[key] as FieldValue)}`)
    .join(" · ");

/** A choice in one line: its edges, and its values. */
export const choiceLine = (name: EdgeOptionName, choice: EdgeChoice): string =>
  `${targetText(targetOf(choice))} · ${choiceSummary(name, choice)}`;
