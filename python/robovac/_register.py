"""The environments' entry in Gymnasium, which finds this by itself once the package is installed."""


def register() -> None:
    """Registers ``robovac/Clean-v0``."""
    import gymnasium

    if "robovac/Clean-v0" not in gymnasium.registry:
        gymnasium.register(
            id="robovac/Clean-v0",
            entry_point="robovac.gym:CleanEnv",
            vector_entry_point="robovac.gym:CleanVectorEnv",
        )
