/** Controls that only some roles may use: disabled for others, with the reason. */

import type { ReactNode } from "react";
import type { UserRole } from "../api/accounts";
import { useRoleReason } from "../state/accounts";
import css from "./account.module.css";

interface Props {
  /** The least role that may use the controls. */
  readonly to: UserRole;
  readonly children: ReactNode;
}

/** Disables all form controls inside for a person without the role, and says why. */
export function Permitted({ to, children }: Props) {
  const reason = useRoleReason(to);
  return (
    <fieldset
      className={css.permitted}
      disabled={reason !== null}
      title={reason ?? undefined}
      data-permitted={reason === null}
    >
      {children}
      {reason !== null && (
        <p className={css.reason} data-testid="role-reason">
          {reason}
        </p>
      )}
    </fieldset>
  );
}
