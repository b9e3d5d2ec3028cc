/** Findings of one kind and severity, which are stated in one row. */

import type { Finding } from "../../api/jobs";

export interface FindingKind {
  readonly kind: string;
  readonly severity: Finding["severity"];
  /** All of them concern edges. */
  readonly findings: readonly Finding[];
}

/** Kinds of shortfalls and notes that concern edges, in the order of the findings. */
export function kindsOf(findings: readonly Finding[]): readonly FindingKind[] {
  const groups = new Map<
    string,
    { kind: string; severity: Finding["severity"]; rows: Finding[] }
  >();
  for (const finding of findings) {
    const { kind, severity, code, edge } = finding;
    if (severity === "fault" || edge < 0) continue;
    // Notes of one kind may be about different things.
    const key = severity === "note" ? `${kind} ${code}` : kind;
    const group = groups.get(`${severity} ${key}`) ?? { kind, severity, rows: [] };
    group.rows.push(finding);
    groups.set(`${severity} ${key}`, group);
  }
  return [...groups.values()].map(({ kind, severity, rows }) => ({
    kind,
    severity,
    findings: rows,
  }));
}

/** The edges that the tool makes as one with that of a finding, such as the chords of a curve. */
export const edgesOf = ({ edge, edges }: Pick<Finding, "edge" | "edges">): readonly number[] =>
  edges.length > 0 ? edges : [edge];

/** Who has accepted findings and why, each once. */
export function acceptancesOf(
  findings: readonly Finding[],
): readonly { readonly by: string; readonly reason: string }[] {
  const found = new Map<string, { by: string; reason: string }>();
  for (const { acceptance } of findings)
    if (acceptance) {
      const { by, reason } = acceptance;
      found.set(JSON.stringify([by, reason]), { by, reason });
    }
  return [...found.values()];
}

/** Greatest deviation (mm) of the edges that have no shortfall, accepted or not. */
export function deviationOfOthers(
  deviations: readonly number[],
  findings: readonly Finding[],
): number {
  const short = new Set(
    findings.filter(({ severity }) => severity === "shortfall").flatMap((one) => edgesOf(one)),
  );
  return deviations.reduce((most, one, row) => (short.has(row) ? most : Math.max(most, one)), 0);
}
