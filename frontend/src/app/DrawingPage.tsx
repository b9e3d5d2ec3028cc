/** The page of a drawing: four steps from its lines to a job, each with a panel beside the canvas. */

import "../messages/load";
import { useEffect, useRef } from "react";
import { translate } from "../language/translate";
import { ProfileEditor } from "../panels/drawing/ProfileEditor";
import { MainAction } from "../panels/steps/MainAction";
import { STEP_PANELS } from "../panels/steps/panels";
import { StepBar } from "../panels/steps/StepBar";
import { useFirstStep, useOrderChoices } from "../state/drawing/useSteps";
import { useDrawing } from "../state/queries";
import { useUiStore } from "../state/store";
import css from "./app.module.css";
import { DrawingError } from "./DrawingError";
import { Picture } from "./Picture";
import { listenToKeys, type PictureCommands } from "./shortcuts";

export function DrawingPage() {
  const picture = useRef<PictureCommands | null>(null);
  const { data: drawing, error } = useDrawing();
  const step = useUiStore((ui) => ui.step);
  const editing = useUiStore((ui) => ui.editedProfile);
  const panelOpen = useUiStore((ui) => ui.panelOpen);
  useFirstStep();
  useOrderChoices();
  useEffect(() => listenToKeys(() => picture.current), []);
  const ready = useRef((keys: PictureCommands | null) => {
    picture.current = keys;
  });
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
      <div className={css.action}>
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
        key={editing ?? step}
        className={css.panel}
        hidden={!panelOpen}
        aria-label={translate("drawingPage.choicesOfThisStep")}
        data-step={step}
      >
        {editing !== null ? <ProfileEditor name={editing} /> : Panel !== null && <Panel />}
      </aside>
      <div className={css.stage}>
        <Picture onReady={ready.current} />
      </div>
    </main>
  );
}
