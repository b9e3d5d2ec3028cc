/** First step: open questions, line types and layers, and the file that they come from. */

import { DocumentPanel } from "../drawing/DocumentPanel";
import { ImportPanel } from "../drawing/ImportPanel";
import { InspectorPanel } from "../drawing/InspectorPanel";
import { LayersPanel } from "../drawing/LayersPanel";
import { LearnedPanel } from "../drawing/LearnedPanel";
import { LineTypesPanel } from "../drawing/LineTypesPanel";
import { PagesPanel } from "../drawing/PagesPanel";
import { PanelSwitch } from "../drawing/PanelSwitch";
import { QuestionsPanel } from "../drawing/QuestionsPanel";
import { TaughtPanel } from "../drawing/TaughtPanel";
import { UnitPanel } from "../drawing/UnitPanel";

export function LinesStep() {
  return (
    <>
      <PanelSwitch />
      <QuestionsPanel />
      <InspectorPanel />
      <LineTypesPanel />
      <LayersPanel />
      <TaughtPanel />
      <LearnedPanel />
      <DocumentPanel />
      <PagesPanel />
      <UnitPanel />
      <ImportPanel />
    </>
  );
}
