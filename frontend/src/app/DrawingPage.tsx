/** The page of a drawing: four steps from its lines to a job, each with a panel beside the canvas. */

import "../messages/load";
import { Suspense, useEffect, useRef } from "react";
import { translate } from "../language/translate";
import { ProfileEditor } from "../panels/drawing/ProfileEditor";
import { MainAction } from "../panels/steps/MainAction";
import { STEP_PANELS } from "../panels/steps/panels";
import { StepBar } from "../panels/steps/StepBar";
import { useKeptFocus } from "../panels/steps/useKeptFocus";
import { setPicture } from "../state/commands/picture";
import { useEdgeList } from "../state/drawing/edgeList";
import { useFirstStep, useOrderChoices } from "../state/drawing/useSteps";
import { useDrawing } from "../state/queries";
import { useUiStore } from "../state/store";
import css from "./app.module.css";
import { DrawingError } from "./DrawingError";
import { Picture } from "./Picture";
import { listenToKeys } from "./shortcuts";
import { EdgeList } from "./views";

export function DrawingPage() {
  const { data: drawing, error } = useDrawing();
  const step = useUiStore((ui) => ui.step);
  const editing = useUiStore((ui) => ui.editedProfile);
  const panelOpen = useUiStore((ui) => ui.panelOpen);
  const listOpen = useEdgeList((list) => list.open) && step === "lines" && editing === null;
  const action = useRef<HTMLDivElement>(null);
  useKeptFocus(action);
  useFirstStep();
  useOrderChoices();
  useEffect(() => listenToKeys(), []);
  if (error !== null)
    return (
      <main className={css.whole}>
        <DrawingError error={error} />
      </main>
    );
  const Panel = step === null ? null : STEP_PANELS[step];
  return (
    <main className={css.drawing} data-panel={panelOpen}>
      {/* First for the keyboard. */}
      <div ref={action} className={css.action} data-main-action>
        <MainAction />
      </div>
      <header className={css.top}>
        <h1 className={css.name} title={drawing?.name}>
          {drawing?.name ?? translate("part.loading")}
        </h1>
        <StepBar />
      </header>
      {/* A step begins at its upper end. */}
      <aside
        key={editing ?? `${step} ${listOpen}`}
        className={css.panel}
        hidden={!panelOpen}
        aria-label={translate("drawingPage.choicesOfThisStep")}
        data-step={step}
      >
        {listOpen ? (
          <Suspense fallback={null}>
            <EdgeList />
          </Suspense>
        ) : editing !== null ? (
          <ProfileEditor name={editing} />
        ) : (
          Panel !== null && <Panel />
        )}
      </aside>
      <div className={css.stage}>
        <Picture onReady={setPicture} />
      </div>
    </main>
  );
}
