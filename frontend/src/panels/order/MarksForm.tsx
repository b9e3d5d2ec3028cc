/** Marks of a printed sheet: centres of circles and crosses that the designer selects. */

import { ActionIcon, Button, Checkbox, Group, Stack, Text } from "@mantine/core";
import { IconHandClick, IconX } from "@tabler/icons-react";
import { useEffect, useState } from "react";
import type { Registration } from "../../api/jobs";
import { formatFixed } from "../../language/numbers";
import { translate } from "../../language/translate";
import { marksOf, NO_MARKS, stopPicking, useMarkPicking, withMarks } from "../../state/order/marks";
import { useEdges } from "../../state/queries";
import { useUiStore } from "../../state/store";
import { Note } from "../shared/parts";

const CLICK_FAULTS = {
  none: translate("marksForm.noPoint"),
  close: translate("marksForm.close"),
};

export function MarksForm() {
  const { data: edges } = useEdges();
  const selection = useUiStore((ui) => ui.selection);
  const registration = useUiStore((ui) => ui.registration) ?? NO_MARKS;
  const set = useUiStore((ui) => ui.set);
  const [fault, setFault] = useState<string | null>(null);
  const { active, fault: clicked } = useMarkPicking();
  const drawing = useUiStore((ui) => ui.drawing);
  // biome-ignore lint/correctness/useExhaustiveDependencies: another drawing ends the clicking
  useEffect(() => stopPicking, [drawing]);
  const { marks } = registration;
  const change = (changed: Registration["marks"]) =>
    set({ registration: changed.length === 0 ? null : { ...registration, marks: changed } });
  const take = () => {
    if (edges === undefined) return;
    const found = marksOf(edges, selection);
    const next = withMarks(marks, found);
    if (found.length === 0) setFault(translate("marksForm.none"));
    else setFault(next.close ? translate("marksForm.close") : null);
    change(next.marks);
  };
  return (
    <Stack gap={6} data-testid="marks-form">
      <Text fw={500} size="sm">
        {translate("marksForm.marks")}
      </Text>
      <Note>{translate("marksForm.note")}</Note>
      {marks.map(([x, y], at) => (
        <Group key={`${x} ${y}`} justify="space-between" wrap="nowrap" data-testid="mark">
          <Text size="sm">
            {translate("marksForm.mark", {
              number: at + 1,
              x: formatFixed(x, 1),
              y: formatFixed(y, 1),
            })}
          </Text>
          <ActionIcon
            variant="subtle"
            aria-label={translate("marksForm.remove", { number: at + 1 })}
            onClick={() => change(marks.filter((_, other) => other !== at))}
          >
            <IconX size={16} aria-hidden />
          </ActionIcon>
        </Group>
      ))}
      <Button
        variant={active ? "light" : "default"}
        leftSection={<IconHandClick size={15} aria-hidden />}
        aria-pressed={active}
        disabled={edges === undefined}
        onClick={() => (active ? stopPicking() : useMarkPicking.setState({ active: true }))}
        data-testid="marks-pick"
      >
        {active ? translate("marksForm.finish") : translate("marksForm.pick")}
      </Button>
      <Button
        variant="default"
        disabled={selection.size === 0 || edges === undefined}
        onClick={take}
        data-testid="marks-take"
      >
        {translate("marksForm.take")}
      </Button>
      {marks.length > 0 && (
        <Checkbox
          label={translate("marksForm.keep")}
          checked={registration.scale === "keep"}
          onChange={({ currentTarget }) =>
            set({
              registration: { ...registration, scale: currentTarget.checked ? "keep" : "fit" },
            })
          }
        />
      )}
      {active && clicked !== null && <Note role="alert">{CLICK_FAULTS[clicked]}</Note>}
      {(fault !== null || marks.length === 1) && (
        <Note role="alert">{fault ?? translate("marksForm.one")}</Note>
      )}
    </Stack>
  );
}
