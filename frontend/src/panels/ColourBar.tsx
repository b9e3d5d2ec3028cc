/** Choice of what the colour of a line shows, and the scale of that figure. */

import { SCALE } from "../state/palette";
import { useEdges, useVerdict } from "../state/queries";
import { COLOUR_MODES, type ColourMode, useUiStore } from "../state/store";
import { verdictMapOf } from "../state/verdictMap";
import css from "./over.module.css";

const TITLES: Readonly<Record<ColourMode, string>> = {
  types: "Line types",
  deviation: "Deviation",
  overcut: "Overcut",
};

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
        aria-label="Colour lines by"
        className={css.modes}
        data-testid="colour-mode"
        data-mode={mode}
      >
        {COLOUR_MODES.map((word) => (
          <button
            key={word}
            type="button"
            className={css.chip}
            aria-pressed={word === mode}
            onClick={() => set({ colourMode: word })}
            data-testid={`colour-${word}`}
          >
            {TITLES[word]}
          </button>
        ))}
      </div>
      {map !== null && <Scale title={map.title} limit={map.limit} />}
    </div>
  );
}

function Scale({ title, limit }: { title: string; limit: number }) {
  const half = Number((limit / 2).toPrecision(6));
  return (
    <div
      className={css.scale}
      role="img"
      aria-label={`${title}: blue 0, yellow ${limit} mm, red above; grey: not machined`}
      data-testid="colour-scale"
    >
      <span className={css.scaleKey}>
        <span style={{ background: SCALE.unworked }} />
        not machined
      </span>
      <span className={css.scaleBar}>
        <span
          className={css.scaleRamp}
          style={{ background: `linear-gradient(90deg, ${SCALE.stops.join(", ")})` }}
        />
        <span className={css.scaleFigures}>
          <span>0</span>
          <span>{half}</span>
          <span>{limit} mm</span>
        </span>
      </span>
      <span className={css.scaleKey}>
        <span style={{ background: SCALE.beyond }} />
        above
      </span>
    </div>
  );
}
