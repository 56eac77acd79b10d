#!/usr/bin/env python3
"""Table and plots of the rows that bench_solvers wrote: solvers_table.py ROWS.csv FOLDER
For each file and solver the time is that of its first rung with natural_map_m_s <= TARGET."""
import csv
import math
import sys
from collections import defaultdict

TARGET = 1e-8  # m/s
SIZE = 50      # contacts, above which no file may be far behind the best peer
WIDE = 1e3     # end of the performance profile


def read(path):
    rows = defaultdict(lambda: defaultdict(list))
    contacts = {}
    with open(path, newline="") as file:
        for row in csv.DictReader(file):
            contacts[row["problem"]] = int(row["contacts"])
            rows[row["problem"]][row["solver"]].append((float(row["seconds"]), float(row["natural_map_m_s"])))
    return rows, contacts


def time_to_target(runs):
    times = [seconds for seconds, residual in runs if residual <= TARGET]
    return min(times) if times else math.inf


def mean_ratio(ratios):
    return math.exp(sum(map(math.log, ratios)) / len(ratios)) if ratios else math.nan


def text(seconds):
    return "-" if math.isinf(seconds) else f"{1e3 * seconds:.2f}"


def main(path, folder):
    rows, contacts = read(path)
    solvers = list(dict.fromkeys(name for runs in rows.values() for name in runs))
    peers = [name for name in solvers if name.startswith("siconos")]
    times = {file: {name: time_to_target(rows[file][name]) for name in solvers} for file in rows}

    print(f"ms to natural_map_m_s <= {TARGET:g} from a cold start; - : not within the time limit")
    print("| file | contacts | " + " | ".join(solvers) + " | auto / best Siconos |")
    print("|---" * (len(solvers) + 3) + "|")
    late = []
    for file in sorted(rows, key=contacts.get):
        best = min(times[file][name] for name in peers)
        ratio = times[file]["auto"] / best if math.isfinite(best) else 0 if math.isfinite(times[file]["auto"]) else math.nan
        shown = f"{ratio:.2f}" if math.isfinite(best) else "auto alone" if math.isfinite(times[file]["auto"]) else "none"
        if contacts[file] > SIZE and math.isfinite(best) and ratio > 1.5:
            late.append(f"{file} ({ratio:.2f})")
        print(f"| {file} | {contacts[file]} | " + " | ".join(text(times[file][name]) for name in solvers) + f" | {shown} |")
    print("| solved | | " + " | ".join(f"{sum(math.isfinite(times[f][name]) for f in rows)}/{len(rows)}" for name in solvers) + " | |")

    print("\ntime of each peer over that of auto, geometric mean over the files that both solve:")
    for name in solvers:
        both = [f for f in rows if math.isfinite(times[f][name]) and math.isfinite(times[f]["auto"])]
        if name != "auto":
            print(f"  {name:<16}{mean_ratio([times[f][name] / times[f]['auto'] for f in both]):8.2f}  over {len(both)} files")
    best = [(min(times[f][name] for name in peers), times[f]["auto"]) for f in rows]
    both = [(a, b) for a, b in best if math.isfinite(a) and math.isfinite(b)]
    print(f"  best per file   {mean_ratio([a / b for a, b in both]):8.2f}  over {len(both)} files")
    print(f"files above {SIZE} contacts where auto takes over 1.5 times the best Siconos solver: {', '.join(late) or 'none'}")
    draw(rows, times, solvers, folder)


def draw(rows, times, solvers, folder):
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import pyplot

    colours = pyplot.get_cmap("tab20").colors

    def style(name):
        return dict(linestyle="--" if name.startswith("siconos") else "-", linewidth=2.5 if name == "auto" else 1.2,
                    color=colours[2 * solvers.index(name) % 20 + 2 * solvers.index(name) // 20])

    figure, axes = pyplot.subplots(figsize=(8, 5))
    for name in solvers:
        ratios = sorted(times[f][name] / min(times[f].values()) for f in rows if math.isfinite(times[f][name]))
        steps = [(1, 0.0)] + [(r, (k + 1) / len(rows)) for k, r in enumerate(ratios)] + [(WIDE, len(ratios) / len(rows))]
        axes.step(*zip(*steps), where="post", label=name, **style(name))
    axes.set(xscale="log", xlim=(1, WIDE), ylim=(0, 1.02), xlabel="time over the fastest solver of the file [-]",
             ylabel=f"share of files solved to {TARGET:g} m/s", title="Performance profile")
    axes.legend(fontsize=8, loc="upper left", bbox_to_anchor=(1, 1))
    figure.savefig(f"{folder}/performance-profile.png", dpi=120, bbox_inches="tight")

    names = sorted(rows)
    columns = 5
    lines = math.ceil(len(names) / columns)
    figure, grid = pyplot.subplots(lines, columns, figsize=(4 * columns, 3 * lines), squeeze=False)
    for axes in grid.flat[len(names):]:
        axes.axis("off")
    for axes, file in zip(grid.flat, names):
        for name in solvers:
            points = [(1e3 * s, max(r, 1e-16)) for s, r in rows[file][name] if math.isfinite(r)]
            axes.plot(*zip(*points) if points else ([], []), marker=".", label=name, **style(name))
        axes.axhline(TARGET, color="0.7", linewidth=0.8)
        axes.set(xscale="log", yscale="log")
        axes.set_title(file, fontsize=8)
    handles, labels = grid[0][0].get_legend_handles_labels()
    figure.legend(handles, labels, ncol=len(solvers), loc="upper center", fontsize=9)
    figure.supxlabel("time [ms]")
    figure.supylabel("natural_map_m_s [m/s]")
    figure.tight_layout(rect=(0.01, 0, 1, 1 - 0.25 / lines))
    figure.savefig(f"{folder}/work-precision.png", dpi=90)
    print(f"plots: {folder}/performance-profile.png, {folder}/work-precision.png")


if __name__ == "__main__":
    main(*sys.argv[1:])
