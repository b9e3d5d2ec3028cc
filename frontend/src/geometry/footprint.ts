/** Shape of the area that a tool removes or presses, and position of its tip, from the server. */

export interface Footprint {
  /** A line has no width; a disc has `radius`, a groove `slope`, a wheel `radius` and `width`. */
  readonly shape: "line" | "disc" | "groove" | "wheel";
  /** radius of the disc or wheel (mm) */
  readonly radius: number;
  /** width of the wheel's rim (mm) */
  readonly width: number;
  /** width of a groove's side per depth (mm/mm) */
  readonly slope: number;
  /** length of the cutting edge along C (mm) */
  readonly blade: number;
  /** distance of the tip from the axis of the head, to the left of C (mm) */
  readonly left: number;
  /** distance of the tip behind the axis of the head, along C (mm) */
  readonly behind: number;
  /** Whether the tool cuts at any height, like a laser beam. */
  readonly any_height: boolean;
}
