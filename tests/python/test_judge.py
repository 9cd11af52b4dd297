"""Cases, and what the judge says of answers to them."""

import json
import os
import subprocess

import manifuzz
import numpy as np
import pytest

PROGRAM = os.environ.get("MANIFUZZ_PROGRAM", "")
needs_program = pytest.mark.skipif(not os.access(PROGRAM, os.X_OK), reason="MANIFUZZ_PROGRAM names no manifuzz")

TWO_BOXES = manifuzz.Cases(
    *[manifuzz.shape([[[-1, -1], [1, -1], [1, 1], [-1, 1]]])] * 2,
    np.array([[[10, 0, 0, 1], [10 - 1.75, 0.5, 0, 1]]], np.float32),
)


def lines_of(text: str):
    return [json.loads(line) for line in text.splitlines()]


def manifuzz_says(*arguments, cases: str = "") -> str:
    return subprocess.run([PROGRAM, *arguments], input=cases, capture_output=True, text=True).stdout


def generated(regime: str, seed: int, count: int) -> str:
    return manifuzz_says("generate", "--regime", regime, "--seed", str(seed), "--cases", str(count))


@pytest.mark.parametrize("regime", manifuzz.regimes())
def test_clip_and_clip64_are_right_in_every_regime(regime):
    cases = manifuzz.cases(regime, 1, 300)
    for answers in (manifuzz.clip(cases.a, cases.b, cases.poses), manifuzz.clip64(*cases.in_doubles())):
        judged = manifuzz.judge(cases, answers)
        assert set(judged["verdict"]) <= {"agree", "ill_posed"}
        assert not judged["errors"]["depth"].any()
        measured = judged[(judged["verdict"] == "agree") & (answers["count"] > 0)]
        if len(measured):
            assert np.nanmax(measured["of_bound"]["depth"]) <= 1


def test_a_case_depends_on_seed_regime_and_index_alone():
    whole, part = manifuzz.cases("sliver", 7, 20), manifuzz.cases("sliver", 7, 5, first=10)
    for name in ("a", "b", "poses"):
        assert getattr(part, name).tobytes() == getattr(whole[10:15], name).tobytes()
    assert manifuzz.cases("sliver", 8, 20).poses.tobytes() != whole.poses.tobytes()


def test_some_of_the_cases_are_chosen_as_arrays_are():
    cases = manifuzz.cases("generic", 1, 10)
    assert len(cases[3]) == 1 and cases[3].poses.tobytes() == cases.poses[3].tobytes()
    chosen = cases[cases.a["count"] == cases.a["count"][0]]
    assert len(chosen) >= 1 and (chosen.a["count"] == cases.a["count"][0]).all()


def test_a_radius_may_be_asked_for():
    assert (manifuzz.cases("generic", 1, 10, radius=0.25).a["radius"] == 0.25).all()


def test_what_is_right_of_two_boxes_is_said_in_full():
    judged = manifuzz.judge(TWO_BOXES, np.zeros(1, manifuzz.manifold64))[0]
    assert judged["verdict"] == "subject_wrong" and judged["kind"] == "missed_contact"
    assert judged["touching"] and judged["separation"] == -0.25 and judged["depth"] == 0.25
    assert judged["normal"].tolist() == [0, 1]
    assert judged["errors"]["missing"] == judged["magnitude"] == pytest.approx(0.25 / np.sqrt(8))
    assert judged["right"]["count"] == 2 and judged["right_count"] >= 1
    assert judged["right"]["points"]["depth"].tolist() == [0.25, 0.25]
    assert np.isnan(judged["of_size"]["depth"])


def test_an_engine_s_answers_in_the_world_are_judged_by_what_it_declares():
    answer = manifuzz.clip64(*TWO_BOXES.in_doubles())
    positions, normals = manifuzz.to_world(TWO_BOXES.poses, answer)
    own = manifuzz.manifolds(answer["count"], normals, positions[:, ::-1], answer["points"]["depth"][:, ::-1])
    declaration = manifuzz.Declaration(in_world=True, names_reference=False, names_features=False)
    assert manifuzz.judge(TWO_BOXES, own, declaration)["verdict"] == "agree"
    assert manifuzz.judge(TWO_BOXES, own)["verdict"] == "subject_wrong"  # as if it were in A's frame
    own["points"]["depth"][0, 0] += 0.1
    judged = manifuzz.judge(TWO_BOXES, own, declaration)[0]
    assert judged["verdict"] == "subject_wrong" and judged["kind"] == "depth"
    assert judged["of_size"]["depth"] == judged["errors"]["depth"] == pytest.approx(0.1 / np.sqrt(8))
    assert judged["of_bound"]["depth"] > 1e10


@pytest.mark.parametrize(
    "counts, normals, positions, depths, error, said",
    [
        ([1, 2], [[1, 0]], [[[0, 0], [1, 1]]], [[1, 1]], ValueError, r"normals: shape \(1, 2\); \(2, 2\) is expected"),
        ([2], [[1, 0]], [[[0, 0]]], [[1, 1]], ValueError, r"positions: shape \(1, 1, 2\); \(1, 2, 2\) is expected"),
        ([2], [[1, 0]], [[[0, 0], [1, 1]]], 5.0, ValueError, r"depths: shape \(\); \(1, 2\) is expected"),
        (2, [1, 0], [[0, 0], [1, 1]], [1, 1], ValueError, r"counts: shape \(\); \(1,\) is expected"),
        ([1.9], [[1, 0]], [[[0, 0], [1, 1]]], [[1, 1]], TypeError, "counts: float64; integers are expected"),
    ],
)
def test_answers_whose_shapes_do_not_fit_are_refused(counts, normals, positions, depths, error, said):
    with pytest.raises(error, match=said):
        manifuzz.manifolds(counts, normals, positions, depths)


def test_midpoints_are_taken_for_what_they_are():
    answer = manifuzz.clip64(*TWO_BOXES.in_doubles())
    incident = 1 - 2.0 * answer["reference"]
    answer["points"]["position"] += (incident * 0.125)[:, None, None] * answer["normal"][:, None, :]
    assert manifuzz.judge(TWO_BOXES, answer, manifuzz.Declaration(points="midpoint"))["verdict"] == "agree"
    assert manifuzz.judge(TWO_BOXES, answer)["verdict"] == "subject_wrong"


def test_floats_that_claim_to_be_doubles_are_held_to_it():
    cases = manifuzz.cases("generic", 1, 300)
    answers = manifuzz.clip(cases.a, cases.b, cases.poses)
    assert (manifuzz.judge(cases, answers, manifuzz.Declaration(scalar="float64"))["verdict"] == "subject_wrong").any()


def test_one_point_is_enough_for_whoever_declares_so():
    answer = manifuzz.clip64(*TWO_BOXES.in_doubles())
    answer["count"] = 1
    assert manifuzz.judge(TWO_BOXES, answer)["kind"] == "count"
    for declaration in (
        manifuzz.Declaration(one_point_enough=True),
        manifuzz.Declaration(claims="point", clips=False),
    ):
        assert manifuzz.judge(TWO_BOXES, answer, declaration)["verdict"] == "agree"


@pytest.mark.parametrize("field, value", [("count", 3), ("count", -1), ("normal", np.nan), ("depth", -1)])
def test_what_is_no_manifold_is_malformed(field, value):
    answer = manifuzz.clip64(*TWO_BOXES.in_doubles())
    (answer if field != "depth" else answer["points"])[field] = value
    judged = manifuzz.judge(TWO_BOXES, answer)[0]
    assert judged["verdict"] == "malformed" and judged["right"]["count"] == 2


def test_round_shapes_are_judged_by_depth_and_normal():
    cases = manifuzz.cases("circles", 1, 300)
    answers = manifuzz.clip(cases.a, cases.b, cases.poses)
    answers["points"]["depth"][:, 0] *= 1.5
    judged = manifuzz.judge(cases, answers)
    wrong = judged[judged["verdict"] == "subject_wrong"]
    assert len(wrong) > 50
    assert np.isfinite(wrong["of_size"]["depth"]).sum() > 50
    assert np.isnan(judged["of_size"]["position"]).all() or not (cases.a["round"] & cases.b["round"]).all()


def test_no_cases_give_no_judgements():
    assert manifuzz.judge(TWO_BOXES[:0], np.zeros(0, manifuzz.manifold32)).shape == (0,)


@needs_program
@pytest.mark.parametrize("regime", ["generic", "far_from_origin", "mixed_shapes"])
def test_cases_are_those_of_the_program(regime):
    cases = manifuzz.cases(regime, 3, 200)
    lines = lines_of(generated(regime, 3, 200))
    assert len(lines) == 200
    for i, line in enumerate(lines):
        for side, shapes in (("a", cases.a), ("b", cases.b)):
            body, shape = line[side], shapes[i]
            assert np.array_equal(np.float32(body["vertices"]), shape["vertices"][: shape["count"]])
            assert np.float32(body.get("radius", 0)) == shape["radius"]
            pose = [*body.get("position", [0, 0]), *body.get("rotation", [1, 0])]
            assert np.array_equal(np.float32(pose), cases.poses[i, "ab".index(side)])


@needs_program
@pytest.mark.parametrize("name", ["clip", "clip64"])
def test_manifolds_are_those_of_the_program(name):
    cases = manifuzz.cases("off_unit", 3, 200)
    arrays = (cases.a, cases.b, cases.poses) if name == "clip" else cases.in_doubles()
    answers = getattr(manifuzz, name)(*arrays)
    lines = lines_of(manifuzz_says("collide", "--collider", name, cases=generated("off_unit", 3, 200)))
    assert len(lines) == 200
    for line, answer in zip(lines, answers):
        points = answer["points"][: answer["count"]]
        assert [point["local"] for point in line["points"]] == points["position"].astype(np.float64).tolist()
        assert [point["depth"] for point in line["points"]] == points["depth"].astype(np.float64).tolist()


@needs_program
def test_judgements_are_those_of_the_program():
    cases, text = manifuzz.cases("sliver", 3, 200), generated("sliver", 3, 200)
    answers = manifuzz.clip(cases.a, cases.b, cases.poses, tie_bias=0.05)  # which it does not declare
    judged = manifuzz.judge(cases, answers)
    expected = lines_of(manifuzz_says("judge", "--subject", "clip", "--oracle", "clip64", cases=text))
    assert len(expected) == 200
    assert [line["separation"] for line in expected] == judged["separation"].tolist()
    assert [line["touching"] for line in expected] == judged["touching"].tolist()
    assert [line["penetration"]["depth"] for line in expected] == judged["depth"].tolist()
    assert [len(line["admissible"]) for line in expected] == judged["right_count"].tolist()
    assert "subject_wrong" in judged["verdict"] and "agree" in judged["verdict"]
