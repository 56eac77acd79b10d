"""Random scenes over the whole schema: each is a function of its seed."""
