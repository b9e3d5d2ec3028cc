/** Labels that several components show. */

/** Removes the line type that a user has set, so that the rules of the profile decide again. */
export const USE_PROFILE_TYPE = "Use the line type that the profile gives";
export const SHOW_EDGES = "Show these edges in the drawing";
export const TO_ALL_DRAWINGS = "Back to all drawings";
