/** Last step: the open job with its verdict, and the other jobs of the drawing. */

import { translate } from "../../language/translate";
import { hasProgram } from "../../state/job/jobs";
import { useDrawing, useJob } from "../../state/queries";
import { useUiStore } from "../../state/store";
import { InspectorPanel } from "../drawing/InspectorPanel";
import { JobPanel } from "../job/JobPanel";
import { JobsOfDrawing } from "../job/JobsOfDrawing";
import { PlacePanels } from "../job/PlacePanels";
import css from "../shared/panels.module.css";
import { Note } from "../shared/parts";

export function CheckStep() {
  const { data: drawing } = useDrawing();
  const { data: job } = useJob();
  const named = useUiStore((ui) => ui.job !== null);
  return (
    <>
      <JobPanel />
      {!named && (
        <section className={css.section} style={{ padding: 16 }}>
          <Note>{translate("checkStep.thereIsNoProgramYet")}</Note>
        </section>
      )}
      {job !== undefined && hasProgram(job) && <PlacePanels job={job} />}
      <InspectorPanel />
      {drawing !== undefined && <JobsOfDrawing drawing={drawing.id} open={job?.id ?? ""} />}
    </>
  );
}
