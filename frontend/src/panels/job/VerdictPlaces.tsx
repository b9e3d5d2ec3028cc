/** Places at which the program makes more or less than the drawing; each click zooms to the next. */

import { IconArrowsHorizontal, IconArrowsMinimize } from "@tabler/icons-react";
import { type ReactNode, useState } from "react";
import type { VerdictSummary } from "../../api/client";
import { lineTypeOf } from "../../geometry/records";
import { translate } from "../../language/translate";
import { formatLength } from "../../state/format";
import { placesOf } from "../../state/job/verdictPlaces";
import { useBoards, useEdges, useJob, useVerdict } from "../../state/queries";
import { useUiStore } from "../../state/store";
import css from "../shared/panels.module.css";

export function VerdictPlaces({ verdict }: { verdict: VerdictSummary }) {
  const { data: full } = useVerdict();
  const { data: job } = useJob();
  const { data: boards } = useBoards();
  const { data: edges } = useEdges();
  if (full === undefined) return null;
  const [over, left, uncut] = [full.edge_overcut, full.edge_setback, full.edge_uncut].map(placesOf);
  // The board limits the overcut of V-grooves; that of other lines ends in the waste.
  const isGroove = lineTypeOf(edges?.lineType[over?.[0] ?? -1]) === "v-groove";
  const limit = boards?.find(({ name }) => name === job?.board)?.groove_overcut ?? 0;
  const allowed = isGroove ? limit : 0;
  return (
    <>
      {over !== undefined && over.length > 0 && (
        <Places rows={over} icon={<IconArrowsHorizontal size={15} aria-hidden />} testId="overcuts">
          {translate("verdictPlaces.overcut", {
            length: formatLength(verdict.overcut),
            places: over.length,
          })}
          {allowed > 0 &&
            `, ${translate("verdictPlaces.allowed", { length: formatLength(allowed) })}`}
        </Places>
      )}
      {left !== undefined && left.length > 0 && (
        <Places rows={left} icon={<IconArrowsMinimize size={15} aria-hidden />} testId="left-out">
          {translate("verdictPlaces.leftOut", {
            length: formatLength(verdict.setback_total),
            places: left.length,
          })}
        </Places>
      )}
      {uncut !== undefined && uncut.length > 0 && (
        <Places rows={uncut} icon={<IconArrowsMinimize size={15} aria-hidden />} testId="uncut">
          {translate("verdictPlaces.uncut", {
            length: formatLength(verdict.uncut),
            places: uncut.length,
          })}
        </Places>
      )}
    </>
  );
}

interface PlacesProps {
  /** Rows of the edges, the largest figure first. */
  readonly rows: readonly number[];
  readonly icon: ReactNode;
  readonly testId: string;
  readonly children: ReactNode;
}

function Places({ rows, icon, testId, children }: PlacesProps) {
  const [next, setNext] = useState(0);
  const zoomToEdges = useUiStore((ui) => ui.zoomToEdges);
  return (
    <button
      type="button"
      className={css.pick}
      title={translate("verdictPlaces.eachClickShowsTheNext")}
      onClick={() => {
        const row = rows[next % rows.length];
        if (row !== undefined) zoomToEdges([row]);
        setNext(next + 1);
      }}
      data-testid={testId}
    >
      {icon}
      <span>{children}</span>
    </button>
  );
}
