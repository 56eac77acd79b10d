"""Measured runs: tables of loads, towing records, and floes that were laid out."""
