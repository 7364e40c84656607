"""The environments' entry in Gymnasium's registry, whichever of the two packages is imported first.

Gymnasium is not imported for it: that would take longer than all of this package.
"""

from __future__ import annotations

import sys
from typing import Any


def register() -> None:
    """Registers ``robovac/Clean-v0``."""
    import gymnasium

    if "robovac/Clean-v0" not in gymnasium.registry:
        gymnasium.register(
            id="robovac/Clean-v0",
            entry_point="robovac.gym:CleanEnv",
            vector_entry_point="robovac.gym:CleanVectorEnv",
        )


def register_with_gymnasium() -> None:
    """Registers now if Gymnasium is imported, else as soon as it is."""
    if "gymnasium" in sys.modules:
        register()
    else:
        sys.meta_path.insert(0, _Waiting())


class _Waiting:
    """Finds Gymnasium as others do, and registers once it is imported."""

    def find_spec(self, name: str, path: Any = None, target: Any = None) -> Any:
        if name != "gymnasium":
            return None
        from importlib.util import find_spec

        sys.meta_path.remove(self)
        spec = find_spec(name)
        if spec is not None and spec.loader is not None:
            load = spec.loader.exec_module

            def exec_module(module: Any) -> None:
                load(module)
                register()

            spec.loader.exec_module = exec_module
        return spec
