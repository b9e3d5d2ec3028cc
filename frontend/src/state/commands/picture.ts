/** Commands of the canvas that is on display. */

export interface PictureCommands {
  fit(): void;
  fitTable(): void;
  zoom(factor: number): void;
  pan(dx: number, dy: number): void;
}

let shown: PictureCommands | null = null;

/** Set what the keyboard moves; null while there is no canvas. */
export function setPicture(commands: PictureCommands | null): void {
  shown = commands;
}

export const picture = (): PictureCommands | null => shown;
