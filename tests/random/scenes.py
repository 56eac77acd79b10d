#!/usr/bin/env python3
"""Makes random scenes over the whole schema, runs them and judges the runs.

usage: scenes.py [--count N | --seconds N] [--seed S] [--out FOLDER] [--program FILE] [--brief] [--shrink SECONDS]

Scene k of a campaign is a function of seed S + k alone. Each judge states an invariant, such as closed accounts, the
same bits on two threads, or that the mirrored scene moves as the mirror image. A failing scene is made small and stored
in FOLDER/failed with a sentence. Tables are written into FOLDER. The exit code is 1 where a judge found a fault.
With --brief the judges check, again, threads and resumed are asked in turn, one for each scene.
"""
import argparse
import sys
import time
from pathlib import Path

sys.dont_write_bytecode = True  # leaves no folder beside the sources
sys.path.insert(0, str(Path(__file__).resolve().parent))
from campaign import Campaign  # noqa: E402  (it stands beside this script)
from program import Program  # noqa: E402

REPOSITORY = Path(__file__).resolve().parents[2]


def main() -> int:
    """Runs a campaign as the command line asks; gives the exit code."""
    parser = argparse.ArgumentParser(description=(__doc__ or "").split("\n")[0])
    parser.add_argument("--count", type=int, default=100, help="number of scenes")
    parser.add_argument("--seconds", type=float, help="goes on for this wall time instead")
    parser.add_argument("--seed", type=int, default=1, help="seed of the first scene")
    parser.add_argument("--out", type=Path, default=REPOSITORY / "runs" / "scenes",
                        help="folder of tables and failing scenes")
    parser.add_argument("--program", type=Path, default=REPOSITORY / "build" / "release" / "nilas",
                        help="program under test")
    parser.add_argument("--brief", action="store_true", help="one group of judges with further runs for each scene")
    parser.add_argument("--shrink", type=float, default=120,
                        help="wall time to make a failing scene small [s]; 0: leave it")
    options = parser.parse_args()
    campaign = Campaign(Program(options.program), options.out.resolve(), options.brief, options.shrink)
    began, seed = time.monotonic(), options.seed
    while (time.monotonic() - began < options.seconds) if options.seconds else seed < options.seed + options.count:
        campaign.judge(seed)
        seed += 1
        if (seed - options.seed) % 50 == 0:
            campaign.write()
    campaign.write()
    print(campaign.report())
    return 1 if campaign.failures else 0


if __name__ == "__main__":
    sys.exit(main())
