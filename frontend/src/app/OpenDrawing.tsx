/** What the page of drawings shows of the open drawing: its panels, and the canvas between them. */

import { DocumentPanel } from "../panels/DocumentPanel";
import { ImportPanel } from "../panels/ImportPanel";
import { InspectorPanel } from "../panels/InspectorPanel";
import { JobPanel } from "../panels/JobPanel";
import { LayersPanel } from "../panels/LayersPanel";
import { LearnedPanel } from "../panels/LearnedPanel";
import { LineTypesPanel } from "../panels/LineTypesPanel";
import { OrderPanel } from "../panels/OrderPanel";
import { ProfileEditor } from "../panels/ProfileEditor";
import { QuestionsPanel } from "../panels/QuestionsPanel";
import { UnitPanel } from "../panels/UnitPanel";
import { useUiStore } from "../state/store";
import css from "./app.module.css";

export { Picture } from "./Picture";

/** The left side: the drawing, or the profile that is edited. */
export function DrawingPanels() {
  const editing = useUiStore((ui) => ui.editedProfile);
  if (editing !== null) return <ProfileEditor name={editing} />;
  return (
    <>
      <DocumentPanel />
      <QuestionsPanel />
      <LearnedPanel />
      <LineTypesPanel />
      <LayersPanel />
      <UnitPanel />
      <ImportPanel />
    </>
  );
}

/** The right side: the chosen edges, and the job. */
export function JobPanels() {
  return (
    <>
      <InspectorPanel />
      <OrderPanel />
      <div className={css.openJob}>
        <JobPanel />
      </div>
    </>
  );
}
