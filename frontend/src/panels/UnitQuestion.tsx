/** Question for the unit of the drawing: sizes to choose from, the most likely first. */

import type { Drawing, Question } from "../api/client";
import { isUnit } from "../state/sizes";
import questionCss from "./questions.module.css";
import { UnitChoices } from "./UnitPanel";

export function UnitQuestion({ question, drawing }: { question: Question; drawing: Drawing }) {
  // The sizes that the rest of it lists stand on the answers, with what speaks for them.
  const [why = ""] = /^.*?\.(?=\s|$)/.exec(question.text) ?? [question.text];
  return (
    <article className={questionCss.question}>
      <div className={questionCss.questionHead}>What size is the drawing?</div>
      <p className={questionCss.questionText} title={question.text}>
        {why}
      </p>
      <UnitChoices drawing={drawing} units={question.choices.filter(isUnit)} />
    </article>
  );
}
