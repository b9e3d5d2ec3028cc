/** Tools at the end of their lives: the operator puts new ones in, or states why they stay in use. */

import { Checkbox, Fieldset, Stack, TextInput } from "@mantine/core";
import { translate } from "../../language/translate";
import { formatMetres } from "../../state/station/checks";
import { REASON_LENGTH, type WornToolsState } from "../../state/station/wornTools";
import panels from "../shared/panels.module.css";

export function WornTools({ tools }: { tools: WornToolsState }) {
  const { worn, changed, reason } = tools;
  if (worn.length === 0) return null;
  const kept = worn.filter(({ station }) => !changed.has(station));
  return (
    <Fieldset
      data-touch
      className={panels.callout}
      data-tone="amber"
      data-testid="worn-tools"
      legend={translate("wornTools.otherToolsAreAtThe", { worn: worn.length })}
    >
      <Stack gap={8}>
        {worn.map(({ station, name, used, life }) => (
          <Checkbox
            key={station}
            size="lg"
            label={translate("wornTools.iHavePutANew", { station })}
            description={translate("wornTools.workedOfM", {
              name,
              used: formatMetres(used ?? 0),
              life: formatMetres(life ?? 0),
            })}
            checked={changed.has(station)}
            onChange={() => tools.toggle(station)}
            data-testid={`worn-changed-${station}`}
          />
        ))}
        {kept.length > 0 && (
          <TextInput
            size="lg"
            label={
              changed.size > 0
                ? translate("wornTools.orStateWhyTheOther")
                : translate("wornTools.orStateWhyTheTool")
            }
            value={reason}
            maxLength={REASON_LENGTH}
            placeholder={translate("wornTools.reasonRecorded")}
            onChange={(event) => tools.explain(event.currentTarget.value)}
            data-testid="worn-reason"
          />
        )}
      </Stack>
    </Fieldset>
  );
}
