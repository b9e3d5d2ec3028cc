/** Figures of a verdict that are lines with a title, as the server declares them. */

import { EDGE_FIGURES, PROGRAM_FIGURES } from "../../api/figures.gen";
import type { ServerMessage } from "../../messages/translateMessage";

/** Unit of a figure; empty for a number of things. */
export type FigureUnit = "mm" | "s" | "";

interface Line<Name> {
  readonly name: Name;
  readonly title: ServerMessage;
}

type ProgramFigure = keyof typeof PROGRAM_FIGURES;
type EdgeFigure = keyof typeof EDGE_FIGURES;

export const PROGRAM_FIGURE_LINES = Object.entries(PROGRAM_FIGURES).map(([name, figure]) => ({
  name,
  ...figure,
})) as readonly (Line<ProgramFigure> & { readonly unit: FigureUnit })[];

/** Figures of edges, by the names of their columns; all are lengths. */
export const EDGE_FIGURE_LINES = Object.entries(EDGE_FIGURES).map(([name, { title }]) => ({
  name: `edge_${name as EdgeFigure}` as const,
  title,
})) satisfies readonly Line<`edge_${EdgeFigure}`>[];
