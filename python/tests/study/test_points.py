"""Designs: which points they have, and how their folders are called."""

import numpy as np

from nilas.study.describe.plan import Plan
from nilas.study.describe.points import points_of, shares_of
from nilas.study.describe.read_study import read_study

HEAD = "scene: scene.xml\nresponses: [a]\n"


def plan(desk, text):
    return Plan(read_study(desk.write(HEAD + text), desk.folder / "out"))


def labels(points):
    return [tuple(level.label for level in point.levels) for point in points]


def test_a_full_design_has_all_combinations_with_the_last_factor_fastest(desk):
    points = plan(desk, "factors: {t/@x: [1, 2], t/@y: [a, b]}").points
    assert labels(points) == [("1", "a"), ("1", "b"), ("2", "a"), ("2", "b")]


def test_one_at_a_time_varies_each_factor_from_the_first_values(desk):
    points = plan(desk, "factors: {t/@x: [1, 2, 3], t/@y: [a, b]}\ndesign: one-at-a-time").points
    assert labels(points) == [("1", "a"), ("2", "a"), ("3", "a"), ("1", "b")]


def test_ranges_are_spaced_evenly_in_their_scale(desk):
    text = (
        "factors: {t/@x: {from: 1, to: 100, steps: 3, scale: log}, t/@y: {from: 0, to: "
        "1, steps: 3}}"
    )
    x, y = read_study(desk.write(HEAD + text)).factors
    assert [level.number for level in x.levels] == [1, 10, 100]
    assert [level.number for level in y.levels] == [0, 0.5, 1]


def test_a_latin_hypercube_has_one_point_in_each_slice(desk):
    shares = shares_of("latin-hypercube", 3, 20, seed=1)
    for column in shares.T:
        assert sorted((column * 20).astype(int)) == list(range(20))


def test_sampled_points_are_those_of_the_seed_and_stay_in_their_ranges(desk):
    text = "factors: {t/@x: {from: 2, to: 3}, t/@n: {from: 1, to: 4, whole: true}, t/@w: [a, b]}\n"
    design = "design: {kind: sobol, points: 64, seed: %d}\n"
    one = plan(desk, text + design % 1).points
    assert labels(one) == labels(plan(desk, text + design % 1).points)
    assert labels(one) != labels(plan(desk, text + design % 2).points)
    x, n, w = zip(*labels(one), strict=True)
    assert all(2 <= float(value) <= 3 for value in x)
    assert set(n) == {"1", "2", "3", "4"} and set(w) == {"a", "b"}


def test_the_design_of_saltelli_mixes_one_column_at_a_time():
    rows = shares_of("saltelli", 3, 8, 1).reshape(8, 5, 3)
    for block in rows:
        for place in range(3):
            expected = block[0].copy()
            expected[place] = block[-1][place]
            np.testing.assert_array_equal(block[1 + place], expected)


def test_a_table_has_its_rows_from_the_study_or_from_a_file(desk):
    factors = "factors: {t/@x: [1, 2], hull: {values: {slim: {t/@y: 1}}}}\n"
    rows = "design: {kind: table, rows: [{x: 7, hull: slim}, {x: 1.0, hull: slim}]}"
    assert labels(plan(desk, factors + rows).points) == [("7", "slim"), ("1", "slim")]
    (desk.folder / "points.csv").write_text("hull,x\nslim,7\nslim,1\n")
    other = plan(desk, factors + "design: {kind: table, file: points.csv}")
    assert labels(other.points) == [("7", "slim"), ("1", "slim")]


def test_folders_are_named_by_values_or_by_a_hash_of_them(desk):
    few = plan(desk, "factors: {t/@x: [0.50], t/@y: [-2]}")
    assert few.run(few.points[0], 0).name == "x-0.5_y--2/seed-1"
    odd = plan(desk, "factors: {t/@x: ['0 0 1', a/b]}").points
    assert all(point.name.startswith("point-") and len(point.name) == 18 for point in odd)
    assert odd[0].name != odd[1].name


def test_more_values_leave_the_names_of_the_others_alone(desk):
    before = {point.name for point in plan(desk, "factors: {t/@x: [1, 2]}").points}
    after = {point.name for point in plan(desk, "factors: {t/@x: [0, 1, 2, 3]}").points}
    assert before < after


def test_seeds_are_the_same_or_own_for_each_point(desk):
    text = "factors: {t/@x: [1, 2]}\nseeds: {count: 3, %s}"
    same = plan(desk, text % "first: 5")
    assert [same.seed(same.points[1], k) for k in range(3)] == [5, 6, 7]
    own = plan(desk, text % "each_point: own")
    seeds = [own.seed(point, k) for point in own.points for k in range(3)]
    assert len(set(seeds)) == 6 and seeds == [
        own.seed(point, k) for point in own.points for k in range(3)
    ]


def test_many_points_go_to_256_folders_and_a_study_that_grows_stays_where_it_is(desk):
    text = "factors: {t/@x: {from: 1, to: %d, steps: %d}}"
    large = plan(desk, text % (1200, 1200))
    assert large.run(large.points[0], 0).name.count("/") == 2
    small = plan(desk, text % (10, 10))
    small.make_folders()
    assert plan(desk, text % (1200, 1200)).run(large.points[0], 0).name.count("/") == 1


def test_a_hundred_thousand_points_are_planned_in_seconds(desk):
    factors = "factors: {t/@x: {from: 0, to: 1}, t/@y: {from: 0, to: 1}}\n"
    study = read_study(desk.write(HEAD + factors + "design: {kind: sobol, points: 131072}"))
    points = points_of(study)
    # Values have six digits, so that a few points may meet.
    assert len(points) > 131000
