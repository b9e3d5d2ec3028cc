/** Progress of the server's preparation, shown while it compiles itself after an installation. */

import { Progress } from "@mantine/core";
import { useServiceStatus } from "../state/queries";
import reportCss from "./notifications.module.css";
import overCss from "./over.module.css";
import css from "./panels.module.css";

export function PreparationBanner() {
  const { data: status } = useServiceStatus();
  if (status === undefined || !status.preparing || status.parts === 0) return null;
  const { parts, parts_compiled: compiled } = status;
  return (
    <div
      className={`${overCss.float} ${reportCss.preparation}`}
      role="status"
      data-testid="preparation"
    >
      <div>{`Preparing the server: ${compiled} of ${parts} parts compiled`}</div>
      <Progress
        value={(compiled / parts) * 100}
        size="sm"
        my={6}
        aria-label="Preparation of the server"
      />
      <div className={css.hint}>
        Only after an installation. Drawings and jobs can be sent now; they start as soon as their
        parts are compiled.
      </div>
    </div>
  );
}
