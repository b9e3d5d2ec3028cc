/** Who may share a drawing with all designers. */

import type { Me } from "../../api/accounts";
import type { Drawing } from "../../api/drawings";

export const maySetShare = (
  me: Pick<Me, "account" | "scopes">,
  drawing: Pick<Drawing, "owner" | "shared">,
): boolean => me.scopes.includes("operator") || drawing.shared || drawing.owner === me.account;
