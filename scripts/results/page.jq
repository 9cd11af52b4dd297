# The file of a history as a page that needs nothing else: of each collider what came and went, and a
# table of its faults over its releases. $style is the page's style.

def html: tostring | @html;
def times: if . == 1 then "once" else "\(.) times" end;

def count($one; $many): if . == 1 then "1 \($one)" else "\(.) \($many)" end;

# A cause without the collider's name, which the heading has.
def short($collider): ltrimstr("\($collider)-");

def change_in_words($collider):
  "<li class=\"\(.change)\"><b>\(.change)</b> <span>\(.fault | short($collider) | html)</span> <small>\(
    if .change == "came" then .now | times elif .change == "went" then "\(.before | times) before" else "\(.before) → \(.now)" end)</small></li>";

# What came and went; what is only met more or less often is in the table.
def changes_in_words($collider; $one; $many):
  map(select(.fault != "unexplained")) as $of
  | ($of | map(select(.change | IN("came", "went")))) as $new
  | ($of - $new | length) as $rest
  | ($new | map(change_in_words($collider)) | join(""))
    + (if $rest > 0 then "<li>\($rest | count($one; $many)) more or less often</li>" else "" end)
    + (map(select(.fault == "unexplained") | "<li>unexplained <small>\(.before | times) before, \(.now) now</small></li>") | join(""));

def release_in_words($collider):
  if .reason then "<dt>\(.version | html)</dt><dd class=\"none\">not asked: \(.reason | html)</dd>"
  elif .changes == null then empty
  elif .changes + .kind_changes == [] then "<dt>\(.version | html)</dt><dd class=\"none\">as often wrong as \(.since | html), for the same causes</dd>"
  else "<dt>\(.version | html)</dt><dd><ul>\(.kind_changes | changes_in_words($collider; "kind"; "kinds"))\(.changes | changes_in_words($collider; "cause"; "causes"))</ul></dd>" end;

def cell($fault; $counts; $changes):
  ($counts[$fault] // 0) as $count
  | ($changes // [] | map(select(.fault == $fault)) | first) as $change
  | "<td class=\"\(if $change then $change.change elif $count == 0 then "none" else "same" end)\">"
    + (if $count == 0 then "–" else $count | tostring end)
    + (if $change then " <small>\({came: "came", went: "went", more: "+\($change.now - $change.before)",
        fewer: "−\($change.before - $change.now)"}[$change.change])</small>" else "" end) + "</td>";

# Rows of what is counted in .[$of] of releases, with what changed in .[$changed].
def rows($collider; $what; $of; $changed):
  . as $asked
  | ([.[] | .[$of] | keys_unsorted[]] | reduce .[] as $one ([]; if index($one) then . else . + [$one] end)
     | sort_by(. == "unexplained")) as $counted
  | "<tbody>
<tr class=\"head\"><th scope=\"rowgroup\" colspan=\"\(length + 1)\">\($what)</th></tr>
"
  + ($counted | map(. as $fault | "<tr><th scope=\"row\">\($fault | short($collider) | html)</th>"
      + ($asked | map(cell($fault; .[$of]; .[$changed])) | join("")) + "</tr>\n") | join(""))
  + "</tbody>\n";

def table:
  .collider as $collider | [.releases[] | select(.reason | not)]
  | "<div class=\"scroll\" tabindex=\"0\" role=\"region\" aria-label=\"Faults of \($collider | html), by release\"><table>
<thead><tr><th scope=\"col\">release</th>\(map("<th scope=\"col\">\(.version | html)</th>") | join(""))</tr></thead>
"
  + rows($collider; "Wrong answers, by kind"; "wrong"; "kind_changes")
  + rows($collider; "Causes of these answers"; "faults"; "changes")
  + "<tfoot><tr><th scope=\"row\">wrong in a million</th>\(map("<td>\([.wrong_in_a_million[]] | add // 0 | round)</td>") | join(""))</tr></tfoot>
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
  [.engines[].releases[] | select(.reason | not)] as $asked
  | def of($change; $changed; $one; $many):
      [$asked[] | .[$changed] // [] | .[] | select(.change == $change and .fault != "unexplained")] | length | count($one; $many);
  def all($change): of($change; "kind_changes"; "kind of wrong answers"; "kinds of wrong answers") + " and " + of($change; "changes"; "cause"; "causes") + " \($change)";
  "\(.engines | length | count("collider"; "colliders")), \($asked | length | count("release"; "releases")) asked: \(all("came")), \(all("went")).";

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
<p class=\"quiet\">Each release was asked the same \(.cases) cases (seed \(.seed)) against \(.subject | html); numbers are cases. A cause is recognised by the steps of the pinned release, the last one: an older release may compute otherwise, and then its answers count as unexplained. Kinds do not depend on that.</p>
<nav aria-label=\"Colliders\">\(.engines | map("<a href=\"#\(.collider | html)\">\(.collider | html)</a>") | join(" "))</nav>
\(.engines | map(section) | join("\n"))
</main>
</body>
</html>"
