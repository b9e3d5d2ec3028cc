"""Components of a server, which routes use."""

from __future__ import annotations

import threading
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import Annotated, TypeVar

from fastapi import Depends, Request

from knifetip import tracing
from knifetip.model.stage import Stage
from knifetip.service.accounts.access_rules import AccessRules
from knifetip.service.database.change_notifier import ALL
from knifetip.service.drawings.answered_questions import AnsweredQuestions
from knifetip.service.limits.threads import GatewayThreads
from knifetip.service.limits.work_queue import WorkQueue
from knifetip.service.processes.pool import ProcessPool
from knifetip.service.processes.reported_stages import reported_stages
from knifetip.service.processes.warm_up import WarmUp
from knifetip.service.settings import Settings
from knifetip.service.store import Store

T = TypeVar("T")


@dataclass(slots=True)
class Service:
    """Components of one server, such as its store and its worker processes, for its routes."""

    settings: Settings
    access: AccessRules
    store: Store
    pool: ProcessPool
    work: WorkQueue
    orders: WorkQueue  #: of orders, which need no worker process
    warm_up: WarmUp
    answered_questions: AnsweredQuestions = field(default_factory=AnsweredQuestions)
    threads: GatewayThreads = field(default_factory=GatewayThreads)
    stopping: threading.Event = field(default_factory=threading.Event)
    ready: bool = False

    def stop(self) -> None:
        """End the event streams and the waiting claims of gateways, because the server stops."""
        self.stopping.set()
        self.store.changes.receive((ALL,))

    def run(self, task: Callable[..., T], *arguments: object) -> T:
        """Run ``task`` with the given arguments in a worker process, wait, and return its result.

        The task runs to its end even if the client of the request has gone.

        Raises
        ------
        KnifetipError
            The task raised this error, the task exceeded its time limit or memory limit, or the
            worker process died.
        TaskCancelled
            The server was stopped.
        TaskFailed
            The task raised an exception that is not a KnifetipError.
        """
        self.warm_up.wait("drawings")
        with tracing.span(f"task {task.__name__}"), reported_stages() as stages:

            def watch(stage: Stage, _fraction: float) -> bool:
                stages.enter(stage)
                return True

            return self.pool.run(task, *arguments, limit=self.settings.time_limit, watch=watch)


# A coroutine: FastAPI would run a plain function on a thread of the shared pool.
async def _service(request: Request) -> Service:
    service: Service = request.app.state.service
    return service


ServiceDep = Annotated[Service, Depends(_service)]
