import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { pageProblem } from "../../api/errors";
import { type Job, jobService } from "../../api/jobs";
import { machineService } from "../../api/machines";
import { upsertJob } from "../cacheUpdates";
import { queries, queryClient } from "../queries";
import { commandJob, isCarriedOut, operate, useOutcomes } from "./operations";

const last = () => useOutcomes.getState().last;
const job = (part: Partial<Job>): Job =>
  ({
    id: "j",
    machine: "t",
    state: "running",
    actions: [],
    waiting_for: "",
    updated: "2030-01-01T00:00:01.000Z",
    ...part,
  }) as Job;

beforeEach(() => {
  vi.useFakeTimers();
});
afterEach(() => {
  vi.useRealTimers();
  vi.restoreAllMocks();
  queryClient.clear();
});

test("an operation is taken, then done", async () => {
  vi.spyOn(machineService, "operate").mockResolvedValue({
    id: "o",
    state: "waiting",
    message: null,
  });
  vi.spyOn(machineService, "operation")
    .mockResolvedValueOnce({ id: "o", state: "waiting", message: null })
    .mockResolvedValue({ id: "o", state: "done", message: null });
  const result = operate("t", "Home", { operation: "home" });
  expect(last()?.state).toBe("asked");
  await vi.advanceTimersByTimeAsync(1);
  expect(last()?.state).toBe("taken");
  await vi.advanceTimersByTimeAsync(1000);
  expect((await result).state).toBe("done");
  expect(last()).toMatchObject({ label: "Home", state: "done" });
});

test("a refusal shows its reason and what to do", async () => {
  vi.spyOn(machineService, "operate").mockRejectedValue(
    pageProblem(409, "Wrong state", "A job runs.", "Wait until it has ended."),
  );
  await operate("t", "Park", { operation: "park" });
  expect(last()).toEqual({
    label: "Park",
    state: "refused",
    text: "A job runs.",
    hint: "Wait until it has ended.",
  });
});

test("an expired operation is shown as such", async () => {
  vi.spyOn(machineService, "operate").mockResolvedValue({
    id: "o",
    state: "waiting",
    message: null,
  });
  vi.spyOn(machineService, "operation").mockResolvedValue({
    id: "o",
    state: "expired",
    message: null,
  });
  const result = operate("t", "Home", { operation: "home" });
  await vi.advanceTimersByTimeAsync(1000);
  expect((await result).state).toBe("expired");
});

test("an older action does not replace the report of a newer one", async () => {
  let refuse = (_: unknown) => {};
  vi.spyOn(machineService, "operate").mockImplementationOnce(
    () =>
      new Promise((_, reject) => {
        refuse = reject;
      }),
  );
  const slow = operate("t", "Park", { operation: "park" });
  vi.spyOn(machineService, "operate").mockResolvedValue({ id: "o", state: "done", message: null });
  await operate("t", "Stop", { operation: "stop_jog" });
  refuse(pageProblem(409, "", "late", ""));
  await slow;
  expect(last()).toMatchObject({ label: "Stop", state: "done" });
});

test("a stop that the machine does not execute points to the emergency stop", async () => {
  const asked = job({ requested_action: "cancel" });
  queryClient.setQueryData(queries.job("j").queryKey, asked);
  vi.spyOn(jobService, "command").mockResolvedValue(asked);
  const result = commandJob("j", "Stop", "cancel");
  await vi.advanceTimersByTimeAsync(2000);
  expect(last()).toMatchObject({ state: "taken", text: "" });
  await vi.advanceTimersByTimeAsync(2000);
  expect(last()?.hint).toContain("emergency stop");
  upsertJob(job({ state: "cancelled", requested_action: "", updated: "2030-01-01T00:00:02.000Z" }));
  await vi.advanceTimersByTimeAsync(500);
  await result;
  expect(last()?.state).toBe("done");
});

test("a job is resumed in the phase that the person has seen", async () => {
  queryClient.setQueryData(queries.job("j").queryKey, job({ state: "held", phase: 3 }));
  const resume = vi
    .spyOn(jobService, "goOnNow")
    .mockResolvedValue(job({ updated: "2030-01-01T00:00:02.000Z" }));
  const result = commandJob("j", "Resume", "resume");
  // What is reported after the press does not count.
  upsertJob(job({ state: "held", phase: 4, updated: "2030-01-01T00:00:03.000Z" }));
  await vi.advanceTimersByTimeAsync(100);
  expect(resume).toHaveBeenCalledWith("j", "resume", 3);
  upsertJob(job({ state: "running", requested_action: "", updated: "2030-01-01T00:00:04.000Z" }));
  await vi.advanceTimersByTimeAsync(500);
  await result;
});

test("a command is executed when the job has changed, not when it was taken", () => {
  expect(isCarriedOut("hold", job({ requested_action: "hold" }))).toBe(false);
  expect(isCarriedOut("hold", job({ state: "held", requested_action: "" }))).toBe(true);
  expect(isCarriedOut("confirm", job({ state: "queued", requested_action: "" }))).toBe(false);
  expect(isCarriedOut("resume", job({ state: "held", requested_action: "" }))).toBe(false);
});
