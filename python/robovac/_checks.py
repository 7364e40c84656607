"""Invalid arguments, described in words."""

from __future__ import annotations

import operator
import re
from collections.abc import Callable
from typing import Any

from ._errors import UsageError

#: Seeds are from 0 on, and below this.
SEEDS = 2**64


def whole(name: str, value: Any, least: int = 0, below: int = SEEDS) -> int:
    """``value`` as a whole number from ``least`` on."""
    try:
        number = operator.index(value)
    except TypeError:
        number = least - 1
    if not least <= number < below:
        most = "2**64 - 1" if below == SEEDS else str(below - 1)
        raise UsageError(f"{name} can't be {value!r}; use a whole number from {least} to {most}")
    return number


def told(call: Callable[..., Any], *arguments: Any) -> Any:
    """What ``call`` returns. A wrong type in a dictionary among its arguments is told by its name and value."""
    try:
        return call(*arguments)
    except TypeError as error:
        found = re.match(r"failed to extract field \w+\.(\w+)", str(error))
        if found is None:
            raise
        name = found[1]
        value = next(given[name] for given in arguments if isinstance(given, dict) and name in given)
        raise UsageError(f"{name} can't be {value!r}: {error.__cause__}") from None
