/** Why the controller is not connected, or what differs between its settings and the machine. */

import { Flex, Text } from "@mantine/core";
import type { Station } from "../../api/machines";
import { translate } from "../../language/translate";
import { messageHint, messageText } from "../../messages/translateMessage";
import panels from "../shared/panels.module.css";

/** Notices that are shown at once; the others can be unfolded. */
const SHOWN = 2;

/** What is not known of the outputs of a machine that was locked when its gateway was started. */
export function UnknownOutputs({ station }: { readonly station: Station }) {
  if (!station.connected || station.outputs_known) return null;
  return (
    <section
      className={panels.callout}
      data-tone="amber"
      role="status"
      data-testid="unknown-outputs"
    >
      {translate("stationNotices.itIsNotKnownWhich")}
      <Text span c="ink.0" fw={600}>
        {" "}
        {translate("stationNotices.lookAtTheHeadBefore")}
      </Text>
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
        {hint !== "" && (
          <Text span c="ink.0" fw={600}>
            {" "}
            {hint}
          </Text>
        )}
      </li>
    );
  });
  return (
    <section
      className={panels.callout}
      data-tone={connected ? "amber" : "red"}
      aria-label={
        connected
          ? translate("stationNotices.settingsOfTheController")
          : translate("stationNotices.connectionToTheController")
      }
      role="status"
      data-testid="station-notices"
    >
      <Flex component="ul" direction="column" gap={6} pl={18} style={{ listStyle: "disc" }}>
        {rows.slice(0, SHOWN)}
      </Flex>
      {rows.length > SHOWN && (
        <details>
          <summary>
            {translate("stationNotices.moreSettingsDiffer", { rows: rows.length - SHOWN })}
          </summary>
          <Flex component="ul" direction="column" gap={6} pl={18} style={{ listStyle: "disc" }}>
            {rows.slice(SHOWN)}
          </Flex>
        </details>
      )}
    </section>
  );
}
