/**
 * Decides which conditions and alternatives of a schema apply. The server checks all values; ajv,
 * the usual validator of rjsf, compiles with `eval`, which the policy of the page forbids.
 */

import { type Schema, Validator } from "@cfworker/json-schema";
import type { RJSFSchema, ValidatorType } from "@rjsf/utils";
import type { Fields } from "../../state/library/definitions";
import type { FormContext } from "./DefinitionForm";

export const validator: ValidatorType<Fields, RJSFSchema, FormContext> = {
  isValid(schema, value, root) {
    const complete = { ...schema, $defs: root.$defs } as Schema;
    return new Validator(complete, "7", true).validate(withoutUndefined(value)).valid;
  },
  validateFormData: () => ({ errors: [], errorSchema: {} }),
  rawValidation: () => ({ errors: [] }),
};

/** A copy of a value without undefined fields, which the validator would refuse. */
const withoutUndefined = (value: unknown): unknown =>
  value === undefined ? null : JSON.parse(JSON.stringify(value));
