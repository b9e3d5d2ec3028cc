/** Search, conditions and order of the table of work. */

import { NativeSelect, SimpleGrid, TextInput } from "@mantine/core";
import { IconSearch } from "@tabler/icons-react";
import { translate } from "../../language/translate";
import { useMachines } from "../../state/queries";
import { showWork, type WorkView } from "../../state/routes";
import type { ProgressGroup } from "../../state/work/orders";
import type { WorkFilter } from "../../state/work/workFilter";
import type { WorkOrder } from "../../state/work/workOrder";

const PROGRESS_CHOICES: readonly { value: ProgressGroup; label: string }[] = [
  { value: "all", label: translate("workFilters.allStates") },
  { value: "prepare", label: translate("workFilters.toPrepare") },
  { value: "ready", label: translate("workFilters.readyToSend") },
  { value: "machine", label: translate("workFilters.atTheMachine") },
  { value: "ended", label: translate("workFilters.ended") },
];

const SORTS: readonly { value: WorkOrder["sort"]; label: string }[] = [
  { value: "newest", label: translate("workFilters.newestFirst") },
  { value: "due", label: translate("workFilters.byDueTime") },
  { value: "customer", label: translate("workFilters.byCustomer") },
  { value: "name", label: translate("workFilters.byName") },
  { value: "board", label: translate("workFilters.byBoard") },
  { value: "machine", label: translate("workFilters.byMachine") },
  { value: "state", label: translate("workFilters.byState") },
  { value: "time", label: translate("workFilters.byTime") },
];

export function WorkFilters({ view }: { readonly view: WorkView }) {
  const { data: machines } = useMachines();
  const { filter, order } = view;
  const change = (part: Partial<WorkFilter>) =>
    showWork({ ...view, filter: { ...filter, ...part } }, view);
  return (
    <SimpleGrid cols={{ base: 2, sm: 4 }} spacing={8} mb={12} role="search">
      <TextInput
        aria-label={translate("workFilters.search")}
        placeholder={translate("workFilters.search")}
        leftSection={<IconSearch size={16} aria-hidden />}
        value={filter.search}
        onChange={({ currentTarget }) => change({ search: currentTarget.value })}
        data-testid="work-search"
      />
      <NativeSelect
        aria-label={translate("workFilters.state")}
        data={[...PROGRESS_CHOICES]}
        value={filter.progress}
        onChange={({ currentTarget }) => change({ progress: currentTarget.value as ProgressGroup })}
        data-testid="work-progress"
      />
      <NativeSelect
        aria-label={translate("workFilters.machine")}
        data={[
          { value: "", label: translate("workFilters.allMachines") },
          ...(machines ?? []).map(({ name, title }) => ({ value: name, label: title || name })),
        ]}
        value={filter.machine}
        onChange={({ currentTarget }) => change({ machine: currentTarget.value })}
        data-testid="work-machine"
      />
      <NativeSelect
        aria-label={translate("workFilters.order")}
        data={[...SORTS]}
        value={order.sort}
        onChange={({ currentTarget }) =>
          showWork(
            { ...view, order: { sort: currentTarget.value as WorkOrder["sort"], reverse: false } },
            view,
          )
        }
        data-testid="work-sort"
      />
    </SimpleGrid>
  );
}
