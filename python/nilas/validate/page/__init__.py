"""Writes validation.html, the page that shows all cases."""
