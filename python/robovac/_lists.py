"""What there is, by id."""

from __future__ import annotations

import json
from typing import Any

from . import _native


def _by_id(text: str) -> dict[str, dict[str, Any]]:
    return {entry.pop("id"): entry for entry in json.loads(text)}


def planners() -> dict[str, dict[str, Any]]:
    """Planners by id: title, summary, claims (complete, deterministic, fast) and parameters."""
    return _by_id(_native.planners())


def behaviours() -> dict[str, dict[str, Any]]:
    """Behaviours by id: title, summary, what they do (ends, cleans, explores) and parameters."""
    return _by_id(_native.behaviours())


def rooms() -> dict[str, dict[str, Any]]:
    """Shipped rooms by id: title, and what each is good for."""
    return _by_id(_native.rooms())


def robots() -> dict[str, dict[str, Any]]:
    """Robots by id: title, summary, and figures in m and m/s."""
    return _by_id(_native.robots())


def metrics() -> dict[str, dict[str, Any]]:
    """Metrics of plans by id: label, unit and definition."""
    return _by_id(_native.metrics())
