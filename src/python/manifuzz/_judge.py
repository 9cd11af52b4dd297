"""Cases, and the exact judge of answers to them."""

from dataclasses import dataclass
from math import isfinite
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from . import _core
from ._arrays import (
    expect,
    judgement,
    judgement_record,
    kinds,
    manifold32,
    manifold64,
    parts,
    rows,
    shape32,
    shape64,
    verdicts,
)

_Array = NDArray[Any]
_POSES = np.dtype((np.float32, (2, 4)))

# Python sees ctrl-C only between calls, so cases are judged in calls of this many.
_CASES_AT_A_TIME = 1000


@dataclass(frozen=True, eq=False)
class Cases:
    """Pairs of shapes with a pose each, in the floats that every collider gets.

    a, b: `shape32` of shape (n,).
    poses: float32 of shape (n, 2, 4): of A and of B x and y of the position, cos and sin of the rotation.

    ``cases[i:j]`` and ``cases[mask]`` are some of them. Raises TypeError and ValueError where arrays are others.
    """

    a: _Array
    b: _Array
    poses: _Array

    def __post_init__(self) -> None:
        expect("cases.a", self.a, shape32, ("n",), "manifuzz.shape makes shapes")
        expect("cases.b", self.b, shape32, (len(self.a),), "manifuzz.shape makes shapes")
        expect("cases.poses", self.poses, np.float32, (len(self.a), 2, 4))

    def __len__(self) -> int:
        return len(self.a)

    def __getitem__(self, some: Any) -> "Cases":
        if isinstance(some, (int, np.integer)):
            some = [some]
        of = (np.ascontiguousarray(array[some]) for array in (self.a, self.b, self.poses))
        return Cases(*of)

    def in_doubles(self) -> tuple[_Array, _Array, _Array]:
        """Copies of a, b and poses for `clip64`, with the same values."""
        return self.a.astype(shape64), self.b.astype(shape64), self.poses.astype(np.float64)


def regimes() -> dict[str, str]:
    """The names of the families of cases, with a line on each."""
    return dict(_core.regimes())


def cases(regime: str, seed: int, count: int, *, first: int = 0, radius: float | None = None) -> Cases:
    """Cases `first` to `first + count - 1` of a regime: those of ``manifuzz generate``, on every machine.

    regime: a name of `regimes`. seed, first: 0 <= seed, first < 2**64.
    radius: of each polygon, a length >= 0, in place of the regime's own.

    Raises ValueError for a regime that there is not, or a number that is out of range.
    """
    for name, value in (("seed", seed), ("first", first), ("count", count)):
        if not 0 <= value < 2**64:
            raise ValueError(f"{name}: a whole number from 0 to 2**64 - 1 is expected, not {value}")
    if radius is not None and not (isfinite(radius) and radius >= 0):
        raise ValueError(f"radius: a length of 0 or more is expected, not {radius}")
    if regime not in regimes():
        raise ValueError(f"there is no regime {regime!r}; these are: {', '.join(regimes())}")
    made = Cases(np.zeros(count, shape32), np.zeros(count, shape32), np.zeros((count, 2, 4), np.float32))
    everything = rows(made.a, shape32), rows(made.b, shape32), rows(made.poses, _POSES)
    for some in parts(count, _CASES_AT_A_TIME):
        _core.generate(regime, seed, first + some.start, radius, *(all[some] for all in everything))
    return made


@dataclass(frozen=True)
class Declaration:
    """What a collider declares of itself, which it is judged by. The defaults are those of `clip`.

    scalar: what it computes in, whose roundoff scales every bound; None is the scalar of its answers.
    frame: where it rounds: "local" in a frame that travels with the pair, "world" in coordinates of the world.
    normals: where a face's comes from: "given", made in double and rounded once, as in C++; "vertices", in the shape's
        own frame; "world_vertices", once they are rounded in the world.
    tie_bias: B's face is taken only where its separation is greater by more than this length (0.0005 in Box2D 2.4).
    points: where they lie: "clip", on the incident edge; "midpoint", halfway between both surfaces; "vertex";
        "surface_a"; "surface_b".
    claims: what an answer says: "manifold", all contact points; "point", one of them.
    clips: whether a face clips an edge; else any point where the shapes overlap by what it says is right.
    takes_angles: whether rotations reach it as angles. one_point_enough: of two points it may give one.
    shares_depth: one depth for all points, the deepest's.
    in_world: whether its answers are in the world; else they are in A's frame.
    names_reference, names_features: whether those fields of its answers are filled in; else nobody looks at them.
    """

    scalar: Literal["float32", "float64"] | None = None
    frame: Literal["local", "world"] = "local"
    normals: Literal["given", "vertices", "world_vertices"] = "given"
    tie_bias: float = 0.0
    points: Literal["clip", "midpoint", "vertex", "surface_a", "surface_b"] = "clip"
    claims: Literal["manifold", "point"] = "manifold"
    clips: bool = True
    takes_angles: bool = False
    one_point_enough: bool = False
    shares_depth: bool = False
    in_world: bool = False
    names_reference: bool = True
    names_features: bool = True

    def _convention(self, scalar: np.dtype[Any]) -> _core.Convention:
        if not (isfinite(self.tie_bias) and self.tie_bias >= 0):
            raise ValueError(f"tie_bias: a length of 0 or more is expected, not {self.tie_bias}")
        return _core.convention(
            _place("scalar", self.scalar or scalar.name, ("float32", "float64")),
            _place("frame", self.frame, ("local", "world")),
            _place("normals", self.normals, ("given", "vertices", "world_vertices")),
            _place("points", self.points, ("clip", "midpoint", "vertex", "surface_a", "surface_b")),
            _place("claims", self.claims, ("manifold", "point")),
            self.clips,
            self.tie_bias,
            self.takes_angles,
            self.one_point_enough,
            self.shares_depth,
            self.in_world,
            self.names_reference,
            self.names_features,
        )


def _place(name: str, word: str, words: tuple[str, ...]) -> int:
    if word not in words:
        raise ValueError(f"{name}: one of {', '.join(words)} is expected, not {word!r}")
    return words.index(word)


def judge(cases: Cases, answers: _Array, declaration: Declaration = Declaration()) -> _Array:
    """What is right of each case, and what is wrong with each answer, by exact arithmetic.

    cases: n of them.
    answers: `manifold32` or `manifold64` of shape (n,): of `clip`, or of an engine of your own
        (`manifolds` makes them).
    declaration: of the collider whose answers they are.

    Returns `judgement` of shape (n,). Lengths are in the world, shares are of ``size``, and normals and points
    in A's frame:

    verdict: "agree" where the answer is right within the bounds that its scalar and the case have; "subject_wrong";
        "ill_posed" where it is within them but they are more than 5% of the size; "malformed" where it is no manifold.
    kind: what is wrong: "none", "missed_contact", "phantom_contact", "normal", "position", "depth", "count", ...
    touching, separation: what is true; a separation below 0 is an overlap of the shapes without radii.
    depth, normal: the least depth over all directions, below 0 across a gap, and the normal along which it is least.
    size: of the smaller shape, a length: its diameter.
    errors: by how much a wrong answer is, in "normal" (a length of vectors of length 1), "position", "depth",
        "missing", "extra" and "excess" (shares of the size); 0 within its own bound. magnitude: the greatest; bound: of
        that one.
    of_size, of_bound: the plain error in normal, position and depth against the nearest right answer, whether or not it
        is within its bound: as shares of the size (of a normal, a length), and of its bound, below 1 within it.
        Not a number where there is no contact to compare; of round shapes, and where ``clips`` is false, no position.
    right, right_count: the right manifold that the answer is nearest to, and how many there are. Where an empty one is
        right, too, it counts. Of round shapes there are none: ``depth`` and ``normal`` say what is right.

    Raises TypeError and ValueError as `clip` does. It takes some microseconds a case; ctrl-C ends it.
    """
    if not isinstance(cases, Cases):
        raise TypeError(f"cases: manifuzz.Cases are expected, not a {type(cases).__name__}")
    is_float = getattr(answers, "dtype", None) == manifold32
    dtype = manifold32 if is_float else manifold64
    given = expect("answers", answers, dtype, (len(cases),), "manifuzz.manifolds makes them").astype(
        manifold64, copy=False
    )
    if np.any(given["reference"] > 1):
        raise ValueError(f"answers[{int(np.argmax(given['reference'] > 1))}]: the reference must be 0 (A) or 1 (B)")
    by = declaration._convention(np.dtype(np.float32 if is_float else np.float64))
    records = np.zeros(len(cases), judgement_record)
    everything = (
        rows(cases.a, shape32),
        rows(cases.b, shape32),
        rows(cases.poses, _POSES),
        rows(given, manifold64),
        by,
        rows(records, judgement_record),
    )
    for some in parts(len(cases), _CASES_AT_A_TIME):
        _core.judge(*everything, some.start, some.stop)
    result = np.zeros(len(cases), judgement)
    words = {"verdict": verdicts, "kind": kinds}
    for name in judgement.names or ():
        result[name] = words[name][records[name]] if name in words else records[name]
    return result
