/** The page: drawings, with side panels and the canvas between them, or the station of a machine. */

import { useEffect, useRef } from "react";
import { DrawingsPanel } from "../panels/DrawingsPanel";
import { MachinePanel } from "../panels/MachinePanel";
import { NotificationList } from "../panels/NotificationList";
import { OperatorDialog } from "../panels/OperatorForm";
import { PreparationBanner } from "../panels/PreparationBanner";
import { ProgressOverlay } from "../panels/ProgressOverlay";
import { QueuePanel } from "../panels/QueuePanel";
import { ShortcutsDialog } from "../panels/ShortcutsDialog";
import { useMe } from "../state/accounts";
import { syncDrawing } from "../state/drawingSync";
import { subscribeToEvents, useDrawing } from "../state/queries";
import { useUiStore } from "../state/store";
import css from "./app.module.css";
import { DrawingError } from "./DrawingError";
import { DropZone } from "./DropZone";
import { Part } from "./Part";
import { syncWithAddress } from "./routes";
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
  const station = useUiStore((ui) => ui.station);
  const library = useUiStore((ui) => ui.library);
  const webhooks = useUiStore((ui) => ui.webhooks);
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
  if (library)
    return (
      <Part key="library" as="page">
        <LibraryPage />
      </Part>
    );
  if (webhooks)
    return (
      <Part key="webhooks" as="page">
        <WebhooksPage />
      </Part>
    );
  if (station !== null)
    return (
      <Part key={station} as="page">
        <StationPage machine={station} />
      </Part>
    );
  return <DrawingPage />;
}

/** The page on which drawings are prepared and jobs are sent. */
function DrawingPage() {
  const picture = useRef<PictureCommands | null>(null);
  const drawing = useUiStore((ui) => ui.drawing);
  const history = useUiStore((ui) => ui.history);
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
        aria-label="Job, queue and machine"
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
        aria-label="Drawings, line types and import"
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
