"""From finished runs to the tables and the page of a study."""
