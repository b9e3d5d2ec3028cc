/**
 * Translates mouse, pen and touch input to pan, zoom, hover and select.
 *
 *     drag, middle or right drag   pan         wheel, pinch    zoom about the cursor
 *     click                        select      shift + drag    select with a box
 *     drag with an area tool       select      alt + drag      select with a lasso
 */

import type { Point } from "../geometry/records";
import { clickMode, type SelectMode } from "../geometry/selection";
import { type AreaTool, areaOfDrag, extendedArea } from "./areaSelection";

export interface PointerTarget {
  pan(dx: number, dy: number): void;
  zoom(factor: number, about: Point): void;
  hover(at: Point | null): void;
  select(at: Point, mode: SelectMode): void;
  /** The tool that a drag draws an area with; null if it moves the view. */
  areaTool(): AreaTool | null;
  /** Called while an area is drawn, and with a mode when it is finished. */
  area(corners: readonly Point[], mode: SelectMode | null): void;
  /** Called if a second finger or the system ends the drawing of an area. */
  areaCancelled(): void;
}

/** Maximum movement of a click (pixels). */
const CLICK_RADIUS = 4;
const LINE_HEIGHT = 16;

export function listenToPointer(element: HTMLElement, target: PointerTarget): () => void {
  const held = new Map<number, Point>();
  let pressed: { at: Point; area: AreaTool | null; button: number; moved: boolean } | null = null;
  let corners: readonly Point[] = [];
  const gone = new AbortController();
  const on = <K extends keyof HTMLElementEventMap>(
    name: K,
    act: (event: HTMLElementEventMap[K]) => void,
    passive = true,
  ) => element.addEventListener(name, act, { signal: gone.signal, passive });

  const place = (event: MouseEvent): Point => {
    const frame = element.getBoundingClientRect();
    return { x: event.clientX - frame.left, y: event.clientY - frame.top };
  };

  const spread = (): { middle: Point; apart: number } => {
    const [a, b] = [...held.values()];
    if (a === undefined || b === undefined) return { middle: { x: 0, y: 0 }, apart: 0 };
    return {
      middle: { x: (a.x + b.x) / 2, y: (a.y + b.y) / 2 },
      apart: Math.hypot(a.x - b.x, a.y - b.y),
    };
  };

  on("pointerdown", (event) => {
    element.setPointerCapture(event.pointerId);
    held.set(event.pointerId, place(event));
    if (pressed?.area != null) target.areaCancelled();
    const area =
      event.button === 0 && held.size === 1 ? areaOfDrag(target.areaTool(), event) : null;
    pressed = { at: place(event), area, button: event.button, moved: false };
    corners = [pressed.at];
    element.focus({ preventScroll: true });
  });

  on("pointermove", (event) => {
    const now = place(event);
    const before = held.get(event.pointerId);
    if (before === undefined || pressed === null) {
      if (event.pointerType !== "touch") target.hover(now);
      return;
    }
    if (held.size === 2) {
      const old = spread();
      held.set(event.pointerId, now);
      const next = spread();
      target.pan(next.middle.x - old.middle.x, next.middle.y - old.middle.y);
      if (old.apart > 0) target.zoom(next.apart / old.apart, next.middle);
      pressed.moved = true;
      return;
    }
    if (!pressed.moved && Math.hypot(now.x - pressed.at.x, now.y - pressed.at.y) < CLICK_RADIUS)
      return;
    if (!pressed.moved) target.hover(null);
    const from = pressed.moved ? before : pressed.at;
    pressed.moved = true;
    held.set(event.pointerId, now);
    if (pressed.area !== null) {
      corners = extendedArea(pressed.area.kind, corners, now);
      target.area(corners, null);
    } else target.pan(now.x - from.x, now.y - from.y);
  });

  const release = (event: PointerEvent, finished: boolean) => {
    if (!held.delete(event.pointerId) || pressed === null || held.size > 0) return;
    const now = place(event);
    if (pressed.moved && pressed.area !== null) {
      if (finished) target.area(corners, pressed.area.mode);
      else target.areaCancelled();
    } else if (!pressed.moved && pressed.button === 0 && finished) {
      target.select(now, clickMode(event));
    }
    pressed = null;
  };
  on("pointerup", (event) => release(event, true));
  on("pointercancel", (event) => release(event, false));
  on("pointerleave", () => {
    if (held.size === 0) target.hover(null);
  });
  on("contextmenu", (event) => event.preventDefault(), false);
  on(
    "wheel",
    (event) => {
      event.preventDefault();
      const turned = event.deltaMode === WheelEvent.DOM_DELTA_LINE ? LINE_HEIGHT : 1;
      // A pinch on a touch pad is sent as wheel events with Ctrl, in small steps.
      const gain = event.ctrlKey ? 0.01 : 0.0016;
      target.zoom(Math.exp(-event.deltaY * turned * gain), place(event));
    },
    false,
  );
  return () => gone.abort();
}
