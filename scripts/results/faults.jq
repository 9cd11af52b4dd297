# What was wrong with an oracle in the JSON of a fuzz, and how often: causes by their ids in the ledger,
# and "unexplained", for answers that no cause of it explains.

(.ledger | map(select(.hits > 0) | {key: .id, value: .hits})) + [{key: "unexplained", value: .unexplained} | select(.value > 0)]
| from_entries
