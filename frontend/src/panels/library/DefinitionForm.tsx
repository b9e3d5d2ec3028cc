/** Form for the fields of a machine, a board or a tool: made by rjsf from their JSON Schema. */

// The index of the package also imports ajv, which the page must not have.
import Form from "@rjsf/core/lib/components/Form.js";
import type { ErrorSchema, RJSFSchema } from "@rjsf/utils";
import type { ReactNode } from "react";
import type { Fields } from "../../state/library/definitions";
import { fields as formFields, templates, widgets } from "./formTemplates";
import { validator } from "./formValidator";

/** What the templates of the form need besides the field that they show. */
export interface FormContext {
  /** Sets the value at a path, such as that of a tool in a station. */
  readonly setAt: (path: readonly (string | number)[], value: unknown) => void;
  /** Further content of the group of a field, by the name of the field. */
  readonly after: Readonly<Record<string, ReactNode>>;
  readonly readOnly: boolean;
}

interface Props extends FormContext {
  readonly schema: RJSFSchema;
  readonly fields: Fields;
  readonly faults: ErrorSchema;
}

export function DefinitionForm({ schema, fields, faults, ...context }: Props) {
  return (
    <Form<Fields, RJSFSchema, FormContext>
      tagName="div"
      schema={schema}
      uiSchema={UI}
      formData={fields}
      formContext={context}
      validator={validator}
      extraErrors={faults as ErrorSchema<Fields>}
      templates={templates}
      widgets={widgets}
      fields={formFields}
      readonly={context.readOnly}
      showErrorList={false}
      noValidate
      experimental_defaultFormStateBehavior={NO_DEFAULTS}
    />
  );
}

/** A table that is not required is added and removed; lists have no buttons for their order. */
const UI = {
  // The page has a button of its own.
  "ui:submitButtonOptions": { norender: true },
  "ui:globalOptions": { enableOptionalDataFieldForType: ["object" as const], orderable: false },
};

/** A default is shown but not stored, so that a file keeps to what a person has chosen. */
const NO_DEFAULTS = {
  emptyObjectFields: "skipDefaults",
  allOf: "skipDefaults",
  arrayMinItems: { populate: "never" },
} as const;
