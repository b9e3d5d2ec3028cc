/** Errors of requests: what the server reports as problem+json, or that it does not answer. */

import { translate } from "../language/translate";
import type { components } from "./openapi.gen";

export type Problem = components["schemas"]["Problem"];

const STALE_REVISION = "urn:knifetip:problem:stale-revision";

/** The server refused a request or did not answer it. */
export class ServiceError extends Error {
  override name = "ServiceError";

  constructor(readonly problem: Problem) {
    super(problem.detail || problem.title);
  }

  /** The drawing has changed since the revision that the request is for. */
  get stale(): boolean {
    return this.problem.type === STALE_REVISION;
  }

  /** The same request may succeed later: the server did not answer, or is busy or broken. */
  get temporary(): boolean {
    const { status } = this.problem;
    return status === 0 || status === 429 || status >= 500;
  }
}

const problem = (status: number, title: string, detail: string, hint: string): Problem => ({
  type: "about:blank",
  title,
  status,
  code: "stored.text",
  arguments: { text: detail, hint },
  detail,
  text: detail,
  hint,
  source: [],
  edges: [],
  questions: [],
  revision: null,
});

/** A problem that the page itself finds. */
export const pageProblem = (status: number, title: string, detail: string, hint: string) =>
  new ServiceError(problem(status, title, detail, hint));

export const noAnswer = (): ServiceError =>
  pageProblem(
    0,
    translate("errors.noResponseFromTheServer"),
    translate("errors.theKnifetipServerDoesNot"),
    translate("errors.checkThatTheServerIs"),
  );

/** Read the body of an error response; whatever it lacks is derived from the status. */
export function parseProblem(status: number, title: string, body: string): Problem {
  const fallback = problem(
    status,
    title || translate("errors.error", { status }),
    title
      ? translate("errors.theKnifetipServerAnsweredWith", { status, title })
      : translate("errors.theKnifetipServerAnsweredWith2", { status }),
    status >= 500 ? translate("errors.tryAgainIfTheError") : "",
  );
  let parsed: unknown;
  try {
    parsed = JSON.parse(body);
  } catch {
    return fallback;
  }
  if (typeof parsed !== "object" || parsed === null) return fallback;
  const known = parsed as Partial<Problem>;
  return {
    ...fallback,
    ...known,
    detail: typeof known.detail === "string" ? known.detail : fallback.detail,
    hint: typeof known.hint === "string" ? known.hint : fallback.hint,
    source: known.source ?? [],
    edges: known.edges ?? [],
    questions: known.questions ?? [],
    status,
  };
}
