import { afterEach, describe, expect, test, vi } from "vitest";
import { nextOf, problemOf, ServiceError, service } from "./client";

const answers = (body: string, init: ResponseInit) =>
  vi.stubGlobal(
    "fetch",
    vi.fn(async () => new Response(body, init)),
  );

afterEach(() => vi.unstubAllGlobals());

describe("what goes wrong", () => {
  test("keeps the service's own words, the mend and the entities", async () => {
    answers(
      JSON.stringify({
        title: "The job cannot be made",
        status: 409,
        detail: "LWPOLYLINE 2F4 on layer CREASE has no azimuth.",
        mend: "Join its vertices.",
        source: ["2F4"],
      }),
      { status: 409 },
    );
    const failure = await service.command("j1", "release").catch((cause: unknown) => cause);
    expect(failure).toBeInstanceOf(ServiceError);
    const { problem, message } = failure as ServiceError;
    expect(message).toBe("LWPOLYLINE 2F4 on layer CREASE has no azimuth.");
    expect(problem.mend).toBe("Join its vertices.");
    expect(problem.source).toEqual(["2F4"]);
    expect(problem.questions).toEqual([]);
  });

  test("carries open questions", async () => {
    const question = { kind: "unit", text: "?", choices: ["mm"], edges: [], layer: "", colour: 0 };
    answers(JSON.stringify({ detail: "1 question", questions: [question] }), { status: 409 });
    await expect(
      service.compile({ drawing: "d", machine: "m", board: "b", copies: 1, corners: null }),
    ).rejects.toMatchObject({ problem: { questions: [question] } });
  });

  test("of a service that does not answer is told as that", async () => {
    vi.stubGlobal(
      "fetch",
      vi.fn(async () => Promise.reject(new TypeError("Failed to fetch"))),
    );
    await expect(service.jobs()).rejects.toMatchObject({
      problem: { status: 0, detail: "knifetip does not answer." },
    });
  });

  test("of a page that was left is not told at all", async () => {
    const left = new DOMException("left", "AbortError");
    vi.stubGlobal(
      "fetch",
      vi.fn(async () => Promise.reject(left)),
    );
    await expect(service.jobs()).rejects.toBe(left);
  });

  test.each(["<html>Bad gateway</html>", "", "null", "[]"])(
    "that is no problem+json (%s) is still one",
    (body) => {
      const problem = problemOf(502, "Bad Gateway", body);
      expect(problem.detail).toBe("knifetip answered 502 Bad Gateway.");
      expect(problem.mend).not.toBe("");
    },
  );
});

test("a name from elsewhere cannot leave its place in the address", async () => {
  answers("{}", { status: 200 });
  await service.drawing("../jobs?x");
  expect(fetch).toHaveBeenCalledWith("/api/drawings/..%2Fjobs%3Fx", expect.anything());
});

describe("a list", () => {
  test("leads on by its Link header", async () => {
    const link = '</api/jobs?state=done&cursor=41&limit=100>; rel="next"';
    answers('[{"id": "a"}]', { status: 200, headers: { Link: link } });
    const { rows, next } = await service.jobs();
    expect(rows.map(({ id }) => id)).toEqual(["a"]);
    expect(next).toBe("/api/jobs?state=done&cursor=41&limit=100");
    await service.jobs(undefined, next ?? "");
    expect(fetch).toHaveBeenLastCalledWith(next, expect.anything());
  });

  test("without one has come to its end", async () => {
    answers("[]", { status: 200 });
    expect(await service.drawings()).toEqual({ rows: [], next: null });
  });

  test.each([null, "", '</api/jobs?cursor=1>; rel="prev"', '<https://else.where/api>; rel="next"'])(
    "is not led astray by %s",
    (link) => expect(nextOf(link)).toBeNull(),
  );
});
