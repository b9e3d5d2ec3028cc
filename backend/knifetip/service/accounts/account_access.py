"""Look up the users and API keys of requests, and sign users in."""

from __future__ import annotations

import asyncio
import time
from collections import Counter, OrderedDict
from collections.abc import Callable
from concurrent.futures import ThreadPoolExecutor
from functools import partial
from typing import Final, NamedTuple, TypeVar

from knifetip.errors import SignInRefused, SignInSlowDown
from knifetip.service.accounts.access_rules import Proof, RequestFacts, bearer_key
from knifetip.service.accounts.key_store import is_secret
from knifetip.service.accounts.provider_users import ProviderUser
from knifetip.service.accounts.sign_in_throttle import SignInThrottle
from knifetip.service.database.acting import DONE, REFUSED, ActingPrincipal
from knifetip.service.database.key_limits import KeyLimits
from knifetip.service.http.principal import SERVER_KEY, Principal, PrincipalKind
from knifetip.service.http.scopes import AccessScope, scopes_of, scopes_of_role
from knifetip.service.limits.clients import network_of
from knifetip.service.store import Store

T = TypeVar("T")

#: Time after which a change by another process takes effect in this one (s).
KEPT: Final = 1.0
_CREDENTIALS: Final = 4096  # greatest number of cached credentials
_AT_ONCE: Final = 2  # sign-ins of one address that may wait for the computation of a hash
#: Stands for the account in the throttle of pairing codes; no user has this name.
_PAIRING: Final = "pairing code"


class Pairing(NamedTuple):
    """A browser that was paired with a machine."""

    token: str  #: for its cookie
    machine: str  #: name of the machine


class Accounts:
    """Users and API keys of a server, for the access control.

    It has threads of its own, so that the requests of gateways do not wait for other requests.
    Results are cached for ``KEPT`` seconds.
    """

    def __init__(self) -> None:
        #: the store; None while the server starts
        self.store: Store | None = None
        self._threads = ThreadPoolExecutor(2, "accounts")
        self._hashing = ThreadPoolExecutor(2, "passwords")
        self._found: OrderedDict[tuple[str, bool], tuple[float, Principal | None]] = OrderedDict()
        self._throttle = SignInThrottle()
        self._hashes: Counter[str] = Counter()
        self._closed = False  # never becomes False again: there is always an administrator then
        self._checked = -KEPT
        self._clears = 0  # number of times that the cache was cleared

    def close(self) -> None:
        """Shut the threads down."""
        for pool in (self._threads, self._hashing):
            pool.shutdown(wait=False, cancel_futures=True)

    def clear_cache(self) -> None:
        """Clear the cache, because users or keys have changed."""
        self._found.clear()
        self._checked = -KEPT
        self._clears += 1

    async def proof(self, facts: RequestFacts, *, used: bool = True) -> Proof:
        """Return the owner of the credentials of a request, and whether an administrator exists.

        Parameters
        ----------
        facts
            Headers of the request.
        used
            Record the use of the session or of the key.
        """
        if self.store is None:
            return Proof()
        now = time.monotonic()
        if not self._closed and now - self._checked >= KEPT:
            clears = self._clears
            found = await self._run(self._threads, self.store.users.has_admin)
            self._closed = self._closed or found
            # What was read before a change is not kept.
            if clears == self._clears:
                self._checked = now
        bearer = bearer_key(facts.authorization)
        if bearer is not None:
            principal = await self._find(
                f"key {bearer}", lambda: self._owner_of_key(bearer, used), used
            )
        elif facts.user_session:
            token = facts.user_session
            principal = await self._find(
                f"session {token}", lambda: self._owner_of_cookie(token, used), used
            )
        else:
            principal = None
        return Proof(principal, self._closed)

    async def _find(
        self, credential: str, look_up: Callable[[], Principal | None], used: bool = True
    ) -> Principal | None:
        if len(credential) > 200:
            return None
        now = time.monotonic()
        # A look-up that is not a use is cached separately, so that the next use is recorded.
        place = credential, used
        found = self._found.get(place)
        if found is None or found[0] <= now:
            clears = self._clears
            found = now + KEPT, await self._run(self._threads, look_up)
            if clears == self._clears:
                self._found.pop(place, None)
                self._found[place] = found
                if len(self._found) > _CREDENTIALS:
                    self._found.popitem(last=False)
        return found[1]

    def _owner_of_cookie(self, token: str, used: bool = True) -> Principal | None:
        """Return the user of a session, or the paired device; None if both have ended."""
        if is_secret(token):
            return self._owner_of_key(token, used, PrincipalKind.DEVICE)
        return self._user(token, used)

    def _owner_of_key(
        self, secret: str, used: bool, kind: PrincipalKind = PrincipalKind.KEY
    ) -> Principal | None:
        assert self.store is not None
        row = self.store.keys.find(secret, used=used)
        # The secret of a device is accepted in its cookie only, and that of a program never there.
        if row is None or row.device != (kind is PrincipalKind.DEVICE):
            return None
        scopes = scopes_of(AccessScope(scope) for scope in row.scopes)
        limits = KeyLimits(row.customer, frozenset(row.machines))
        binds = AccessScope.GATEWAY in scopes and not row.any_machine
        return Principal(kind, row.title, row.id, scopes, limits, binds)

    def _user(self, token: str, used: bool = True) -> Principal | None:
        assert self.store is not None
        row = self.store.sessions.find(token, used=used)
        if row is None:
            return None
        scopes = scopes_of_role(AccessScope(row.role))
        return Principal(PrincipalKind.USER, row.name, row.id, scopes)

    async def sign_in(self, name: str, password: str, address: str) -> str:
        """Begin a session of a user and return its token.

        Parameters
        ----------
        name, password
            What the user has entered.
        address
            Address of the sender.

        Raises
        ------
        SignInRefused
            The name or the password is wrong, or the user is disabled.
        SignInSlowDown
            Too many sign-ins have failed for this name from this address, or too many sign-ins
            from this address are waiting.
        """
        account = name.strip().lower()[:64]
        sender = network_of(address)
        now = time.monotonic()
        pause = self._throttle.pause(account, sender, now)
        if pause or self._hashes[sender] >= _AT_ONCE:
            raise SignInSlowDown(pause or 1)
        # Counted before the result, so that simultaneous attempts do not share one free attempt.
        self._throttle.failed(account, sender, now)
        self._hashes[sender] += 1
        try:
            token = await self._run(
                self._hashing, lambda: self._open_session(account, password, address)
            )
        finally:
            self._hashes[sender] -= 1
            self._hashes += Counter()  # drops the addresses without sign-ins
        if token is None:
            raise SignInRefused("sign-in.wrong")
        self._throttle.succeeded(account, sender)
        return token

    def _open_session(self, account: str, password: str, address: str) -> str | None:
        assert self.store is not None
        user = self.store.users.authenticate(account, password)
        known = user is not None or self.store.users.exists(account)
        # A name that no user has is not recorded: it may be a password in the wrong field.
        acting = ActingPrincipal(
            kind=PrincipalKind.USER,
            name=account if known else "",
            id="",
            action="sign_in",
            subject_kind="user",
            subject=account if known else "",
            peer=address,
        )
        token = None if user is None else self.store.sessions.open(user)
        self.store.audit.write(acting, REFUSED if token is None else DONE)
        return token

    async def record_key_sign_in(self, address: str) -> None:
        """Write the entry of the audit log for a sign-in with the key of the server."""
        assert self.store is not None
        acting = ActingPrincipal(
            kind=SERVER_KEY.kind, name=SERVER_KEY.name, id="", action="sign_in", peer=address
        )
        await self._run(self._threads, partial(self.store.audit.write, acting, DONE))

    async def sign_in_at_provider(self, provider_user: ProviderUser, address: str) -> str:
        """Begin a session of a user of a provider and return its token.

        Parameters
        ----------
        provider_user
            The user, as the provider has confirmed it.
        address
            Address of the sender.

        Raises
        ------
        SignInRefused
            The attempt was used before, or the user has no role or is disabled.
        WrongState
            The user is the last administrator and would have another role.
        """
        token = await self._run(
            self._threads, lambda: self._open_provider_session(provider_user, address)
        )
        self.clear_cache()
        return token

    def _open_provider_session(self, provider_user: ProviderUser, address: str) -> str:
        assert self.store is not None
        user = self.store.provider_users.record_sign_in(provider_user)
        token = self.store.sessions.open(user)
        acting = ActingPrincipal(
            kind=PrincipalKind.USER,
            name=user.name,
            id="",
            action="sign_in",
            subject_kind="user",
            subject=user.name,
            peer=address,
        )
        self.store.audit.write(acting, DONE)
        return token

    async def user_of(self, token: str) -> Principal:
        """Return the user of a session that has just begun."""
        found = await self._find(f"session {token}", lambda: self._owner_of_cookie(token))
        if found is None:  # the user was disabled in the meantime
            raise SignInRefused("sign-in.wrong")
        return found

    async def sign_out(self, token: str) -> None:
        """End a session, or the pairing of a device."""
        await self._run(self._threads, lambda: self._close(token))
        self.clear_cache()

    def _close(self, token: str) -> None:
        assert self.store is not None
        if not is_secret(token):
            self.store.sessions.close(token)
            return
        row = self.store.keys.find(token, used=False)
        if row is not None and row.device:
            self.store.keys.revoke(row.id)

    async def pair(self, code: str, title: str, address: str) -> Pairing:
        """Pair a browser with the machine for which a code was made.

        Parameters
        ----------
        code, title
            The code, and the name of the device, as they were entered.
        address
            Address of the sender.

        Raises
        ------
        SignInRefused
            There is no such code, or it has expired or was used.
        SignInSlowDown
            Too many wrong codes were sent from this address.
        """
        sender = network_of(address)
        now = time.monotonic()
        if pause := self._throttle.pause(_PAIRING, sender, now):
            raise SignInSlowDown(pause)
        # Counted before the result, so that simultaneous attempts do not share one free attempt.
        self._throttle.failed(_PAIRING, sender, now)
        found = await self._run(self._threads, lambda: self._pair_device(code, title, address))
        if found is None:
            raise SignInRefused("sign-in.wrong-code")
        self._throttle.succeeded(_PAIRING, sender)
        self.clear_cache()
        return found

    def _pair_device(self, code: str, title: str, address: str) -> Pairing | None:
        assert self.store is not None
        found = self.store.pairing.pair(code, title)
        acting = ActingPrincipal(
            kind=PrincipalKind.DEVICE,
            name="" if found is None else found[0].title,
            id="",
            action="pair_device",
            subject_kind="machine",
            subject="" if found is None else found[0].machines[0],
            peer=address,
        )
        self.store.audit.write(acting, REFUSED if found is None else DONE)
        return None if found is None else Pairing(found[1], found[0].machines[0])

    @staticmethod
    async def _run(pool: ThreadPoolExecutor, call: Callable[[], T]) -> T:
        return await asyncio.get_running_loop().run_in_executor(pool, call)
