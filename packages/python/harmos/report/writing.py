"""What the sections of a report are written with: pictures, tables, numbers."""
import base64
import html
import io
import os
import pathlib
from collections.abc import Collection, Iterable, Sequence

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as pyplot
import numpy
from matplotlib.axes import Axes
from matplotlib.figure import Figure

from harmos.outputs import demand_distinct, replace_file, writing
from harmos.results import Study

STYLE = """
body { font: 15px/1.45 system-ui, sans-serif; max-width: 1100px; margin: 2em auto; padding: 0 1em; color: #222; }
h1 { margin-bottom: .2em; } h2 { margin-top: 2em; border-bottom: 1px solid #ccc; }
table { border-collapse: collapse; margin: 1em 0; } td, th { padding: .2em .8em; text-align: right; }
th { border-bottom: 1px solid #888; } td:first-child, th:first-child, td.text { text-align: left; }
img { max-width: 100%; } pre { background: #f6f6f6; padding: 1em; overflow: auto; font-size: 12px; }
.note { color: #555; }
.warning { background: #fff3cd; border-left: 4px solid #d39e00; padding: .5em 1em; }
"""
"""The style sheet of the page."""


class Pictures:
    """Puts figures into the page, and keeps them as files in a folder, if one is given.

    Attributes:
        folder: that also gets the figures, as PNG files; None: there is none.
        study: the file that is read, which no picture may replace.
        files: these figures by the name of their file, until they are written.
    """

    def __init__(self, folder: pathlib.Path | None = None, study: str | os.PathLike[str] = "") -> None:
        """Writes nothing; see write()."""
        self.folder, self.study = folder, study
        self.files: dict[str, bytes] = {}

    def __call__(self, figure: Figure, name: str) -> str:
        """The figure, which is closed, as HTML; `name` is that of its file, without suffix."""
        buffer = io.BytesIO()
        figure.savefig(buffer, format="png", dpi=110, bbox_inches="tight")
        pyplot.close(figure)
        if self.folder:
            self.files[f"{name}.png"] = buffer.getvalue()
        return f'<img alt="" src="data:image/png;base64,{base64.b64encode(buffer.getvalue()).decode()}">'

    def write(self) -> None:
        """Writes the files; makes the folder only when there are any.

        Raises:
            OSError: it cannot.
            ValueError: one of them would replace the study; nothing is written then.
        """
        if self.folder and self.files:
            for name in self.files:
                demand_distinct(self.study, self.folder / name)
            with writing(self.folder):
                self.folder.mkdir(parents=True, exist_ok=True)
            for name, content in self.files.items():
                replace_file(self.folder / name, content)


def table(header: Iterable[str], rows: Iterable[Iterable[object]], text_columns: Collection[int] = ()) -> str:
    """A table as HTML; `text_columns` are those that hold text and no numbers, besides the first."""
    cells = "".join(f"<th>{html.escape(name)}</th>" for name in header)
    lines = [f"<tr>{cells}</tr>"]
    for row in rows:
        cells = "".join(f'<td{" class=text" if i in text_columns else ""}>{html.escape(str(cell))}</td>'
                        for i, cell in enumerate(row))
        lines.append(f"<tr>{cells}</tr>")
    return "<table>" + "".join(lines) + "</table>"


def number(value: float, otherwise: str = "") -> str:
    """A number with five digits; `otherwise` stands for NaN."""
    return otherwise if numpy.isnan(value) else f"{value:.5g}"


def percent(value: float) -> str:
    """A share in percent with two digits, "n/a" for what is not finite."""
    return "n/a" if not numpy.isfinite(value) else f"{plain(100 * value)} %"


def plain(value: float) -> str:
    """A number with two digits, large ones without an exponent."""
    return f"{float(f'{value:.2g}'):.0f}" if abs(value) >= 10 else f"{value:.2g}"


def label(study: Study, name: str) -> str:
    """The name of a parameter with its unit, if it has one."""
    unit = study.units.get(name, "")
    return f"{name} [{unit}]" if unit else name


def panel_grid(count: int, width: float = 4.6, height: float = 3.1, columns: int = 2) -> tuple[Figure, Sequence[Axes]]:
    """A figure with `count` panels, and these; width and height of a panel are in inches."""
    columns = min(columns, count)
    rows = -(-count // columns)
    figure, axes = pyplot.subplots(rows, columns, figsize=(width * columns, height * rows), squeeze=False,
                                   layout="constrained")
    for axis in axes.flat[count:]:
        axis.set_visible(False)
    return figure, axes.flat[:count]
