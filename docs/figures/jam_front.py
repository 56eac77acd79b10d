"""What a step of the jam of 966 floes costs and which residual it leaves: ../evidence/data/jam-front.csv, recorded by
./dev bench front; docs/evidence/validation-solvers.md, "The exact cone in a scene"."""
import csv
import pathlib

from style import *

FILE = pathlib.Path(__file__).resolve().parent.parent / "evidence/data/jam-front.csv"
# engine, friction: colour, mark, where its name stands beside its first or last point
LOOKS = {
    ("Nilas `pgs`, pyramid", "0.15"): (SKY, "o", "Nilas pgs, pyramid", -1, (20, -3), "left"),
    ("Nilas `nsgs`", "0.15"): (GREEN, "s", "Nilas nsgs", -1, (-4, -15), "center"),
    ("Nilas `auto`", "0.15"): (BLUE, "D", "Nilas auto", -1, (-8, -3), "right"),
    ("Nilas `auto`", "0.3"): (PURPLE, "D", "Nilas auto, friction 0.3", -1, (6, 6), "left"),
    ("ODE", "0.15"): (ORANGE, "^", "ODE", 0, (0, 7), "center"),
    ("Bullet", "0.15"): (RED, "v", "Bullet", -1, (0, 8), "center"),
    ("MuJoCo", "0.15"): (GREY, "P", "MuJoCo", -1, (0, -14), "center"),
}


def rows():
    with FILE.open(encoding="utf-8") as file:
        return list(csv.DictReader(line for line in file if not line.startswith("#")))


def draw():
    series = {}
    for row in rows():
        if row["engine"].endswith("two threads"):  # they stand in the table alone
            continue
        series.setdefault((row["engine"], row["friction"]), []).append(row)
    assert set(series) <= set(LOOKS), set(series) - set(LOOKS)
    fig = figure(4.2)
    ax = fig.add_axes([0.105, 0.125, 0.87, 0.85])
    for key, points in series.items():
        colour, mark, name, at, offset, side = LOOKS[key]
        x = np.array([float(p["median_ms"]) for p in points])
        y = np.array([float(p["residual_m_s"]) for p in points])
        late = np.array([float(p["p95_ms"]) for p in points]) - x
        ax.plot(x, y, color=colour, marker=mark, markersize=5, zorder=3)
        ax.errorbar(x, y, xerr=[0 * late, late], fmt="none", ecolor=colour, elinewidth=1, capsize=2.5, zorder=2)
        ax.annotate(name, (x[at], y[at]), offset, textcoords="offset points", color=colour, fontsize=SMALL, ha=side)
    ax.set_xscale("log")
    ax.set_yscale("log")
    ax.set_ylim(2e-7, 0.1)
    ax.xaxis.set_major_formatter("{x:g}")
    ax.set_xlabel("time of a step [ms]: median, bar to the 95th percentile")
    ax.set_ylabel("residual of exact Coulomb friction, median [m/s]")
    ax.grid(True, which="major", color="#E4E4E4", linewidth=0.6)
    return fig
