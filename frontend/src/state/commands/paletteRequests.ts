/** Requests to open the command palette, by keys and by buttons. */

import { create } from "zustand";

interface PaletteRequests {
  readonly requests: number;
  /** Open the palette, or close it if it is open. */
  request(): void;
}

export const usePaletteRequests = create<PaletteRequests>()((set) => ({
  requests: 0,
  request: () => set(({ requests }) => ({ requests: requests + 1 })),
}));
