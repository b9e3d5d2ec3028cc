/** Tools at the end of their lives: the operator puts new ones in, or states why they stay in use. */

import { IconCheck } from "@tabler/icons-react";
import { formatMetres } from "../state/checks";
import { REASON_LENGTH, type WornToolsState } from "../state/wornTools";
import css from "./worn.module.css";

export function WornTools({ tools }: { tools: WornToolsState }) {
  const { worn, changed, reason } = tools;
  if (worn.length === 0) return null;
  const kept = worn.filter(({ station }) => !changed.has(station));
  return (
    <fieldset className={css.worn} data-testid="worn-tools">
      <legend>
        {worn.length === 1 ? "A tool is" : `${worn.length} tools are`} at the end of life
      </legend>
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
            <b>I have put a new tool into station {station}</b>
            <small>
              {name}, worked {formatMetres(used ?? 0)} of {formatMetres(life ?? 0)} m
            </small>
          </span>
        </label>
      ))}
      {kept.length > 0 && (
        <label className={css.reason}>
          {changed.size > 0
            ? "Or state why the other tool stays in use"
            : "Or state why the tool stays in use"}
          <input
            type="text"
            value={reason}
            maxLength={REASON_LENGTH}
            placeholder="Reason (recorded)"
            onChange={(event) => tools.explain(event.currentTarget.value)}
            data-testid="worn-reason"
          />
        </label>
      )}
    </fieldset>
  );
}
