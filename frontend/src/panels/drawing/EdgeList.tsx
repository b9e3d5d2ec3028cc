/** The edges of the drawing as a table that sorts and filters; only the rows in view are rendered. */

import { Button, NativeSelect, TextInput } from "@mantine/core";
import { useDeferredValue, useMemo, useState } from "react";
import { translate } from "../../language/translate";
import {
  EDGE_STATES,
  type EdgeState,
  type ListFilter,
  type ListSort,
  listedRows,
  NO_LIST_FILTER,
} from "../../state/drawing/edgeList";
import { LEGEND, LINE_STYLES } from "../../state/drawing/palette";
import { isLineType } from "../../state/drawing/questions";
import { useEdges } from "../../state/queries";
import { useUiStore } from "../../state/store";
import { Note } from "../shared/parts";
import { EdgeTable } from "./EdgeTable";
import css from "./edgeList.module.css";
import { STATE_TITLES } from "./edgeStateTitles";
import { PanelSwitch } from "./PanelSwitch";

export function EdgeList() {
  const { data: edges } = useEdges();
  const [filter, setFilter] = useState<ListFilter>(NO_LIST_FILTER);
  const [sort, setSort] = useState<ListSort>({ column: "row", down: false });
  const selectEdges = useUiStore((ui) => ui.selectEdges);
  const selected = useUiStore((ui) => ui.selection.size);
  // Typing does not wait until many edges are sorted.
  const wanted = useDeferredValue(filter);
  const listed = useMemo(
    () => (edges === undefined ? [] : listedRows(edges, wanted, sort)),
    [edges, wanted, sort],
  );
  return (
    <div className={css.whole} data-testid="edge-list">
      <PanelSwitch />
      <Filter filter={filter} onChange={setFilter} />
      {edges !== undefined && (
        <EdgeTable edges={edges} listed={listed} sort={sort} onSort={setSort} />
      )}
      <div className={css.foot}>
        <Note role="status" data-testid="list-count">
          {translate("edgeList.listedAndSelected", { listed: listed.length, selected })}
        </Note>
        <Button
          size="compact-xs"
          variant="default"
          disabled={listed.length === 0}
          onClick={() => selectEdges(listed)}
          data-testid="select-listed"
        >
          {translate("edgeList.selectTheListed")}
        </Button>
      </div>
    </div>
  );
}

interface FilterProps {
  readonly filter: ListFilter;
  onChange(filter: ListFilter): void;
}

const isState = (word: string): word is EdgeState => EDGE_STATES.some((state) => state === word);

function Filter({ filter, onChange }: FilterProps) {
  return (
    <div className={css.filter}>
      <TextInput
        size="xs"
        type="search"
        aria-label={translate("edgeList.layerOrNumber")}
        placeholder={translate("edgeList.layerOrNumber")}
        value={filter.text}
        onChange={({ currentTarget }) => onChange({ ...filter, text: currentTarget.value })}
      />
      <NativeSelect
        size="xs"
        aria-label={translate("selectMenu.lineType")}
        value={filter.type ?? ""}
        onChange={({ currentTarget: { value } }) =>
          onChange({
            ...filter,
            type: value === "unclassified" || isLineType(value) ? value : null,
          })
        }
        data={[
          { value: "", label: translate("edgeList.allLineTypes") },
          ...LEGEND.map((type) => ({ value: type, label: LINE_STYLES[type].title })),
        ]}
      />
      <NativeSelect
        size="xs"
        aria-label={translate("edgeList.state")}
        value={filter.state ?? ""}
        onChange={({ currentTarget: { value } }) =>
          onChange({ ...filter, state: isState(value) ? value : null })
        }
        data={[
          { value: "", label: translate("edgeList.allStates") },
          ...EDGE_STATES.map((state) => ({ value: state, label: STATE_TITLES[state] })),
        ]}
      />
    </div>
  );
}
