/** Number types for lengths and angles, which the compiler distinguishes from other numbers. */

declare const unit: unique symbol;

export type Millimetre = number & { readonly [unit]: "mm" };
export type Degree = number & { readonly [unit]: "degree" };

export const mm = (value: number): Millimetre => value as Millimetre;
export const degree = (value: number): Degree => value as Degree;

export const radians = (angle: Degree): number => (angle * Math.PI) / 180;
