#!/usr/bin/env python3
"""Holds a port of the article's clipping against cases.jsonl: check.py ANSWERS.jsonl, a line a case,
or check.py -- COMMAND, a program that is asked. README.md beside it has the rules."""
import argparse, json, math, os, re, struct, subprocess, sys
from pathlib import Path


def as_floats(value):
    """Every number of a shape and its pose is a float; the file has its shortest decimals."""
    if isinstance(value, dict):
        return {key: as_floats(one) for key, one in value.items()}
    if isinstance(value, list):
        return [as_floats(one) for one in value]
    return value if isinstance(value, (str, bool)) else struct.unpack("f", struct.pack("f", value))[0]


def refuse(why):
    raise ValueError(why)


def dot(p, q):
    return p[0] * q[0] + p[1] * q[1]


def cross(p, q):
    return p[0] * q[1] - p[1] * q[0]


def off(p, q, low):
    return math.hypot(p[0] - q[0] - low[0], p[1] - q[1] - low[1])


def angle_chord(n, m):
    """The distance of two directions on the unit circle, to the last digits; m is unit, its low parts behind it."""
    by = [n[0] - m[0] - m[2], n[1] - m[1] - m[3]]
    return 2 * math.sin(abs(math.atan2(cross(m, by), 1 + dot(m, by))) / 2)


def turn(r, v):  # R v
    return [r[0] * v[0] - r[1] * v[1], r[1] * v[0] + r[0] * v[1]]


def turn_back(r, v):  # R^T v
    return [r[0] * v[0] + r[1] * v[1], r[0] * v[1] - r[1] * v[0]]


def in_frame_of_a(r, normal):
    return [c / math.sqrt(dot(r, r)) for c in turn_back(r, normal)]


def normals(corners):
    lengths = [(v - y, x - u, math.dist((x, y), (u, v))) for (x, y), (u, v) in zip(corners, corners[1:] + corners[:1])]
    return [[x / length, y / length] for x, y, length in lengths if length > 0]


def read(case, answer):
    """The answer's points, in A's frame, and its normal, in the world; a ValueError says what is wrong. Null is
    nothing."""
    def expect(is_so, what):
        return is_so or refuse(what)
    def is_number(value):
        return isinstance(value, float) and math.isfinite(value)
    def is_two(value):
        return isinstance(value, list) and len(value) == 2 and all(map(is_number, value))
    def of(value, key):
        return value.get(key) if isinstance(value, dict) else None
    def is_feature(value, count):
        return isinstance(value, str) and re.fullmatch("[fv][0-7]", value) and int(value[1]) < count

    points = of(answer, "points")
    expect(isinstance(points, list) and len(points) <= 2, 'an answer has 0 to 2 "points"')
    position, rotation = case["a"]["position"], case["a"]["rotation"]
    found, counts = [], [len(case[side]["vertices"]) for side in "ab"]
    for point in points:
        at, world, features = of(point, "local"), of(point, "position"), of(point, "features")
        expect(is_two(world if at is None else at), "a point has no place of two finite numbers")
        depth = of(answer, "depth") if of(point, "depth") is None else point["depth"]
        expect(is_number(depth) and depth >= 0, "a depth is not a finite number of 0 or more")
        expect(features is None or isinstance(features, list) and len(features) == 2 and all(
            map(is_feature, features, counts)), "the features are not one of each shape")
        if at is None:
            at = [c / dot(rotation, rotation) for c in turn_back(rotation, [x - p for x, p in zip(world, position)])]
        found.append((at, depth, features))
    expect(of(answer, "reference") in (None, "a", "b"), "the reference is neither a nor b")
    expect(not points or is_two(of(answer, "normal")), "the normal is not two finite numbers")
    return found, of(answer, "normal")


def why_no_clip(right, scalar, answer, points, normal):
    """Why the answer is not this right manifold, or None. All figures are in A's frame."""
    within, places = right[scalar], right["points"]
    named = all(features for _, _, features in points)
    if answer.get("reference") not in (None, right["reference"]):
        return "reference"
    low = within.get("low", [0] * 8)  # what the figures lost where they were written as doubles
    if not off(normal, right["normal"], low) <= within["normal"]:
        return "normal"
    near = [[k for k, place in enumerate(places)
             if off(at, place["local"], low[2 + 3 * k:]) <= within["local"][k]
             and abs(depth - place["depth"] - low[4 + 3 * k]) <= within["depth"][k]] for at, depth, _ in points]
    for ks, (_, _, features) in zip(near, points):
        if not ks:
            return "position or depth of a point"
        if named and all(k in within["features"] and features != places[k]["features"] for k in ks):
            return "features"
    return next((f"no point is point {k + 1} of the right manifold" for k in within["needed"]
                 if not any(k in ks for ks in near)), None)


def heights(shape, normal, side, low, high, thin):
    """The heights along the normal, least and most, of what of a core faces the other one from low to high."""
    ends = [(cross(normal, v), dot(normal, v)) for v in shape]
    is_thin = max(ends)[0] - min(ends)[0] <= thin  # rounding alone says which side faces the other core
    seen = [y for x, y in ends if is_thin and low <= x <= high]
    for p, q in zip(ends, ends[1:] + ends[:1]):
        (x, y), (u, v) = (p, q) if side == "a" else (q, p)
        if u > x and max(x, low) <= min(u, high):
            seen += [y + (v - y) * ((at - x) / (u - x)) for at in (max(x, low), min(u, high))]
    return (min(seen), max(seen)) if seen else None


def why_no_contact(case, scalar, points, normal):
    """Why it is no right contact of round shapes, or None. All is seen from A's position, in the world."""
    right, within, radii = case["round"], case["round"][scalar], [case[side]["radius"] for side in "ab"]
    r = case["a"]["rotation"]
    local, length = in_frame_of_a(r, normal), math.hypot(*normal)
    if not abs(math.sqrt(dot(local, local)) - 1) <= within["unit"]:
        return "length of the normal"
    n = [normal[0] / length, normal[1] / length]
    offset = [q - p for p, q in zip(case["a"]["position"], case["b"]["position"])]
    a = [turn(case["a"]["rotation"], v) for v in case["a"]["vertices"]]
    b = [[x + o for x, o in zip(turn(case["b"]["rotation"], v), offset)] for v in case["b"]["vertices"]]
    along = max(dot(n, v) for v in a) - min(dot(n, v) for v in b)  # D(n) without the radii
    excess, deepest = along + sum(radii) - right["least"], max(depth for _, depth, _ in points)
    if not (any(angle_chord(normal, m) <= within["turn"] for m in within.get("nearest", []))
            or abs(excess) <= within.get("excess", -1)):
        return "normal"
    if not (abs(deepest - right["least"]) <= within.get("depth", -1)
            or "shortfall" in within and abs(deepest - along - sum(radii)) <= within["consistency"]):
        return "depth"
    at = [turn(case["a"]["rotation"], local) for local, _, _ in points]
    for i, (p, (_, depth, _)) in enumerate(zip(at, points)):
        place, height = cross(n, p), dot(n, p)
        reach = place - within["along"], place + within["along"], within["across"]
        top, bottom = (heights(shape, n, side, *reach) for shape, side in ((a, "a"), (b, "b")))
        least, most = (depth + sign * within["consistency"] - sum(radii) for sign in (-1, 1))
        if i == [d for _, d, _ in points].index(deepest) and "shortfall" in within:
            least = max(least, along - within["shortfall"])
        on_a, on_b = ([h - within["across"], h + within["across"]] for h in (height - radii[0], height + radii[1]))
        if not (top and bottom) or not any(
                t[0] <= t[1] and s[0] <= s[1] and max(t[0] - s[1], least) <= min(t[1] - s[0], most)
                for t, s in (((max(top[0], on_a[0]), min(top[1], on_a[1])), bottom),
                             (top, (max(bottom[0], on_b[0]), min(bottom[1], on_b[1]))))):
            return "a point is not where they overlap by its depth"
    if not within["points"][0] <= len(points) <= within["points"][1]:
        return f"{len(points)} points"
    if len(points) == 2 and abs(cross(n, at[0]) - cross(n, at[1])) < within.get("span", 0):
        return "the points span too little"
    return None


def why_wrong(case, answer, scalar):
    """None where the answer is right."""
    try:
        points, normal = read(case, answer)
    except ValueError as error:
        return f"malformed: {error}"
    if not points:
        return None if scalar in case["empty"] else "missed contact"
    if "round" in case:
        return why_no_contact(case, scalar, points, normal) if scalar in case["round"] else "phantom contact"
    normal = in_frame_of_a(case["a"]["rotation"], normal)
    reasons = [why_no_clip(right, scalar, answer, points, normal) for right in case["right"] if scalar in right]
    return None if None in reasons else reasons[0] if reasons else "phantom contact"


def ask(command, cases):
    """What a program says when it is given the cases, their numbers with all digits."""
    lines = [json.dumps({side: {**case[side], "normals": normals(case[side]["vertices"])} for side in "ab"})
             for case in cases]
    ended = subprocess.run(command, input="\n".join(lines) + "\n", stdout=subprocess.PIPE, encoding="utf-8")
    if ended.returncode:
        how = f"status {ended.returncode}" if ended.returncode > 0 else f"signal {-ended.returncode}"
        refuse(f"{command[0]} ended with {how}; 0 is expected, after an answer to each case")
    return ended.stdout


def lines_of(text):
    """The lines that are not empty, with their numbers."""
    return [(number, line) for number, line in enumerate(text.split("\n"), 1) if line.strip(" \t\r")]


def parse(text, name):
    """What a port declares, if it does, and its answers."""
    answers = []
    for number, line in lines_of(text):
        try:  # NaN and Infinity are refused
            answers.append(json.loads(line, parse_int=float, parse_constant=refuse))
        except (ValueError, RecursionError) as error:
            raise ValueError(f"{name}:{number}: no JSON: {error}") from error
    is_declared = answers and isinstance(answers[0], dict) and "declaration" in answers[0]
    declared = answers.pop(0)["declaration"] if is_declared else {}
    if not isinstance(declared, dict):
        refuse(f"{name}: its declaration is no object")
    declared = {key: value for key, value in declared.items() if value is not None}
    only = {"tie_bias": [0.0], "claims": ["manifold"], "clips": [True], "points": ["clip"], "normal": ["a_to_b"],
            "second_point": ["clip", "never"], "scalar": ["float32", "float64"],
            "vertices_min": [1.0, 2.0, 3.0], "takes_round": [True, False]}
    for key, value in declared.items():
        if not any(type(value) is type(one) and value == one for one in only.get(key, [value])):
            whole = int(value) if isinstance(value, float) and value.is_integer() else value
            said = json.dumps(whole, ensure_ascii=False, separators=(",", ":"))
            refuse(f"{name} declares {key} {said}; it is not what this suite is for")
    return declared, answers


def give_one_point(cases):
    """What is right of a port that never gives a second point of round shapes."""
    for case in cases:
        for scalar in {"float32", "float64"} & case.get("round", {}).keys():
            case["round"][scalar] = {**case["round"][scalar], "points": [1, 1], "span": 0}


def takes(declared, case):
    """Whether a program is asked about the case: about round shapes only as it declares."""
    all_shapes = "second_point" in declared
    takes_round = declared.get("takes_round", all_shapes)
    return "round" not in case or all(
        len(body["vertices"]) >= declared.get("vertices_min", 1 if all_shapes else 3)
        and (len(body["vertices"]) < 3 or takes_round or ("rounding" not in body and body["radius"] == 0))
        for body in (case["a"], case["b"]))


def read_cases(path):
    cases = []
    for number, line in lines_of(Path(path).read_text(encoding="utf-8-sig")):
        try:
            case = json.loads(line, parse_constant=refuse)
            case.update({side: as_floats({"position": [0, 0], "rotation": [1, 0], **case[side]}) for side in "ab"})
            for body in (case["a"], case["b"]):
                numbers = [body["radius"], *(c for x, y in body["vertices"] for c in (x, y))]
                len(numbers) > 1 and all(type(x) is float and math.isfinite(x) for x in numbers) or refuse("no body")
            kinds = [type(case[key]) for key in ("name", "empty", "round" if "round" in case else "right")]
            case["format"] == "manifuzz/conformance/1" or refuse("another format")
            kinds == [str, list, dict if "round" in case else list] or refuse("no truth")
            cases.append(case)
        except (ArithmeticError, LookupError, TypeError, ValueError, struct.error):
            refuse(f"{path}:{number}: a case of manifuzz/conformance/1 is expected")
    return cases


def check(options):
    cases = read_cases(options.cases)
    command, left = options.command, len(cases)
    if command:
        declared, _ = parse(ask(command, [case for case in cases if "round" not in case][:1]), command[0])
        cases = [case for case in cases if takes(declared, case)]
    text = ask(command, cases) if command else Path(options.answers).read_text(encoding="utf-8-sig")
    declared, answers = parse(text, command[0] if command else options.answers)
    scalar = options.scalar or declared.get("scalar", "float32")
    if declared.get("second_point") == "never":
        give_one_point(cases)
    if len(answers) != len(cases):
        refuse(f"{len(answers)} answers; {len(cases)} are expected, a line a case")
    wrong, unsupported, lines = 0, left - len(cases), []
    for case, answer in zip(cases, answers):
        is_asked = not (isinstance(answer, dict) and "unsupported" in answer)
        why = why_wrong(case, answer, scalar) if is_asked else None
        wrong, unsupported = wrong + (why is not None), unsupported + (not is_asked)
        if options.each or (why and wrong <= 10):
            lines.append(f"{case['name']}: {why or ('right' if is_asked else 'unsupported')}")
    if unsupported == left:
        refuse(f"none of {left} cases was answered; nothing is checked")
    lines.append(f"{'fail' if wrong else 'pass'}: {wrong} of {len(cases)} wrong, {unsupported} unsupported, as {scalar}")
    with os.fdopen(os.dup(1), "w") as out:  # what cannot be written is an error here, not at the end
        out.write("\n".join(lines) + "\n")
    return 1 if wrong else 0


def main():
    parser = argparse.ArgumentParser(description=__doc__, usage="%(prog)s [options] ANSWERS.jsonl | -- COMMAND...")
    parser.add_argument("answers", nargs="?", help="a manifold a line, in the order of the cases")
    parser.add_argument("--cases", default=Path(__file__).with_name("cases.jsonl"), help="default: cases.jsonl")
    parser.add_argument("--scalar", choices=("float32", "float64"), help="default: as declared, else float32")
    parser.add_argument("--each", action="store_true", help="print a line for each case")
    parser.error = refuse
    words = sys.argv[1:] + ["--"]
    try:
        options = parser.parse_args(words[:words.index("--")])
        options.command = words[words.index("--") + 1:-1]
        if bool(options.answers) == bool(options.command):
            refuse("either a file of answers or, after --, a command is expected")
        return check(options)
    except (OSError, ValueError) as error:
        print(f"check.py: {error}", file=sys.stderr)
        return 2


if __name__ == "__main__":
    sys.exit(main())
