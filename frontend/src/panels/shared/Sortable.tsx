/** Rows that are put in order by a grip: with the mouse, a finger or the keyboard. */

import {
  type Announcements,
  closestCenter,
  DndContext,
  KeyboardSensor,
  MouseSensor,
  TouchSensor,
  type UniqueIdentifier,
  useSensor,
  useSensors,
} from "@dnd-kit/core";
import {
  SortableContext,
  sortableKeyboardCoordinates,
  useSortable,
  verticalListSortingStrategy,
} from "@dnd-kit/sortable";
import { ActionIcon } from "@mantine/core";
import { IconGripVertical } from "@tabler/icons-react";
import type { ReactNode } from "react";
import { translate } from "../../language/translate";
import css from "./sortable.module.css";

type RowId = string | number;

interface ListProps<Id extends RowId> {
  /** Ids of the rows in their order. */
  readonly ids: readonly Id[];
  /** How a row is moved with the keyboard, for screen readers. */
  readonly howTo: string;
  nameOf(id: Id): string;
  /** Move the row at an index to another index. */
  onMove(from: number, to: number): void;
  readonly children: ReactNode;
}

export function SortableRows<Id extends RowId>({
  ids,
  howTo,
  nameOf,
  onMove,
  children,
}: ListProps<Id>) {
  const sensors = useSensors(
    useSensor(MouseSensor, { activationConstraint: { distance: 4 } }),
    // A finger that moves at once scrolls the list.
    useSensor(TouchSensor, { activationConstraint: { delay: 180, tolerance: 6 } }),
    useSensor(KeyboardSensor, { coordinateGetter: sortableKeyboardCoordinates }),
  );
  const atPlace = (active: UniqueIdentifier, over: UniqueIdentifier | undefined) =>
    over === undefined
      ? undefined
      : translate("workOrder.atPlace", {
          name: nameOf(active as Id),
          place: ids.indexOf(over as Id) + 1,
          count: ids.length,
        });
  const announcements: Announcements = {
    onDragStart: ({ active }) => atPlace(active.id, active.id),
    onDragOver: ({ active, over }) => atPlace(active.id, over?.id),
    onDragEnd: ({ active, over }) => atPlace(active.id, over?.id),
    onDragCancel: ({ active }) => atPlace(active.id, active.id),
  };
  return (
    <DndContext
      sensors={sensors}
      collisionDetection={closestCenter}
      accessibility={{ announcements, screenReaderInstructions: { draggable: howTo } }}
      onDragEnd={({ active, over }) =>
        over !== null && onMove(ids.indexOf(active.id as Id), ids.indexOf(over.id as Id))
      }
    >
      <SortableContext items={[...ids]} strategy={verticalListSortingStrategy}>
        {children}
      </SortableContext>
    </DndContext>
  );
}

interface RowProps {
  readonly id: RowId;
  /** There is no grip. */
  readonly disabled?: boolean;
}

/** Properties of the element of a row, and of its grip. */
export function useSortableRow({ id, disabled = false }: RowProps) {
  const { attributes, listeners, setNodeRef, transform, transition, isDragging } = useSortable({
    id,
    disabled,
  });
  const row = {
    ref: setNodeRef,
    "data-dragged": isDragging,
    style: {
      transform: transform === null ? undefined : `translateY(${transform.y}px)`,
      transition,
    },
  };
  return { row, grip: { ...attributes, ...listeners } };
}

interface GripProps {
  readonly grip: ReturnType<typeof useSortableRow>["grip"];
  readonly label: string;
  readonly testId: string;
}

export function Grip({ grip, label, testId }: GripProps) {
  return (
    <ActionIcon
      {...grip}
      className={css.grip}
      variant="subtle"
      color="gray"
      size={28}
      aria-label={label}
      data-testid={testId}
    >
      <IconGripVertical size={15} aria-hidden />
    </ActionIcon>
  );
}
