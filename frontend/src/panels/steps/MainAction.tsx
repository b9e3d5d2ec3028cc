/** The button of a step that brings the drawing nearest to its job: answer, choose, prepare, send. */

import { Button } from "@mantine/core";
import {
  IconArrowRight,
  IconBolt,
  IconHelpHexagon,
  IconSend2,
  IconStack2,
} from "@tabler/icons-react";
import type { Job } from "../../api/jobs";
import { translate } from "../../language/translate";
import { useRefusal } from "../../state/accounts/accounts";
import { command, compile } from "../../state/actions";
import { useEdgeList } from "../../state/drawing/edgeList";
import { useOpenQuestions } from "../../state/drawing/useSteps";
import { isCompiling, isQueued } from "../../state/job/jobs";
import { useDrawing, useJob } from "../../state/queries";
import { stationAddress } from "../../state/routes";
import { type Step, useUiStore } from "../../state/store";

/** The button of the job on the last step; that which prepares a program on the others. */
export function MainAction() {
  const { data: drawing } = useDrawing();
  const { data: job } = useJob();
  const step = useUiStore((ui) => ui.step);
  const questions = useOpenQuestions().length;
  const missing = useUiStore((ui) => ui.board === null || ui.machine === null);
  if (drawing === undefined || step === null) return null;
  if (questions > 0) return <Answer questions={questions} />;
  if (step === "check" && job !== undefined) {
    if (isCompiling(job)) return <Prepare job={job} />;
    if (job.actions.includes("release")) return <Send job={job} />;
    if (job.waiting_for !== "compile" && isQueued(job)) return <ToStation job={job} />;
  }
  return missing ? <ChooseBoard /> : <Prepare job={job} />;
}

/** Go to a step, and give the focus to a control of it. */
function goTo(step: Step, selector: string): void {
  useEdgeList.getState().show(false);
  const focus = () => document.querySelector<HTMLElement>(selector)?.focus();
  useUiStore.getState().set({ step, panelOpen: true });
  // The panel of the step is there after the next rendering.
  setTimeout(focus, 60);
}

function Answer({ questions }: { questions: number }) {
  return (
    <Button
      fullWidth
      leftSection={<IconHelpHexagon size={17} aria-hidden />}
      onClick={() => goTo("lines", "[data-answer]")}
      data-testid="answer-first"
    >
      {translate("mainAction.answerQuestions", { questions })}
    </Button>
  );
}

function ChooseBoard() {
  return (
    <Button
      fullWidth
      leftSection={<IconStack2 size={17} aria-hidden />}
      onClick={() => goTo("sheet", "[data-testid=board-select]")}
      data-testid="choose-board"
    >
      {translate("mainAction.chooseTheBoard")}
    </Button>
  );
}

function Prepare({ job }: { job: Job | undefined }) {
  const machine = useUiStore((ui) => ui.machine);
  const board = useUiStore((ui) => ui.board);
  const busy = useUiStore((ui) => ui.busy);
  const refusal = useRefusal("POST /api/v1/jobs");
  const again = job !== undefined && !isCompiling(job);
  return (
    <Button
      fullWidth
      leftSection={<IconBolt size={17} aria-hidden />}
      disabled={refusal !== null}
      title={refusal ?? undefined}
      loading={busy || (job !== undefined && isCompiling(job))}
      onClick={() => {
        if (machine !== null && board !== null) void compile(machine, board);
      }}
      variant={again && job.state !== "refused" ? "default" : "filled"}
      data-testid="compile"
    >
      {again ? translate("orderPanel.prepareAgain") : translate("orderPanel.prepareProgram")}
    </Button>
  );
}

function Send({ job }: { job: Job }) {
  const busy = useUiStore((ui) => ui.busy);
  const refusal = useRefusal("POST /api/v1/jobs/{id}/release");
  return (
    <Button
      fullWidth
      leftSection={<IconSend2 size={17} aria-hidden />}
      disabled={busy || refusal !== null}
      title={refusal ?? undefined}
      onClick={() => void command(job.id, "release")}
      data-testid="send"
    >
      {translate("jobPanel.sendJobToMachine")}
    </Button>
  );
}

function ToStation({ job }: { job: Job }) {
  return (
    <Button
      fullWidth
      component="a"
      variant="default"
      href={stationAddress(job.machine)}
      rightSection={<IconArrowRight size={17} aria-hidden />}
      data-testid="main-station"
    >
      {translate("mainAction.toTheStation")}
    </Button>
  );
}
