# What a fuzz of clip64 against an oracle counts of it, in the words of results.json. $collider,
# $engine and $description are given, and $times, which holds the JSON of `bench` or null.
# The table of scripts/engines, results.json, badges and the history are all made of this.

def claim:
  map(capture("^\($collider) (?<what>claims no points|claims one point|does not clip)").what) | first
  | {"claims no points": "a translation", "claims one point": "one point", "does not clip": "points"}[. // ""] // "a clip";

def in_a_million($cases): . * 1000000 / $cases | . * 100 | round | . / 100;

. as $report
| [.buckets[] | select(.verdict | IN("known", "oracle_wrong", "both_wrong"))
    | {kind: (.bucket | split("/")[2] | gsub("_"; " ")), count}] as $found
| ([$found[] | select(.kind == "none") | .count] + [.verdicts | .crashed, .timed_out, .malformed] | add) as $lost
| ($found | map(select(.kind != "none")) | group_by(.kind)
    | map({key: .[0].kind, value: (map(.count) | add)}) | sort_by(-.value)
    + [{key: "lost", value: $lost} | select(.value > 0)] | from_entries) as $wrong
| ($times[0].rows // []
    | map(select(.collider == $collider and .query == "manifold" and .input == "pair")) | first) as $time
| {collider: $collider, engine: $engine, version: .versions[$collider], description: $description,
   claims: (.allowances // [] | claim), cases, wrong: $wrong, explained: .verdicts.known, unexplained,
   wrong_in_a_million: ($wrong | map_values(in_a_million($report.cases))),
   explained_in_a_million: (.verdicts.known | in_a_million($report.cases)),
   unexplained_in_a_million: (.unexplained | in_a_million($report.cases)),
   agree: .verdicts.agree, tie: .verdicts.tie, ill_posed: .verdicts.ill_posed, unsupported: .verdicts.unsupported,
   worst_depth_error: .worst_error.oracle.depth, worst_position_error: .worst_error.oracle.position,
   ns: (if $time then $time.ns_without_interface // $time.ns_per_pair else null end)}
