/** The page of the person at a machine, for a tablet beside the table. */

import { Center, Tabs } from "@mantine/core";
import "../messages/load";
import { useEffect, useRef, useState } from "react";
import { translate } from "../language/translate";
import { translateRich } from "../language/translateRich";
import { AskOperator } from "../panels/accounts/OperatorForm";
import { Permitted } from "../panels/accounts/Permitted";
import panels from "../panels/shared/panels.module.css";
import { StationAlarm } from "../panels/station/StationAlarm";
import { StationControls } from "../panels/station/StationControls";
import { StationHeader } from "../panels/station/StationHeader";
import { StationJob } from "../panels/station/StationJob";
import { StationNotices, UnknownOutputs } from "../panels/station/StationNotices";
import { StationOperations } from "../panels/station/StationOperations";
import { StationOutcome } from "../panels/station/StationOutcome";
import css from "../panels/station/station.module.css";
import type { PictureCommands } from "../state/commands/picture";
import { useFollowedJob, useServerReached } from "../state/job/followMachine";
import { isOnTable, needsOperator } from "../state/job/jobs";
import {
  useDrawing,
  useEdges,
  useJob,
  useMachines,
  useStation,
  useTimeline,
} from "../state/queries";
import { useChecks } from "../state/station/checks";
import { HANDS, useHandsClear } from "../state/station/handsClear";
import type { ViewerEvents } from "../viewer/contract";
import { Canvas } from "./Canvas";
import { NotFound } from "./NotFound";

interface Props {
  readonly machine: string;
}

type Tab = "job" | "machine";

/** The report of the last action covers the lower edge. */
const INSETS = { left: 24, top: 24, right: 24, bottom: 68 };
const LABEL = translate("stationPage.theSheetOnTheTable");
/** Nothing is chosen in this picture: it is looked at from a distance. */
const NO_EVENTS: ViewerEvents = {
  onHover: () => {},
  onSelect: () => {},
  onCursor: () => {},
  onView: () => {},
  onArea: () => {},
};

export function StationPage({ machine: name }: Props) {
  useFollowedJob(name);
  const reached = useServerReached(name);
  const { data: machines } = useMachines();
  const { data: station } = useStation(name);
  const { data: open } = useJob();
  const [tab, setTab] = useState<Tab>("job");
  const machine = machines?.find((one) => one.name === name);
  const job = open?.machine === name ? open : undefined;
  const hands = useHandsClear(name, station);
  const { checks, ticked: kept, tick, wornTools } = useChecks();
  // The last check counts for a minute only.
  const ticked = hands.left > 0 ? new Set([...kept, HANDS]) : kept;
  const onTick = (changed: readonly string[]) => {
    if (changed.includes(HANDS)) hands.toggle();
    tick(changed.filter((key) => key !== HANDS));
  };
  const waits = job !== undefined && (needsOperator(job) || isOnTable(job));
  // A job that asks for the person, or moves, comes to the front.
  useEffect(() => {
    if (waits) setTab("job");
  }, [waits]);

  if (machine === undefined) {
    return (
      <main className={css.page}>
        {machines === undefined ? (
          <p className={css.lost} role="status">
            {translate("stationPage.loadingTheMachine")}{" "}
            <a href="#/">{translate("stationPage.backToAllDrawings")}</a>
          </p>
        ) : (
          <NotFound text={translate("stationPage.thereIsNoMachineNamed", { name })} />
        )}
      </main>
    );
  }
  const shown = { machine, station, job, reached, hands };
  return (
    <main className={css.page} data-testid="station-page">
      <StationHeader {...shown} />
      {!reached && (
        <p className={css.lost} role="alert" data-testid="no-server">
          {translateRich("stationPage.noConnectionToTheServer", {
            b: (children) => <b>{children}</b>,
          })}
        </p>
      )}
      <div className={css.table} data-idle={job === undefined}>
        {job === undefined ? (
          <Center p={24} fz={26} ta="center">
            {translate("stationPage.noJobWaitsForThis")}
          </Center>
        ) : (
          <StationPicture place={needsOperator(job)} />
        )}
      </div>
      <div className={css.side}>
        {station !== undefined && <StationAlarm {...shown} station={station} />}
        {station !== undefined && <UnknownOutputs station={station} />}
        {station !== undefined && <StationNotices station={station} />}
        <AskOperator />
        <Tabs
          variant="pills"
          className={css.tabs ?? ""}
          value={tab}
          onChange={(value) => setTab(value === "machine" ? "machine" : "job")}
        >
          <Tabs.List grow aria-label={translate("stationPage.jobOrMachine")}>
            <Tabs.Tab value="job" data-testid="tab-job">
              {translate("stationPage.job")}
            </Tabs.Tab>
            <Tabs.Tab value="machine" data-testid="tab-machine">
              {translate("stationPage.moveMachine")}
            </Tabs.Tab>
          </Tabs.List>
          <Tabs.Panel value={tab} pt={12}>
            {tab === "machine" ? (
              <Permitted request="POST /api/v1/machines/{name}/operations">
                <StationOperations {...shown} />
              </Permitted>
            ) : job === undefined ? (
              <p className={panels.callout}>{translate("stationPage.theQueueOfThisMachine")}</p>
            ) : (
              <Permitted request="POST /api/v1/jobs/{id}/confirm">
                <StationJob
                  {...shown}
                  job={job}
                  checks={checks}
                  ticked={ticked}
                  wornTools={wornTools}
                  onTick={onTick}
                />
              </Permitted>
            )}
          </Tabs.Panel>
        </Tabs>
      </div>
      <StationOutcome state={job === undefined ? "" : `${job.id} ${job.state}`} />
      <StationControls
        machine={name}
        station={station}
        job={job}
        reached={reached}
        hands={hands}
        checked={
          checks?.every(({ key }) => ticked.has(key)) && wornTools.decision !== null
            ? { ids: checks.map(({ key }) => key), tools: wornTools.decision }
            : null
        }
      />
    </main>
  );
}

/** The picture of the job; `place` shows the whole table, to lay the sheet in its place. */
function StationPicture({ place }: { place: boolean }) {
  const host = useRef<HTMLDivElement>(null);
  const commands = useRef<PictureCommands | null>(null);
  const { data: drawing } = useDrawing();
  const { data: edges } = useEdges();
  const { data: timeline } = useTimeline();
  const { data: machines } = useMachines();
  const fit = useRef(() => {});
  fit.current = () => {
    if (place) commands.current?.fitTable();
    else commands.current?.fit();
  };
  const ready = useRef((keys: PictureCommands | null) => {
    commands.current = keys;
    fit.current();
  });
  // biome-ignore lint/correctness/useExhaustiveDependencies: another content or purpose, another view
  useEffect(() => fit.current(), [place, drawing, edges, timeline, machines]);
  // A tablet is turned: the whole picture stays in view.
  useEffect(() => {
    if (host.current === null) return;
    const watch = new ResizeObserver(() => fit.current());
    watch.observe(host.current);
    return () => watch.disconnect();
  }, []);
  return (
    <div ref={host} className={css.picture}>
      <Canvas label={LABEL} events={NO_EVENTS} insets={INSETS} onReady={ready.current} />
    </div>
  );
}
