/** Name, undo and redo, the state of the machine. */

import { ActionIcon, Tooltip } from "@mantine/core";
import {
  IconArrowBackUp,
  IconArrowForwardUp,
  IconKeyboard,
  IconLayoutSidebar,
  IconLayoutSidebarRight,
} from "@tabler/icons-react";
import type { ReactNode } from "react";
import { MachineChip } from "../panels/MachineChip";
import { redo, undo } from "../state/actions";
import { useEditing } from "../state/editing";
import { usePage } from "../state/store";
import css from "./app.module.css";
import { Logo } from "./Logo";

export function TopBar() {
  const open = usePage((page) => page.open);
  const drawing = usePage((page) => page.drawing);
  const editing = usePage((page) => page.editing !== null);
  const steps = useEditing();
  const past = usePage((page) => page.past.length) + (editing ? steps.past.length : 0);
  const future = usePage((page) => page.future.length) + (editing ? steps.future.length : 0);
  const busy = usePage((page) => page.busy);
  const leftOpen = usePage((page) => page.leftOpen);
  const rightOpen = usePage((page) => page.rightOpen);
  const set = usePage((page) => page.set);
  return (
    <header className={css.top}>
      <button type="button" className={css.brand} onClick={() => open(null)} aria-label="knifetip">
        <Logo />
        knifetip
      </button>
      <span className={css.divider} />
      <Icon label="Left panel ([)" on={leftOpen} act={() => set({ leftOpen: !leftOpen })}>
        <IconLayoutSidebar size={18} stroke={1.6} />
      </Icon>
      {drawing !== null && (
        <>
          <Icon
            label="Undo (Ctrl Z)"
            off={past === 0 || busy}
            act={() => void undo()}
            testId="undo"
          >
            <IconArrowBackUp size={18} stroke={1.6} />
          </Icon>
          <Icon
            label="Redo (Ctrl Shift Z)"
            off={future === 0 || busy}
            act={() => void redo()}
            testId="redo"
          >
            <IconArrowForwardUp size={18} stroke={1.6} />
          </Icon>
        </>
      )}
      <span className={css.gap} />
      <MachineChip />
      <Icon label="Keys and mouse (?)" act={() => set({ helpOpen: true })}>
        <IconKeyboard size={18} stroke={1.6} />
      </Icon>
      <Icon label="Right panel (])" on={rightOpen} act={() => set({ rightOpen: !rightOpen })}>
        <IconLayoutSidebarRight size={18} stroke={1.6} />
      </Icon>
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
