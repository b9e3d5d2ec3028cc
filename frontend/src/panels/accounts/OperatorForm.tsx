/** Asks for the name of the operator, shows it, and changes it. */

import { Modal } from "@mantine/core";
import { IconUser } from "@tabler/icons-react";
import { useId } from "react";
import { OPERATOR_LENGTH } from "../../api/operator";
import { translate } from "../../language/translate";
import { useOperator } from "../../state/accounts/operator";
import css from "./operator.module.css";

/** The form for the name. It blocks nothing: without an answer, requests carry no name. */
export function OperatorForm() {
  const name = useOperator((operator) => operator.name);
  const keep = useOperator((operator) => operator.keep);
  const close = useOperator((operator) => operator.close);
  const note = useId();
  return (
    <form
      className={css.form}
      aria-label={translate("operatorForm.nameOfTheOperator")}
      action={(form) => keep(String(form.get("operator") ?? ""))}
      data-testid="operator-form"
    >
      <label className={css.label}>
        {translate("operatorForm.whoWorksAtThisDevice")}
        <input
          className={css.input}
          name="operator"
          defaultValue={name ?? ""}
          maxLength={OPERATOR_LENGTH}
          autoComplete="name"
          placeholder={translate("operatorForm.yourName")}
          aria-describedby={note}
          data-testid="operator-name"
        />
      </label>
      <div className={css.answers}>
        <button type="submit" className={css.yes} data-testid="operator-keep">
          {translate("operatorForm.save")}
        </button>
        <button type="button" className={css.no} onClick={close} data-testid="operator-close">
          {name === null ? translate("operatorForm.noName") : translate("operatorForm.cancel")}
        </button>
      </div>
      <p className={css.note} id={note}>
        {translate("operatorForm.recordedWithWhatYouConfirm")}
      </p>
    </form>
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
    <Modal opened={changing} onClose={close} title={translate("operatorForm.operator")} centered>
      <OperatorForm />
    </Modal>
  );
}

/** The name, which is changed by a click. */
export function OperatorButton({ className = "" }: { className?: string }) {
  const name = useOperator((operator) => operator.name);
  const change = useOperator((operator) => operator.change);
  return (
    <button
      type="button"
      className={`${css.button} ${className}`}
      onClick={change}
      title={translate("operatorForm.changeTheNameOfThe")}
      data-testid="operator"
    >
      <IconUser size={18} stroke={1.6} aria-hidden />
      <span className={css.name}>{name || translate("operatorForm.noName")}</span>
    </button>
  );
}
