"""Statistics of the load of one run or of several: peaks with return levels, spectrum, ice ahead.

``series`` takes a load from a run, ``events`` finds independent peaks, ``tail`` fits their
distribution, ``peaks`` puts both together, ``spectrum`` and ``ice_ahead`` do the rest, and
``command`` is ``nilas statistics``. Methods and sources: docs/theory/load-statistics.md.
"""
