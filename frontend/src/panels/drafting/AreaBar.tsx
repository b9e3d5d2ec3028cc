/** What the edges in a drawn area do to the selection: for fingers, which have no Shift and Ctrl. */

import { CloseButton, Group, SegmentedControl, Text } from "@mantine/core";
import type { SelectMode } from "../../geometry/selection";
import { translate } from "../../language/translate";
import { type AreaKind, isAreaKind, useDrafting } from "../../state/drafting/drafting";
import overlayCss from "../drawing/overlay.module.css";
import css from "./drafting.module.css";

const HINTS: Readonly<Record<AreaKind, string>> = {
  box: translate("areaBar.dragABoxAround"),
  lasso: translate("areaBar.drawALineAround"),
};

export const AREA_MODES = [
  { value: "replace", label: translate("areaBar.new") },
  { value: "add", label: translate("areaBar.add") },
  { value: "remove", label: translate("areaBar.remove") },
] as const satisfies readonly { value: SelectMode; label: string }[];

export function AreaBar() {
  const { tool, areaMode, setAreaMode, choose } = useDrafting();
  if (!isAreaKind(tool)) return null;
  return (
    <Group
      className={`${overlayCss.float} ${css.bar}`}
      role="group"
      aria-label={translate("areaBar.selectByArea")}
      gap={10}
      data-testid="area-bar"
    >
      <Text fz={12.5} role="status" maw={300} visibleFrom="xs">
        {HINTS[tool]}
      </Text>
      <SegmentedControl
        size="xs"
        aria-label={translate("areaBar.whatTheEdgesInTheAreaDo")}
        data={[...AREA_MODES]}
        value={areaMode}
        onChange={(mode) => setAreaMode(mode as SelectMode)}
      />
      <CloseButton
        size="sm"
        aria-label={translate("draftBar.leaveTheTool")}
        onClick={() => choose(null)}
      />
    </Group>
  );
}
