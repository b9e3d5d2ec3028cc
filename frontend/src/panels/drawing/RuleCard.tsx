/** One rule of a profile: edit, move, delete. */

import { ActionIcon, Group, Select, SimpleGrid, TextInput, Tooltip } from "@mantine/core";
import { IconChevronDown, IconChevronUp, IconGripVertical, IconX } from "@tabler/icons-react";
import { useState } from "react";
import { translate } from "../../language/translate";
import {
  CONDITIONS,
  type Condition,
  colourError,
  type DraftRule,
  formatPatterns,
  matchesAll,
  parsePatterns,
} from "../../state/drawing/draft";
import { ASSIGNABLE_TYPES, LINE_STYLES } from "../../state/drawing/palette";
import { Figure, LinkButton } from "../shared/parts";
import { Swatch } from "../shared/Swatch";
import css from "./profile.module.css";

const TITLES: Readonly<Record<Condition, string>> = {
  layer: translate("ruleCard.layerName"),
  colour: translate("ruleCard.colour"),
  linetype: translate("ruleCard.lineStyleInFile"),
  entity: translate("ruleCard.objectTypeInFile"),
  block: translate("ruleCard.blockName"),
};
const HINTS: Readonly<Record<Condition, string>> = {
  layer: translate("ruleCard.eGFoldsCrease"),
  colour: translate("ruleCard.eG1Ff0000"),
  linetype: translate("ruleCard.eGDash"),
  entity: translate("ruleCard.eGLineArc"),
  block: translate("ruleCard.eGCrease"),
};
/** Conditions that are always shown; the others on request. */
const USUAL: readonly Condition[] = ["layer", "colour"];

interface Props {
  rule: DraftRule;
  number: number;
  /** Edges of the open drawing that it matches; null until counted. */
  edges: number | null;
  lifted: boolean;
  onChange: (part: Partial<DraftRule>) => void;
  onDelete: () => void;
  onMove: (to: number) => void;
  onLift: (key: number | null) => void;
  onOver: () => void;
}

export function RuleCard(props: Props) {
  const { rule, number, edges, lifted, onChange, onDelete, onMove, onLift, onOver } = props;
  const [all, setAll] = useState(false);
  const shown = CONDITIONS.filter(
    (condition) => all || USUAL.includes(condition) || rule[condition].length > 0,
  );
  return (
    <li
      className={css.rule}
      data-lifted={lifted}
      data-testid="rule"
      onDragOver={(event) => {
        event.preventDefault();
        onOver();
      }}
      onDrop={(event) => event.preventDefault()}
    >
      <Group gap={4} wrap="nowrap">
        {/* biome-ignore lint/a11y/noStaticElementInteractions: the buttons at the right do the same */}
        <span
          className={css.grip}
          draggable
          title={translate("ruleCard.dragToChangeTheOrder")}
          onDragStart={(event) => {
            event.dataTransfer.effectAllowed = "move";
            onLift(rule.key);
          }}
          onDragEnd={() => onLift(null)}
        >
          <IconGripVertical size={14} aria-hidden />
        </span>
        <Select
          size="xs"
          aria-label={translate("ruleCard.lineTypeOfRule", { number })}
          data={ASSIGNABLE_TYPES.map((type) => ({ value: type, label: LINE_STYLES[type].title }))}
          value={rule.type}
          allowDeselect={false}
          leftSection={<Swatch type={rule.type} />}
          leftSectionWidth={34}
          style={{ flex: 1 }}
          onChange={(choice) => {
            const type = ASSIGNABLE_TYPES.find((one) => one === choice);
            if (type !== undefined) onChange({ type });
          }}
        />
        <Figure data-testid="rule-edges">
          {edges === null ? "…" : translate("ruleCard.edges", { edges })}
        </Figure>
        <IconButton
          label={translate("ruleCard.moveThisRuleUpApplied")}
          act={() => onMove(number - 2)}
        >
          <IconChevronUp size={14} />
        </IconButton>
        <IconButton
          label={translate("ruleCard.moveThisRuleDownApplied")}
          act={() => onMove(number)}
        >
          <IconChevronDown size={14} />
        </IconButton>
        <IconButton label={translate("ruleCard.deleteThisRule")} act={onDelete}>
          <IconX size={14} />
        </IconButton>
      </Group>
      <SimpleGrid cols={2} spacing={8} mt={8}>
        {shown.map((condition) => (
          <Field
            key={condition}
            condition={condition}
            number={number}
            patterns={rule[condition]}
            onChange={(patterns) => onChange({ [condition]: patterns })}
          />
        ))}
      </SimpleGrid>
      <Group gap={8} mt={6} justify="space-between" fz={11.5} c="var(--warn-ink)">
        {matchesAll(rule) && <span>{translate("ruleCard.thisRuleHasNoCondition")}</span>}
        {shown.length < CONDITIONS.length && (
          <LinkButton ml="auto" onClick={() => setAll(true)}>
            {translate("ruleCard.showMoreConditionsForThis")}
          </LinkButton>
        )}
      </Group>
    </li>
  );
}

interface FieldProps {
  condition: Condition;
  number: number;
  patterns: readonly (string | number)[];
  onChange: (patterns: (string | number)[]) => void;
}

/** Keeps the text as typed and passes on the parsed patterns. */
function Field({ condition, number, patterns, onChange }: FieldProps) {
  const [typed, setTyped] = useState(() => formatPatterns(patterns));
  // Undo may have changed the patterns: then show those instead of the typed text.
  const normalized = formatPatterns(patterns);
  const text = formatPatterns(parsePatterns(condition, typed)) === normalized ? typed : normalized;
  const fault = condition === "colour" ? colourError(patterns) : "";
  return (
    <TextInput
      size="xs"
      label={TITLES[condition]}
      aria-label={translate("ruleCard.ofRule", { condition: TITLES[condition], number })}
      placeholder={HINTS[condition]}
      value={text}
      error={fault === "" ? undefined : fault}
      onChange={(event) => {
        setTyped(event.currentTarget.value);
        onChange(parsePatterns(condition, event.currentTarget.value));
      }}
    />
  );
}

function IconButton(props: { label: string; act: () => void; children: React.ReactNode }) {
  return (
    <Tooltip label={props.label}>
      <ActionIcon
        variant="subtle"
        color="gray"
        size="sm"
        aria-label={props.label}
        onClick={props.act}
      >
        {props.children}
      </ActionIcon>
    </Tooltip>
  );
}
