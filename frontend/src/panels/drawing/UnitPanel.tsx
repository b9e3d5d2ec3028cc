/** The unit of the drawing: choices with sizes, and the evidence for each. */

import { Flex, Group, Progress, Stack, Text } from "@mantine/core";
import { IconAlertTriangle, IconCheck } from "@tabler/icons-react";
import { useState } from "react";
import type { Drawing, Unit } from "../../api/drawings";
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
import { Figure, LinkButton, Note } from "../shared/parts";
import { Section } from "../shared/Section";

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
        <Figure>
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
        </Figure>
      }
    >
      {warnings.map((warning) => (
        <p key={warning.text} className={panels.callout} data-tone="amber">
          {messageText(warning)} {messageHint(warning)}
        </p>
      ))}
      {drawing.unit_learned.length > 0 && (
        <Note data-testid="unit-learned">
          {translate("unitPanel.asInDrawings", { drawings: drawing.unit_learned.join(", ") })}
        </Note>
      )}
      <UnitChoices drawing={drawing} />
      <Refusal reason={refusal} />
      {drawing.unit_given !== null && (
        <LinkButton
          type="button"
          disabled={refusal !== null}
          data-testid="unit-file"
          onClick={() => void patchDrawing({ unit: "file" })}
        >
          {translate("unitPanel.letKnifetipDetectTheUnit")}
        </LinkButton>
      )}
    </Section>
  );
}

const CHOICE = {
  flexDirection: "column",
  alignItems: "flex-start",
  gap: 4,
  padding: "8px 10px",
} as const;

interface ChoicesProps {
  readonly drawing: Drawing;
  readonly units?: readonly Unit[];
  /** Given where the unit is asked for: called after an answer by keyboard. */
  readonly onAnswered?: () => void;
}

/** One button per unit, with the size that it gives and the evidence for it. */
export function UnitChoices({ drawing, units, onAnswered }: ChoicesProps) {
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
    <Stack gap={6}>
      <Group gap={8} fz={11.5} c="ink.3" wrap="nowrap">
        <Progress w={28} size={4} value={60} aria-hidden flex="none" />
        {translate("unitPanel.aLongerBarShowsStronger")}
      </Group>
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
            className={panels.choice}
            style={CHOICE}
            aria-pressed={chosen}
            disabled={busy || refusal !== null}
            title={refusal ?? undefined}
            data-answer={onAnswered && unit}
            data-likely={likely}
            data-testid={`unit-${unit}`}
            onClick={(event) => {
              const byKey = event.detail === 0;
              if (!chosen) void patchDrawing({ unit }).then(() => byKey && onAnswered?.());
            }}
          >
            <Flex component="span" align="center" wrap="wrap" gap="0 6px" fw={600} w="100%">
              <span>{UNITS[unit].title}</span>
              {chosen && <IconCheck size={14} aria-label={translate("unitPanel.thisUnitIsUsed")} />}
              {likely && (
                <Text span fz={11.5} fw={500} c="var(--accent-ink)">
                  {translate("unitPanel.mostLikely")}
                </Text>
              )}
              <Text span ml="auto" fw={500}>
                {formatSize(width, height)}
              </Text>
            </Flex>
            <Flex component="span" align="center" justify="space-between" w="100%">
              <Progress
                w={96}
                size={4}
                value={(100 * (weightOf(unit) - lightest)) / range}
                aria-hidden
              />
              <Text span fz={11.5} c="ink.2">
                {formatInches(width, height)}
              </Text>
            </Flex>
            {reasons.slice(0, REASONS).map((reason) => (
              <Text span key={reason.text} fz={11.5} c="ink.2">
                {`• ${messageText(reason)}`}
              </Text>
            ))}
          </button>
        );
      })}
      {evidence.length > 0 && (
        <LinkButton
          type="button"
          style={{ margin: 0, textAlign: "left" }}
          aria-expanded={all}
          data-testid="unit-evidence"
          onClick={() => setAll(!all)}
        >
          {all
            ? translate("unitPanel.hideTheEvidenceForOther")
            : translate("unitPanel.showTheEvidenceForOther")}
        </LinkButton>
      )}
    </Stack>
  );
}
