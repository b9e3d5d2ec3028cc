/** Go along the program by hand, or let it play, before anything moves on the table. */

import { ActionIcon, Slider } from "@mantine/core";
import { IconPlayerPauseFilled, IconPlayerPlayFilled } from "@tabler/icons-react";
import { useEffect, useState } from "react";
import { duration as lengthOf } from "../geometry/timeline";
import { isOnTable } from "../state/jobs";
import { useJob, useTimeline } from "../state/queries";
import { usePage } from "../state/store";
import { duration } from "../state/words";
import overCss from "./over.module.css";
import css from "./panels.module.css";

/** A play-through lasts about this long, however long the program is (s). */
const PLAY = 20;

export function Scrubber() {
  const { data: job } = useJob();
  const { data: line } = useTimeline();
  const scrub = usePage((page) => page.scrub);
  const set = usePage((page) => page.set);
  const [playing, setPlaying] = useState(false);
  const whole = line === undefined ? 0 : lengthOf(line);

  useEffect(() => {
    if (!playing || whole === 0) return;
    const pace = Math.max(1, whole / PLAY);
    let before = performance.now();
    let frame = requestAnimationFrame(function step(now) {
      const next = (usePage.getState().scrub ?? 0) + ((now - before) / 1000) * pace;
      before = now;
      set({ scrub: Math.min(whole, next) });
      if (next >= whole) setPlaying(false);
      else frame = requestAnimationFrame(step);
    });
    return () => cancelAnimationFrame(frame);
  }, [playing, whole, set]);

  if (job === undefined || line === undefined || whole === 0 || isOnTable(job)) return null;
  const at = scrub ?? (job.state === "done" ? whole : 0);
  return (
    <div className={`${overCss.float} ${overCss.scrubber}`} data-testid="scrubber">
      <ActionIcon
        variant="subtle"
        color="gray"
        aria-label={playing ? "Pause the preview" : "Play the preview"}
        data-testid="play"
        onClick={() => {
          if (!playing && (scrub === null || scrub >= whole)) set({ scrub: 0 });
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
        max={whole}
        step={whole / 1000}
        value={at}
        label={null}
        thumbLabel="Place in the program"
        onChange={(value) => {
          setPlaying(false);
          set({ scrub: value });
        }}
      />
      <span className={css.rowFigure}>
        {duration(at)} / {duration(whole)}
      </span>
    </div>
  );
}
