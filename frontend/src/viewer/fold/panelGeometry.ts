/** The geometry of a panel: a solid between its rings in the bottom and the top face. */

import { BufferGeometry, Float32BufferAttribute, ShapeUtils, Vector2 } from "three";

type Ring = readonly (readonly number[])[];

export interface PanelRings {
  /** Outline, then holes; both faces have the same corners in the same order (mm). */
  readonly bottom: readonly Ring[];
  readonly top: readonly Ring[];
}

/** Index of the material of each group of the geometry. */
export const FACES = { bottom: 0, top: 1, edge: 2 } as const;

/** Triangles without shared corners, so that each has its own normal. */
export function panelGeometry(panel: PanelRings, caliper: number): BufferGeometry {
  const points: number[] = [];
  const geometry = new BufferGeometry();
  const group = (face: number, add: () => void) => {
    const first = points.length / 3;
    add();
    geometry.addGroup(first, points.length / 3 - first, face);
  };
  group(FACES.bottom, () => addFace(points, panel.bottom, 0, true));
  group(FACES.top, () => addFace(points, panel.top, caliper, false));
  group(FACES.edge, () => {
    panel.bottom.forEach((ring, k) => {
      addWalls(points, ring, panel.top[k] ?? ring, caliper);
    });
  });
  geometry.setAttribute("position", new Float32BufferAttribute(points, 3));
  geometry.computeVertexNormals();
  return geometry;
}

function addFace(points: number[], rings: readonly Ring[], z: number, reversed: boolean): void {
  const [outline = [], ...holes] = rings.map((ring) =>
    ring.map(([x, y]) => new Vector2(x ?? 0, y ?? 0)),
  );
  const corners = [outline, ...holes].flat();
  for (const triangle of ShapeUtils.triangulateShape(outline, holes)) {
    for (const k of reversed ? [...triangle].reverse() : triangle) {
      const corner = corners[k];
      if (corner !== undefined) points.push(corner.x, corner.y, z);
    }
  }
}

function addWalls(points: number[], bottom: Ring, top: Ring, caliper: number): void {
  bottom.forEach((low, k) => {
    const next = (k + 1) % bottom.length;
    const corner = (ring: Ring, at: number, z: number) => [
      ring[at]?.[0] ?? 0,
      ring[at]?.[1] ?? 0,
      z,
    ];
    const from = [low[0] ?? 0, low[1] ?? 0, 0];
    const over = corner(top, next, caliper);
    points.push(...from, ...corner(bottom, next, 0), ...over);
    points.push(...from, ...over, ...corner(top, k, caliper));
  });
}
