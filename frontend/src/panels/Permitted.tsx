/** Controls that only some roles may use: disabled for others, with the reason. */

import type { ReactNode } from "react";
import { type RestrictedRequest, useRefusal } from "../state/accounts";
import css from "./account.module.css";

interface Props {
  /** What the controls send; its role is needed. */
  readonly request: RestrictedRequest;
  readonly children: ReactNode;
}

/** Disables all form controls inside for a person without the role, and says why. */
export function Permitted({ request, children }: Props) {
  const reason = useRefusal(request);
  return (
    <fieldset
      className={css.permitted}
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
    <p className={css.reason} data-testid="role-reason">
      {reason}
    </p>
  );
}
