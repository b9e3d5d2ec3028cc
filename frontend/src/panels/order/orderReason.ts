/** Why the order of the work cannot be changed. */

import { translate } from "../../language/translate";
import type { BrokenRule } from "../../state/order/workOrder";

const RULES = {
  types: translate("workOrder.creasesFirst"),
  tools: translate("workOrder.oneToolAfterTheOther"),
  enclosed: translate("workOrder.insideFirst"),
  pieces: translate("workOrder.piecesFirst"),
} as const;

/** The rule that a move would break, with the names of both rows. */
export const reasonOf = <Kind>(
  { rule, first, second }: BrokenRule<Kind>,
  nameOf: (row: Kind) => string,
): string =>
  translate("workOrder.comesBefore", {
    first: nameOf(first),
    second: nameOf(second),
    why: RULES[rule],
  });
