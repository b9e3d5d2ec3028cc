/** The canvas: draws what the store holds, and passes on what the pointer does. */

import { useEffect, useRef, useState } from "react";
import { useScheme } from "../panels/shared/scheme";
import type { PictureCommands } from "../state/commands/picture";
import { useUiStore } from "../state/store";
import type { Insets } from "../viewer/camera";
import type { ViewerEvents } from "../viewer/contract";
import { NoWebGL, Viewer } from "../viewer/viewer";
import css from "./app.module.css";
import { viewerColours } from "./colours";
import { useViewerContents } from "./useViewerContents";
import { WebGlError } from "./WebGlError";

interface Props {
  /** What the picture shows and which keys it has, for screen readers. */
  readonly label: string;
  readonly events: ViewerEvents;
  readonly insets: Insets;
  onReady(commands: PictureCommands | null): void;
  onViewer?(viewer: Viewer | null, host: HTMLElement | null): void;
}

/** Label, events and insets are those of the first rendering. */
export function Canvas({ label, events, insets, onReady, onViewer }: Props) {
  const host = useRef<HTMLDivElement>(null);
  const canvas = useRef<HTMLCanvasElement>(null);
  const first = useRef({ events, insets, onViewer });
  const [viewer, setViewer] = useState<Viewer | null>(null);
  const [failure, setFailure] = useState<string | null>(null);
  const pin = useUiStore((ui) => ui.pin);
  const scheme = useScheme();

  useEffect(() => {
    if (host.current === null || canvas.current === null) return;
    const { events, insets, onViewer } = first.current;
    let created: Viewer;
    try {
      const colours = viewerColours(scheme);
      created = new Viewer(host.current, canvas.current, colours, events, insets);
    } catch (cause) {
      if (!(cause instanceof NoWebGL)) throw cause;
      setFailure(cause.message);
      return;
    }
    setViewer(created);
    onViewer?.(created, host.current);
    return () => {
      created.dispose();
      setViewer(null);
      onViewer?.(null, null);
    };
  }, [scheme]);

  useViewerContents(viewer, onReady);

  if (failure !== null) return <WebGlError why={failure} />;
  return (
    <div
      ref={host}
      className={css.picture}
      data-testid="picture"
      data-pin={pin === null ? undefined : pin.join()}
      // biome-ignore lint/a11y/noNoninteractiveTabindex: the arrow keys pan it
      tabIndex={0}
      role="img"
      aria-label={label}
    >
      {/* A canvas keeps its WebGL context: another scheme has a canvas of its own. */}
      <canvas key={scheme} ref={canvas} data-testid="canvas" />
    </div>
  );
}
