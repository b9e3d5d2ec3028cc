/** The open questions and the marks of the steps of the open drawing. */

import { useEffect } from "react";
import { proposedMachine } from "../job/machines";
import { DEFAULT_CORNERS } from "../order/corners";
import { optionsOf } from "../order/options";
import { detailsOf } from "../order/orderDetails";
import { useBoards, useDrawing, useJob, useLastJob, useMachines } from "../queries";
import { type Step, useUiStore } from "../store";
import { firstStep, isOutdated, openQuestions, type StepStatus, stepStatuses } from "./steps";

export function useOpenQuestions() {
  const { data: drawing } = useDrawing();
  const { data: job } = useJob();
  const refused = useUiStore((ui) => ui.compileQuestions);
  return openQuestions(drawing?.questions ?? [], refused, job?.questions ?? []);
}

export function useStepStatuses(): Record<Step, StepStatus> {
  const questions = useOpenQuestions().length;
  const chosen = useUiStore((ui) => ui.board !== null && ui.machine !== null);
  const { data: job } = useJob();
  return stepStatuses({ questions, chosen, job: job ?? null });
}

/** Open the step that needs the user first, if the address names none. */
export function useFirstStep(): void {
  const { data: drawing } = useDrawing();
  const step = useUiStore((ui) => ui.step);
  const job = useUiStore((ui) => ui.job);
  const open = useUiStore((ui) => ui.open);
  const unknown = step === null && drawing !== undefined;
  const questions = drawing?.questions.length ?? 0;
  const asked = unknown && questions === 0 && job === null;
  const { data: last, isError } = useLastJob({ drawing: drawing?.id ?? "" }, asked);
  useEffect(() => {
    if (!unknown || (asked && last === undefined && !isError)) return;
    const newest = asked && last != null && !isOutdated(last, drawing) ? last.id : null;
    const found = job ?? newest;
    open(drawing.id, found, firstStep(questions, found !== null));
  }, [unknown, asked, last, isError, job, questions, drawing, open]);
}

/** Keep the choices for the next job: a machine, those of the open job, the board of the last one. */
export function useOrderChoices(): void {
  const { data: drawing } = useDrawing();
  const { data: machines } = useMachines();
  const { data: boards } = useBoards();
  const { data: job } = useJob();
  const machine = useUiStore((ui) => ui.machine);
  const board = useUiStore((ui) => ui.board);
  const set = useUiStore((ui) => ui.set);
  const remembered = useRememberedBoard();

  useEffect(() => {
    const proposed = proposedMachine(machines ?? []);
    if (machine === null && proposed !== null) set({ machine: proposed });
  }, [machines, machine, set]);

  // Opening a job takes over its settings, so that it can be compiled again.
  // biome-ignore lint/correctness/useExhaustiveDependencies: once per job, not on each update
  useEffect(() => {
    if (job !== undefined && job.drawing === drawing?.id) {
      set({
        machine: job.machine,
        board: job.board,
        corners: job.corners ?? DEFAULT_CORNERS,
        sheet: job.sheet ?? null,
        lift: job.lift,
        options: optionsOf(job),
        details: detailsOf(job),
      });
    }
  }, [job?.id, drawing?.id, set]);

  // The board of the last job of this drawing, if this page has not chosen another one since.
  useEffect(() => {
    if (board === null && remembered !== undefined && boards !== undefined)
      set({ board: remembered });
  }, [board, remembered, boards, set]);
}

/** The board of the last job of the open drawing, if the library still has it. */
export function useRememberedBoard(): string | undefined {
  const { data: boards } = useBoards();
  const drawing = useUiStore((ui) => ui.drawing);
  const wanted = useUiStore((ui) => ui.board === null && ui.job === null && ui.drawing !== null);
  const { data: last } = useLastJob({ drawing: drawing ?? "" }, wanted);
  return boards?.some(({ name }) => name === last?.board) ? last?.board : undefined;
}
