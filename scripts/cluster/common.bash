# What the scripts of this folder have in common; they source it. shellcheck shell=bash
# A campaign is told by three variables:
#   MANIFUZZ_SHARES    how many shares its cases are dealt to
#   MANIFUZZ_COMMAND   what runs all of them, as `manifuzz fuzz --seed 1 --cases 1000000`, or
#                      `manifuzz hunt --seed 1 --cases 1000000 --rounds 4`; words with blanks stand in
#                      quotes, and nothing in it is expanded
#   MANIFUZZ_RESULTS   the folder of the results, which every machine sees under this name

# By the names that whoever calls uses: other machines may not have what links lead to here.
cluster=$(dirname "$(realpath -s -- "$0")")
[ -e "$cluster/common.bash" ] || cluster=$(dirname "$(realpath "${BASH_SOURCE[0]}")")
me=scripts/cluster/${0##*/}

complain() {
  echo "$me: $*" >&2
  exit 2
}

# print_help: the first comment of the script.
print_help() {
  "$cluster/../print_help" "$0"
}

# Options that each task is given; several tasks must not write to one file.
readonly of_tasks=(--share --round --archives --json --found --report --junit)

# Checks the three variables; sets shares, results and archives (absolute), program, kind (fuzz or
# hunt), rounds, options (what stands behind the kind, without --rounds) and tasks, the number of all:
# the tasks of a round are its shares, and those of the next one follow them.
read_campaign() {
  local name
  [[ ${MANIFUZZ_SHARES:-} =~ ^[1-9][0-9]{0,8}$ ]] ||
    complain "MANIFUZZ_SHARES is '${MANIFUZZ_SHARES:-}'; a whole number from 1 on is expected"
  [ -n "${MANIFUZZ_RESULTS:-}" ] ||
    complain "MANIFUZZ_RESULTS is not set; the folder for the results is expected"
  shares=$MANIFUZZ_SHARES
  results=$(realpath -m -s -- "$MANIFUZZ_RESULTS")
  [ ! -e "$results" ] || [ -d "$results" ] ||
    complain "MANIFUZZ_RESULTS: $results is a file; a folder is expected"
  read_command
  for name in "${of_tasks[@]}"; do
    ! has_option "$name" ||
      complain "MANIFUZZ_COMMAND has '$name', which each task is given; leave it out"
  done
  archives=$results/archives
  rounds=1
  [ "$kind" != hunt ] || take_rounds
  tasks=$((shares * rounds))
}

# Takes --rounds out of a hunt's options.
take_rounds() {
  local i kept=()
  for ((i = 0; i < ${#options[@]}; ++i)); do
    case ${options[i]} in
      --rounds) i=$((i + 1)) && rounds=${options[i]:-} ;;
      --rounds=*) rounds=${options[i]#*=} ;;
      *) kept+=("${options[i]}") ;;
    esac
  done
  [[ $rounds =~ ^[1-9][0-9]{0,5}$ ]] ||
    complain "MANIFUZZ_COMMAND: --rounds is '$rounds'; a whole number from 1 to 999999 is expected"
  options=("${kept[@]}")
}

has_option() {
  local word
  for word in "${options[@]}"; do
    [[ $word != "$1" && $word != "$1="* ]] || return 0
  done
  return 1
}

read_command() {
  local words i
  [ -n "${MANIFUZZ_COMMAND:-}" ] ||
    complain "MANIFUZZ_COMMAND is not set; such as 'manifuzz fuzz --seed 1 --cases 1000000' is expected"
  [[ $MANIFUZZ_COMMAND != *$'\n'* ]] || complain "MANIFUZZ_COMMAND has several lines; one is expected"
  words=()
  mapfile -d '' -t words < <(xargs -n 1 printf '%s\0' <<<"$MANIFUZZ_COMMAND" 2>/dev/null)
  wait "$!" || complain "MANIFUZZ_COMMAND has a quote without its end: $MANIFUZZ_COMMAND"
  for ((i = 0; i < ${#words[@]}; ++i)); do
    [[ ${words[i]} != fuzz && ${words[i]} != hunt ]] || break
  done
  ((i > 0 && i < ${#words[@]})) ||
    complain "MANIFUZZ_COMMAND is '$MANIFUZZ_COMMAND'; 'manifuzz fuzz', or such, and options are expected"
  kind=${words[i]}
  program=("${words[@]:0:i}")
  options=("${words[@]:i+1}")
}

# The program must be there where it is to run.
expect_program() {
  command -v -- "${program[0]}" >/dev/null ||
    complain "MANIFUZZ_COMMAND: there is no program '${program[0]}' in $PWD or PATH"
}

# Makes the folder of the results, and writes down in it whose they are: another campaign's shares
# are never added to this one's.
own_results() {
  local campaign=$results/campaign mine why
  why=$(mkdir -p -- "$results" 2>&1) || complain "MANIFUZZ_RESULTS: $results cannot be made: ${why##*: }"
  if ! [ -s "$campaign" ]; then
    mine=$(new_in_results campaign.)
    why=$({ campaign_in_words >"$mine" && chmod a+r "$mine" && mv -T -- "$mine" "$campaign"; } 2>&1) || {
      rm -f -- "$mine"
      complain "$campaign cannot be written: ${why##*: }"
    }
  fi
  [ "$(<"$campaign")" = "$(campaign_in_words)" ] ||
    complain "$results holds shares of another campaign, named in $campaign; another MANIFUZZ_RESULTS is expected"
}

# new_in_results NAME [--directory]: a new hidden file, whose name begins so.
new_in_results() {
  local made
  if ! made=$(mktemp "${@:2}" "$results/.$1XXXXXX" 2>&1); then
    complain "MANIFUZZ_RESULTS: $results cannot be written to: ${made##*: }"
  fi
  echo "$made"
}

campaign_in_words() {
  printf '%s shares of %s\n' "$shares" "$MANIFUZZ_COMMAND"
}

# The archive that a task of a hunt writes.
archive_of() {
  echo "$archives/round-$(($1 / shares))-share-$(($1 % shares)).archive"
}

# Whether a task has a result, and its archive where it has one.
is_done() {
  [ -d "$results/share-$1" ] && { [ "$kind" != hunt ] || [ -e "$(archive_of "$1")" ]; }
}

# The first round that is not done, or nothing.
open_round() {
  local round
  for ((round = 0; round < rounds; ++round)); do
    if [ -n "$(missing_tasks "$round")" ]; then
      echo "$round"
      break
    fi
  done
}

# missing_tasks ROUND|all: the tasks that are not done, of that round or of all, a line each.
missing_tasks() {
  local begin=0 end=$tasks
  if [ "$1" != all ]; then
    begin=$(($1 * shares))
    end=$((begin + shares))
  fi
  {
    [ ! -d "$results" ] || (cd -- "$results" && shopt -s nullglob && printf '%s\n' share-*)
    [ ! -d "$archives" ] || (cd -- "$archives" && shopt -s nullglob && printf '%s\n' round-*)
  } |
    awk -v begin="$begin" -v end="$end" -v shares="$shares" -v kind="$kind" '
      { there[$0] }
      END {
        for (i = begin; i < end; ++i) {
          archive = "round-" int(i / shares) "-share-" i % shares ".archive"
          if (!("share-" i in there) || (kind == "hunt" && !(archive in there))) print i
        }
      }'
}
