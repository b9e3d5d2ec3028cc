/** Asks for the name of the operator, shows it, and changes it. */

import { Box, Button, Group, Text, TextInput } from "@mantine/core";
import { IconUser } from "@tabler/icons-react";
import { useId } from "react";
import { OPERATOR_LENGTH } from "../../api/operator";
import { translate } from "../../language/translate";
import { useOperator } from "../../state/accounts/operator";
import { Dialog } from "../shared/Dialog";
import css from "../shared/panels.module.css";
import { Note } from "../shared/parts";

/** The form for the name. It blocks nothing: without an answer, requests carry no name. */
export function OperatorForm() {
  const name = useOperator((operator) => operator.name);
  const keep = useOperator((operator) => operator.keep);
  const close = useOperator((operator) => operator.close);
  const note = useId();
  return (
    <Box
      component="form"
      p={12}
      className={css.section}
      bg="var(--raise-soft)"
      aria-label={translate("operatorForm.nameOfTheOperator")}
      action={(form) => keep(String(form.get("operator") ?? ""))}
      data-testid="operator-form"
    >
      <Group gap={8} align="flex-end">
        <TextInput
          flex="1 1 220px"
          styles={{ label: { color: "var(--ink-0)", fontSize: 14, fontWeight: 600 } }}
          size="md"
          label={translate("operatorForm.whoWorksAtThisDevice")}
          name="operator"
          defaultValue={name ?? ""}
          maxLength={OPERATOR_LENGTH}
          autoComplete="name"
          placeholder={translate("operatorForm.yourName")}
          aria-describedby={note}
          data-testid="operator-name"
        />

        <Button type="submit" mih={44} data-testid="operator-keep">
          {translate("operatorForm.save")}
        </Button>
        <Button variant="default" mih={44} onClick={close} data-testid="operator-close">
          {name === null ? translate("operatorForm.noName") : translate("operatorForm.cancel")}
        </Button>

        <Note id={note} flex="1 0 100%" visibleFrom="xs">
          {translate("operatorForm.recordedWithWhatYouConfirm")}
        </Note>
      </Group>
    </Box>
  );
}

/** The form, while the question is not answered on this device. */
export function AskOperator() {
  const asked = useOperator((operator) => operator.name !== null);
  return asked ? null : <OperatorForm />;
}

/** The form in a dialog, to change the name. */
export function OperatorDialog() {
  const changing = useOperator((operator) => operator.changing);
  const close = useOperator((operator) => operator.close);
  return (
    <Dialog opened={changing} onClose={close} title={translate("operatorForm.operator")} centered>
      <OperatorForm />
    </Dialog>
  );
}

/** The name, which is changed by a click; `compact` leaves it out on a phone. */
export function OperatorButton({ compact = false }: { compact?: boolean }) {
  const name = useOperator((operator) => operator.name);
  const change = useOperator((operator) => operator.change);
  return (
    <Button
      variant="subtle"
      color="gray"
      size="xs"
      px={8}
      mih={compact ? 34 : 44}
      fw={400}
      flex="0 1 auto"
      leftSection={<IconUser size={18} stroke={1.6} aria-hidden />}
      onClick={change}
      title={translate("operatorForm.changeTheNameOfThe")}
      data-testid="operator"
    >
      <Text
        span
        fz={compact ? 13 : 16}
        maw={160}
        truncate="end"
        {...(compact ? { visibleFrom: "xs" } : {})}
      >
        {name || translate("operatorForm.noName")}
      </Text>
    </Button>
  );
}
