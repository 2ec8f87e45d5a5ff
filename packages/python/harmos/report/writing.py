"""What the sections of a report are written with: pictures, tables, numbers."""
import base64
import html
import io

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as pyplot
import numpy

STYLE = """
body { font: 15px/1.45 system-ui, sans-serif; max-width: 1100px; margin: 2em auto; padding: 0 1em; color: #222; }
h1 { margin-bottom: .2em; } h2 { margin-top: 2em; border-bottom: 1px solid #ccc; }
table { border-collapse: collapse; margin: 1em 0; } td, th { padding: .2em .8em; text-align: right; }
th { border-bottom: 1px solid #888; } td:first-child, th:first-child, td.text { text-align: left; }
img { max-width: 100%; } pre { background: #f6f6f6; padding: 1em; overflow: auto; font-size: 12px; }
.note { color: #555; }
"""


class Pictures:
    """Puts figures into the page, and keeps them as files in a folder, if one is given."""

    def __init__(self):
        self.folder = None

    def __call__(self, figure, name):
        buffer = io.BytesIO()
        figure.savefig(buffer, format="png", dpi=110, bbox_inches="tight")
        pyplot.close(figure)
        if self.folder:
            self.folder.mkdir(parents=True, exist_ok=True)
            (self.folder / f"{name}.png").write_bytes(buffer.getvalue())
        return f'<img alt="" src="data:image/png;base64,{base64.b64encode(buffer.getvalue()).decode()}">'


picture = Pictures()


def table(header, rows, text_columns=()):
    cells = "".join(f"<th>{html.escape(name)}</th>" for name in header)
    lines = [f"<tr>{cells}</tr>"]
    for row in rows:
        cells = "".join(f'<td{" class=text" if i in text_columns else ""}>{html.escape(str(cell))}</td>'
                        for i, cell in enumerate(row))
        lines.append(f"<tr>{cells}</tr>")
    return "<table>" + "".join(lines) + "</table>"


def number(value, otherwise=""):
    return otherwise if numpy.isnan(value) else f"{value:.5g}"


def percent(value):
    return "n/a" if numpy.isnan(value) else f"{100 * value:.2g} %"


def label(study, name):
    unit = study.units.get(name, "")
    return f"{name} [{unit}]" if unit else name


def panel_grid(count, width=4.6, height=3.1, columns=2):
    """A figure with `count` panels, and these."""
    columns = min(columns, count)
    rows = -(-count // columns)
    figure, axes = pyplot.subplots(rows, columns, figsize=(width * columns, height * rows), squeeze=False,
                                   layout="constrained")
    for axis in axes.flat[count:]:
        axis.set_visible(False)
    return figure, axes.flat[:count]
