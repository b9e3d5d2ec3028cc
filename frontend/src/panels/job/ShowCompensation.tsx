/** Button that zooms to the largest offset of head and tip, and plays the program there slowly. */

import { Button } from "@mantine/core";
import { IconPlayerPlay } from "@tabler/icons-react";
import { useEffect, useMemo, useRef } from "react";
import { tipOffset } from "../../geometry/tip";
import { translate } from "../../language/translate";
import { largestOffset, type Showing } from "../../state/job/compensation";
import { useJob, useMachines, useTimeline } from "../../state/queries";
import { useUiStore } from "../../state/store";

/** Half the side of the zoom box: at least (mm), and relative to the offset. */
const MIN_VIEW = 6;
const VIEW = 4;
/** Program time before and after the move (s), and how long both are played (s). */
const AROUND = 0.6;
const PLAY = 8;

export function ShowCompensation() {
  const { data: job } = useJob();
  const { data: timeline } = useTimeline();
  const { data: machines } = useMachines();
  const frame = useRef(0);
  const found = useMemo(() => {
    const stations = machines?.find(({ name }) => name === job?.machine)?.stations ?? [];
    const offsets = new Map(
      stations.map(({ number, tool }) => [number, tipOffset(tool.footprint)]),
    );
    return timeline === undefined ? null : largestOffset(timeline, offsets);
  }, [timeline, machines, job?.machine]);
  useEffect(() => () => cancelAnimationFrame(frame.current), []);
  if (found === null) return null;
  return (
    <Button
      mt={10}
      size="sm"
      variant="default"
      leftSection={<IconPlayerPlay size={15} aria-hidden />}
      onClick={() => {
        cancelAnimationFrame(frame.current);
        lookAt(found);
        play(found, (next) => {
          frame.current = next;
        });
      }}
      data-testid="show-compensation"
    >
      {translate("showCompensation.showTheCompensation")}
    </Button>
  );
}

/** Show line, tip and head, and zoom to where the head is farthest from the tip. */
function lookAt({ tip, head }: Showing): void {
  const { layers, set, zoomToBox } = useUiStore.getState();
  for (const layer of ["nominal", "tip", "head"] as const)
    if (!layers[layer]) useUiStore.getState().toggleLayer(layer);
  set({ colourMode: "types" });
  const reach = Math.max(MIN_VIEW, VIEW * Math.hypot(head.x - tip.x, head.y - tip.y));
  const [x, y] = [(tip.x + head.x) / 2, (tip.y + head.y) / 2];
  zoomToBox([x - reach, y - reach, x + reach, y + reach]);
}

/** Play the program around a move; a slider that the user moves, or another job, ends it. */
function play({ to }: Showing, keep: (frame: number) => void): void {
  const first = Math.max(0, to - AROUND);
  const pace = (to + AROUND - first) / (PLAY * 1000);
  const begin = performance.now();
  let shown = first;
  useUiStore.getState().set({ previewTime: first });
  const step = (now: number) => {
    const { previewTime, set } = useUiStore.getState();
    if (previewTime !== shown) return;
    shown = first + (now - begin) * pace;
    if (shown > to + AROUND) return;
    set({ previewTime: shown });
    keep(requestAnimationFrame(step));
  };
  keep(requestAnimationFrame(step));
}
