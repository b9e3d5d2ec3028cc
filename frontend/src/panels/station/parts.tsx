/** Parts of the station page that are large enough for a finger. */

import { Button, Fieldset, SegmentedControl, Stack } from "@mantine/core";
import type { ReactNode } from "react";
import css from "./station.module.css";

/** A button beside others. */
export const WideButton = Button.withProps({
  variant: "default",
  size: "md",
  mih: 52,
  fz: 18,
  radius: 12,
  fullWidth: true,
});

/** A group of controls with a title. */
export const ControlGroup = Fieldset.withProps({
  variant: "unstyled",
  styles: { legend: { marginBottom: 6, color: "var(--ink-2)", fontSize: 16, fontWeight: 600 } },
});

interface NotedProps {
  /** What the button does, or why it is disabled. */
  readonly note: ReactNode;
  readonly children: ReactNode;
}

/** A button and the note below it. */
export function NotedButton({ note, children }: NotedProps) {
  return (
    <Stack gap={4} justify="flex-start">
      {children}
      <small>{note}</small>
    </Stack>
  );
}

interface StepsProps<Value extends string | number> {
  readonly title: ReactNode;
  /** Values with their labels, and the start of the ids by which tests find them. */
  readonly data: readonly { readonly value: Value; readonly label: string }[];
  readonly testId: string;
  readonly value: Value | undefined;
  readonly onChange: (value: Value) => void;
}

/** Choice of one of a few values. */
export function Steps<Value extends string | number>(props: StepsProps<Value>) {
  const { title, data, testId, value, onChange } = props;
  return (
    <ControlGroup legend={title}>
      <SegmentedControl
        className={css.steps ?? ""}
        size="lg"
        fullWidth
        radius={12}
        data={data.map(({ value, label }) => ({
          value: String(value),
          label: <span data-testid={`${testId}-${value}`}>{label}</span>,
        }))}
        value={String(value)}
        onChange={(word) => {
          const chosen = data.find((one) => String(one.value) === word);
          if (chosen !== undefined) onChange(chosen.value);
        }}
      />
    </ControlGroup>
  );
}
