/** The placed drawings as a list: it does all that the sheet does, with the keyboard. */

import { ActionIcon, NumberInput, Switch } from "@mantine/core";
import { IconCopy, IconRotate, IconTrash } from "@tabler/icons-react";
import type { Placed } from "../../api/layouts";
import { translate } from "../../language/translate";
import css from "./layout.module.css";
import { normalTurn, round } from "./placing";

interface Props {
  readonly placed: readonly Placed[];
  readonly nameOf: (placed: Placed) => string;
  readonly chosen: ReadonlySet<number>;
  readonly colliding: ReadonlySet<number>;
  readonly onChoose: (index: number, more: boolean) => void;
  readonly onChange: (index: number, fields: Partial<Placed>) => void;
  readonly onFill: (index: number) => void;
  readonly onDuplicate: (index: number) => void;
  readonly onRemove: (index: number) => void;
}

const PLACES = [
  { field: "x", label: translate("layoutEditor.xMm"), min: -10000, max: 10000 },
  { field: "y", label: translate("layoutEditor.yMm"), min: -10000, max: 10000 },
  { field: "turn", label: translate("layoutEditor.turn"), min: -359, max: 359 },
] as const;
const REPEATS = [
  { field: "columns", label: translate("layoutEditor.columns"), min: 1, max: 200 },
  { field: "rows", label: translate("layoutEditor.rows"), min: 1, max: 200 },
  { field: "gap_x", label: translate("layoutEditor.gapX"), min: 0, max: 10000 },
  { field: "gap_y", label: translate("layoutEditor.gapY"), min: 0, max: 10000 },
] as const;

export function PlacedList(props: Props) {
  return (
    <ol className={css.list} aria-label={translate("layoutEditor.placedDrawings")}>
      {props.placed.map((one, index) => (
        // biome-ignore lint/suspicious/noArrayIndexKey: entries have no other identity
        <Entry key={index} one={one} index={index} {...props} />
      ))}
    </ol>
  );
}

function Entry({ one, index, ...props }: Props & { one: Placed; index: number }) {
  const name = props.nameOf(one);
  const isChosen = props.chosen.has(index);
  const field = ({ field, label, min, max }: (typeof PLACES | typeof REPEATS)[number]) => (
    <NumberInput
      hideControls
      key={field}
      label={label}
      size="xs"
      min={min}
      max={max}
      clampBehavior="blur"
      allowDecimal={field !== "columns" && field !== "rows"}
      decimalScale={3}
      value={one[field]}
      onChange={(value) => {
        if (typeof value === "number" && value >= min && value <= max)
          props.onChange(index, { [field]: round(value) });
      }}
      data-testid={`placed-${field}`}
    />
  );
  return (
    <li className={css.entry} data-chosen={isChosen} data-testid="placed">
      <div className={css.entryHead}>
        <button
          type="button"
          className={css.entryName}
          aria-pressed={isChosen}
          onClick={(event) => props.onChoose(index, event.shiftKey)}
        >
          {index + 1}. {name}
          {one.columns * one.rows > 1 && ` × ${one.columns * one.rows}`}
        </button>
        {props.colliding.has(index) && (
          <span className={css.collides}>{translate("layoutEditor.collides")}</span>
        )}
        <ActionIcon
          variant="subtle"
          color="gray"
          aria-label={translate("layoutEditor.turnBy90", { name })}
          onClick={() => props.onChange(index, { turn: normalTurn(one.turn + 90) })}
        >
          <IconRotate size={16} />
        </ActionIcon>
        <ActionIcon
          variant="subtle"
          color="gray"
          aria-label={translate("layoutEditor.duplicate", { name })}
          onClick={() => props.onDuplicate(index)}
        >
          <IconCopy size={16} />
        </ActionIcon>
        <ActionIcon
          variant="subtle"
          color="gray"
          aria-label={translate("layoutEditor.remove", { name })}
          onClick={() => props.onRemove(index)}
        >
          <IconTrash size={16} />
        </ActionIcon>
      </div>
      {isChosen && (
        <fieldset className={css.fields} aria-label={name}>
          {PLACES.map(field)}
          <Switch
            size="xs"
            label={translate("layoutEditor.mirror")}
            checked={one.mirror}
            onChange={(event) => props.onChange(index, { mirror: event.currentTarget.checked })}
          />
          {REPEATS.map(field)}
          <button
            type="button"
            className={css.fill}
            onClick={() => props.onFill(index)}
            data-testid="placed-fill"
          >
            {translate("layoutEditor.fillTheSheet")}
          </button>
        </fieldset>
      )}
    </li>
  );
}
