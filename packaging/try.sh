#!/usr/bin/env bash
# Installs Debian packages and wheels on bare Debian 12 systems in folders of their own, runs a tow with each, removes
# them, and tells what is left. Needs root and the package mmdebstrap.
# usage: try.sh [FILE.deb|FILE.whl ...]; without files, build/release/nilas_*.deb and dist/nilas-*.whl
set -euo pipefail
if [ $# -eq 0 ]; then
  cd "$(dirname "${BASH_SOURCE[0]}")/.."
  shopt -s nullglob
  set -- build/release/nilas_*.deb dist/nilas-*.whl
  shopt -u nullglob
fi
[ $# -gt 0 ] || { echo "There is no package and no wheel to try; docs/howto/install.md says how to make them." >&2; exit 1; }
for file in "$@"; do
  [ -f "$file" ] && [[ $file = *.deb || $file = *.whl ]] ||
    { echo "$file: allowed: a file *.deb or *.whl that exists" >&2; exit 2; }
done
[ "$(id -u)" = 0 ] && command -v mmdebstrap >/dev/null ||
  { echo "Bare systems need root and the package mmdebstrap." >&2; exit 1; }
room=$(mktemp -d)
left=0
leave() {
  umount "$room"/*/proc 2>/dev/null || true
  rm -rf --one-file-system "$room"
}
trap leave EXIT
mmdebstrap --variant=apt bookworm "$room/bare" >/dev/null

# $1: name of the system, $2: script that runs in it
within() { chroot "$room/$1" bash -euc "$2"; }
# Files of a system but for what every installation writes.
files() { (cd "$room/$1" && find . -xdev \( -path ./proc -o -path ./var/lib -o -path ./var/cache -o -path ./var/log \) -prune -o -print | sort); }
# What is new and named after Nilas; packages that it needs may stay in a virtual environment.
tell_left() {
  comm -13 "$room/before" "$room/after" | grep -i nilas >"$room/left" || true
  echo "$1 leaves $(wc -l <"$room/left") files"
  if [ -s "$room/left" ]; then cat "$room/left"; left=1; fi
}
tow='nilas --version
nilas run "$scenes/towing.xml" --until 1 --out /tmp/tow --quiet
test -s /tmp/tow/summary.json
nilas verify --case A1 --quiet
rm -rf /tmp/tow'

# $1: name of a new system; its mounts and files of the last trial are gone.
bare_system() {
  umount "$room/$1/proc" 2>/dev/null || true
  rm -rf "${room:?}/$1"
  cp -a "$room/bare" "$room/$1"
  mount -t proc proc "$room/$1/proc"  # the program finds its scenes by its own path
}

try_deb() {
  bare_system deb
  cp "$1" "$room/deb/tmp/nilas.deb"
  within deb 'apt-get update -q >/dev/null'
  files deb >"$room/before"
  within deb 'apt-get install -y -q --no-install-recommends /tmp/nilas.deb >/dev/null; if command -v gcc c++ cc; then exit 1; fi'
  within deb "scenes=/usr/share/nilas/scenes; $tow"
  within deb 'python3 -c "import nilas; print(len(nilas.solvers()), \"solvers in Python\")"'
  within deb 'apt-get purge -y -q nilas >/dev/null; apt-get autoremove --purge -y -q >/dev/null'
  files deb >"$room/after"
  tell_left "$1"
}

try_wheel() {
  bare_system wheel
  # What it needs is downloaded outside, where pip knows the way to its server.
  [ -x "$room/pip/bin/pip" ] || /usr/bin/python3 -m venv "$room/pip"
  "$room/pip/bin/pip" download -q -d "$room/wheel/tmp/wheels" "$1"
  within wheel 'apt-get update -q >/dev/null; apt-get install -y -q --no-install-recommends python3-venv >/dev/null
python3 -m venv /opt/try'
  files wheel >"$room/before"
  within wheel '/opt/try/bin/pip install -q --no-index --find-links /tmp/wheels nilas; if command -v gcc c++ cc; then exit 1; fi'
  within wheel "export PATH=/opt/try/bin:\$PATH; scenes=\$(python3 -c 'import nilas, pathlib; print(pathlib.Path(nilas.__file__).parent / \"share/nilas/scenes\")'); $tow"
  within wheel '/opt/try/bin/python3 -c "import nilas; print(len(nilas.solvers()), \"solvers in Python\")"
/opt/try/bin/pip uninstall -y -q nilas'
  files wheel >"$room/after"
  tell_left "$1"
}

for file in "$@"; do
  case $file in
    *.deb) try_deb "$file" ;;
    *) try_wheel "$file" ;;
  esac
done
exit "$left"
