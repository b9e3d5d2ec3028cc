/** Scale bar and cursor position, at the bottom of the canvas. */

import type { Point } from "../geometry/records";
import { formatFixed, formatNumber } from "../language/numbers";
import { translate } from "../language/translate";
import css from "./app.module.css";

/** A round length (mm) whose bar is 60 to 150 pixels long. */
function barLength(pixelsPerMm: number): number {
  const least = 60 / pixelsPerMm;
  const power = 10 ** Math.floor(Math.log10(least));
  return power * ([1, 2, 5, 10].find((step) => step * power >= least) ?? 10);
}

interface Props {
  scale: number;
  cursor: Point | null;
  /** Empty if the unit of the file is unknown. */
  unit: "mm" | "";
}

export function StatusBar({ scale, cursor, unit }: Props) {
  const bar = barLength(scale);
  const digits = scale > 50 ? 3 : scale > 5 ? 2 : 1;
  return (
    <div className={css.status}>
      <span className={css.scale} data-testid="scale-bar">
        <span className={css.scaleBar} style={{ width: bar * scale }} />
        {bar >= 1000 && unit === "mm"
          ? `${bar / 1000} m`
          : `${formatNumber(Number(bar.toPrecision(2)))} ${unit || translate("statusBar.fileUnits")}`}
      </span>
      <span style={{ flex: 1 }} />
      {cursor && (
        <span data-testid="cursor">
          {translate("statusBar.xY", {
            x: formatFixed(cursor.x, digits),
            y: formatFixed(cursor.y, digits),
            unit,
          })}
        </span>
      )}
    </div>
  );
}
