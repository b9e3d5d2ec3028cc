/** Small picture of a drawing, which is requested again if the server cannot make it now. */

import { useEffect, useState } from "react";

interface Props {
  readonly src: string;
  readonly className?: string | undefined;
}

/** Requests after the first one. */
const REPEATS = 5;
/** Pause before the first of them, doubled after each (ms). */
const PAUSE = 1000;

export function DrawingPicture({ src, className }: Props) {
  const [attempt, setAttempt] = useState(0);
  const [failed, setFailed] = useState(-1);
  useEffect(() => {
    if (failed < attempt || attempt >= REPEATS) return;
    const timer = window.setTimeout(() => setAttempt(attempt + 1), PAUSE * 2 ** attempt);
    return () => window.clearTimeout(timer);
  }, [attempt, failed]);
  return (
    <img
      // Another element is another request.
      key={attempt}
      className={className}
      src={src}
      alt=""
      loading="lazy"
      draggable={false}
      onError={() => setFailed(attempt)}
    />
  );
}
