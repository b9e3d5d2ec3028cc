/** Form for the fields of a machine, a board or a tool, made from their JSON Schema. */

import { Button, Checkbox, NumberInput, Select, TextInput } from "@mantine/core";
import {
  emptyTable,
  type Fields,
  fieldLabel,
  fieldsOf,
  isOptional,
  itemLabel,
  pathOf,
  resolved,
  type Schema,
} from "../state/definitions";
import css from "./library.module.css";
import { ToolPicker } from "./ToolPicker";

interface FieldProps {
  readonly name: string;
  readonly path: string;
  readonly schema: Schema;
  readonly root: Schema;
  readonly value: unknown;
  readonly faults: Readonly<Record<string, string>>;
  readonly readOnly: boolean;
  readonly onChange: (value: unknown) => void;
  /** Name for people; made from the name in the file if it is missing. */
  readonly label?: string;
}

const labelOf = ({ name, path, label }: FieldProps): string => label ?? fieldLabel(name, path);

export function DefinitionField(props: FieldProps) {
  const { path, root, value, faults, readOnly, onChange } = props;
  const schema = resolved(props.schema, root);
  const error = faults[path] ?? null;
  const common = {
    label: labelOf(props),
    description: schema.description ?? "",
    error,
    disabled: readOnly,
    "data-path": path,
  };
  const kinds = schema.oneOf?.map((one) => resolved(one, root));
  if (kinds !== undefined) return <Kinds {...props} kinds={kinds} />;
  const named = schema.anyOf?.map((one) => resolved(one, root));
  if (named?.[0]?.enum !== undefined && named[1]?.properties !== undefined) {
    return <NamedOrOwn {...props} names={named[0].enum} own={named[1]} />;
  }
  if (schema.enum !== undefined) {
    return (
      <Select
        {...common}
        data={[...schema.enum]}
        value={String(value ?? schema.default ?? "") || null}
        allowDeselect={false}
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
        placeholder={typeof schema.default === "number" ? String(schema.default) : ""}
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
  if (schema.properties === undefined) return <NoFields schema={schema} />;
  return isOptional(props.schema) ? (
    <OptionalTable {...props} schema={schema} />
  ) : (
    <Table {...props} schema={schema} />
  );
}

/** A table whose fields are not described. */
function NoFields({ schema }: { schema: Schema }) {
  return (
    <p className={css.wide}>
      {schema.maxProperties === 0
        ? "This controller language has no settings."
        : "The settings of this controller language can be changed in the TOML file."}
    </p>
  );
}

/** The fields of a table. */
function Table(props: FieldProps) {
  const { path, schema, root, value, faults, readOnly, onChange } = props;
  const fields = (value ?? {}) as Fields;
  return (
    <fieldset className={css.table}>
      <legend>{labelOf(props)}</legend>
      {faults[path] !== undefined && <div className={css.fault}>{faults[path]}</div>}
      <div className={css.fields}>
        {Object.entries(fieldsOf(schema, fields))
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

/** A table that may be left out, such as the gantry of a machine with several carriages. */
function OptionalTable(props: FieldProps) {
  const { path, schema, root, value, faults, readOnly, onChange } = props;
  const label = labelOf(props);
  if (value === undefined || value === null) {
    return (
      <div className={css.wide}>
        {faults[path] !== undefined && <div className={css.fault}>{faults[path]}</div>}
        {readOnly ? (
          <span className={css.mark}>{label}: none</span>
        ) : (
          <Button
            size="sm"
            variant="default"
            onClick={() => onChange(firstValue(schema, root))}
            data-testid={`add-${path}`}
          >
            Add: {label.toLowerCase()}
          </Button>
        )}
      </div>
    );
  }
  return (
    <div className={css.wide}>
      <Table {...props} />
      {!readOnly && (
        <Button size="sm" variant="subtle" color="red" onClick={() => onChange(undefined)}>
          Remove: {label.toLowerCase()}
        </Button>
      )}
    </div>
  );
}

/** First value of a table that is added: a list that must not be empty has one item. */
function firstValue(schema: Schema, root: Schema): Fields {
  const lists = Object.entries(schema.properties ?? {}).filter(
    ([, one]) => one.type === "array" && (one.minItems ?? 0) > 0 && one.maxItems === undefined,
  );
  return {
    ...emptyTable(schema, root),
    ...Object.fromEntries(lists.map(([name, one]) => [name, [emptyTable(one.items ?? {}, root)]])),
  };
}

const OWN = "own";

/** The name of something known, such as a plotter, or a table with its properties. */
function NamedOrOwn({
  names,
  own,
  ...props
}: FieldProps & { names: readonly string[]; own: Schema }) {
  const { path, schema, value, faults, readOnly, onChange } = props;
  const isOwn = typeof value === "object" && value !== null;
  return (
    <div className={css.wide}>
      <Select
        label={labelOf(props)}
        description={schema.description ?? ""}
        error={isOwn ? null : (faults[path] ?? null)}
        disabled={readOnly}
        data={[
          ...names.map((name) => ({ value: name, label: name })),
          { value: OWN, label: "Another, with these properties" },
        ]}
        value={isOwn ? OWN : typeof value === "string" ? value : null}
        allowDeselect={false}
        onChange={(word) => onChange(word === OWN ? emptyTable(own, props.root) : word)}
        data-path={path}
      />
      {isOwn && <Table {...props} schema={own} />}
    </div>
  );
}

/** A table of one of several kinds, such as a tool. */
function Kinds({ kinds, ...props }: FieldProps & { kinds: readonly Schema[] }) {
  const { path, value, faults, readOnly, onChange } = props;
  const kindOf = (schema: Schema) => schema.properties?.kind?.const ?? "";
  const kind = String((value as Fields | undefined)?.kind ?? "");
  const chosen = kinds.find((schema) => kindOf(schema) === kind);
  // A machine has tools in its stations; a tool of the library is one by itself.
  const isInStation = path.includes(" → ");
  return (
    <div className={css.wide}>
      <div className={css.fields}>
        <Select
          label="Kind of tool"
          data={kinds.map(kindOf)}
          value={kind || null}
          error={chosen === undefined ? (faults[path] ?? null) : null}
          disabled={readOnly}
          allowDeselect={false}
          onChange={(word) => onChange({ kind: word })}
          data-path={pathOf(path, "kind")}
        />
        {isInStation && !readOnly && <ToolPicker onPick={onChange} />}
      </div>
      {chosen !== undefined && <Table {...props} schema={chosen} />}
    </div>
  );
}

/** A list: of numbers, or of tables that can be added and removed. */
function Items(props: FieldProps) {
  const { name, path, schema, root, value, faults, readOnly, onChange } = props;
  const { minItems = 0, maxItems } = schema;
  // A list of fixed length shows all its items, also those without a value.
  const isFixed = minItems > 0 && minItems === maxItems;
  const given = (value ?? []) as readonly unknown[];
  const items = isFixed ? Array.from({ length: minItems }, (_, at) => given[at]) : given;
  const item = schema.items ?? {};
  const isTable = resolved(item, root).properties !== undefined;
  const word = fieldLabel(name, path).toLowerCase();
  const replaced = (at: number, changed: unknown) => {
    const next = items.map((one, index) => (index === at ? changed : one));
    return next.every((one) => one === undefined) ? undefined : next;
  };
  return (
    <div className={css.wide}>
      {faults[path] !== undefined && <div className={css.fault}>{faults[path]}</div>}
      <div className={isTable ? "" : css.fields}>
        {items.map((one, at) => (
          // biome-ignore lint/suspicious/noArrayIndexKey: an item has no other identity
          <div key={at}>
            <DefinitionField
              {...props}
              name={name}
              label={itemLabel(name, at)}
              path={`${path} ${at + 1}`}
              schema={isTable ? item : { ...item, description: schema.description ?? "" }}
              value={one}
              onChange={(changed) => onChange(replaced(at, changed))}
            />
            {isTable && !readOnly && (
              <Button
                size="compact-sm"
                variant="subtle"
                color="red"
                onClick={() => onChange(items.filter((_, index) => index !== at))}
              >
                Remove {word} {at + 1}
              </Button>
            )}
          </div>
        ))}
      </div>
      {isTable && !readOnly && (
        <Button
          size="sm"
          variant="default"
          onClick={() =>
            onChange([...items, structuredClone(items.at(-1)) ?? emptyTable(item, root)])
          }
          data-testid={`add-${path}`}
        >
          Add {word}
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
  const without = (key: string) =>
    Object.fromEntries(Object.entries(tables).filter(([name]) => name !== key));
  return (
    <div className={css.wide}>
      {Object.entries(tables).map(([key, one]) => (
        <div key={key}>
          <DefinitionField
            {...props}
            name={key}
            label={key}
            path={pathOf(path, key)}
            schema={item}
            value={one}
            onChange={(changed) => onChange({ ...tables, [key]: changed })}
          />
          {!readOnly && (
            <Button
              size="compact-sm"
              variant="subtle"
              color="red"
              onClick={() => onChange(without(key))}
            >
              Remove {key}
            </Button>
          )}
        </div>
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
