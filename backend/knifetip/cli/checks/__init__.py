"""The checks of ``knifetip doctor``."""
