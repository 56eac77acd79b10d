"""What a run holds and has written while it goes on."""
from dataclasses import dataclass
from pathlib import Path
from typing import Sequence

TAIL = 4096  # bytes at the end of steps.csv that hold its last row


@dataclass
class Sample:
    """A moment of a run."""

    steps: int
    resident: int           # memory [B]
    bytes: dict[str, int]   # sizes by the name of the file; the trajectory's frames count as one


@dataclass
class Growth:
    """A quantity over the steps, each half by a straight line."""

    first: float        # at the first sample
    last: float         # at the last one
    steps: int          # between them
    second_half: float  # growth per step
    ratio: float        # to that of the first half; 1 where nothing grows


def _steps_done(folder: Path, start: float, step: float) -> int | None:
    """Number of the last whole row of steps.csv; None before there is one."""
    try:
        with (folder / "steps.csv").open("rb") as file:
            size = file.seek(0, 2)
            file.seek(max(0, size - TAIL))
            lines = file.read().decode().split("\n")
    except OSError:
        return None
    # The last piece has no line end yet; the first may be cut.
    row = lines[-2].split(",")[0] if len(lines) > 2 else ""
    try:
        return round((float(row) - start) / step)
    except ValueError:
        return None


def sample(process: int, folder: Path, start: float, step: float) -> Sample | None:
    """The present moment; None where the run has not begun or is over."""
    steps = _steps_done(folder, start, step)
    try:
        status = Path(f"/proc/{process}/status").read_text(encoding="utf-8")
    except OSError:
        return None
    resident = [line.split()[1] for line in status.splitlines() if line.startswith("VmRSS")]
    if steps is None or not resident:
        return None
    sizes = {path.name: path.stat().st_size for path in folder.iterdir() if path.suffix in (".csv", ".h5", ".bin", ".pvd")}
    return Sample(steps, 1024 * int(resident[0]), sizes)


def _slope(points: Sequence[tuple[int, float]]) -> float:
    """Growth per step by least squares."""
    n = len(points)
    x0, y0 = sum(x for x, _ in points) / n, sum(y for _, y in points) / n
    spread = sum((x - x0) ** 2 for x, _ in points)
    return sum((x - x0) * (y - y0) for x, y in points) / spread if spread else 0.0


def growth(points: Sequence[tuple[int, float]]) -> Growth:
    """The growth of a quantity over the second tenth of the run to its end, since the start only prepares."""
    kept = [point for point in points if point[0] >= 0.1 * points[-1][0]]
    middle = (kept[0][0] + kept[-1][0]) / 2
    halves = [point for point in kept if point[0] <= middle], [point for point in kept if point[0] >= middle]
    first, second = _slope(halves[0]), _slope(halves[1])
    ratio = second / first if first > 0 else 1.0 if second <= 0 else float("inf")
    return Growth(points[0][1], points[-1][1], kept[-1][0] - kept[0][0], second, ratio)
