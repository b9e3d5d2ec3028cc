/**
 * The service's events as they happen, across every break of the line.
 *
 * The browser's EventSource mends a dropped connection by itself (and says with Last-Event-ID how
 * far it heard) but gives up for good when the service answers with an error, as while it
 * restarts. So a closed one is opened anew, later and later, up to half a minute.
 */

export type ConnectionState = "connecting" | "open" | "broken";

/** As much of EventSource as is used here. */
export interface Source {
  readyState: number;
  onopen: ((event: Event) => void) | null;
  onerror: ((event: Event) => void) | null;
  addEventListener(name: string, listener: (event: MessageEvent<string>) => void): void;
  close(): void;
}

interface Listener {
  /** `event` is the name that the service gave it, `data` its parsed JSON. */
  onEvent: (event: string, data: unknown) => void;
  onConnection: (state: ConnectionState) => void;
}

const CLOSED = 2;
const SHORTEST_WAIT = 500;
const LONGEST_WAIT = 30_000;

/** Listen to these events until the returned function is called. */
export function listen(
  url: string,
  names: readonly string[],
  { onEvent, onConnection }: Listener,
  open: (url: string) => Source = (address) => new EventSource(address) as unknown as Source,
): () => void {
  let source: Source | null = null;
  let wait = SHORTEST_WAIT;
  let timer: ReturnType<typeof setTimeout> | undefined;
  let ended = false;

  const connect = () => {
    if (ended) return;
    onConnection("connecting");
    const line = open(url);
    source = line;
    line.onopen = () => {
      wait = SHORTEST_WAIT;
      onConnection("open");
    };
    line.onerror = () => {
      onConnection("broken");
      if (line.readyState !== CLOSED || ended) return;
      line.close();
      timer = setTimeout(connect, wait);
      wait = Math.min(wait * 2, LONGEST_WAIT);
    };
    for (const name of names) {
      line.addEventListener(name, (event) => {
        let data: unknown;
        try {
          data = JSON.parse(event.data);
        } catch {
          // A keep-alive without JSON carries no news.
          return;
        }
        onEvent(name, data);
      });
    }
  };

  connect();
  return () => {
    ended = true;
    clearTimeout(timer);
    source?.close();
  };
}
