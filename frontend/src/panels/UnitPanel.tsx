/** How large the drawing is, in which unit that was drawn, and what speaks for it. */

import { IconAlertTriangle, IconCheck } from "@tabler/icons-react";
import { useState } from "react";
import type { Drawing, Unit } from "../api/client";
import { settle } from "../state/actions";
import { useDrawing } from "../state/queries";
import { inches, sizeIn, UNITS, unitsOffered } from "../state/sizes";
import { usePage } from "../state/store";
import { size } from "../state/words";
import panels from "./panels.module.css";
import { Section } from "./Section";
import css from "./unit.module.css";

/** Of what speaks for a unit, so much is said. */
const REASONS = 4;

export function UnitPanel() {
  const { data: drawing } = useDrawing();
  if (drawing === undefined || drawing.unit === null) return null;
  const warnings = drawing.unit_finding?.warnings ?? [];
  return (
    <Section
      title="Unit"
      open={warnings.length > 0}
      aside={
        <span className={panels.rowFigure}>
          {warnings.length > 0 && (
            <IconAlertTriangle size={13} color="var(--warn)" aria-label="Look at this" />
          )}{" "}
          {UNITS[drawing.unit].title.toLowerCase()}
          {drawing.unit_given === null ? "" : ", as you said"}
        </span>
      }
    >
      {warnings.map((text) => (
        <p key={text} className={panels.warning}>
          {text}
        </p>
      ))}
      <UnitChoices drawing={drawing} />
      {drawing.unit_given !== null && (
        <button
          type="button"
          className={panels.link}
          data-testid="unit-file"
          onClick={() => void settle({ unit: "file" })}
        >
          Take what the file says
        </button>
      )}
    </Section>
  );
}

/** Each unit with the size that it would make, and why it may be the one; one click says it. */
export function UnitChoices({ drawing, units }: { drawing: Drawing; units?: readonly Unit[] }) {
  const busy = usePage((page) => page.busy);
  const offered = units ?? unitsOffered(drawing);
  const evidence = drawing.unit_finding?.evidence ?? [];
  const weightOf = (unit: Unit) =>
    evidence.reduce((sum, one) => (one.unit === unit ? sum + one.weight : sum), 0);
  const weights = offered.map(weightOf);
  const lightest = Math.min(...weights);
  const range = Math.max(1, Math.max(...weights) - lightest);
  const [all, setAll] = useState(false);
  return (
    <div className={css.units}>
      <p className={css.unitKey}>
        <span className={css.weight} aria-hidden>
          <span style={{ width: "60%" }} />
        </span>
        how much speaks for it
      </p>
      {offered.map((unit, at) => {
        const [width, height] = sizeIn(drawing, unit);
        const chosen = drawing.unit === unit;
        const likely = drawing.unit === null && at === 0;
        // Why not the others either: their sizes say it best.
        const told = all || chosen || likely;
        const reasons = told ? evidence.filter((one) => one.unit === unit) : [];
        return (
          <button
            key={unit}
            type="button"
            className={css.unit}
            aria-pressed={chosen}
            disabled={busy}
            data-likely={likely}
            data-testid={`unit-${unit}`}
            onClick={() => {
              if (!chosen) void settle({ unit });
            }}
          >
            <span className={css.unitHead}>
              {UNITS[unit].title}
              {chosen && <IconCheck size={14} aria-label="chosen" />}
              {likely && <span className={css.likely}>likeliest</span>}
              <span className={css.unitSize}>{size(width, height)}</span>
            </span>
            <span className={css.unitFoot}>
              <span className={css.weight}>
                <span style={{ width: `${(100 * (weightOf(unit) - lightest)) / range}%` }} />
              </span>
              <span className={css.unitInches}>{inches(width, height)}</span>
            </span>
            {reasons.slice(0, REASONS).map(({ text }) => (
              <span key={text} className={css.reason}>
                {text}
              </span>
            ))}
          </button>
        );
      })}
      {evidence.length > 0 && (
        <button
          type="button"
          className={panels.link}
          style={{ margin: 0, textAlign: "left" }}
          aria-expanded={all}
          data-testid="unit-evidence"
          onClick={() => setAll(!all)}
        >
          {all ? "Hide what speaks for the others" : "What speaks for the others"}
        </button>
      )}
    </div>
  );
}
