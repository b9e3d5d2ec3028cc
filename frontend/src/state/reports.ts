/** What went wrong, until somebody has read it: nothing is swallowed. */

import { create } from "zustand";
import { type Problem, ServiceError } from "../api/client";

export interface Report {
  readonly id: number;
  readonly title: string;
  readonly detail: string;
  readonly hint: string;
  readonly source: readonly string[];
  /** Something happened that is no fault. */
  readonly notice?: boolean;
}

interface Reports {
  readonly list: readonly Report[];
  add(report: Omit<Report, "id">): void;
  dismiss(id: number): void;
}

const MOST = 4;
let last = 0;

export const useReports = create<Reports>()((put) => ({
  list: [],
  add: (report) =>
    put(({ list }) => {
      // The same words twice are one thing to read.
      const others = list.filter(({ detail }) => detail !== report.detail);
      return { list: [...others, { ...report, id: ++last }].slice(-MOST) };
    }),
  dismiss: (id) => put(({ list }) => ({ list: list.filter((report) => report.id !== id) })),
}));

const fromProblem = ({ title, detail, hint, source }: Problem): Omit<Report, "id"> => ({
  title,
  detail,
  hint,
  source,
});

export function report(cause: unknown): void {
  const { add } = useReports.getState();
  if (cause instanceof ServiceError) add(fromProblem(cause.problem));
  else if (cause instanceof Error) {
    add({ title: "The page failed", detail: cause.message, hint: "Load it again.", source: [] });
  } else {
    add({ title: "The page failed", detail: String(cause), hint: "Load it again.", source: [] });
  }
}
