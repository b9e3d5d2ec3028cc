/** The places of the page, each with its address. */

import { type ReactNode, useEffect } from "react";
import { Redirect, Route, Switch } from "wouter";
import { translate } from "../language/translate";
import { useMe } from "../state/accounts/accounts";
import { subscribeToEvents } from "../state/cacheUpdates";
import { syncDrawing } from "../state/drawing/drawingSync";
import { proposedMachine } from "../state/job/machines";
import { useMachines } from "../state/queries";
import {
  type AccountTab,
  CARTONS,
  DRAWINGS,
  decodedPart,
  FOLD,
  HISTORY,
  type HistoryView,
  LIBRARY,
  MACHINES,
  SETTINGS,
  SHEET,
  STATION,
  STATIONS,
  syncWithAddress,
  WEBHOOKS,
  WORK_TABLE,
  workViewOf,
} from "../state/routes";
import { useUiStore } from "../state/store";
import css from "./app.module.css";
import { NotFound } from "./NotFound";
import { Part } from "./Part";
import { Shell } from "./Shell";
import {
  CartonPage,
  DrawingPage,
  FoldPage,
  HistoryPage,
  LayoutEditor,
  LibraryPage,
  MachinesPage,
  prefetch,
  SettingsPage,
  StationPage,
  WebhooksPage,
} from "./views";
import { WorkPage } from "./WorkPage";

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
  const uploading = useUiStore((ui) => ui.upload !== null);
  // The drawing is shown when it has been read.
  useEffect(() => {
    if (uploading) prefetch("drawing");
  }, [uploading]);
  return (
    <Shell>
      <Switch>
        <Route path={WORK_TABLE}>{() => <WorkPage view={workViewOf(location.hash)} />}</Route>
        <Route path={DRAWINGS}>{fetched("drawing", <DrawingPage />)}</Route>
        <Route path={MACHINES}>
          {({ machine }) => fetched("machines", <MachinesPage shown={decodedPart(machine)} />)}
        </Route>
        <Route path={STATIONS}>
          <ToStation />
        </Route>
        <Route path={STATION}>
          {({ machine }) => fetched(machine, <StationPage machine={machine} />)}
        </Route>
        <Route path={LIBRARY}>{fetched("library", <LibraryPage />)}</Route>
        <Route path={CARTONS}>
          {({ code }) => fetched("cartons", <CartonPage code={decodedPart(code)} />)}
        </Route>
        <Route path={FOLD}>
          {({ drawing }) => fetched(drawing, <FoldPage drawing={drawing} />)}
        </Route>
        <Route path={SHEET}>{({ id }) => fetched(id, <LayoutEditor id={id} />)}</Route>
        <Route path={HISTORY}>
          {({ view }) => fetched("history", <HistoryPage view={(view ?? "jobs") as HistoryView} />)}
        </Route>
        <Route path={SETTINGS}>
          {({ tab }) => fetched("settings", <SettingsPage tab={(tab ?? "own") as AccountTab} />)}
        </Route>
        <Route path={WEBHOOKS}>{fetched("webhooks", <WebhooksPage />)}</Route>
        <Route>
          <main className={css.whole}>
            <NotFound text={translate("app.thereIsNoSuchPage")} />
          </main>
        </Route>
      </Switch>
    </Shell>
  );
}

/** A page that is fetched when it is first shown. */
const fetched = (key: string, page: ReactNode) => <Part key={key}>{page}</Part>;

/** The station of the machine on which jobs are made. */
function ToStation() {
  const { data: machines } = useMachines();
  const chosen = useUiStore((ui) => ui.machine);
  const machine = chosen ?? proposedMachine(machines ?? []);
  if (machine === null)
    return (
      <main className={css.whole}>
        <h1 className={css.hint} role="status">
          {machines === undefined ? translate("part.loading") : translate("app.thereIsNoMachine")}
        </h1>
      </main>
    );
  return <Redirect to={`/station/${encodeURIComponent(machine)}`} replace />;
}
