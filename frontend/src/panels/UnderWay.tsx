/** What is under way: a line for whatever takes its time, a card for a file that comes in. */

import { Progress } from "@mantine/core";
import { usePage } from "../state/store";
import overCss from "./over.module.css";
import css from "./panels.module.css";
import reportCss from "./reports.module.css";

export function UnderWay() {
  const busy = usePage((page) => page.busy);
  const upload = usePage((page) => page.upload);
  return (
    <>
      {busy && <div className={reportCss.underWay} role="progressbar" aria-label="Under way" />}
      {upload !== null && (
        <div className={`${overCss.float} ${reportCss.upload}`} role="status" data-testid="upload">
          <div className={css.runFigures} style={{ margin: "0 0 6px" }}>
            <span className={css.rowName}>{upload.name}</span>
            <span>
              {upload.fraction < 1 ? `${Math.round(upload.fraction * 100)} %` : "reading …"}
            </span>
          </div>
          <Progress
            value={upload.fraction * 100}
            animated={upload.fraction >= 1}
            size="sm"
            aria-label={`Upload of ${upload.name}`}
          />
        </div>
      )}
    </>
  );
}
