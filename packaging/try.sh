#!/usr/bin/env bash
# Installs build/release/nilas_*.deb and dist/nilas-*.whl on bare Debian 12 systems in folders of their own, runs a tow with
# each, removes them, and tells what is left. Needs root and the package mmdebstrap.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
room=$(mktemp -d)
left=0
trap 'rm -rf "$room"' EXIT
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

for package in build/release/nilas_*.deb; do
  rm -rf "$room/deb"
  cp -a "$room/bare" "$room/deb"
  cp "$package" "$room/deb/tmp/nilas.deb"
  within deb 'apt-get update -q >/dev/null'
  files deb >"$room/before"
  within deb 'apt-get install -y -q --no-install-recommends /tmp/nilas.deb >/dev/null; ! command -v gcc c++ cc'
  within deb "scenes=/usr/share/nilas/scenes; $tow"
  within deb 'python3 -c "import nilas; print(len(nilas.solvers()), \"solvers in Python\")"'
  within deb 'apt-get purge -y -q nilas >/dev/null; apt-get autoremove --purge -y -q >/dev/null'
  files deb >"$room/after"
  tell_left "$package"
done

for wheel in dist/nilas-*.whl; do
  rm -rf "$room/wheel"
  cp -a "$room/bare" "$room/wheel"
  cp "$wheel" "$room/wheel/tmp/"
  cp /etc/resolv.conf "$room/wheel/etc/"
  within wheel 'apt-get update -q >/dev/null; apt-get install -y -q --no-install-recommends python3-venv >/dev/null
python3 -m venv /opt/try'
  files wheel >"$room/before"
  within wheel '/opt/try/bin/pip install -q /tmp/nilas-*.whl; ! command -v gcc c++ cc'
  within wheel "export PATH=/opt/try/bin:\$PATH; scenes=\$(python3 -c 'import nilas, pathlib; print(pathlib.Path(nilas.__file__).parent / \"share/nilas/scenes\")'); $tow"
  within wheel '/opt/try/bin/python3 -c "import nilas; print(len(nilas.solvers()), \"solvers in Python\")"
/opt/try/bin/pip uninstall -y -q nilas'
  files wheel >"$room/after"
  tell_left "$wheel"
done
exit "$left"
