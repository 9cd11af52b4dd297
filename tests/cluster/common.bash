# What the tests of scripts/cluster have in common; they source it. shellcheck shell=bash
# A campaign of few cases, dealt to many shares, in a temporary folder, and what one run of it counts.

tests=$(dirname "$(realpath "${BASH_SOURCE[0]}")")
# shellcheck disable=SC2034  # the tests use it
cluster=$(realpath "$tests/../../scripts/cluster")

# skip REASON: ctest takes it from this line (tests/CMakeLists.txt).
skip() {
  echo "this test is skipped: $*"
  exit 0
}

# expect_programs PACKAGES PROGRAM...
expect_programs() {
  local program
  for program in "${@:2}"; do
    PATH=$PATH:/usr/sbin:/sbin command -v "$program" >/dev/null ||
      skip "$program is missing; scripts/setup --clusters installs it ($1)"
  done
}

exec 3>&2
fail() {
  echo "FAILED: $*" >&3  # wherever what is asked writes to
  exit 1
}

# expect_one_line STATUS TEXT COMMAND...: ends with that status and one line on stderr that has TEXT.
expect_one_line() {
  local status=0 said
  said=$("${@:3}" 2>&1 >/dev/null </dev/null) || status=$?
  [ "$status" = "$1" ] || fail "status $status, not $1, of ${*:3}: $said"
  [[ $said == *"$2"* ]] || fail "not '$2' but '$said' of ${*:3}"
  [ "$(wc --lines <<<"$said")" = 1 ] || fail "not one line of ${*:3}: $said"
}

# until_true SECONDS COMMAND...: waits for it, so long at most.
until_true() {
  local end=$((SECONDS + $1))
  until "${@:2}"; do
    ((SECONDS < end)) || fail "in $1 s not: ${*:2}"
    sleep 0.2
  done
}

# begin_campaign MANIFUZZ SHARES: a folder that goes at the end, the working folder from now on;
# `end_all`, where a test has one, is called first.
begin_campaign() {
  manifuzz=$(realpath "$1")
  folder=$(mktemp -d)
  trap 'status=$?; trap "" INT TERM; if declare -F end_all >/dev/null; then end_all "$status"; fi; rm -rf "$folder"; exit "$status"' EXIT
  trap 'exit 130' INT
  trap 'exit 143' TERM HUP
  cd "$folder" || exit
  campaign="fuzz --seed 1 --cases 20001 --regime sliver --regime tie_bias --regime boxes --radius 0 --judge-every 7"
  mkdir bin
  stand_in 'exec "$manifuzz" "$@"'
  export PATH=$folder/bin:$PATH MANIFUZZ_SHARES=$2 MANIFUZZ_RESULTS="results here" MANIFUZZ_COMMAND="manifuzz $campaign"
}

# stand_in SCRIPT: what is called as manifuzz from now on. It knows `share`, the number of its own,
# empty in other commands, and `manifuzz`.
stand_in() {
  cat >bin/stand-in <<END
#!/usr/bin/env bash
set -euo pipefail
manifuzz=$manifuzz
folder=$folder
share=
for ((i = 1; i < \$#; ++i)); do
  [ "\${!i}" != --share ] || { i=\$((i + 1)); share=\${!i%/*}; }
done
$1
END
  chmod +x bin/stand-in
  mv bin/stand-in bin/manifuzz
}

# All that must be one run's, bit for bit: all but what clocks decide, and the files, which hold the
# smallest of what all shares have shrunk.
counted() {
  jq --sort-keys 'del(.seconds, .cases_per_second, .unshrunk, .hints) | .buckets |= map(del(.file))' "$1"
}

# The sum is what one run counts, and findings and page are there.
expect_whole() {
  # shellcheck disable=SC2086  # its words
  [ -e one.json ] || "$manifuzz" $campaign --jobs 1 --found one --json one.json --quiet >/dev/null
  [ "$(jq '.buckets | length' one.json)" -ge 3 ] || fail "one run finds next to nothing"
  diff <(counted one.json) <(counted "$MANIFUZZ_RESULTS/merged.json") || fail "the sum is not one run's"
  jq --raw-output '.buckets[] | select(.new) | .file' "$MANIFUZZ_RESULTS/merged.json" >files
  [ -s files ] || fail "nothing new was found"
  while read -r file; do [ -s "$file" ] || fail "$file is not there"; done <files
  grep -q '</html>' "$MANIFUZZ_RESULTS/report.html" || fail "the page is not whole"
}
