# The file of a history as a page that needs nothing else: of each collider what came and went, and a
# table of its faults over its releases. $style is the page's style.

def html: tostring | @html;
def in_a_million($cases): . * 1000000 / $cases | . * 10 | round | . / 10;
def times: if . == 1 then "once" else "\(.) times" end;

# A cause without the collider's name, which the heading has.
def short($collider): ltrimstr("\($collider)-");

def change_in_words($collider):
  "<li class=\"\(.change)\"><b>\(.change)</b> <span>\(.fault | short($collider) | html)</span> <small>\(
    if .change == "came" then .now | times elif .change == "went" then "\(.before | times) before" else "\(.before) → \(.now)" end)</small></li>";

def release_in_words($collider):
  if .reason then "<dt>\(.version | html)</dt><dd class=\"none\">not asked: \(.reason | html)</dd>"
  elif .changes == null then empty
  elif .changes == [] then "<dt>\(.version | html)</dt><dd class=\"none\">answers as \(.since | html) does, fault by fault</dd>"
  else "<dt>\(.version | html)</dt><dd><ul>\(.changes | map(change_in_words($collider)) | join(""))</ul></dd>" end;

def cell($fault):
  (.faults[$fault] // 0) as $count
  | ((.changes // []) | map(select(.fault == $fault)) | first) as $change
  | "<td class=\"\(if $change then $change.change elif $count == 0 then "none" else "same" end)\">"
    + (if $count == 0 then "–" else $count | tostring end)
    + (if $change then " <small>\({came: "came", went: "went", more: "+\($change.now - $change.before)",
        fewer: "−\($change.before - $change.now)"}[$change.change])</small>" else "" end) + "</td>";

def table:
  . as $of | [.releases[] | select(.reason | not)] as $asked
  | ([$asked[] | .faults // {} | keys_unsorted[]] | reduce .[] as $one ([]; if index($one) then . else . + [$one] end)
     | sort_by(startswith("unexplained: "))) as $faults
  | "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"Faults of \(.collider | html), by release\"><table>
<thead><tr><th scope=\"col\">fault</th>\($asked | map("<th scope=\"col\">\(.version | html)</th>") | join(""))</tr></thead>
<tbody>
"
  + ($faults | map(. as $fault | "<tr><th scope=\"row\">\($fault | short($of.collider) | html)</th>"
      + ($asked | map(cell($fault)) | join("")) + "</tr>\n") | join(""))
  + "</tbody>
<tfoot><tr><th scope=\"row\">wrong in a million</th>\($asked | map("<td>\(.cases as $cases | [.wrong[]] | add // 0 | in_a_million($cases) | round)</td>") | join(""))</tr></tfoot>
</table></div>";

def section:
  . as $of
  | "<section id=\"\(.collider | html)\">
<h2>\(.collider | html)</h2>
<p class=\"quiet\">\(.description | html)</p>
<dl>\(.releases | map(release_in_words($of.collider)) | join("\n"))</dl>
\(if any(.releases[]; .reason | not) then table else "" end)
</section>";

def overview:
  [.engines[] | .collider as $collider | .releases[] | .changes // [] | .[] | .change] as $all
  | "\(.engines | length) colliders, \([.engines[].releases[] | select(.reason | not)] | length) releases asked: "
    + "\([$all[] | select(. == "came")] | length) faults came, \([$all[] | select(. == "went")] | length) went.";

"<!doctype html>
<html lang=\"en\">
<head>
<meta charset=\"utf-8\">
<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\">
<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data:; style-src 'unsafe-inline'\">
<link rel=\"icon\" href=\"data:,\">
<title>manifuzz: faults of engines by release</title>
<style>\($style)</style>
</head>
<body>
<main>
<h1>Faults of engines by release</h1>
<p>\(overview)</p>
<p class=\"quiet\">Each release was asked the same \(.cases) cases (seed \(.seed)) against \(.subject | html). A fault is a cause of the ledger of the pinned release, or, where none explains an answer, a kind of wrong answer; numbers are cases. A cause is recognised by the steps of the pinned release: where an older one computes otherwise, its answers may count as unexplained.</p>
<nav aria-label=\"Colliders\">\(.engines | map("<a href=\"#\(.collider | html)\">\(.collider | html)</a>") | join(" "))</nav>
\(.engines | map(section) | join("\n"))
</main>
</body>
</html>"
