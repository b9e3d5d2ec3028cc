/** What somebody must decide before anything is cut; each in one click. */

import { IconHelpHexagonFilled } from "@tabler/icons-react";
import { useState } from "react";
import type { Question } from "../api/client";
import { LINE_TYPES, type LineType } from "../geometry/records";
import { retype } from "../state/actions";
import { indexColour } from "../state/colours";
import { LINE_LOOKS } from "../state/palette";
import { useDrawing, useEdges, useJob } from "../state/queries";
import { rowsOfLayer } from "../state/rows";
import { usePage } from "../state/store";
import { count } from "../state/words";
import css from "./panels.module.css";
import { Section } from "./Section";
import { ShowMore } from "./ShowMore";
import { Swatch } from "./Swatch";
import { UnitQuestion } from "./UnitQuestion";

const isLineType = (word: string): word is LineType =>
  LINE_TYPES.some((type) => type === word) && word !== "unclassified";

/** Questions that come at once. */
const STEP = 6;
/** Up to so many, each is answered by itself. */
const FEW = 3;

export function QuestionsPanel() {
  const { data: drawing } = useDrawing();
  const { data: job } = useJob();
  const asked = usePage((page) => page.asked);
  const [most, setMost] = useState(STEP);
  if (drawing === undefined) return null;
  const questions = new Map<string, Question>();
  for (const question of [...drawing.questions, ...asked, ...(job?.questions ?? [])]) {
    questions.set(question.text, question);
  }
  if (questions.size === 0) return null;
  const listed = [...questions];
  const lines = listed.map(([, question]) => question).filter(({ kind }) => kind === "line-type");
  return (
    <Section
      title={
        <>
          <IconHelpHexagonFilled size={15} color={LINE_LOOKS.unclassified.colour} aria-hidden />
          {count(questions.size, "open question")}
        </>
      }
    >
      <div data-testid="questions">
        {lines.length > FEW && <TheRest questions={lines} />}
        {listed
          .slice(0, most)
          .map(([text, question]) =>
            question.kind === "unit" ? (
              <UnitQuestion key={text} question={question} drawing={drawing} />
            ) : (
              <EdgeQuestion key={text} question={question} />
            ),
          )}
        {listed.length > most && (
          <ShowMore left={listed.length - most} act={() => setMost(most + STEP)} />
        )}
      </div>
    </Section>
  );
}

/** One answer to all: much of a messy sheet is of no concern to the machine. */
function TheRest({ questions }: { questions: readonly Question[] }) {
  const busy = usePage((page) => page.busy);
  const set = usePage((page) => page.set);
  const rows = questions.flatMap(({ edges }) => edges);
  return (
    <button
      type="button"
      className={css.choice}
      style={{ width: "100%", marginBottom: 8 }}
      disabled={busy}
      data-testid="ignore-rest"
      onMouseEnter={() => set({ proposed: [{ rows, type: "ignored" }] })}
      onMouseLeave={() => set({ proposed: [] })}
      onClick={() => void retype(rows, "ignored")}
    >
      <Swatch type="ignored" />
      Ignore whatever is not decided
      <span className={css.choiceFigure}>{count(rows.length, "edge")}</span>
    </button>
  );
}

/** What is asked, and what speaks for the likeliest answer. */
function partsOf(text: string): readonly [string, string] {
  const at = text.indexOf("Most likely ");
  return at < 0 ? [text, ""] : [text.slice(0, at).trim(), text.slice(at)];
}

function EdgeQuestion({ question }: { question: Question }) {
  const { data: edges } = useEdges();
  const busy = usePage((page) => page.busy);
  const look = usePage((page) => page.look);
  const set = usePage((page) => page.set);
  const rows =
    question.edges.length > 0 || edges === undefined
      ? question.edges
      : rowsOfLayer(edges, question.layer, question.colour);
  const choices = question.choices.filter(isLineType);
  const [asks, evidence] = partsOf(question.text);
  return (
    <article className={css.question} data-testid="question">
      <button
        type="button"
        className={css.rowMain}
        style={{ height: "auto" }}
        title="Show these edges"
        onClick={() => look(rows)}
      >
        <span className={css.questionHead}>
          <span className={css.dot} style={{ background: indexColour(question.colour) }} />
          {question.layer === "" ? "These edges" : `Layer ${question.layer}`}
        </span>
        <span className={css.rowFigure} style={{ marginLeft: "auto", marginBottom: 4 }}>
          {count(rows.length, "edge")}
        </span>
      </button>
      <p className={css.questionText}>{asks}</p>
      {evidence !== "" && (
        <p className={css.questionText} style={{ color: "var(--ink-0)" }}>
          {evidence}
        </p>
      )}
      <div className={css.choices}>
        {choices.map((type, at) => (
          <button
            key={type}
            type="button"
            className={`${css.choice} ${at === 0 ? css.choiceWide : ""}`}
            disabled={busy}
            data-testid={`answer-${type}`}
            data-likely={at === 0}
            title={at === 0 ? "The most plausible answer" : undefined}
            onMouseEnter={() => set({ proposed: [{ rows, type }] })}
            onMouseLeave={() => set({ proposed: [] })}
            onClick={() => void retype(rows, type)}
          >
            <Swatch type={type} />
            {LINE_LOOKS[type].title}
            {at === 0 && <span className={css.choiceFigure}>likeliest</span>}
          </button>
        ))}
      </div>
    </article>
  );
}
