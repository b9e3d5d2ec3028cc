/** What a tool takes of the board, or presses, and where its tip lies, as the server sends it. */

export interface Footprint {
  /** line: no wider than the line; disc: `radius`; groove: `slope`; wheel: `radius`, `width` */
  readonly shape: "line" | "disc" | "groove" | "wheel";
  /** mm */
  readonly radius: number;
  /** mm */
  readonly width: number;
  /** mm sideways per mm of depth */
  readonly slope: number;
  /** mm, length of the cutting edge along C */
  readonly blade: number;
  /** mm from the axis of the head to the tip, to the left of C */
  readonly left: number;
  /** mm from the axis of the head back to the tip, along C */
  readonly behind: number;
  /** The tool works at any height, as a beam does. */
  readonly any_height: boolean;
}
