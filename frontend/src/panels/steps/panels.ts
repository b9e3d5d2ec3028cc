/** The panel of each step. */

import type { ComponentType } from "react";
import type { Step } from "../../state/store";
import { CheckStep } from "./CheckStep";
import { LinesStep } from "./LinesStep";
import { ProcessStep } from "./ProcessStep";
import { SheetStep } from "./SheetStep";

export const STEP_PANELS: Readonly<Record<Step, ComponentType>> = {
  lines: LinesStep,
  sheet: SheetStep,
  process: ProcessStep,
  check: CheckStep,
};
