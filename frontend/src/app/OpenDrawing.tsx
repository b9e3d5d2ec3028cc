/** What the page of drawings shows of the open drawing: its panels, and the canvas between them. */

import "../messages/load";
import { DocumentPanel } from "../panels/drawing/DocumentPanel";
import { ImportPanel } from "../panels/drawing/ImportPanel";
import { InspectorPanel } from "../panels/drawing/InspectorPanel";
import { LayersPanel } from "../panels/drawing/LayersPanel";
import { LearnedPanel } from "../panels/drawing/LearnedPanel";
import { LineTypesPanel } from "../panels/drawing/LineTypesPanel";
import { PagesPanel } from "../panels/drawing/PagesPanel";
import { ProfileEditor } from "../panels/drawing/ProfileEditor";
import { QuestionsPanel } from "../panels/drawing/QuestionsPanel";
import { TaughtPanel } from "../panels/drawing/TaughtPanel";
import { UnitPanel } from "../panels/drawing/UnitPanel";
import { JobPanel } from "../panels/job/JobPanel";
import { OrderPanel } from "../panels/order/OrderPanel";
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
      <PagesPanel />
      <QuestionsPanel />
      <TaughtPanel />
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
