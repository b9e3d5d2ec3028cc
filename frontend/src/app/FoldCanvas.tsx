/** The canvas of the folded board: orbits by mouse, touch and arrow keys. */

import { type KeyboardEvent, useEffect, useRef, useState } from "react";
import type { Folding } from "../api/folding";
import { panelTransforms } from "../geometry/fold";
import { translate } from "../language/translate";
import css from "../panels/fold/fold.module.css";
import { faultyPanels } from "../state/fold/folding";
import { FoldViewer } from "../viewer/fold/foldViewer";
import { WebGlError } from "./WebGlError";

const COLOURS = {
  outside: "#e4ddd0",
  inside: "#c19a6b",
  edge: "#8a623a",
  line: "#4a3521",
  bad: "#e5343a",
  chosen: "#2f84fb",
};
/** What the keys turn (radians) and zoom. */
const STEP = 0.12;
const ZOOM = 1.15;

interface Props {
  readonly folding: Folding;
  readonly fraction: number;
  readonly outsideUp: boolean;
  readonly angleOf: (fold: number) => number;
  /** Indices of the chosen panels. */
  readonly chosen: ReadonlySet<number>;
  onPick(panel: number | null): void;
  onViewer(viewer: FoldViewer | null): void;
}

export function FoldCanvas(props: Props) {
  const { folding, fraction, outsideUp, angleOf, chosen } = props;
  const host = useRef<HTMLDivElement>(null);
  const canvas = useRef<HTMLCanvasElement>(null);
  const latest = useRef(props);
  latest.current = props;
  const [viewer, setViewer] = useState<FoldViewer | null>(null);
  const [failure, setFailure] = useState<string | null>(null);

  useEffect(() => {
    if (host.current === null || canvas.current === null) return;
    let created: FoldViewer;
    try {
      created = new FoldViewer(host.current, canvas.current, COLOURS, (panel) =>
        latest.current.onPick(panel),
      );
    } catch (cause) {
      setFailure(cause instanceof Error ? cause.message : String(cause));
      return;
    }
    setViewer(created);
    latest.current.onViewer(created);
    return () => {
      created.dispose();
      setViewer(null);
      latest.current.onViewer(null);
    };
  }, []);

  const fitted = useRef(false);
  useEffect(() => {
    viewer?.show(folding.panels, folding.caliper, outsideUp);
  }, [viewer, folding, outsideUp]);
  useEffect(() => {
    const turned = (fold: number) => angleOf(fold) * fraction;
    viewer?.place(panelTransforms(folding.panels.length, folding.folds, folding.order, turned));
    if (viewer !== null && !fitted.current) {
      fitted.current = true;
      viewer.fit();
    }
  }, [viewer, folding, fraction, angleOf]);
  useEffect(() => viewer?.mark(faultyPanels(folding), chosen), [viewer, folding, chosen]);

  const onKeyDown = (event: KeyboardEvent) => {
    const turn = TURNS[event.key];
    if (turn !== undefined) viewer?.orbit(...turn);
    else if (event.key === "+" || event.key === "-")
      viewer?.zoom(event.key === "+" ? 1 / ZOOM : ZOOM);
    else if (event.key === "0") viewer?.fit();
    else return;
    event.preventDefault();
  };

  if (failure !== null) return <WebGlError why={failure} />;
  return (
    <div
      ref={host}
      className={css.view}
      data-testid="fold-view"
      // biome-ignore lint/a11y/noNoninteractiveTabindex: the arrow keys turn it
      tabIndex={0}
      role="img"
      aria-label={translate("foldCanvas.foldedBoard", { panels: folding.panels.length })}
      onKeyDown={onKeyDown}
    >
      <canvas ref={canvas} />
    </div>
  );
}

const TURNS: Readonly<Record<string, [number, number]>> = {
  ArrowLeft: [-STEP, 0],
  ArrowRight: [STEP, 0],
  ArrowUp: [0, STEP],
  ArrowDown: [0, -STEP],
};
