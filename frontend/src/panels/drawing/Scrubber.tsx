/** Preview of the program: a slider over its time, and a play button. */

import { ActionIcon, Slider } from "@mantine/core";
import { IconPlayerPauseFilled, IconPlayerPlayFilled } from "@tabler/icons-react";
import { useEffect, useState } from "react";
import { totalSeconds } from "../../geometry/timeline";
import { translate } from "../../language/translate";
import { formatDuration } from "../../state/format";
import { isOnTable } from "../../state/job/jobs";
import { useJob, useTimeline } from "../../state/queries";
import { useUiStore } from "../../state/store";
import { Figure } from "../shared/parts";
import overlayCss from "./overlay.module.css";

/** Duration of the playback (s); shorter programs play in real time. */
const PLAY = 20;

export function Scrubber() {
  const { data: job } = useJob();
  const { data: timeline } = useTimeline();
  const previewTime = useUiStore((ui) => ui.previewTime);
  const set = useUiStore((ui) => ui.set);
  const [playing, setPlaying] = useState(false);
  const total = timeline === undefined ? 0 : totalSeconds(timeline);

  useEffect(() => {
    if (!playing || total === 0) return;
    const pace = Math.max(1, total / PLAY);
    let before = performance.now();
    let frame = requestAnimationFrame(function step(now) {
      const next = (useUiStore.getState().previewTime ?? 0) + ((now - before) / 1000) * pace;
      before = now;
      set({ previewTime: Math.min(total, next) });
      if (next >= total) setPlaying(false);
      else frame = requestAnimationFrame(step);
    });
    return () => cancelAnimationFrame(frame);
  }, [playing, total, set]);

  if (job === undefined || timeline === undefined || total === 0 || isOnTable(job)) return null;
  const at = previewTime ?? (job.state === "done" ? total : 0);
  // The preview moves without acceleration: its clock is scaled to the machine time of the verdict.
  const seconds = job.verdict?.seconds ?? total;
  return (
    <div className={`${overlayCss.float} ${overlayCss.scrubber}`} data-testid="scrubber">
      <ActionIcon
        variant="subtle"
        color="gray"
        aria-label={
          playing
            ? translate("scrubber.pauseThePreviewOfThe")
            : translate("scrubber.playAPreviewOfThe")
        }
        data-testid="play"
        onClick={() => {
          if (!playing && (previewTime === null || previewTime >= total)) set({ previewTime: 0 });
          setPlaying(!playing);
        }}
      >
        {playing ? <IconPlayerPauseFilled size={16} /> : <IconPlayerPlayFilled size={16} />}
      </ActionIcon>
      <Slider
        style={{ flex: 1 }}
        size={4}
        thumbSize={14}
        min={0}
        max={total}
        step={total / 1000}
        value={at}
        label={null}
        thumbLabel={translate("scrubber.timeInThePreviewOf")}
        onChange={(value) => {
          setPlaying(false);
          set({ previewTime: value });
        }}
      />
      <Figure title={translate("scrubber.machineTimeUpToThe")}>
        {formatDuration((at / total) * seconds)} / {formatDuration(seconds)}
      </Figure>
    </div>
  );
}
