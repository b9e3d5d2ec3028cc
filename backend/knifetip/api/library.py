"""library: the boards, profiles and tools that orders may name."""

from __future__ import annotations

from dataclasses import asdict

from fastapi import APIRouter

from knifetip.api.schemas import BoardOut, ProfileOut, RuleOut, StationTool
from knifetip.api.service import on_shelf
from knifetip.library import load

router = APIRouter(tags=["library"])


@router.get("/boards")
def list_boards() -> list[BoardOut]:
    """List the boards."""
    return [get_board(name) for name in load.names("boards")]


@router.get("/boards/{name}")
def get_board(name: str) -> BoardOut:
    """Look at a board."""
    board = asdict(load.board(on_shelf("boards", name)))
    return BoardOut.model_validate({field: board[field] for field in BoardOut.model_fields})


@router.get("/profiles")
def list_profiles() -> list[ProfileOut]:
    """List the classification profiles."""
    return [get_profile(name) for name in load.names("profiles")]


@router.get("/profiles/{name}")
def get_profile(name: str) -> ProfileOut:
    """Look at a classification profile: its rules, of which the first that matches decides."""
    profile = load.profile(on_shelf("profiles", name))
    rules = [
        RuleOut.model_validate({"type": rule.line_type.word, "words": rule.words})
        for rule in profile.rules
    ]
    return ProfileOut(name=profile.name, title=profile.title, rules=rules)


@router.get("/tools")
def list_tools() -> list[StationTool]:
    """List the tools on all machines."""
    return [
        StationTool.model_validate(
            {
                "machine": name,
                "station": station.number,
                "name": station.name,
                "kind": load.kind_of(station.tool),
                "dimensions": asdict(station.tool),
            }
        )
        for name in load.names("machines")
        for station in load.machine(name).stations
    ]
