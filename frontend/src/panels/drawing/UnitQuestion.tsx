/** Question for the unit of the drawing: sizes to choose from, the most likely first. */

import { Text } from "@mantine/core";
import type { Drawing, Question } from "../../api/client";
import { translate } from "../../language/translate";
import { messageText } from "../../messages/translateMessage";
import { unitQuestionText } from "../../state/drawing/questions";
import { isUnit } from "../../state/drawing/sizes";
import css from "../shared/panels.module.css";
import { UnitChoices } from "./UnitPanel";

export function UnitQuestion({ question, drawing }: { question: Question; drawing: Drawing }) {
  return (
    <article className={css.callout} data-tone="open">
      <Text component="div" mb={4} c="ink.0" fw={600}>
        {translate("unitQuestion.whichUnitOfLengthDoes")}
      </Text>
      <Text mb={10} fz={12} c="ink.2" title={messageText(question)}>
        {unitQuestionText(question)}
      </Text>
      <UnitChoices drawing={drawing} units={question.choices.filter(isUnit)} />
    </article>
  );
}
