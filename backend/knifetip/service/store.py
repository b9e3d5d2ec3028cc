"""The store: drawings, profiles, machines, boards, jobs and their events in SQLite or PostgreSQL.

A transition of a job is one UPDATE … WHERE state IN … in one transaction with its event.  If two
clients claim the same job, or two jobs need the same table, only one of them succeeds.  This is
ensured by the WHERE clause, by the epoch of the job (a number that increases with each owner), and
by a unique index that permits one job on the table of each machine.
"""

from __future__ import annotations

from collections.abc import Callable

from knifetip.service.accounts.audit_store import AuditStore
from knifetip.service.accounts.key_store import KeyStore
from knifetip.service.accounts.pairing_store import PairingStore
from knifetip.service.accounts.provider_users import ProviderUsers
from knifetip.service.accounts.session_store import SessionStore
from knifetip.service.accounts.user_store import UserStore
from knifetip.service.compiling.store import CompileStore
from knifetip.service.content.objects import open_objects
from knifetip.service.content.store import ContentStore
from knifetip.service.database.change_notifier import ChangeNotifier
from knifetip.service.database.engine import Database
from knifetip.service.database.schema import Migration
from knifetip.service.documents.store import DocumentStore
from knifetip.service.drawings.customer_answer_store import CustomerAnswerStore
from knifetip.service.drawings.store import DrawingStore
from knifetip.service.gateways.lease_sweep import LeaseSweep
from knifetip.service.gateways.store import GatewayStore
from knifetip.service.history.statistics_store import StatisticsStore
from knifetip.service.history.store import HistoryStore
from knifetip.service.http.answered_requests import AnsweredRequests
from knifetip.service.library.store import LibraryStore
from knifetip.service.lifecycle.event_store import EventStore
from knifetip.service.lifecycle.machine_queues import MachineQueues
from knifetip.service.lifecycle.transitions import Transitions
from knifetip.service.machines.station_store import StationStore
from knifetip.service.nestings.store import NestingStore
from knifetip.service.orders.command_keys import CommandKeys
from knifetip.service.orders.interrupted_jobs import InterruptedJobs
from knifetip.service.orders.operator_store import OperatorStore
from knifetip.service.orders.program_store import ProgramStore
from knifetip.service.orders.store import JobStore
from knifetip.service.profiles.store import ProfileStore
from knifetip.service.queues.store import QueueStore
from knifetip.service.runs.checks import CheckList
from knifetip.service.runs.claimed_jobs import ClaimedJobs
from knifetip.service.stock.store import StockStore
from knifetip.service.tools.check import ToolGate
from knifetip.service.tools.store import ToolStore
from knifetip.service.webhooks.queue import WebhookQueue
from knifetip.service.webhooks.store import WebhookStore


class Store:
    """The repositories of one database; safe to use from several threads and processes.

    Parameters
    ----------
    url
        ``sqlite:///FILE`` or ``postgresql://USER@HOST/NAME``.
    clock
        Returns the seconds since 1970; None for the clock of the database, see ``Database``.
    objects
        Folder or bucket for large values (see ``open_objects``); "" to keep them in the database.
    """

    def __init__(
        self, url: str, clock: Callable[[], float] | None = None, objects: str = ""
    ) -> None:
        self.database = Database(url, clock)
        self.contents = ContentStore(self.database, open_objects(objects))
        transitions = Transitions(self.database)
        self.drawings = DrawingStore(self.database, self.contents, transitions)
        self.customer_answers = CustomerAnswerStore(self.database)
        self.documents = DocumentStore(self.database)
        self.nestings = NestingStore(self.database)
        self.stock = StockStore(self.database)
        self.jobs = JobStore(self.database, self.contents, transitions)
        self.events = EventStore(self.database)
        self.compiles = CompileStore(self.database, self.contents, transitions)
        self.tools = ToolStore(self.database)
        self.library = LibraryStore(self.database)
        gate = ToolGate(self.tools, self.library)
        keys = CommandKeys(self.database, transitions)
        self.checks = CheckList(self.library)
        self.programs = ProgramStore(self.database, self.contents, transitions, keys)
        self.operators = OperatorStore(self.database, transitions, self.checks, gate, keys)
        self.interrupted = InterruptedJobs(self.database, transitions, keys)
        self.machines = MachineQueues(self.database)
        claimed = ClaimedJobs(self.database, transitions)
        self.gateways = GatewayStore(self.database, transitions, self.machines, claimed)
        self.queues = QueueStore(self.database, self.contents, transitions, claimed)
        self.leases = LeaseSweep(self.database, transitions, self.compiles, claimed)
        self.profiles = ProfileStore(self.database)
        self.stations = StationStore(self.database)
        self.history = HistoryStore(self.database)
        self.users = UserStore(self.database)
        self.provider_users = ProviderUsers(self.database, self.users)
        self.keys = KeyStore(self.database)
        self.pairing = PairingStore(self.database)
        self.answers = AnsweredRequests(self.database)
        self.sessions = SessionStore(self.database)
        self.audit = AuditStore(self.database)
        self.statistics = StatisticsStore(self.database)
        self.webhooks = WebhookStore(self.database)
        self.webhook_queue = WebhookQueue(self.database)

    @property
    def changes(self) -> ChangeNotifier:
        """Notifier that calls its subscribers after each transaction that wrote an event."""
        return self.database.changes

    def migrate(self) -> Migration | None:
        """Create or migrate the tables of the database; see ``Database.migrate``."""
        return self.database.migrate()

    def prepare(self, *, migrate: bool = False) -> Migration | None:
        """Make the tables of the database ready for a server; see ``Database.prepare``."""
        return self.database.prepare(migrate=migrate)

    def alive(self) -> bool:
        """Return True if the database answers a query, else raise the error of the database."""
        return self.database.alive()

    def close(self) -> None:
        """Close all connections."""
        self.database.close()
