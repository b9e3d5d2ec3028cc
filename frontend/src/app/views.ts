/**
 * Pages that the start page does without: each is fetched when it is first shown.
 *
 * `prefetch` fetches a page before that, once it is likely to be wanted.
 */

import { type ComponentType, lazy } from "react";

const FETCH = {
  drawing: () => import("./DrawingPage"),
  machines: () => import("./MachinesPage"),
  station: () => import("./StationPage"),
  library: () => import("./LibraryPage"),
  settings: () => import("./SettingsPage"),
  webhooks: () => import("./WebhooksPage"),
  cartons: () => import("../panels/cartons/CartonPage"),
  fold: () => import("./FoldPage"),
  layout: () => import("../panels/layout/LayoutEditor"),
  history: () => import("../panels/history/HistoryPage"),
  edgeList: () => import("../panels/drawing/EdgeList"),
} as const;

/** A part of the page cannot be fetched. */
export class PartNotFetched extends Error {}

const part = <Module, Props>(
  fetch: () => Promise<Module>,
  choose: (module: Module) => ComponentType<Props>,
) =>
  lazy(() =>
    fetch().then(
      (module) => ({ default: choose(module) }),
      (cause: unknown) => {
        throw new PartNotFetched("part", { cause });
      },
    ),
  );

export const DrawingPage = part(FETCH.drawing, (module) => module.DrawingPage);
export const MachinesPage = part(FETCH.machines, (module) => module.MachinesPage);
export const StationPage = part(FETCH.station, (module) => module.StationPage);
export const LibraryPage = part(FETCH.library, (module) => module.LibraryPage);
export const SettingsPage = part(FETCH.settings, (module) => module.SettingsPage);
export const WebhooksPage = part(FETCH.webhooks, (module) => module.WebhooksPage);
export const CartonPage = part(FETCH.cartons, (module) => module.CartonPage);
export const FoldPage = part(FETCH.fold, (module) => module.FoldPage);
export const LayoutEditor = part(FETCH.layout, (module) => module.LayoutEditor);
export const HistoryPage = part(FETCH.history, (module) => module.HistoryPage);
export const EdgeList = part(FETCH.edgeList, (module) => module.EdgeList);

/** Fetch a page; a failure is shown when the page is wanted. */
export function prefetch(view: keyof typeof FETCH): void {
  FETCH[view]().catch(() => undefined);
}
