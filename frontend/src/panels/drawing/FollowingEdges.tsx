/** Edges that an answer decides besides those that the question asks about. */

import { Flex, Text } from "@mantine/core";
import { useMemo } from "react";
import type { FollowingEdges as Following } from "../../api/drawings";
import { translate } from "../../language/translate";
import { messageText } from "../../messages/translateMessage";
import { indexColour } from "../../state/drawing/colours";
import { summarizeEdges } from "../../state/drawing/inspect";
import { LINE_STYLES } from "../../state/drawing/palette";
import { edgeQuestionTitle, isLineType } from "../../state/drawing/questions";
import { useFormatLength } from "../../state/drawing/useFormatLength";
import { useEdges } from "../../state/queries";
import { useUiStore } from "../../state/store";
import css from "../shared/panels.module.css";
import { Figure } from "../shared/parts";

export function FollowingEdges({ following }: { following: Following }) {
  const { data: edges } = useEdges();
  const zoomToEdges = useUiStore((ui) => ui.zoomToEdges);
  const length = useFormatLength();
  const facts = useMemo(
    () => (edges === undefined ? null : summarizeEdges(edges, following.edges)),
    [edges, following],
  );
  const types = Object.entries(following.line_types).flatMap(([answer, type]) =>
    isLineType(answer) && isLineType(type)
      ? [
          translate("followingEdges.typeByAnswer", {
            type: LINE_STYLES[type].title,
            answer: LINE_STYLES[answer].title,
          }),
        ]
      : [],
  );
  return (
    <button
      type="button"
      className={css.whole}
      title={messageText(following)}
      data-testid="following-edges"
      onClick={() => zoomToEdges(following.edges)}
    >
      <Text span display="block" mb={4} fz={12} c="ink.2">
        {translate("followingEdges.alsoDecided")}
      </Text>
      <Flex component="span" align="center" gap={8} mb={4} c="ink.0" fw={600}>
        <span className={css.dot} style={{ background: indexColour(following.colour) }} />
        <Text span flex={1} miw={0}>
          {edgeQuestionTitle({ kind: "line-type", layer: following.layer })}
        </Text>
        <Figure>{`${translate("edgeQuestion.edges", { rows: following.edges.length })}${facts !== null ? ` · ${length(facts.length)}` : ""}`}</Figure>
      </Flex>
      {types.map((text) => (
        <Text key={text} span display="block" mb={6} fz={11.5} c="ink.3" truncate="end">
          {text}
        </Text>
      ))}
    </button>
  );
}
