/** Buttons that show and hide the layers of the canvas. */

import { translate } from "../../language/translate";
import { LINE_STYLES, MARKS, SWEPT, TRAVEL, translucent, UNCUT } from "../../state/drawing/palette";
import { useToolpath, useVerdictColumns } from "../../state/queries";
import { type Layer, useUiStore } from "../../state/store";
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
  {
    layer: "nominal",
    title: translate("viewBar.drawing"),
    shows: translate("viewBar.theEdgesOfTheDrawing"),
    colour: LINE_STYLES.cut.colour,
  },
  {
    layer: "head",
    title: translate("viewBar.headPath"),
    shows: translate("viewBar.thePathOfTheMachine"),
    colour: TRAVEL.head,
  },
  {
    layer: "tip",
    title: translate("viewBar.pathOfToolTip"),
    shows: translate("viewBar.thePathOfTheTool"),
    colour: TRAVEL.tip,
  },
  {
    layer: "rapids",
    title: translate("viewBar.movesAboveBoard"),
    shows: translate("viewBar.theMovesOfTheMachine"),
    colour: TRAVEL.rapid,
    dashed: true,
  },
  {
    layer: "swept",
    title: translate("viewBar.toolWidth"),
    shows: translate("viewBar.theAreaThatTheTools"),
    colour: translucent(SWEPT.groove, 60),
    thick: true,
  },
  {
    layer: "moves",
    title: translate("viewBar.plungesAndLifts"),
    shows: translate("viewBar.thePointsWhereATool"),
    colour: MARKS.plunge,
    dot: true,
  },
  {
    layer: "uncut",
    title: translate("viewBar.unreachableAreas"),
    shows: translate("viewBar.areasThatTheToolCannot"),
    colour: translucent(UNCUT, 67),
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
      aria-label={translate("viewBar.chooseWhatTheViewShows")}
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
                  ? translate("viewBar.prepareTheProgramFirstRight")
                  : translate("viewBar.showOrHide", { shows })
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
