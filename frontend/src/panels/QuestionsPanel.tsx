/** What somebody must decide before anything is cut; each in one click. */

import { IconHelpHexagonFilled } from "@tabler/icons-react";
import type { Drawing, Question, Unit } from "../api/client";
import { LINE_TYPES, type LineType } from "../geometry/records";
import { retype, settle } from "../state/actions";
import { indexColour } from "../state/colours";
import { LINE_LOOKS } from "../state/palette";
import { useDrawing, useEdges, useJob } from "../state/queries";
import { rowsOfLayer } from "../state/rows";
import { usePage } from "../state/store";
import { count, size } from "../state/words";
import css from "./panels.module.css";
import { Section } from "./Section";
import { Swatch } from "./Swatch";

const UNITS: Readonly<Record<Unit, { title: string; mm: number }>> = {
  mm: { title: "Millimetres", mm: 1 },
  cm: { title: "Centimetres", mm: 10 },
  m: { title: "Metres", mm: 1000 },
  in: { title: "Inches", mm: 25.4 },
  ft: { title: "Feet", mm: 304.8 },
};

const isUnit = (word: string): word is Unit => word in UNITS;
const isLineType = (word: string): word is LineType =>
  LINE_TYPES.some((type) => type === word) && word !== "unclassified";

export function QuestionsPanel() {
  const { data: drawing } = useDrawing();
  const { data: job } = useJob();
  const asked = usePage((page) => page.asked);
  if (drawing === undefined) return null;
  const questions = new Map<string, Question>();
  for (const question of [...drawing.questions, ...asked, ...(job?.questions ?? [])]) {
    questions.set(question.text, question);
  }
  if (questions.size === 0) return null;
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
        {[...questions].map(([text, question]) =>
          question.kind === "unit" ? (
            <UnitQuestion key={text} question={question} drawing={drawing} />
          ) : (
            <EdgeQuestion key={text} question={question} />
          ),
        )}
      </div>
    </Section>
  );
}

function UnitQuestion({ question, drawing }: { question: Question; drawing: Drawing }) {
  const busy = usePage((page) => page.busy);
  return (
    <article className={css.question}>
      <div className={css.questionHead}>What unit is this drawn in?</div>
      <p className={css.questionText}>{question.text}</p>
      <div className={css.choices}>
        {question.choices.filter(isUnit).map((unit) => (
          <button
            key={unit}
            type="button"
            className={`${css.choice} ${css.choiceWide}`}
            disabled={busy}
            data-testid={`unit-${unit}`}
            onClick={() => void settle({ unit })}
          >
            {UNITS[unit].title}
            <span className={css.choiceFigure}>
              {size(drawing.width * UNITS[unit].mm, drawing.height * UNITS[unit].mm)}
            </span>
          </button>
        ))}
      </div>
    </article>
  );
}

function EdgeQuestion({ question }: { question: Question }) {
  const { data: edges } = useEdges();
  const busy = usePage((page) => page.busy);
  const look = usePage((page) => page.look);
  const rows =
    question.edges.length > 0 || edges === undefined
      ? question.edges
      : rowsOfLayer(edges, question.layer, question.colour);
  const choices = question.choices.filter(isLineType);
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
      <p className={css.questionText}>{question.text}</p>
      <div className={css.choices}>
        {choices.map((type, at) => (
          <button
            key={type}
            type="button"
            className={css.choice}
            disabled={busy}
            data-testid={`answer-${type}`}
            data-likely={at === 0}
            title={at === 0 ? "The most plausible answer" : undefined}
            onClick={() => void retype(rows, type)}
          >
            <Swatch type={type} />
            {LINE_LOOKS[type].title}
          </button>
        ))}
      </div>
    </article>
  );
}
