"""Loses the power of the machine at each change of a file, and continues from what the disk then holds."""

from __future__ import annotations

import argparse
import random
import shutil
import time
from collections import Counter
from pathlib import Path

from commands import Bench, Command, prepared
from interpose import Plan
from plans import share_of_time

COLUMNS = ("command", "disk", "changes", "tried", "mended", "bad")
# What the disk holds. cut: all names, and the content of files as of their last flush. zeros: the same, with the length
# that files had and zeros for what was not flushed. old names: names, too, as of the last flush of their folder.
DISKS = ("cut", "zeros", "old names")


def campaign(
    bench: Bench, store: Path, options: argparse.Namespace, end: float
) -> tuple[tuple[str, ...], list[dict]]:
    """Each change of each command, or as many as `--most`; a row for each command and disk."""
    rows = []
    names = [name for name in options.of.split(",") if name != "report"]
    for k, name in enumerate(names):
        its_end = share_of_time(end, len(names) - k)
        command = prepared(name, bench, store)
        bench.put_back(command.out, command.before)
        changes = bench.runner.run(bench.words(command.words)).calls["change"]
        chance = random.Random(f"{options.seed} power {name}")
        places = [options.at] if options.at else list(range(1, changes + 1))
        places = chance.sample(places, min(len(places), options.most))
        counts: dict[str, Counter[str]] = {disk: Counter() for disk in DISKS}
        for at in places:
            if time.monotonic() < its_end:
                _lose(bench, command, at, counts)
        for disk in DISKS:
            rows.append({"command": name, "disk": disk, "changes": changes, **counts[disk]})
            print(", ".join(f"{column} {rows[-1].get(column, 0)}" for column in COLUMNS), flush=True)
    return COLUMNS, rows


def _lose(bench: Bench, command: Command, at: int, counts: dict[str, Counter[str]]) -> None:
    """One loss of power, continued from each disk."""
    out = bench.folder / command.out
    bench.put_back(command.out, command.before)
    disk = Disk(bench.folder.with_name("shadow"), bench.folder)
    plan = Plan("change", at, "kill")
    ended = bench.runner.run(bench.words(command.words), plan, disk.shadow)
    stopped = bench.folder.with_name("stopped")
    shutil.rmtree(stopped, ignore_errors=True)
    if out.exists():
        out.rename(stopped)
    for kind in DISKS:
        disk.restore(kind, stopped, out)
        counts[kind]["tried"] += 1
        fault = command.mend()
        counts[kind]["mended"] += not fault
        if fault:
            counts[kind]["bad"] += 1
            print(f"BAD {command.name}: no power before change {at} ({ended.where()}), {kind}: {fault}", flush=True)


class Disk:
    """What was flushed: see interposer/shadow.h."""

    def __init__(self, shadow: Path, folder: Path) -> None:
        """``folder``: what it holds already is on the disk."""
        self.shadow = shadow
        self._base = folder
        shutil.rmtree(shadow, ignore_errors=True)
        (shadow / "files").mkdir(parents=True)
        (shadow / "kept").mkdir()
        lines = []
        for path in [folder, *folder.rglob("*")]:
            if path.is_dir():
                lines.append(f"D {path}")
                lines += [f"{'S' if entry.is_dir() else 'E'} {entry.stat().st_ino} {entry.name}" for entry in path.iterdir()]
            else:
                shutil.copyfile(path, shadow / "files" / str(path.stat().st_ino))
        (shadow / "journal").write_text("".join(line + "\n" for line in lines))

    def restore(self, kind: str, stopped: Path, out: Path) -> None:
        """Makes the output folder that the disk holds. ``stopped``: the folder as the program left it."""
        shutil.rmtree(out, ignore_errors=True)
        if kind == "old names":
            self._restore_names(out)
            return
        if not stopped.exists():
            return
        shutil.copytree(stopped, out)
        for file in stopped.rglob("*"):
            if file.is_file():
                (out / file.relative_to(stopped)).write_bytes(self._content(file, kind == "zeros"))

    def _content(self, file: Path, zeros: bool) -> bytes:
        flushed = self.shadow / "files" / str(file.stat().st_ino)
        content = flushed.read_bytes() if flushed.exists() else b""
        size = file.stat().st_size
        return content + bytes(size - len(content)) if zeros and size > len(content) else content

    def _restore_names(self, out: Path) -> None:
        """The names as of the last flush of their folder; a flushed file has the name of that time."""
        names: dict[Path, dict[str, str | None]] = {}  # the inode of each file; None for a folder
        folder = Path()
        for line in (self.shadow / "journal").read_text().splitlines():
            kind, _, rest = line.partition(" ")
            if kind == "D":
                folder = Path(rest)
                names[folder] = {}
                continue
            inode, _, name = rest.partition(" ")
            if kind in "ES" and name not in (".", ".."):
                names[folder][name] = inode if kind == "E" else None
            elif kind == "F":
                names.setdefault(Path(name).parent, {})[Path(name).name] = inode
        for folder, entries in names.items():
            if folder != out and out not in folder.parents:
                continue
            for name, inode in entries.items():
                if inode is None or (folder / name) in names:
                    (folder / name).mkdir(parents=True, exist_ok=True)
                    continue
                folder.mkdir(parents=True, exist_ok=True)
                flushed = self.shadow / "files" / inode
                if not (folder / name).is_dir():
                    (folder / name).write_bytes(flushed.read_bytes() if flushed.exists() else b"")
