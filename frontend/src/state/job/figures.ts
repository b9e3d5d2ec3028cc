/** Figures of a verdict and facts of a program that are lines with a title, as the server declares them. */

import { EDGE_FIGURES, PROGRAM_FACTS, PROGRAM_FIGURES } from "../../api/figures.gen";
import { formatNumber } from "../../language/numbers";
import type { ServerMessage } from "../../messages/translateMessage";
import { formatBytes, formatDuration, formatHundredths, formatLength } from "../format";

/** Unit of a figure; empty for a number of things. */
type FigureUnit = "mm" | "s" | "bytes" | "";

const FORMATS: Readonly<Record<FigureUnit, (value: number) => string>> = {
  mm: (value) => (value < 10_000 ? formatHundredths(value) : formatLength(value)),
  s: formatDuration,
  bytes: formatBytes,
  "": formatNumber,
};

/** A figure with its unit. */
export const figureText = (value: number, unit: FigureUnit): string => FORMATS[unit](value);

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

export const PROGRAM_FACT_LINES = Object.entries(PROGRAM_FACTS).map(([name, fact]) => ({
  name,
  ...fact,
})) as readonly {
  readonly name: ProgramFact;
  readonly unit: FigureUnit;
  readonly listed: boolean;
}[];

/** The facts that the list of ended jobs has. */
export const LISTED_FACTS = PROGRAM_FACT_LINES.filter(({ listed }) => listed);
