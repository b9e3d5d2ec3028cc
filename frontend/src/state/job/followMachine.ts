/** Keeps the job of a machine open, and tells whether the server can be reached. */

import { useEffect, useSyncExternalStore } from "react";
import { useQueue, useStation } from "../queries";
import { useUiStore } from "../store";

/**
 * Open the job on the table of a machine, else the next one of its queue.
 *
 * A job that has ended remains open until there is another one.
 */
export function useFollowedJob(machine: string): void {
  const { data: station } = useStation(machine);
  const { data: queue } = useQueue(machine);
  const open = useUiStore((ui) => ui.open);
  const set = useUiStore((ui) => ui.set);
  const entries = queue?.entries ?? [];
  const found = entries.find(({ job }) => job.id === station?.job) ?? entries[0];
  const { id, drawing, sheet } = found?.job ?? {};
  useEffect(() => {
    if (id === undefined || drawing === undefined) return;
    const page = useUiStore.getState();
    if (page.drawing !== drawing || page.job !== id) open(drawing, id);
    set({ sheet: sheet ?? null });
  }, [id, drawing, sheet, open, set]);
}

const watchNetwork = (changed: () => void): (() => void) => {
  window.addEventListener("online", changed);
  window.addEventListener("offline", changed);
  return () => {
    window.removeEventListener("online", changed);
    window.removeEventListener("offline", changed);
  };
};

/** Whether a request would arrive at the server now. */
export function useServerReached(machine: string): boolean {
  const connection = useUiStore((ui) => ui.connection);
  const { isError } = useStation(machine);
  const online = useSyncExternalStore(watchNetwork, () => navigator.onLine);
  return online && !isError && connection !== "broken";
}
