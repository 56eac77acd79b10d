#!/usr/bin/env python3
"""Changes study files by chance, reads each, and reports what the reader neither takes nor refuses.

usage: study_inputs.py SECONDS FOLDER [SEED]

The reader must return a study or raise StudyError. Inputs for which it does otherwise, or that take more than five
seconds of processor time, are written to FOLDER. The changes follow from the seed alone.
"""
import hashlib
import pathlib
import random
import resource
import sys
import tempfile
import time
import traceback

ROOT = pathlib.Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "python"))
from nilas.study.describe.faults import StudyError  # noqa: E402
from nilas.study.describe.read_study import read_study  # noqa: E402

LONGEST, SLOWEST = 1500, 5.0
WORDS = (
    "scene: scene.xml", "factors:", "responses:", "design:", "seeds:", "run:", "job:", "set:", "kind: table", "rows:",
    "file: rows.csv", "latin-hypercube", "sobol", "full", "count: 3", "until:", "relative_error: 0.1", "most:", "path:",
    "values:", "low:", "high:", "steps:", "vessel/@speed", "channel:", "mean", "threads: 2", "keep: nothing", "&a ", "*a",
    "!!python/object:os.system", "<<: *a", "? ", "- ", "  ", "\n", "{", "}", "[", "]", ": ", "'", '"', "|", ">", "%YAML 1.2",
    "---", "...", "\t", "\\0", "\ufeff", "\u202e", "1e400", "nan", "-0", "1_000", "0x10", "9" * 5000, "x" * 300, "../" * 50,
    "null", "~", "yes")  # fmt: skip


def seeds():
    for folder in (ROOT / "apps/scenes/validation", ROOT / "tests/slurm", ROOT / "tests/fuzz/corpus/study"):
        for file in sorted(folder.glob("*")):
            if file.is_file() and file.suffix in (".yaml", ""):
                yield file.read_text(encoding="utf-8")[:LONGEST]
    yield "scene: scene.xml\nfactors:\n  speed: {path: vessel/@speed, values: [1, 2]}\nresponses:\n  load: {channel: fx_N}\n"


def changed(text, others, chance):
    for _ in range(chance.choice((1, 1, 2, 4, 8))):
        at = chance.randrange(len(text) + 1)
        to = min(len(text), at + chance.choice((1, 2, 8, 40)))
        other = chance.choice(others)
        cut = chance.randrange(len(other) + 1)
        text = text[:at] + chance.choice((
            "", chance.choice(WORDS), chr(chance.choice((0, 9, 10, 32, 58, 91, 123, 0x85, 0xFFFE, chance.randrange(0x2FF)))),
            other[cut:cut + chance.choice((8, 40, 200))], text[at:to] * chance.choice((2, 3, 50)))) + text[to if
                                                                                                           chance.random() < 0.6 else at:]
    return text[:LONGEST]


def lines_reached(code):
    """Calls, and returns the lines of the reader that ran."""
    reached = set()

    def note(frame, event, _):
        if "nilas/study/describe" not in frame.f_code.co_filename:
            return None
        reached.add((frame.f_code.co_filename, frame.f_lineno))
        return note

    sys.settrace(note)
    try:
        code()
    finally:
        sys.settrace(None)
    return reached


def main():
    seconds, found, seed = float(sys.argv[1]), pathlib.Path(sys.argv[2]), int((sys.argv[3:] or ["1"])[0])
    # What takes more is a finding too, as a MemoryError.
    resource.setrlimit(resource.RLIMIT_AS, (2**31, 2**31))
    chance, pool = random.Random(seed), list(seeds())
    inputs, slowest, reached, end = 0, 0.0, set(), time.monotonic() + seconds
    with tempfile.TemporaryDirectory() as path:
        folder = pathlib.Path(path)
        (folder / "scene.xml").write_text("<scene version='1'/>")
        (folder / "rows.csv").write_text("speed,x\n1,2\n")
        file = folder / "study.yaml"
        while time.monotonic() < end:
            text = changed(chance.choice(pool), pool, chance) if inputs >= len(pool) else pool[inputs]
            file.write_bytes(text.encode("utf-8", "surrogatepass"))

            def read():
                try:
                    read_study(file)
                except StudyError:
                    pass

            begin, inputs = time.process_time(), inputs + 1
            try:
                # To follow the lines takes ten times as long as to read.
                fresh = lines_reached(read) - reached if inputs % 8 == 1 or inputs <= len(pool) else read()
                if fresh:
                    reached |= fresh
                    pool.append(text)
                fault = ""
            except Exception:  # noqa: BLE001  (all others are what is searched for)
                fault = traceback.format_exc()
            took = time.process_time() - begin
            slowest = max(slowest, took)
            if fault or took > SLOWEST:
                kept = found / f"study-{hashlib.sha256(fault.encode()).hexdigest()[:8]}"
                if not kept.exists():
                    kept.write_text(text)
                    print(f"{fault}\nTest unit written to {kept}", file=sys.stderr, flush=True)
    print(f"#{inputs}\tDONE cov: {len(reached)} \nstat::peak_rss_mb: "
          f"{resource.getrusage(resource.RUSAGE_SELF).ru_maxrss >> 10}\nslowest input: {slowest:.6f} s", file=sys.stderr)


if __name__ == "__main__":
    main()
