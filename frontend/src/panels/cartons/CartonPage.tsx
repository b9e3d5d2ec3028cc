/** The page of carton styles: a gallery, and the form and picture of the chosen style. */

import "../../messages/load";
import { Button, Text, Title } from "@mantine/core";
import { useQuery } from "@tanstack/react-query";
import { cartonService } from "../../api/cartons";
import { translate } from "../../language/translate";
import { errorText, messageText } from "../../messages/translateMessage";
import { DrawingPicture } from "../shared/DrawingPicture";
import { CartonEditor } from "./CartonEditor";
import css from "./cartons.module.css";

interface Props {
  /** Code of the chosen style; empty for the gallery. */
  readonly code: string;
}

export function CartonPage({ code }: Props) {
  const { data: styles, error } = useQuery({
    queryKey: ["cartons"],
    queryFn: ({ signal }) => cartonService.styles(signal),
    staleTime: Number.POSITIVE_INFINITY,
  });
  const open = styles?.find((style) => style.code === code);
  return (
    <main className={css.page} data-testid="cartons">
      {code !== "" && (
        <nav className={css.head} aria-label={translate("cartonPage.cartons")}>
          <Button component="a" href="#/cartons" variant="default" size="sm">
            {translate("cartonPage.allStyles")}
          </Button>
        </nav>
      )}
      {error !== null && (
        <Text c="var(--bad-ink)" role="alert">
          {errorText(error)}
        </Text>
      )}
      {code === "" && (
        <>
          <Title order={1} fz={22}>
            {translate("cartonPage.cartons")}
          </Title>
          <Text mb={16} c="ink.2">
            {translate("cartonPage.chooseAStyle")}
          </Text>
          <ul className={css.gallery}>
            {(styles ?? []).map((style) => (
              <li key={style.code}>
                <a
                  className={css.card}
                  href={`#/cartons/${encodeURIComponent(style.code)}`}
                  data-testid={`style-${style.code}`}
                >
                  <DrawingPicture
                    className={css.small}
                    src={`/api/v1/cartons/${encodeURIComponent(style.code)}/picture`}
                  />
                  <b>{messageText(style.name)}</b>
                  <span>{messageText(style.description)}</span>
                </a>
              </li>
            ))}
          </ul>
        </>
      )}
      {open !== undefined && <CartonEditor key={open.code} style={open} />}
      {code !== "" && styles !== undefined && open === undefined && (
        <Text role="alert">{translate("cartonPage.noSuchStyle", { code })}</Text>
      )}
    </main>
  );
}
