"""From a study file to a plan: factors, points, seeds and the names of runs."""
