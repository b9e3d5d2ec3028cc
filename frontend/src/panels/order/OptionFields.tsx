/** Fields of the options of a job that need no form of their own. */

import { Checkbox, NumberInput, Select, TextInput } from "@mantine/core";
import { OPTION_NAMES, type OptionName, optionField } from "../../state/order/options";
import { useUiStore } from "../../state/store";
import { descriptionText, optionLabel, valueLabel } from "./optionTexts";

/** Part of the range of a number by which its buttons change it. */
const STEPS = 18;

export function OptionFields() {
  return OPTION_NAMES.map((name) => <OptionInput key={name} name={name} />);
}

function OptionInput({ name }: { name: OptionName }) {
  const options = useUiStore((ui) => ui.options);
  const set = useUiStore((ui) => ui.set);
  const field = optionField(name);
  const change = (value: string | number | boolean) =>
    set({ options: { ...options, [name]: value } });
  const shown = {
    label: optionLabel(name),
    description: descriptionText(name),
    "data-testid": `option-${name}`,
  };
  const value = options[name] as string | number | boolean;
  switch (field.kind) {
    case "number":
      return (
        <NumberInput
          {...shown}
          min={field.min}
          max={field.max}
          step={(field.max - field.min) / STEPS}
          decimalScale={2}
          value={Number(value)}
          onChange={(given) => change(Number(given) || field.default)}
        />
      );
    case "choice":
      return (
        <Select
          {...shown}
          data={field.choices.map((choice) => ({ value: choice, label: valueLabel(name, choice) }))}
          value={String(value)}
          allowDeselect={false}
          onChange={(given) => change(given ?? field.default)}
        />
      );
    case "text":
      return (
        <TextInput
          {...shown}
          maxLength={field.maxLength}
          value={String(value)}
          onChange={({ currentTarget }) => change(currentTarget.value)}
        />
      );
    case "switch":
      return (
        <Checkbox
          {...shown}
          checked={value === true}
          onChange={({ currentTarget }) => change(currentTarget.checked)}
        />
      );
  }
}
