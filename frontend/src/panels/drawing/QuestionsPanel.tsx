/** Open questions, one at a time and zoomed to; a program needs the answers to all. */

import { ActionIcon, Group, Stack } from "@mantine/core";
import { IconChevronLeft, IconChevronRight, IconHelpHexagonFilled } from "@tabler/icons-react";
import { type ReactNode, useEffect, useRef } from "react";
import { translate } from "../../language/translate";
import { useRefusal } from "../../state/accounts/accounts";
import { retypeEach } from "../../state/actions";
import { focusMainAction } from "../../state/commands/mainAction";
import { useAsked } from "../../state/drawing/asked";
import { LINE_STYLES } from "../../state/drawing/palette";
import { suggestions } from "../../state/drawing/questions";
import { useOpenQuestions } from "../../state/drawing/useSteps";
import { useDrawing } from "../../state/queries";
import { type RetypePreview, useUiStore } from "../../state/store";
import { Refusal } from "../accounts/Permitted";
import css from "../shared/panels.module.css";
import { Figure } from "../shared/parts";
import { Section } from "../shared/Section";
import { Swatch } from "../shared/Swatch";
import { EdgeQuestion } from "./EdgeQuestion";
import { previewHandlers } from "./previewHandlers";
import { QuestionTable } from "./QuestionTable";
import { AllAnswered, Settled, useSettled } from "./SettledQuestions";
import { UnitQuestion } from "./UnitQuestion";

/** With more questions, a button answers all at once. */
const FEW = 3;
/** With more questions about line types, they are also the rows of a table. */
const CARDS = 5;

export function QuestionsPanel() {
  const { data: drawing } = useDrawing();
  const questions = useOpenQuestions();
  const refusal = useRefusal("PATCH /api/v1/drawings/{id}/edges");
  const wanted = useAsked((asked) => asked.at);
  const turn = useAsked((asked) => asked.turn);
  const settled = useSettled(questions);
  const list = useRef<HTMLDivElement>(null);
  const at = Math.min(wanted, questions.length - 1);
  const [key, question] = questions[at] ?? ["", undefined];
  useZoomTo(key, question?.edges ?? []);
  if (drawing === undefined) return null;
  if (question === undefined)
    return settled.length === 0 ? null : <AllAnswered settled={settled} />;
  const lineTypeQuestions = questions
    .map(([, one]) => one)
    .filter(({ kind }) => kind === "line-type");
  const suggested = suggestions(lineTypeQuestions);
  const undecided = lineTypeQuestions.flatMap(({ edges }) => edges);
  // The next question is enabled one frame later.
  const focusNextAnswer = () =>
    requestAnimationFrame(() => {
      const next = list.current?.querySelector<HTMLElement>("[data-answer]");
      if (next) next.focus();
      else focusMainAction();
    });
  return (
    <Section
      title={
        <>
          <IconHelpHexagonFilled size={15} color={LINE_STYLES.unclassified.colour} aria-hidden />
          {translate("questionsPanel.openQuestions", { questions: questions.length })}
        </>
      }
    >
      <Stack ref={list} gap={8} data-testid="questions">
        {questions.length > 1 && (
          <Group gap={4} justify="space-between">
            <Turn label={translate("questionsPanel.previousKey")} act={() => turn(-1)}>
              <IconChevronLeft size={17} />
            </Turn>
            <Figure aria-live="polite">
              {translate("questionsPanel.questionOf", { at: at + 1, all: questions.length })}
            </Figure>
            <Turn
              label={translate("questionsPanel.nextKey")}
              act={() => turn(1)}
              testId="next-question"
            >
              <IconChevronRight size={17} />
            </Turn>
          </Group>
        )}
        {settled.length > 0 && <Settled count={settled.length} />}
        {question.kind === "unit" ? (
          <UnitQuestion
            key={key}
            question={question}
            drawing={drawing}
            onAnswered={focusNextAnswer}
          />
        ) : (
          <EdgeQuestion key={key} question={question} onAnswered={focusNextAnswer} />
        )}
        <Refusal reason={refusal} />
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
        {lineTypeQuestions.length > CARDS && (
          <details data-testid="all-questions">
            <summary className={css.summary}>{translate("questionsPanel.allInATable")}</summary>
            <QuestionTable questions={lineTypeQuestions} />
          </details>
        )}
      </Stack>
    </Section>
  );
}

/** Select the edges of a question and zoom to them when it is asked. */
function useZoomTo(key: string, rows: readonly number[]): void {
  const { data: drawing } = useDrawing();
  const known = drawing !== undefined;
  // biome-ignore lint/correctness/useExhaustiveDependencies: once per question
  useEffect(() => {
    if (!known || key === "" || rows.length === 0) return;
    // The picture is fitted to the drawing first.
    const timer = setTimeout(() => useUiStore.getState().zoomToEdges(rows), 350);
    return () => clearTimeout(timer);
  }, [key, known]);
}

interface TurnProps {
  readonly label: string;
  readonly act: () => void;
  readonly testId?: string;
  readonly children: ReactNode;
}

function Turn({ label, act, testId, children }: TurnProps) {
  return (
    <ActionIcon
      variant="default"
      size={32}
      aria-label={label}
      title={label}
      onClick={act}
      data-testid={testId}
    >
      {children}
    </ActionIcon>
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
