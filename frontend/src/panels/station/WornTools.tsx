/** Tools at the end of their lives: the operator puts new ones in, or states why they stay in use. */

import { IconCheck } from "@tabler/icons-react";
import { translate } from "../../language/translate";
import { formatMetres } from "../../state/station/checks";
import { REASON_LENGTH, type WornToolsState } from "../../state/station/wornTools";
import css from "./worn.module.css";

export function WornTools({ tools }: { tools: WornToolsState }) {
  const { worn, changed, reason } = tools;
  if (worn.length === 0) return null;
  const kept = worn.filter(({ station }) => !changed.has(station));
  return (
    <fieldset className={css.worn} data-testid="worn-tools">
      <legend>{translate("wornTools.otherToolsAreAtThe", { worn: worn.length })}</legend>
      {worn.map(({ station, name, used, life }) => (
        <label key={station} className={css.choice}>
          <input
            type="checkbox"
            checked={changed.has(station)}
            onChange={() => tools.toggle(station)}
            data-testid={`worn-changed-${station}`}
          />
          <span className={css.box} aria-hidden>
            <IconCheck className={css.tick} />
          </span>
          <span>
            <b>{translate("wornTools.iHavePutANew", { station })}</b>
            <small>
              {translate("wornTools.workedOfM", {
                name,
                used: formatMetres(used ?? 0),
                life: formatMetres(life ?? 0),
              })}
            </small>
          </span>
        </label>
      ))}
      {kept.length > 0 && (
        <label className={css.reason}>
          {changed.size > 0
            ? translate("wornTools.orStateWhyTheOther")
            : translate("wornTools.orStateWhyTheTool")}
          <input
            type="text"
            value={reason}
            maxLength={REASON_LENGTH}
            placeholder={translate("wornTools.reasonRecorded")}
            onChange={(event) => tools.explain(event.currentTarget.value)}
            data-testid="worn-reason"
          />
        </label>
      )}
    </fieldset>
  );
}
