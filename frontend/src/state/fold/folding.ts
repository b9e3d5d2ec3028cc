/** The folded drawing: the request for it, and what its page shows of it. */

import { keepPreviousData, queryOptions } from "@tanstack/react-query";
import { type Fold, type Folding, type FoldingWanted, foldingService } from "../../api/folding";

/** Choices of the user on the page of the folded drawing. */
export interface FoldChoices {
  readonly board: string;
  readonly sideUp: "outside" | "inside";
  /** Opening angle of grooves (°); null for the fold angle of the board. */
  readonly opening: number | null;
  /** Angles of folds by their numbers (°), where they differ from the default. */
  readonly angles: Readonly<Record<number, number>>;
}

export function wantedOf({ board, sideUp, opening, angles }: FoldChoices): FoldingWanted {
  return {
    board,
    side_up: sideUp,
    ...(opening === null ? {} : { opening }),
    angle: Object.entries(angles).map(([fold, angle]) => `${fold}:${angle}`),
  };
}

export const foldingQuery = (id: string, choices: FoldChoices) =>
  queryOptions({
    queryKey: ["folding", id, wantedOf(choices)],
    queryFn: ({ signal }) => foldingService.folding(id, wantedOf(choices), signal),
    placeholderData: keepPreviousData,
  });

/** Indices of the panels that have a fault. */
export function faultyPanels({ findings }: Folding): Set<number> {
  return new Set(findings.flatMap(({ panels }) => panels.map((panel) => panel - 1)));
}

/** The fold that turns a panel; undefined for a root. */
export function foldOfPanel({ folds, order }: Folding, panel: number): Fold | undefined {
  return folds.find(({ child, number }) => child === panel + 1 && order.includes(number));
}
