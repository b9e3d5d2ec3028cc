/** Account of the person who uses the page; for administrators also users, keys and audit log. */

import {
  ActionIcon,
  Button,
  Indicator,
  Modal,
  MultiSelect,
  PasswordInput,
  Select,
  Tabs,
  TextInput,
  Tooltip,
} from "@mantine/core";
import { IconShieldLock } from "@tabler/icons-react";
import { type ReactNode, useState } from "react";
import { type AccessScope, accounts, type Me, type User, type UserRole } from "../api/accounts";
import { errorText } from "../messages/render";
import {
  createFirstAdmin,
  refreshKeys,
  refreshUsers,
  roleOf,
  signOut,
  useAudit,
  useKeys,
  useMe,
  useUsers,
} from "../state/accounts";
import { useMachines } from "../state/queries";
import { dateTimeText } from "../state/times";
import css from "./account.module.css";

const ROLES: readonly UserRole[] = ["viewer", "designer", "operator", "admin"];
const SCOPES: readonly AccessScope[] = [
  ...(["read", "order", "webhooks", "station", "gateway"] as const),
  ...ROLES,
];
const PERMITS: Readonly<Record<string, string>> = {
  viewer: "You can view drawings, jobs and machines, but not change them.",
  designer: "You can upload and change drawings and order jobs. An operator must release the jobs.",
  operator: "You can order, release and control jobs, and operate machines.",
  admin: "You can do everything, and manage the library, users and keys.",
};

/** Opens the dialog; a mark shows that there is no administrator. */
export function AccountButton() {
  const me = useMe();
  const [opened, setOpened] = useState(false);
  if (me === undefined) return null;
  const label = me.kind === "local" ? "Account: sign-in is not set up yet" : `Account: ${me.name}`;
  return (
    <>
      <Tooltip label={label}>
        <Indicator disabled={me.has_admin} color="orange" size={9} offset={9} withBorder>
          <ActionIcon
            variant="subtle"
            color="gray"
            size="lg"
            aria-label={label}
            onClick={() => setOpened(true)}
            data-testid="account"
          >
            <IconShieldLock size={18} stroke={1.6} />
          </ActionIcon>
        </Indicator>
      </Tooltip>
      <Modal opened={opened} onClose={() => setOpened(false)} title="Account" size="xl" centered>
        <Account me={me} />
      </Modal>
    </>
  );
}

function Account({ me }: { me: Me }) {
  if (!me.scopes.includes("admin")) return <Own me={me} />;
  return (
    <Tabs defaultValue="own" keepMounted={false}>
      <Tabs.List>
        <Tabs.Tab value="own">My account</Tabs.Tab>
        <Tabs.Tab value="users">Users</Tabs.Tab>
        <Tabs.Tab value="keys">API keys</Tabs.Tab>
        <Tabs.Tab value="audit">Audit log</Tabs.Tab>
      </Tabs.List>
      <Tabs.Panel value="own">
        <Own me={me} />
      </Tabs.Panel>
      <Tabs.Panel value="users">
        <Users />
      </Tabs.Panel>
      <Tabs.Panel value="keys">
        <Keys />
      </Tabs.Panel>
      <Tabs.Panel value="audit">
        <Audit />
      </Tabs.Panel>
    </Tabs>
  );
}

function Own({ me }: { me: Me }) {
  const role = roleOf(me.scopes);
  if (me.kind === "local") return me.has_admin ? null : <FirstAdmin />;
  if (me.kind === "device") return <PairedDevice me={me} />;
  return (
    <section className={css.section}>
      <p data-testid="account-name">
        {"Signed in as "}
        <strong>{me.name}</strong>
        {` (${role}). ${PERMITS[role] ?? ""}`}
      </p>
      <Button variant="default" onClick={() => void signOut()} data-testid="sign-out">
        Sign out
      </Button>
      {me.sign_in === "password" && <OwnPassword />}
      {me.sign_in === "oidc" && (
        <p>Your password and your role are managed by the provider with which you sign in.</p>
      )}
    </section>
  );
}

function PairedDevice({ me }: { me: Me }) {
  return (
    <section className={css.section}>
      <p data-testid="account-name">
        This device, <strong>{me.name}</strong>, is paired with {me.machines.join(", ")}. It may
        start, continue and move this machine, and sees its jobs.
      </p>
      <Button variant="default" onClick={() => void signOut()} data-testid="unpair">
        Unpair this device
      </Button>
    </section>
  );
}

/** A form that shows the result of its request: a confirmation or the error. */
function RequestForm({
  send,
  label,
  children,
}: {
  readonly send: (form: FormData) => Promise<string>;
  readonly label: string;
  readonly children: ReactNode;
}) {
  const [note, setNote] = useState({ text: "", failed: false });
  const action = async (form: FormData) => {
    try {
      setNote({ text: await send(form), failed: false });
    } catch (error) {
      setNote({ text: errorText(error as Error), failed: true });
    }
  };
  return (
    <form className={css.form} action={action} aria-label={label}>
      {children}
      <Button type="submit">{label}</Button>
      {note.text !== "" && (
        <p className={css.note} role={note.failed ? "alert" : "status"} data-failed={note.failed}>
          {note.text}
        </p>
      )}
    </form>
  );
}

const textOf = (form: FormData, name: string): string => String(form.get(name) ?? "");

function FirstAdmin() {
  const send = async (form: FormData) => {
    await createFirstAdmin(textOf(form, "name"), textOf(form, "password"));
    return "";
  };
  return (
    <section className={css.section} data-testid="first-admin">
      <p>
        No administrator exists yet. Every program on this computer has full access, and other
        computers have none. Create the first administrator here or with this command:
      </p>
      <pre className={css.command}>knifetip user add NAME --role admin</pre>
      <RequestForm send={send} label="Create the administrator">
        <TextInput label="Name" name="name" required maxLength={64} autoComplete="username" />
        <NewPassword />
      </RequestForm>
    </section>
  );
}

function NewPassword({ name = "password", label = "Password" }) {
  return (
    <PasswordInput
      label={label}
      description="At least ten characters"
      name={name}
      required
      minLength={10}
      autoComplete="new-password"
    />
  );
}

function OwnPassword() {
  const send = async (form: FormData) => {
    await accounts.changePassword(textOf(form, "current"), textOf(form, "new"));
    return "Password changed. Your other sessions were signed out.";
  };
  return (
    <RequestForm send={send} label="Change the password">
      <PasswordInput
        label="Current password"
        name="current"
        required
        autoComplete="current-password"
      />
      <NewPassword name="new" label="New password" />
    </RequestForm>
  );
}

function Users() {
  const { data: users = [] } = useUsers();
  const send = async (form: FormData) => {
    const name = textOf(form, "name");
    await accounts.createUser(name, textOf(form, "password"), textOf(form, "role") as UserRole);
    await refreshUsers();
    return `User ${name} created.`;
  };
  return (
    <section className={css.section} data-testid="users">
      <ul className={css.list}>
        {users.map((user) => (
          <UserRow key={user.name} user={user} />
        ))}
      </ul>
      <RequestForm send={send} label="Create a user">
        <TextInput label="Name" name="name" required maxLength={64} autoComplete="off" />
        <Select label="Role" name="role" data={[...ROLES]} defaultValue="designer" />
        <NewPassword />
      </RequestForm>
    </section>
  );
}

function UserRow({ user }: { user: User }) {
  const [fault, setFault] = useState("");
  const change = async (body: { role?: UserRole; active?: boolean }) => {
    try {
      await accounts.changeUser(user.name, body);
      setFault("");
    } catch (error) {
      setFault(errorText(error as Error));
    }
    await refreshUsers();
  };
  const last = user.signed_in === null ? "never signed in" : dateTimeText(user.signed_in);
  return (
    <li className={css.row}>
      <span className={css.main}>
        <strong>{user.name}</strong>
        <small>{user.active ? last : "disabled"}</small>
      </span>
      <Select
        aria-label={`Role of ${user.name}`}
        data={[...ROLES]}
        value={user.role}
        allowDeselect={false}
        onChange={(role) => void change({ role: role as UserRole })}
      />
      <Button variant="default" onClick={() => void change({ active: !user.active })}>
        {user.active ? "Disable" : "Enable"}
      </Button>
      {fault !== "" && (
        <p className={css.note} role="alert" data-failed>
          {fault}
        </p>
      )}
    </li>
  );
}

function Keys() {
  const { data: keys = [] } = useKeys();
  const [scopes, setScopes] = useState<AccessScope[]>(["order"]);
  const [machines, setMachines] = useState<string[]>([]);
  const { data: known = [] } = useMachines();
  const [secret, setSecret] = useState("");
  const send = async (form: FormData) => {
    const day = textOf(form, "expires");
    const expires = day === "" ? null : new Date(day).toISOString();
    const title = textOf(form, "title");
    const customer = textOf(form, "customer");
    setSecret(await accounts.createKey({ title, scopes, expires, customer, machines }));
    await refreshKeys();
    return "Copy the key now. It cannot be shown again.";
  };
  const revoke = async (id: string) => {
    await accounts.revokeKey(id);
    await refreshKeys();
  };
  return (
    <section className={css.section} data-testid="keys">
      <ul className={css.list}>
        {keys.map((key) => (
          <li key={key.id} className={css.row}>
            <span className={css.main}>
              <strong>{key.title}</strong>
              <small>
                {`${key.scopes.join(", ")} · ${key.used === null ? "never used" : `used ${dateTimeText(key.used)}`}`}
                {key.customer !== "" && ` · customer ${key.customer}`}
                {key.machines.length > 0 && ` · ${key.machines.join(", ")}`}
                {key.scopes.includes("gateway") && key.any_machine && " · any machine"}
                {key.expires !== null && ` · expires ${dateTimeText(key.expires)}`}
              </small>
            </span>
            {key.revoked === null ? (
              <Button variant="default" onClick={() => void revoke(key.id)}>
                Revoke
              </Button>
            ) : (
              <small>revoked</small>
            )}
          </li>
        ))}
      </ul>
      <RequestForm send={send} label="Create a key">
        <TextInput
          label="Used by"
          description="Program that uses the key"
          name="title"
          required
          maxLength={100}
        />
        <MultiSelect
          label="Scopes"
          description="No role lets a key start or move a machine: that is station"
          data={[...SCOPES]}
          value={scopes}
          onChange={(chosen) => setScopes(chosen as AccessScope[])}
        />
        <TextInput
          label="Customer (optional)"
          description="The key sees and orders only jobs of this customer"
          name="customer"
          maxLength={200}
        />
        <MultiSelect
          label="Machines (optional)"
          description="The key is for these machines only"
          data={known.map((machine) => machine.name)}
          value={machines}
          onChange={setMachines}
        />
        <TextInput label="Expires (optional)" name="expires" type="date" />
      </RequestForm>
      {secret !== "" && (
        <pre className={css.command} data-testid="key-secret">
          {secret}
        </pre>
      )}
    </section>
  );
}

function Audit() {
  const { data: entries = [] } = useAudit();
  return (
    <section className={css.section} data-testid="audit">
      <ul className={css.list}>
        {entries.map((entry) => (
          <li key={entry.id} className={css.row} data-failed={entry.outcome !== "done"}>
            <small>{dateTimeText(entry.at)}</small>
            <span className={css.main}>
              {`${entry.principal || "unknown"}: ${entry.action.replaceAll("_", " ")} ${entry.subject}`}
            </span>
            <small>{`${entry.outcome} · ${entry.peer}`}</small>
          </li>
        ))}
      </ul>
    </section>
  );
}
