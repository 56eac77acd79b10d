#!/usr/bin/python3
"""Draws the pictures of the pages.

usage: /usr/bin/python3 docs/figures/draw.py [--into FOLDER] [--png] [NAME...]

Without names all are drawn. NAME is that of the picture without its ending: frames-and-signs. Each is drawn by the
module of its name in this folder (frames_and_signs.py), from closed forms, the hull of apps/scenes/hulls/icebreaker,
and data/ alone: offline, and the same bytes each time on one version of matplotlib. take_data.py fills data/.
  --into FOLDER  where to put them, in place of this folder
  --png          as PNG whatever their ending, to look at
Needs Debian's python3-matplotlib, so Debian's /usr/bin/python3.
"""
import argparse
import importlib
import pathlib
import sys

HERE = pathlib.Path(__file__).resolve().parent
sys.dont_write_bytecode = True
sys.path.insert(0, str(HERE))

PICTURES = [
    "frames-and-signs.svg", "towing-rig.svg", "one-step.svg", "cone-and-pyramid.svg", "contact-gap.svg",
    "crushing-face.svg", "bending-wedges.svg", "cutting.svg", "wetted-surface.svg", "field-kinds.svg",
    "hull-decomposition.svg", "jam-front.svg", "load-error-window.svg", "compare-page.svg", "run-towing.png", "level-ice-run.png",
]


def save(fig, path):
    if path.suffix == ".svg":
        fig.savefig(path, dpi=150, metadata={"Date": None, "Creator": None})
        lines = path.read_text(encoding="utf-8").split("\n")
        path.write_text("\n".join(line.rstrip() for line in lines), encoding="utf-8")
    else:
        fig.savefig(path, dpi=200, metadata={"Software": None})
        from PIL import Image
        with Image.open(path) as picture:  # 256 colours: a third of the size
            few = picture.convert("RGB").quantize(256, Image.Quantize.MAXCOVERAGE, dither=Image.Dither.NONE)
        few.save(path, optimize=True)


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    parser.add_argument("names", nargs="*")
    parser.add_argument("--into", type=pathlib.Path, default=HERE)
    parser.add_argument("--png", action="store_true")
    options = parser.parse_args()
    try:
        import matplotlib.pyplot as plt
    except ImportError:
        sys.exit("draw.py: this python has no matplotlib. Debian's has it: apt install python3-matplotlib, then run "
                 "/usr/bin/python3 " + sys.argv[0])
    known = {}
    for picture in PICTURES:
        known.setdefault(pathlib.Path(picture).stem, []).append(picture)
    for name in options.names:
        if name not in known:
            sys.exit(f"draw.py: no picture '{name}'; there are: {', '.join(known)}")
    options.into.mkdir(parents=True, exist_ok=True)
    for name in options.names or known:
        fig = importlib.import_module(name.replace("-", "_")).draw()
        for picture in [name + ".png"] if options.png else known[name]:
            save(fig, options.into / picture)
            print(options.into / picture)
        plt.close(fig)


if __name__ == "__main__":
    main()
