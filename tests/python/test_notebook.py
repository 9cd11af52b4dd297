"""The notebook runs, and shows what it shows to readers."""

from pathlib import Path

import nbformat
from nbclient import NotebookClient

NOTEBOOK = Path(__file__).parents[2] / "src" / "python" / "errors.ipynb"


def outputs_of(notebook):
    return [output for cell in notebook.cells if cell.cell_type == "code" for output in cell.outputs]


def pictures_in(notebook) -> int:
    return sum("image/png" in output.get("data", {}) for output in outputs_of(notebook))


def text_of(notebook) -> list[str]:
    """The lines that are printed, without what numpy computed: its sums differ between processors."""
    text = "".join(output.text for output in outputs_of(notebook) if output.output_type == "stream")
    lines = [line for line in text.splitlines() if not line.startswith("mine")]
    return [line.rpartition(",")[0] if "e-" in line else line for line in lines]


def test_the_notebook_runs_and_finds_what_it_says():
    stored = nbformat.read(NOTEBOOK, 4)
    notebook = nbformat.read(NOTEBOOK, 4)
    for cell in notebook.cells:
        cell.pop("outputs", None)
        if cell.cell_type == "code":
            cell.outputs = []
    NotebookClient(notebook, timeout=300, kernel_name="python3").execute()
    assert pictures_in(notebook) == pictures_in(stored) == 2
    # Times are in the pictures alone; cases, verdicts and errors are the same wherever it runs.
    assert text_of(notebook) == text_of(stored)
    assert "clip64  agree 20000" in text_of(notebook)
