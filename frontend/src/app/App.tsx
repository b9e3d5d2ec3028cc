/** The page: panels at the sides, the picture between them. */

import { useEffect, useRef } from "react";
import { DocumentPanel } from "../panels/DocumentPanel";
import { DrawingsPanel } from "../panels/DrawingsPanel";
import { ImportPanel } from "../panels/ImportPanel";
import { InspectorPanel } from "../panels/InspectorPanel";
import { JobPanel } from "../panels/JobPanel";
import { LayersPanel } from "../panels/LayersPanel";
import { LearnedPanel } from "../panels/LearnedPanel";
import { LineTypesPanel } from "../panels/LineTypesPanel";
import { MachinePanel } from "../panels/MachinePanel";
import { OrderPanel } from "../panels/OrderPanel";
import { ProfileEditor } from "../panels/ProfileEditor";
import { QuestionsPanel } from "../panels/QuestionsPanel";
import { QueuePanel } from "../panels/QueuePanel";
import { ReportsList } from "../panels/ReportsList";
import { ShortcutsDialog } from "../panels/ShortcutsDialog";
import { UnderWay } from "../panels/UnderWay";
import { UnitPanel } from "../panels/UnitPanel";
import { heardDrawing } from "../state/actions";
import { follow, useDrawing } from "../state/queries";
import { usePage } from "../state/store";
import css from "./app.module.css";
import { DropAnywhere } from "./DropAnywhere";
import { NoDrawing } from "./NoDrawing";
import { Picture } from "./Picture";
import { followAddress } from "./routes";
import { listenToKeys, type PictureKeys } from "./shortcuts";
import { TopBar } from "./TopBar";
import { Welcome } from "./Welcome";

export function App() {
  const picture = useRef<PictureKeys | null>(null);
  const drawing = usePage((page) => page.drawing);
  const editing = usePage((page) => page.editing);
  const leftOpen = usePage((page) => page.leftOpen);
  const rightOpen = usePage((page) => page.rightOpen);
  const { error } = useDrawing();

  useEffect(() => {
    const ends = [followAddress(), follow(heardDrawing), listenToKeys(() => picture.current)];
    return () => {
      for (const end of ends) end();
    };
  }, []);

  const ready = useRef((keys: PictureKeys | null) => {
    picture.current = keys;
  });

  return (
    <div className={css.page}>
      <TopBar />
      <aside className={css.side} hidden={!leftOpen} aria-label="Drawing">
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
        {drawing === null ? (
          <Welcome />
        ) : error !== null ? (
          <NoDrawing error={error} />
        ) : (
          <Picture onReady={ready.current} />
        )}
      </main>
      <aside
        className={`${css.side} ${css.right}`}
        hidden={!rightOpen}
        aria-label="Job, queue and machine"
      >
        {drawing !== null && (
          <>
            <InspectorPanel />
            <OrderPanel />
            <JobPanel />
          </>
        )}
        <QueuePanel />
        <MachinePanel />
      </aside>
      <UnderWay />
      <ReportsList />
      <ShortcutsDialog />
      <DropAnywhere />
    </div>
  );
}
