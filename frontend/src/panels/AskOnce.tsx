/** A question with two large answers, in place of the button that raised it. */

import css from "./station.module.css";

interface Props {
  readonly title: string;
  readonly text: string;
  readonly yes: string;
  readonly no: string;
  readonly disabled?: boolean;
  onYes(): void;
  onNo(): void;
}

export function AskOnce({ title, text, yes, no, disabled = false, onYes, onNo }: Props) {
  return (
    <div className={css.question} role="alertdialog" aria-label={title}>
      <div className={css.questionTitle}>{title}</div>
      <div data-testid="question-text">{text}</div>
      <div className={css.answers}>
        <button type="button" className={css.button} onClick={onNo} data-testid="question-no">
          {no}
        </button>
        <button
          type="button"
          className={css.button}
          data-tone="red"
          disabled={disabled}
          onClick={onYes}
          data-testid="question-yes"
        >
          {yes}
        </button>
      </div>
    </div>
  );
}
