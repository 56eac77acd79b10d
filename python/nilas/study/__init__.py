"""Studies: many runs of one scene, with factors, seeds, one table and one page.

``python3 -m nilas.study STUDY.yaml`` carries out a study. ``describe`` reads the study file and
makes the plan, ``carry_out`` runs it, and ``results`` writes the tables and the page.
"""
