# What was wrong with an oracle in the JSON of a fuzz, and how often: causes by their ids in the ledger,
# and of answers that no cause explains, "unexplained" and their kinds.

(.ledger | map(select(.hits > 0) | {key: .id, value: .hits}))
+ ([.buckets[] | select(.verdict | IN("oracle_wrong", "both_wrong"))
     | {key: "unexplained: \(.bucket | split("/")[2] | gsub("_"; " "))", value: .count}]
   | group_by(.key) | map({key: .[0].key, value: (map(.value) | add)}))
+ (.verdicts | [{crashed, "timed out": .timed_out, malformed} | to_entries[]
     | select(.value > 0) | {key: "unexplained: \(.key)", value}])
| from_entries
