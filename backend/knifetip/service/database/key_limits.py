"""key_limits: what an API key may see and order: jobs of one customer, jobs of some machines.

The repositories apply the limits of the acting principal to every job and drawing that they find,
so that no route can answer with one that its sender may not see.  Such an object is unknown to the
sender: the error is the one of an id that does not exist.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Any, Final

import sqlalchemy as sa

from knifetip.errors import AccessDenied
from knifetip.service.database.tables import Drawing, Job


@dataclass(frozen=True, slots=True)
class KeyLimits:
    """Limits of an API key; empty values limit nothing."""

    customer: str = ""
    machines: frozenset[str] = frozenset()

    def job_conditions(self) -> list[sa.ColumnElement[bool]]:
        """Return the conditions on the jobs that the key may see, as SQL expressions."""
        found: list[sa.ColumnElement[bool]] = []
        if self.customer:
            found.append(Job.customer == self.customer)
        if self.machines:
            found.append(Job.machine.in_(sorted(self.machines)))
        return found

    def drawing_conditions(self) -> list[sa.ColumnElement[bool]]:
        """Return the conditions on the drawings that the key may see, as SQL expressions."""
        return [Drawing.customer == self.customer] if self.customer else []

    def conditions(self, table: type[Drawing] | type[Job]) -> list[sa.ColumnElement[bool]]:
        """Return the conditions on the rows of a table that the key may see."""
        return self.job_conditions() if table is Job else self.drawing_conditions()

    def sees_machine(self, machine: str) -> bool:
        """Return whether the key may see a machine and order for it."""
        return not self.machines or machine in self.machines

    def sees_job(self, customer: str, machine: str) -> bool:
        """Return whether the key may see a job of a customer on a machine."""
        return self.customer in ("", customer) and self.sees_machine(machine)

    def check_machine(self, machine: str) -> None:
        """Raise ``AccessDenied`` if the key is not for a machine."""
        if not self.sees_machine(machine):
            raise AccessDenied(
                "key.other-machine",
                machine=machine[:80],
                machines=sorted(self.machines),
                source=["machine"],
            )

    def ordered_details(self, details: Mapping[str, Any]) -> Mapping[str, Any]:
        """Return the details of a new drawing or job, which gets the customer of the key.

        Raises
        ------
        AccessDenied
            The details name another customer.
        """
        if not self.customer:
            return details
        given = details.get("customer") or self.customer
        self.check_change({"customer": given})
        return {**details, "customer": given}

    def check_change(self, details: Mapping[str, Any]) -> None:
        """Raise ``AccessDenied`` if new details name another customer than that of the key."""
        given = details.get("customer", self.customer)
        if self.customer and given != self.customer:
            raise AccessDenied(
                "key.other-customer",
                customer=self.customer,
                given=str(given)[:80],
                source=["customer"],
            )


#: Limits of users, and of keys without limits.
UNLIMITED: Final = KeyLimits()
