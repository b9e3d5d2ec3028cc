import { afterEach, describe, expect, test, vi } from "vitest";
import { drawingService } from "./drawings";
import { parseProblem, ServiceError } from "./errors";
import { jobService } from "./jobs";
import { nextCursor, revisionOf } from "./restApi";
import { retryAfter } from "./transport";

const answers = (body: string, init: ResponseInit) =>
  vi.stubGlobal(
    "fetch",
    vi.fn(async () => new Response(body, init)),
  );

/** Path and query of a request that was sent. */
const addressOf = (call: number): string => {
  const [request] = vi.mocked(fetch).mock.calls[call] ?? [];
  const { pathname, search } = new URL((request as Request).url);
  return pathname + search;
};

afterEach(() => vi.unstubAllGlobals());

describe("an error", () => {
  test("keeps the text, hint and entities of the server", async () => {
    answers(
      JSON.stringify({
        title: "The job cannot be made",
        status: 409,
        detail: "LWPOLYLINE 2F4 on layer CREASE has no azimuth.",
        hint: "Join its vertices.",
        source: ["2F4"],
      }),
      { status: 409 },
    );
    const failure = await jobService.command("j1", "release").catch((cause: unknown) => cause);
    expect(failure).toBeInstanceOf(ServiceError);
    const { problem, message } = failure as ServiceError;
    expect(message).toBe("LWPOLYLINE 2F4 on layer CREASE has no azimuth.");
    expect(problem.hint).toBe("Join its vertices.");
    expect(problem.source).toEqual(["2F4"]);
    expect(problem.questions).toEqual([]);
  });

  test("carries open questions", async () => {
    const question = { kind: "unit", text: "?", choices: ["mm"], edges: [], layer: "", colour: 0 };
    answers(JSON.stringify({ detail: "1 question", questions: [question] }), { status: 409 });
    await expect(
      jobService.compile({
        drawing: "d",
        revision: 1,
        machine: "m",
        board: "b",
        copies: 1,
        corners: null,
        sheet: null,
        registration: null,
        lift: "clearance",
        feed_factor: 1,
        warp: 0,
        contour_starts: [],
        work_order: [],
        bridges: [],
        cut_depths: [],
        crease_depths: [],
        edge_tools: [],
        edge_corners: [],
        contour_leads: [],
        edge_feeds: [],
        program_note: "",
        external_id: "PO-1",
        customer: "",
        due: null,
        notes: "",
        metadata: {},
      }),
    ).rejects.toMatchObject({ problem: { questions: [question] } });
  });

  test("reports a server that does not answer", async () => {
    vi.stubGlobal(
      "fetch",
      vi.fn(async () => Promise.reject(new TypeError("Failed to fetch"))),
    );
    await expect(jobService.jobs()).rejects.toMatchObject({
      problem: { status: 0, detail: "The knifetip server does not respond." },
    });
  });

  test("passes on an aborted request", async () => {
    const left = new DOMException("left", "AbortError");
    vi.stubGlobal(
      "fetch",
      vi.fn(async () => Promise.reject(left)),
    );
    await expect(jobService.jobs()).rejects.toBe(left);
  });

  test.each(["<html>Bad gateway</html>", "", "null", "[]"])(
    "without problem+json (%s) becomes a problem",
    (body) => {
      const problem = parseProblem(502, "Bad Gateway", body);
      expect(problem.detail).toBe("The knifetip server answered with error 502 (Bad Gateway).");
      expect(problem.hint).not.toBe("");
    },
  );
});

test("a name is escaped in the path", async () => {
  answers("{}", { status: 200 });
  await drawingService.drawing("../jobs?x");
  expect(addressOf(0)).toBe("/api/v1/drawings/..%2Fjobs%3Fx");
});

describe("a list", () => {
  test("takes the next page from its Link header", async () => {
    const link = '</api/v1/jobs?state=done&cursor=41&limit=100>; rel="next"';
    answers('[{"id": "a"}]', { status: 200, headers: { Link: link } });
    const { rows, next } = await jobService.jobs();
    expect(rows.map(({ id }) => id)).toEqual(["a"]);
    expect(next).toBe(41);
    await jobService.jobs(undefined, next);
    expect(addressOf(1)).toBe("/api/v1/jobs?cursor=41");
  });

  test("without a Link header is complete", async () => {
    answers("[]", { status: 200 });
    expect(await jobService.orders({})).toEqual({ rows: [], next: null });
  });

  test.each([
    null,
    "",
    '</api/v1/jobs?cursor=1>; rel="prev"',
    '<https://else.where/api>; rel="next"',
  ])("ignores the Link header %s", (link) => expect(nextCursor(link)).toBeNull());
});

describe("a request", () => {
  afterEach(() => {
    vi.useRealTimers();
    vi.unstubAllGlobals();
  });

  test("contains the header of the page and the revision", async () => {
    const asked = vi.fn(async () => new Response("{}"));
    vi.stubGlobal("fetch", asked);
    await drawingService.override("d", [], 7);
    await drawingService.patchDrawing("d", {}, null);
    await jobService.command("j", "release");
    const headers = asked.mock.calls.map((call) => ((call as unknown[])[0] as Request).headers);
    expect(headers.map((one) => one.get("X-Knifetip"))).toEqual(["page", "page", "page"]);
    expect(headers.map((one) => one.get("Accept-Language"))).toEqual(["en", "en", "en"]);
    expect(headers.map((one) => one.get("If-Match"))).toEqual(['"7"', null, null]);
    expect(headers.map((one) => one.get("Content-Type"))).toEqual([
      "application/json",
      "application/json",
      null,
    ]);
  });

  test("is repeated after the time that a busy server names", async () => {
    vi.useFakeTimers();
    const busy = { status: 503, headers: { "Retry-After": "3" } };
    const asked = vi
      .fn()
      .mockResolvedValueOnce(new Response("{}", busy))
      .mockResolvedValueOnce(new Response("{}", { ...busy, status: 429 }))
      .mockResolvedValue(new Response('{"id":"j"}'));
    vi.stubGlobal("fetch", asked);
    const answer = jobService.command("j", "release");
    await vi.advanceTimersByTimeAsync(2900);
    expect(asked).toHaveBeenCalledTimes(1);
    await vi.advanceTimersByTimeAsync(8000);
    expect(asked).toHaveBeenCalledTimes(3);
    await expect(answer).resolves.toEqual({ id: "j" });
  });

  test("is given up after six attempts, and at once without Retry-After", async () => {
    expect(retryAfter(503, "1", 1)).toBeGreaterThanOrEqual(1);
    expect(retryAfter(503, "999", 1)).toBeLessThanOrEqual(40);
    expect(retryAfter(503, "1", 6)).toBeNull();
    expect(retryAfter(503, null, 1)).toBeNull();
    expect(retryAfter(500, "1", 1)).toBeNull();
    vi.stubGlobal("fetch", async () => new Response("{}", { status: 503 }));
    await expect(jobService.command("j", "hold")).rejects.toMatchObject({
      problem: { status: 503 },
    });
  });

  test("without a session reloads the page to sign in", async () => {
    const reload = vi.fn();
    vi.stubGlobal("location", { reload });
    vi.stubGlobal("fetch", async () => new Response("{}", { status: 401 }));
    await expect(jobService.jobs()).rejects.toMatchObject({ problem: { status: 401 } });
    expect(reload).toHaveBeenCalledOnce();
  });

  test.each([
    ['"12"', 12],
    ['W/"12"', 12],
    ['"12-changed"', 12],
    ['"x"', null],
    [null, null],
  ])("is answered with the revision in its ETag: %s", (etag, revision) => {
    expect(revisionOf(etag)).toBe(revision);
  });
});
