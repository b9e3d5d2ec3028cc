/** Tablets and other browsers that are paired with a machine; administrators add and revoke them. */

import { Button } from "@mantine/core";
import { useState } from "react";
import { type ApiKey, accounts, type PairingCode } from "../api/accounts";
import { errorText } from "../messages/render";
import { refreshDevices, useDevices, useIsPermitted, useMe } from "../state/accounts";
import { dateTimeText } from "../state/times";
import css from "./account.module.css";
import panels from "./panels.module.css";

export function PairedDevices({ machine }: { machine: string }) {
  const me = useMe();
  const permitted = useIsPermitted("POST /api/v1/machines/{name}/pairing-codes");
  // Without accounts there is nothing to sign in to.
  const wanted = permitted && me?.kind !== "local";
  const { data: devices = [] } = useDevices(machine, wanted);
  const [code, setCode] = useState<PairingCode | null>(null);
  const [fault, setFault] = useState("");
  if (!wanted) return null;
  const change = async (act: () => Promise<void>) => {
    try {
      setFault("");
      await act();
    } catch (error) {
      setFault(errorText(error as Error));
    }
    await refreshDevices(machine);
  };
  return (
    <details
      className={css.devices}
      data-testid="paired-devices"
      onToggle={() => void refreshDevices(machine)}
    >
      <summary>Paired devices</summary>
      <ul className={css.list}>
        {devices.map((device) => (
          <Device key={device.id} device={device} change={change} />
        ))}
      </ul>
      <Button
        variant="default"
        onClick={() => void change(async () => setCode(await accounts.newPairingCode(machine)))}
        data-testid="new-pairing-code"
      >
        Pair a device
      </Button>
      {code !== null && (
        <p className={panels.note} role="status">
          Open <b>{globalThis.location.origin}/pair</b> on the device and enter{" "}
          <output className={css.code} data-testid="pairing-code">
            {code.code}
          </output>
          until {dateTimeText(code.expires)}. The code is for one device, which may then start and
          move this machine.
        </p>
      )}
      {fault !== "" && (
        <p className={css.note} role="alert" data-failed>
          {fault}
        </p>
      )}
    </details>
  );
}

interface DeviceProps {
  readonly device: ApiKey;
  change(act: () => Promise<void>): Promise<void>;
}

function Device({ device, change }: DeviceProps) {
  const used = device.used === null ? "not used yet" : `last used ${dateTimeText(device.used)}`;
  return (
    <li className={css.row} data-testid="paired-device">
      <span className={css.main}>
        <strong>{device.title}</strong>
        <small>{used}</small>
      </span>
      <Button
        variant="default"
        aria-label={`Revoke ${device.title}`}
        onClick={() => void change(() => accounts.revokeKey(device.id))}
      >
        Revoke
      </Button>
    </li>
  );
}
