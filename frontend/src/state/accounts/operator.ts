/** The operator of this device: name, and whether the page has asked for it. */

import { create } from "zustand";
import { storedOperator, storeOperator } from "../../api/operator";

interface Operator {
  /** null: not asked yet on this device; empty: the person gave no name. */
  readonly name: string | null;
  /** Whether the name is being changed. */
  readonly changing: boolean;
  change(): void;
  keep(name: string): void;
  close(): void;
}

export const useOperator = create<Operator>()((set) => ({
  name: storedOperator(),
  changing: false,
  change: () => set({ changing: true }),
  keep: (name) => set({ name: storeOperator(name), changing: false }),
  // A person who closes the question is not asked again.
  close: () => set(({ name }) => ({ name: name ?? storeOperator(""), changing: false })),
}));
