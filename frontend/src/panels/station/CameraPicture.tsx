/** Picture of a camera of the station's computer, with a crosshair. */

import { Box, Text } from "@mantine/core";
import { useEffect, useRef, useState } from "react";
import { translate } from "../../language/translate";
import { WideButton } from "./parts";

export function CameraPicture() {
  const [open, setOpen] = useState(false);
  return (
    <>
      <WideButton onClick={() => setOpen(!open)} aria-expanded={open} data-testid="camera">
        {open ? translate("marksPanel.cameraOff") : translate("marksPanel.camera")}
      </WideButton>
      {open && <Live />}
    </>
  );
}

function Live() {
  const video = useRef<HTMLVideoElement>(null);
  const [denied, setDenied] = useState(false);
  useEffect(() => {
    let ended = false;
    let stream: MediaStream | null = null;
    const stop = () => {
      for (const track of stream?.getTracks() ?? []) track.stop();
    };
    const begin = async () => {
      try {
        // Absent on pages that are not served by HTTPS or from this computer.
        stream = await navigator.mediaDevices.getUserMedia({
          video: { facingMode: "environment" },
        });
      } catch {
        setDenied(true);
        return;
      }
      if (ended) stop();
      else if (video.current !== null) video.current.srcObject = stream;
    };
    void begin();
    return () => {
      ended = true;
      stop();
    };
  }, []);
  if (denied)
    return (
      <Text c="ink.2" role="status" data-testid="no-camera">
        {translate("marksPanel.noCamera")}
      </Text>
    );
  return (
    <Box pos="relative" lh={0}>
      <video ref={video} autoPlay muted playsInline style={{ width: "100%", borderRadius: 12 }} />
      <svg
        viewBox="-50 -50 100 100"
        aria-hidden
        style={{ position: "absolute", inset: 0, width: "100%", height: "100%" }}
      >
        <path d="M-50 0H50M0-50V50" stroke="var(--bad)" strokeWidth={0.5} />
        <circle r={6} fill="none" stroke="var(--bad)" strokeWidth={0.5} />
      </svg>
    </Box>
  );
}
