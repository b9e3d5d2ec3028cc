/** The table of work: a row for each drawing, with its newest job and its next action. */

import { ActionIcon, Button, Table, Tooltip, VisuallyHidden } from "@mantine/core";
import { IconArrowDown, IconArrowUp, IconCopy, IconTrash } from "@tabler/icons-react";
import { type ReactNode, useState } from "react";
import { drawingService } from "../../api/drawings";
import type { OrderRow } from "../../api/jobs";
import { translate } from "../../language/translate";
import { useRefusal } from "../../state/accounts/accounts";
import { deleteDrawing } from "../../state/actions";
import { formatDuration, formatSize, formatUnitless } from "../../state/format";
import { useBoardTitles, useMachineTitles } from "../../state/queries";
import { drawingPath, layoutAddress, showWork, type WorkView } from "../../state/routes";
import { dateTimeText } from "../../state/times";
import { nextAction, type RowGroup } from "../../state/work/orders";
import { ariaSort, nextOrder, type WorkColumn } from "../../state/work/workOrder";
import { StateBadge } from "../job/StateBadge";
import { ConfirmDialog } from "../shared/ConfirmDialog";
import { DrawingPicture } from "../shared/DrawingPicture";
import css from "./work.module.css";

interface TableProps {
  readonly groups: readonly RowGroup[];
  readonly view: WorkView;
}

export function WorkTable({ groups, view }: TableProps) {
  const [unfolded, setUnfolded] = useState<ReadonlySet<string>>(new Set());
  const [asked, setAsked] = useState<OrderRow | null>(null);
  const toggle = (file: string) =>
    setUnfolded((before) => {
      const next = new Set(before);
      if (!next.delete(file)) next.add(file);
      return next;
    });
  return (
    <>
      <Table verticalSpacing={6} horizontalSpacing={8} className={css.table ?? ""} highlightOnHover>
        <Table.Thead>
          <Table.Tr>
            {COLUMNS.map((column) => (
              <ColumnHead key={column.column} {...column} view={view} />
            ))}
            <Table.Th>{translate("workTable.nextAction")}</Table.Th>
            <Table.Th className={css.state ?? ""}>
              <VisuallyHidden>{translate("workTable.delete")}</VisuallyHidden>
            </Table.Th>
          </Table.Tr>
        </Table.Thead>
        <Table.Tbody>
          {groups.flatMap(({ first, others }) => {
            const open = unfolded.has(first.file);
            const copies = (
              <Copies
                key={first.file}
                count={others.length}
                open={open}
                toggle={() => toggle(first.file)}
              />
            );
            return [
              <Row key={first.drawing.id} row={first} aside={copies} onDelete={setAsked} />,
              ...(open
                ? others.map((row) => (
                    <Row key={row.drawing.id} row={row} isCopy onDelete={setAsked} />
                  ))
                : []),
            ];
          })}
        </Table.Tbody>
      </Table>
      <ConfirmDialog
        confirmation={
          asked === null
            ? null
            : {
                title: translate("workTable.deleteThisDrawing"),
                text: translate("workTable.isDeletedForEver", { name: asked.drawing.name }),
                yes: translate("workTable.deleteDrawing"),
                no: translate("workTable.keepIt"),
              }
        }
        onYes={() => {
          if (asked !== null) void deleteDrawing(asked.drawing.id);
          setAsked(null);
        }}
        onNo={() => setAsked(null)}
      />
    </>
  );
}

interface Column {
  readonly column: WorkColumn;
  readonly title: string;
  /** Class of the widths at which it is shown. */
  readonly shown?: string | undefined;
  readonly span?: number;
}

const COLUMNS: readonly Column[] = [
  { column: "name", title: translate("workTable.drawing"), span: 2 },
  { column: "customer", title: translate("workTable.customer"), shown: css.wide },
  { column: "due", title: translate("workTable.due"), shown: css.wide },
  { column: "board", title: translate("workTable.board"), shown: css.widest },
  { column: "machine", title: translate("workTable.machine"), shown: css.widest },
  { column: "time", title: translate("workTable.time"), shown: css.widest },
  { column: "state", title: translate("workTable.state"), shown: css.state },
];

/** The title of a column; a click sorts by it. */
function ColumnHead({ column, title, shown, span, view }: Column & { view: WorkView }) {
  const sorted = ariaSort(view.order, column);
  return (
    <Table.Th colSpan={span} className={shown ?? ""} aria-sort={sorted}>
      <button
        type="button"
        className={css.sort}
        onClick={() => showWork({ ...view, order: nextOrder(view.order, column) }, view)}
        data-testid={`sort-${column}`}
      >
        {title}
        {sorted === "ascending" && <IconArrowUp size={13} aria-hidden />}
        {sorted === "descending" && <IconArrowDown size={13} aria-hidden />}
      </button>
    </Table.Th>
  );
}

interface CopiesProps {
  readonly count: number;
  readonly open: boolean;
  readonly toggle: () => void;
}

/** Shows and hides the other drawings of the same file. */
function Copies({ count, open, toggle }: CopiesProps) {
  if (count === 0) return null;
  return (
    <Button
      size="compact-xs"
      variant="subtle"
      color="gray"
      leftSection={<IconCopy size={13} aria-hidden />}
      aria-expanded={open}
      onClick={toggle}
      data-testid="duplicates"
    >
      {translate("workTable.sameFile", { others: count })}
    </Button>
  );
}

interface RowProps {
  readonly row: OrderRow;
  readonly aside?: ReactNode;
  readonly isCopy?: boolean;
  readonly onDelete: (row: OrderRow) => void;
}

function Row({ row, aside = null, isCopy = false, onDelete }: RowProps) {
  const { drawing, job } = row;
  const titleOf = useBoardTitles();
  const machineTitle = useMachineTitles();
  const refusal = useRefusal("DELETE /api/v1/drawings/{id}");
  const action = nextAction(row);
  const open =
    drawing.is_layout && job === null
      ? layoutAddress(drawing.id)
      : `#${drawingPath({ drawing: drawing.id, step: null, job: null })}`;
  const customer = job?.customer || drawing.customer;
  const due = job?.due ?? drawing.due;
  const order = job?.external_id || drawing.external_id;
  const board = job === null ? "" : titleOf(job.board);
  const machine = job === null ? "" : machineTitle(job.machine);
  const time = job === null || job.seconds === 0 ? "" : formatDuration(job.seconds);
  const size =
    drawing.unit === null
      ? `${formatUnitless(drawing.width)} × ${formatUnitless(drawing.height)}`
      : formatSize(drawing.width, drawing.height);
  const dueText = due == null ? "" : dateTimeText(due);
  const kept = job !== null ? translate("workTable.aJobWasMadeFromIt") : refusal;
  return (
    <Table.Tr data-testid="drawing-row" data-copy={isCopy || undefined}>
      <Table.Td className={css.pictureCell ?? ""}>
        <DrawingPicture className={css.picture} src={drawingService.pictureUrl(drawing.id)} />
      </Table.Td>
      <Table.Td className={css.nameCell ?? ""}>
        <a href={open} className={css.name} data-testid="open-drawing">
          {drawing.name}
        </a>
        <span className={css.facts}>
          {[drawing.is_layout ? translate("workTable.sheet") : "", order, size]
            .filter(Boolean)
            .join(" · ")}
        </span>
        <span className={css.facts} data-narrow>
          {[customer, dueText, board, machine, time].filter(Boolean).join(" · ")}
        </span>
        <span className={css.facts} data-state>
          {job !== null && <StateBadge job={job} size="sm" />}
        </span>
        {aside}
      </Table.Td>
      <Table.Td className={css.wide ?? ""}>{customer}</Table.Td>
      <Table.Td className={css.wide ?? ""}>
        {due != null && <time dateTime={due}>{dueText}</time>}
      </Table.Td>
      <Table.Td className={css.widest ?? ""}>{board}</Table.Td>
      <Table.Td className={css.widest ?? ""}>{machine}</Table.Td>
      <Table.Td className={css.widest ?? ""}>{time}</Table.Td>
      <Table.Td className={css.state ?? ""}>{job !== null && <StateBadge job={job} />}</Table.Td>
      <Table.Td>
        <Button
          component="a"
          href={action.href}
          size="xs"
          style={{ whiteSpace: "nowrap" }}
          variant={action.urgent ? "filled" : "default"}
          data-testid="next-action"
        >
          {action.title}
        </Button>
      </Table.Td>
      <Table.Td className={css.state ?? ""}>
        <Tooltip label={kept ?? translate("workTable.deleteDrawing")}>
          <ActionIcon
            variant="subtle"
            color="gray"
            size={32}
            aria-label={translate("workTable.deleteNamed", { name: drawing.name })}
            disabled={kept !== null}
            onClick={() => onDelete(row)}
            data-testid="delete-drawing"
          >
            <IconTrash size={17} stroke={1.6} />
          </ActionIcon>
        </Tooltip>
      </Table.Td>
    </Table.Tr>
  );
}
