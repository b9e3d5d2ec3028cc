import { beforeEach, expect, test } from "vitest";
import { handsReason } from "./handsClear";
import { endWithMotion, useHandsStatement } from "./handsStatement";

beforeEach(() => useHandsStatement.getState().make("table", 60_000));

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
