/** A rule, read-only. */

import { Group, Text } from "@mantine/core";
import type { Rule } from "../../api/drawings";
import { messageText } from "../../messages/translateMessage";
import { LINE_STYLES } from "../../state/drawing/palette";
import { Figure } from "../shared/parts";
import { Swatch } from "../shared/Swatch";

export function RuleSummary({ rule }: { rule: Rule & { edges?: number } }) {
  const conditions = messageText(rule.conditions);
  return (
    <Group gap={8} px={12} py={4} wrap="nowrap" align="baseline" fz={12} c="ink.2">
      <Swatch type={rule.type} />
      <Text flex={1} lineClamp={2} title={conditions}>
        <Text span c="ink.1" fw={600}>
          {LINE_STYLES[rule.type].title}
        </Text>{" "}
        {conditions}
      </Text>
      <Figure miw={30} ta="right" c="ink.2">
        {rule.edges ?? ""}
      </Figure>
    </Group>
  );
}
