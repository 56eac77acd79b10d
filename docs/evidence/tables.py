#!/usr/bin/env python3
"""Writes the tables of the validation pages from the figures that are stored in data/.

usage: tables.py [--check]

A page marks the place of a table by two comments, `<!-- table: NAME -->` and `<!-- /table -->`. What stands between them
is written by this script: the rows of data/NAME.csv in the layout of LAYOUTS below, and a caption that says with which
revision and command they were measured. With --check nothing is written, and the exit code is 1 where a page differs
from the data, a file of data/ is used by no page or lacks one of its keys, or a marker has no file.

A file of data/ begins with comment lines `# key: value`: `command` (what repeats the figures), `revision` (of the
program; the commit that recorded the figures where nobody wrote down more), `date` (`FIRST and LAST` where there are
several), `machine`, and where there is something to say `note`, which ends the caption. A table whose rows are of several revisions has a column `revision`.
Figures are stored with the digits that were measured; a layout that gives a format rounds them. Figures of one meaning
stand in one column, with their unit in its name; an empty field means that nothing was measured.
"""
import argparse
import csv
import pathlib
import re
import sys
import textwrap

HERE = pathlib.Path(__file__).resolve().parent
KEYS = ("command", "revision", "date", "machine")
BLOCK = re.compile(r"<!-- table: (\S+) -->\n.*?<!-- /table -->", re.DOTALL)
COLUMNS = 100
NOTHING = "-"

# For each table its columns, each as heading and pattern. {name} is the field of that name as it is stored, {name:.1f}
# the same as a number in that format.
LAYOUTS = {
    "scenes-to-end": [
        ("scene", "{scene}"),
        ("steps", "{steps}"),
        ("momentum imbalance / scale", "{momentum_imbalance:.0e}"),
        ("penetration max / thickness", "{penetration_max_percent} %"),
        ("mean / thickness", "{penetration_mean_percent} %"),
        ("steps above tolerance", "{steps_above_tolerance}"),
        ("largest residual / tolerance", "{residual_over_tolerance}"),
        ("revision", "`{revision}`"),
    ],
    "integrator-error": [
        ("scene", "{scene}"),
        ("until [s]", "{until_s}"),
        ("Fx at h/8 [N]", "{fx_reference_N:.4f}"),
        ("error of `semi-implicit-euler` at h [N]", "{euler_h_N:.4f}"),
        ("at h/2 [N]", "{euler_half_N:.4f}"),
        ("error of `moreau` at h [N]", "{moreau_h_N:.4f}"),
        ("at h/2 [N]", "{moreau_half_N:.4f}"),
    ],
    "compare-towing": [
        ("law", "{law}"),
        ("stabilisation", "`{stabilisation}`"),
        ("integrator", "`{integrator}`"),
        ("error of the mean load [N]", "{error_N:.3f}"),
        ("computing [s per s]", "{computing_s_per_s:.1f}"),
    ],
    "compare-oblique": [
        ("law", "{law}"),
        ("stabilisation", "`{stabilisation}`"),
        ("error with `semi-implicit-euler` [N]", "{euler_error_N:.2f}"),
        ("computing [s per s]", "{euler_computing_s_per_s:.2f}"),
        ("error with `moreau` [N]", "{moreau_error_N:.2f}"),
        ("computing [s per s]", "{moreau_computing_s_per_s:.2f}"),
    ],
    "level-ice-solver": [
        ("solver", "{solver}"),
        ("integrator, stabilisation, detection", "{settings}"),
        ("computing [s]", "{computing_s}"),
        ("mean load [N]", "{load_N} ± {load_error_N}"),
    ],
    "integrators": [
        ("scene", "{scene}"),
        ("until [s]", "{until_s}"),
        ("penetration max [mm]", "{euler_penetration_mm:.2f} / {moreau_penetration_mm:.2f}"),
        ("energy imbalance / energy put in", "{euler_imbalance:.0e} / {moreau_imbalance:.0e}"),
        ("mean contact Fx [N]", "{euler_fx_N:.1f} / {moreau_fx_N:.1f}"),
        ("revision", "`{revision}`"),
    ],
    "load-cells": [
        ("$`h\\,\\omega`$", "{h_omega}"),
        ("peak of the reading [N]", "{peak_N}"),
    ],
    "water": [
        ("quantity", "{quantity}"),
        ("held against", "{against}"),
        ("largest relative error", "{error:.0e}"),
    ],
    "mirror-solvers": [
        ("solver", "`{solver}`"),
        ("tolerance [m/s]", "{tolerance_m_s:.0e}"),
        ("asymmetry of positions at 5 s [m]", "{at_5_s_m}"),
        ("largest asymmetry in 10 s", "{asymmetry}"),
        ("steps above tolerance", "{steps_above_tolerance}"),
        ("solver [ms per step]", "{solver_ms}"),
    ],
    "presawn-symmetry": [
        ("case", "{case}"),
        ("solver, tolerance [m/s]", "`{solver}` {tolerance_m_s:.0e}"),
        ("sides differ from [s]", "{differs_from_s}"),
        ("3 s [m]", "{at_3_s_m}"),
        ("4 s [m]", "{at_4_s_m}"),
        ("5 s [m]", "{at_5_s_m}"),
        ("6 s [m]", "{at_6_s_m}"),
        ("8 s [m]", "{at_8_s_m}"),
        ("10 s [m]", "{at_10_s_m}"),
        ("mean Fx [N]", "{fx_N}"),
        ("mean Fy [N]", "{fy_N}"),
        ("steps above tolerance", "{steps_above_tolerance} of {steps}"),
        ("computing [s]", "{computing_s:.1f}"),
    ],
    "presawn-growth": [
        ("case", "{case}"),
        ("2 s [m]", "{at_2_s_m}"),
        ("3 s [m]", "{at_3_s_m}"),
        ("4 s [m]", "{at_4_s_m}"),
        ("5 s [m]", "{at_5_s_m}"),
        ("6 s [m]", "{at_6_s_m}"),
        ("grows e-fold in [s]", "{e_fold_s:.2f}"),
    ],
    "presawn-loads": [
        ("case", "{case}"),
        ("triangles", "{triangles}"),
        ("penetration", "{penetration_percent:.2f} %"),
        ("in the hull", "{in_hull_percent:.2f} %"),
        ("in the sheets", "{in_sheets_percent:.2f} %"),
        ("mean Fx [N]", "{fx_N:.3f} ± {fx_error_N:.3f}"),
        ("port - starboard Fx [N]", "{sides_N:.3f} ± {sides_error_N:.3f}"),
        ("mean Fy [N]", "{fy_N:.3f} ± {fy_error_N:.3f}"),
    ],
    "level-ice-loads": [
        ("thickness [mm]", "{thickness_mm}"),
        ("speed [m/s]", "{speed_m_s}"),
        ("mean load [N]", "{load_N:.1f} ± {load_error_N:.1f}"),
        ("Lindqvist [N]", "{lindqvist_N:.1f}"),
        ("ratio", "{ratio:.2f}"),
        ("peak [N]", "{peak_N:.0f}"),
        ("mean R_bending [m]", "{r_bending_m:.3f}"),
        ("breaks", "{breaks}"),
        ("bodies", "{bodies}"),
        ("fastest floe [m/s]", "{fastest_m_s:.2f}"),
        ("energy error / energy put in", "{energy_error:.0e}"),
        ("ms per step", "{step_ms:.0f}"),
    ],
    "level-ice-convergence": [
        ("step [s]", "{step_s}"),
        ("triangles of the hull", "{triangles}"),
        ("mean load [N]", "{load_N:.1f} ± {load_error_N:.1f}"),
        ("peak [N]", "{peak_N:.0f}"),
        ("mean R_bending [m]", "{r_bending_m:.3f}"),
        ("breaks", "{breaks}"),
        ("bodies", "{bodies}"),
        ("fastest floe [m/s]", "{fastest_m_s:.2f}"),
        ("energy error / energy put in", "{energy_error:.1e}"),
        ("revision", "`{revision}`"),
    ],
    "broken-field": [
        ("breakable", "{breakable}"),
        ("floes at 0, 15, 30, 45, 60 s", "{floes_0_s}, {floes_15_s}, {floes_30_s}, {floes_45_s}, {floes_60_s}"),
        ("breaks", "{breaks}"),
        ("a break adds [ms]", "{break_ms}"),
        ("mean load [N]", "{load_N:.1f} ± {load_error_N:.1f}"),
        ("peak [N]", "{peak_N:.0f}"),
        ("mean R_bending [m]", "{r_bending_m}"),
        ("fastest floe [m/s]", "{fastest_m_s:.2f}"),
        ("energy error / energy put in", "{energy_error:.1e}"),
        ("ms per step", "{step_ms:.1f}"),
        ("of these crushing and breaking", "{crushing_breaking_ms:.2f}"),
    ],
    "detection-classes": [
        ("class", "{class}"),
        ("contacts", "{contacts}"),
        ("ties", "{ties}"),
        ("depth error / size", "{depth_error:.1e}"),
        ("in ulps", "{depth_error_ulps}"),
    ],
    "detection-peers": [
        ("class", "{class}"),
        ("Nilas new / again [us]", "{nilas_new_us:.1f} / {nilas_again_us:.1f}"),
        ("FCL [us]", "{fcl_us:.1f}"),
        ("Bullet [us]", "{bullet_us:.1f}"),
        ("wrong normals Nilas / FCL / Bullet", "{nilas_wrong} / {fcl_wrong} / {bullet_wrong} of {overlapping}"),
    ],
    "detection-peers-ratios": [
        ("pairs per second, ratio", "{ratio}"),
        ("median class", "{median}"),
        ("range", "{least} to {largest}"),
    ],
    "detection-steps": [
        ("floes", "{floes}"),
        ("ms per step", "{step_ms:.1f}"),
        ("pairs", "{pairs}"),
        ("points", "{points}"),
        ("separated by the stored axis", "{separated_percent:.1f} %"),
        ("contact axis kept", "{kept_percent:.1f} %"),
        ("growth exponent", "{exponent}"),
    ],
    "detection-threads": [
        ("quantity", "{quantity}"),
        ("range of four runs", "{least} to {largest}"),
    ],
    "detection-swept": [
        ("class", "{class}"),
        ("certain hits", "{hits}"),
        ("missed", "{missed}"),
        ("largest error of the time [steps]", "{time_error:.1e}"),
        ("false hits", "{false_hits}"),
        ("us per hit / miss", "{hit_us} / {miss_us}"),
        ("missed by FCL", "{fcl_missed_percent} %"),
    ],
    "packing": [
        ("floes", "{floes}"),
        ("polygons to 95 % [s]", "{polygons_s}"),
        ("exponent", "{polygons_exponent}"),
        ("cells (`voronoi`) to 95 % [s]", "{cells_s}"),
        ("exponent", "{cells_exponent}"),
        ("equal squares to 98 % [s]", "{squares_s}"),
        ("exponent", "{squares_exponent}"),
    ],
    "narrow-phase": [
        ("scene", "{scene}"),
        ("mean ice load [N], `nilas` / `fcl`", "{nilas_load_N} / {fcl_load_N}"),
        ("largest penetration [m], `nilas` / `fcl`", "{nilas_penetration_m:.2e} / {fcl_penetration_m:.2e}"),
        ("detection [ms per step], `nilas` / `nilas-alone` / `fcl`", "{nilas_ms} / {alone_ms} / {fcl_ms}"),
        ("pairs by a stored axis / FCL / corrected [%]", "{axis_percent} / {fcl_percent} / {corrected_percent}"),
    ],
    "narrow-phase-contacts": [
        ("scene", "{scene}"),
        ("contacts", "{contacts}"),
        ("missed", "{missed}"),
        ("surplus", "{surplus}"),
        ("other normals", "{other_normals}"),
        ("other depths", "{other_depths}"),
        ("largest depth error / thinner body", "{depth_error:.1e}"),
    ],
    "fcl-classes": [
        ("class", "{class}"),
        ("contacts", "{contacts}"),
        ("wrong normals", "{wrong_normals}"),
        ("wrong depths", "{wrong_depths}"),
        ("largest depth error / size", "{depth_error:.1e}"),
    ],
    "hulls": [
        ("shape", "{shape}"),
        ("triangles", "{triangles}"),
        ("convex parts", "{parts}"),
        ("deviation [mm]", "{deviation_mm:.3f}"),
        ("tolerance [mm]", "{tolerance_mm:.1f}"),
        (
            "read / repair / decompose / report / pictures [s]",
            "{read_s:.1f} / {mend_s:.1f} / {decompose_s:.1f} / {report_s:.1f} / {pictures_s:.1f}",
        ),
    ],
    "packed-step": [
        ("floes", "{floes}"),
        ("sweeps", "{sweeps}"),
        ("Nilas detect / solve / water / total [ms]", "{detect_ms:.2f} / {solve_ms:.2f} / {water_ms:.2f} / {total_ms:.2f}"),
        ("Bullet total [ms]", "{bullet_ms:.2f}"),
        ("ODE total [ms]", "{ode_ms:.2f}"),
        ("Nilas/Bullet", "{over_bullet:.2f}"),
        ("Nilas/ODE", "{over_ode:.2f}"),
        ("contacts Nilas / Bullet / ODE", "{contacts} / {bullet_contacts} / {ode_contacts}"),
    ],
    "packed-growth": [
        ("engine", "{engine}"),
        ("10 sweeps", "{sweeps_10:.2f}"),
        ("50 sweeps", "{sweeps_50:.2f}"),
        ("200 sweeps", "{sweeps_200:.2f}"),
    ],
    "packed-shares": [
        ("part of the step", "{part}"),
        ("share", "{share_percent} %"),
    ],
    "solvers": [
        ("solver", "`{solver}`"),
        ("solved in 5 s, of 29", "{solved}"),
        ("time over that of `auto`", "{time_over_auto}"),
    ],
    "solvers-scaling": [
        ("solver", "`{solver}`"),
        ("112 contacts [ms]", "{ms_112}"),
        ("1012 [ms]", "{ms_1012}"),
        ("10082 [ms]", "{ms_10082}"),
        ("100350 [ms]", "{ms_100350}"),
        ("growth exponent", "{exponent}"),
        ("memory at 100350 [MB]", "{memory_MB}"),
    ],
    "solvers-threads": [
        ("work", "{work}"),
        ("speed-up on 2 threads", "{speed_up:.2f}"),
        ("share of the loop's", "{share_of_loop:.2f}"),
    ],
    "exact-cone": [
        ("floes", "{floes}"),
        ("engine", "{engine}"),
        ("step, median [ms]", "{median_ms}"),
        ("95th percentile [ms]", "{p95_ms}"),
        ("residual [m/s]", "{residual_m_s}"),
        ("remark", "{remark}"),
        ("revision", "`{revision}`"),
    ],
    "towing-tolerance": [
        ("setting", "{setting}"),
        ("solver in the median step [ms]", "{median_ms}"),
        ("95th percentile [ms]", "{p95_ms}"),
        ("largest [ms]", "{largest_ms}"),
        ("distance from exact Coulomb [m/s], median", "{residual_median_m_s}"),
        ("largest", "{residual_largest_m_s}"),
    ],
    "peaks": [
        ("step [s]", "{step_s}"),
        ("mean [kN]", "{mean_kN:.1f}"),
        ("filtered peak over 0.2 s [kN]", "{filtered_peak_kN:.0f}"),
        ("raw peak [kN]", "{raw_peak_kN:.0f}"),
        ("impulse of its event [kN s]", "{impulse_kNs:.0f}"),
    ],
    "coverage-scenes": [
        ("scene", "{scene}"),
        ("until [s]", "{until_s}"),
        ("runs", "{runs}"),
        ("mean load [N]", "{load_N}"),
        ("measured errors [N]", "{error_min_N} to {error_max_N}"),
    ],
    "coverage-estimates": [
        ("estimate", "{estimate}"),
        ("presawn-a: covered, width ratio", "{presawn_a_covered}, {presawn_a_width}"),
        ("mirror-25", "{mirror_25_covered}, {mirror_25_width}"),
        ("towing", "{towing_covered}, {towing_width}"),
        ("all", "{all_covered}, {all_width}"),
    ],
    "coverage-level-ice": [
        ("settings", "{settings}"),
        ("until [s]", "{until_s}"),
        ("direction", "{direction}"),
        ("mean ice load [N]", "{load_N} ± {load_error_N}"),
        ("runs scatter by [N]", "{scatter_N}"),
        ("steps above tolerance", "{short_percent} %"),
        ("method A [N]", "{method_a_N}"),
        ("A holds the mean of its row", "{method_a_held} of {method_a_runs}"),
        ("method B, at least [N]", "{method_b_N}"),
        ("B holds the mean of its row", "{method_b_held} of {method_b_runs}"),
        ("B holds that of `auto`, 1e-4 m/s", "{method_b_held_last} of {method_b_runs_last}"),
    ],
    "coverage-compare": [
        ("scene", "{scene}"),
        ("until [s]", "{until_s}"),
        ("realisations", "{realisations}"),
        ("settings", "{settings}"),
        ("runs judged", "{runs}"),
        ("perturbed runs diverge at", "{diverge_at}"),
        ("with the other runs: covered, width ratio", "{others_covered_percent} %, {others_width}"),
        ("each run by itself", "{single_covered_percent} %, {single_width}"),
        ("parallel efficiency of 2 jobs", "{efficiency}"),
        ("scatter of times", "{scatter_percent} %"),
        ("revision", "`{revision}`"),
    ],
    "solver-part": [
        ("scene", "{scene}"),
        ("until [s]", "{until_s}"),
        ("tolerance [m/s]", "{tolerance_m_s:.0e}"),
        ("true error [N]", "{error_N}"),
        ("solver part [N]", "{solver_part_N}"),
        ("of the signed sum [N]", "{signed_N}"),
    ],
    "law-part": [
        ("until [s]", "{until_s}"),
        ("mean load [N]", "{load_N}"),
        ("difference of the laws [N]", "{difference_N}"),
        ("law part [N]", "{law_part_N}"),
    ],
}


class Field(str):
    """A stored figure; a format turns it into a number, an exponent is written as 1e-6."""

    def __format__(self, spec):
        if not spec:
            return str(self)
        try:
            value = float(self)
        except ValueError:
            return str(self)
        if value == 0 and spec.endswith("e"):
            return "0"
        return re.sub(r"e([+-])0*(\d)", lambda m: "e" + m.group(1).strip("+") + m.group(2), format(value, spec)).removesuffix("e0")


def read(name):
    """The keys and the rows of a file of data/."""
    path = HERE / "data" / f"{name}.csv"
    if not path.exists():
        raise SystemExit(f"{path}: no such file, but a page asks for it")
    keys, lines = {}, []
    for line in path.read_text(encoding="utf-8").splitlines():
        if line.startswith("# "):
            key, _, value = line[2:].partition(": ")
            keys[key] = value
        else:
            lines.append(line)
    missing = [key for key in KEYS if not keys.get(key)]
    if missing:
        raise SystemExit(f"{path}: found no {', '.join(missing)}; expected lines '# key: value' for {', '.join(KEYS)}")
    return keys, [{k: Field(v) for k, v in row.items()} for row in csv.DictReader(lines, strict=True)]


def cell(pattern, row):
    """A pattern filled in; a dash where every field of it is empty."""
    names = re.findall(r"\{(\w+)", pattern)
    return pattern.format(**row) if any(row[name] for name in names) else NOTHING


def caption(name, keys, mixed):
    recorded = "the revision of each row" if mixed else f"revision `{keys['revision']}`"
    when = ("between " if " and " in keys["date"] else "on ") + keys["date"]
    text = f"The figures were recorded with {recorded} {when}, on {keys['machine']}. "
    text += f"They are repeated by {keys['command']}, and are stored in [data/{name}.csv](data/{name}.csv)."
    if keys.get("note"):
        text += " " + keys["note"]
    return textwrap.fill(text, COLUMNS, break_long_words=False, break_on_hyphens=False)


def table(name):
    if name not in LAYOUTS:
        raise SystemExit(f"tables.py: found no layout for '{name}'; known: {', '.join(LAYOUTS)}")
    keys, rows = read(name)
    layout = LAYOUTS[name]
    lines = ["| " + " | ".join(heading for heading, _ in layout) + " |", "|" + "---|" * len(layout)]
    try:
        lines += ["| " + " | ".join(cell(pattern, row) for _, pattern in layout) + " |" for row in rows]
    except KeyError as key:
        raise SystemExit(f"data/{name}.csv: found no column {key}, which its layout asks for") from None
    return "\n".join(lines) + "\n\n" + caption(name, keys, "revision" in rows[0])


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--check", action="store_true", help="write nothing; exit 1 where a page and the data differ")
    check = parser.parse_args().check
    faults, used = [], set()
    for page in sorted(HERE.glob("validation*.md")):
        old = page.read_text(encoding="utf-8")
        names = BLOCK.findall(old)
        if len(names) != old.count("<!-- table: "):
            faults.append(f"{page.name}: a marker '<!-- table: NAME -->' has no '<!-- /table -->'")
        used.update(names)
        new = BLOCK.sub(lambda m: f"<!-- table: {m.group(1)} -->\n{table(m.group(1))}\n<!-- /table -->", old)
        if new != old and check:
            faults.append(f"{page.name}: differs from the data; run docs/evidence/tables.py")
        elif new != old:
            page.write_text(new, encoding="utf-8")
            print(f"written: {page.name}")
    stored = {path.stem for path in (HERE / "data").glob("*.csv")}
    faults += [f"data/{name}.csv: no page shows it" for name in sorted(stored - used)]
    faults += [f"tables.py: the layout '{name}' is used by no page" for name in sorted(set(LAYOUTS) - used)]
    for fault in faults:
        print(fault, file=sys.stderr)
    return 1 if faults else 0


if __name__ == "__main__":
    sys.exit(main())
