/** Form for the fields of a machine, a board or a tool, made from their JSON Schema. */

import { Button, Checkbox, NumberInput, Select, TextInput } from "@mantine/core";
import { type Fields, pathOf, resolved, type Schema } from "../state/definitions";
import css from "./library.module.css";

interface FieldProps {
  readonly name: string;
  readonly path: string;
  readonly schema: Schema;
  readonly root: Schema;
  readonly value: unknown;
  readonly faults: Readonly<Record<string, string>>;
  readonly readOnly: boolean;
  readonly onChange: (value: unknown) => void;
}

const labelOf = (name: string): string => {
  const words = name.replaceAll("_", " ");
  return words.charAt(0).toUpperCase() + words.slice(1);
};

export function DefinitionField(props: FieldProps) {
  const { name, path, root, value, faults, readOnly, onChange } = props;
  const schema = resolved(props.schema, root);
  const error = faults[path] ?? null;
  const common = {
    label: labelOf(name),
    description: schema.description ?? "",
    error,
    disabled: readOnly,
    "data-path": path,
  };
  const kinds = schema.oneOf?.map((one) => resolved(one, root));
  if (kinds !== undefined) return <Kinds {...props} kinds={kinds} />;
  if (schema.enum !== undefined) {
    return (
      <Select
        {...common}
        data={[...schema.enum]}
        value={String(value ?? schema.default ?? "")}
        onChange={(word) => onChange(word ?? undefined)}
      />
    );
  }
  if (schema.type === "boolean") {
    return (
      <Checkbox
        {...common}
        checked={Boolean(value ?? schema.default)}
        onChange={(event) => onChange(event.currentTarget.checked)}
      />
    );
  }
  if (schema.type === "number" || schema.type === "integer") {
    return (
      <NumberInput
        {...common}
        value={typeof value === "number" ? value : ""}
        placeholder={schema.default === undefined ? "" : String(schema.default)}
        allowDecimal={schema.type === "number"}
        onChange={(number) => onChange(typeof number === "number" ? number : undefined)}
      />
    );
  }
  if (schema.type === "string") {
    return (
      <TextInput
        {...common}
        value={String(value ?? "")}
        onChange={(event) => onChange(event.currentTarget.value)}
      />
    );
  }
  if (schema.type === "array") return <Items {...props} schema={schema} />;
  if (typeof schema.additionalProperties === "object") return <Named {...props} schema={schema} />;
  if (schema.properties !== undefined && value !== undefined) {
    return <Table {...props} schema={schema} />;
  }
  return null;
}

/** The fields of a table. */
function Table({ name, path, schema, root, value, faults, readOnly, onChange }: FieldProps) {
  const fields = (value ?? {}) as Fields;
  return (
    <fieldset className={css.table}>
      <legend>{labelOf(name)}</legend>
      {faults[path] !== undefined && <div className={css.fault}>{faults[path]}</div>}
      <div className={css.fields}>
        {Object.entries(schema.properties ?? {})
          .filter(([, one]) => one.const === undefined)
          .map(([key, one]) => (
            <DefinitionField
              key={key}
              name={key}
              path={pathOf(path, key)}
              schema={one}
              root={root}
              value={fields[key]}
              faults={faults}
              readOnly={readOnly}
              onChange={(changed) => onChange({ ...fields, [key]: changed })}
            />
          ))}
      </div>
    </fieldset>
  );
}

/** A table of one of several kinds, such as a tool. */
function Kinds({ kinds, ...props }: FieldProps & { kinds: readonly Schema[] }) {
  const { value, readOnly, onChange } = props;
  const kindOf = (schema: Schema) => schema.properties?.kind?.const ?? "";
  const kind = String((value as Fields | undefined)?.kind ?? "");
  const chosen = kinds.find((schema) => kindOf(schema) === kind);
  return (
    <div className={css.wide}>
      <Select
        label="Kind of tool"
        data={kinds.map(kindOf)}
        value={kind}
        disabled={readOnly}
        onChange={(word) => onChange({ kind: word })}
      />
      {chosen !== undefined && <Table {...props} schema={chosen} />}
    </div>
  );
}

/** A list: of numbers, or of tables that can be added and removed. */
function Items(props: FieldProps) {
  const { name, path, schema, root, value, faults, readOnly, onChange } = props;
  const items = (value ?? []) as readonly unknown[];
  const item = schema.items ?? {};
  const isTable = resolved(item, root).properties !== undefined;
  const replaced = (at: number, changed: unknown) =>
    items.map((one, index) => (index === at ? changed : one));
  return (
    <div className={css.wide}>
      {faults[path] !== undefined && <div className={css.fault}>{faults[path]}</div>}
      <div className={isTable ? "" : css.fields}>
        {items.map((one, at) => (
          // biome-ignore lint/suspicious/noArrayIndexKey: an item has no other identity
          <div key={at}>
            <DefinitionField
              {...props}
              name={`${name} ${at + 1}`}
              path={`${path} ${at + 1}`}
              schema={isTable ? item : { ...item, description: schema.description ?? "" }}
              value={one}
              onChange={(changed) => onChange(replaced(at, changed))}
            />
            {isTable && !readOnly && (
              <Button
                size="compact-xs"
                variant="subtle"
                color="red"
                onClick={() => onChange(items.filter((_, index) => index !== at))}
              >
                Remove {name} {at + 1}
              </Button>
            )}
          </div>
        ))}
      </div>
      {isTable && !readOnly && (
        <Button
          size="compact-sm"
          variant="default"
          onClick={() => onChange([...items, structuredClone(items.at(-1)) ?? {}])}
        >
          Add {name}
        </Button>
      )}
    </div>
  );
}

/** Tables by name, such as the deflection of each cutter. */
function Named(props: FieldProps) {
  const { path, schema, value, readOnly, onChange } = props;
  const tables = (value ?? {}) as Fields;
  const item = typeof schema.additionalProperties === "object" ? schema.additionalProperties : {};
  const add = (form: FormData) => {
    const name = String(form.get("name") ?? "").trim();
    if (name !== "") onChange({ ...tables, [name]: {} });
  };
  return (
    <div className={css.wide}>
      {Object.entries(tables).map(([key, one]) => (
        <DefinitionField
          {...props}
          key={key}
          name={key}
          path={pathOf(path, key)}
          schema={item}
          value={one}
          onChange={(changed) => onChange({ ...tables, [key]: changed })}
        />
      ))}
      {!readOnly && (
        <form action={add} className={css.add}>
          <TextInput name="name" label="Name of the station" />
          <Button type="submit" variant="default">
            Add
          </Button>
        </form>
      )}
    </div>
  );
}
