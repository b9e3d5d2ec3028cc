/** Buttons of the canvas: undo, redo, zoom. */

import { ActionIcon, Tooltip } from "@mantine/core";
import {
  IconArrowBackUp,
  IconArrowForwardUp,
  IconFocusCentered,
  IconMinus,
  IconPlus,
} from "@tabler/icons-react";
import { type ReactNode, useRef } from "react";
import { translate } from "../language/translate";
import overlayCss from "../panels/drawing/overlay.module.css";
import { useRovingFocus } from "../panels/shared/roving";
import { redo, undo } from "../state/actions";
import { useProfileDraft } from "../state/drawing/profileDraft";
import { useUiStore } from "../state/store";
import type { Viewer } from "../viewer/viewer";
import css from "./app.module.css";

export function ZoomControls({ viewer }: { viewer: Viewer | null }) {
  const bar = useRef<HTMLDivElement>(null);
  const editing = useUiStore((ui) => ui.editedProfile !== null);
  const steps = useProfileDraft();
  const past = useUiStore((ui) => ui.past.length) + (editing ? steps.past.length : 0);
  const future = useUiStore((ui) => ui.future.length) + (editing ? steps.future.length : 0);
  const busy = useUiStore((ui) => ui.busy);
  useRovingFocus(bar);
  return (
    <div
      ref={bar}
      className={`${overlayCss.float} ${css.zoom}`}
      role="toolbar"
      aria-orientation="vertical"
      aria-label={translate("zoomControls.undoAndZoom")}
    >
      <ZoomButton
        label={translate("topBar.undoTheLastChangeCtrl")}
        off={past === 0 || busy}
        act={() => void undo()}
        testId="undo"
      >
        <IconArrowBackUp size={16} />
      </ZoomButton>
      <ZoomButton
        label={translate("topBar.redoTheUndoneChangeCtrl")}
        off={future === 0 || busy}
        act={() => void redo()}
        testId="redo"
      >
        <IconArrowForwardUp size={16} />
      </ZoomButton>
      <ZoomButton label={translate("zoomControls.zoomInKey")} act={() => viewer?.zoomBy(1.4)}>
        <IconPlus size={16} />
      </ZoomButton>
      <ZoomButton label={translate("zoomControls.zoomOutKey")} act={() => viewer?.zoomBy(1 / 1.4)}>
        <IconMinus size={16} />
      </ZoomButton>
      <ZoomButton
        label={translate("zoomControls.showTheWholeDrawingKey")}
        act={() => viewer?.fit()}
      >
        <IconFocusCentered size={16} />
      </ZoomButton>
    </div>
  );
}

interface ZoomButtonProps {
  readonly label: string;
  readonly act: () => void;
  readonly off?: boolean;
  readonly testId?: string;
  readonly children: ReactNode;
}

function ZoomButton({ label, act, off = false, testId, children }: ZoomButtonProps) {
  return (
    <Tooltip label={label} position="left">
      <ActionIcon
        variant="subtle"
        color="gray"
        aria-label={label}
        disabled={off}
        onClick={act}
        data-testid={testId}
      >
        {children}
      </ActionIcon>
    </Tooltip>
  );
}
