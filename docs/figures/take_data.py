#!/usr/bin/python3
"""Runs the program for the pictures that show its results, and keeps what they draw in data/.

usage: /usr/bin/python3 docs/figures/take_data.py [--nilas PROGRAM] [--work FOLDER] [WHAT...]

WHAT: fields (seconds), hull (a minute), towing (minutes), level-ice (minutes), compare (five minutes); all without.
PROGRAM is build/release/nilas unless given; the runs stay in FOLDER (default: figures-work in the system's temporary
folder). Runs of the same build on the same kind of machine give the same data; times of `compare` differ.
"""
import argparse
import base64
import csv
import json
import pathlib
import re
import struct
import subprocess
import tempfile

import numpy as np

HERE = pathlib.Path(__file__).resolve().parent
REPOSITORY = HERE.parents[1]
SCENES = REPOSITORY / "apps/scenes"
DATA = HERE / "data"

# ---------------------------------------------------------------------------------------------------------------- fields
REGION = "0 0 12 8"
FIELDS = {  # one scene per kind: what stands inside <ice>
    "packed": f'<field kind="packed" region="{REGION}" concentration="0.85">'
              '<size distribution="lognormal" mean="0.9" sd="0.3" min="0.4" max="1.7"/>'
              '<shape kind="polygon" vertices="5 8"/></field>',
    "voronoi": f'<field kind="voronoi" region="{REGION}" concentration="0.95">'
               '<size distribution="lognormal" mean="0.9" sd="0.3" min="0.4" max="1.7"/></field>',
    "grid": f'<field kind="grid" region="{REGION}" rows="6" columns="9" gap="0.08" shear_deg="30"/>',
    "channel": f'<field kind="channel" region="{REGION}" concentration="0.8" channel_width="3.6">'
               '<size distribution="lognormal" mean="0.6" sd="0.2" min="0.3" max="1.1"/></field>',
    "level": '<field kind="level" region="4.2 0.6 12 7.4" fixed="true"/>',
    "file": '<field kind="file" file="{file}"/>',
}
FIELD_SCENE = """<?xml version="1.0" encoding="UTF-8"?>
<scene version="1" name="field-{kind}">
  <seed value="3"/>
  <water density="1005"/>
  <hydro><buoyancy/></hydro>
{vessel}  <ice density="920" thickness="0.04">
    {field}
  </ice>
</scene>
"""
FIELD_VESSEL = """  <vessel name="ship" hull="{hull}" position="0.3 4"><mass draught="0.35"/><fixed/></vessel>
"""


def outlines(geojson):
    """Rings of a field's floes, in millimetres."""
    found = []
    for feature in json.loads(pathlib.Path(geojson).read_text())["features"]:
        if feature["geometry"]["type"] != "Polygon":
            continue
        ring = feature["geometry"]["coordinates"][0][:-1]
        found.append({"ring_mm": [round(1000 * c) for point in ring for c in point],
                      "fixed": bool(feature["properties"].get("fixed", False))})
    return found


def fields(run, work):
    kept = {}
    floes = work / "observed.geojson"  # of kind file: a few outlines as from a photograph, concave ones among them
    rings = observed_floes()
    floes.write_text(json.dumps({"type": "FeatureCollection", "features": [
        {"type": "Feature", "properties": {}, "geometry": {"type": "Polygon", "coordinates": [ring + ring[:1]]}}
        for ring in rings]}))
    for kind, field in FIELDS.items():
        scene = work / f"field-{kind}.xml"
        vessel = FIELD_VESSEL.format(hull=SCENES / "hulls/icebreaker") if kind == "level" else ""
        scene.write_text(FIELD_SCENE.format(kind=kind, vessel=vessel, field=field.format(file=floes)))
        out = work / f"field-{kind}.geojson"
        run("field", scene, "--out", out)
        kept[kind] = outlines(out)
    write("fields.json", kept)


def observed_floes():
    """Outlines of uneven, partly concave floes at the places of a coarse net, from a fixed stream of numbers."""
    stream = np.random.Generator(np.random.PCG64(5))
    rings = []
    for i, x in enumerate(np.arange(1.35, 12, 2.3)):
        for j, y in enumerate(np.arange(1.25, 8, 1.85)):
            count = 26
            angle = 2 * np.pi * np.arange(count) / count
            waves = sum(stream.normal(0, 0.2 / k) * np.cos(k * angle + stream.uniform(0, 2 * np.pi)) for k in (2, 3, 4, 5))
            radius = stream.uniform(0.6, 0.78) * (1 + waves)
            radius = np.minimum(radius, 0.88)
            rings.append([[round(float(x + 1.1 * r * np.cos(a)), 3), round(float(y + r * np.sin(a)), 3)]
                          for r, a in zip(radius, angle)])
    return rings


# ------------------------------------------------------------------------------------------------------------------ hull
def ship_with_bulb(stations=60, heights=18, rings=10):
    """A ship of 6 m with hollow entrance and flared bow, and an ellipsoid as its bulb: the forms of
    tests/core/mesh/hull_shapes.h. Triangles, count x 3 x 3."""
    found = []

    def add(*corners):
        for b, c in zip(corners[1:], corners[2:]):
            triangle = [np.asarray(p, dtype=np.float32) for p in (corners[0], b, c)]
            if len({tuple(p) for p in triangle}) == 3:
                found.append(triangle)

    def half_breadth(x, z):
        t, aft = np.clip((x - 3.4) / 2.6, 0, 1), np.clip(1 - x / 1.2, 0, 1)
        return 0.6 * (1 - t * t) ** 1.5 * (1 - 0.3 * aft * aft) * (z / 0.6) ** (0.25 + 1.2 * t * t)

    def at(i, j, side):
        x, z = 6 * i / stations, 0.6 * (j / heights) ** 2
        return x, 0.0 if i == stations or j == 0 else side * half_breadth(x, z), z

    for i in range(stations):
        for j in range(heights):
            if i + 1 == stations and j == 0:
                add(at(i, 0, 1), at(i, 1, 1), at(stations, 1, 1))
                add(at(i, 0, -1), at(stations, 1, -1), at(i, 1, -1))
                continue
            add(at(i, j, 1), at(i, j + 1, 1), at(i + 1, j + 1, 1), at(i + 1, j, 1))
            add(at(i, j, -1), at(i + 1, j, -1), at(i + 1, j + 1, -1), at(i, j + 1, -1))
        add(at(i, heights, 1), at(i, heights, -1), at(i + 1, heights, -1), at(i + 1, heights, 1))
    for j in range(heights):
        add(at(0, j, 1), at(0, j, -1), at(0, j + 1, -1), at(0, j + 1, 1))

    def bulb(i, j):
        u, v = np.pi * i / rings, np.pi * (j % (2 * rings)) / rings
        ring = 0.0 if i % rings == 0 else np.sin(u)
        return 5.9 + 0.5 * np.cos(u), 0.09 * ring * np.cos(v), 0.12 + 0.1 * ring * np.sin(v)

    for i in range(rings):
        for j in range(2 * rings):
            add(bulb(i, j), bulb(i + 1, j), bulb(i + 1, j + 1), bulb(i, j + 1))
    return np.array(found)


def write_stl(triangles, path):
    with open(path, "wb") as file:
        file.write(bytes(80) + struct.pack("<I", len(triangles)))
        for triangle in triangles:
            file.write(bytes(12) + triangle.astype("<f4").tobytes() + bytes(2))


def hull(run, work):
    from icebreaker import triangles as read_stl
    mesh, out = work / "ship-with-bulb.stl", work / "ship-with-bulb"
    write_stl(ship_with_bulb(), mesh)
    run("hull", mesh, "--out", out, "--tolerance", "0.012", "--force")
    report = json.loads((out / "hull.json").read_text())
    parts = []
    for file in sorted(out.glob("part-*.stl")):
        corners = np.unique(read_stl(file).reshape(-1, 3), axis=0)
        parts.append([round(1e4 * c) for point in corners for c in point])
    write("hull-parts.json", {"unit_m": 1e-4, "deviation_m": report["deviation_m"], "tolerance_m": report["tolerance_m"],
                              "mesh_triangles": report["triangles"], "parts": parts})


# ------------------------------------------------------------------------------------------------------------------ runs
def expand(block, size):
    """LZ4 block format."""
    out, at = bytearray(), 0
    while True:
        token, at = block[at], at + 1
        literals = token >> 4
        if literals == 15:
            while True:
                literals, at = literals + block[at], at + 1
                if block[at - 1] != 255:
                    break
        out += block[at:at + literals]
        at += literals
        if len(out) >= size:
            return bytes(out)
        distance, at = block[at] + 256 * block[at + 1], at + 2
        match = token & 15
        if match == 15:
            while True:
                match, at = match + block[at], at + 1
                if block[at - 1] != 255:
                    break
        for _ in range(match + 4):
            out.append(out[-distance])


def arrays(vtp):
    """The numeric arrays of a frame of trajectory/ by name."""
    kinds = {"Float64": "<f8", "Float32": "<f4", "Int32": "<i4", "Int64": "<i8", "UInt8": "u1", "Int8": "i1"}
    found = {}
    for kind, name, components, text in re.findall(
            r'<DataArray type="(\w+)" Name="(\w+)" NumberOfComponents="(\d+)"[^>]*>([^<]*)</DataArray>',
            pathlib.Path(vtp).read_text()):
        header = struct.unpack("<4I", base64.b64decode(text[:24])[:16])
        if header[0] == 0:
            continue
        data = expand(base64.b64decode(text[24:])[:header[3]], header[1])
        values = np.frombuffer(data, dtype=kinds[kind])
        found[name] = values.reshape(-1, int(components)) if int(components) > 1 else values
    return found


def upper_faces(vtp):
    """Of each floe: its upper face in plan [mm], its speed [mm/s]. A floe's polygons: lower face, upper face, sides."""
    frame = arrays(vtp)
    ends = frame["offsets"]
    starts = np.concatenate([[0], ends[:-1]])
    seen, faces = {}, []
    for k, body in enumerate(frame["id"]):
        seen[body] = seen.get(body, 0) + 1
        if seen[body] == 2:
            corners = frame["Points"][frame["connectivity"][starts[k]:ends[k]]]
            faces.append({"ring_mm": [round(1000 * float(c)) for p in corners for c in p[:2]],
                          "z_mm": round(1000 * float(corners[:, 2].mean())),
                          "speed_mm_s": round(1000 * float(frame["speed_m_s"][k]))})
    return faces


def last_frame(folder):
    return sorted((folder / "trajectory").glob("step-*-ice.vtp"))[-1]


def column(file, names):
    with open(file, newline="") as text:
        rows = list(csv.DictReader(text))
    return [[float(row[name]) for row in rows] for name in names]


def plan_of(folder, scene):
    x, y, yaw = column(folder / "vessel.csv", ["x_m", "y_m", "yaw_deg"])
    t, = column(folder / "vessel.csv", ["time_s"])
    summary = json.loads((folder / "summary.json").read_text())
    return {"scene": scene, "time_s": round(t[-1], 6), "vessel_com_m": [round(x[-1], 4), round(y[-1], 4)],
            "yaw_deg": round(yaw[-1], 4), "floes": upper_faces(last_frame(folder)),
            "cog_m": summary.get("vessel", {}).get("cog_m")}


def towing(run, work):
    out = work / "towing"
    run("run", SCENES / "towing.xml", "--out", out, "--until", "40", "--set", "output/@trajectory_every=1", "--force")
    write("towing.json", plan_of(out, "towing"))
    load, = column(out / "vessel.csv", ["ice_resistance_N"])
    summary = json.loads((out / "summary.json").read_text())
    write("towing-load.json", {"step_s": 0.01, "ice_resistance_cN": [round(100 * f) for f in load],
                               "window": summary["window"],
                               "load_error": {key: value for key, value in summary["load_error"].items()
                                              if key != "methods"}})


def level_ice(run, work):
    out = work / "level-ice"
    run("run", SCENES / "level-ice.xml", "--out", out, "--until", "12", "--set", "output/@trajectory_every=1", "--force")
    write("level-ice.json", plan_of(out, "level-ice"))


# --------------------------------------------------------------------------------------------------------------- compare
def compare(run, work):
    out = work / "compare"
    run("compare", SCENES / "presawn-c.xml", "--budget", "280", "--jobs", "2", "--out", out, "--force")
    # times are those of the machine, and so is what fits into the budget
    (DATA / "compare-settings.csv").write_text((out / "settings.csv").read_text())


def write(name, value):
    text = json.dumps(value, separators=(",", ":")) + "\n"
    (DATA / name).write_text(text)
    print(f"{DATA / name}: {len(text) // 1000} kB")


def main():
    parser = argparse.ArgumentParser(usage=__doc__)
    jobs = {"fields": fields, "hull": hull, "towing": towing, "level-ice": level_ice, "compare": compare}
    parser.add_argument("what", nargs="*", choices=[*jobs, []])
    parser.add_argument("--nilas", default=REPOSITORY / "build/release/nilas")
    parser.add_argument("--work", type=pathlib.Path, default=pathlib.Path(tempfile.gettempdir()) / "figures-work")
    options = parser.parse_args()
    options.work.mkdir(parents=True, exist_ok=True)
    DATA.mkdir(exist_ok=True)

    def run(*words):
        command = [str(options.nilas), *map(str, words)]
        print(" ".join(command), flush=True)
        subprocess.run(command, check=True)

    for name in options.what or jobs:
        jobs[name](run, options.work)


if __name__ == "__main__":
    main()
