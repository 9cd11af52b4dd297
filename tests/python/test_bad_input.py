"""Errors: one line, which says what is wrong, where, and what would be right."""

import manifuzz
import numpy as np
import pytest

BOX = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]], np.float32)
POSES = np.array([[[0, 0, 1, 0], [0.5, 1.75, 1, 0]]], np.float32)


def bodies_of(count: int, dtype=manifuzz.body32):
    bodies = np.zeros(count, dtype)
    bodies["pose"][:, 2] = 1
    return bodies


def says(error, *parts):
    text = str(error.value)
    assert "\n" not in text
    for part in parts:
        assert part in text


@pytest.mark.parametrize(
    "vertices, why",
    [
        ([[0, 0], [1, 0], [0.2, 0.1], [0, 1]], "not strictly convex"),
        ([[0, 0], [0, 1], [1, 0]], "clockwise"),
        ([[0, 0], [1, 0], [1, 0], [0, 1]], "repeated"),
        ([[0, 0], [1, 0], [0, np.nan]], "not finite"),
        ([[0, 0]], "without a radius"),
        (np.zeros((9, 2)), "k from 1 to 8"),
        (np.zeros((3, 3)), "(k, 2)"),
    ],
)
@pytest.mark.parametrize("dtype", [np.float32, np.float64])
def test_what_is_no_convex_shape_is_refused(vertices, why, dtype):
    with pytest.raises(ValueError) as error:
        manifuzz.shape(vertices, dtype=dtype)
    says(error, "vertices", why)


def test_a_radius_below_zero_is_refused():
    with pytest.raises(ValueError) as error:
        manifuzz.shape(BOX, radius=-1)
    says(error, "radius is not a length")


@pytest.mark.parametrize("count", [0, 9, -1])
def test_a_record_with_an_impossible_count_is_refused_wherever_it_comes(count):
    shapes = np.repeat(manifuzz.shape(BOX)[None], 3)
    shapes["count"][2] = count
    poses = np.repeat(POSES, 3, 0)
    for ask, name in (
        (lambda: manifuzz.clip(shapes, manifuzz.shape(BOX), poses), "a[2]"),
        (lambda: manifuzz.Shapes(shapes), "shapes[2]"),
        (
            lambda: manifuzz.judge(manifuzz.Cases(shapes, shapes, poses), np.zeros(3, manifuzz.manifold32)),
            "cases.a[2]",
        ),
    ):
        with pytest.raises(ValueError) as error:
            ask()
        says(error, name, f"{count} vertices", "1 to 8")


def test_another_dtype_is_refused_with_the_function_that_takes_it():
    with pytest.raises(TypeError) as error:
        manifuzz.clip(BOX, BOX, POSES.astype(np.float64))
    says(error, "poses", "float32", "not float64 of shape (1, 2, 4)", "clip64")
    with pytest.raises(TypeError) as error:
        manifuzz.clip64(BOX, BOX, POSES)
    says(error, "a:", "manifuzz.shape64", "not float32")
    with pytest.raises(TypeError) as error:
        manifuzz.clip([[0, 0], [1, 0], [0, 1]], BOX, POSES)
    says(error, "a:", "not a list")
    with pytest.raises(TypeError) as error:
        manifuzz.batch(manifuzz.shape([BOX]), bodies_of(2), np.array([[0, 1]]))
    says(error, "pairs", "uint32", "not int64", "astype")
    with pytest.raises(TypeError) as error:
        manifuzz.batch(manifuzz.shape([BOX], dtype=np.float64), bodies_of(2), np.zeros((1, 2), np.uint32))
    says(error, "bodies", "manifuzz.body64", "not manifuzz.body32", "the shapes are of float64")


@pytest.mark.parametrize("shape", [(4,), (3, 4), (1, 2, 3), (1, 1, 2, 4)])
def test_another_shape_is_refused(shape):
    with pytest.raises(ValueError) as error:
        manifuzz.clip(BOX, BOX, np.zeros(shape, np.float32))
    says(error, "poses", "(n, 2, 4)" if shape != (3, 4) else "2, 4)", f"of shape {shape}")


def test_a_bad_case_among_thousands_is_named_by_its_index():
    cases = manifuzz.cases("generic", 1, 2500)
    answers = manifuzz.clip(cases.a, cases.b, cases.poses)
    cases.b["vertices"][2345, 1] = np.nan
    for ask, name in (
        (lambda: manifuzz.judge(cases, answers), "cases.b[2345]"),
        (lambda: manifuzz.clip(cases.a, cases.b, cases.poses), "b[2345]"),
    ):
        with pytest.raises(ValueError) as error:
            ask()
        says(error, name, "not finite")


def test_another_number_of_shapes_is_refused():
    with pytest.raises(ValueError) as error:
        manifuzz.clip(manifuzz.shape([BOX, BOX]), manifuzz.shape(BOX), POSES)
    says(error, "a: 2 shapes for 1 pairs")


def test_memory_that_is_not_contiguous_is_refused_and_not_copied():
    poses = np.repeat(POSES, 4, 0)
    with pytest.raises(ValueError) as error:
        manifuzz.clip(BOX, BOX, poses[::2])
    says(error, "poses", "not contiguous", "ascontiguousarray")


@pytest.mark.parametrize(
    "place, value, why", [(0, np.nan, "position"), (1, np.inf, "position"), (2, 1.1, "length must be 1")]
)
@pytest.mark.parametrize("side", [0, 1])
def test_a_pose_that_is_none_is_refused(place, value, why, side):
    poses = np.repeat(POSES, 3, 0)
    poses[2, side, place] = value
    with pytest.raises(ValueError) as error:
        manifuzz.clip(BOX, BOX, poses)
    says(error, "poses[2]", why)
    bodies = bodies_of(3)
    bodies["pose"][2, place] = value
    with pytest.raises(ValueError) as error:
        manifuzz.batch(manifuzz.shape([BOX]), bodies, np.array([[0, 1]], np.uint32))
    says(error, "bodies[2]", why)


def test_an_index_of_nothing_is_refused():
    shapes, bodies = manifuzz.shape([BOX, BOX]), bodies_of(3)
    with pytest.raises(ValueError) as error:
        manifuzz.batch(shapes, bodies, np.array([[0, 1], [1, 3]], np.uint32))
    says(error, "pairs[1]", "(1, 3)", "3 bodies")
    bodies["shape"][1] = 2
    with pytest.raises(ValueError) as error:
        manifuzz.batch(shapes, bodies, np.array([[0, 1]], np.uint32))
    says(error, "bodies[1]", "shape 2", "2 shapes")


@pytest.mark.parametrize("bias", [-1, np.nan, np.inf])
def test_a_bias_that_is_no_length_is_refused(bias):
    with pytest.raises(ValueError) as error:
        manifuzz.clip(BOX, BOX, POSES, tie_bias=bias)
    says(error, "tie_bias")


def test_a_place_for_results_that_does_not_fit_is_refused():
    with pytest.raises(ValueError) as error:
        manifuzz.clip(BOX, BOX, POSES, out=np.empty(2, manifuzz.manifold32))
    says(error, "out", "(1,)")
    with pytest.raises(TypeError) as error:
        manifuzz.clip(BOX, BOX, POSES, out=np.empty(1, manifuzz.manifold64))
    says(error, "out", "manifuzz.manifold32")
    out = np.empty(1, manifuzz.manifold32)
    out.flags.writeable = False
    with pytest.raises(ValueError) as error:
        manifuzz.clip(BOX, BOX, POSES, out=out)
    says(error, "out", "read-only")


def test_an_unknown_regime_is_refused_with_those_that_there_are():
    with pytest.raises(ValueError) as error:
        manifuzz.cases("slivers", 1, 1)
    says(error, "'slivers'", "generic", "sliver")


@pytest.mark.parametrize("arguments", [(-1, 1), (1, -1), (2**64, 1)])
def test_a_number_out_of_range_is_refused(arguments):
    with pytest.raises(ValueError) as error:
        manifuzz.cases("generic", *arguments)
    says(error, "is expected")


def test_the_judge_refuses_other_answers():
    cases = manifuzz.cases("generic", 1, 3)
    with pytest.raises(ValueError) as error:
        manifuzz.judge(cases, np.zeros(2, manifuzz.manifold32))
    says(error, "answers", "(3,)")
    with pytest.raises(TypeError) as error:
        manifuzz.judge(cases, np.zeros(3))
    says(error, "answers", "manifuzz.manifold64")
    with pytest.raises(TypeError) as error:
        manifuzz.judge(cases.a, np.zeros(3, manifuzz.manifold32))
    says(error, "cases", "manifuzz.Cases")
    answers = np.zeros(3, manifuzz.manifold32)
    answers["reference"][1] = 2
    with pytest.raises(ValueError) as error:
        manifuzz.judge(cases, answers)
    says(error, "answers[1]", "0 (A) or 1 (B)")
    with pytest.raises(ValueError) as error:
        manifuzz.judge(cases, np.zeros(3, manifuzz.manifold32), manifuzz.Declaration(points="middle"))
    says(error, "points", "midpoint", "'middle'")
