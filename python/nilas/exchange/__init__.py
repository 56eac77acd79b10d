"""Handing scenes and results to other programs. ``docs/howto/exchange-with-other-programs.md``."""
