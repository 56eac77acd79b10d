#!/usr/bin/env python3
"""Lists what a build of the program is made of: a bill of materials as CycloneDX 1.5 in JSON.

usage: sbom.py [BUILD] [--out FILE]

BUILD is the build tree, build/release by default. A component is
 - a Debian package whose shared library the program loads (scope `required`),
 - a Debian package whose headers were compiled into it (scope `optional`: nothing of it is needed to run),
 - a package of npm that is bundled into the pages.
Version and licence of a Debian package are those of the machine that built it. Exit codes: 0 done, 2 BUILD holds no
finished build, or a tool of Debian is missing.
"""
import argparse
import json
import pathlib
import re
import shutil
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
SYSTEM = "/usr/"
LONGEST_NAME = 60  # a longer one is the text of a licence


def output_of(*command):
    return subprocess.run(command, capture_output=True, text=True, check=False).stdout


def libraries_of(program):
    """Paths of the shared libraries that the program loads."""
    return {match[1] for match in re.finditer(r"=> (/\S+)", output_of("ldd", str(program)))}


def headers_of(build):
    """Paths of the system's headers that any source of the program includes; those of tests and benches do not count."""
    headers, counts = set(), False
    for line in output_of("ninja", "-C", str(build), "-t", "deps").splitlines():
        if line and not line.startswith(" "):
            counts = not line.startswith("tests/")
        elif counts and line.strip().startswith(SYSTEM):
            headers.add(line.strip())
    return headers


def packages_of(paths):
    """Names of the Debian packages that own the paths, which may be links."""
    names = set()
    known = {str(form) for path in paths for form in (pathlib.Path(path), pathlib.Path(path).resolve())}
    known |= {path.removeprefix("/usr") for path in known if path.startswith("/usr/lib")}
    asked = sorted(known)
    for first in range(0, len(asked), 500):
        for line in output_of("dpkg", "-S", *asked[first : first + 500]).splitlines():
            owners, _, path = line.partition(": ")
            if path in known and not owners.startswith("diversion"):
                names |= {owner.split(":")[0] for owner in owners.split(", ")}
    return names


def licences_of(package):
    """Short names of the licences in the package's copyright file, those of its first files first; else where to read."""
    file = pathlib.Path(f"/usr/share/doc/{package}/copyright")
    text = file.read_text(encoding="utf-8", errors="replace") if file.exists() else ""
    names = [name for name in re.findall(r"^License: *(\S.*)$", text, re.MULTILINE) if len(name) <= LONGEST_NAME]
    return list(dict.fromkeys(names)) or [f"see {file}"]


def debian_component(package, scope):
    form = "${Version}|${Architecture}|${source:Package}"
    version, architecture, source = output_of("dpkg-query", "-W", f"-f={form}", package).split("|")[:3]
    return {
        "type": "library",
        "bom-ref": f"deb/{package}",
        "name": package,
        "version": version,
        "scope": scope,
        "licenses": [{"license": {"name": name}} for name in licences_of(package)],
        "purl": f"pkg:deb/debian/{package}@{version}?arch={architecture}",
        "properties": [{"name": "debian:source", "value": source}],
    }


def npm_components():
    """The packages that the bundler puts into the pages; the bundler itself is a tool of the build."""
    page = ROOT / "apps/view/page"
    wanted = json.loads((page / "package.json").read_text(encoding="utf-8"))["dependencies"]
    locked = json.loads((page / "package-lock.json").read_text(encoding="utf-8"))["packages"]
    for name in sorted(set(wanted) - {"esbuild"}):
        found = locked[f"node_modules/{name}"]
        yield {
            "type": "library",
            "bom-ref": f"npm/{name}",
            "name": name,
            "version": found["version"],
            "scope": "required",
            "licenses": [{"license": {"name": found.get("license", "see apps/view/page/LICENSES.txt")}}],
            "purl": f"pkg:npm/{name}@{found['version']}",
        }


def bill_of(build):
    program = build / "nilas"
    version = output_of(str(program), "--version").split()[1]
    loaded = packages_of(libraries_of(program))
    included = packages_of(headers_of(build)) - loaded
    components = [debian_component(package, "required") for package in sorted(loaded)]
    components += [debian_component(package, "optional") for package in sorted(included)]
    components += npm_components()
    return {
        "bomFormat": "CycloneDX",
        "specVersion": "1.5",
        "version": 1,
        "metadata": {
            "component": {
                "type": "application",
                "bom-ref": "nilas",
                "name": "nilas",
                "version": version,
                "licenses": [{"license": {"id": "GPL-3.0-or-later"}}],
            }
        },
        "components": components,
        "dependencies": [{"ref": "nilas", "dependsOn": [one["bom-ref"] for one in components]}],
    }


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("build", nargs="?", type=pathlib.Path, default=ROOT / "build/release")
    parser.add_argument("--out", type=pathlib.Path, help="writes here instead of to standard output")
    given = parser.parse_args()
    missing = [tool for tool in ("dpkg-query", "ldd", "ninja") if shutil.which(tool) is None]
    if missing:
        print(f"error: found no {', '.join(missing)}; the list is made of Debian's packages", file=sys.stderr)
        return 2
    if not (given.build / "nilas").exists() or not (given.build / ".ninja_deps").exists():
        print(f"error: {given.build} holds no finished build; ./dev build makes one", file=sys.stderr)
        return 2
    text = json.dumps(bill_of(given.build), indent=1) + "\n"
    if given.out is None:
        print(text, end="")
    else:
        given.out.write_text(text, encoding="utf-8")
    return 0


if __name__ == "__main__":
    sys.exit(main())
