/** Progress of the server's preparation, shown while it compiles itself after an installation. */

import { Progress } from "@mantine/core";
import { useServiceStatus } from "../state/queries";
import notificationCss from "./notifications.module.css";
import overlayCss from "./overlay.module.css";
import css from "./panels.module.css";

export function PreparationBanner() {
  const { data: status } = useServiceStatus();
  if (status === undefined || !status.preparing || status.parts === 0) return null;
  const { parts, parts_compiled: compiled } = status;
  return (
    <div
      className={`${overlayCss.float} ${notificationCss.preparation}`}
      role="status"
      data-testid="preparation"
    >
      <div>{`First start of the server: ${compiled} of ${parts} software modules are ready`}</div>
      <Progress
        value={(compiled / parts) * 100}
        size="sm"
        my={6}
        aria-label="First start of the server"
      />
      <div className={css.hint}>
        The server prepares its software modules only once, after the installation. You can already
        work: a drawing or job that needs a module waits until this module is ready.
      </div>
    </div>
  );
}
