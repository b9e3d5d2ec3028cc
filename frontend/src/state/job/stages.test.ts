import { expect, test } from "vitest";
import { SHOWN_STAGES, stageProgress } from "./stages";

test("a job that waits for the server has not begun its first stage", () => {
  expect(stageProgress("prepare")).toEqual({
    title: "Waiting for the server to finish its first start",
    index: -1,
  });
});

test("each stage of a compile is a step further than the one before", () => {
  const indices = ["", ...SHOWN_STAGES, "done"].map(
    (stage) => stageProgress(stage as (typeof SHOWN_STAGES)[number]).index,
  );
  expect(indices).toEqual([-1, 0, 1, 2, 3, 4, 5, 6, 7]);
});
