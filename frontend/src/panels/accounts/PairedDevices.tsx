/** Tablets and other browsers that are paired with a machine; administrators add and revoke them. */

import { Button } from "@mantine/core";
import { useState } from "react";
import { type ApiKey, accounts, type PairingCode } from "../../api/accounts";
import { translate } from "../../language/translate";
import { translateRich } from "../../language/translateRich";
import { errorText } from "../../messages/translateMessage";
import { refreshDevices, useDevices, useIsPermitted, useMe } from "../../state/accounts/accounts";
import { dateTimeText } from "../../state/times";
import panels from "../shared/panels.module.css";
import css from "./account.module.css";

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
      <summary>{translate("pairedDevices.pairedDevices")}</summary>
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
        {translate("pairedDevices.pairADevice")}
      </Button>
      {code !== null && (
        <p className={panels.note} role="status">
          {translateRich("pairedDevices.openPairOnTheDevice", {
            origin: globalThis.location.origin,
            code: code.code,
            expires: dateTimeText(code.expires),
            b: (children) => <b>{children}</b>,
            output: (children) => (
              <output className={css.code} data-testid="pairing-code">
                {children}
              </output>
            ),
          })}
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
  const used =
    device.used === null
      ? translate("pairedDevices.notUsedYet")
      : translate("pairedDevices.lastUsed", { used: dateTimeText(device.used) });
  return (
    <li className={css.row} data-testid="paired-device">
      <span className={css.main}>
        <strong>{device.title}</strong>
        <small>{used}</small>
      </span>
      <Button
        variant="default"
        aria-label={translate("pairedDevices.revoke", { title: device.title })}
        onClick={() => void change(() => accounts.revokeKey(device.id))}
      >
        {translate("pairedDevices.revoke2")}
      </Button>
    </li>
  );
}
