/** Why the controller is not connected, or what differs between its settings and the machine. */

import type { Station } from "../../api/client";
import { translate } from "../../language/translate";
import { messageHint, messageText } from "../../messages/translateMessage";
import css from "./station.module.css";

/** Notices that are shown at once; the others can be unfolded. */
const SHOWN = 2;

/** What is not known of the outputs of a machine that was locked when its gateway was started. */
export function UnknownOutputs({ station }: { readonly station: Station }) {
  if (!station.connected || station.outputs_known) return null;
  return (
    <section className={css.message} data-tone="amber" role="status" data-testid="unknown-outputs">
      {translate("stationNotices.itIsNotKnownWhich")}
      <span className={css.todo}> {translate("stationNotices.lookAtTheHeadBefore")}</span>
    </section>
  );
}

export function StationNotices({ station }: { readonly station: Station }) {
  const { notices, connected } = station;
  if (notices.length === 0) return null;
  const rows = notices.map((notice) => {
    const hint = messageHint(notice);
    return (
      <li key={JSON.stringify(notice.arguments)}>
        {messageText(notice)}
        {hint !== "" && <span className={css.todo}> {hint}</span>}
      </li>
    );
  });
  return (
    <section
      className={css.message}
      data-tone={connected ? "amber" : "red"}
      aria-label={
        connected
          ? translate("stationNotices.settingsOfTheController")
          : translate("stationNotices.connectionToTheController")
      }
      role="status"
      data-testid="station-notices"
    >
      <ul className={css.notices}>{rows.slice(0, SHOWN)}</ul>
      {rows.length > SHOWN && (
        <details>
          <summary>
            {translate("stationNotices.moreSettingsDiffer", { rows: rows.length - SHOWN })}
          </summary>
          <ul className={css.notices}>{rows.slice(SHOWN)}</ul>
        </details>
      )}
    </section>
  );
}
