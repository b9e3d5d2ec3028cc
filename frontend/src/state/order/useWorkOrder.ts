/** The tracks of the newest program of the open drawing, in the order of the next one. */

import { useQuery } from "@tanstack/react-query";
import { useMemo } from "react";
import { isOutdated } from "../drawing/steps";
import { hasProgram } from "../job/jobs";
import { queries, useDrawing, useEdges, useJob } from "../queries";
import { useUiStore } from "../store";
import { inChosenOrder, newestProgram, type WorkItem, workItems } from "./workOrder";

export interface WorkOrder {
  /** Offset from the drawing to the sheet (mm). */
  readonly placement: readonly [number, number];
  readonly items: readonly WorkItem[];
}

/** null while there is no program of the drawing as it is now. */
export function useWorkOrder(): WorkOrder | null {
  const { data: drawing } = useDrawing();
  const { data: edges } = useEdges();
  const { data: open } = useJob();
  const order = useUiStore((ui) => ui.options.work_order);
  const { data: jobs } = useQuery({
    ...queries.jobsOf(drawing?.id ?? ""),
    enabled: drawing !== undefined,
  });
  const job = open !== undefined && hasProgram(open) ? open : newestProgram(jobs ?? []);
  const wanted = job !== null && drawing !== undefined && !isOutdated(job, drawing);
  const id = job?.id ?? "";
  const { data: tracks } = useQuery({ ...queries.tracks(id, job?.line ?? 0), enabled: wanted });
  const { data: toolpath } = useQuery({ ...queries.toolpath(id), enabled: wanted });
  const made = useMemo(
    () => (wanted && tracks !== undefined && edges !== undefined ? workItems(tracks, edges) : null),
    [wanted, tracks, edges],
  );
  return useMemo(
    () =>
      made === null || toolpath === undefined
        ? null
        : { placement: toolpath.placement, items: inChosenOrder(made, order) },
    [made, toolpath, order],
  );
}
