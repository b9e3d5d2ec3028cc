/** Buttons that choose what a click on the canvas does: select, measure, draw or move. */

import { ActionIcon, Tooltip } from "@mantine/core";
import {
  IconCircle,
  IconLine,
  IconPointer,
  IconRuler2,
  IconVectorSpline,
} from "@tabler/icons-react";
import { type ComponentType, useEffect, useRef } from "react";
import { translate } from "../language/translate";
import overlayCss from "../panels/drawing/overlay.module.css";
import { useRefusal } from "../state/accounts/accounts";
import { type Tool, useDrafting } from "../state/drafting/drafting";
import { useDrawing } from "../state/queries";
import css from "./app.module.css";
import { useRovingFocus } from "./roving";

const BUTTONS: readonly {
  tool: Tool | null;
  label: string;
  Icon: ComponentType<{ size: number }>;
}[] = [
  { tool: null, label: translate("draftTools.selectEdges"), Icon: IconPointer },
  { tool: "measure", label: translate("draftTools.measureKey"), Icon: IconRuler2 },
  { tool: "line", label: translate("draftTools.drawALine"), Icon: IconLine },
  { tool: "circle", label: translate("draftTools.drawACircle"), Icon: IconCircle },
  { tool: "move", label: translate("draftTools.moveEnds"), Icon: IconVectorSpline },
];

export function DraftTools() {
  const bar = useRef<HTMLDivElement>(null);
  const chosen = useDrafting((draft) => draft.tool);
  const choose = useDrafting((draft) => draft.choose);
  const { data: drawing } = useDrawing();
  const refusal = useRefusal("PATCH /api/v1/drawings/{id}");
  useRovingFocus(bar);
  // Other steps have no drawing tools.
  useEffect(() => () => choose(null), [choose]);
  const noUnit = drawing?.unit === null ? translate("draftTools.chooseTheUnitFirst") : null;
  return (
    <div
      ref={bar}
      className={`${overlayCss.float} ${css.tools}`}
      role="toolbar"
      aria-orientation="vertical"
      aria-label={translate("draftTools.whatAClickDoes")}
    >
      {BUTTONS.map(({ tool, label, Icon }) => {
        const changes = tool !== null && tool !== "measure";
        const why = changes ? (refusal ?? noUnit) : null;
        return (
          <Tooltip key={label} label={why ?? label} position="right">
            <ActionIcon
              variant={chosen === tool ? "light" : "subtle"}
              color={chosen === tool ? "blue" : "gray"}
              aria-label={label}
              aria-pressed={chosen === tool}
              disabled={why !== null}
              onClick={() => choose(tool)}
              data-testid={`tool-${tool ?? "select"}`}
            >
              <Icon size={16} />
            </ActionIcon>
          </Tooltip>
        );
      })}
    </div>
  );
}
