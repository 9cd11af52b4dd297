"""Manifolds in float and double, of one pair and of many."""

import sys
import threading

import manifuzz
import numpy as np
import pytest

BOX = np.array([[-1, -1], [1, -1], [1, 1], [-1, 1]], np.float32)
POSES = np.array([[0, 0, 1, 0], [0.5, 1.75, 1, 0]], np.float32)


def as_batch(cases: manifuzz.Cases, scalar=np.float32):
    """Each case as two bodies of a batch."""
    shape, body = (manifuzz.shape32, manifuzz.body32) if scalar == np.float32 else (manifuzz.shape64, manifuzz.body64)
    n = len(cases)
    shapes = np.concatenate([cases.a, cases.b]).astype(shape)
    bodies = np.empty(2 * n, body)
    bodies["shape"] = np.arange(2 * n)
    bodies["pose"] = np.concatenate([cases.poses[:, 0], cases.poses[:, 1]])
    pairs = np.stack([np.arange(n), np.arange(n) + n], 1).astype(np.uint32)
    return shapes, bodies, pairs


def test_two_boxes_touch_as_the_readme_says():
    manifold = manifuzz.clip(BOX, BOX, POSES)
    assert manifold.shape == () and manifold.dtype == manifuzz.manifold32
    assert manifold["count"] == 2
    assert manifold["points"]["depth"].tolist() == [0.25, 0.25]
    assert manifold["normal"].tolist() == [0, 1]


def test_doubles_give_the_same_two_points():
    manifold = manifuzz.clip64(BOX.astype(np.float64), BOX.astype(np.float64), POSES.astype(np.float64))
    assert manifold.dtype == manifuzz.manifold64
    assert manifold["points"]["position"].tolist() == manifuzz.clip(BOX, BOX, POSES)["points"]["position"].tolist()


def test_the_world_is_where_the_pose_of_a_puts_it():
    poses = np.array([[[10, 20, 0, 1], [10 - 1.75, 20.5, 0, 1]]], np.float32)
    manifold = manifuzz.clip(BOX, BOX, poses)
    positions, normals = manifuzz.to_world(poses, manifold)
    np.testing.assert_allclose(normals[0], [-1, 0], atol=1e-7)
    assert sorted(positions[0].tolist()) == [[9.25, 19.5], [9.25, 21.0]]


@pytest.mark.parametrize("regime", ["generic", "sliver", "mixed_shapes", "separated"])
def test_one_pair_many_pairs_and_batches_give_the_same_bits(regime):
    cases = manifuzz.cases(regime, 5, 500)
    many = manifuzz.clip(cases.a, cases.b, cases.poses)
    for i in range(0, 500, 50):
        one = manifuzz.clip(cases.a[i], cases.b[i], cases.poses[i])
        assert one == many[i]
    assert manifuzz.batch(*as_batch(cases)).tobytes() == many.tobytes()
    assert (many["count"] > 0).any() or regime == "separated"


def test_batches_of_doubles_give_the_bits_of_clip64_where_rotations_are_unit():
    cases = manifuzz.cases("boxes", 5, 500)
    cases.poses[..., 2:] = [1, 0]
    many = manifuzz.clip64(*cases.in_doubles())
    assert manifuzz.batch(*as_batch(cases, np.float64)).tobytes() == many.tobytes()
    assert (many["count"] > 0).any()


def test_a_tie_bias_keeps_the_reference_on_a():
    poses = np.array([[0, 0, 1, 0], [0.25, 1.9999, 1, 0]], np.float32)
    thin = np.array([[-1, -1.0001], [1, -1.0001], [1, 1], [-1, 1]], np.float32)
    turned = np.array([[0, 0, 1, 0], [0, 1.9, np.cos(0.001), np.sin(0.001)]], np.float32)
    assert manifuzz.clip(thin, BOX, poses)["reference"] == 0
    without, biased = manifuzz.clip(BOX, BOX, turned), manifuzz.clip(BOX, BOX, turned, tie_bias=1)
    assert biased["reference"] == 0 and without["count"] == biased["count"] == 2


def test_one_shape_serves_all_pairs():
    cases = manifuzz.cases("generic", 1, 100)
    repeated = np.repeat(manifuzz.shape(BOX)[None], 100)
    expected = manifuzz.clip(repeated, cases.b, cases.poses)
    assert manifuzz.clip(manifuzz.shape(BOX), cases.b, cases.poses).tobytes() == expected.tobytes()


def test_what_is_unspecified_is_zero():
    cases = manifuzz.cases("generic", 1, 1000)
    for manifold in (manifuzz.clip(cases.a, cases.b, cases.poses), manifuzz.batch(*as_batch(cases))):
        apart, single = manifold[manifold["count"] == 0], manifold[manifold["count"] == 1]
        assert len(apart) > 0 and len(single) > 0
        assert (apart == np.zeros(1, manifuzz.manifold32)).all()
        assert (single["points"][:, 1] == np.zeros(1, manifuzz.manifold32)["points"][:, 1]).all()


def test_results_go_where_they_are_wanted_and_nothing_is_copied():
    cases = manifuzz.cases("generic", 1, 50)
    out = np.empty(50, manifuzz.manifold32)
    assert manifuzz.clip(cases.a, cases.b, cases.poses, out=out) is out
    expected = out.tobytes()
    out["count"] = 9
    shapes, bodies, pairs = as_batch(cases)
    assert manifuzz.batch(manifuzz.Shapes(shapes), bodies, pairs, out=out) is out
    assert out.tobytes() == expected


def test_a_read_only_array_is_read():
    cases = manifuzz.cases("generic", 1, 50)
    expected = manifuzz.clip(cases.a, cases.b, cases.poses)
    for array in (cases.a, cases.b, cases.poses):
        array.flags.writeable = False
    assert manifuzz.clip(cases.a, cases.b, cases.poses).tobytes() == expected.tobytes()


def test_no_pairs_give_no_manifolds():
    none = np.empty((0, 2, 4), np.float32)
    assert manifuzz.clip(BOX, BOX, none).shape == (0,)
    shapes, bodies, _ = as_batch(manifuzz.cases("generic", 1, 1))
    assert manifuzz.batch(shapes, bodies, np.empty((0, 2), np.uint32)).shape == (0,)


def is_unfinished_when_another_thread_runs(call) -> bool:
    """Whether this thread runs again before a call in another one has ended, that thread being asked for nothing."""
    started, ended = threading.Event(), []

    def work():
        started.set()
        call()
        ended.append(True)

    before = sys.getswitchinterval()
    sys.setswitchinterval(100)  # else whoever has the lock is asked to give it up
    try:
        thread = threading.Thread(target=work)
        thread.start()
        started.wait()
        return not ended
    finally:
        sys.setswitchinterval(before)
        thread.join()


def test_other_threads_run_during_a_batch():
    shapes, bodies, pairs = as_batch(manifuzz.cases("generic", 1, 1000))
    laid_out, many = manifuzz.Shapes(shapes), np.tile(pairs, (2000, 1))
    out = np.empty(len(many), manifuzz.manifold32)
    # On a busy machine this thread may wake too late; where the lock is kept it always does.
    assert any(
        is_unfinished_when_another_thread_runs(lambda: manifuzz.batch(laid_out, bodies, many, out=out))
        for _ in range(20)
    )
    assert not any(is_unfinished_when_another_thread_runs(lambda: sum(range(10000))) for _ in range(5))
