/** Which machine a new job proposes. */

import type { Machine } from "../api/client";

/** Name of the first machine that is connected, otherwise of the first one; null if there is none. */
export function proposedMachine(
  machines: readonly Pick<Machine, "name" | "gateway">[],
): string | null {
  const connected = machines.find(({ gateway }) => gateway === "connected");
  return (connected ?? machines[0])?.name ?? null;
}
