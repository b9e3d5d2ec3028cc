/** Fields of the options of a job that need no form of their own. */

import { NumberInput } from "@mantine/core";
import { OPTIONS } from "../../api/options.gen";
import { translate } from "../../language/translate";
import { OPTION_NAMES, type OptionName } from "../../state/order/options";
import { useUiStore } from "../../state/store";

export const OPTION_LABELS: Readonly<Record<OptionName, string>> = {
  feed_factor: translate("option.feedFactor"),
};

const DESCRIPTIONS: Readonly<Record<OptionName, string>> = {
  feed_factor: translate("option.feedFactorDescription"),
};

/** Part of the range of a number by which its buttons change it. */
const STEPS = 18;

export function OptionFields() {
  const options = useUiStore((ui) => ui.options);
  const set = useUiStore((ui) => ui.set);
  return OPTION_NAMES.map((name) => {
    const { min, max, default: usual } = OPTIONS[name];
    return (
      <NumberInput
        key={name}
        label={OPTION_LABELS[name]}
        description={DESCRIPTIONS[name]}
        min={min}
        max={max}
        step={(max - min) / STEPS}
        decimalScale={2}
        value={options[name]}
        onChange={(value) => set({ options: { ...options, [name]: Number(value) || usual } })}
        data-testid={`option-${name}`}
      />
    );
  });
}
