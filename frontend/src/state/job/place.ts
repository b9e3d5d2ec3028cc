/** The edge at the place that a user looks at: the one picked last, or the one under the slider. */

import { useState } from "react";
import { rowAt, type Timeline } from "../../geometry/timeline";
import { useUiStore } from "../store";

/** Row of the edge that the tool makes at a time (s), or has made last; -1 before the first one. */
export function edgeAt(timeline: Timeline, seconds: number): number {
  const { source } = timeline.toolpath;
  for (let row = rowAt(timeline, seconds); row >= 0; row--)
    if ((source[row] ?? -1) >= 0) return source[row] as number;
  return -1;
}

/** Row of the edge at the place, whichever of selection and slider was changed last; -1 for none. */
export function useEdgeAtPlace(timeline: Timeline | undefined): number {
  const selection = useUiStore((ui) => ui.selection);
  const previewTime = useUiStore((ui) => ui.previewTime);
  const [seen, setSeen] = useState({ selection, previewTime, picked: selection.size > 0 });
  if (seen.selection !== selection || seen.previewTime !== previewTime) {
    const picked = seen.selection !== selection && selection.size > 0;
    setSeen({ selection, previewTime, picked });
  }
  const [edge = -1] = selection;
  if (seen.picked || timeline === undefined || previewTime === null) return edge;
  return edgeAt(timeline, previewTime);
}
