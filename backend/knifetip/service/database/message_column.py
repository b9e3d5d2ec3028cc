"""Column type that stores a message as JSON."""

from __future__ import annotations

from typing import Any

import sqlalchemy as sa

from knifetip.messages import Message, from_json


class MessageColumn(sa.TypeDecorator[Message]):
    """A message in a JSON column; None is stored as NULL."""

    impl = sa.JSON(none_as_null=True)
    cache_ok = True

    def process_bind_param(self, value: Message | None, dialect: sa.Dialect) -> Any:  # noqa: ARG002  # signature of TypeDecorator
        """Return the JSON data of a message, which the database stores; None for None."""
        return None if value is None else value.as_json()

    def process_result_value(self, value: Any, dialect: sa.Dialect) -> Message | None:  # noqa: ARG002  # signature of TypeDecorator
        """Return the message with the JSON data ``value``; None for None."""
        return None if value is None else from_json(value)


class MessagesColumn(sa.TypeDecorator[list[Message]]):
    """A list of messages in a JSON column; NULL and None are no messages."""

    impl = sa.JSON(none_as_null=True)
    cache_ok = True

    def process_bind_param(self, value: list[Message] | None, dialect: sa.Dialect) -> Any:  # noqa: ARG002  # signature of TypeDecorator
        """Return the JSON data of some messages, which the database stores."""
        return [message.as_json() for message in value or ()]

    def process_result_value(self, value: Any, dialect: sa.Dialect) -> list[Message]:  # noqa: ARG002  # signature of TypeDecorator
        """Return the messages with the JSON data ``value``."""
        return [from_json(message) for message in value or ()]
