"""All tables of the first release."""

import sqlalchemy as sa
from alembic import op

revision = "0131"
down_revision = None
branch_labels = None
depends_on = None

SERIAL = sa.BigInteger().with_variant(sa.Integer(), "sqlite")


def upgrade() -> None:
    op.create_table(
        "answered_request",
        sa.Column("key", sa.String(200), nullable=False),
        sa.Column("fingerprint", sa.String(64), nullable=False),
        sa.Column("created", sa.Double(), nullable=False),
        sa.Column("status", sa.Integer(), nullable=False),
        sa.Column("headers", sa.JSON(), nullable=False),
        sa.Column("body", sa.LargeBinary(), nullable=False),
        sa.PrimaryKeyConstraint("key"),
    )
    op.create_index("answered_request_by_time", "answered_request", ["created"])
    op.create_table(
        "api_key",
        sa.Column("id", sa.String(32), nullable=False),
        sa.Column("title", sa.String(100), nullable=False),
        sa.Column("digest", sa.String(64), nullable=False),
        sa.Column("scopes", sa.JSON(), nullable=False),
        sa.Column("customer", sa.String(200), nullable=False),
        sa.Column("machines", sa.JSON(), nullable=False),
        sa.Column("device", sa.Boolean(), nullable=False),
        sa.Column("any_machine", sa.Boolean(), nullable=False),
        sa.Column("created", sa.Double(), nullable=False),
        sa.Column("created_by", sa.String(200), nullable=False),
        sa.Column("expires", sa.Double(), nullable=True),
        sa.Column("used", sa.Double(), nullable=True),
        sa.Column("revoked", sa.Double(), nullable=True),
        sa.PrimaryKeyConstraint("id"),
    )
    op.create_table(
        "audit",
        sa.Column("id", SERIAL, autoincrement=True, nullable=False),
        sa.Column("at", sa.Double(), nullable=False),
        sa.Column("kind", sa.String(16), nullable=False),
        sa.Column("principal", sa.String(200), nullable=False),
        sa.Column("action", sa.String(80), nullable=False),
        sa.Column("subject_kind", sa.String(32), nullable=False),
        sa.Column("subject", sa.String(200), nullable=False),
        sa.Column("outcome", sa.String(8), nullable=False),
        sa.Column("peer", sa.String(80), nullable=False),
        sa.PrimaryKeyConstraint("id"),
        sqlite_autoincrement=True,
    )
    op.create_index("audit_by_subject", "audit", ["subject"])
    op.create_index("audit_by_time", "audit", ["at"])
    op.create_table(
        "content",
        sa.Column("address", sa.String(64), nullable=False),
        sa.Column("unused_since", sa.Double(), nullable=True),
        sa.Column("data", sa.LargeBinary(), nullable=True),
        sa.PrimaryKeyConstraint("address"),
    )
    op.create_table(
        "database_version",
        sa.Column("id", SERIAL, autoincrement=True, nullable=False),
        sa.Column("version", sa.String(64), nullable=False),
        sa.Column("revision", sa.String(32), nullable=False),
        sa.Column("at", sa.Double(), nullable=False),
        sa.PrimaryKeyConstraint("id"),
    )
    op.create_table(
        "event",
        sa.Column("id", SERIAL, autoincrement=True, nullable=False),
        sa.Column("kind", sa.String(8), nullable=False),
        sa.Column("subject", sa.String(32), nullable=False),
        sa.Column("at", sa.Double(), nullable=False),
        sa.Column("state", sa.String(16), nullable=False),
        sa.Column("who", sa.String(200), nullable=False),
        sa.Column(
            "message",
            sa.JSON(),
            nullable=True,
        ),
        sa.PrimaryKeyConstraint("id"),
        sqlite_autoincrement=True,
    )
    op.create_index("event_by_subject", "event", ["subject"])
    op.create_table(
        "gateway",
        sa.Column("machine", sa.String(200), nullable=False),
        sa.Column("name", sa.String(200), nullable=False),
        sa.Column("seen", sa.Double(), nullable=False),
        sa.PrimaryKeyConstraint("machine", "name"),
    )
    op.create_table(
        "library_entry",
        sa.Column("shelf", sa.String(16), nullable=False),
        sa.Column("name", sa.String(64), nullable=False),
        sa.Column("version", sa.Integer(), nullable=False),
        sa.PrimaryKeyConstraint("shelf", "name"),
    )
    op.create_table(
        "library_version",
        sa.Column("shelf", sa.String(16), nullable=False),
        sa.Column("name", sa.String(64), nullable=False),
        sa.Column("version", sa.Integer(), nullable=False),
        sa.Column("title", sa.String(200), nullable=False),
        sa.Column("text", sa.Text(), nullable=False),
        sa.Column("at", sa.Double(), nullable=False),
        sa.Column("by", sa.String(100), nullable=False),
        sa.Column("note", sa.String(200), nullable=False),
        sa.PrimaryKeyConstraint("shelf", "name", "version"),
    )
    op.create_table(
        "machine_run",
        sa.Column("id", SERIAL, autoincrement=True, nullable=False),
        sa.Column("job", sa.String(32), nullable=False),
        sa.Column("epoch", sa.Integer(), nullable=False),
        sa.Column("machine", sa.String(200), nullable=False),
        sa.Column("board", sa.String(200), nullable=False),
        sa.Column("started", sa.Double(), nullable=False),
        sa.Column("ended", sa.Double(), nullable=False),
        sa.Column("outcome", sa.String(16), nullable=False),
        sa.Column("copies", sa.Integer(), nullable=False),
        sa.Column("sheets", sa.Integer(), nullable=False),
        sa.PrimaryKeyConstraint("id"),
        sa.UniqueConstraint("job", "epoch", name="one_run_of_a_claim"),
    )
    op.create_index("run_by_end", "machine_run", ["machine", "ended"])
    op.create_index("run_by_end_of_all", "machine_run", ["ended"])
    op.create_index("run_by_machine", "machine_run", ["machine", "id"])
    op.create_table(
        "operation",
        sa.Column("serial", SERIAL, autoincrement=True, nullable=False),
        sa.Column("id", sa.String(32), nullable=False),
        sa.Column("machine", sa.String(200), nullable=False),
        sa.Column("request", sa.JSON(), nullable=False),
        sa.Column("state", sa.String(8), nullable=False),
        sa.Column(
            "message",
            sa.JSON(),
            nullable=True,
        ),
        sa.Column("asked", sa.Double(), nullable=False),
        sa.Column("handed", sa.Double(), nullable=True),
        sa.Column("renewed", sa.Double(), nullable=True),
        sa.PrimaryKeyConstraint("serial"),
        sa.UniqueConstraint("id"),
    )
    op.create_index("operation_by_state", "operation", ["machine", "state"])
    op.create_table(
        "pairing_code",
        sa.Column("digest", sa.String(64), nullable=False),
        sa.Column("machine", sa.String(200), nullable=False),
        sa.Column("created_by", sa.String(200), nullable=False),
        sa.Column("expires", sa.Double(), nullable=False),
        sa.PrimaryKeyConstraint("digest"),
    )
    op.create_table(
        "profile",
        sa.Column("name", sa.String(64), nullable=False),
        sa.Column("title", sa.String(200), nullable=False),
        sa.Column("text", sa.Text(), nullable=False),
        sa.Column("version", sa.Integer(), nullable=False),
        sa.Column("created", sa.Double(), nullable=False),
        sa.Column("updated", sa.Double(), nullable=False),
        sa.PrimaryKeyConstraint("name"),
    )
    op.create_table(
        "refused_look",
        sa.Column("customer", sa.String(200), nullable=False),
        sa.Column("token", sa.String(64), nullable=False),
        sa.Column("look", sa.JSON(), nullable=False),
        sa.Column("at", sa.Double(), nullable=False),
        sa.PrimaryKeyConstraint("customer", "token"),
    )
    op.create_table(
        "station",
        sa.Column("machine", sa.String(200), nullable=False),
        sa.Column("gateway", sa.String(200), nullable=False),
        sa.Column("reported", sa.Double(), nullable=False),
        sa.Column("watched", sa.Double(), nullable=False),
        sa.Column("hands_clear", sa.Double(), nullable=False),
        sa.Column("connected", sa.Boolean(), nullable=False),
        sa.Column("state", sa.String(16), nullable=False),
        sa.Column(
            "alarm",
            sa.JSON(),
            nullable=True,
        ),
        sa.Column(
            "obstacle",
            sa.JSON(),
            nullable=True,
        ),
        sa.Column("position", sa.JSON(), nullable=True),
        sa.Column("outputs", sa.JSON(), nullable=False),
        sa.Column("outputs_known", sa.Boolean(), nullable=False),
        sa.Column("operations", sa.JSON(), nullable=False),
        sa.Column("spindle", sa.Integer(), nullable=True),
        sa.Column("override", sa.Integer(), nullable=True),
        sa.Column("activity", sa.JSON(), nullable=True),
        sa.Column(
            "notices",
            sa.JSON(),
            nullable=False,
        ),
        sa.PrimaryKeyConstraint("machine"),
    )
    op.create_table(
        "taught_drawing",
        sa.Column("drawing", sa.String(32), nullable=False),
        sa.Column("customer", sa.String(200), nullable=False),
        sa.Column("name", sa.String(200), nullable=False),
        sa.Column("sha256", sa.String(64), nullable=False),
        sa.Column("at", sa.Double(), nullable=False),
        sa.Column("unit", sa.String(8), nullable=False),
        sa.Column("uses", sa.JSON(), nullable=False),
        sa.PrimaryKeyConstraint("drawing"),
    )
    op.create_index(
        "taught_drawing_by_customer", "taught_drawing", ["customer", "at"], unique=False
    )
    op.create_table(
        "tool_event",
        sa.Column("id", SERIAL, autoincrement=True, nullable=False),
        sa.Column("machine", sa.String(200), nullable=False),
        sa.Column("station", sa.Integer(), nullable=False),
        sa.Column("kind", sa.String(8), nullable=False),
        sa.Column("at", sa.Double(), nullable=False),
        sa.Column("who", sa.String(200), nullable=False),
        sa.Column("length", sa.Double(), nullable=False),
        sa.Column("unfinished", sa.Double(), nullable=False),
        sa.Column("worked_before", sa.Double(), nullable=False),
        sa.PrimaryKeyConstraint("id"),
    )
    op.create_index("tool_event_by_machine", "tool_event", ["machine", "station"])
    op.create_table(
        "tool_work",
        sa.Column("machine", sa.String(200), nullable=False),
        sa.Column("station", sa.Integer(), nullable=False),
        sa.Column("length", sa.Double(), nullable=False),
        sa.PrimaryKeyConstraint("machine", "station"),
    )
    op.create_table(
        "used_sign_in",
        sa.Column("digest", sa.String(64), nullable=False),
        sa.Column("at", sa.Double(), nullable=False),
        sa.PrimaryKeyConstraint("digest"),
    )
    op.create_table(
        "user_account",
        sa.Column("id", sa.String(32), nullable=False),
        sa.Column("name", sa.String(64), nullable=False),
        sa.Column("kind", sa.String(16), nullable=False),
        sa.Column("subject", sa.String(64), nullable=True),
        sa.Column("role", sa.String(16), nullable=False),
        sa.Column("password", sa.String(200), nullable=False),
        sa.Column("active", sa.Boolean(), nullable=False),
        sa.Column("created", sa.Double(), nullable=False),
        sa.Column("created_by", sa.String(200), nullable=False),
        sa.Column("signed_in", sa.Double(), nullable=True),
        sa.PrimaryKeyConstraint("id"),
        sa.UniqueConstraint("name"),
    )
    op.create_index("user_account_by_subject", "user_account", ["subject"], unique=True)
    op.create_table(
        "webhook",
        sa.Column("serial", SERIAL, autoincrement=True, nullable=False),
        sa.Column("id", sa.String(32), nullable=False),
        sa.Column("url", sa.String(2000), nullable=False),
        sa.Column("description", sa.String(200), nullable=False),
        sa.Column("event_types", sa.JSON(), nullable=False),
        sa.Column("secret", sa.String(100), nullable=False),
        sa.Column("previous_secret", sa.String(100), nullable=False),
        sa.Column("previous_until", sa.Double(), nullable=False),
        sa.Column("active", sa.Boolean(), nullable=False),
        sa.Column("created", sa.Double(), nullable=False),
        sa.Column("created_by", sa.String(200), nullable=False),
        sa.Column("owner", sa.String(80), nullable=False),
        sa.Column("customer", sa.String(200), nullable=False),
        sa.Column("machines", sa.JSON(), nullable=False),
        sa.Column("failures", sa.Integer(), nullable=False),
        sa.Column("resume_at", sa.Double(), nullable=False),
        sa.PrimaryKeyConstraint("serial"),
        sa.UniqueConstraint("id"),
    )
    op.create_table(
        "write_probe",
        sa.Column("id", sa.Integer(), nullable=False),
        sa.Column("at", sa.Double(), nullable=False),
        sa.PrimaryKeyConstraint("id"),
    )
    op.create_table(
        "browser_session",
        sa.Column("digest", sa.String(64), nullable=False),
        sa.Column("user", sa.String(32), nullable=False),
        sa.Column("created", sa.Double(), nullable=False),
        sa.Column("seen", sa.Double(), nullable=False),
        sa.Column("expires", sa.Double(), nullable=False),
        sa.ForeignKeyConstraint(
            ["user"],
            ["user_account.id"],
        ),
        sa.PrimaryKeyConstraint("digest"),
    )
    op.create_index(op.f("ix_browser_session_user"), "browser_session", ["user"])
    op.create_table(
        "drawing",
        sa.Column("serial", SERIAL, autoincrement=True, nullable=False),
        sa.Column("id", sa.String(32), nullable=False),
        sa.Column("name", sa.String(200), nullable=False),
        sa.Column("created", sa.Double(), nullable=False),
        sa.Column("sha256", sa.String(64), nullable=False),
        sa.Column("unit_given", sa.String(8), nullable=False),
        sa.Column("unit_learned", sa.JSON(), nullable=False),
        sa.Column("profile", sa.String(200), nullable=False),
        sa.Column("version", sa.Integer(), nullable=False),
        sa.Column("rules", sa.Text(), nullable=False),
        sa.Column("learned", sa.Text(), nullable=False),
        sa.Column("summary", sa.JSON(), nullable=False),
        sa.Column("key", sa.String(200), nullable=True),
        sa.Column("fingerprint", sa.String(64), nullable=False),
        sa.Column("updated", sa.Double(), nullable=False),
        sa.Column("owner", sa.String(80), nullable=False),
        sa.Column("shared", sa.Boolean(), nullable=False),
        sa.Column("external_id", sa.String(200), nullable=False),
        sa.Column("customer", sa.String(200), nullable=False),
        sa.Column("due", sa.Double(), nullable=True),
        sa.Column("notes", sa.Text(), nullable=False),
        sa.Column("metadata", sa.JSON(), nullable=False),
        sa.Column("content_address", sa.String(64), nullable=True),
        sa.Column("overrides_address", sa.String(64), nullable=True),
        sa.Column("edges_address", sa.String(64), nullable=True),
        sa.Column("import_report_address", sa.String(64), nullable=True),
        sa.ForeignKeyConstraint(
            ["content_address"],
            ["content.address"],
        ),
        sa.ForeignKeyConstraint(
            ["edges_address"],
            ["content.address"],
        ),
        sa.ForeignKeyConstraint(
            ["import_report_address"],
            ["content.address"],
        ),
        sa.ForeignKeyConstraint(
            ["overrides_address"],
            ["content.address"],
        ),
        sa.PrimaryKeyConstraint("serial"),
        sa.UniqueConstraint("id"),
        sa.UniqueConstraint("key"),
    )
    op.create_index("drawing_by_created", "drawing", ["created"])
    op.create_index("drawing_by_customer", "drawing", ["customer", "serial"])
    op.create_index("drawing_by_due", "drawing", ["due"])
    op.create_index("drawing_by_external_id", "drawing", ["external_id", "serial"])
    op.create_index("drawing_by_sha256", "drawing", ["sha256"])
    op.create_index("drawing_by_updated", "drawing", ["updated"])
    op.create_index(
        op.f("ix_drawing_content_address"), "drawing", ["content_address"], unique=False
    )
    op.create_index(op.f("ix_drawing_edges_address"), "drawing", ["edges_address"])
    op.create_index(
        op.f("ix_drawing_import_report_address"), "drawing", ["import_report_address"], unique=False
    )
    op.create_index(
        op.f("ix_drawing_overrides_address"), "drawing", ["overrides_address"], unique=False
    )
    op.create_table(
        "run_length",
        sa.Column("run", SERIAL, nullable=False),
        sa.Column("station", sa.Integer(), nullable=False),
        sa.Column("line_type", sa.String(16), nullable=False),
        sa.Column("length", sa.Double(), nullable=False),
        sa.ForeignKeyConstraint(["run"], ["machine_run.id"], ondelete="CASCADE"),
        sa.PrimaryKeyConstraint("run", "station", "line_type"),
    )
    op.create_table(
        "webhook_delivery",
        sa.Column("serial", SERIAL, autoincrement=True, nullable=False),
        sa.Column("id", sa.String(40), nullable=False),
        sa.Column("webhook", SERIAL, nullable=False),
        sa.Column("event_type", sa.String(40), nullable=False),
        sa.Column("subject", sa.String(32), nullable=False),
        sa.Column("payload", sa.Text(), nullable=False),
        sa.Column("created", sa.Double(), nullable=False),
        sa.Column("state", sa.String(10), nullable=False),
        sa.Column("due", sa.Double(), nullable=False),
        sa.Column("lease", sa.Double(), nullable=False),
        sa.Column("tries", sa.Integer(), nullable=False),
        sa.Column("attempts", sa.JSON(), nullable=False),
        sa.Column("traceparent", sa.String(55), nullable=False),
        sa.ForeignKeyConstraint(["webhook"], ["webhook.serial"], ondelete="CASCADE"),
        sa.PrimaryKeyConstraint("serial"),
        sa.UniqueConstraint("id"),
    )
    op.create_index("delivery_by_webhook", "webhook_delivery", ["webhook", "serial"])
    op.create_index(
        "delivery_due",
        "webhook_delivery",
        ["webhook", "due", "serial"],
        sqlite_where=sa.text("state = 'pending'"),
        postgresql_where=sa.text("state = 'pending'"),
    )
    op.create_index(
        "delivery_of_subject",
        "webhook_delivery",
        ["webhook", "subject", "serial"],
        sqlite_where=sa.text("state = 'pending'"),
        postgresql_where=sa.text("state = 'pending'"),
    )
    op.create_table(
        "drawing_document",
        sa.Column("owner", SERIAL, nullable=False),
        sa.Column("kind", sa.String(40), nullable=False),
        sa.Column("version", sa.String(200), nullable=False),
        sa.Column("content", sa.LargeBinary(), nullable=False),
        sa.ForeignKeyConstraint(["owner"], ["drawing.serial"], ondelete="CASCADE"),
        sa.PrimaryKeyConstraint("owner", "kind"),
    )
    op.create_table(
        "drawing_metadata",
        sa.Column("token", sa.String(40), nullable=False),
        sa.Column("owner", SERIAL, nullable=False),
        sa.ForeignKeyConstraint(["owner"], ["drawing.serial"], ondelete="CASCADE"),
        sa.PrimaryKeyConstraint("token", "owner"),
    )
    op.create_index("drawing_metadata_by_owner", "drawing_metadata", ["owner"])
    op.create_table(
        "job",
        sa.Column("serial", SERIAL, autoincrement=True, nullable=False),
        sa.Column("id", sa.String(32), nullable=False),
        sa.Column("state", sa.String(16), nullable=False),
        sa.Column("drawing", sa.String(32), nullable=False),
        sa.Column("drawing_name", sa.String(200), nullable=False),
        sa.Column("machine", sa.String(200), nullable=False),
        sa.Column("board", sa.String(200), nullable=False),
        sa.Column("machine_version", sa.Integer(), nullable=False),
        sa.Column("board_version", sa.Integer(), nullable=False),
        sa.Column("profile", sa.String(200), nullable=False),
        sa.Column("rules", sa.Text(), nullable=False),
        sa.Column("learned", sa.Text(), nullable=False),
        sa.Column("unit_given", sa.String(8), nullable=False),
        sa.Column("copies", sa.Integer(), nullable=False),
        sa.Column("priority", sa.Integer(), nullable=False),
        sa.Column("release", sa.Boolean(), nullable=False),
        sa.Column("created", sa.Double(), nullable=False),
        sa.Column("updated", sa.Double(), nullable=False),
        sa.Column("queued", sa.Double(), nullable=False),
        sa.Column("rank", sa.Double(), nullable=False),
        sa.Column("on_hold", sa.Boolean(), nullable=False),
        sa.Column(
            "check_refusal",
            sa.JSON(),
            nullable=True,
        ),
        sa.Column("ended", sa.Double(), nullable=False),
        sa.Column(
            "message",
            sa.JSON(),
            nullable=True,
        ),
        sa.Column("source", sa.JSON(), nullable=False),
        sa.Column("edges", sa.JSON(), nullable=False),
        sa.Column("questions", sa.JSON(), nullable=False),
        sa.Column("attempt", sa.Integer(), nullable=False),
        sa.Column("epoch", sa.Integer(), nullable=False),
        sa.Column("owner", sa.String(200), nullable=False),
        sa.Column("lease", sa.Double(), nullable=False),
        sa.Column("owner_epoch", sa.Integer(), nullable=False),
        sa.Column("confirmation", sa.String(8), nullable=False),
        sa.Column("tools", sa.JSON(), nullable=False),
        sa.Column("requested_action", sa.String(8), nullable=False),
        sa.Column("phase", sa.Integer(), nullable=False),
        sa.Column("stage", sa.String(80), nullable=False),
        sa.Column("progress", sa.Double(), nullable=False),
        sa.Column("line", sa.Integer(), nullable=False),
        sa.Column("lines", sa.Integer(), nullable=False),
        sa.Column("copies_done", sa.Integer(), nullable=False),
        sa.Column("copies_before", sa.Integer(), nullable=False),
        sa.Column("position", sa.JSON(), nullable=True),
        sa.Column("seconds", sa.Double(), nullable=False),
        sa.Column("seconds_left", sa.Double(), nullable=True),
        sa.Column("program_sha256", sa.String(64), nullable=False),
        sa.Column("verdict_summary", sa.JSON(), nullable=True),
        sa.Column("compile_key", sa.String(64), nullable=False),
        sa.Column("program_of", sa.String(32), nullable=False),
        sa.Column("key", sa.String(200), nullable=True),
        sa.Column("fingerprint", sa.String(64), nullable=False),
        sa.Column("options", sa.JSON(), nullable=False),
        sa.Column("exceptions", sa.JSON(), nullable=True),
        sa.Column("resumes", sa.String(32), nullable=True),
        sa.Column("rest", sa.JSON(), nullable=True),
        sa.Column("stopped_at", sa.JSON(), nullable=True),
        sa.Column("ordered_by", sa.String(80), nullable=False),
        sa.Column("claimed_by", sa.String(80), nullable=False),
        sa.Column("feeds", sa.Boolean(), nullable=False),
        sa.Column("awaits_end", sa.Boolean(), nullable=False),
        sa.Column("begun", sa.Boolean(), nullable=False),
        sa.Column("traceparent", sa.String(55), nullable=False),
        sa.Column("external_id", sa.String(200), nullable=False),
        sa.Column("customer", sa.String(200), nullable=False),
        sa.Column("due", sa.Double(), nullable=True),
        sa.Column("notes", sa.Text(), nullable=False),
        sa.Column("metadata", sa.JSON(), nullable=False),
        sa.Column("overrides_address", sa.String(64), nullable=True),
        sa.Column("program_address", sa.String(64), nullable=True),
        sa.Column("toolpath_address", sa.String(64), nullable=True),
        sa.Column("verdict_address", sa.String(64), nullable=True),
        sa.Column("lengths", sa.LargeBinary(), nullable=True),
        sa.ForeignKeyConstraint(
            ["drawing"],
            ["drawing.id"],
        ),
        sa.ForeignKeyConstraint(
            ["overrides_address"],
            ["content.address"],
        ),
        sa.ForeignKeyConstraint(
            ["program_address"],
            ["content.address"],
        ),
        sa.ForeignKeyConstraint(
            ["toolpath_address"],
            ["content.address"],
        ),
        sa.ForeignKeyConstraint(
            ["verdict_address"],
            ["content.address"],
        ),
        sa.PrimaryKeyConstraint("serial"),
        sa.UniqueConstraint("id"),
        sa.UniqueConstraint("key"),
    )
    op.create_index(op.f("ix_job_drawing"), "job", ["drawing"])
    op.create_index(op.f("ix_job_overrides_address"), "job", ["overrides_address"])
    op.create_index(op.f("ix_job_program_address"), "job", ["program_address"])
    op.create_index(op.f("ix_job_resumes"), "job", ["resumes"])
    op.create_index(op.f("ix_job_toolpath_address"), "job", ["toolpath_address"])
    op.create_index(op.f("ix_job_verdict_address"), "job", ["verdict_address"])
    op.create_index("job_by_compile_key", "job", ["compile_key", "serial"])
    op.create_index("job_by_created", "job", ["created"])
    op.create_index("job_by_customer", "job", ["customer", "serial"])
    op.create_index("job_by_due", "job", ["due"])
    op.create_index("job_by_end", "job", ["ended", "serial"])
    op.create_index("job_by_external_id", "job", ["external_id", "serial"])
    op.create_index("job_by_state", "job", ["state", "machine"])
    op.create_index("job_by_state_serial", "job", ["state", "serial"])
    op.create_index("job_by_updated", "job", ["updated"])
    op.create_index(
        "one_job_on_a_table",
        "job",
        ["machine"],
        unique=True,
        sqlite_where=sa.text(
            "state IN ('running', 'held', 'interrupted') OR (state = 'queued' AND confirmation <> '')"
        ),
        postgresql_where=sa.text(
            "state IN ('running', 'held', 'interrupted') OR (state = 'queued' AND confirmation <> '')"
        ),
    )
    op.create_table(
        "command_key",
        sa.Column("key", sa.String(200), nullable=False),
        sa.Column("fingerprint", sa.String(64), nullable=False),
        sa.Column("job", sa.String(32), nullable=False),
        sa.Column("created", sa.Double(), nullable=False),
        sa.ForeignKeyConstraint(["job"], ["job.id"], ondelete="CASCADE"),
        sa.PrimaryKeyConstraint("key"),
    )
    op.create_index("command_key_by_job", "command_key", ["job"])
    op.create_table(
        "job_document",
        sa.Column("owner", SERIAL, nullable=False),
        sa.Column("kind", sa.String(40), nullable=False),
        sa.Column("version", sa.String(200), nullable=False),
        sa.Column("content", sa.LargeBinary(), nullable=False),
        sa.ForeignKeyConstraint(["owner"], ["job.serial"], ondelete="CASCADE"),
        sa.PrimaryKeyConstraint("owner", "kind"),
    )
    op.create_table(
        "job_metadata",
        sa.Column("token", sa.String(40), nullable=False),
        sa.Column("owner", SERIAL, nullable=False),
        sa.ForeignKeyConstraint(["owner"], ["job.serial"], ondelete="CASCADE"),
        sa.PrimaryKeyConstraint("token", "owner"),
    )
    op.create_index("job_metadata_by_owner", "job_metadata", ["owner"])
    probe = sa.table("write_probe", sa.column("id"), sa.column("at"))
    op.bulk_insert(probe, [{"id": 1, "at": 0.0}])
