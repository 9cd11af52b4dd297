# What the tests of scripts/cluster have in common; they source it. shellcheck shell=bash
# A campaign of few cases, dealt to many shares, in a temporary folder, and what one run of it counts.

tests=$(dirname "$(realpath "${BASH_SOURCE[0]}")")
# shellcheck disable=SC2034  # the tests use it
cluster=$(realpath "$tests/../../scripts/cluster")

# skip REASON: ends with the status that ctest takes for skipped (CMakeLists.txt).
skip() {
  echo "this test is skipped: $*"
  exit 77
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

# begin_hunt: in the campaign's place a hunt of two rounds of three shares. What one machine makes of
# it, one share behind the other, is in the folder in-order.
begin_hunt() {
  local index
  # shellcheck disable=SC2016
  stand_in 'exec "$manifuzz" "$@"'
  export MANIFUZZ_SHARES=3 MANIFUZZ_RESULTS=$folder/hunt
  export MANIFUZZ_COMMAND="manifuzz hunt --subject box2d --seed 1 --cases 1800 --radius 0 --shrink-seconds 1 --rounds 2"
  [ ! -d in-order ] || return 0
  for index in 0 1 2 3 4 5; do expect_done "$cluster/task" "$index"; done
  expect_done "$cluster/finish"
  mv "$MANIFUZZ_RESULTS" in-order
}

# expect_done COMMAND...: what ends so has found something.
expect_done() {
  local status=0
  "$@" >/dev/null 2>said || status=$?
  [ "$status" = 1 ] || fail "status $status, not 1, of $*: $(<said)"
}

# The sum and all archives are those of one machine.
expect_whole_hunt() {
  diff -r in-order/archives "$MANIFUZZ_RESULTS/archives" >&3 || fail "the archives are not one machine's"
  diff <(counted in-order/merged.json) <(counted "$MANIFUZZ_RESULTS/merged.json") || fail "the sum is not one machine's"
  diff -r in-order/merged/worst "$MANIFUZZ_RESULTS/merged/worst" >&3 || fail "the worst cases are not one machine's"
  [ "$(jq '[.cases, .rounds, .shares, (.rows | length), (.buckets | length > 3), .cells > 10000]' "$MANIFUZZ_RESULTS/merged.json" | tr -d ' \n')" = \
    "[1800,2,3,6,true,true]" ] || fail "the sum lacks what hunts have"
  jq --raw-output '(.rows[] | select(.worst > 0) | .file), (.buckets[] | select(.new) | .file)' "$MANIFUZZ_RESULTS/merged.json" >files
  while read -r file; do [ -s "$file" ] || fail "$file is not there"; done <files
  grep -q '</html>' "$MANIFUZZ_RESULTS/report.html" || fail "the page is not whole"
}

# stand_in SCRIPT: what is called as manifuzz from now on. It knows `share`, the number of its own,
# empty in other commands, `round`, of a hunt, and `manifuzz`.
stand_in() {
  cat >bin/stand-in <<END
#!/usr/bin/env bash
set -euo pipefail
manifuzz=$manifuzz
folder=$folder
share=
round=
for ((i = 1; i < \$#; ++i)); do
  case \${!i} in
    --share) i=\$((i + 1)); share=\${!i%/*} ;;
    --round) i=\$((i + 1)); round=\${!i} ;;
  esac
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
