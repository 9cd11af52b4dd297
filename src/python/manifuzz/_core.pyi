"""Arrays come as rows of bytes: `__init__.py` has looked at them."""

from numpy import uint8
from numpy.typing import NDArray

_Rows = NDArray[uint8]

verdicts: list[str]
kinds: list[str]
components: list[str]

class LaidOut32:
    def __init__(self, shapes: _Rows) -> None: ...
    def __len__(self) -> int: ...

class LaidOut64:
    def __init__(self, shapes: _Rows) -> None: ...
    def __len__(self) -> int: ...

class Convention: ...

def convention(
    scalar: int,
    frame: int,
    normals: int,
    points: int,
    claims: int,
    clips: bool,
    tie_bias: float,
    takes_angles: bool,
    one_point_enough: bool,
    shares_depth: bool,
    in_world: bool,
    names_reference: bool,
    names_features: bool,
    /,
) -> Convention: ...
def clip(a: _Rows, b: _Rows, poses: _Rows, tie_bias: float, out: _Rows, begin: int, end: int, /) -> None: ...
def clip64(a: _Rows, b: _Rows, poses: _Rows, tie_bias: float, out: _Rows, begin: int, end: int, /) -> None: ...
def check_shapes(shapes: _Rows, name: str, /) -> None: ...
def check_shapes64(shapes: _Rows, name: str, /) -> None: ...
def batch(shapes: LaidOut32 | LaidOut64, bodies: _Rows, pairs: _Rows, tie_bias: float, out: _Rows, /) -> None: ...
def generate(regime: str, seed: int, first: int, radius: float | None, a: _Rows, b: _Rows, poses: _Rows, /) -> None: ...
def regimes() -> list[tuple[str, str]]: ...
def judge(
    a: _Rows, b: _Rows, poses: _Rows, answers: _Rows, by: Convention, out: _Rows, begin: int, end: int, /
) -> None: ...
