/** Open questions, each answered with one click; a program needs the answers to all. */

import { Stack } from "@mantine/core";
import { IconHelpHexagonFilled } from "@tabler/icons-react";
import { useRef, useState } from "react";
import type { Question } from "../../api/client";
import { translate } from "../../language/translate";
import { useRefusal } from "../../state/accounts/accounts";
import { retypeEach } from "../../state/actions";
import { LINE_STYLES } from "../../state/drawing/palette";
import { questionKey, suggestions } from "../../state/drawing/questions";
import { useDrawing, useJob } from "../../state/queries";
import { type RetypePreview, useUiStore } from "../../state/store";
import { Refusal } from "../accounts/Permitted";
import css from "../shared/panels.module.css";
import { Figure } from "../shared/parts";
import { Section } from "../shared/Section";
import { ShowMore } from "../shared/ShowMore";
import { Swatch } from "../shared/Swatch";
import { EdgeQuestion } from "./EdgeQuestion";
import { previewHandlers } from "./previewHandlers";
import { QuestionTable } from "./QuestionTable";
import { UnitQuestion } from "./UnitQuestion";

/** Questions listed at once. */
const STEP = 4;
/** With more questions, a button answers all at once. */
const FEW = 3;
/** With more questions about line types, they are the rows of a table. */
const CARDS = 5;

export function QuestionsPanel() {
  const { data: drawing } = useDrawing();
  const { data: job } = useJob();
  const compileQuestions = useUiStore((ui) => ui.compileQuestions);
  const refusal = useRefusal("PATCH /api/v1/drawings/{id}/edges");
  const [limit, setLimit] = useState(STEP);
  const list = useRef<HTMLDivElement>(null);
  if (drawing === undefined) return null;
  const questions = new Map<string, Question>();
  for (const question of [...drawing.questions, ...compileQuestions, ...(job?.questions ?? [])]) {
    questions.set(questionKey(question), question);
  }
  if (questions.size === 0) return null;
  const all = [...questions];
  const lineTypeQuestions = all
    .map(([, question]) => question)
    .filter(({ kind }) => kind === "line-type");
  const suggested = suggestions(lineTypeQuestions);
  const asTable = lineTypeQuestions.length > CARDS;
  const listed = asTable ? all.filter(([, { kind }]) => kind !== "line-type") : all;
  const undecided = lineTypeQuestions.flatMap(({ edges }) => edges);
  // The next question is enabled one frame later.
  const focusNextAnswer = () =>
    requestAnimationFrame(() => list.current?.querySelector<HTMLElement>("[data-answer]")?.focus());
  return (
    <Section
      title={
        <>
          <IconHelpHexagonFilled size={15} color={LINE_STYLES.unclassified.colour} aria-hidden />
          {translate("questionsPanel.openQuestions", { questions: questions.size })}
        </>
      }
    >
      <Stack ref={list} gap={8} data-testid="questions">
        {listed
          .slice(0, limit)
          .map(([key, question]) =>
            question.kind === "unit" ? (
              <UnitQuestion key={key} question={question} drawing={drawing} />
            ) : (
              <EdgeQuestion key={key} question={question} onAnswered={focusNextAnswer} />
            ),
          )}
        {asTable && <QuestionTable questions={lineTypeQuestions} />}
        <Refusal reason={refusal} />
        {listed.length > limit && (
          <ShowMore left={listed.length - limit} act={() => setLimit(limit + STEP)} />
        )}
        {suggested.length > 1 && (
          <SetMany
            retypings={suggested}
            title={translate("questionsPanel.oneUndoTakesAllOf")}
            figure={translate("questionsPanel.questions", { suggested: suggested.length })}
            name="accept-suggestions"
          >
            {translate("questionsPanel.acceptAllMostLikelyLine")}
          </SetMany>
        )}
        {lineTypeQuestions.length > FEW && (
          <SetMany
            retypings={[{ rows: undecided, type: "ignored" }]}
            title={translate("questionsPanel.theEdgesStayVisibleIn")}
            figure={translate("questionsPanel.edges", { undecided: undecided.length })}
            name="ignore-rest"
          >
            {translate("questionsPanel.setAllUndecidedEdgesTo")}
          </SetMany>
        )}
      </Stack>
    </Section>
  );
}

/** Sets the line types of many edges; one undo takes all of them back. */
function SetMany({
  retypings,
  title,
  figure,
  name,
  children,
}: {
  retypings: readonly RetypePreview[];
  title: string;
  figure: string;
  name: string;
  children: string;
}) {
  const busy = useUiStore((ui) => ui.busy);
  const refusal = useRefusal("PATCH /api/v1/drawings/{id}/edges");
  return (
    <button
      type="button"
      className={css.choice}
      style={{ width: "100%" }}
      disabled={busy || refusal !== null}
      title={title}
      data-testid={name}
      {...previewHandlers(() => retypings)}
      onClick={() => void retypeEach(retypings)}
    >
      <Swatch type={retypings[0]?.type ?? "unclassified"} />
      {children}
      <Figure ml="auto">{figure}</Figure>
    </button>
  );
}
