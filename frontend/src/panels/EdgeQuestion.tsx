/** What nobody knows of some edges: the likeliest answer first, each one click. */

import { useMemo } from "react";
import type { Question } from "../api/client";
import { LINE_TYPES, type LineType } from "../geometry/records";
import { retype } from "../state/actions";
import { colourWords, indexColour } from "../state/colours";
import { inspected } from "../state/inspect";
import { useLength } from "../state/measure";
import { LINE_LOOKS } from "../state/palette";
import { useEdges } from "../state/queries";
import { askedOf } from "../state/questions";
import { rowsOfLayer } from "../state/rows";
import { usePage } from "../state/store";
import { count } from "../state/words";
import css from "./panels.module.css";
import { answering } from "./pointing";
import questionCss from "./questions.module.css";
import { Swatch } from "./Swatch";

const isLineType = (word: string): word is LineType =>
  LINE_TYPES.some((type) => type === word) && word !== "unclassified";

interface Props {
  question: Question;
  /** Called once it is answered by the keyboard: the focus would be lost with it. */
  onAnswered: () => void;
}

export function EdgeQuestion({ question, onAnswered }: Props) {
  const { data: edges } = useEdges();
  const busy = usePage((page) => page.busy);
  const look = usePage((page) => page.look);
  const length = useLength();
  const rows = useMemo(
    () =>
      question.edges.length > 0 || edges === undefined
        ? question.edges
        : rowsOfLayer(edges, question.layer, question.colour),
    [question, edges],
  );
  const choices = question.choices.filter(isLineType);
  const { text, share, why } = askedOf(question.text);
  const facts = useMemo(() => (edges === undefined ? null : inspected(edges, rows)), [edges, rows]);
  return (
    <article
      className={questionCss.question}
      data-testid="question"
      {...answering(rows, "unclassified")}
    >
      <button
        type="button"
        className={questionCss.questionShow}
        title="Show these edges"
        onClick={() => look(rows)}
      >
        <span className={questionCss.questionHead}>
          <span className={css.dot} style={{ background: indexColour(question.colour) }} />
          <span className={css.rowName}>
            {question.layer === "" ? "These edges" : `Layer ${question.layer}`}
          </span>
          <span className={css.rowFigure}>
            {count(rows.length, "edge")}
            {facts !== null && ` · ${length(facts.length)}`}
          </span>
        </span>
        <span className={questionCss.questionFacts} title={question.text}>
          Colour {colourWords(question.colour)}
          {facts !== null && facts.linetypes.length > 0 && ` · ${facts.linetypes.join(", ")}`}
        </span>
      </button>
      <p className={questionCss.questionText}>{why || text || "Nothing says what they are."}</p>
      <div className={questionCss.choices}>
        {choices.map((type, at) => {
          const likely = at === 0 && share !== null;
          return (
            <button
              key={type}
              type="button"
              className={`${questionCss.choice} ${likely ? questionCss.choiceWide : ""}`}
              disabled={busy}
              data-answer={type}
              data-testid={`answer-${type}`}
              data-likely={likely}
              onClick={(event) => {
                const byKey = event.detail === 0;
                void retype(rows, type).then(() => byKey && onAnswered());
              }}
            >
              <Swatch type={type} />
              {LINE_LOOKS[type].title}
              {likely && (
                <span className={questionCss.choiceFigure}>likeliest, {share} % sure</span>
              )}
            </button>
          );
        })}
      </div>
    </article>
  );
}
