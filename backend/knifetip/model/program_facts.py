"""What a job keeps about its program, each fact declared once.

From a field come the stored value (column ``facts`` of ``job``), the field of the REST API, and the
line of the page.  ``service.processes.tasks`` fills them in after the compile.
"""

from __future__ import annotations

from pydantic import Field

from knifetip.fields import Table


class ProgramFacts(Table):
    """Facts about the program of a job; those that are not 0 are lines of the page.

    The ``unit`` of a field is ``bytes``, ``mm``, ``s``, or empty for a number of things.  With
    ``listed``, the list of ended jobs shows it, too.
    """

    program_bytes: int = Field(
        default=0,
        ge=0,
        title="Size of the program",
        description="Size of the program (bytes), for controllers with a small memory; 0 before "
        "the job is compiled, or if an older version compiled it",
        json_schema_extra={"unit": "bytes"},
    )
    worked_length: float = Field(
        default=0.0,
        ge=0.0,
        title="Work per copy",
        description="Length that all tools work in the board in one copy (mm), each pass counted, "
        "such as for prices; 0 before the job is compiled, or if an older version compiled it",
        json_schema_extra={"unit": "mm", "listed": True},
    )
