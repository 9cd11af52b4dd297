"""What whoever installs the wheel reads and imports."""

import inspect
import re
from importlib import metadata
from pathlib import Path

import manifuzz
import pytest

ROOT = Path(__file__).parents[2]


def test_the_wheel_has_the_project_s_version_and_licence():
    version = re.search(r"project\(manifuzz VERSION (\S+)", (ROOT / "CMakeLists.txt").read_text())[1]
    assert metadata.version("manifuzz") == version
    names = [str(file) for file in metadata.files("manifuzz")]
    assert any(name.endswith("LICENSE") for name in names) and "manifuzz/py.typed" in names


@pytest.mark.parametrize("name", [name for name in manifuzz.__all__ if callable(getattr(manifuzz, name))])
def test_docstrings_say_what_goes_in_and_what_is_refused(name):
    documented = getattr(manifuzz, name)
    text = documented.__doc__
    for parameter in list(inspect.signature(documented).parameters):
        assert re.search(rf"\b{parameter}\b", text), parameter
    if name not in ("Declaration", "regimes", "to_world"):
        assert "Raises" in text


def test_the_code_of_the_readme_runs_and_prints_what_it_says(capsys):
    text = (ROOT / "src/python/README.md").read_text()
    blocks = re.findall(r"```python\n(.*?)```", text, re.S)
    assert blocks
    names = {}
    for block in blocks:
        exec(compile(block, "README.md", "exec"), names)
    said = re.findall(r"```text\n(.*?)```", text, re.S)
    assert capsys.readouterr().out == "".join(said)
