/** One rule of a profile, to be written, moved and taken away. */

import { ActionIcon, Select, TextInput, Tooltip } from "@mantine/core";
import { IconChevronDown, IconChevronUp, IconGripVertical, IconX } from "@tabler/icons-react";
import { useState } from "react";
import {
  CONDITIONS,
  type Condition,
  colourFault,
  type DraftRule,
  meetsAll,
  patternsOf,
  textOf,
} from "../state/draft";
import { CHOICES, LINE_LOOKS } from "../state/palette";
import { count } from "../state/words";
import panels from "./panels.module.css";
import css from "./profile.module.css";
import { Swatch } from "./Swatch";

const TITLES: Readonly<Record<Condition, string>> = {
  layer: "Layer",
  colour: "Colour",
  linetype: "Linetype",
  entity: "Entity",
  block: "Block",
};
const HINTS: Readonly<Record<Condition, string>> = {
  layer: "FOLDS, crease*",
  colour: "1, #ff0000",
  linetype: "*DASH*",
  entity: "LINE, ARC",
  block: "*",
};
/** What most rules are made of; the rest is there once it is wanted. */
const USUAL: readonly Condition[] = ["layer", "colour"];

interface Props {
  rule: DraftRule;
  number: number;
  /** How many edges of the drawing it takes; null while that is not known. */
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
      <div className={css.ruleHead}>
        {/* biome-ignore lint/a11y/noStaticElementInteractions: the buttons at the right do the same */}
        <span
          className={css.grip}
          draggable
          title="Drag it to another place"
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
          aria-label={`Line type of rule ${number}`}
          data={CHOICES.map((type) => ({ value: type, label: LINE_LOOKS[type].title }))}
          value={rule.type}
          allowDeselect={false}
          leftSection={<Swatch type={rule.type} />}
          leftSectionWidth={34}
          style={{ flex: 1 }}
          onChange={(word) => {
            const type = CHOICES.find((one) => one === word);
            if (type !== undefined) onChange({ type });
          }}
        />
        <span className={panels.rowFigure} data-testid="rule-edges">
          {edges === null ? "…" : count(edges, "edge")}
        </span>
        <Button label="Sooner" act={() => onMove(number - 2)}>
          <IconChevronUp size={14} />
        </Button>
        <Button label="Later" act={() => onMove(number)}>
          <IconChevronDown size={14} />
        </Button>
        <Button label="Delete this rule" act={onDelete}>
          <IconX size={14} />
        </Button>
      </div>
      <div className={css.conditions}>
        {shown.map((condition) => (
          <Field
            key={condition}
            condition={condition}
            number={number}
            patterns={rule[condition]}
            onChange={(patterns) => onChange({ [condition]: patterns })}
          />
        ))}
      </div>
      <div className={css.ruleFoot}>
        {meetsAll(rule) && <span>Without a condition it takes everything.</span>}
        {shown.length < CONDITIONS.length && (
          <button type="button" className={css.more} onClick={() => setAll(true)}>
            More conditions
          </button>
        )}
      </div>
    </li>
  );
}

interface FieldProps {
  condition: Condition;
  number: number;
  patterns: readonly (string | number)[];
  onChange: (patterns: (string | number)[]) => void;
}

/** What is typed stays as it is typed; what it means goes up. */
function Field({ condition, number, patterns, onChange }: FieldProps) {
  const [typed, setText] = useState(() => textOf(patterns));
  // What is meant may have been taken back meanwhile.
  const means = textOf(patterns);
  const text = textOf(patternsOf(condition, typed)) === means ? typed : means;
  const fault = condition === "colour" ? colourFault(patterns) : "";
  return (
    <TextInput
      size="xs"
      label={TITLES[condition]}
      aria-label={`${TITLES[condition]} of rule ${number}`}
      placeholder={HINTS[condition]}
      value={text}
      error={fault === "" ? undefined : fault}
      onChange={(event) => {
        setText(event.currentTarget.value);
        onChange(patternsOf(condition, event.currentTarget.value));
      }}
    />
  );
}

function Button(props: { label: string; act: () => void; children: React.ReactNode }) {
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
