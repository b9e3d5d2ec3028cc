/** The pages of a file with several pages: pictures from which the user chooses the drawing. */

import { IconCheck } from "@tabler/icons-react";
import type { Drawing, PageOfFile } from "../../api/client";
import { translate } from "../../language/translate";
import { messageText } from "../../messages/translateMessage";
import { useRefusal } from "../../state/accounts/accounts";
import { choosePage } from "../../state/actions";
import { pageRead } from "../../state/drawing/pages";
import { formatSize } from "../../state/format";
import { useDrawing, usePages } from "../../state/queries";
import { useUiStore } from "../../state/store";
import { Refusal } from "../accounts/Permitted";
import panels from "../shared/panels.module.css";
import { Section } from "../shared/Section";
import css from "./pages.module.css";

export function PagesPanel() {
  const { data: drawing } = useDrawing();
  const page = drawing === undefined ? null : pageRead(drawing);
  if (drawing === undefined || page === null) return null;
  return (
    <Section
      title={translate("pagesPanel.pagesOfTheFile")}
      aside={
        <span className={panels.rowFigure}>{translate("pagesPanel.pageIsRead", { page })}</span>
      }
    >
      <Pages drawing={drawing} read={page} />
    </Section>
  );
}

function Pages({ drawing, read }: { drawing: Drawing; read: number }) {
  const { data: pages, isError } = usePages(drawing.id);
  const refusal = useRefusal("POST /api/v1/drawings/{id}/pages/{page}");
  const busy = useUiStore((ui) => ui.upload !== null);
  if (isError)
    return <p className={panels.note}>{translate("pagesPanel.thePagesCannotBeShown")}</p>;
  if (pages === undefined)
    return <p className={panels.note}>{translate("pagesPanel.thePagesAreBeingRead")}</p>;
  return (
    <>
      <p className={panels.note}>{translate("pagesPanel.chooseAPageToOpen")}</p>
      <ul className={css.pages} data-testid="pages">
        {pages.map((page) => (
          <li key={page.page}>
            <button
              type="button"
              className={css.page}
              aria-current={page.page === read}
              disabled={page.page === read || page.edges === 0 || refusal !== null || busy}
              title={page.problem === null ? undefined : messageText(page.problem)}
              onClick={() => void choosePage(drawing, page.page)}
            >
              <Miniature page={page} />
              <span className={css.number}>
                {translate("pagesPanel.page", { page: page.page })}
                {page.page === read && (
                  <IconCheck size={13} aria-label={translate("pagesPanel.thePageThatIsRead")} />
                )}
              </span>
              {page.edges === 0 ? (
                <small>{translate("pagesPanel.noDrawing")}</small>
              ) : (
                <>
                  <small>{formatSize(page.width, page.height)}</small>
                  <small>{translate("pagesPanel.edges", { edges: page.edges })}</small>
                </>
              )}
            </button>
          </li>
        ))}
      </ul>
      <Refusal reason={refusal} />
    </>
  );
}

function Miniature({ page }: { page: PageOfFile }) {
  if (page.picture === "") return <span className={css.picture} />;
  const source = `data:image/svg+xml,${encodeURIComponent(page.picture)}`;
  return <img className={css.picture} src={source} alt="" draggable={false} />;
}
