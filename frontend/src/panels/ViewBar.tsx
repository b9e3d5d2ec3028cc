/** Buttons that show and hide the layers of the canvas. */

import { MARKS, SWEPT, TRAVEL, UNCUT } from "../state/palette";
import { useToolpath, useVerdictColumns } from "../state/queries";
import { type Layer, useUiStore } from "../state/store";
import css from "./over.module.css";

const LAYERS: readonly {
  layer: Layer;
  title: string;
  colour: string;
  dashed?: true;
  thick?: true;
  dot?: true;
}[] = [
  { layer: "nominal", title: "Drawing", colour: "#ff6b61" },
  { layer: "head", title: "Head path", colour: TRAVEL.head },
  { layer: "tip", title: "Tip path", colour: TRAVEL.tip },
  { layer: "rapids", title: "Rapids", colour: "#8b97a6", dashed: true },
  { layer: "swept", title: "Swept area", colour: `${SWEPT.groove}99`, thick: true },
  { layer: "moves", title: "Plunges", colour: MARKS.plunge, dot: true },
  { layer: "uncut", title: "Uncut", colour: `${UNCUT}aa`, thick: true },
];

export function ViewBar() {
  const layers = useUiStore((ui) => ui.layers);
  const toggle = useUiStore((ui) => ui.toggleLayer);
  const { data: toolpath } = useToolpath();
  const { data: along } = useVerdictColumns();
  // Without unreachable areas the layer has no button.
  const some = (along?.areas.size.length ?? 0) > 0;
  return (
    <div className={`${css.float} ${css.chips}`} role="toolbar" aria-label="Layers shown">
      {LAYERS.filter(({ layer }) => layer !== "uncut" || some).map(
        ({ layer, title, colour, dashed, thick, dot }) => {
          const needsPath = layer !== "nominal";
          return (
            <button
              key={layer}
              type="button"
              className={css.chip}
              aria-pressed={layers[layer] && (!needsPath || toolpath !== undefined)}
              disabled={needsPath && toolpath === undefined}
              title={needsPath && toolpath === undefined ? "Compile first" : undefined}
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
