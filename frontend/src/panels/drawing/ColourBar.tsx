/** Choice of what the colour of a line shows, and the scale of that figure. */

import { formatNumber } from "../../language/numbers";
import { translate } from "../../language/translate";
import { SCALE } from "../../state/drawing/palette";
import { COLOUR_MODE_TITLES, verdictMapOf } from "../../state/drawing/verdictMap";
import { useEdges, useVerdict } from "../../state/queries";
import { COLOUR_MODES, useUiStore } from "../../state/store";
import { useScheme } from "../shared/scheme";
import css from "./overlay.module.css";

export function ColourBar() {
  const mode = useUiStore((ui) => ui.colourMode);
  const set = useUiStore((ui) => ui.set);
  const { data: edges } = useEdges();
  const { data: verdict } = useVerdict();
  if (verdict === undefined || edges === undefined) return null;
  const map = verdictMapOf(mode, verdict, edges.bulge.length);
  return (
    <div className={`${css.float} ${css.chips}`}>
      <div
        role="toolbar"
        aria-label={translate("colourBar.whatTheColoursOfThe")}
        className={css.modes}
        data-testid="colour-mode"
        data-mode={mode}
      >
        {COLOUR_MODES.map((choice) => (
          <button
            key={choice}
            type="button"
            className={css.chip}
            aria-pressed={choice === mode}
            onClick={() => set({ colourMode: choice })}
            data-testid={`colour-${choice}`}
          >
            {COLOUR_MODE_TITLES[choice]}
          </button>
        ))}
      </div>
      {map !== null && <Scale title={map.title} limit={map.limit} />}
    </div>
  );
}

function Scale({ title, limit }: { title: string; limit: number }) {
  const scale = SCALE[useScheme()];
  const half = Number((limit / 2).toPrecision(6));
  return (
    <div
      className={css.scale}
      role="img"
      aria-label={translate("colourBar.blueEdgesHave0Mm", { title, limit })}
      data-testid="colour-scale"
    >
      <span className={css.scaleKey}>
        <span style={{ background: scale.unworked }} />
        {translate("colourBar.neitherCutNorCreased")}
      </span>
      <span className={css.scaleBar}>
        <span
          className={css.scaleRamp}
          style={{ background: `linear-gradient(90deg, ${scale.stops.join(", ")})` }}
        />
        <span className={css.scaleFigures}>
          <span>0</span>
          <span>{formatNumber(half, { maximumFractionDigits: 6 })}</span>
          <span>{formatNumber(limit, { maximumFractionDigits: 6 })} mm</span>
        </span>
      </span>
      <span className={css.scaleKey}>
        <span style={{ background: scale.beyond }} />
        {translate("colourBar.moreThanMm", { limit })}
      </span>
    </div>
  );
}
