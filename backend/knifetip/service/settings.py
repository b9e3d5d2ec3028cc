"""Settings of the server and of its other processes: each is declared once, as a field.

From the field come the command-line option, the environment variable, the key of the settings file,
and the row of the page ``docs/settings.md`` (ADR 132).  A value of the command line precedes one of
the environment, which precedes one of the file.
"""

from __future__ import annotations

import tomllib
from pathlib import Path
from typing import TYPE_CHECKING, Annotated, Any, Final, NamedTuple, TypeVar

from annotated_types import Ge, Le
from pydantic import BeforeValidator, Field, ValidationError
from pydantic_core import ErrorDetails
from pydantic_settings import (
    BaseSettings,
    InitSettingsSource,
    NoDecode,
    PydanticBaseSettingsSource,
    SettingsConfigDict,
)

from knifetip import logs
from knifetip.errors import SettingsError
from knifetip.fields import fault_message
from knifetip.logs import LogFormat, LogLevel
from knifetip.messages import Message

if TYPE_CHECKING:
    from knifetip.service.accounts.oidc.settings import OidcSettings

#: Beginning of the names of environment variables.
PREFIX: Final = "KNIFETIP_"

MEGABYTE: Final = 1 << 20
#: All clients together may have so many times as many connections and listeners as one.
_CLIENTS: Final = 8
_MOST = 5  # faults in one error


class FormerName(NamedTuple):
    """Annotation of a field: the name that its option and its variable had before."""

    name: str


class FileOnly:
    """Annotation of a field that only the file and the environment set, so that --help stays
    short.
    """


Loaded = TypeVar("Loaded", bound=BaseSettings)
Days = Annotated[int, Ge(0), Le(100_000)]
#: Values with spaces between them in the environment, as command-line options have them too.
Texts = Annotated[
    tuple[str, ...],
    NoDecode,
    BeforeValidator(lambda value: value.split() if isinstance(value, str) else value),
]


class _File(InitSettingsSource):
    """Values of the settings file, without those that only other processes need."""

    def __init__(self, kind: type[BaseSettings], file: Path | None) -> None:
        found = {} if file is None else _read_file(file)
        others = Settings.model_fields.keys() - kind.model_fields.keys()
        super().__init__(kind, {name: value for name, value in found.items() if name not in others})


def _read_file(file: Path) -> dict[str, Any]:
    try:
        return tomllib.loads(file.read_text("utf-8"))
    except (OSError, UnicodeDecodeError, tomllib.TOMLDecodeError) as reason:
        raise SettingsError("settings.bad-file", file=file, reason=reason) from reason


class ProcessSettings(BaseSettings):
    """Settings of every process that runs for a long time: its settings file, log and metrics."""

    model_config = SettingsConfigDict(
        env_prefix=PREFIX,
        env_ignore_empty=True,
        extra="forbid",
        frozen=True,
        allow_inf_nan=False,
        hide_input_in_errors=True,
    )

    settings: Path | None = Field(
        default=None,
        description="TOML file with settings, each under its name. "
        "Options of the command line and variables of the environment precede it",
    )
    metrics_address: str = Field(
        default="",
        description="HOST:PORT at which Prometheus reads metrics without a key, such as "
        "127.0.0.1:9464. Everybody who reaches it sees names of machines and numbers of jobs. "
        "Default: none",
    )
    log_format: LogFormat = Field(
        default=LogFormat.TEXT, description="Form of the log: one line of text or of JSON each"
    )
    log_level: LogLevel = Field(
        default=LogLevel.WARNING,
        description="Least severe records of the log; info has a record for each request",
    )

    @classmethod
    def settings_customise_sources(
        cls,
        settings_cls: type[BaseSettings],
        init_settings: PydanticBaseSettingsSource,
        env_settings: PydanticBaseSettingsSource,
        dotenv_settings: PydanticBaseSettingsSource,  # noqa: ARG003  # there is no such file
        file_secret_settings: PydanticBaseSettingsSource,  # noqa: ARG003  # secrets have files of their own
    ) -> tuple[PydanticBaseSettingsSource, ...]:
        """Return the sources of values, the first first: arguments, environment, settings file."""
        file = init_settings().get("settings") or env_settings().get("settings")
        return init_settings, env_settings, _File(settings_cls, Path(file) if file else None)

    def configure_log(self) -> None:
        """Set up the log of this process."""
        logs.configure(self.log_format, self.log_level)


class DatabaseSettings(BaseSettings):
    """The database of a process or command."""

    model_config = SettingsConfigDict(env_prefix=PREFIX, env_ignore_empty=True, frozen=True)

    database: str = Field(
        default="sqlite:///knifetip.sqlite",
        description="SQLAlchemy URL of an SQLite or PostgreSQL database",
        repr=False,
    )
    database_password_file: Path | None = Field(
        default=None,
        description="File that contains the password of the database, so that it is not in the URL",
    )

    @property
    def url(self) -> str:
        """URL of the database, with its password."""
        if self.database_password_file is None:
            return self.database
        from knifetip.service.database.url import add_password  # slow to import

        return add_password(self.database, self.database_password_file)

    @property
    def shown(self) -> str:
        """URL of the database without its password, for output."""
        from knifetip.service.database.url import hide_password

        return hide_password(self.database)


class StorageSettings(DatabaseSettings):
    """The database, and the place of large values."""

    store: str = Field(
        default="",
        description="Folder or bucket for drawings and programs beyond 4 kB: file:///FOLDER or "
        "s3://BUCKET/PREFIX, the same for all servers and workers of a database. Default: the "
        "database",
    )


class CompilingSettings(ProcessSettings, StorageSettings):
    """Settings of the processes that compile jobs: servers and workers."""

    name: str = Field(
        default="",
        description="Name of this process among those of the database; give the same name after a "
        "restart. Default: the name of the computer and a stored random suffix",
    )


class Settings(CompilingSettings):
    """Settings of a server."""

    host: str = Field(
        default="127.0.0.1",
        description="IP address or host name to listen on; 0.0.0.0 for all networks",
    )
    port: int = Field(
        default=8080, ge=0, le=65535, description="TCP port to listen on; 0 chooses a free port"
    )
    speed: float = Field(
        default=1.0,
        ge=0.01,
        le=100_000.0,
        description="Speed of the simulated machine as a multiple of real time",
    )
    samples: bool = Field(default=True, description="Add the sample drawings to a new database")
    simulator: bool = Field(
        default=True, description="Also run a simulated machine with its gateway"
    )
    compiles: bool = Field(
        default=True,
        description="Compile jobs in this process. With --no-compiles, the command `knifetip "
        "worker` must run in another process",
    )
    keep_jobs: Annotated[Days, FormerName("keep_history")] = Field(
        default=0,
        description="Days after which ended jobs are deleted; events, statistics and the use of "
        "tools remain. 0 keeps all jobs",
    )
    keep_drawings: Days = Field(
        default=0,
        description="Days after their upload after which drawings without jobs are deleted. 0 "
        "keeps all drawings",
    )
    archive: Path | None = Field(
        default=None,
        description="Folder in which a zip file of each job and each drawing is written before it "
        "is deleted",
    )
    webhook_private: bool = Field(
        default=True,
        description="Permit webhooks to loopback and private addresses, where the ERP system of a "
        "shop usually is",
    )
    key: str = Field(
        default="",
        repr=False,
        description="Access key that requests from other computers must send. Default: no key; "
        "the server then accepts only requests from this computer",
    )
    key_file: Path | None = Field(
        default=None,
        description="File that contains the access key. If the file does not exist, the server "
        "creates it with a random key",
    )
    allow_host: Texts = Field(
        default=(),
        description="NAME or NAME:PORT that the Host header may contain besides the server's "
        "addresses; may be repeated",
    )
    oidc_issuer: str = Field(
        default="",
        description="URL of a provider of OpenID Connect at which users can sign in. Needs the "
        "extra `oidc`. Default: none",
    )
    oidc_client_id: str = Field(default="", description="Name of this server at the provider")
    oidc_client_secret_file: Path | None = Field(
        default=None,
        description="File that contains the secret of this server at the provider",
    )
    oidc_roles_claim: str = Field(
        default="roles",
        description="Claim of the ID token that contains the roles or groups of a user; a.b for "
        "the member b of the claim a",
    )
    oidc_role: Texts = Field(
        default=(),
        description="VALUE=ROLE: users with this value in the claim have the role viewer, "
        "designer, operator or admin; may be repeated. Others cannot sign in",
    )
    oidc_title: str = Field(
        default="",
        description="Name of the provider on the sign-in page. Default: its host name",
    )
    public_url: str = Field(
        default="",
        description="URL of this server for browsers, such as https://knifetip.example behind a "
        "proxy; the provider sends browsers back to it, and job tickets contain it. Default: that "
        "of each request",
    )
    fonts: Annotated[Texts, FileOnly()] = Field(
        default=(),
        description="Files of TrueType or OpenType fonts for letters of job tickets that the fonts "
        "of knifetip lack, such as Chinese; several with spaces between them",
    )
    max_rate: int = Field(
        default=200,
        ge=0,
        le=100_000,
        description="Requests of a client in a second on average; 0 for no limit. Requests of "
        "gateways are not limited",
    )
    max_burst: int = Field(
        default=2000,
        ge=1,
        le=1_000_000,
        description="Requests that a client may send at once after a pause",
    )
    max_listeners: int = Field(
        default=64,
        ge=1,
        le=100_000,
        description="Open pages and other streams of events of a client; all clients together may "
        "have eight times as many",
    )
    max_connections: int = Field(
        default=256,
        ge=1,
        le=100_000,
        description="Connections of an address; all addresses together may have eight times as "
        "many. Behind a proxy, all clients have its address",
    )
    max_upload: int = Field(
        default=64, ge=1, le=1024, description="Largest drawing that can be uploaded (MB)"
    )
    min_free: int = Field(
        default=256,
        ge=0,
        le=1_000_000,
        description="Space that is kept free on the disk for running jobs (MB): with less, uploads "
        "and orders are refused, and /readyz reports it",
    )
    processes: Annotated[int, FileOnly()] = Field(
        default=2, ge=1, le=64, description="Processes that read drawings and compile jobs"
    )
    max_waiting: Annotated[int, FileOnly()] = Field(
        default=16, ge=1, le=10_000, description="Requests that may wait for a process"
    )
    time_limit: Annotated[float, FileOnly()] = Field(
        default=120.0,
        gt=0.0,
        le=3600.0,
        description="Time in which a drawing must be read or a job compiled (s)",
    )
    max_body: Annotated[int, FileOnly()] = Field(
        default=16, ge=1, le=1024, description="Largest request that is no upload (MB)"
    )
    max_all_listeners: Annotated[int | None, FileOnly()] = Field(
        default=None,
        ge=1,
        le=1_000_000,
        description="Streams of events of all clients. Default: eight times `max_listeners`",
    )
    page: Annotated[Path, FileOnly()] = Field(
        default=Path(__file__).parent / "page", description="Folder of the built page"
    )

    @property
    def upload_bytes(self) -> int:
        """Maximum size of a drawing (bytes)."""
        return self.max_upload * MEGABYTE

    @property
    def body_bytes(self) -> int:
        """Maximum size of a request that is no upload (bytes)."""
        return self.max_body * MEGABYTE

    @property
    def free_bytes(self) -> int:
        """Space that must remain free on the disk (bytes)."""
        return self.min_free * MEGABYTE

    @property
    def all_listeners(self) -> int:
        """Streams of events of all clients."""
        return self.max_all_listeners or _CLIENTS * self.max_listeners

    @property
    def all_connections(self) -> int:
        """Connections of all addresses."""
        return _CLIENTS * self.max_connections

    def sign_in_provider(self) -> OidcSettings | None:
        """Return the provider at which users can sign in; None without one.

        Raises
        ------
        SettingsError
            A setting is missing or malformed, or authlib is not installed.
        """
        from knifetip.service.accounts.oidc.settings import read_settings  # imported here: slow

        return read_settings(
            self.oidc_issuer,
            self.oidc_client_id,
            secret_file=self.oidc_client_secret_file,
            roles_claim=self.oidc_roles_claim,
            roles=self.oidc_role,
            title=self.oidc_title,
            public_url=self.public_url,
        )


class WorkerSettings(CompilingSettings):
    """Settings of a compile worker."""

    processes: int = Field(
        default=1, ge=1, le=64, description="Number of jobs to compile at the same time"
    )


def load_settings(kind: type[Loaded], **given: Any) -> Loaded:
    """Return settings from given values, the environment and the settings file.

    Parameters
    ----------
    kind
        Class of the settings.
    given
        Values of the command line by name; they precede the others.

    Raises
    ------
    SettingsError
        The settings file cannot be read, or a value is invalid or unknown.
    """
    try:
        return kind(**given)
    except ValidationError as reason:
        faults = reason.errors(include_url=False)[:_MOST]
        raise SettingsError(
            "settings.invalid",
            faults=[_fault(kind, fault) for fault in faults],
        ) from None


def _fault(kind: type[BaseSettings], fault: ErrorDetails) -> Message:
    path = ".".join(map(str, fault["loc"]))
    return fault_message(fault, path, lambda: sorted(kind.model_fields))
