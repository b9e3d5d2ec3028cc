/** Small picture of a drawing; failed requests are repeated, because a busy server refuses them. */

import { useEffect, useState } from "react";

interface Props {
  readonly src: string;
  readonly className?: string | undefined;
}

/** Largest number of repeated requests. */
const REPEATS = 5;
/** Pause before the first repeated request (ms); each further pause is twice as long. */
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
      // A new key replaces the element, so that the browser sends the request again.
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
