/** What the form of a carton needs: its schema in groups, and the fields that an error names. */

import type { ErrorSchema, RJSFSchema } from "@rjsf/utils";
import type { CartonStyle } from "../../api/cartons";
import { ServiceError } from "../../api/errors";
import { translate } from "../../language/translate";
import { errorText } from "../../messages/translateMessage";
import { formSchema } from "../../state/library/formSchema";

const DIMENSIONS: ReadonlySet<string> = new Set(["length", "width", "depth"]);

/** The schema of the parameters of a style, with a group for dimensions and one for options. */
export function cartonSchema({ parameters }: CartonStyle): RJSFSchema {
  const schema = formSchema(parameters);
  const properties = Object.entries(schema.properties ?? {}).map(([name, field]) => [
    name,
    {
      ...(field as object),
      group: DIMENSIONS.has(name)
        ? translate("cartonPage.innerDimensions")
        : translate("cartonPage.options"),
    },
  ]);
  return { ...schema, properties: Object.fromEntries(properties) };
}

/** The text of an error at the field that it names; {} if it names none. */
export function fieldFaults(error: unknown, { parameters }: CartonStyle): ErrorSchema {
  if (!(error instanceof ServiceError)) return {};
  const known = (parameters as RJSFSchema).properties ?? {};
  const name = error.problem.source[0]?.split(".").at(-1);
  if (name === undefined || !(name in known)) return {};
  return { [name]: { __errors: [errorText(error)] } } as ErrorSchema;
}
