/** Question for the unit of the drawing: sizes to choose from, the most likely first. */

import type { Drawing, Question } from "../api/client";
import { renderText } from "../messages/render";
import { unitQuestionText } from "../state/questions";
import { isUnit } from "../state/sizes";
import questionCss from "./questions.module.css";
import { UnitChoices } from "./UnitPanel";

export function UnitQuestion({ question, drawing }: { question: Question; drawing: Drawing }) {
  return (
    <article className={questionCss.question}>
      <div className={questionCss.questionHead}>Which unit of length does the file use?</div>
      <p className={questionCss.questionText} title={renderText(question)}>
        {unitQuestionText(question)}
      </p>
      <UnitChoices drawing={drawing} units={question.choices.filter(isUnit)} />
    </article>
  );
}
