/** Progress bar while requests are pending, and a card for an upload. */

import { Progress } from "@mantine/core";
import { translate } from "../../language/translate";
import { useUiStore } from "../../state/store";
import overlayCss from "../drawing/overlay.module.css";
import notificationCss from "./notifications.module.css";
import { Figures, Name } from "./parts";

export function ProgressOverlay() {
  const busy = useUiStore((ui) => ui.busy);
  const upload = useUiStore((ui) => ui.upload);
  return (
    <>
      {busy && (
        <div
          className={notificationCss.working}
          role="progressbar"
          aria-label={translate("progressOverlay.waitingForTheServer")}
        />
      )}
      {upload !== null && (
        <div
          className={`${overlayCss.float} ${notificationCss.upload}`}
          role="status"
          data-testid="upload"
        >
          <Figures style={{ margin: "0 0 6px" }}>
            <Name>{upload.name}</Name>
            <span>
              {upload.fraction < 1
                ? translate("progressOverlay.uploaded", {
                    fraction: Math.round(upload.fraction * 100),
                  })
                : translate("progressOverlay.readingTheFile")}
            </span>
          </Figures>
          <Progress
            value={upload.fraction * 100}
            animated={upload.fraction >= 1}
            size="sm"
            aria-label={translate("progressOverlay.uploadOf", { name: upload.name })}
          />
        </div>
      )}
    </>
  );
}
