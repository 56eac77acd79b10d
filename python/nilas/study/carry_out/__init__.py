"""From a plan to finished runs: starts the program, resumes, records what came of each run."""
