#!/usr/bin/env bash
# Tries packaging/release.sh: on this tree, and on a small one that is made wrong in one place after another.
# usage: release.sh BUILD_FOLDER
set -euo pipefail
build=$(realpath "$1")
source=$(realpath "$(dirname "${BASH_SOURCE[0]}")/../..")
"$source/packaging/release.sh" --check --build "$build"

room=$(mktemp -d)
trap 'rm -rf "$room"' EXIT
export GIT_CONFIG_GLOBAL=/dev/null GIT_CONFIG_SYSTEM=/dev/null GIT_CEILING_DIRECTORIES=$room
export GIT_AUTHOR_NAME=A GIT_AUTHOR_EMAIL=a@example.org GIT_COMMITTER_NAME=A GIT_COMMITTER_EMAIL=a@example.org
unset GIT_DIR GIT_WORK_TREE
mkdir -p "$room/tree/packaging" "$room/tree/docs/howto" "$room/tree/build/release"
cd "$room/tree"
cp "$source/packaging/release.sh" packaging/
echo 'project(nilas VERSION 1.2.3 LANGUAGES CXX)' >CMakeLists.txt
printf 'version: 1.2.3\ndate-released: 2030-02-28\n' >CITATION.cff
echo 'find_package(nilas 1.2 REQUIRED)' >docs/howto/use-the-library.md
printf '#!/bin/sh\necho nilas 1.2.3\necho built with: nothing\n' >build/release/nilas
chmod +x build/release/nilas
cat >CHANGELOG.md <<'TEXT'
# Changelog

## [Unreleased]

## [1.2.3] - 2030-02-28

### Added

- One thing.

## [1.2.2] - 2030-01-31

### Fixed

- Another thing.
TEXT
printf '/build/\n/dist/\n' >.gitignore
git init -q . && git add -A && git commit -q -m first

# Words of the script; then what it must say when it refuses.
must_refuse() {
  local words=$1 message=$2 answer
  if answer=$(packaging/release.sh $words 2>&1); then echo "not refused: $message"; exit 1; fi
  grep -qF -- "$message" <<<"$answer" || { echo "expected '$message', found:"; echo "$answer"; exit 1; }
}
# File, what is wrong in it, words, message; the tree is put right again.
wrong() {
  sed -i "$2" "$1"
  must_refuse "$3" "$4"
  git checkout -q -- .
}
all=format,docs,test,verify,source,deb,wheel,sbom,try,sums
packaging/release.sh --check >/dev/null
wrong CITATION.cff 's/1.2.3/1.2.4/' --check "CITATION.cff: version is '1.2.4'"
wrong docs/howto/use-the-library.md 's/1.2/1.1/' --check "find_package asks for '1.1'"
wrong CHANGELOG.md '/Unreleased/d' --check "## [Unreleased] is missing"
wrong CHANGELOG.md 's/2030-02-28/2030-02-30/' --check "CHANGELOG.md:5: 2030-02-30 is no date"
wrong CHANGELOG.md 's/1.2.2/1.2.9/' --check "CHANGELOG.md:11: 1.2.9 stands below a version that is not newer"
wrong CHANGELOG.md 's/1.2.3/1.3.0/' --check "CHANGELOG.md:5: 1.3.0 is beyond the version 1.2.3"
wrong CHANGELOG.md 's/## \[1.2.2\].*/## 1.2.2 (unreleased)/' --check "CHANGELOG.md:11: found '## 1.2.2 (unreleased)'"
wrong CHANGELOG.md 's/### Fixed/### Mended/' --check "CHANGELOG.md:13: found '### Mended'"
must_refuse "--skip all" "'all' is no step"
must_refuse "--sign" "found '--sign'"
must_refuse "--check --build build/none" "build/none/nilas is missing"
sed -i 's/1.2.3/1.2.2/' build/release/nilas
must_refuse --check "says 'nilas 1.2.2'"
sed -i 's/1.2.2/1.2.3/' build/release/nilas

# What only a release needs.
wrong CHANGELOG.md 's/^- One.*//' "--skip $all" "the tree has changes"
wrong CITATION.cff 's/2030-02-28/2030-02-27/' "--skip $all" "date-released is '2030-02-27', and CHANGELOG.md has 2030-02-28"
wrong CHANGELOG.md 's/## \[Unreleased\]/&\n- A third thing./' "--skip $all" "entries stand under ## [Unreleased]"
wrong CHANGELOG.md '/1.2.3/d' "--skip $all" "the heading ## [1.2.3] - YYYY-MM-DD is missing"

# Archive, sums and tag of a tree that is right.
packaging/release.sh --skip format,docs,test,verify,deb,wheel,sbom,try --tag >"$room/said"
grep -q "Skipped here: format docs test verify deb wheel sbom try" "$room/said"
tar -tzf dist/nilas-1.2.3.tar.gz | grep -x nilas-1.2.3/CHANGELOG.md >/dev/null
(cd dist && sha256sum --quiet -c SHA256SUMS)
git cat-file tag v1.2.3 | grep -x '### Added' >/dev/null
git cat-file tag v1.2.3 | grep -x -- '- One thing.' >/dev/null
if git cat-file tag v1.2.3 | grep 'Another thing'; then echo "the tag tells of an older version"; exit 1; fi
must_refuse "--skip $all" "the tag v1.2.3 exists"
# Between two releases the check passes, and a release is refused.
git tag -d v1.2.3 >/dev/null
sed -i 's/1.2.3/1.2.4/' CMakeLists.txt CITATION.cff build/release/nilas
packaging/release.sh --check >/dev/null
git commit -qam second
must_refuse "--skip $all" "the heading ## [1.2.4] - YYYY-MM-DD is missing"
echo "release.sh does what it says"
