# A record of record.jq as a row of the table of scripts/engines; $whole has the verdicts besides.

def short:
  if . == 0 then "0"
  else . as $x | ($x * 1.0000001 | log10 | floor) as $e | (($x / pow(10; $e) * 10 | round) / 10) as $m
    | if $m == 10 then "1e\($e + 1)" else "\($m)e\($e)" end
  end;

"| `\(.collider)` | \(.version) | \(.description) | \(.claims) "
+ "| \(if .wrong == {} then "0" else .wrong | to_entries | map("\(.key) \(.value)") | join(", ") end) "
+ "| \(.worst_depth_error | short) | \(if .claims == "a clip" then .worst_position_error | short else "-" end) "
+ "| \(if .ns then .ns | round else "-" end) |"
+ (if $whole then " \(.agree) | \(.tie) | \(.explained) | \(.unexplained) | \(.ill_posed) | \(.unsupported) |" else "" end)
