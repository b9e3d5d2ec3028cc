/** The machines: a card each with its state, its queue, its tools and the way to its station. */

import { SimpleGrid, Title } from "@mantine/core";
import { translate } from "../language/translate";
import { AskOperator, OperatorButton } from "../panels/accounts/OperatorForm";
import { MachineCard } from "../panels/machines/MachineCard";
import panels from "../panels/shared/panels.module.css";
import { Note } from "../panels/shared/parts";
import { useMachines } from "../state/queries";
import "../messages/load";

export function MachinesPage() {
  const { data } = useMachines();
  // Those that are connected come first.
  const machines = data?.toSorted(
    (a, b) => Number(b.gateway === "connected") - Number(a.gateway === "connected"),
  );
  return (
    <main className={panels.page} data-testid="machines">
      <header className={panels.head}>
        <Title order={1} fz={22}>
          {translate("machinesPage.machines")}
        </Title>
        <OperatorButton compact />
      </header>
      <AskOperator />
      {machines?.length === 0 && <Note>{translate("app.thereIsNoMachine")}</Note>}
      <SimpleGrid cols={{ base: 1, md: 2 }} spacing={16} mt={8} style={{ alignItems: "start" }}>
        {machines?.map((machine) => (
          <MachineCard key={machine.name} machine={machine} />
        ))}
      </SimpleGrid>
    </main>
  );
}
