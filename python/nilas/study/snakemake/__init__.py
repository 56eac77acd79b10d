"""The study as a workflow of Snakemake."""
