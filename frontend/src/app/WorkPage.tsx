/** The start page: drawings and their orders as a table, or a welcome while there are none. */

import { Group, Skeleton, Stack, Title } from "@mantine/core";
import { useDebouncedValue } from "@mantine/hooks";
import type { OrdersFilter } from "../api/jobs";
import { translate } from "../language/translate";
import { errorText } from "../messages/translateMessage";
import { Permitted } from "../panels/accounts/Permitted";
import { ToCartons } from "../panels/cartons/ToCartons";
import panels from "../panels/shared/panels.module.css";
import { Note } from "../panels/shared/parts";
import { ShowMore } from "../panels/shared/ShowMore";
import { ChooseFile } from "../panels/work/ChooseFile";
import { Welcome } from "../panels/work/Welcome";
import { WorkFilters } from "../panels/work/WorkFilters";
import { WorkTable } from "../panels/work/WorkTable";
import { useOrders } from "../state/queries";
import type { WorkView } from "../state/routes";
import { groupByFile, PROGRESS } from "../state/work/orders";
import type { WorkFilter } from "../state/work/workFilter";
import type { WorkOrder } from "../state/work/workOrder";
import { prefetch } from "./views";

/** Pause after which a search begins (ms). */
const PAUSE = 250;

const wantedOf = (
  { search, progress, machine }: WorkFilter,
  { sort, reverse }: WorkOrder,
): OrdersFilter => ({
  search: search.trim(),
  state: [...PROGRESS[progress]],
  machine,
  sort,
  reverse,
});

export function WorkPage({ view }: { readonly view: WorkView }) {
  const { filter, order } = view;
  const [search] = useDebouncedValue(filter.search, filter.search === "" ? 0 : PAUSE);
  const wanted = { ...filter, search };
  const list = useOrders(wantedOf(wanted, order));
  const { data: rows, error } = list;
  const none = rows?.length === 0;
  const isUnfiltered =
    wanted.search.trim() === "" && wanted.progress === "all" && wanted.machine === "";
  if (none && isUnfiltered && !list.isPlaceholderData)
    return (
      <main className={panels.page}>
        <Welcome />
      </main>
    );
  return (
    <main className={panels.page} data-testid="work" onPointerEnter={() => prefetch("drawing")}>
      <header className={panels.head}>
        <Title order={1} fz={22}>
          {translate("workPage.work")}
        </Title>
        <Permitted request="POST /api/v1/drawings">
          <Group gap={10}>
            <ToCartons />
            <ChooseFile />
          </Group>
        </Permitted>
      </header>
      <WorkFilters view={view} />
      {error !== null && <Note role="alert">{errorText(error)}</Note>}
      {rows === undefined && error === null && (
        <Stack gap={8} mt={12} aria-hidden>
          {[1, 2, 3, 4].map((row) => (
            <Skeleton key={row} height={56} radius={8} />
          ))}
        </Stack>
      )}
      {none ? (
        <Note mt={16} role="status">
          {translate("workPage.nothingMeetsTheseConditions")}
        </Note>
      ) : (
        rows !== undefined && <WorkTable groups={groupByFile(rows)} view={view} />
      )}
      {list.hasNextPage && (
        <ShowMore busy={list.isFetchingNextPage} act={() => void list.fetchNextPage()} />
      )}
    </main>
  );
}
