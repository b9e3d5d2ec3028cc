/** Inputs, tables and lists of the form of a definition, with the components of the page. */

import {
  Button,
  Checkbox,
  Fieldset,
  Group,
  NumberInput,
  Select,
  Text,
  TextInput,
  Title,
} from "@mantine/core";
// The index of the package also imports ajv, which the page must not have.
import SchemaField from "@rjsf/core/lib/components/fields/SchemaField.js";
import {
  ADDITIONAL_PROPERTY_FLAG,
  type ArrayFieldItemTemplateProps,
  type ArrayFieldTemplateProps,
  type BaseInputTemplateProps,
  type FieldProps,
  type FieldTemplateProps,
  type MultiSchemaFieldTemplateProps,
  type ObjectFieldTemplateProps,
  type OptionalDataControlsTemplateProps,
  type RJSFSchema,
  type TemplatesType,
  type WidgetProps,
} from "@rjsf/utils";
import { createContext, type FormEvent, type ReactElement, useContext, useState } from "react";
import { insideSentence } from "../../language/numbers";
import { schemaTexts } from "../../language/schemaTexts";
import { translate } from "../../language/translate";
import { type Fields, pathText } from "../../state/library/definitions";
import type { FormContext } from "./DefinitionForm";
import { DimensionPicture } from "./DimensionPicture";
import css from "./library.module.css";
import { ToolPicker } from "./ToolPicker";

type Path = readonly (string | number)[];

/** Path of the field in which a template is. */
const PathContext = createContext<Path>([]);
/** Name of the list in which an item is. */
const ListContext = createContext("");

const usePathText = () => pathText(useContext(PathContext));

/** What all inputs have: name, help, fault, and the path by which tests find them. */
function useInput({ id, label, schema, rawErrors, disabled, readonly, options }: WidgetProps) {
  return {
    id,
    // rjsf gives the items of a list its title and their numbers.
    label: schema.title ?? label,
    description: options.description ?? schema.description ?? "",
    error: rawErrors?.join(" ") || null,
    disabled: Boolean(disabled || readonly),
    "data-path": usePathText(),
  };
}

function Input(props: BaseInputTemplateProps<Fields, RJSFSchema, FormContext>) {
  const input = useInput(props as unknown as WidgetProps);
  const isNumber = props.schema.type === "number" || props.schema.type === "integer";
  return isNumber ? (
    <NumberText input={input} {...props} />
  ) : (
    <TextInput
      {...input}
      value={String(props.value ?? "")}
      onChange={(event) => props.onChange(event.currentTarget.value)}
    />
  );
}

function NumberText({
  input,
  schema,
  value,
  onChange,
}: Pick<BaseInputTemplateProps, "schema" | "value" | "onChange"> & {
  input: ReturnType<typeof useInput>;
}) {
  // A number that is being typed, such as "2.", is a text, which must not be written anew.
  const [typed, setTyped] = useState<string | null>(null);
  return (
    <NumberInput
      {...input}
      value={typed ?? (typeof value === "number" ? value : "")}
      placeholder={typeof schema.default === "number" ? String(schema.default) : ""}
      allowDecimal={schema.type === "number"}
      onBlur={() => setTyped(null)}
      onChange={(entered) => {
        setTyped(String(entered));
        const number = entered === "" ? Number.NaN : Number(entered);
        onChange(Number.isNaN(number) ? undefined : number);
      }}
    />
  );
}

function Choice(props: WidgetProps) {
  const input = useInput(props);
  const options = props.options.enumOptions ?? [];
  const shown = props.value ?? props.schema.default;
  return (
    <Select
      {...input}
      data={options.map(({ value, label }) => ({
        value: String(value),
        label: schemaTexts[label] ?? label,
      }))}
      value={options.some(({ value }) => value === shown) ? String(shown) : null}
      allowDeselect={false}
      onChange={(word) => {
        const chosen = options.find(({ value }) => String(value) === word);
        if (chosen !== undefined) props.onChange(chosen.value);
      }}
    />
  );
}

function Switch(props: WidgetProps) {
  return (
    <Checkbox
      {...useInput(props)}
      checked={Boolean(props.value ?? props.schema.default)}
      onChange={(event) => props.onChange(event.currentTarget.checked)}
    />
  );
}

/** Whether a field is a table or a list, which has its faults above its content. */
const isComposite = (schema: RJSFSchema): boolean =>
  schema.type === "object" || schema.type === "array" || schema.oneOf !== undefined;

function Field(props: FieldTemplateProps<Fields, RJSFSchema, FormContext>) {
  const { fieldPathId, schema, hidden, label, children, rawErrors, registry } = props;
  // The kind of a tool follows from the choice of its table.
  if (hidden || schema.const !== undefined) return null;
  const composite = isComposite(schema);
  const isOwn = ADDITIONAL_PROPERTY_FLAG in schema && !registry.formContext.readOnly;
  return (
    <PathContext value={fieldPathId.path}>
      <div className={composite ? css.wide : undefined}>
        {composite && schema.oneOf === undefined && rawErrors !== undefined && (
          <Text component="div" my={8} c="var(--bad-ink)">
            {rawErrors.join(" ")}
          </Text>
        )}
        {children}
        {isOwn && (
          <Button
            size="compact-sm"
            variant="subtle"
            color="red"
            onClick={() => registry.formContext.setAt(fieldPathId.path, undefined)}
          >
            {translate("definitionForm.remove3", { key: label })}
          </Button>
        )}
      </div>
    </PathContext>
  );
}

/** Kind of the tool that a table describes; empty for other tables. */
function kindOf({ properties }: RJSFSchema): string {
  const kind = properties?.kind;
  return typeof kind === "object" ? String(kind.const ?? "") : "";
}

/** Title of a field of a table. */
function titleIn({ properties }: RJSFSchema, name: string): string | undefined {
  const field = properties?.[name];
  return typeof field === "object" ? field.title : undefined;
}

type TableProps = ObjectFieldTemplateProps<Fields, RJSFSchema, FormContext>;

function Table(props: TableProps) {
  const { schema, title, properties, optionalDataControl, fieldPathId } = props;
  if (fieldPathId.path.length === 0) return <Groups {...props} />;
  // A table of one of several kinds is shown by the choice of its kind.
  if (schema.oneOf !== undefined) return null;
  if (schema.maxProperties === 0) {
    return <p className={css.wide}>{translate("definitionForm.thisControllerLanguageHasNo")}</p>;
  }
  if (typeof schema.additionalProperties === "object") return <Named {...props} />;
  if (properties.length === 0 && optionalDataControl !== undefined) return optionalDataControl;
  if (properties.length === 0) {
    return <p className={css.wide}>{translate("definitionForm.theSettingsOfThisController")}</p>;
  }
  return (
    <>
      {/* rjsf numbers the items of a list with a hyphen. */}
      <Fieldset
        my={6}
        className={css.table}
        legend={schemaTexts[title] ?? title.replace(/-(\d+)$/, " $1")}
      >
        <DimensionPicture kind={kindOf(schema)} titleOf={(name) => titleIn(schema, name)} />
        <div className={css.fields}>{properties.map(({ content }) => content)}</div>
      </Fieldset>
      {!(ADDITIONAL_PROPERTY_FLAG in schema) && optionalDataControl}
    </>
  );
}

/** The fields of a definition in the groups that its schema names. */
function Groups({ schema, properties, registry }: TableProps) {
  const groups = new Map<string, { name: string; content: ReactElement }[]>();
  for (const { name, content } of properties) {
    const field = schema.properties?.[name];
    const own = typeof field === "object" && "group" in field ? String(field.group) : undefined;
    const title = own ?? translate("definitionEditor.more");
    groups.set(title, [...(groups.get(title) ?? []), { name, content }]);
  }
  return [...groups].map(([title, fields]) => (
    <section key={title} className={css.group}>
      <Title order={2} fz={14} mb={12}>
        {title}
      </Title>
      {fields.some(({ name }) => name === "caliper") && (
        <DimensionPicture kind="board" titleOf={(name) => titleIn(schema, name)} />
      )}
      <div className={css.fields}>{fields.map(({ content }) => content)}</div>
      {fields.map(({ name }) => registry.formContext.after[name])}
    </section>
  ));
}

/** Tables by name, such as the deflection of each cutter. */
function Named({ schema, properties, registry, formData, ...props }: TableProps) {
  const path = useContext(PathContext);
  const item = registry.schemaUtils.retrieveSchema(schema.additionalProperties as RJSFSchema);
  const { title = translate("definitionForm.name"), enum: names } = (schema.propertyNames ??
    {}) as RJSFSchema;
  const free = names?.map(String).filter((name) => !Object.hasOwn(formData ?? {}, name));
  const add = (event: FormEvent<HTMLFormElement>) => {
    event.preventDefault();
    // The form around it is that of the definition.
    event.stopPropagation();
    const name = String(new FormData(event.currentTarget).get("name") ?? "").trim();
    event.currentTarget.reset();
    if (name !== "") registry.formContext.setAt([...path, name], firstValue(item, registry));
  };
  return (
    <>
      {properties.map(({ content }) => content)}
      {!props.readonly && !props.disabled && free?.length !== 0 && (
        <form onSubmit={add}>
          <Group gap={8} mt={8} align="flex-end">
            {free === undefined ? (
              <TextInput name="name" label={title} />
            ) : (
              <Select name="name" label={title} data={free} defaultValue={free[0] ?? null} />
            )}
            <Button type="submit" variant="default">
              {translate("definitionForm.add3")}
            </Button>
          </Group>
        </form>
      )}
    </>
  );
}

type Registry = TableProps["registry"];

/** First value of a table that is added: its required fields, which are empty, and tables. */
function firstValue(schema: RJSFSchema, registry: Registry): Fields {
  const { schemaUtils } = registry;
  const names = schema.required ?? Object.keys(schema.properties ?? {}).slice(0, 1);
  return Object.fromEntries(
    names.map((name) => {
      const field = schemaUtils.retrieveSchema((schema.properties?.[name] ?? {}) as RJSFSchema);
      if (field.type === "object") return [name, firstValue(field, registry)];
      if (field.oneOf !== undefined) {
        const first = schemaUtils.retrieveSchema(field.oneOf[0] as RJSFSchema);
        return [name, first.const ?? firstValue(first, registry)];
      }
      if (field.const !== undefined) return [name, field.const];
      const { items, minItems = 0 } = field;
      if (field.type !== "array" || minItems === 0 || Array.isArray(items)) return [name, null];
      return [name, [firstValue(schemaUtils.retrieveSchema(items as RJSFSchema), registry)]];
    }),
  );
}

/** Adds or removes a table that may be left out, such as the gantry. */
function OptionalTable(props: OptionalDataControlsTemplateProps<Fields, RJSFSchema, FormContext>) {
  const { schema, registry, onAddClick, onRemoveClick } = props;
  const path = useContext(PathContext);
  const label = schema.title ?? String(path.at(-1));
  const word = label.length > 1 ? insideSentence(label) : label;
  if (onAddClick !== undefined) {
    return (
      <Button
        size="sm"
        variant="default"
        onClick={() => registry.formContext.setAt(path, firstValue(schema, registry))}
        data-testid={`add-${pathText(path)}`}
      >
        {translate("definitionForm.add", { label: word })}
      </Button>
    );
  }
  return onRemoveClick === undefined ? (
    <Text span fz={11} c="ink.3">
      {translate("definitionForm.none", { label })}
    </Text>
  ) : (
    <Button size="sm" variant="subtle" color="red" onClick={onRemoveClick}>
      {translate("definitionForm.remove", { label: word })}
    </Button>
  );
}

/** A table of one of several kinds, such as a tool. */
function Kinds(props: MultiSchemaFieldTemplateProps<Fields, RJSFSchema, FormContext>) {
  const { schema, selector, optionSchemaField, registry } = props;
  const path = useContext(PathContext);
  // A machine has tools in its stations; a tool of the library is one by itself.
  const hasPicker = schema.discriminator !== undefined && path.length > 1;
  return (
    <>
      <div className={css.fields}>
        {selector}
        {hasPicker && !registry.formContext.readOnly && (
          <ToolPicker onPick={(tool) => registry.formContext.setAt(path, tool)} />
        )}
      </div>
      {optionSchemaField}
    </>
  );
}

function List(props: ArrayFieldTemplateProps<Fields[], RJSFSchema, FormContext>) {
  const { schema, items, title, formData, canAdd, disabled, readonly, registry } = props;
  const path = useContext(PathContext);
  if (Array.isArray(schema.items)) return <div className={css.fields}>{items}</div>;
  // A new item is a copy of the last one, of which a person changes a few values.
  const add = () => {
    const last = formData?.at(-1);
    const item = registry.schemaUtils.retrieveSchema(schema.items as RJSFSchema);
    const added = last === undefined ? firstValue(item, registry as never) : structuredClone(last);
    registry.formContext.setAt(path, [...(formData ?? []), added]);
  };
  return (
    <ListContext value={insideSentence(title)}>
      {items}
      {items.length === 0 && registry.formContext.readOnly && (
        <Text span fz={11} c="ink.3">
          {translate("definitionForm.none", { label: title })}
        </Text>
      )}
      {canAdd && !disabled && !readonly && (
        <Button size="sm" variant="default" onClick={add} data-testid={`add-${pathText(path)}`}>
          {translate("definitionForm.add2", { word: insideSentence(title) })}
        </Button>
      )}
    </ListContext>
  );
}

function Item(props: ArrayFieldItemTemplateProps<Fields[], RJSFSchema, FormContext>) {
  const { children, index, buttonsProps, disabled, readonly } = props;
  const word = useContext(ListContext);
  return (
    <div>
      {children}
      {buttonsProps.hasRemove && !disabled && !readonly && word !== "" && (
        <Button size="compact-sm" variant="subtle" color="red" onClick={buttonsProps.onRemoveItem}>
          {translate("definitionForm.remove2", { word, at: index + 1 })}
        </Button>
      )}
    </div>
  );
}

/**
 * Writes a change to the fields directly. The form of rjsf would add default values, such as empty
 * tables, which the file does not contain.
 */
function ChangedField(props: FieldProps<Fields, RJSFSchema, FormContext>) {
  const { setAt } = props.registry.formContext;
  // rjsf reads the names of a table of own names once, so another name makes another field.
  const isNamed = typeof props.schema.additionalProperties === "object";
  const names = isNamed ? Object.keys(props.formData ?? {}).join("\n") : "";
  const isRequired = props.required === true || ADDITIONAL_PROPERTY_FLAG in props.schema;
  return (
    <SchemaField
      key={names}
      {...props}
      required={isRequired}
      onChange={(value, path) => setAt(path, value)}
    />
  );
}

/** A number stays one: the field of rjsf would write it in the language of the browser. */
function NumberField(props: FieldProps<Fields, RJSFSchema, FormContext>) {
  const { StringField } = props.registry.fields;
  return StringField === undefined ? null : <StringField {...props} />;
}

export const fields = { NumberField, SchemaField: ChangedField };

export const widgets = { SelectWidget: Choice, CheckboxWidget: Switch };

export const templates = {
  BaseInputTemplate: Input,
  FieldTemplate: Field,
  ObjectFieldTemplate: Table,
  OptionalDataControlsTemplate: OptionalTable,
  MultiSchemaFieldTemplate: Kinds,
  ArrayFieldTemplate: List,
  ArrayFieldItemTemplate: Item,
} as unknown as Partial<TemplatesType<Fields, RJSFSchema, FormContext>>;
