# Engines with what is known of their releases, oldest first, as the file of a history: each release
# that was asked has `kind_changes` and `changes`, its kinds of wrong answers and its faults against
# those of the release asked before it.

def changes($before; $now):
  [($before + $now | keys_unsorted[]) as $fault | ($before[$fault] // 0) as $was | ($now[$fault] // 0) as $is
    | select($was != $is)
    | ($fault != "unexplained") as $is_told  # what is explained since, or no more, neither went nor came
    | {fault: $fault, change: (if $is_told and $was == 0 then "came" elif $is_told and $is == 0 then "went" elif $is > $was then "more" else "fewer" end),
       before: $was, now: $is}]
  | sort_by({came: 0, went: 1, more: 2, fewer: 3}[.change], -(.now - .before | fabs));

def with_changes:
  reduce .[] as $release ({before: null, releases: []};
    if $release.reason then .releases += [$release]
    else .before as $before
      | .releases += [$release + if $before then {since: $before.version,
          kind_changes: changes($before.wrong; $release.wrong), changes: changes($before.faults; $release.faults)} else {} end]
      | .before = $release
    end)
  | .releases;

{format: "manifuzz/history/1", subject: "clip64", cases: $cases, seed: $seed,
 engines: map(.releases |= with_changes)}
