"""Carries out cases within a budget of time."""
