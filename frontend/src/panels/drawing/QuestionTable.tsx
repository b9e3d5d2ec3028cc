/** Many questions about line types as a table: one row for each, answered together. */

import { useMemo, useState } from "react";
import type { Question } from "../../api/client";
import type { LineType } from "../../geometry/records";
import { translate } from "../../language/translate";
import { messageText } from "../../messages/translateMessage";
import { useRefusal } from "../../state/accounts/accounts";
import { retypeEach } from "../../state/actions";
import { indexColour } from "../../state/drawing/colours";
import { summarizeEdges } from "../../state/drawing/inspect";
import { LINE_STYLES } from "../../state/drawing/palette";
import {
  chosenAnswers,
  edgeQuestionFacts,
  edgeQuestionTitle,
  isLineType,
  questionKey,
  suggestedType,
} from "../../state/drawing/questions";
import { useFormatLength, useFormatLineWidth } from "../../state/drawing/useFormatLength";
import { useEdges } from "../../state/queries";
import { useUiStore } from "../../state/store";
import { SHOW_EDGES } from "../shared/labels";
import panels from "../shared/panels.module.css";
import { Swatch } from "../shared/Swatch";
import { FollowingEdges } from "./FollowingEdges";
import { answerHandlers, previewHandlers } from "./previewHandlers";
import questionCss from "./questions.module.css";
import css from "./questionTable.module.css";

export function QuestionTable({ questions }: { questions: readonly Question[] }) {
  const busy = useUiStore((ui) => ui.busy);
  const refusal = useRefusal("PATCH /api/v1/drawings/{id}/edges");
  const [chosen, setChosen] = useState<ReadonlyMap<string, LineType | null>>(new Map());
  const answers = chosenAnswers(questions, chosen);
  return (
    <form
      className={css.table}
      onSubmit={(event) => {
        event.preventDefault();
        void retypeEach(answers);
      }}
    >
      <p className={questionCss.questionText}>{translate("questionTable.chooseALineTypeFor")}</p>
      <table className={css.rows} data-testid="question-table">
        <thead>
          <tr>
            <th scope="col">{translate("questionTable.layerAndEdges")}</th>
            <th scope="col">{translate("questionTable.lineType")}</th>
          </tr>
        </thead>
        <tbody>
          {questions.map((question) => {
            const key = questionKey(question);
            return (
              <Row
                key={key}
                question={question}
                value={chosen.get(key) ?? (chosen.has(key) ? null : suggestedType(question))}
                onChoose={(type) => setChosen(new Map(chosen).set(key, type))}
              />
            );
          })}
        </tbody>
      </table>
      <button
        type="submit"
        className={questionCss.choice}
        style={{ width: "100%", marginTop: 8 }}
        disabled={busy || refusal !== null || answers.length === 0}
        title={translate("questionTable.oneUndoTakesAllOf")}
        data-testid="set-table"
        {...previewHandlers(() => answers)}
      >
        {translate("questionTable.setTheChosenLineTypes")}
        <span className={questionCss.choiceFigure}>
          {translate("questionTable.ofRows", {
            answers: answers.length,
            questions: questions.length,
          })}
        </span>
      </button>
    </form>
  );
}

interface RowProps {
  question: Question;
  value: LineType | null;
  onChoose: (type: LineType | null) => void;
}

function Row({ question, value, onChoose }: RowProps) {
  const { data: edges } = useEdges();
  const busy = useUiStore((ui) => ui.busy);
  const refusal = useRefusal("PATCH /api/v1/drawings/{id}/edges");
  const zoomToEdges = useUiStore((ui) => ui.zoomToEdges);
  const length = useFormatLength();
  const lineWidth = useFormatLineWidth();
  const facts = useMemo(
    () => (edges === undefined ? null : summarizeEdges(edges, question.edges)),
    [edges, question],
  );
  const title = edgeQuestionTitle(question);
  const look = edgeQuestionFacts(
    question,
    facts?.linetypes ?? [],
    facts?.lineWidths.map(lineWidth) ?? [],
  );
  return (
    <tr
      data-testid="question-row"
      {...answerHandlers(question.edges, value ?? "unclassified", question.follows)}
    >
      <td>
        <button
          type="button"
          className={questionCss.questionShow}
          title={`${SHOW_EDGES}\n${messageText(question)}`}
          onClick={() => zoomToEdges(question.edges)}
        >
          <span className={css.name}>
            <span className={panels.dot} style={{ background: indexColour(question.colour) }} />
            <span className={questionCss.questionTitle}>{title}</span>
          </span>
          <span
            className={css.facts}
          >{`${translate("questionTable.edges", { edges: question.edges.length })}${facts !== null ? ` · ${length(facts.length)}` : ""}${look !== "" ? ` · ${look}` : ""}`}</span>
        </button>
        {question.follows?.map((following) => (
          <FollowingEdges key={questionKey(following)} following={following} />
        ))}
      </td>
      <td>
        <span className={css.answer}>
          <Swatch type={value ?? "unclassified"} />
          <select
            className={css.select}
            aria-label={translate("questionTable.lineTypeOfEdges", {
              title,
              edges: question.edges.length,
            })}
            value={value ?? ""}
            disabled={busy || refusal !== null}
            onChange={({ currentTarget }) =>
              onChoose(isLineType(currentTarget.value) ? currentTarget.value : null)
            }
          >
            <option value="">{translate("questionTable.choose")}</option>
            {question.choices.filter(isLineType).map((type) => (
              <option key={type} value={type}>
                {LINE_STYLES[type].title}
              </option>
            ))}
          </select>
        </span>
      </td>
    </tr>
  );
}
