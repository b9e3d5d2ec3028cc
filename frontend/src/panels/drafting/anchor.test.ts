import { expect, test } from "vitest";
import { anchorAt } from "./anchor";

test("a pan by whole pixels changes the transform only", () => {
  const shapes = [0, 1, 7, 40].map((pan) => {
    const [from, to] = [
      { x: 10.1 + pan, y: 20.7 - 2 * pan },
      { x: 310.4 + pan, y: 20.7 - 2 * pan },
    ];
    const { transform, local } = anchorAt(from);
    return { transform, local: [local(from), local(to)] };
  });
  expect(shapes[2]?.transform).toBe("translate(17px, 7px)");
  for (const { local } of shapes)
    expect(local).toEqual([
      { x: 0.1, y: -0.3 },
      { x: 300.4, y: -0.3 },
    ]);
});
