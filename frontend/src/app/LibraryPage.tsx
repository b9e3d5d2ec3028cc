/** The page of machines, boards and tools: a list, and the editor of the chosen entry. */

import "../messages/load";
import { Button, FileButton, Text, Title } from "@mantine/core";
import { useQuery } from "@tanstack/react-query";
import { useState } from "react";
import { useRoute } from "wouter";
import { navigate } from "wouter/use-hash-location";
import { type LibraryEntry, libraryService, type Shelf } from "../api/library";
import { translate } from "../language/translate";
import { errorText } from "../messages/translateMessage";
import { Permitted } from "../panels/accounts/Permitted";
import { DefinitionEditor } from "../panels/library/DefinitionEditor";
import css from "../panels/library/library.module.css";
import panels from "../panels/shared/panels.module.css";
import { savingOf } from "../state/accounts/accounts";
import { slugOf } from "../state/drawing/draft";
import { refreshLibrary, SHELF_TITLES } from "../state/library/definitions";
import { byTitle } from "../state/naturalOrder";
import { queries } from "../state/queries";
import { decodedPart, LIBRARY } from "../state/routes";
import { NotFound } from "./NotFound";

const SHELVES = Object.keys(SHELF_TITLES) as Shelf[];

/** Shelves that the list can be narrowed to; "" shows all of them. */
const TABS: readonly (readonly [Shelf | "", string])[] = [
  ["", translate("libraryPage.all")],
  ...SHELVES.map((shelf) => [shelf, SHELF_TITLES[shelf]] as const),
];

/** Show an entry of the library; null shows none. */
const setOpen = (entry: Pick<LibraryEntry, "shelf" | "name"> | null): void =>
  navigate(
    entry === null ? "/library" : `/library/${entry.shelf}/${encodeURIComponent(entry.name)}`,
  );

export function LibraryPage() {
  const { data: entries = [], isSuccess } = useQuery(queries.library());
  const [, params] = useRoute(LIBRARY);
  const shelf = SHELVES.find((one) => one === params?.shelf);
  const name = decodedPart(params?.name);
  const open = shelf === undefined || name === "" ? null : { shelf, name };
  const isMissing =
    open === null
      ? params?.shelf !== undefined && shelf === undefined
      : isSuccess && !entries.some((one) => one.shelf === shelf && one.name === name);
  const [fault, setFault] = useState("");
  const importFile = async (shelf: Shelf, file: File | null) => {
    if (file === null) return;
    const name = slugOf(file.name.replace(/\.toml$/i, "")) || "imported";
    const same = entries.find((one) => one.shelf === shelf && one.name === name);
    const version = same !== undefined && !same.shipped ? same.version : null;
    setFault("");
    try {
      const note = translate("libraryPage.importedFrom", { name: file.name }).slice(0, 200);
      await libraryService.putDefinition({ shelf, name }, await file.text(), { version, note });
      await refreshLibrary();
      setOpen({ shelf, name });
    } catch (error) {
      setFault(error instanceof Error ? errorText(error) : String(error));
    }
  };
  return (
    <div className={css.page} data-open={open !== null} data-testid="library">
      <nav className={css.list} aria-label={translate("libraryPage.machinesBoardsAndTools")}>
        <Title order={1} fz={17}>
          {translate("libraryPage.machinesBoardsAndTools")}
        </Title>
        <ul className={css.shelves} data-touch>
          {TABS.map(([one, title]) => (
            <li key={one}>
              <a
                href={one === "" ? "#/library" : `#/library/${one}`}
                aria-current={one === (shelf ?? "") && !isMissing ? "page" : undefined}
                data-testid={`shelf-${one || "all"}`}
              >
                {title}
              </a>
            </li>
          ))}
        </ul>
        {fault !== "" && (
          <Text my={8} c="var(--bad-ink)" role="alert">
            {fault}
          </Text>
        )}
        {SHELVES.filter((one) => shelf === undefined || one === shelf).map((shelf) => (
          <section key={shelf}>
            <Title order={2} fz={13} mt={20} mb={6} c="ink.2">
              {SHELF_TITLES[shelf]}
            </Title>
            {byTitle(entries.filter((one) => one.shelf === shelf)).map(
              ({ name, title, shipped, version }) => (
                <button
                  key={name}
                  type="button"
                  className={panels.pick}
                  aria-pressed={open?.shelf === shelf && open.name === name}
                  onClick={() => setOpen({ shelf, name })}
                  data-testid={`entry-${name}`}
                >
                  <Text span flex={1}>
                    {title || name}
                  </Text>
                  <Text span fz={11} c="ink.3" flex="none">
                    {shipped
                      ? translate("libraryPage.supplied")
                      : `${translate("libraryPage.own")} · ${translate("libraryPage.v", { version })}`}
                  </Text>
                </button>
              ),
            )}
            <Permitted request={savingOf(shelf)}>
              <FileButton accept=".toml" onChange={(file) => void importFile(shelf, file)}>
                {(props) => (
                  <Button {...props} size="sm" variant="subtle">
                    {translate("libraryPage.importFromATomlFile", { shelf })}
                  </Button>
                )}
              </FileButton>
            </Permitted>
          </section>
        ))}
      </nav>
      <main className={css.editor}>
        {isMissing ? (
          <NotFound
            text={
              open === null
                ? translate("app.thereIsNoSuchPage")
                : translate("libraryPage.thereIsNo", open)
            }
            href="#/library"
            label={translate("libraryPage.machinesBoardsAndTools")}
          />
        ) : open === null ? (
          <Text maw={560} fz={15}>
            {translate("libraryPage.chooseAMachineABoard")}
          </Text>
        ) : (
          <DefinitionEditor key={`${open.shelf} ${open.name}`} entry={open} onOpen={setOpen} />
        )}
      </main>
    </div>
  );
}
