/** Search, conditions and order of the table of work. */

import { NativeSelect, SimpleGrid, TextInput } from "@mantine/core";
import { IconSearch } from "@tabler/icons-react";
import type { OrdersFilter } from "../../api/client";
import { translate } from "../../language/translate";
import { useMachines } from "../../state/queries";
import type { ProgressGroup } from "../../state/work/orders";

export interface WorkFilter {
  readonly search: string;
  readonly progress: ProgressGroup;
  /** "" for all machines */
  readonly machine: string;
  readonly sort: NonNullable<OrdersFilter["sort"]>;
}

export const NO_FILTER: WorkFilter = { search: "", progress: "all", machine: "", sort: "newest" };

const PROGRESS_CHOICES: readonly { value: ProgressGroup; label: string }[] = [
  { value: "all", label: translate("workFilters.allStates") },
  { value: "prepare", label: translate("workFilters.toPrepare") },
  { value: "ready", label: translate("workFilters.readyToSend") },
  { value: "machine", label: translate("workFilters.atTheMachine") },
  { value: "ended", label: translate("workFilters.ended") },
];

const SORTS: readonly { value: WorkFilter["sort"]; label: string }[] = [
  { value: "newest", label: translate("workFilters.newestFirst") },
  { value: "due", label: translate("workFilters.byDueTime") },
  { value: "customer", label: translate("workFilters.byCustomer") },
  { value: "name", label: translate("workFilters.byName") },
];

interface Props {
  readonly filter: WorkFilter;
  readonly onChange: (filter: WorkFilter) => void;
}

export function WorkFilters({ filter, onChange }: Props) {
  const { data: machines } = useMachines();
  const change = (part: Partial<WorkFilter>) => onChange({ ...filter, ...part });
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
        value={filter.sort}
        onChange={({ currentTarget }) =>
          change({ sort: currentTarget.value as WorkFilter["sort"] })
        }
        data-testid="work-sort"
      />
    </SimpleGrid>
  );
}
