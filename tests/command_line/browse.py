#!/usr/bin/python3
"""Opens a page of `harmos show` in Chromium without a screen and a network: it shows every field, and a drag turns it.

browse.py CHROMIUM PAGE.html
"""
import pathlib
import subprocess
import sys
import tempfile

import numpy

from drawn import coloured_share, pixels

DRAG = """<script>
(function drag() {
  if (document.body.dataset.ready !== 'yes') { setTimeout(drag, 50); return; }
  const canvas = document.querySelector('#view canvas');
  const at = (type, x, y) => canvas.dispatchEvent(new PointerEvent(type, { clientX: x, clientY: y, pointerId: 1,
    pointerType: 'mouse', isPrimary: true, button: 0, buttons: 1, bubbles: true }));
  at('pointerdown', 500, 300);
  for (let i = 1; i <= 10; ++i) at('pointermove', 500 + 15 * i, 300 + 5 * i);
  at('pointerup', 650, 350);
}());
</script>"""


def screenshot(chromium, folder, page, fragment=""):
    """The picture of a page after it has come to rest."""
    picture = folder / "page.png"
    picture.unlink(missing_ok=True)
    subprocess.run([chromium, "--headless=new", "--no-sandbox", "--use-angle=swiftshader", "--enable-unsafe-swiftshader",
                    f"--user-data-dir={folder}/profile", "--proxy-server=127.0.0.1:9", "--window-size=1000,600",
                    "--virtual-time-budget=20000", f"--screenshot={picture}", f"file://{page}{fragment}"],
                   stdout=subprocess.DEVNULL, stderr=subprocess.DEVNULL, timeout=120, check=True)
    return str(picture)


def main():
    chromium, page = sys.argv[1], pathlib.Path(sys.argv[2]).resolve()
    with tempfile.TemporaryDirectory() as name:
        folder = pathlib.Path(name)
        pictures = {}
        for fragment in ("", "#field=contact_pressure", "#field=contact_pressure&step=1", "#field=disp_"):
            path = screenshot(chromium, folder, page, fragment)
            if coloured_share(path) < 0.02:
                sys.exit(f"FAILED: {page}{fragment} shows nothing in colour")
            pictures[fragment] = pixels(path)
        dragged = folder / "dragged.html"
        dragged.write_text(page.read_text(encoding="utf-8").replace("</body>", DRAG + "</body>"), encoding="utf-8")
        pictures["drag"] = pixels(screenshot(chromium, folder, dragged))
    names = list(pictures)
    for i, first in enumerate(names):
        for second in names[:i]:
            if numpy.mean(numpy.any(pictures[first] != pictures[second], axis=1)) < 0.005:
                sys.exit(f"FAILED: \"{first}\" and \"{second}\" look alike")


if __name__ == "__main__":
    main()
