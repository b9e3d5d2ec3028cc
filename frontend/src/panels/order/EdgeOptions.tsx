/** Options of the next job for the selected edges, and the list of all such choices. */

import {
  Checkbox,
  CloseButton,
  Fieldset,
  Flex,
  NumberInput,
  Paper,
  SegmentedControl,
  Select,
  SimpleGrid,
  Slider,
  Stack,
  Text,
} from "@mantine/core";
import { useState } from "react";
import type { Machine } from "../../api/machines";
import type { Edges } from "../../geometry/records";
import { formatNumber } from "../../language/numbers";
import { translate } from "../../language/translate";
import { LINE_STYLES } from "../../state/drawing/palette";
import { CORNER_TYPES } from "../../state/order/corners";
import {
  arrowAlong,
  type ChoiceField,
  chosenValues,
  commonType,
  EDGE_OPTION_NAMES,
  type EdgeChoice,
  type EdgeField,
  type EdgeOptionName,
  edgeFields,
  type FieldValue,
  isByType,
  isOfCutters,
  type NumberField,
  optionsForEdges,
  stationsForEdges,
  type Target,
  withoutTarget,
  withValue,
} from "../../state/order/edgeOptions";
import { withEdgeChoices } from "../../state/order/options";
import { useMachines } from "../../state/queries";
import { useUiStore } from "../../state/store";
import css from "../shared/panels.module.css";
import { Note } from "../shared/parts";
import { CornerPicture } from "./CornerPicture";
import cornerCss from "./corners.module.css";
import {
  choiceSummary,
  choiceText,
  fieldText,
  optionHelp,
  optionTitle,
  targetOf,
  targetText,
  valueText,
} from "./edgeOptionTexts";
import { LeadPicture } from "./LeadPicture";

interface SelectionProps {
  edges: Edges;
  rows: readonly number[];
}

/** The fields of all options for the selected edges. */
export function EdgeOptions({ edges, rows }: SelectionProps) {
  const names = useOptionNames(edges, rows);
  if (names.length === 0) return null;
  return (
    <Stack gap={8} mt={14} data-testid="edge-options">
      <Note>{translate("edgeOption.forTheNextJob")}</Note>
      {names.map((name) => (
        <OptionForm key={name} name={name} edges={edges} rows={rows} />
      ))}
    </Stack>
  );
}

/** The options that can be chosen for some edges on the machine, and those that are chosen. */
function useOptionNames(edges: Edges, rows: readonly number[]): EdgeOptionName[] {
  const machine = useMachine();
  const options = useUiStore((ui) => ui.options);
  const offered = (name: EdgeOptionName): boolean => {
    if (name === "edge_tools") return stationsForEdges(machine, edges, rows).length > 1;
    return !isOfCutters(name) || machine?.offset_cuts === true;
  };
  return optionsForEdges(edges, rows).filter((name) => offered(name) || options[name].length > 0);
}

function useMachine(): Machine | undefined {
  const { data: machines } = useMachines();
  const machine = useUiStore((ui) => ui.machine);
  return machines?.find(({ name }) => name === machine);
}

function OptionForm({ name, edges, rows }: SelectionProps & { name: EdgeOptionName }) {
  const options = useUiStore((ui) => ui.options);
  const set = useUiStore((ui) => ui.set);
  const [forType, setForType] = useState(false);
  const type = commonType(edges, rows);
  const hasTypes = type !== null && isByType(name);
  const target: Target = hasTypes && forType ? type : rows;
  const first = typeof target === "string" ? target : (target[0] ?? -1);
  const fields = edgeFields(name);
  const choices: readonly EdgeChoice[] = options[name];
  const help = optionHelp(name);
  const values = chosenValues(fields, choices, first);
  // What an edge without a choice of its own has from its line type.
  const ofType = type === null ? {} : chosenValues(fields, choices, type);
  const change = (key: string, value: FieldValue) =>
    set({
      options: withEdgeChoices(options, name, withValue(fields, choices, target, key, value)),
    });
  return (
    <Fieldset px={12} py={8} legend={optionTitle(name)} data-testid={`edge-option-${name}`}>
      <Stack gap={10}>
        {hasTypes && (
          <SegmentedControl
            size="xs"
            fullWidth
            data={[
              { value: "edges", label: translate("edgeOption.selectedEdges", { n: rows.length }) },
              {
                value: "type",
                label: translate("edgeOption.allOfType", { type: LINE_STYLES[type].title }),
              },
            ]}
            value={forType ? "type" : "edges"}
            onChange={(scope) => setForType(scope === "type")}
            data-testid={`edge-scope-${name}`}
          />
        )}
        {name === "contour_leads" ? (
          <Flex gap={10} align="center">
            <LeadPicture />
            <Note>{help}</Note>
          </Flex>
        ) : (
          help !== null && <Note>{help}</Note>
        )}
        {Object.entries(fields).map(([key, field]) => (
          <Field
            key={key}
            selection={{ edges, rows }}
            name={name}
            id={key}
            field={field}
            value={values[key] ?? null}
            usual={typeof target === "string" ? null : (ofType[key] ?? null)}
            edge={
              typeof target !== "string" && rows.length === 1 ? { edges, row: rows[0] ?? 0 } : null
            }
            onChange={(value) => change(key, value)}
          />
        ))}
      </Stack>
    </Fieldset>
  );
}

interface FieldProps<Kind extends EdgeField> {
  name: EdgeOptionName;
  id: string;
  field: Kind;
  value: FieldValue;
  /** Value that is chosen for the line type of the edges; null for none. */
  usual: FieldValue;
  selection: SelectionProps;
  /** The edge if a single one is selected. */
  edge: { edges: Edges; row: number } | null;
  onChange: (value: FieldValue) => void;
}

function Field({ field, ...rest }: FieldProps<EdgeField>) {
  if (field.unit === "corner" && field.kind === "choice")
    return <CornerControl field={field} {...rest} />;
  if (field.kind === "choice") return <ChoiceControl field={field} {...rest} />;
  if (field.unit === "fraction") return <PlaceControl field={field} {...rest} />;
  if (field.unit === "station") return <StationControl field={field} {...rest} />;
  return <NumberControl field={field} {...rest} />;
}

function ChoiceControl({ name, id, field, value, edge, onChange }: FieldProps<ChoiceField>) {
  const isDirection = field.unit === "direction" && edge !== null;
  return (
    <Stack gap={6} fz={12} c="ink.2">
      <span>{fieldText(name, id)}</span>
      <SegmentedControl
        size="xs"
        fullWidth
        aria-label={fieldText(name, id)}
        data={field.choices.map((choice) => ({
          value: choice,
          label:
            isDirection && choice !== field.default
              ? `${arrowAlong(edge.edges, edge.row, choice === "reverse")} ${choiceText(name, id, choice)}`
              : choiceText(name, id, choice),
        }))}
        value={String(value ?? field.default)}
        onChange={onChange}
        data-testid={`edge-${name}-${id}`}
      />
    </Stack>
  );
}

/** A corner type with its picture, or that of the job. */
function CornerControl({ name, id, field, value, onChange }: FieldProps<ChoiceField>) {
  return (
    <Stack gap={6} fz={12} c="ink.2">
      <span>{fieldText(name, id)}</span>
      <SimpleGrid cols={3} spacing={4}>
        {field.choices.map((choice) => (
          <button
            key={choice}
            type="button"
            className={`${css.choice} ${cornerCss.cornerType}`}
            aria-pressed={(value ?? field.default) === choice}
            onClick={() => onChange(choice)}
            data-testid={`edge-${name}-${id}-${choice}`}
          >
            {CORNER_TYPES.filter((type) => type === choice).map((type) => (
              <CornerPicture key={type} type={type} />
            ))}
            {choiceText(name, id, choice)}
          </button>
        ))}
      </SimpleGrid>
    </Stack>
  );
}

/** A place on the edge: nowhere, or a part of its length. */
function PlaceControl({ name, id, field, value, edge, onChange }: FieldProps<NumberField>) {
  const share = typeof value === "number" ? value : null;
  const length = edge?.edges.length[edge.row];
  const label = fieldText(name, id);
  return (
    <Stack gap={6} fz={12} c="ink.2">
      <Checkbox
        size="xs"
        label={label}
        checked={share !== null}
        onChange={({ currentTarget }) => onChange(currentTarget.checked ? 0.5 : null)}
        data-testid={`edge-${name}-${id}`}
      />
      {share !== null && (
        <Stack gap={4} pl={2}>
          <Slider
            size="sm"
            min={field.min}
            max={field.max}
            step={0.01}
            value={share}
            label={null}
            thumbLabel={label}
            onChange={(at) => onChange(Number(at.toFixed(2)))}
          />
          <span>
            {length === undefined
              ? valueText(name, id, share)
              : translate("edgeOption.fromStart", {
                  share: valueText(name, id, share),
                  length: formatNumber(share * length, { maximumFractionDigits: 1 }),
                })}
          </span>
        </Stack>
      )}
    </Stack>
  );
}

/** One of the stations whose tools make the selected edges. */
function StationControl({ name, id, value, usual, selection, onChange }: FieldProps<NumberField>) {
  const stations = stationsForEdges(useMachine(), selection.edges, selection.rows);
  const known = stations.map(({ number, name: title }) => ({
    value: String(number),
    label: `${number} ${title}`,
  }));
  // A station that this machine lacks stays visible until another one is chosen.
  const foreign =
    value === null || known.some((one) => one.value === String(value))
      ? []
      : [{ value: String(value), label: valueText(name, id, value) }];
  return (
    <Select
      size="xs"
      label={fieldText(name, id)}
      placeholder={valueText(name, id, usual)}
      data={[...known, ...foreign]}
      value={value === null ? null : String(value)}
      clearable
      onChange={(chosen) => onChange(chosen === null ? null : Number(chosen))}
      data-testid={`edge-${name}-${id}`}
    />
  );
}

function NumberControl({ name, id, field, value, usual, onChange }: FieldProps<NumberField>) {
  return (
    <NumberInput
      size="xs"
      label={fieldText(name, id)}
      placeholder={valueText(name, id, usual)}
      suffix={field.unit === "" ? "" : ` ${field.unit}`}
      min={field.min}
      max={field.max}
      step={field.whole ? 1 : 0.1}
      decimalScale={field.whole ? 0 : 3}
      allowDecimal={!field.whole}
      value={value ?? ""}
      onChange={(typed) =>
        onChange(
          typed === "" || !(field.min < 0 || Number(typed) > 0) ? field.default : Number(typed),
        )
      }
      data-testid={`edge-${name}-${id}`}
    />
  );
}

/** All choices for edges of the next job, each with a button that removes it. */
export function EdgeChoiceList() {
  const options = useUiStore((ui) => ui.options);
  const set = useUiStore((ui) => ui.set);
  const selectEdges = useUiStore((ui) => ui.selectEdges);
  const chosen = EDGE_OPTION_NAMES.flatMap((name) =>
    (options[name] as readonly EdgeChoice[]).map((choice) => ({ name, choice })),
  );
  if (chosen.length === 0) return null;
  return (
    <Stack gap={6} fw={500} data-testid="edge-choices">
      <span>{translate("edgeOption.choicesForEdges")}</span>
      <Flex component="ul" direction="column" gap={4} mah={220} style={{ overflow: "hidden auto" }}>
        {chosen.map(({ name, choice }) => {
          const target = targetOf(choice);
          const subject = targetText(target);
          return (
            <Paper component="li" display="flex" key={`${name} ${JSON.stringify(choice)}`}>
              <button
                type="button"
                className={css.pick}
                style={{ flexWrap: "wrap" }}
                disabled={typeof target === "string"}
                onClick={() => typeof target !== "string" && selectEdges(target)}
              >
                <Text span c="ink.0" fw={600}>
                  {subject}
                </Text>
                <Text span fz={12} fw={400} c="ink.2">
                  {choiceSummary(name, choice)}
                </Text>
              </button>
              <CloseButton
                size="sm"
                aria-label={translate("edgeOption.remove", { subject })}
                onClick={() =>
                  set({
                    options: withEdgeChoices(options, name, withoutTarget(options[name], target)),
                  })
                }
              />
            </Paper>
          );
        })}
      </Flex>
    </Stack>
  );
}
