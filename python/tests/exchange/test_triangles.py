"""Triangles cover polygons, and solids have their known mass properties."""

from __future__ import annotations

import numpy as np
import pytest
from numpy.typing import NDArray

from nilas.exchange.triangles import solid_of, triangles_of


def area_of(points: NDArray[np.float64], triangles: NDArray[np.int64]) -> NDArray[np.float64]:
    a, b, c = (points[triangles[:, k]] for k in range(3))
    return np.cross(b - a, c - a) / 2


def prism(
    outline: NDArray[np.float64], height: float
) -> tuple[NDArray[np.float64], list[list[int]]]:
    """A floe as the replay has it: lower face, upper face, sides."""
    count = len(outline)
    low, high = (np.column_stack([outline, np.full(count, z)]) for z in (0.0, height))
    sides = [[k, (k + 1) % count, count + (k + 1) % count, count + k] for k in range(count)]
    upper = list(range(count, 2 * count))
    return np.concatenate([low, high]), [list(range(count))[::-1], upper, *sides]


L_SHAPE = np.array([[0.0, 0], [2, 0], [2, 1], [1, 1], [1, 2], [0, 2]])


def test_concave_polygons_are_covered_once() -> None:
    """The L has an area of 3, and all triangles turn as it does."""
    points = np.column_stack([L_SHAPE, np.zeros(6)])
    areas = area_of(points, triangles_of(points, [list(range(6))]))
    assert (areas[:, 2] > 0).all()
    assert areas[:, 2].sum() == pytest.approx(3)


def test_a_spiral_is_covered_once() -> None:
    """A spiral strip, whose area follows from the shoelace formula."""
    turn = np.linspace(0, 4 * np.pi, 60)
    inner, outer = 0.5 + 0.2 * turn, 0.9 + 0.2 * turn
    way = np.column_stack([np.cos(turn), np.sin(turn)])
    outline = np.concatenate([outer[:, None] * way, (inner[:, None] * way)[::-1]])
    x, y = outline.T
    expected = 0.5 * np.sum(x * np.roll(y, -1) - np.roll(x, -1) * y)
    points = np.column_stack([outline, np.zeros(len(outline))])
    areas = area_of(points, triangles_of(points, [list(range(len(outline)))]))
    assert (areas[:, 2] >= 0).all()
    assert areas[:, 2].sum() == pytest.approx(expected)


def test_a_box_has_its_known_inertia() -> None:
    """m (b^2 + c^2) / 12 about the centre, with mass = volume = a b c. Far from the origin too."""
    a, b, c = 2.0, 3.0, 0.5
    points, polygons = prism(np.array([[0, 0], [a, 0], [a, b], [0, b]]), c)
    solid = solid_of(points + 1000.0, triangles_of(points, polygons))
    volume = a * b * c
    assert solid.volume == pytest.approx(volume)
    assert solid.centre == pytest.approx([1000 + a / 2, 1000 + b / 2, 1000 + c / 2])
    expected = volume / 12 * np.diag([b * b + c * c, a * a + c * c, a * a + b * b])
    assert solid.inertia == pytest.approx(expected, abs=1e-8)


def test_a_concave_prism_has_the_inertia_of_its_boxes() -> None:
    """The L is a box of 2 x 1 below one of 1 x 1; Steiner moves each to the common centre."""
    height = 0.4
    points, polygons = prism(L_SHAPE, height)
    solid = solid_of(points, triangles_of(points, polygons))
    boxes = [((2.0, 1.0), (1.0, 0.5)), ((1.0, 1.0), (0.5, 1.5))]
    masses = np.array([a * b * height for (a, b), _ in boxes])
    centres = np.array([[x, y, height / 2] for _, (x, y) in boxes])
    centre = masses @ centres / masses.sum()
    inertia = np.zeros((3, 3))
    for ((a, b), _), mass, at in zip(boxes, masses, centres):
        own = np.diag([b * b + height**2, a * a + height**2, a * a + b * b]) / 12
        d = at - centre
        inertia += mass * (own + d @ d * np.eye(3) - np.outer(d, d))
    assert solid.centre == pytest.approx(centre)
    assert solid.inertia == pytest.approx(inertia)
