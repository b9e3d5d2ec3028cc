/** Puts a tool of the library into a station. */

import { Select } from "@mantine/core";
import { useQuery } from "@tanstack/react-query";
import { useState } from "react";
import { translate } from "../../language/translate";
import { errorText } from "../../messages/translateMessage";
import type { Fields } from "../../state/library/definitions";
import { queries, queryClient } from "../../state/queries";

interface Props {
  /** Takes the fields of the tool, which are a copy: a later change of the tool does not reach it. */
  readonly onPick: (tool: Fields) => void;
}

export function ToolPicker({ onPick }: Props) {
  const { data: entries = [] } = useQuery(queries.library());
  const [fault, setFault] = useState<string | null>(null);
  const pick = async (name: string) => {
    setFault(null);
    try {
      const { fields } = await queryClient.fetchQuery(queries.definition("tools", name));
      onPick((fields as { tool: Fields }).tool);
    } catch (error) {
      setFault(error instanceof Error ? errorText(error) : String(error));
    }
  };
  return (
    <Select
      label={translate("toolPicker.takeAToolFromThe")}
      description={translate("toolPicker.itsDimensionsAndFeedRates")}
      placeholder={translate("toolPicker.chooseATool")}
      data={entries
        .filter(({ shelf }) => shelf === "tools")
        .map(({ name, title }) => ({ value: name, label: title || name }))}
      value={null}
      error={fault}
      onChange={(name) => name !== null && void pick(name)}
      data-testid="tool-picker"
    />
  );
}
