/** Question for the line type of some edges; the most likely answer first. */

import { Flex, Text } from "@mantine/core";
import { useMemo } from "react";
import type { Question } from "../../api/drawings";
import { translate } from "../../language/translate";
import { messageText } from "../../messages/translateMessage";
import { useRefusal } from "../../state/accounts/accounts";
import { retype } from "../../state/actions";
import { indexColour } from "../../state/drawing/colours";
import { summarizeEdges } from "../../state/drawing/inspect";
import { LINE_STYLES } from "../../state/drawing/palette";
import {
  edgeQuestionFacts,
  edgeQuestionText,
  edgeQuestionTitle,
  isLineType,
  questionKey,
  questionRows,
} from "../../state/drawing/questions";
import { useFormatLength, useFormatLineWidth } from "../../state/drawing/useFormatLength";
import { useEdges } from "../../state/queries";
import { useUiStore } from "../../state/store";
import { SHOW_EDGES } from "../shared/labels";
import css from "../shared/panels.module.css";
import { Figure } from "../shared/parts";
import { Swatch } from "../shared/Swatch";
import { FollowingEdges } from "./FollowingEdges";
import { answerHandlers } from "./previewHandlers";

interface Props {
  question: Question;
  /** Called after an answer by keyboard, to move the focus to the next question. */
  onAnswered: () => void;
}

export function EdgeQuestion({ question, onAnswered }: Props) {
  const { data: edges } = useEdges();
  const busy = useUiStore((ui) => ui.busy);
  const refusal = useRefusal("PATCH /api/v1/drawings/{id}/edges");
  const zoomToEdges = useUiStore((ui) => ui.zoomToEdges);
  const length = useFormatLength();
  const lineWidth = useFormatLineWidth();
  const rows = useMemo(() => questionRows(edges, question), [question, edges]);
  const choices = question.choices.filter(isLineType);
  const { text, percent } = edgeQuestionText(question);
  const facts = useMemo(
    () => (edges === undefined ? null : summarizeEdges(edges, rows)),
    [edges, rows],
  );
  return (
    <article
      className={css.callout}
      data-tone="open"
      data-testid="question"
      {...answerHandlers(rows, "unclassified", question.follows)}
    >
      <button
        type="button"
        className={css.whole}
        title={SHOW_EDGES}
        onClick={() => zoomToEdges(rows)}
      >
        <Flex component="span" align="center" gap={8} mb={4} c="ink.0" fw={600}>
          <span className={css.dot} style={{ background: indexColour(question.colour) }} />
          <Text span flex={1} miw={0}>
            {edgeQuestionTitle(question)}
          </Text>
          <Figure>{`${translate("edgeQuestion.edges", { rows: rows.length })}${facts !== null ? ` · ${length(facts.length)}` : ""}`}</Figure>
        </Flex>
        <Text
          span
          display="block"
          mb={6}
          fz={11.5}
          c="ink.3"
          truncate="end"
          title={messageText(question)}
        >
          {edgeQuestionFacts(
            question,
            facts?.linetypes ?? [],
            facts?.lineWidths.map(lineWidth) ?? [],
          )}
        </Text>
      </button>
      <Text mb={10} fz={12} c="ink.2">
        {text || translate("edgeQuestion.nothingInTheFileSuggests")}
      </Text>
      {question.follows?.map((following) => (
        <FollowingEdges key={questionKey(following)} following={following} />
      ))}
      <div className={css.choices}>
        {choices.map((type, at) => {
          const likely = at === 0 && percent !== null;
          return (
            <button
              key={type}
              type="button"
              className={css.choice}
              disabled={busy || refusal !== null}
              aria-keyshortcuts={LINE_STYLES[type].key}
              title={refusal ?? undefined}
              data-answer={type}
              data-testid={`answer-${type}`}
              data-likely={likely}
              onClick={(event) => {
                const byKey = event.detail === 0;
                void retype(rows, type).then(() => byKey && onAnswered());
              }}
            >
              <Swatch type={type} />
              {LINE_STYLES[type].title}
              <Figure ml={likely ? 0 : "auto"} fz={11} c="ink.2" aria-hidden>
                {LINE_STYLES[type].key}
              </Figure>
              {likely && (
                <Figure ml="auto" c="ink.1">
                  {translate("edgeQuestion.mostLikely", { percent })}
                </Figure>
              )}
            </button>
          );
        })}
      </div>
    </article>
  );
}
