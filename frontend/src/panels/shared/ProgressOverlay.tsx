/** Progress bar while requests are pending, and a card for an upload. */

import { Progress } from "@mantine/core";
import { translate } from "../../language/translate";
import { useUiStore } from "../../state/store";
import overlayCss from "../drawing/overlay.module.css";
import notificationCss from "./notifications.module.css";
import css from "./panels.module.css";

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
          <div className={css.runFigures} style={{ margin: "0 0 6px" }}>
            <span className={css.rowName}>{upload.name}</span>
            <span>
              {upload.fraction < 1
                ? translate("progressOverlay.uploaded", {
                    fraction: Math.round(upload.fraction * 100),
                  })
                : translate("progressOverlay.readingTheFile")}
            </span>
          </div>
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
