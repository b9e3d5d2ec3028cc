/** The page: drawings, with side panels and the canvas between them, or the station of a machine. */

import { useEffect, useRef } from "react";
import { DocumentPanel } from "../panels/DocumentPanel";
import { DrawingsPanel } from "../panels/DrawingsPanel";
import { HistoryPage } from "../panels/HistoryPage";
import { ImportPanel } from "../panels/ImportPanel";
import { InspectorPanel } from "../panels/InspectorPanel";
import { JobPanel } from "../panels/JobPanel";
import { LayersPanel } from "../panels/LayersPanel";
import { LearnedPanel } from "../panels/LearnedPanel";
import { LineTypesPanel } from "../panels/LineTypesPanel";
import { MachinePanel } from "../panels/MachinePanel";
import { NotificationList } from "../panels/NotificationList";
import { OperatorDialog } from "../panels/OperatorForm";
import { OrderPanel } from "../panels/OrderPanel";
import { PreparationBanner } from "../panels/PreparationBanner";
import { ProfileEditor } from "../panels/ProfileEditor";
import { ProgressOverlay } from "../panels/ProgressOverlay";
import { QuestionsPanel } from "../panels/QuestionsPanel";
import { QueuePanel } from "../panels/QueuePanel";
import { ShortcutsDialog } from "../panels/ShortcutsDialog";
import { UnitPanel } from "../panels/UnitPanel";
import { syncDrawing } from "../state/drawingSync";
import { subscribeToEvents, useDrawing } from "../state/queries";
import { useUiStore } from "../state/store";
import css from "./app.module.css";
import { DrawingError } from "./DrawingError";
import { DropZone } from "./DropZone";
import { LibraryPage } from "./LibraryPage";
import { Picture } from "./Picture";
import { syncWithAddress } from "./routes";
import { StationPage } from "./StationPage";
import { listenToKeys, type PictureCommands } from "./shortcuts";
import { TopBar } from "./TopBar";
import { WebhooksPage } from "./WebhooksPage";
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
  if (library) return <LibraryPage />;
  if (webhooks) return <WebhooksPage />;
  return station === null ? <DrawingPage /> : <StationPage key={station} machine={station} />;
}

/** The page on which drawings are prepared and jobs are sent. */
function DrawingPage() {
  const picture = useRef<PictureCommands | null>(null);
  const drawing = useUiStore((ui) => ui.drawing);
  const history = useUiStore((ui) => ui.history);
  const editing = useUiStore((ui) => ui.editedProfile);
  const leftOpen = useUiStore((ui) => ui.leftOpen);
  const rightOpen = useUiStore((ui) => ui.rightOpen);
  const { error } = useDrawing();

  useEffect(() => listenToKeys(() => picture.current), []);

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
          <>
            <InspectorPanel />
            <OrderPanel />
            <div className={css.openJob}>
              <JobPanel />
            </div>
          </>
        )}
        <QueuePanel />
        <MachinePanel />
      </aside>
      <aside
        className={`${css.side} ${css.left}`}
        hidden={!leftOpen || history}
        aria-label="Drawings, line types and import"
      >
        {drawing === null ? (
          <DrawingsPanel />
        ) : editing !== null ? (
          <ProfileEditor name={editing} />
        ) : (
          <>
            <DocumentPanel />
            <QuestionsPanel />
            <LearnedPanel />
            <LineTypesPanel />
            <LayersPanel />
            <UnitPanel />
            <ImportPanel />
          </>
        )}
      </aside>
      <main className={css.stage}>
        {history ? (
          <HistoryPage />
        ) : drawing === null ? (
          <Welcome />
        ) : error !== null ? (
          <DrawingError error={error} />
        ) : (
          <Picture onReady={ready.current} />
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
