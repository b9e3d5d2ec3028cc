/** Figures of a verdict and facts of a program that are lines with a title, as the server declares them. */

import { EDGE_FIGURES, PROGRAM_FACTS, PROGRAM_FIGURES } from "../../api/figures.gen";
import type { ServerMessage } from "../../messages/translateMessage";

/** Unit of a figure; empty for a number of things. */
export type FigureUnit = "mm" | "s" | "bytes" | "";

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

type ProgramFact = keyof typeof PROGRAM_FACTS;

export const PROGRAM_FACT_LINES = Object.entries(PROGRAM_FACTS).map(([name, { unit }]) => ({
  name,
  unit,
})) as readonly { readonly name: ProgramFact; readonly unit: FigureUnit }[];
