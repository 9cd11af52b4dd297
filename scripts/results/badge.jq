# A record of record.jq as a badge: a flat SVG of one line, "manifuzz" and what was found.

# Widths of Verdana at 11 pixels, of what a badge can say; the text is stretched to its width where
# another font stands in.
def width:
  {" ": 3.9, ".": 4, ",": 4, "%": 11.8, "a": 6.6, "b": 6.9, "c": 5.7, "d": 6.9, "e": 6.6, "f": 3.9, "g": 6.9, "h": 7,
   "i": 3, "l": 3, "m": 10.7, "n": 7, "o": 6.7, "p": 6.9, "r": 4.7, "s": 5.7, "t": 4.3, "u": 7, "w": 9, "x": 6.5,
   "z": 5.8} as $widths
  | split("") | map($widths[.] // 7) | add | ceil;

# Two digits, which never round to none: 1.4, 0.0012, 44.
def percent:
  if . >= 0.1 then . * 100 | round
  else (log10 | floor) as $e | . / pow(10; $e) * 10 | round | . * pow(10; $e + 1) | . * 1e12 | round | . / 1e12
  end | tostring | . + "%";

def colour:
  if . == 0 then "#3c7d0f" elif . < 0.001 then "#4f7a12" elif . < 0.01 then "#6b7012"
  elif . < 0.05 then "#8a6400" elif . < 0.2 then "#b3500f" else "#b33a2e" end;

([.wrong[]] | add // 0) as $wrong
| ($wrong / .cases) as $share
| (if $wrong == 0 then "no wrong answer in \(.cases)"
   else "\($share | percent) wrong, \(if .unexplained == 0 then "all explained" else "\(.unexplained) unexplained" end)" end) as $message
| "manifuzz" as $name
| ($name | width) as $name_text | ($message | width) as $message_text
| ($name_text + 10) as $left | ($message_text + 10) as $right
| ("\(.collider) \(.version): \(.cases) cases, \($wrong) wrong answers, \(.unexplained) unexplained" | @html) as $title
| "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"\($left + $right)\" height=\"20\" role=\"img\" aria-label=\"\($name): \($message)\">
  <title>\($title)</title>
  <rect width=\"\($left + $right)\" height=\"20\" rx=\"3\" fill=\"\($share | colour)\"/>
  <path d=\"M\($left) 0H3a3 3 0 0 0-3 3v14a3 3 0 0 0 3 3H\($left)z\" fill=\"#555\"/>
  <g fill=\"#fff\" font-family=\"Verdana,Geneva,'DejaVu Sans',sans-serif\" font-size=\"11\" text-anchor=\"middle\">
    <text x=\"\($left / 2)\" y=\"14\" textLength=\"\($name_text)\">\($name)</text>
    <text x=\"\($left + $right / 2)\" y=\"14\" textLength=\"\($message_text)\">\($message)</text>
  </g>
</svg>"
