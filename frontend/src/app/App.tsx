/** The page: drawings, with side panels and the canvas between them, or the station of a machine. */

import { useEffect, useRef } from "react";
import { Route, Switch, useRoute } from "wouter";
import { translate } from "../language/translate";
import { OperatorDialog } from "../panels/accounts/OperatorForm";
import { DrawingsPanel } from "../panels/drawing/DrawingsPanel";
import { PreparationBanner } from "../panels/drawing/PreparationBanner";
import { MachinePanel } from "../panels/job/MachinePanel";
import { QueuePanel } from "../panels/job/QueuePanel";
import { NotificationList } from "../panels/shared/NotificationList";
import { ProgressOverlay } from "../panels/shared/ProgressOverlay";
import { ShortcutsDialog } from "../panels/shared/ShortcutsDialog";
import { useMe } from "../state/accounts/accounts";
import { syncDrawing } from "../state/drawing/drawingSync";
import { subscribeToEvents, useDrawing } from "../state/queries";
import { DRAWINGS, HISTORY, LIBRARY, STATION, syncWithAddress, WEBHOOKS } from "../state/routes";
import { useUiStore } from "../state/store";
import css from "./app.module.css";
import { DrawingError } from "./DrawingError";
import { DropZone } from "./DropZone";
import { NotFound } from "./NotFound";
import { Part } from "./Part";
import { listenToKeys, type PictureCommands } from "./shortcuts";
import { TopBar } from "./TopBar";
import {
  DrawingPanels,
  HistoryPage,
  JobPanels,
  LibraryPage,
  Picture,
  prefetch,
  StationPage,
  WebhooksPage,
} from "./views";
import { Welcome } from "./Welcome";

export function App() {
  useEffect(() => {
    const ends = [syncWithAddress(), subscribeToEvents(syncDrawing)];
    return () => {
      for (const end of ends) end();
    };
  }, []);
  const paired = useMe()?.kind === "device";
  // A device at a machine opens the station page next.
  useEffect(() => {
    if (paired) prefetch("station");
  }, [paired]);
  return (
    <Switch>
      <Route path={LIBRARY}>
        <Part key="library" as="page">
          <LibraryPage />
        </Part>
      </Route>
      <Route path={WEBHOOKS}>
        <Part key="webhooks" as="page">
          <WebhooksPage />
        </Part>
      </Route>
      <Route path={STATION}>
        {({ machine }) => (
          <Part key={machine} as="page">
            <StationPage machine={machine} />
          </Part>
        )}
      </Route>
      <Route path={DRAWINGS}>
        <DrawingPage />
      </Route>
      <Route>
        <main>
          <NotFound text={translate("app.thereIsNoSuchPage")} />
        </main>
      </Route>
    </Switch>
  );
}

/** The page on which drawings are prepared and jobs are sent. */
function DrawingPage() {
  const picture = useRef<PictureCommands | null>(null);
  const drawing = useUiStore((ui) => ui.drawing);
  const [history] = useRoute(HISTORY);
  const uploading = useUiStore((ui) => ui.upload !== null);
  const leftOpen = useUiStore((ui) => ui.leftOpen);
  const rightOpen = useUiStore((ui) => ui.rightOpen);
  const { error } = useDrawing();

  useEffect(() => listenToKeys(() => picture.current), []);
  // The drawing is shown when it has been read.
  useEffect(() => {
    if (uploading) prefetch("drawing");
  }, [uploading]);

  const ready = useRef((keys: PictureCommands | null) => {
    picture.current = keys;
  });

  return (
    <div className={css.page} data-history={history}>
      <TopBar />
      {/* First for the keyboard: the next action is here. */}
      <aside
        className={`${css.side} ${css.right}`}
        hidden={!rightOpen || history}
        aria-label={translate("app.jobQueueAndMachine")}
      >
        {drawing !== null && (
          <Part as="side">
            <JobPanels />
          </Part>
        )}
        <QueuePanel />
        <MachinePanel />
      </aside>
      <aside
        className={`${css.side} ${css.left}`}
        hidden={!leftOpen || history}
        aria-label={translate("app.drawingsLineTypesAndImport")}
        onPointerEnter={() => prefetch("drawing")}
      >
        {drawing === null ? (
          <DrawingsPanel />
        ) : (
          <Part as="side">
            <DrawingPanels />
          </Part>
        )}
      </aside>
      <main className={css.stage}>
        {history ? (
          <Part key="history" as="middle">
            <HistoryPage />
          </Part>
        ) : drawing === null ? (
          <Welcome />
        ) : error !== null ? (
          <DrawingError error={error} />
        ) : (
          <Part key="drawing" as="middle">
            <Picture onReady={ready.current} />
          </Part>
        )}
      </main>
      <PreparationBanner />
      <ProgressOverlay />
      <NotificationList />
      <ShortcutsDialog />
      <OperatorDialog />
      <DropZone />
    </div>
  );
}
