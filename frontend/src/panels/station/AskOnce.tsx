/**
 * A question with two large buttons, in place of the button that opened it.
 *
 * The buttons are enabled after a short time, so that a double tap does not press one of them.
 */

import { SimpleGrid, Stack, Text } from "@mantine/core";
import { useEffect, useState } from "react";
import { WideButton } from "./parts";
import css from "./station.module.css";

/** Time (ms) for which the buttons are disabled: the longest interval of a double tap. */
const SECOND_TAP = 400;

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
  const [open, setOpen] = useState(false);
  useEffect(() => {
    const timer = setTimeout(() => setOpen(true), SECOND_TAP);
    return () => clearTimeout(timer);
  }, []);
  return (
    <Stack gap={10} className={css.question} role="alertdialog" aria-label={title}>
      <Text component="div" c="ink.0" fz={21} fw={700}>
        {title}
      </Text>
      <div data-testid="question-text">{text}</div>
      <SimpleGrid cols={2} spacing={12}>
        <WideButton disabled={!open} onClick={onNo} data-testid="question-no">
          {no}
        </WideButton>
        <WideButton
          variant="filled"
          color="red"
          disabled={disabled || !open}
          onClick={onYes}
          data-testid="question-yes"
        >
          {yes}
        </WideButton>
      </SimpleGrid>
    </Stack>
  );
}
