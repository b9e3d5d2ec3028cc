/** Question for the unit of the drawing: sizes to choose from, the most likely first. */

import type { Drawing, Question } from "../../api/client";
import { translate } from "../../language/translate";
import { messageText } from "../../messages/translateMessage";
import { unitQuestionText } from "../../state/drawing/questions";
import { isUnit } from "../../state/drawing/sizes";
import questionCss from "./questions.module.css";
import { UnitChoices } from "./UnitPanel";

export function UnitQuestion({ question, drawing }: { question: Question; drawing: Drawing }) {
  return (
    <article className={questionCss.question}>
      <div className={questionCss.questionHead}>
        {translate("unitQuestion.whichUnitOfLengthDoes")}
      </div>
      <p className={questionCss.questionText} title={messageText(question)}>
        {unitQuestionText(question)}
      </p>
      <UnitChoices drawing={drawing} units={question.choices.filter(isUnit)} />
    </article>
  );
}
