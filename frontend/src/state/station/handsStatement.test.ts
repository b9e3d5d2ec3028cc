import { afterEach, beforeEach, expect, test, vi } from "vitest";
import { ServiceError } from "../../api/errors";
import { machineService } from "../../api/machines";
import { handsReason, stateHandsClear, withdrawHandsClear } from "./handsClear";
import { endWithMotion, useHandsStatement } from "./handsStatement";
import { useOutcomes } from "./operations";

beforeEach(() => useHandsStatement.getState().make("table", 60_000));

afterEach(() => vi.restoreAllMocks());

test("the statement is made on the server first", async () => {
  useHandsStatement.getState().end();
  vi.spyOn(Date, "now").mockReturnValue(1000);
  vi.spyOn(machineService, "stateHandsClear").mockResolvedValue({ until: "", seconds: 60 });
  const stated = stateHandsClear("table");
  expect(useHandsStatement.getState().until).toBe(0);
  await stated;
  expect(useHandsStatement.getState()).toMatchObject({ machine: "table", until: 61_000 });
});

test("the statement is taken back on the page at once, and on the server", async () => {
  const withdrawn = vi.spyOn(machineService, "withdrawHandsClear").mockResolvedValue();
  const done = withdrawHandsClear("table");
  expect(useHandsStatement.getState().until).toBe(0);
  await done;
  expect(withdrawn.mock.calls).toEqual([["table"]]);
});

test("a statement that the server cannot take back is told, and no longer counts here", async () => {
  const problem = { code: "stored.text", arguments: { text: "No server.", hint: "" }, status: 503 };
  vi.spyOn(machineService, "withdrawHandsClear").mockRejectedValue(
    new ServiceError(problem as never),
  );
  await withdrawHandsClear("table");
  expect(useHandsStatement.getState().until).toBe(0);
  expect(useOutcomes.getState().last?.text).toBe("No server.");
});

test.each(["home", "jog", "park", "dry_run", "frame", "tool_check", "resume"])(
  "the statement ends with the motion that it permits: %s",
  (operation) => {
    endWithMotion(operation);
    expect(useHandsStatement.getState()).toMatchObject({ machine: "", until: 0 });
  },
);

test.each(["zero", "switch", "spindle", "unlock", "stop_jog", "lift", "hold"])(
  "the statement lasts where nothing travels: %s",
  (operation) => {
    endWithMotion(operation);
    expect(useHandsStatement.getState().until).toBe(60_000);
  },
);

test("what moves by itself waits for the statement, and what stops does not", () => {
  const nobody = { left: 0, toggle: () => {} };
  for (const operation of ["frame", "dry_run", "tool_check", "home", "zero", "park"] as const) {
    expect(handsReason(operation, nobody)).toContain("hands are clear");
    expect(handsReason(operation, { ...nobody, left: 12 })).toBeNull();
  }
  for (const operation of ["stop_jog", "lift", "hold", "unlock", "jog"] as const) {
    expect(handsReason(operation, nobody)).toBeNull();
  }
});
