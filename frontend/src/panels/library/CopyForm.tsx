/** Asks for title and name of a copy, which belong to the person from then on. */

import { Button, Group, Text, TextInput } from "@mantine/core";
import { useQuery } from "@tanstack/react-query";
import { type FormEvent, useState } from "react";
import { type Definition, type LibraryEntry, libraryService } from "../../api/library";
import { translate } from "../../language/translate";
import { errorText } from "../../messages/translateMessage";
import { slugOf } from "../../state/drawing/draft";
import { refreshLibrary } from "../../state/library/definitions";
import { queries } from "../../state/queries";
import css from "./library.module.css";

interface Props {
  readonly definition: Definition;
  readonly onDone: (entry: Pick<LibraryEntry, "shelf" | "name">) => void;
  readonly onCancel: () => void;
}

export function CopyForm({ definition, onDone, onCancel }: Props) {
  const { shelf } = definition;
  const { data: entries = [] } = useQuery(queries.library());
  const [title, setTitle] = useState(`${definition.title} (copy)`);
  const [typed, setTyped] = useState<string | null>(null);
  const [failure, setFailure] = useState<string | null>(null);
  const name = typed ?? slugOf(title);
  const taken = entries.some((one) => one.shelf === shelf && one.name === name);
  const fault =
    name === ""
      ? translate("copyForm.giveItAName")
      : !/^[a-z0-9][a-z0-9_-]{0,63}$/.test(name)
        ? translate("copyForm.aNameHasSmallLetters")
        : taken
          ? translate("copyForm.thereIsAWithThis", { shelf })
          : null;
  const copy = async (event: FormEvent) => {
    event.preventDefault();
    if (fault !== null || title.trim() === "") return;
    try {
      const body = { ...definition.fields, title: title.trim() };
      const note = translate("copyForm.copiedFrom", { title: definition.title }).slice(0, 200);
      await libraryService.putDefinition({ shelf, name }, body, { version: null, note });
      await refreshLibrary();
      onDone({ shelf, name });
    } catch (error) {
      setFailure(error instanceof Error ? errorText(error) : String(error));
    }
  };
  return (
    <form
      className={css.group}
      onSubmit={copy}
      aria-label={translate("copyForm.copy", { title: definition.title })}
    >
      <div className={css.fields}>
        <TextInput
          label={translate("copyForm.titleOfTheCopy")}
          description={translate("copyForm.asItIsShownIn")}
          value={title}
          maxLength={200}
          error={title.trim() === "" ? translate("copyForm.giveItATitle") : null}
          onChange={(event) => setTitle(event.currentTarget.value)}
          data-autofocus
          data-testid="copy-title"
        />
        <TextInput
          label={translate("copyForm.nameOfTheCopy")}
          description={translate("copyForm.forGatewaysFilesAndRequests")}
          value={name}
          maxLength={64}
          error={fault}
          onChange={(event) => setTyped(event.currentTarget.value)}
          data-testid="copy-name"
        />
      </div>
      {failure !== null && (
        <Text my={8} c="var(--bad-ink)" role="alert">
          {failure}
        </Text>
      )}
      <Group gap={8} mt={8} align="flex-end">
        <Button
          type="submit"
          disabled={fault !== null || title.trim() === ""}
          data-testid="copy-save"
        >
          {translate("copyForm.makeTheCopy")}
        </Button>
        <Button variant="default" onClick={onCancel}>
          {translate("copyForm.cancel")}
        </Button>
      </Group>
    </form>
  );
}
