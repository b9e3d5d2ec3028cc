/** Question for the unit of the drawing: sizes to choose from, the most likely first. */

import { Text } from "@mantine/core";
import type { Drawing, Question } from "../../api/drawings";
import { translate } from "../../language/translate";
import { messageText } from "../../messages/translateMessage";
import { unitQuestionText } from "../../state/drawing/questions";
import { isUnit } from "../../state/drawing/sizes";
import css from "../shared/panels.module.css";
import { UnitChoices } from "./UnitPanel";

interface Props {
  readonly question: Question;
  readonly drawing: Drawing;
  /** Called after an answer by keyboard, to move the focus to the next question. */
  readonly onAnswered: () => void;
}

export function UnitQuestion({ question, drawing, onAnswered }: Props) {
  return (
    <article className={css.callout} data-tone="open">
      <Text component="div" mb={4} c="ink.0" fw={600}>
        {translate("unitQuestion.whichUnitOfLengthDoes")}
      </Text>
      <Text mb={10} fz={12} c="ink.2" title={messageText(question)}>
        {unitQuestionText(question)}
      </Text>
      <UnitChoices
        drawing={drawing}
        units={question.choices.filter(isUnit)}
        onAnswered={onAnswered}
      />
    </article>
  );
}
