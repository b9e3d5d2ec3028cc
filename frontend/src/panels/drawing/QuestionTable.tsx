/** Many questions about line types as a table: one row for each, answered together. */

import { Flex, NativeSelect, Table, Text } from "@mantine/core";
import { useMemo, useState } from "react";
import type { Question } from "../../api/drawings";
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
import { Figure } from "../shared/parts";
import { Swatch } from "../shared/Swatch";
import { FollowingEdges } from "./FollowingEdges";
import { answerHandlers, previewHandlers } from "./previewHandlers";

export function QuestionTable({ questions }: { questions: readonly Question[] }) {
  const busy = useUiStore((ui) => ui.busy);
  const refusal = useRefusal("PATCH /api/v1/drawings/{id}/edges");
  const [chosen, setChosen] = useState<ReadonlyMap<string, LineType | null>>(new Map());
  const answers = chosenAnswers(questions, chosen);
  return (
    <form
      onSubmit={(event) => {
        event.preventDefault();
        void retypeEach(answers);
      }}
    >
      <Text mb={10} fz={12} c="ink.2">
        {translate("questionTable.chooseALineTypeFor")}
      </Text>
      <Table fz={12} horizontalSpacing={4} data-testid="question-table">
        <Table.Thead>
          <Table.Tr>
            <Table.Th scope="col">{translate("questionTable.layerAndEdges")}</Table.Th>
            <Table.Th scope="col">{translate("questionTable.lineType")}</Table.Th>
          </Table.Tr>
        </Table.Thead>
        <Table.Tbody>
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
        </Table.Tbody>
      </Table>
      <button
        type="submit"
        className={panels.choice}
        style={{ width: "100%", marginTop: 8 }}
        disabled={busy || refusal !== null || answers.length === 0}
        title={translate("questionTable.oneUndoTakesAllOf")}
        data-testid="set-table"
        {...previewHandlers(() => answers)}
      >
        {translate("questionTable.setTheChosenLineTypes")}
        <Figure ml="auto">
          {translate("questionTable.ofRows", {
            answers: answers.length,
            questions: questions.length,
          })}
        </Figure>
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
    <Table.Tr
      data-testid="question-row"
      {...answerHandlers(question.edges, value ?? "unclassified", question.follows)}
    >
      <Table.Td>
        <button
          type="button"
          className={panels.whole}
          title={`${SHOW_EDGES}\n${messageText(question)}`}
          onClick={() => zoomToEdges(question.edges)}
        >
          <Flex component="span" align="center" gap={8} c="ink.0" fw={600}>
            <span className={panels.dot} style={{ background: indexColour(question.colour) }} />
            <Text span flex={1} miw={0}>
              {title}
            </Text>
          </Flex>
          <Text
            span
            display="block"
            fz={11.5}
            c="ink.3"
          >{`${translate("questionTable.edges", { edges: question.edges.length })}${facts !== null ? ` · ${length(facts.length)}` : ""}${look !== "" ? ` · ${look}` : ""}`}</Text>
        </button>
        {question.follows?.map((following) => (
          <FollowingEdges key={questionKey(following)} following={following} />
        ))}
      </Table.Td>
      <Table.Td>
        <Flex component="span" align="center" gap={6}>
          <Swatch type={value ?? "unclassified"} />
          <NativeSelect
            size="xs"
            w={112}
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
          </NativeSelect>
        </Flex>
      </Table.Td>
    </Table.Tr>
  );
}
