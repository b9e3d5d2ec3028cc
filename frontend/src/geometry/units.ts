/**
 * Lengths and angles that the compiler can tell apart from counts and pixels.
 *
 * A plain number does not become a length by accident: it is called one, once, where it enters.
 */

declare const unit: unique symbol;

export type Millimetre = number & { readonly [unit]: "mm" };
export type Degree = number & { readonly [unit]: "degree" };

export const mm = (value: number): Millimetre => value as Millimetre;
export const degree = (value: number): Degree => value as Degree;

export const radians = (angle: Degree): number => (angle * Math.PI) / 180;
