/** A page that is fetched when it is first shown: see `views`. */

import { Button } from "@mantine/core";
import { Component, type ReactNode, Suspense } from "react";
import { translate } from "../language/translate";
import css from "./app.module.css";
import { PartNotFetched } from "./views";

interface PartProps {
  readonly children: ReactNode;
}

/** Shows its children as soon as they have been fetched, and until then that they are loading. */
export function Part({ children }: PartProps) {
  const loading = (
    <main className={css.loading}>
      <div role="status">
        <h1>{translate("part.loading")}</h1>
      </div>
    </main>
  );
  const failed = (
    <main className={css.notFetched} data-testid="not-fetched">
      <NotFetched />
    </main>
  );
  return (
    <FetchFailure instead={failed}>
      <Suspense fallback={loading}>{children}</Suspense>
    </FetchFailure>
  );
}

/** The server does not answer, or has been updated and has other files now: reloading helps. */
function NotFetched() {
  return (
    <div role="alert">
      <h1>{translate("part.thisPartOfThePage")}</h1>
      <p>{translate("part.theServerDoesNotRespond")}</p>
      <Button variant="default" onClick={() => window.location.reload()}>
        {translate("part.reloadThePage")}
      </Button>
    </div>
  );
}

interface FailureProps {
  readonly instead: ReactNode;
  readonly children: ReactNode;
}

interface FailureState {
  readonly error: unknown;
}

/** Shows something else instead of children that cannot be fetched; other errors are passed on. */
class FetchFailure extends Component<FailureProps, FailureState> {
  override state: FailureState = { error: null };

  static getDerivedStateFromError(error: unknown): FailureState {
    return { error };
  }

  override render() {
    const { error } = this.state;
    if (error === null) return this.props.children;
    if (error instanceof PartNotFetched) return this.props.instead;
    throw error;
  }
}
