/** Buttons that show and hide the layers of the canvas. */

import { MARKS, SWEPT, TRAVEL, UNCUT } from "../state/palette";
import { useToolpath, useVerdictColumns } from "../state/queries";
import { type Layer, useUiStore } from "../state/store";
import css from "./overlay.module.css";

const LAYERS: readonly {
  layer: Layer;
  title: string;
  /** What the layer shows. */
  shows: string;
  colour: string;
  dashed?: true;
  thick?: true;
  dot?: true;
}[] = [
  { layer: "nominal", title: "Drawing", shows: "the edges of the drawing", colour: "#ff6b61" },
  { layer: "head", title: "Head path", shows: "the path of the machine head", colour: TRAVEL.head },
  {
    layer: "tip",
    title: "Path of tool tip",
    shows: "the path of the tool tip",
    colour: TRAVEL.tip,
  },
  {
    layer: "rapids",
    title: "Moves above board",
    shows: "the moves of the machine head above the board",
    colour: "#8b97a6",
    dashed: true,
  },
  {
    layer: "swept",
    title: "Tool width",
    shows: "the area that the tools cut or press",
    colour: `${SWEPT.groove}99`,
    thick: true,
  },
  {
    layer: "moves",
    title: "Plunges and lifts",
    shows: "the points where a tool enters the board, turns on the spot or leaves the board",
    colour: MARKS.plunge,
    dot: true,
  },
  {
    layer: "uncut",
    title: "Unreachable areas",
    shows: "areas that the tool cannot reach",
    colour: `${UNCUT}aa`,
    thick: true,
  },
];

export function ViewBar() {
  const layers = useUiStore((ui) => ui.layers);
  const toggle = useUiStore((ui) => ui.toggleLayer);
  const { data: toolpath } = useToolpath();
  const { data: columns } = useVerdictColumns();
  // Without unreachable areas the layer has no button.
  const hasUnreachable = (columns?.areas.size.length ?? 0) > 0;
  return (
    <div
      className={`${css.float} ${css.chips}`}
      role="toolbar"
      aria-label="Choose what the view shows"
    >
      {LAYERS.filter(({ layer }) => layer !== "uncut" || hasUnreachable).map(
        ({ layer, title, shows, colour, dashed, thick, dot }) => {
          const needsPath = layer !== "nominal";
          return (
            <button
              key={layer}
              type="button"
              className={css.chip}
              aria-pressed={layers[layer] && (!needsPath || toolpath !== undefined)}
              disabled={needsPath && toolpath === undefined}
              title={
                needsPath && toolpath === undefined
                  ? "Prepare the program first (right panel, New job)"
                  : `Show or hide ${shows}`
              }
              onClick={() => toggle(layer)}
              data-testid={`layer-${layer}`}
            >
              <span
                className={dot ? css.chipDot : css.chipLine}
                style={{
                  color: colour,
                  borderTopStyle: dashed ? "dashed" : "solid",
                  borderTopWidth: thick ? 7 : 2,
                }}
              />
              {title}
            </button>
          );
        },
      )}
    </div>
  );
}
