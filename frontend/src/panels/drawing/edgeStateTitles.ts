/** Names of the states of edges. */

import { translate } from "../../language/translate";
import type { EdgeState } from "../../state/drawing/edgeList";

export const STATE_TITLES: Readonly<Record<EdgeState, string>> = {
  undecided: translate("edgeState.undecided"),
  byHand: translate("edgeState.byHand"),
  merged: translate("edgeState.merged"),
  dropped: translate("edgeState.dropped"),
  kept: translate("edgeState.kept"),
};
