/** Command palette: commands of this step, places of the page, and drawings by name. */

import "@mantine/spotlight/styles.css";
import { Kbd } from "@mantine/core";
import { useDebouncedValue } from "@mantine/hooks";
import { createSpotlight, Spotlight, useSpotlight } from "@mantine/spotlight";
import { useInfiniteQuery } from "@tanstack/react-query";
import { translate } from "../../language/translate";
import { type Command, commandsOf, GROUPS } from "../../state/commands/commands";
import { GROUP_TITLES, keyTexts } from "../../state/commands/commandTexts";
import { PLACES } from "../../state/commands/places";
import { foundBy } from "../../state/commands/search";
import { queries } from "../../state/queries";
import { showDrawing } from "../../state/routes";
import { useUiStore } from "../../state/store";

/** Pause after which drawings are searched (ms), and how many of them are listed. */
const PAUSE = 200;
const DRAWINGS = 6;

const [store, palette] = createSpotlight();

/** Opens the palette with an empty search, or closes it. */
export function togglePalette(): void {
  // Emptied here and not after closing: what is typed while the last one fades out is kept.
  if (!store.getState().opened) store.updateState((state) => ({ ...state, query: "" }));
  palette.toggle();
}

/** `onDrawing`: whether the page of a drawing is shown, where its commands work. */
export function Palette({ onDrawing }: { onDrawing: boolean }) {
  const { query } = useSpotlight(store);
  const step = useUiStore((ui) => ui.step);
  const open = useUiStore((ui) => ui.drawing !== null);
  const drawings = useFoundDrawings(query.trim());
  const commands = (onDrawing ? commandsOf(step) : []).filter(
    ({ title, ready }) => foundBy(query, title) && ready(),
  );
  const places = PLACES.filter(
    ({ id, title }) => foundBy(query, title) && (id !== "drawing" || open),
  );
  const none = commands.length + places.length + drawings.length === 0;
  return (
    <Spotlight.Root
      store={store}
      shortcut={null}
      clearQueryOnClose={false}
      scrollable
      maxHeight={420}
      attributes={{ content: { "aria-label": translate("palette.commands") } }}
    >
      <Spotlight.Search
        placeholder={translate("palette.search")}
        aria-label={translate("palette.search")}
        data-testid="palette"
      />
      <Spotlight.ActionsList>
        {GROUPS.map((group) => (
          <Actions
            key={group}
            label={GROUP_TITLES[group]}
            actions={commands.filter((one) => one.group === group).map(actionOf)}
          />
        ))}
        <Actions
          label={translate("rail.places")}
          actions={places.map(({ id, title, show }) => ({ id: `place-${id}`, title, run: show }))}
        />
        <Actions label={translate("palette.drawings")} actions={drawings} />
        {none && <Spotlight.Empty>{translate("palette.nothingFound")}</Spotlight.Empty>}
      </Spotlight.ActionsList>
    </Spotlight.Root>
  );
}

interface Action {
  readonly id: string;
  readonly title: string;
  readonly keys?: string;
  run(): void;
}

const actionOf = (command: Command): Action => ({
  id: `command-${command.id}`,
  title: command.title,
  keys: keyTexts(command),
  run: command.run,
});

function Actions({ label, actions }: { label: string; actions: readonly Action[] }) {
  if (actions.length === 0) return null;
  return (
    <Spotlight.ActionsGroup label={label}>
      {actions.map(({ id, title, keys = "", run }) => (
        <Spotlight.Action
          key={id}
          label={title}
          rightSection={keys !== "" && <Kbd size="xs">{keys}</Kbd>}
          onClick={run}
          data-testid={id}
        />
      ))}
    </Spotlight.ActionsGroup>
  );
}

/** The drawings whose names contain what was typed; none while nothing is typed. */
function useFoundDrawings(typed: string): Action[] {
  const [search] = useDebouncedValue(typed, PAUSE);
  const { data } = useInfiniteQuery({ ...queries.orders({ search }), enabled: search !== "" });
  if (typed === "" || search === "") return [];
  const names = new Map(
    data?.pages.flatMap(({ rows }) => rows.map(({ drawing }) => [drawing.id, drawing.name])) ?? [],
  );
  return [...names].slice(0, DRAWINGS).map(([id, title]) => ({
    id: `drawing-${id}`,
    title,
    run: () => showDrawing(id),
  }));
}
