"""From runs to verdicts: means with their error, references, and slopes."""
