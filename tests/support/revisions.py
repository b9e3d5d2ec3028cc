"""Revisions of the database: the steps of this version, and of a later one."""

from __future__ import annotations

import shutil
from pathlib import Path

from alembic.config import Config
from alembic.script import ScriptDirectory

from knifetip.service.database import migrations

#: A step of a later version: drawings get a column.
_LATER = """
import sqlalchemy as sa
from alembic import op

revision = "9000"
down_revision = "{newest}"


def upgrade():
    op.add_column("drawing", sa.Column("later", sa.String(8), nullable=False, server_default="new"))
"""


def alembic_settings() -> Config:
    """Return the settings of Alembic for the steps of this version."""
    settings = Config()
    settings.set_main_option("script_location", str(Path(migrations.__file__).parent))
    return settings


def all_revisions() -> list[str]:
    """Return the revisions of this version, newest first."""
    scripts = ScriptDirectory.from_config(alembic_settings())
    return [script.revision for script in scripts.walk_revisions()]


def newest_revision() -> str:
    """Return the newest revision of this version."""
    return all_revisions()[0]


def write_later_steps(folder: Path) -> None:
    """Write the steps of a later version of knifetip, with the revision 9000, to a new folder."""
    shutil.copytree(Path(migrations.__file__).parent, folder)
    (folder / "versions" / "9000_later.py").write_text(_LATER.format(newest=newest_revision()))
