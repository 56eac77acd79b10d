"""Case files of validation: a study, its references, and the inputs of formulas."""
