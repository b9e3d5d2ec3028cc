/** The four steps of a drawing, each a link with a mark: done, open, a count or a warning. */

import { Loader, VisuallyHidden } from "@mantine/core";
import {
  IconAlertTriangleFilled,
  IconCheck,
  IconCircle,
  IconCircleDotFilled,
} from "@tabler/icons-react";
import { useRef } from "react";
import { translate } from "../../language/translate";
import type { StepStatus } from "../../state/drawing/steps";
import { useStepStatuses } from "../../state/drawing/useSteps";
import { drawingPath } from "../../state/routes";
import { STEPS, type Step, useUiStore } from "../../state/store";
import { useRovingFocus } from "../shared/roving";
import css from "./steps.module.css";

const TITLES: Readonly<Record<Step, string>> = {
  lines: translate("stepBar.lines"),
  sheet: translate("stepBar.sheet"),
  process: translate("stepBar.process"),
  check: translate("stepBar.check"),
};

const MARK_TEXTS: Readonly<Record<StepStatus["kind"], string>> = {
  done: translate("stepBar.done"),
  open: translate("stepBar.needsYou"),
  todo: translate("stepBar.notYet"),
  busy: translate("stepBar.working"),
  warning: translate("stepBar.warning"),
};

export function StepBar() {
  const statuses = useStepStatuses();
  const drawing = useUiStore((ui) => ui.drawing);
  const job = useUiStore((ui) => ui.job);
  const current = useUiStore((ui) => ui.step);
  const bar = useRef<HTMLElement>(null);
  useRovingFocus(bar);
  return (
    <nav ref={bar} className={css.bar} aria-label={translate("stepBar.stepsOfThisDrawing")}>
      <ol>
        {STEPS.map((step) => (
          <li key={step}>
            <a
              className={css.step}
              href={`#${drawingPath({ drawing, step, job })}`}
              aria-current={step === current ? "step" : undefined}
              data-kind={statuses[step].kind}
              data-testid={`step-${step}`}
            >
              <Mark status={statuses[step]} />
              {TITLES[step]}
              <VisuallyHidden>{markText(statuses[step])}</VisuallyHidden>
            </a>
          </li>
        ))}
      </ol>
    </nav>
  );
}

const markText = ({ kind, count }: StepStatus): string =>
  count === undefined ? MARK_TEXTS[kind] : translate("stepBar.questions", { count });

function Mark({ status: { kind, count } }: { status: StepStatus }) {
  if (count !== undefined)
    return (
      <span className={css.count} aria-hidden>
        {count}
      </span>
    );
  switch (kind) {
    case "done":
      return <IconCheck size={15} stroke={2.6} aria-hidden />;
    case "open":
      return <IconCircleDotFilled size={15} aria-hidden />;
    case "todo":
      return <IconCircle size={15} aria-hidden />;
    case "busy":
      return <Loader size={13} aria-hidden />;
    case "warning":
      return <IconAlertTriangleFilled size={15} aria-hidden />;
  }
}
