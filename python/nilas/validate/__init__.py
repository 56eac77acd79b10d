"""Validation: loads of runs beside published formulas, measured runs and scale laws.

``nilas validate`` carries out cases, each a study with references, and writes one table and one
page. ``formulas`` has the formulas, ``cases`` reads the case files, ``campaign`` runs them within
a budget, ``judge`` compares, ``page`` writes, and ``measured`` reads what was measured.
"""
