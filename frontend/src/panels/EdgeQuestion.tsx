/** Question for the line type of some edges; the most likely answer first. */

import { useMemo } from "react";
import type { Question } from "../api/client";
import { renderText } from "../messages/render";
import { useRefusal } from "../state/accounts";
import { retype } from "../state/actions";
import { indexColour } from "../state/colours";
import { pluralize } from "../state/format";
import { summarizeEdges } from "../state/inspect";
import { LINE_STYLES } from "../state/palette";
import { useEdges } from "../state/queries";
import {
  edgeQuestionFacts,
  edgeQuestionText,
  edgeQuestionTitle,
  isLineType,
} from "../state/questions";
import { rowsOfLayer } from "../state/rows";
import { useUiStore } from "../state/store";
import { useFormatLength, useFormatLineWidth } from "../state/useFormatLength";
import { SHOW_EDGES } from "./labels";
import css from "./panels.module.css";
import { answerHandlers } from "./previewHandlers";
import questionCss from "./questions.module.css";
import { Swatch } from "./Swatch";

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
  const rows = useMemo(
    () =>
      question.edges.length > 0 || edges === undefined
        ? question.edges
        : rowsOfLayer(edges, question.layer, question.colour),
    [question, edges],
  );
  const choices = question.choices.filter(isLineType);
  const { text, percent } = edgeQuestionText(question);
  const facts = useMemo(
    () => (edges === undefined ? null : summarizeEdges(edges, rows)),
    [edges, rows],
  );
  return (
    <article
      className={questionCss.question}
      data-testid="question"
      {...answerHandlers(rows, "unclassified")}
    >
      <button
        type="button"
        className={questionCss.questionShow}
        title={SHOW_EDGES}
        onClick={() => zoomToEdges(rows)}
      >
        <span className={questionCss.questionHead}>
          <span className={css.dot} style={{ background: indexColour(question.colour) }} />
          <span className={questionCss.questionTitle}>{edgeQuestionTitle(question)}</span>
          <span className={css.rowFigure}>
            {pluralize(rows.length, "edge")}
            {facts !== null && ` · ${length(facts.length)}`}
          </span>
        </span>
        <span className={questionCss.questionFacts} title={renderText(question)}>
          {edgeQuestionFacts(
            question,
            facts?.linetypes ?? [],
            facts?.lineWidths.map(lineWidth) ?? [],
          )}
        </span>
      </button>
      <p className={questionCss.questionText}>
        {text || "Nothing in the file suggests a line type for these edges. Choose the line type."}
      </p>
      <div className={questionCss.choices}>
        {choices.map((type, at) => {
          const likely = at === 0 && percent !== null;
          return (
            <button
              key={type}
              type="button"
              className={`${questionCss.choice} ${likely ? questionCss.choiceWide : ""}`}
              disabled={busy || refusal !== null}
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
              {likely && (
                <span className={questionCss.choiceFigure}>most likely ({percent} %)</span>
              )}
            </button>
          );
        })}
      </div>
    </article>
  );
}
