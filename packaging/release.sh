#!/usr/bin/env bash
# Makes the files of a release in dist/, as docs/develop/release.md lists them. `packaging/release.sh --help` says how.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

usage() {
  cat <<'TEXT'
usage: packaging/release.sh [--check] [--skip STEP[,STEP...]] [--build DIR] [--tag]

Checks that the tree is that of one version, then makes the files of its release in dist/:

  format   ./dev format --check
  docs     ./dev docs, and an archive of the site
  test     ./dev test
  verify   nilas verify
  source   an archive of the sources
  deb      the Debian package
  wheel    the wheel with its libraries
  sbom     the bill of materials: what the program was built from
  try      both packages on bare systems (packaging/try.sh; needs root)
  sums     SHA256SUMS of the files above

  --check       only checks that the files that name the version agree; the tree may be between two releases
  --skip STEPS  leaves out steps, for example because they were done on this commit
  --build DIR   the build tree, build/release by default; --check also does without one
  --tag         makes the annotated tag at the end, with the changelog of the version as its message; signs it where
                git knows a key

Exit codes: 0 done, 1 a check or a step failed, 2 wrong usage.
TEXT
}

steps=(format docs test verify source deb wheel sbom try sums)
only_check=0 tag=0 skipped=, build=build/release must_be_built=1 faults=0
while [ $# -gt 0 ]; do
  case $1 in
    --check) only_check=1 must_be_built=0 ;;
    --tag) tag=1 ;;
    --skip | --build)
      [ $# -gt 1 ] || { echo "error: $1 needs a value" >&2; exit 2; }
      if [ "$1" = --skip ]; then skipped+="$2,"; else named=$2; fi
      shift ;;
    -h | --help) usage; exit 0 ;;
    *) echo "error: found '$1'; packaging/release.sh --help lists what is allowed" >&2; exit 2 ;;
  esac
  shift
done
if [ -n "${named:-}" ]; then build=$named must_be_built=1; fi
for name in ${skipped//,/ }; do
  [[ " ${steps[*]} " = *" $name "* ]] || { echo "error: --skip: '$name' is no step; allowed: ${steps[*]}" >&2; exit 2; }
done

fault() { echo "$1" >&2; faults=$((faults + 1)); }
# Numbers of a version, one after another, as a number that can be compared.
ordered() { local a b c; IFS=. read -r a b c <<<"$1"; echo $((10#$a * 1000000 + 10#$b * 1000 + 10#$c)); }
# The changelog between a heading of a version and the next one.
section() {
  awk -v head="## [$1]" 'index($0, "## [") == 1 {inside = index($0, head) == 1; next} inside' CHANGELOG.md |
    sed '/./,$!d'
}

version=$(sed -n 's/^project(nilas VERSION \([0-9]*\.[0-9]*\.[0-9]*\)[ )].*/\1/p' CMakeLists.txt)
[ -n "$version" ] || { echo "CMakeLists.txt: project(nilas VERSION X.Y.Z) is missing" >&2; exit 1; }
date=

check_versions() {
  local cited found told
  cited=$(sed -n 's/^version: *"\{0,1\}\([^"]*\)"\{0,1\}$/\1/p' CITATION.cff)
  [ "$cited" = "$version" ] || fault "CITATION.cff: version is '$cited', and CMakeLists.txt has $version"
  found=$(sed -n 's/^find_package(nilas \([0-9.]*\) .*/\1/p' docs/howto/use-the-library.md)
  [ "$found" = "${version%.*}" ] ||
    fault "docs/howto/use-the-library.md: find_package asks for '$found', and version $version needs ${version%.*}"
  if [ -x "$build/nilas" ]; then
    told=$("$build/nilas" --version)
    told=${told%%$'\n'*}
    [ "$told" = "nilas $version" ] || fault "$build/nilas says '$told', and CMakeLists.txt has $version; build it again"
  elif [ "$must_be_built" = 1 ]; then
    fault "$build/nilas is missing; ./dev build makes it"
  fi
}

# Each heading of a version is "## [X.Y.Z] - YYYY-MM-DD", newest first, and none is beyond the version of the tree.
check_changelog() {
  local last=$((1 << 60)) line number name day order
  grep -qx '## \[Unreleased\]' CHANGELOG.md || fault "CHANGELOG.md: the heading ## [Unreleased] is missing"
  while IFS=: read -r number line; do
    [ "$line" = "## [Unreleased]" ] && continue
    if ! [[ $line =~ ^"## ["([0-9]+\.[0-9]+\.[0-9]+)"] - "([0-9]{4}-[0-9]{2}-[0-9]{2})$ ]]; then
      fault "CHANGELOG.md:$number: found '$line'; allowed: ## [X.Y.Z] - YYYY-MM-DD"
      continue
    fi
    name=${BASH_REMATCH[1]} day=${BASH_REMATCH[2]}
    date -d "$day" >/dev/null 2>&1 || fault "CHANGELOG.md:$number: $day is no date"
    order=$(ordered "$name")
    [ "$order" -lt "$last" ] || fault "CHANGELOG.md:$number: $name stands below a version that is not newer"
    [ "$order" -le "$(ordered "$version")" ] ||
      fault "CHANGELOG.md:$number: $name is beyond the version $version of CMakeLists.txt"
    last=$order
    if [ "$name" = "$version" ]; then date=$day; fi
  done < <(grep -n '^## ' CHANGELOG.md)
  while IFS=: read -r number line; do
    case ${line#\#\#\# } in
      Added | Changed | Deprecated | Removed | Fixed | Security) ;;
      *) fault "CHANGELOG.md:$number: found '$line'; allowed: Added, Changed, Deprecated, Removed, Fixed, Security" ;;
    esac
  done < <(grep -n '^### ' CHANGELOG.md)
}

# What holds on the day of a release alone.
check_release() {
  local cited
  [ -z "$(git status --porcelain)" ] || fault "the tree has changes; commit them first: git status"
  ! git rev-parse -q --verify "refs/tags/v$version" >/dev/null || fault "the tag v$version exists; a tag is never moved"
  [ -z "$(section Unreleased | tr -d '[:space:]')" ] ||
    fault "CHANGELOG.md: entries stand under ## [Unreleased]; move them to ## [$version]"
  if [ -z "$date" ]; then
    fault "CHANGELOG.md: the heading ## [$version] - YYYY-MM-DD is missing"
  else
    cited=$(sed -n 's/^date-released: *"\{0,1\}\([0-9-]*\)"\{0,1\}$/\1/p' CITATION.cff)
    [ "$cited" = "$date" ] || fault "CITATION.cff: date-released is '$cited', and CHANGELOG.md has $date"
    [ -n "$(section "$version" | tr -d '[:space:]')" ] || fault "CHANGELOG.md: nothing stands under ## [$version]"
  fi
}

check_versions
check_changelog
[ "$only_check" = 1 ] || check_release
[ "$faults" = 0 ] || { echo "$faults fault(s)" >&2; exit 1; }
echo "The files agree on version $version${date:+ of $date}."
[ "$only_check" = 0 ] || exit 0

archive=dist/nilas-$version.tar.gz site=dist/nilas-$version-site.tar.gz
package() { find dist -maxdepth 1 -name "nilas_${version}_*.deb"; }
wheel() { find dist -maxdepth 1 -name "nilas-$version-*.whl"; }

step_format() { ./dev format --check; }
step_docs() { ./dev docs && tar -C build/site --transform "s,^\.,nilas-$version-site," -czf "$site" .; }
step_test() { ./dev test; }
step_verify() { "$build/nilas" verify --quiet; }
step_source() { git archive --prefix="nilas-$version/" -o "$archive" HEAD; }
step_deb() {
  rm -f "$build"/nilas_*.deb dist/"nilas_${version}"_*.deb
  cmake --build "$build" && (cd "$build" && cpack -G DEB) && cp "$build"/nilas_"$version"_*.deb dist/
}
step_wheel() { rm -f dist/"nilas-$version"-*.whl && packaging/wheel.sh; }
step_sbom() { packaging/sbom.py "$build" --out "dist/nilas-$version.cdx.json"; }
step_try() {
  local files
  mapfile -t files < <(package; wheel)
  [ ${#files[@]} -gt 0 ] || { echo "dist/ has no package of version $version to try" >&2; return 1; }
  packaging/try.sh "${files[@]}"
}
step_sums() {
  local files
  mapfile -t files < <(find dist -maxdepth 1 -type f -name "nilas[-_]$version[-_.]*" -printf '%f\n' | sort)
  [ ${#files[@]} -gt 0 ] || { echo "dist/ has no file of version $version" >&2; return 1; }
  (cd dist && sha256sum "${files[@]}" | tee SHA256SUMS)
}

mkdir -p dist
for step in "${steps[@]}"; do
  if [[ $skipped = *,$step,* ]]; then echo "== $step: skipped"; continue; fi
  echo "== $step"
  "step_$step" || { echo "The step $step failed. Mend it, commit, and begin again." >&2; exit 1; }
done

if [ "$tag" = 1 ]; then
  # The headings of its lists start with a hash, which git would take for comments.
  sign=-a; [ -z "$(git config user.signingkey)" ] || sign=-s
  { echo "Nilas $version"; echo; section "$version"; } | git tag "$sign" --cleanup=whitespace -F - "v$version"
  echo "The tag v$version is made here, and not pushed."
fi

push="Push the commit, then the tag v$version."
[ "$tag" = 1 ] || push="Tag: packaging/release.sh --tag with the steps above under --skip. Then push commit and tag."
cat <<TEXT

Left to you, from docs/develop/release.md:
- asan, tidy and golden: ./dev asan, ./dev tidy LAST_TAG, ./dev golden debug.
- Scenes: run every scene of apps/scenes to its end, and read the warnings of its summary.
- Old runs: report a run folder of the last release, and run its scene.xml again.
- Figures: measure again what changed, draw again what is drawn from it, and check the figures of README.md.
- Sources: unpack $archive outside any git repository, build it, and run its tests.
- Read the first page, the tutorial and the changelog in build/site.
- $push
- Publish the files of dist/ that SHA256SUMS names, and SHA256SUMS. The release notes are the changelog.
- Install from what was published on another machine. Then raise the version in CMakeLists.txt and CITATION.cff.
TEXT
[ "$skipped" = , ] || echo "Skipped here: $(echo "${skipped//,/ }" | xargs). They must have passed on this commit."
