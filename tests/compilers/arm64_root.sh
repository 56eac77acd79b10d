#!/usr/bin/env bash
# Loads Debian's arm64 libraries that the program is built with into a folder, without installing anything.
# usage: arm64_root.sh FOLDER
set -euo pipefail
root=$(realpath -m "$1")
work=$root.apt
libraries=$root/usr/lib/aarch64-linux-gnu
mkdir -p "$root" "$work"/state/lists/partial "$work"/cache/archives/partial
: >"$work/state/status"
options=(-o APT::Architecture=arm64 -o APT::Architectures::=arm64 -o Dir::State="$work/state"
         -o Dir::State::status="$work/state/status" -o Dir::Cache="$work/cache" -o APT::Install-Recommends=false
         -o Debug::NoLocking=true)
apt-get "${options[@]}" update -q
apt-get "${options[@]}" install -y -q --download-only libc6-dev libstdc++-12-dev libeigen3-dev libsimbody-dev libfcl-dev \
  libccd-dev libcgal-dev libtinyxml2-dev nlohmann-json3-dev libcli11-dev libspdlog-dev libfmt-dev libssl-dev libhdf5-dev \
  zlib1g-dev libboost-dev libsundials-dev libalglib-dev libcpp-httplib-dev
for package in "$work"/cache/archives/*.deb; do dpkg-deb -x "$package" "$root"; done
# Links to absolute places would lead out of the folder.
find "$root" -type l -lname '/*' -print0 | while IFS= read -r -d '' link; do
  ln -sfn "$(realpath -ms --relative-to="$(dirname "$link")" "$root$(readlink "$link")")" "$link"
done
# What the packages' own scripts would set up.
for name in blas lapack; do
  ln -sf "$name/lib$name.so.3" "$libraries/lib$name.so.3"
  ln -sf "$name/lib$name.so" "$libraries/lib$name.so"
done
# These name libraries by absolute places.
sed -i "s#\([\";]\)/usr/lib/aarch64-linux-gnu#\1$libraries#g" \
  "$libraries/cmake/simbody/SimbodyTargets-none.cmake" "$libraries/ccd/ccd-targets-none.cmake"
touch "$root/complete"
