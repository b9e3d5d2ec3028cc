import { expect, test } from "vitest";
import { FACES, panelGeometry } from "./panelGeometry";

const SQUARE = [
  [0, 0],
  [10, 0],
  [10, 10],
  [0, 10],
];
const HOLE = [
  [4, 4],
  [4, 6],
  [6, 6],
  [6, 4],
];

/** Volume by the divergence theorem: right only if all triangles face outwards. */
function volumeOf(points: ArrayLike<number>): number {
  let volume = 0;
  for (let k = 0; k < points.length; k += 9) {
    const [ax, ay, az, bx, by, bz, cx, cy, cz] = Array.from(
      { length: 9 },
      (_, i) => points[k + i],
    ) as [number, number, number, number, number, number, number, number, number];
    volume += ax * (by * cz - bz * cy) + ay * (bz * cx - bx * cz) + az * (bx * cy - by * cx);
  }
  return volume / 6;
}

test("a panel with a hole is a closed solid of the thickness of the board", () => {
  const rings = [SQUARE, HOLE];
  const geometry = panelGeometry({ bottom: rings, top: rings }, 2);
  const { array } = geometry.getAttribute("position");
  expect(volumeOf(array)).toBeCloseTo((100 - 4) * 2, 4);
  expect(geometry.groups.map(({ materialIndex }) => materialIndex)).toEqual(Object.values(FACES));
});
