"""content: messages about stored files and programs, and the folder or bucket that keeps them."""

from __future__ import annotations

from typing import Final

from knifetip.messages.entry import Entries, entry

MESSAGES: Final[Entries] = {
    "content.altered": entry(
        "The stored content {address} of {owner} is damaged: its SHA-256 does not match.",
        "Restore the content from a backup, or compile the job again. Nothing was sent to a "
        "machine.",
        owner="text",
        address="text",
    ),
    "content.bad-url": entry(
        "{url!r} is not the URL of a folder or a bucket.",
        "Write the URL as file:///FOLDER or s3://BUCKET/PREFIX, with the keys of S3 in "
        "AWS_ACCESS_KEY_ID and AWS_SECRET_ACCESS_KEY.",
        url="text",
    ),
    "content.missing": entry(
        "The stored content {address} of {owner} is missing.",
        "Check that --store names the folder or bucket of this database. If it does, restore the "
        "content from a backup, or compile the job again. Nothing was sent to a machine.",
        owner="text",
        address="text",
    ),
    "content.no-obstore": entry(
        "The package obstore is not installed, which --store {url} needs.",
        "Install it with: pip install 'knifetip[s3]'.",
        url="text",
    ),
    "content.outside": entry(
        "The stored content {address} of {owner} is in a folder or bucket outside the database.",
        "Start the server and its workers with the same option --store as when the content was "
        "stored.",
        owner="text",
        address="text",
    ),
    "content.unavailable": entry(
        "The store {url} cannot be used: {reason}.",
        "Check the folder or the bucket, its keys and the network. Nothing was stored.",
        url="text",
        reason="text",
    ),
}
