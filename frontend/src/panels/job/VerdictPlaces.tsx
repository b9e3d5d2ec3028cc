/** Places at which the program makes more or less than the drawing; each click zooms to the next. */

import { IconArrowsMinimize } from "@tabler/icons-react";
import { type ReactNode, useState } from "react";
import type { VerdictSummary } from "../../api/jobs";
import { lineTypeOf } from "../../geometry/records";
import { translate } from "../../language/translate";
import { formatLength } from "../../state/format";
import { placesOf } from "../../state/job/verdictPlaces";
import { useBoards, useEdges, useJob, useVerdict } from "../../state/queries";
import { useUiStore } from "../../state/store";
import css from "../shared/panels.module.css";
import { LinkButton } from "../shared/parts";

/** The end of the sentence of the verdict: the overcut if there is any, and the full stop. */
export function OvercutClause({ verdict }: { verdict: VerdictSummary }) {
  const { data: full } = useVerdict();
  const { data: job } = useJob();
  const { data: boards } = useBoards();
  const { data: edges } = useEdges();
  const over = placesOf(full?.edge_overcut ?? []);
  const zoomToNext = useNextPlace(over);
  if (over.length === 0) return ".";
  // The board limits the overcut of V-grooves; that of other lines ends in the waste.
  const isGroove = lineTypeOf(edges?.lineType[over[0] ?? -1]) === "v-groove";
  const limit = boards?.find(({ name }) => name === job?.board)?.groove_overcut ?? 0;
  const allowed = isGroove ? limit : 0;
  return (
    <>
      {"; "}
      <LinkButton
        fz={14}
        fw={600}
        title={translate("verdictPlaces.eachClickShowsTheNext")}
        onClick={zoomToNext}
        data-testid="overcuts"
      >
        {translate("verdictPlaces.overcut", {
          length: formatLength(verdict.overcut),
          places: over.length,
        })}
        {allowed > 0 &&
          `, ${translate("verdictPlaces.allowed", { length: formatLength(allowed) })}`}
        .
      </LinkButton>
    </>
  );
}

export function VerdictPlaces({ verdict }: { verdict: VerdictSummary }) {
  const { data: full } = useVerdict();
  if (full === undefined) return null;
  const [left, uncut] = [full.edge_setback, full.edge_uncut].map(placesOf);
  return (
    <>
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

/** An action that shows the first of some edges, and with each call the next one. */
function useNextPlace(rows: readonly number[]): () => void {
  const [next, setNext] = useState(0);
  const zoomToEdges = useUiStore((ui) => ui.zoomToEdges);
  return () => {
    const row = rows[next % rows.length];
    if (row !== undefined) zoomToEdges([row]);
    setNext(next + 1);
  };
}

function Places({ rows, icon, testId, children }: PlacesProps) {
  const zoomToNext = useNextPlace(rows);
  return (
    <button
      type="button"
      className={css.pick}
      title={translate("verdictPlaces.eachClickShowsTheNext")}
      onClick={zoomToNext}
      data-testid={testId}
    >
      {icon}
      <span>{children}</span>
    </button>
  );
}
