/** The order of the work by blanks: each has layers, and these have tracks. */

import { ActionIcon, Flex, Text } from "@mantine/core";
import { IconChevronDown, IconChevronRight } from "@tabler/icons-react";
import { useState } from "react";
import { translate } from "../../language/translate";
import { LINE_STYLES } from "../../state/drawing/palette";
import type { WorkItem } from "../../state/order/workOrder";
import {
  brokenByLayer,
  brokenByPart,
  movedInLayer,
  movedPart,
  type WorkLayer,
  type WorkPart,
} from "../../state/order/workParts";
import { useUiStore } from "../../state/store";
import panels from "../shared/panels.module.css";
import { Swatch } from "../shared/Swatch";
import { reasonOf } from "./orderReason";
import { SortedList } from "./SortedList";
import { WorkPicture } from "./WorkPicture";
import { trackRow } from "./WorkTrack";
import css from "./workOrder.module.css";

/** Most tracks of a layer that is unfolded at first. */
const FEW = 20;

interface Props {
  items: readonly WorkItem[];
  parts: readonly WorkPart[];
  /** Called with all tracks in their new order. */
  onOrder(items: readonly WorkItem[]): void;
  /** Called with why a move is refused. */
  onRefused(reason: string): void;
}

const nameOfPart = ({ number }: WorkPart): string =>
  number > 0 ? translate("workOrder.blank", { number }) : translate("workOrder.besideBlanks");

function nameOfLayer({ items, place, count }: WorkLayer): string {
  const type = LINE_STYLES[items[0]?.type ?? "cut"].title;
  return count > 1 ? translate("workOrder.layer", { type, place, count }) : type;
}

export function WorkTree(props: Props) {
  const { items, parts, onOrder, onRefused } = props;
  const [open, toggle] = useUnfolded(parts.length === 1 ? parts.map(({ number }) => number) : []);
  const move = (from: number, to: number) => {
    const broken = brokenByPart(parts, from, to);
    if (broken === null) onOrder(movedPart(items, parts, from, to));
    else onRefused(reasonOf(broken, nameOfPart));
  };
  return (
    <SortedList
      kind="part"
      testId="work-parts"
      onMove={move}
      rows={parts.map((part, place) => ({
        id: part.number,
        name: nameOfPart(part),
        content: (
          <>
            <Fold
              name={nameOfPart(part)}
              open={open.has(part.number)}
              onToggle={() => toggle(part.number)}
            />
            <PartName part={part} place={place} />
          </>
        ),
        below: open.has(part.number) && <Layers {...props} layers={part.layers} />,
      }))}
    />
  );
}

function Layers({ items, layers, onOrder, onRefused }: Props & { layers: readonly WorkLayer[] }) {
  const [open, toggle] = useUnfolded(
    layers.filter((layer) => layer.items.length <= FEW).map(({ stage }) => stage),
  );
  const numbers = new Map(items.map(({ edge }, place) => [edge, place + 1]));
  return (
    <SortedList
      kind="layer"
      testId="work-layers"
      onMove={(from, to) => {
        const broken = brokenByLayer(layers, from, to);
        if (broken !== null) onRefused(reasonOf(broken, nameOfLayer));
      }}
      rows={layers.map((layer) => ({
        id: layer.stage,
        name: nameOfLayer(layer),
        content: (
          <>
            <Fold
              name={nameOfLayer(layer)}
              open={open.has(layer.stage)}
              onToggle={() => toggle(layer.stage)}
            />
            <LayerName layer={layer} />
          </>
        ),
        below: open.has(layer.stage) && (
          <SortedList
            kind="track"
            testId="work-items"
            onMove={(from, to) => onOrder(movedInLayer(items, layer, from, to))}
            rows={layer.items.map((item) => trackRow(item, numbers.get(item.edge) ?? 0))}
          />
        ),
      }))}
    />
  );
}

/** The rows that are unfolded, and a function that folds or unfolds one. */
function useUnfolded(first: readonly number[]): [ReadonlySet<number>, (id: number) => void] {
  const [open, setOpen] = useState<ReadonlySet<number>>(() => new Set(first));
  const toggle = (id: number) =>
    setOpen((before) => {
      const after = new Set(before);
      if (!after.delete(id)) after.add(id);
      return after;
    });
  return [open, toggle];
}

function Fold({ name, open, onToggle }: { name: string; open: boolean; onToggle(): void }) {
  const Icon = open ? IconChevronDown : IconChevronRight;
  return (
    <ActionIcon
      variant="subtle"
      color="gray"
      size={24}
      aria-expanded={open}
      aria-label={translate("workOrder.contentsOf", { name })}
      onClick={onToggle}
      data-testid="unfold"
    >
      <Icon size={14} aria-hidden />
    </ActionIcon>
  );
}

function PartName({ part, place }: { part: WorkPart; place: number }) {
  const { edges, box, layers } = part;
  const selectEdges = useUiStore((ui) => ui.selectEdges);
  const selected = useUiStore((ui) => edges.every((edge) => ui.selection.has(edge)));
  const tracks = layers.reduce((sum, layer) => sum + layer.items.length, 0);
  return (
    <button
      type="button"
      className={`${panels.pick} ${css.name}`}
      aria-pressed={selected}
      onClick={() => selectEdges(edges)}
    >
      <Text span w={18} ta="end" c="ink.0" fw={650} className={css.number}>
        {place + 1}
      </Text>
      <WorkPicture edges={edges} box={box} colour="var(--ink-2)" />
      <Flex component="span" direction="column" miw={0} align="flex-start">
        <Text span fz={13} fw={550} truncate="end">
          {nameOfPart(part)}
        </Text>
        <Text span fz={12} c="ink.3">
          {translate("workOrder.tracksInLayers", { tracks, layers: layers.length })}
        </Text>
      </Flex>
    </button>
  );
}

function LayerName({ layer }: { layer: WorkLayer }) {
  const selectEdges = useUiStore((ui) => ui.selectEdges);
  const [first] = layer.items;
  return (
    <button
      type="button"
      className={`${panels.pick} ${css.name}`}
      onClick={() => selectEdges(layer.items.flatMap(({ edges }) => edges))}
    >
      {first !== undefined && <Swatch type={first.type} />}
      <Flex component="span" direction="column" miw={0} align="flex-start">
        <Text span fz={13}>
          {nameOfLayer(layer)}
        </Text>
        <Text span fz={12} c="ink.3">
          {translate("workOrder.tracks", { n: layer.items.length })}
        </Text>
      </Flex>
    </button>
  );
}
