#!/usr/bin/env python3
"""Gives the program inputs that are made to exhaust it, and checks that it refuses each within bounds.

usage: hostile.py PROGRAM [--full] [NAME ...]

Every case must end with exit code 2 (wrong input) or 4 (a file that cannot be read), with a message, within its
seconds of processor time and of waiting, in an address space of 1.5 GB. The quick form, which the tests run, has long
lines of 8 MB; with --full they are of 1 GB.
"""
import argparse
import os
import pathlib
import resource
import struct
import subprocess
import sys
import tempfile
import time
import zlib

SECONDS = 20
ACCEPTED = ("many_comments",)  # only large
# Each waits ten seconds for a program at the other end of the pipe; the quick form has one of them.
SLOW = ("pipe_in_a_hull_folder", "pipe_as_stl", "pipe_as_obj", "pipe_as_off", "pipe_as_ply", "pipe_as_database",
        "pipe_as_replay")
MEMORY = 1536 * 2**20
REFUSED = (2, 4)
CASES = {}


def case(function):
    """A case: writes its files into a folder and returns the words of the command."""
    CASES[function.__name__] = function
    return function


def scene_with(inner, vessel=""):
    return f'<scene version="1">\n  <time step="0.01" end="0.01"/>\n  {inner}\n  {vessel}\n</scene>\n'


def long_text(path, head, unit, size, tail=""):
    """A file of `size` bytes on one line, written in blocks."""
    block = (unit * (2**20 // len(unit))).encode()
    with open(path, "wb") as out:
        out.write(head.encode())
        for _ in range(size // len(block)):
            out.write(block)
        out.write(tail.encode())


@case
def entity_expansion(folder, size):
    levels = "".join(f'<!ENTITY l{k} "{f"&l{k - 1};" * 10}">' for k in range(1, 12))
    (folder / "s.xml").write_text(
        f'<?xml version="1.0"?><!DOCTYPE scene [<!ENTITY l0 "ice">{levels}]>' + scene_with('<ice kind="&l11;"/>'))
    return ["check", "s.xml"]


@case
def entity_file(folder, size):
    (folder / "s.xml").write_text(
        '<?xml version="1.0"?><!DOCTYPE scene [<!ENTITY x SYSTEM "file:///etc/passwd">]>' + scene_with("&x;"))
    return ["check", "s.xml"]


@case
def deep_elements(folder, size):
    (folder / "s.xml").write_text(scene_with("<ice>" * 100000 + "</ice>" * 100000))
    return ["check", "s.xml"]


@case
def many_attributes(folder, size):
    (folder / "s.xml").write_text(scene_with("<ice " + " ".join(f'a{k}="1"' for k in range(60000)) + "/>"))
    return ["check", "s.xml"]


@case
def many_elements_on_a_line(folder, size):
    (folder / "s.xml").write_text('<scene version="1"><ice>' + '<floe a="1"/>' * 60000 + "</ice></scene>")
    return ["check", "s.xml"]


@case
def many_comments(folder, size):
    (folder / "s.xml").write_text('<scene version="1">' + "<!---->" * 200000 + "</scene>")
    return ["check", "s.xml"]


@case
def long_name(folder, size):
    (folder / "s.xml").write_text(scene_with(f"<{'n' * 10**6} {'a' * 10**6}='1'/>"))
    return ["check", "s.xml"]


@case
def long_line_in_a_value(folder, size):
    long_text(folder / "s.xml", '<scene version="1"><time step="', "1", size, '"/></scene>')
    return ["check", "s.xml"]


@case
def long_line_of_elements(folder, size):
    long_text(folder / "s.xml", '<scene version="1">', "<ice/>", size, "</scene>")
    return ["check", "s.xml"]


@case
def not_a_number(folder, size):
    (folder / "s.xml").write_text('<scene version="1"><time step="nan" end="inf"/></scene>')
    return ["check", "s.xml"]


@case
def denormal_step(folder, size):
    (folder / "s.xml").write_text('<scene version="1"><time step="4.9e-324" end="1"/></scene>')
    return ["check", "s.xml"]


@case
def number_beyond_doubles(folder, size):
    (folder / "s.xml").write_text('<scene version="1"><time step="1e-400" end="1e400"/></scene>')
    return ["check", "s.xml"]


@case
def denormal_override(folder, size):
    (folder / "s.xml").write_text(scene_with(""))
    return ["check", "s.xml", "--set", "time/@step=1e-310"]


@case
def odd_names(folder, size):
    (folder / "s.xml").write_text(scene_with("", '<vessel hull="\x1b[31m&quot;%n%s$(id)`id`\t&#10;&#x7f;\u202e.stl"/>'))
    return ["check", "s.xml"]


@case
def name_too_long(folder, size):
    return ["check", "x" * 300]


@case
def path_too_long(folder, size):
    return ["check", "x/" * 4000]


@case
def name_with_a_line_feed(folder, size):
    return ["check", "a\nb\x1b]0;title\x07.xml"]


@case
def link_to_itself(folder, size):
    (folder / "s.xml").symlink_to("s.xml")
    return ["check", "s.xml"]


@case
def links_in_a_circle(folder, size):
    (folder / "a").symlink_to("b")
    (folder / "b").symlink_to("a")
    return ["check", "a/s.xml"]


@case
def folder_as_scene(folder, size):
    (folder / "s.xml").mkdir()
    return ["check", "s.xml"]


@case
def pipe_as_scene(folder, size):
    os.mkfifo(folder / "s.xml")
    return ["check", "s.xml"]


@case
def endless_device_as_scene(folder, size):
    return ["check", "/dev/zero"]


@case
def link_to_a_device(folder, size):
    (folder / "s.xml").symlink_to("/dev/zero")
    return ["check", "s.xml"]


@case
def device_as_hull(folder, size):
    (folder / "s.xml").write_text(scene_with("", '<vessel hull="/dev/zero"/>'))
    return ["check", "s.xml"]


@case
def pipe_as_field(folder, size):
    os.mkfifo(folder / "f.geojson")
    (folder / "s.xml").write_text(scene_with('<ice><field kind="file" file="f.geojson"/></ice>'))
    return ["check", "s.xml"]


@case
def pipe_in_a_hull_folder(folder, size):
    (folder / "hull").mkdir()
    os.mkfifo(folder / "hull/fluid.stl")
    (folder / "s.xml").write_text(scene_with("", '<vessel hull="hull"/>'))
    return ["check", "s.xml"]


for _ending in ("stl", "obj", "off", "ply"):

    def _pipe(folder, size, ending=_ending):
        os.mkfifo(folder / f"m.{ending}")
        return ["hull", f"m.{ending}", "--out", "h"]

    def _device(folder, size, ending=_ending):
        (folder / f"m.{ending}").symlink_to("/dev/zero")
        return ["hull", f"m.{ending}", "--out", "h"]

    CASES[f"pipe_as_{_ending}"] = _pipe
    CASES[f"device_as_{_ending}"] = _device


def field_scene(folder, text=None):
    if text is not None:
        (folder / "f.geojson").write_text(text)
    (folder / "s.xml").write_text(
        '<scene version="1"><time step="0.01" end="0.01"/><ice thickness="0.1"><field kind="file" file="f.geojson"/></ice></scene>')
    return ["field", "s.xml", "--out", "out.geojson"]


@case
def deep_field(folder, size):
    deep = "[" * 100000 + "]" * 100000
    return field_scene(
        folder, '{"type":"FeatureCollection","features":[{"type":"Feature","geometry":{"type":"Polygon","coordinates":'
        + deep + "}}]}")


@case
def deep_field_type(folder, size):
    deep = "[" * 100000 + "]" * 100000
    return field_scene(
        folder, '{"type":"FeatureCollection","features":[{"type":"Feature","geometry":{"type":' + deep + "}}]}")


@case
def field_of_nan(folder, size):
    return field_scene(folder, '{"type":"FeatureCollection","features":[{"type":"Feature","geometry":{"type":"Polygon",'
                       '"coordinates":[[[0,0],[1e999,0],[NaN,1],[0,0]]]}}]}')


@case
def floe_of_many_corners(folder, size):
    ring = [[float(k), (k * k) / 1e6] for k in range(60000)]
    return field_scene(folder, '{"type":"FeatureCollection","features":[{"type":"Feature","geometry":{"type":"Polygon",'
                       f'"coordinates":[{ring + ring[:1]}]}}}}]}}')


@case
def field_of_one_line(folder, size):
    long_text(folder / "f.geojson", '{"type":"FeatureCollection","features":[', "[],", size, "[]]}")
    return field_scene(folder)


@case
def face_of_many_corners(folder, size):
    long_text(folder / "m.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf ", "1 2 3 ", size)
    return ["hull", "m.obj", "--out", "h"]


@case
def mesh_of_one_line(folder, size):
    long_text(folder / "m.stl", "solid ", "x", size)
    return ["hull", "m.stl", "--out", "h"]


@case
def promises_of_a_ply(folder, size):
    (folder / "m.ply").write_bytes(
        b"ply\nformat binary_little_endian 1.0\nelement vertex 4000000000\nproperty float x\nproperty float y\n"
        b"property float z\nelement face 4000000000\nproperty list uint int vertex_indices\nend_header\n" + bytes(64))
    return ["hull", "m.ply", "--out", "h"]


@case
def promises_of_an_stl(folder, size):
    (folder / "m.stl").write_bytes(bytes(80) + struct.pack("<I", 2**32 - 1) + bytes(500))
    return ["hull", "m.stl", "--out", "h"]


@case
def mesh_of_nan(folder, size):
    one = struct.pack("<12fH", *([float("nan")] * 12), 0)
    (folder / "m.stl").write_bytes(bytes(80) + struct.pack("<I", 4) + one * 4)
    return ["hull", "m.stl", "--out", "h"]


@case
def denormal_mesh(folder, size):
    corners = [(0, 0, 0), (1e-310, 0, 0), (0, 1e-310, 0), (0, 0, 1e-310)]
    text = "".join(f"v {x!r} {y!r} {z!r}\n" for x, y, z in corners) + "f 1 3 2\nf 1 2 4\nf 2 3 4\nf 3 1 4\n"
    (folder / "m.obj").write_text(text)
    return ["hull", "m.obj", "--out", "h"]


def netcdf_names(name_bytes, rank):
    """A classic NetCDF file with one long name that a variable repeats for each of its dimensions."""
    def word(n):
        return struct.pack(">I", n)

    dims = word(10) + word(1) + word(name_bytes) + b"n" * name_bytes + word(1)
    one = word(1) + b"v\0\0\0" + word(rank) + word(0) * rank + word(0) + word(0) + word(6) + word(8) + word(0)
    return b"CDF\1" + word(0) + dims + word(0) + word(0) + word(11) + word(1) + one


@case
def names_in_netcdf(folder, size):
    (folder / "d.nc").write_bytes(netcdf_names(2**18, 2**16))
    return ["hydro", "d.nc"]


@case
def wamit_of_one_line(folder, size):
    long_text(folder / "d.1", "", "1 ", size)
    return ["hydro", "d.1", "--length", "1", "--density", "1025", "--gravity", "9.81"]


@case
def pipe_as_database(folder, size):
    os.mkfifo(folder / "d.nc")
    return ["hydro", "d.nc"]


@case
def pipe_as_problem(folder, size):
    os.mkfifo(folder / "p.hdf5")
    return ["solve", "p.hdf5"]


@case
def device_as_problem(folder, size):
    return ["solve", "/dev/zero"]


def run_folder(folder, replay):
    (folder / "run").mkdir()
    (folder / "run/scene.xml").write_text(scene_with(""))
    (folder / "run/replay.bin").write_bytes(replay)
    return ["view", "run"]


def piece(kind, content):
    return kind + struct.pack("<I", len(content)) + content + b"\n"


@case
def bomb_in_a_replay(folder, size):
    packer, packed = zlib.compressobj(1), b""
    for _ in range(4096 if size == 2**30 else 300):
        packed += packer.compress(bytes(2**20))
    packed += packer.flush()
    return run_folder(folder, b"NILASRP4" + piece(b"H", packed) + piece(b"F", zlib.compress(b"x")))


@case
def deep_head_of_a_replay(folder, size):
    head = zlib.compress(b'{"scene":' + b"[" * 10**5 + b"]" * 10**5 + b"}")
    return run_folder(folder, b"NILASRP4" + piece(b"H", head) + piece(b"F", zlib.compress(b"x")))


@case
def pipe_as_replay(folder, size):
    run_folder(folder, b"")
    (folder / "run/replay.bin").unlink()
    os.mkfifo(folder / "run/replay.bin")
    return ["view", "run"]


@case
def deep_summary(folder, size):
    (folder / "run").mkdir()
    (folder / "run/summary.json").write_text("[" * 10**5 + "]" * 10**5)
    return ["run", "s.xml", "--open-water-run", "run"] if (folder / "s.xml").write_text(scene_with("")) else []


def confine():
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, MEMORY))
    resource.setrlimit(resource.RLIMIT_CPU, (SECONDS, SECONDS))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))


def fault_of(program, name, size):
    """What the program does wrong with a case, or nothing; and its seconds and memory."""
    with tempfile.TemporaryDirectory(prefix="nilas-hostile-") as path:
        folder = pathlib.Path(path)
        words = CASES[name](folder, size)
        before, begin = resource.getrusage(resource.RUSAGE_CHILDREN), time.monotonic()
        try:
            done = subprocess.run([program, *words], cwd=folder, stdin=subprocess.DEVNULL, capture_output=True,
                                  timeout=6 * SECONDS, preexec_fn=confine)
        except subprocess.TimeoutExpired:
            return "is not refused in time: it waits", time.monotonic() - begin
        after = resource.getrusage(resource.RUSAGE_CHILDREN)
    seconds = after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime
    said = done.stderr.decode(errors="replace")
    if name in ACCEPTED and done.returncode == 0:
        return "", seconds
    if done.returncode not in REFUSED:
        return f"ends with {done.returncode}: {said[:300]!r}", seconds
    if not said.strip():
        return "ends without a message", seconds
    if len(said) > 2**20:
        return f"ends with a message of {len(said)} bytes", seconds
    if any(c in said for c in "\x1b\x07"):
        return f"sends control characters to the terminal: {said[:200]!r}", seconds
    return "", seconds


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("program")
    parser.add_argument("--full", action="store_true")
    parser.add_argument("names", nargs="*")
    options = parser.parse_intermixed_args()
    program, failed, total = os.path.abspath(options.program), 0, 0.0
    names = options.names or [name for name in CASES if options.full or name not in SLOW]
    for name in names:
        fault, seconds = fault_of(program, name, 2**30 if options.full else 2**23)
        total += seconds
        failed += bool(fault)
        print(f"{seconds:8.2f} s  {name}{': ' + fault if fault else ''}", flush=True)
    print(f"{len(names) - failed} of {len(names)} refused; {total:.1f} s")
    return 1 if failed else 0


if __name__ == "__main__":
    sys.exit(main())
