/**
 * Commands of the page of a drawing with their names and keys.
 *
 * The keyboard, the list of shortcuts and the command palette all read this table.
 */

import { insideSentence } from "../../language/numbers";
import { translate } from "../../language/translate";
import { refusalOf } from "../accounts/accounts";
import { redo, retype, undo } from "../actions";
import { useDimensions } from "../drafting/dimensions";
import { type Tool, useDrafting } from "../drafting/drafting";
import { acceptLikely, hasLikely, openQuestionsNow, useAsked } from "../drawing/asked";
import { useEdgeList } from "../drawing/edgeList";
import { ASSIGNABLE_TYPES, LINE_STYLES } from "../drawing/palette";
import {
  selectAlike,
  selectAll,
  selectConnected,
  selectSimilar,
} from "../drawing/selectionActions";
import { COLOUR_MODES, type Layer, STEPS, type Step, useUiStore } from "../store";
import { type Shortcut, shortcut } from "./keys";
import { focusMainAction } from "./mainAction";
import { picture } from "./picture";

export const GROUPS = ["steps", "questions", "select", "types", "tools", "view", "page"] as const;
export type Group = (typeof GROUPS)[number];

export interface Command {
  readonly id: string;
  readonly title: string;
  readonly group: Group;
  readonly keys: readonly Shortcut[];
  /** Steps in which it works; null: all. */
  readonly steps: readonly Step[] | null;
  /** Whether it does something now. */
  ready(): boolean;
  run(): void;
}

interface Part {
  readonly keys?: string;
  readonly steps?: readonly Step[];
  readonly ready?: () => boolean;
}

/** A command; `keys` are separated by spaces. */
const command = (
  group: Group,
  id: string,
  title: string,
  run: () => void,
  { keys = "", steps, ready = () => true }: Part = {},
): Command => ({
  id,
  title,
  group,
  keys: keys === "" ? [] : keys.split(" ").map(shortcut),
  steps: steps ?? null,
  ready,
  run,
});

const ui = () => useUiStore.getState();
const hasSelection = () => ui().selection.size > 0;
const canRetype = () => hasSelection() && refusalOf("PATCH /api/v1/drawings/{id}/edges") === null;

/** Pixels by which an arrow key moves the view. */
const PAN = 80;

/** Give up what is under way: the profile editor, the tool, at last the selection. */
function cancel(): void {
  if (ui().editedProfile !== null) ui().set({ editedProfile: null, retypePreviews: [] });
  else if (useDrafting.getState().tool !== null) useDrafting.getState().cancel();
  else ui().selectEdges([]);
}

const STEP_TITLES: Readonly<Record<Step, string>> = {
  lines: translate("stepBar.lines"),
  sheet: translate("stepBar.sheet"),
  process: translate("stepBar.process"),
  check: translate("stepBar.check"),
};

const stepCommands = [
  ...STEPS.map((step) =>
    command(
      "steps",
      `step-${step}`,
      translate("commands.goToStep", { step: STEP_TITLES[step] }),
      () => ui().set({ step, panelOpen: true }),
      { ready: () => ui().step !== step },
    ),
  ),
  command("steps", "main-action", translate("commands.mainAction"), focusMainAction, {
    keys: "Ctrl+Enter",
  }),
];

const LINES: Part = { steps: ["lines"] };
const SEVERAL: Part = { ...LINES, ready: () => openQuestionsNow().length > 1 };

const questionCommands = [
  command(
    "questions",
    "next-question",
    translate("questionsPanel.next"),
    () => useAsked.getState().turn(1),
    { ...SEVERAL, keys: "." },
  ),
  command(
    "questions",
    "previous-question",
    translate("questionsPanel.previous"),
    () => useAsked.getState().turn(-1),
    { ...SEVERAL, keys: "," },
  ),
  command("questions", "accept-likely", translate("commands.acceptLikely"), acceptLikely, {
    ...LINES,
    keys: "Enter",
    ready: hasLikely,
  }),
];

const OF_SELECTION: Part = { ...LINES, ready: hasSelection };

const selectCommands = [
  command("select", "select-all", translate("shortcutsDialog.selectAllEdges"), selectAll, {
    keys: "Ctrl+A",
  }),
  command("select", "select-similar", translate("commands.selectSimilar"), selectSimilar, {
    ...OF_SELECTION,
    keys: "A",
  }),
  command("select", "select-connected", translate("commands.selectConnected"), selectConnected, {
    ...OF_SELECTION,
    keys: "K",
  }),
  command(
    "select",
    "select-type",
    translate("commands.selectSameType"),
    () => selectAlike("lineType"),
    OF_SELECTION,
  ),
  command(
    "select",
    "select-layer",
    translate("commands.selectSameLayer"),
    () => selectAlike("layer"),
    OF_SELECTION,
  ),
  command("select", "cancel", translate("shortcutsDialog.clearTheSelectionOfEdges"), cancel, {
    keys: "Escape",
  }),
];

const typeCommands = [
  ...ASSIGNABLE_TYPES.map((type) =>
    command(
      "types",
      `type-${type}`,
      translate("commands.setType", { type: insideSentence(LINE_STYLES[type].title) }),
      () => void retype([...ui().selection], type),
      {
        keys: type === "ignored" ? `${LINE_STYLES[type].key} Delete` : LINE_STYLES[type].key,
        ready: canRetype,
      },
    ),
  ),
  command(
    "types",
    "type-none",
    translate("commands.useProfileType"),
    () => void retype([...ui().selection], null),
    { keys: "0", ready: canRetype },
  ),
];

const choose = (tool: Tool | null) => () => useDrafting.getState().choose(tool);
const tool = (id: string, title: string, chosen: Tool | null, keys = "", request?: "edit") =>
  command("tools", id, title, choose(chosen), {
    ...LINES,
    keys,
    ready: () => request === undefined || refusalOf("PATCH /api/v1/drawings/{id}") === null,
  });

const toolCommands = [
  tool("tool-select", translate("draftTools.selectEdges"), null, "V"),
  tool("tool-box", translate("commands.selectByBox"), "box", "B"),
  tool("tool-lasso", translate("commands.selectByLasso"), "lasso", "Q"),
  tool("tool-measure", translate("shortcutsDialog.measureADistance"), "measure", "M"),
  tool("tool-line", translate("draftTools.drawALine"), "line", "", "edit"),
  tool("tool-circle", translate("draftTools.drawACircle"), "circle", "", "edit"),
  tool("tool-move", translate("draftTools.moveEnds"), "move", "", "edit"),
];

const LAYERS: readonly (readonly [Layer, string, string])[] = [
  ["nominal", "N", translate("viewBar.theEdgesOfTheDrawing")],
  ["head", "H", translate("viewBar.thePathOfTheMachine")],
  ["tip", "T", translate("viewBar.thePathOfTheTool")],
  ["rapids", "R", translate("viewBar.theMovesOfTheMachine")],
  ["swept", "S", translate("viewBar.theAreaThatTheTools")],
  ["moves", "P", translate("viewBar.thePointsWhereATool")],
];

function nextColours(): void {
  const next = (COLOUR_MODES.indexOf(ui().colourMode) + 1) % COLOUR_MODES.length;
  ui().set({ colourMode: COLOUR_MODES[next] ?? "types" });
}

const pan = (id: string, title: string, keys: string, dx: number, dy: number) =>
  command("view", id, title, () => picture()?.pan(dx, dy), { keys });

const viewCommands = [
  command("view", "fit", translate("shortcutsDialog.showTheWholeDrawing"), () => picture()?.fit(), {
    keys: "F",
  }),
  command(
    "view",
    "fit-table",
    translate("shortcutsDialog.showTheWholeTable"),
    () => picture()?.fitTable(),
    {
      keys: "Shift+F",
    },
  ),
  command("view", "zoom-in", translate("commands.zoomIn"), () => picture()?.zoom(1.4), {
    keys: "+ =",
  }),
  command("view", "zoom-out", translate("commands.zoomOut"), () => picture()?.zoom(1 / 1.4), {
    keys: "-",
  }),
  pan("pan-left", translate("commands.panLeft"), "ArrowLeft", PAN, 0),
  pan("pan-right", translate("commands.panRight"), "ArrowRight", -PAN, 0),
  pan("pan-up", translate("commands.panUp"), "ArrowUp", 0, PAN),
  pan("pan-down", translate("commands.panDown"), "ArrowDown", 0, -PAN),
  command(
    "view",
    "dimensions",
    translate("commands.dimensions"),
    () => useDimensions.getState().toggle(),
    { ...LINES, keys: "D" },
  ),
  ...LAYERS.map(([layer, keys, shows]) =>
    command(
      "view",
      `layer-${layer}`,
      translate("viewBar.showOrHide", { shows }),
      () => ui().toggleLayer(layer),
      { keys },
    ),
  ),
  command("view", "colours", translate("shortcutsDialog.changeWhatTheColoursShow"), nextColours, {
    keys: "C",
  }),
];

const pageCommands = [
  command("page", "undo", translate("shortcutsDialog.undoTheLastChange"), () => void undo(), {
    keys: "Ctrl+Z",
  }),
  command("page", "redo", translate("shortcutsDialog.redoTheUndoneChange"), () => void redo(), {
    keys: "Ctrl+Shift+Z Ctrl+Y",
  }),
  command(
    "page",
    "edge-list",
    translate("commands.edgeList"),
    () => {
      ui().set({ panelOpen: true });
      useEdgeList.getState().toggle();
    },
    { ...LINES, keys: "L" },
  ),
  command(
    "page",
    "panel",
    translate("commands.panel"),
    () => ui().set({ panelOpen: !ui().panelOpen }),
    { keys: "]" },
  ),
  command(
    "page",
    "help",
    translate("shortcutsDialog.showOrHideThisList"),
    () => ui().set({ helpOpen: !ui().helpOpen }),
    {
      keys: "?",
    },
  ),
];

export const COMMANDS: readonly Command[] = [
  ...stepCommands,
  ...questionCommands,
  ...selectCommands,
  ...typeCommands,
  ...toolCommands,
  ...viewCommands,
  ...pageCommands,
];

/** The commands that work in a step. */
export const commandsOf = (step: Step | null): readonly Command[] =>
  COMMANDS.filter(({ steps }) => steps === null || (step !== null && steps.includes(step)));
