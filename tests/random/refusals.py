"""The errors that a valid random scene may meet, each with the page that documents it.

A generator cannot know whether a hull touches a random field at the start, or how a light part answers a large step.
What it can know, such as which solver takes which law, is not here: scenes that break these rules are not made.
"""
import re

DOCUMENTED = (
    (r"overlap by .* at the start", "theory/ice-field.md", "bodies overlap at the start"),
    (r"the path ends at .*, and the scene starts at", "reference/scene.md", "path that ends before the start"),
    (r"'reference' does not take \d+ contacts at once", "reference/scene.md",
     "too many contacts for integrator `reference`"),
    (r"the contact solver stopped with status", "reference/scene.md", "`on_failure=\"stop\"`"),
    (r"the observer of dynamic positioning does not converge", "theory/positioning.md",
     "wave filter that does not converge"),
    (r"the tension at the start is", "theory/mooring.md", "mooring line that is too tight at the start"),
    (r"integrator 'reference' takes \d+: use|the law may have no answer without an impulse"
     r"|integrator 'reference' suits smooth motion|integrator 'reference' finds more than", "theory/dynamics.md",
     "motion that integrator `reference` does not follow"),
    (r"the damping is negative at \d+ frequencies", "theory/radiation.md", "damping of a database that is negative"),
    (r"the propeller holds .* at its largest rate", "theory/manoeuvring.md", "start faster than the propeller holds"),
    (r"packed field: concentration: found", "theory/ice-field.md", "field that does not pack as closely"),
    (r"try a smaller <time step>", "reference/conventions.md", "motion grows beyond all bounds"),
)


def documented(error: str) -> str:
    """The short name of the documented refusal that an error states; empty for all other errors."""
    for pattern, _, name in DOCUMENTED:
        if re.search(pattern, error):
            return name
    return ""


def page_of(name: str) -> str:
    """The page below docs that documents the refusal of this name; empty for other errors."""
    return next((page for _, page, known in DOCUMENTED if known == name), "")
