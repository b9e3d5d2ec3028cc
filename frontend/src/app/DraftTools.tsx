/** Buttons that choose what the pointer does on the canvas: select, measure, draw or move. */

import { ActionIcon, Tooltip } from "@mantine/core";
import {
  IconCircle,
  IconDimensions,
  IconLassoPolygon,
  IconLine,
  IconMarquee2,
  IconPointer,
  IconRuler2,
  IconVectorSpline,
} from "@tabler/icons-react";
import { type ComponentType, useEffect, useRef } from "react";
import { translate } from "../language/translate";
import overlayCss from "../panels/drawing/overlay.module.css";
import { SelectMenu } from "../panels/drawing/SelectMenu";
import { useRovingFocus } from "../panels/shared/roving";
import { useRefusal } from "../state/accounts/accounts";
import { useDimensions } from "../state/drafting/dimensions";
import { type Tool, useDrafting } from "../state/drafting/drafting";
import { useDrawing, useEdges } from "../state/queries";
import css from "./app.module.css";

const BUTTONS: readonly {
  tool: Tool | null;
  label: string;
  Icon: ComponentType<{ size: number }>;
}[] = [
  { tool: null, label: translate("draftTools.selectEdgesKey"), Icon: IconPointer },
  { tool: "box", label: translate("draftTools.selectByBoxKey"), Icon: IconMarquee2 },
  { tool: "lasso", label: translate("draftTools.selectByLassoKey"), Icon: IconLassoPolygon },
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
  const { data: edges } = useEdges();
  const refusal = useRefusal("PATCH /api/v1/drawings/{id}");
  useRovingFocus(bar);
  // Other steps have no drawing tools.
  useEffect(() => () => choose(null), [choose]);
  const noUnit = drawing?.unit === null ? translate("draftTools.chooseTheUnitFirst") : null;
  const loading = edges === undefined ? translate("draftTools.edgesAreLoading") : null;
  return (
    <div
      ref={bar}
      className={`${overlayCss.float} ${css.tools}`}
      role="toolbar"
      aria-orientation="vertical"
      aria-label={translate("draftTools.whatAClickDoes")}
    >
      {BUTTONS.map(({ tool, label, Icon }) => {
        const changes = tool === "line" || tool === "circle" || tool === "move";
        const why = (changes ? (refusal ?? noUnit) : null) ?? (tool === null ? null : loading);
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
      <SelectMenu />
      <DimensionsButton />
    </div>
  );
}

function DimensionsButton() {
  const shown = useDimensions((dimensions) => dimensions.shown);
  const toggle = useDimensions((dimensions) => dimensions.toggle);
  const label = translate("draftTools.showDimensionsKey");
  return (
    <Tooltip label={label} position="right">
      <ActionIcon
        variant={shown ? "light" : "subtle"}
        color={shown ? "blue" : "gray"}
        aria-label={label}
        aria-pressed={shown}
        onClick={toggle}
        data-testid="dimensions"
      >
        <IconDimensions size={16} />
      </ActionIcon>
    </Tooltip>
  );
}
