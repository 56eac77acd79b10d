#!/usr/bin/env bash
# Installs a build into a folder, and builds a program of another project against it by find_package(nilas).
# usage: consumer.sh BUILD_FOLDER
set -euo pipefail
build=$(realpath "$1")
source=$(realpath "$(dirname "${BASH_SOURCE[0]}")/../..")
room=$(mktemp -d)
trap 'rm -rf "$room"' EXIT
cmake --install "$build" --prefix "$room/installed" >"$room/install.log" || { cat "$room/install.log"; exit 1; }
mkdir "$room/consumer"
cat >"$room/consumer/CMakeLists.txt" <<'TEXT'
cmake_minimum_required(VERSION 3.25)
project(consumer LANGUAGES CXX)
add_executable(my_program main.cpp solve_example.cpp simulation_example.cpp)
TEXT
# The two lines that the page tells.
sed -n '/^```cmake/,/^```/p' "$source/docs/howto/use-the-library.md" | grep -v '^```' >>"$room/consumer/CMakeLists.txt"
cp "$source"/tests/nilas/*_example.cpp "$room/consumer"
cat >"$room/consumer/main.cpp" <<'TEXT'
#include <nilas/schema.h>
#include <nilas/solve.h>

#include <iostream>

int solve_a_stack();
double hold_a_floe();
int main() {
  std::cout << "library " << nilas::version() << ", " << nilas::scene_schema().size() << " elements\n";
  hold_a_floe();
  return solve_a_stack();
}
TEXT
cmake -S "$room/consumer" -B "$room/consumer/build" -DCMAKE_PREFIX_PATH="$room/installed" >/dev/null
cmake --build "$room/consumer/build" >/dev/null
"$room/consumer/build/my_program"
# What was installed runs from there: program, scenes, Python package, manual page and completion.
"$room/installed/bin/nilas" verify --case A1 --quiet
zcat "$room/installed/share/man/man1/nilas.1.gz" | grep "nilas run" >/dev/null
bash -n "$room/installed/share/bash-completion/completions/nilas"
if [ -d "$room/installed/lib/python3/dist-packages/nilas" ]; then
  PYTHONPATH=$room/installed/lib/python3/dist-packages /usr/bin/python3 -c '
import nilas
print(len(nilas.solvers()), "solvers in Python")'
  # It finds the installed package, and the package finds the program.
  "$room/installed/bin/nilas" study "$source/examples/studies/concentration-speed.yaml" --out "$room/study" \
    --dry-run >"$room/plan" || { cat "$room/plan"; exit 1; }
  grep -q " runs" "$room/plan"
fi
