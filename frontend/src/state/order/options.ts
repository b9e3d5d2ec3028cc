/** Options of a job that need no form of their own. */

import type { Job, ListOption } from "../../api/jobs";
import { OPTIONS } from "../../api/options.gen";
import { EDGE_OPTION_NAMES, type EdgeChoice, type EdgeOptionName } from "./edgeOptions";

export type OptionName = keyof typeof OPTIONS;
export type Options = Pick<Job, OptionName | EdgeOptionName | ListOption>;

const LIST_OPTIONS: readonly ListOption[] = ["work_order", "bridges"];
export const OPTION_NAMES = Object.keys(OPTIONS) as OptionName[];

/** An option with a plain value, as the server declares it. */
export type OptionField =
  | {
      readonly kind: "number";
      readonly min: number;
      readonly max: number;
      readonly default: number;
    }
  | { readonly kind: "choice"; readonly choices: readonly string[]; readonly default: string }
  | { readonly kind: "text"; readonly maxLength: number; readonly default: string }
  | { readonly kind: "switch"; readonly default: boolean };

export const optionField = (name: OptionName): OptionField => OPTIONS[name];

const valuesOf = (
  plain: (name: OptionName) => unknown,
  list: (name: EdgeOptionName | ListOption) => unknown,
): Options =>
  Object.fromEntries([
    ...OPTION_NAMES.map((name) => [name, plain(name)]),
    ...[...EDGE_OPTION_NAMES, ...LIST_OPTIONS].map((name) => [name, list(name)]),
  ]) as Options;

export const DEFAULT_OPTIONS = valuesOf(
  (name) => OPTIONS[name].default,
  () => [],
);

/** The options of a job, to order it again. */
export const optionsOf = (job: Job): Options =>
  valuesOf(
    (name) => job[name],
    (name) => job[name],
  );

/** The plain options of a job that are not the default. */
export const changedOptions = (job: Job): OptionName[] =>
  OPTION_NAMES.filter((name) => job[name] !== OPTIONS[name].default);

/** The options of a job that concern some edges, if any edge is chosen. */
export const changedEdgeOptions = (job: Job): EdgeOptionName[] =>
  EDGE_OPTION_NAMES.filter((name) => job[name].length > 0);

/** The options with other choices for edges; their fields come from the description of the option. */
export const withEdgeChoices = (
  options: Options,
  name: EdgeOptionName,
  choices: readonly EdgeChoice[],
): Options => ({ ...options, [name]: choices }) as Options;
