/** The machines, or the one that the address names: a card each with its state, its queue, its tools and the way to its station. */

import { Button, SimpleGrid, Title } from "@mantine/core";
import { translate } from "../language/translate";
import { AskOperator, OperatorButton } from "../panels/accounts/OperatorForm";
import { MachineCard } from "../panels/machines/MachineCard";
import panels from "../panels/shared/panels.module.css";
import { Note } from "../panels/shared/parts";
import { useMachines } from "../state/queries";
import "../messages/load";
import { NotFound } from "./NotFound";

interface Props {
  /** Name of the only machine to show; "" shows all of them. */
  readonly shown: string;
}

export function MachinesPage({ shown }: Props) {
  const { data: all } = useMachines();
  const data = shown === "" ? all : all?.filter(({ name }) => name === shown);
  if (shown !== "" && data?.length === 0)
    return (
      <main className={panels.page}>
        <NotFound
          text={translate("stationPage.thereIsNoMachineNamed", { name: shown })}
          href="#/machines"
          label={translate("machinesPage.allMachines")}
        />
      </main>
    );
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
        {shown !== "" && (
          <Button component="a" href="#/machines" variant="default" data-testid="all-machines">
            {translate("machinesPage.allMachines")}
          </Button>
        )}
        <OperatorButton compact />
      </header>
      <AskOperator />
      {machines?.length === 0 && <Note>{translate("app.thereIsNoMachine")}</Note>}
      <SimpleGrid
        cols={shown === "" ? { base: 1, md: 2 } : 1}
        spacing={16}
        mt={8}
        style={{ alignItems: "start" }}
      >
        {machines?.map((machine) => (
          <MachineCard key={machine.name} machine={machine} />
        ))}
      </SimpleGrid>
    </main>
  );
}
