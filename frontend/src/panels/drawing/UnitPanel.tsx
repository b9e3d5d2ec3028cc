/** The unit of the drawing: choices with sizes, and the evidence for each. */

import { IconAlertTriangle, IconCheck } from "@tabler/icons-react";
import { useState } from "react";
import type { Drawing, Unit } from "../../api/client";
import { insideSentence } from "../../language/numbers";
import { translate } from "../../language/translate";
import { messageHint, messageText } from "../../messages/translateMessage";
import { useRefusal } from "../../state/accounts/accounts";
import { patchDrawing } from "../../state/actions";
import { formatInches, offeredUnits, sizeIn, UNITS } from "../../state/drawing/sizes";
import { formatSize } from "../../state/format";
import { useDrawing } from "../../state/queries";
import { useUiStore } from "../../state/store";
import { Refusal } from "../accounts/Permitted";
import panels from "../shared/panels.module.css";
import { Section } from "../shared/Section";
import css from "./unit.module.css";

/** Pieces of evidence listed per unit. */
const REASONS = 4;

export function UnitPanel() {
  const { data: drawing } = useDrawing();
  const refusal = useRefusal("PATCH /api/v1/drawings/{id}");
  if (drawing === undefined || drawing.unit === null) return null;
  const warnings = drawing.unit_finding?.warnings ?? [];
  return (
    <Section
      title={translate("unitPanel.unitOfLengthInThe")}
      open={warnings.length > 0}
      aside={
        <span className={panels.rowFigure}>
          {warnings.length > 0 && (
            <IconAlertTriangle
              size={13}
              color="var(--warn)"
              aria-label={translate("unitPanel.warningAboutTheUnit")}
            />
          )}{" "}
          {drawing.unit_given === null || drawing.unit_learned.length > 0
            ? insideSentence(UNITS[drawing.unit].title)
            : translate("unitPanel.setByHand", {
                title: insideSentence(UNITS[drawing.unit].title),
              })}
        </span>
      }
    >
      {warnings.map((warning) => (
        <p key={warning.text} className={panels.warning}>
          {messageText(warning)} {messageHint(warning)}
        </p>
      ))}
      {drawing.unit_learned.length > 0 && (
        <p className={panels.note} data-testid="unit-learned">
          {translate("unitPanel.asInDrawings", { drawings: drawing.unit_learned.join(", ") })}
        </p>
      )}
      <UnitChoices drawing={drawing} />
      <Refusal reason={refusal} />
      {drawing.unit_given !== null && (
        <button
          type="button"
          className={panels.link}
          disabled={refusal !== null}
          data-testid="unit-file"
          onClick={() => void patchDrawing({ unit: "file" })}
        >
          {translate("unitPanel.letKnifetipDetectTheUnit")}
        </button>
      )}
    </Section>
  );
}

/** One button per unit, with the size that it gives and the evidence for it. */
export function UnitChoices({ drawing, units }: { drawing: Drawing; units?: readonly Unit[] }) {
  const busy = useUiStore((ui) => ui.busy);
  const refusal = useRefusal("PATCH /api/v1/drawings/{id}");
  const offered = units ?? offeredUnits(drawing);
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
        {translate("unitPanel.aLongerBarShowsStronger")}
      </p>
      {offered.map((unit, at) => {
        const [width, height] = sizeIn(drawing, unit);
        const chosen = drawing.unit === unit;
        const likely = drawing.unit === null && at === 0;
        // The evidence for unlikely units is collapsed.
        const listed = all || chosen || likely;
        const reasons = listed ? evidence.filter((one) => one.unit === unit) : [];
        return (
          <button
            key={unit}
            type="button"
            className={css.unit}
            aria-pressed={chosen}
            disabled={busy || refusal !== null}
            title={refusal ?? undefined}
            data-likely={likely}
            data-testid={`unit-${unit}`}
            onClick={() => {
              if (!chosen) void patchDrawing({ unit });
            }}
          >
            <span className={css.unitHead}>
              {UNITS[unit].title}
              {chosen && <IconCheck size={14} aria-label={translate("unitPanel.thisUnitIsUsed")} />}
              {likely && <span className={css.likely}>{translate("unitPanel.mostLikely")}</span>}
              <span className={css.unitSize}>{formatSize(width, height)}</span>
            </span>
            <span className={css.unitFoot}>
              <span className={css.weight}>
                <span style={{ width: `${(100 * (weightOf(unit) - lightest)) / range}%` }} />
              </span>
              <span className={css.unitInches}>{formatInches(width, height)}</span>
            </span>
            {reasons.slice(0, REASONS).map((reason) => (
              <span key={reason.text} className={css.reason}>
                {messageText(reason)}
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
          {all
            ? translate("unitPanel.hideTheEvidenceForOther")
            : translate("unitPanel.showTheEvidenceForOther")}
        </button>
      )}
    </div>
  );
}
