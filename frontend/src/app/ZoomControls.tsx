/** Zoom buttons of the canvas. */

import { ActionIcon, Tooltip } from "@mantine/core";
import { IconFocusCentered, IconMinus, IconPlus } from "@tabler/icons-react";
import { translate } from "../language/translate";
import overlayCss from "../panels/drawing/overlay.module.css";
import type { Viewer } from "../viewer/viewer";
import css from "./app.module.css";

export function ZoomControls({ viewer }: { viewer: Viewer | null }) {
  return (
    <div className={`${overlayCss.float} ${css.zoom}`}>
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

function ZoomButton(props: { label: string; act: () => void; children: React.ReactNode }) {
  return (
    <Tooltip label={props.label} position="left">
      <ActionIcon variant="subtle" color="gray" aria-label={props.label} onClick={props.act}>
        {props.children}
      </ActionIcon>
    </Tooltip>
  );
}
