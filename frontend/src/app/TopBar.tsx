/** Top bar: home, undo and redo, machine state, shortcuts. */

import { ActionIcon, Tooltip } from "@mantine/core";
import {
  IconArrowBackUp,
  IconArrowForwardUp,
  IconHistory,
  IconKeyboard,
  IconLayoutSidebar,
  IconLayoutSidebarRight,
} from "@tabler/icons-react";
import { type ReactNode, useRef } from "react";
import { useRoute } from "wouter";
import { navigate } from "wouter/use-hash-location";
import { translate } from "../language/translate";
import { AccountButton } from "../panels/accounts/AccountDialog";
import { OperatorButton } from "../panels/accounts/OperatorForm";
import { MachineChip } from "../panels/job/MachineChip";
import { LanguageMenu } from "../panels/shared/LanguageMenu";
import { redo, undo } from "../state/actions";
import { useProfileDraft } from "../state/drawing/profileDraft";
import { HISTORY, returnToDrawing, showDrawing } from "../state/routes";
import { useUiStore } from "../state/store";
import css from "./app.module.css";
import { Logo } from "./Logo";
import { useRovingFocus } from "./roving";

export function TopBar() {
  const drawing = useUiStore((ui) => ui.drawing);
  const editing = useUiStore((ui) => ui.editedProfile !== null);
  const steps = useProfileDraft();
  const past = useUiStore((ui) => ui.past.length) + (editing ? steps.past.length : 0);
  const future = useUiStore((ui) => ui.future.length) + (editing ? steps.future.length : 0);
  const busy = useUiStore((ui) => ui.busy);
  const leftOpen = useUiStore((ui) => ui.leftOpen);
  const rightOpen = useUiStore((ui) => ui.rightOpen);
  const [history] = useRoute(HISTORY);
  const set = useUiStore((ui) => ui.set);
  const tools = useRef<HTMLDivElement>(null);
  useRovingFocus(tools);
  return (
    <header className={css.top}>
      <button
        type="button"
        className={css.brand}
        onClick={() => showDrawing(null)}
        aria-label={translate("topBar.knifetipShowAllDrawings")}
      >
        <Logo />
        knifetip
      </button>
      <div
        ref={tools}
        className={css.tools}
        role="toolbar"
        aria-label={translate("topBar.viewsAndAccount")}
      >
        <span className={css.divider} />
        <Icon
          label={translate("topBar.showOrHideTheLeft")}
          on={leftOpen}
          large
          act={() => set({ leftOpen: !leftOpen })}
        >
          <IconLayoutSidebar size={18} stroke={1.6} />
        </Icon>
        {drawing !== null && (
          <>
            <Icon
              label={translate("topBar.undoTheLastChangeCtrl")}
              off={past === 0 || busy}
              act={() => void undo()}
              testId="undo"
            >
              <IconArrowBackUp size={18} stroke={1.6} />
            </Icon>
            <Icon
              label={translate("topBar.redoTheUndoneChangeCtrl")}
              off={future === 0 || busy}
              act={() => void redo()}
              testId="redo"
            >
              <IconArrowForwardUp size={18} stroke={1.6} />
            </Icon>
          </>
        )}
        <span className={css.gap} />
        <OperatorButton compact />
        <AccountButton />
        <MachineChip />
        <Icon
          label={translate("topBar.endedJobsStatisticsAndTools")}
          on={history}
          act={() => (history ? returnToDrawing() : navigate(HISTORY))}
          testId="history-button"
        >
          <IconHistory size={18} stroke={1.6} />
        </Icon>
        <span className={css.keys}>
          <LanguageMenu />
          <Icon
            label={translate("topBar.keyboardAndMouseShortcuts")}
            act={() => set({ helpOpen: true })}
          >
            <IconKeyboard size={18} stroke={1.6} />
          </Icon>
        </span>
        <Icon
          label={translate("topBar.showOrHideTheRight")}
          on={rightOpen}
          large
          act={() => set({ rightOpen: !rightOpen })}
        >
          <IconLayoutSidebarRight size={18} stroke={1.6} />
        </Icon>
      </div>
    </header>
  );
}

interface IconProps {
  label: string;
  act: () => void;
  off?: boolean;
  on?: boolean;
  /** Left out on a phone, where the side panels are below the canvas. */
  large?: boolean;
  testId?: string;
  children: ReactNode;
}

function Icon({ label, act, off = false, on, large = false, testId, children }: IconProps) {
  return (
    <Tooltip label={label}>
      <ActionIcon
        variant="subtle"
        color="gray"
        size="lg"
        aria-label={label}
        {...(large ? { visibleFrom: "xs" } : {})}
        {...(on === undefined ? {} : { "aria-pressed": on })}
        disabled={off}
        onClick={act}
        data-testid={testId}
      >
        {children}
      </ActionIcon>
    </Tooltip>
  );
}
