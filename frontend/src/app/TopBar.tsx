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
import { AccountButton } from "../panels/AccountDialog";
import { MachineChip } from "../panels/MachineChip";
import { OperatorButton } from "../panels/OperatorForm";
import { redo, undo } from "../state/actions";
import { useProfileDraft } from "../state/profileDraft";
import { useUiStore } from "../state/store";
import css from "./app.module.css";
import { Logo } from "./Logo";
import { useRovingFocus } from "./roving";

export function TopBar() {
  const open = useUiStore((ui) => ui.open);
  const drawing = useUiStore((ui) => ui.drawing);
  const editing = useUiStore((ui) => ui.editedProfile !== null);
  const steps = useProfileDraft();
  const past = useUiStore((ui) => ui.past.length) + (editing ? steps.past.length : 0);
  const future = useUiStore((ui) => ui.future.length) + (editing ? steps.future.length : 0);
  const busy = useUiStore((ui) => ui.busy);
  const leftOpen = useUiStore((ui) => ui.leftOpen);
  const rightOpen = useUiStore((ui) => ui.rightOpen);
  const history = useUiStore((ui) => ui.history);
  const set = useUiStore((ui) => ui.set);
  const tools = useRef<HTMLDivElement>(null);
  useRovingFocus(tools);
  return (
    <header className={css.top}>
      <button
        type="button"
        className={css.brand}
        onClick={() => open(null)}
        aria-label="knifetip: show all drawings"
      >
        <Logo />
        knifetip
      </button>
      <div ref={tools} className={css.tools} role="toolbar" aria-label="Views and account">
        <span className={css.divider} />
        <Icon
          label="Show or hide the left panel (key [)"
          on={leftOpen}
          act={() => set({ leftOpen: !leftOpen })}
        >
          <IconLayoutSidebar size={18} stroke={1.6} />
        </Icon>
        {drawing !== null && (
          <>
            <Icon
              label="Undo the last change (Ctrl Z)"
              off={past === 0 || busy}
              act={() => void undo()}
              testId="undo"
            >
              <IconArrowBackUp size={18} stroke={1.6} />
            </Icon>
            <Icon
              label="Redo the undone change (Ctrl Shift Z)"
              off={future === 0 || busy}
              act={() => void redo()}
              testId="redo"
            >
              <IconArrowForwardUp size={18} stroke={1.6} />
            </Icon>
          </>
        )}
        <span className={css.gap} />
        <OperatorButton className={css.operator ?? ""} />
        <AccountButton />
        <MachineChip />
        <Icon
          label="Ended jobs, statistics and tools"
          on={history}
          act={() => set({ history: !history })}
          testId="history-button"
        >
          <IconHistory size={18} stroke={1.6} />
        </Icon>
        <span className={css.keys}>
          <Icon label="Keyboard and mouse shortcuts (?)" act={() => set({ helpOpen: true })}>
            <IconKeyboard size={18} stroke={1.6} />
          </Icon>
        </span>
        <Icon
          label="Show or hide the right panel (key ])"
          on={rightOpen}
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
  testId?: string;
  children: ReactNode;
}

function Icon({ label, act, off = false, on, testId, children }: IconProps) {
  return (
    <Tooltip label={label}>
      <ActionIcon
        variant="subtle"
        color="gray"
        size="lg"
        aria-label={label}
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
