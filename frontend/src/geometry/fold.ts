/**
 * Transforms of panels that turn about their folds, as the server computes them: the transform of a
 * panel is that of its parent times a turn about the axis of their fold.
 */

/** A 4 × 4 matrix, row by row. */
export type Matrix = readonly number[];
type Place = readonly number[];

export interface Hinge {
  readonly number: number;
  readonly parent: number;
  readonly child: number;
  /** Start and end in the flat board (mm), with the child on the left. */
  readonly axis: readonly (readonly number[])[];
}

export const IDENTITY: Matrix = [1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1];

export function multiply(a: Matrix, b: Matrix): Matrix {
  const product: number[] = [];
  for (let row = 0; row < 4; row++)
    for (let column = 0; column < 4; column++) {
      let sum = 0;
      for (let k = 0; k < 4; k++) sum += at(a, 4 * row + k) * at(b, 4 * k + column);
      product.push(sum);
    }
  return product;
}

/** The turn about an axis by an angle (degrees), by the formula of Rodrigues. */
export function turnAbout(start: Place, end: Place, degrees: number): Matrix {
  const way = [0, 1, 2].map((k) => at(end, k) - at(start, k));
  const length = Math.hypot(...way);
  const [x = 0, y = 0, z = 0] = way.map((one) => one / length);
  const c = Math.cos((degrees * Math.PI) / 180);
  const s = Math.sin((degrees * Math.PI) / 180);
  const d = 1 - c;
  const rows = [
    [c + d * x * x, d * x * y - s * z, d * x * z + s * y],
    [d * y * x + s * z, c + d * y * y, d * y * z - s * x],
    [d * z * x - s * y, d * z * y + s * x, c + d * z * z],
  ];
  const placed = rows.flatMap((row, k) => [
    ...row,
    at(start, k) - row.reduce((sum, value, column) => sum + value * at(start, column), 0),
  ]);
  return [...placed, 0, 0, 0, 1];
}

/**
 * The transform of each panel, by its index.
 *
 * `order` has the numbers of the folds that turn a panel, parents first; `angleOf` returns the angle
 * of a fold (degrees).
 */
export function panelTransforms(
  panels: number,
  folds: readonly Hinge[],
  order: readonly number[],
  angleOf: (fold: number) => number,
): Matrix[] {
  const placed: Matrix[] = Array.from({ length: panels }, () => IDENTITY);
  for (const number of order) {
    const fold = folds[number - 1];
    const [start, end] = fold?.axis ?? [];
    if (fold === undefined || start === undefined || end === undefined) continue;
    const parent = placed[fold.parent - 1] ?? IDENTITY;
    placed[fold.child - 1] = multiply(parent, turnAbout(start, end, angleOf(number)));
  }
  return placed;
}

const at = (values: Place, k: number): number => values[k] ?? 0;
