/** Progress of the server's preparation, above the page while it compiles itself after an installation. */

import { Progress } from "@mantine/core";
import { translate } from "../../language/translate";
import { useServiceStatus } from "../../state/queries";
import notificationCss from "../shared/notifications.module.css";
import { Hint } from "../shared/parts";

export function PreparationBanner() {
  const { data: status } = useServiceStatus();
  if (status === undefined || !status.preparing || status.parts === 0) return null;
  const { parts, parts_compiled: compiled } = status;
  return (
    <div className={notificationCss.preparation} role="status" data-testid="preparation">
      <div>{translate("preparationBanner.firstStartOfTheServer", { compiled, parts })}</div>
      <Progress
        value={(compiled / parts) * 100}
        size="sm"
        my={6}
        aria-label={translate("preparationBanner.firstStartOfTheServer2")}
      />
      <Hint>{translate("preparationBanner.theServerPreparesItsSoftware")}</Hint>
    </div>
  );
}
