/** Tablets and other browsers that are paired with a machine; administrators add and revoke them. */

import { Box, Button, Text } from "@mantine/core";
import { useState } from "react";
import { type ApiKey, accounts, type PairingCode } from "../../api/accounts";
import { translate } from "../../language/translate";
import { translateRich } from "../../language/translateRich";
import { errorText } from "../../messages/translateMessage";
import { refreshDevices, useDevices, useIsPermitted, useMe } from "../../state/accounts/accounts";
import { dateTimeText } from "../../state/times";
import { Note } from "../shared/parts";
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
    <Box
      component="details"
      px={8}
      pb={10}
      data-testid="paired-devices"
      onToggle={() => void refreshDevices(machine)}
    >
      <Text component="summary" fw={600}>
        {translate("pairedDevices.pairedDevices")}
      </Text>
      <ul>
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
        <Note role="status">
          {translateRich("pairedDevices.openPairOnTheDevice", {
            origin: globalThis.location.origin,
            code: code.code,
            expires: dateTimeText(code.expires),
            b: (children) => <b>{children}</b>,
            output: (children) => (
              <Text
                component="output"
                display="block"
                my={6}
                c="ink.0"
                fz={26}
                fw={700}
                lts="0.08em"
                data-testid="pairing-code"
              >
                {children}
              </Text>
            ),
          })}
        </Note>
      )}
      {fault !== "" && (
        <Text role="alert" c="var(--bad-ink)">
          {fault}
        </Text>
      )}
    </Box>
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
    <li className={css.item} data-testid="paired-device">
      <Box
        component="span"
        display="grid"
        flex="1 1 180px"
        miw={0}
        style={{ overflowWrap: "anywhere" }}
      >
        <div>
          <strong>{device.title}</strong>
        </div>
        <small>{used}</small>
      </Box>
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
