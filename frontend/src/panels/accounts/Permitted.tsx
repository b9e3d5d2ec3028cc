/** Controls that need a role: disabled, with the reason, for users without it. */

import type { ReactNode } from "react";
import { type RestrictedRequest, useRefusal } from "../../state/accounts/accounts";
import { Note } from "../shared/parts";

interface Props {
  /** Request that the controls send; it determines the role. */
  readonly request: RestrictedRequest;
  readonly children: ReactNode;
}

/** Disables all form controls inside for a user without the role, and shows the reason. */
export function Permitted({ request, children }: Props) {
  const reason = useRefusal(request);
  return (
    <fieldset
      disabled={reason !== null}
      title={reason ?? undefined}
      data-permitted={reason === null}
    >
      {children}
      <Refusal reason={reason} />
    </fieldset>
  );
}

/** Why controls are disabled; nothing is shown without a reason. */
export function Refusal({ reason }: { reason: string | null }) {
  if (reason === null) return null;
  return (
    <Note mt={6} c="ink.2" style={{ overflowWrap: "anywhere" }} data-testid="role-reason">
      {reason}
    </Note>
  );
}
