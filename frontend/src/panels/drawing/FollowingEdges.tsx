/** Edges that an answer decides besides those that the question asks about. */

import { useMemo } from "react";
import type { FollowingEdges as Following } from "../../api/client";
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
import questionCss from "./questions.module.css";

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
      className={questionCss.questionShow}
      title={messageText(following)}
      data-testid="following-edges"
      onClick={() => zoomToEdges(following.edges)}
    >
      <span className={questionCss.questionText}>{translate("followingEdges.alsoDecided")}</span>
      <span className={questionCss.questionHead}>
        <span className={css.dot} style={{ background: indexColour(following.colour) }} />
        <span className={questionCss.questionTitle}>
          {edgeQuestionTitle({ kind: "line-type", layer: following.layer })}
        </span>
        <span
          className={css.rowFigure}
        >{`${translate("edgeQuestion.edges", { rows: following.edges.length })}${facts !== null ? ` · ${length(facts.length)}` : ""}`}</span>
      </span>
      {types.map((text) => (
        <span key={text} className={questionCss.questionFacts}>
          {text}
        </span>
      ))}
    </button>
  );
}
