/** Switch between the panels of the Lines step and the list of edges. */

import { SegmentedControl } from "@mantine/core";
import { translate } from "../../language/translate";
import { useEdgeList } from "../../state/drawing/edgeList";
import css from "./edgeList.module.css";

export function PanelSwitch() {
  const open = useEdgeList((list) => list.open);
  const show = useEdgeList((list) => list.show);
  return (
    <div className={css.switch}>
      <SegmentedControl
        size="xs"
        fullWidth
        aria-label={translate("edgeList.whatThePanelShows")}
        data={[
          { value: "panels", label: translate("edgeList.lineTypesAndLayers") },
          { value: "list", label: translate("edgeList.edgeList") },
        ]}
        value={open ? "list" : "panels"}
        onChange={(value) => show(value === "list")}
        data-testid="panel-switch"
      />
    </div>
  );
}
