/** The tracks of the newest program of the open drawing, in the order of the next one. */

import { useQuery } from "@tanstack/react-query";
import { useMemo } from "react";
import { layoutService } from "../../api/layouts";
import { isOutdated } from "../drawing/steps";
import { hasProgram } from "../job/jobs";
import { queries, useDrawing, useEdges, useJob } from "../queries";
import { useUiStore } from "../store";
import { inChosenOrder, newestProgram, type WorkItem, workItems } from "./workOrder";
import { hasStages, partNumbers, type WorkPart, workParts } from "./workParts";

export interface WorkOrder {
  /** Offset from the drawing to the sheet (mm). */
  readonly placement: readonly [number, number];
  readonly items: readonly WorkItem[];
  /** The items by blanks; empty while the blanks or the operations are not known. */
  readonly parts: readonly WorkPart[];
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
  const divided = made !== null && hasStages(made);
  const { data: blanks } = useQuery({
    queryKey: ["blanks", drawing?.id, drawing?.updated],
    queryFn: ({ signal }) => layoutService.blanks(drawing?.id ?? "", signal),
    staleTime: Number.POSITIVE_INFINITY,
    retry: false,
    enabled: divided,
  });
  const numbers = useMemo(
    () =>
      divided && edges !== undefined && blanks !== undefined
        ? partNumbers(made, edges, blanks)
        : null,
    [divided, made, edges, blanks],
  );
  return useMemo(() => {
    if (made === null || toolpath === undefined) return null;
    const items = inChosenOrder(made, order);
    const parts = numbers === null ? [] : workParts(items, numbers);
    return { placement: toolpath.placement, items, parts };
  }, [made, numbers, toolpath, order]);
}
