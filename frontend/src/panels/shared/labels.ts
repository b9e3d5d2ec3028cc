/** Labels that several components show. */

import { translate } from "../../language/translate";

/** Removes the line type that a user has set, so that the rules of the profile decide again. */
export const USE_PROFILE_TYPE = translate("labels.useTheLineTypeThat");
export const SHOW_EDGES = translate("labels.showTheseEdgesInThe");
export const TO_ALL_DRAWINGS = translate("labels.backToAllDrawings");
