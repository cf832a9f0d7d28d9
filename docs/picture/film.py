"""Makes an animated WebP of the recording, for pages that show no SVG: the marketplaces of VS Code.

    docs/picture/film.py CHROMIUM recording.svg film.webp

Needs Pillow. Chromium draws the moments below each other, and they are cut apart here.
"""

import re
import subprocess
import sys
import tempfile
from pathlib import Path

from PIL import Image

# Moments on one page: no side of a picture that Chromium takes may be longer than 16384 pixels.
ON_PAGE = 40


def main():
    chromium, recording, film = sys.argv[1:]
    svg = Path(recording).read_text()
    begun = [float(percent) for percent in re.findall(r"([\d.]+)%\{transform", svg)]
    total = float(re.search(r"animation:play ([\d.]+)s", svg)[1]) * 1000
    width, height = (round(float(re.search(rf'<svg[^>]* {side}="([\d.]+)"', svg)[1])) for side in ("width", "height"))
    moments = [moment.split("</g>\n")[0] for moment in svg.split('<g transform="translate(')[1:]]
    # What is before the film: the ground, the letters, and the rows that the moments name.
    rows = re.sub(r"<style>@keyframes.*?</style>", "", svg[: svg.index('<g id="film">')], flags=re.DOTALL)
    pictures = []
    with tempfile.TemporaryDirectory() as scratch:
        page, picture = Path(scratch, "page.html"), Path(scratch, "page.png")
        for first in range(0, len(moments), ON_PAGE):
            shown = moments[first : first + ON_PAGE]
            drawn = [f'{rows}<g>{moment[moment.index(">") + 1 :]}</g></svg>' for moment in shown]
            page.write_text("<style>body{margin:0}svg{display:block}</style>" + "\n".join(drawn))
            size = f"--window-size={width},{height * len(shown)}"
            command = [chromium, "--headless", "--no-sandbox", "--disable-gpu", "--hide-scrollbars", size]
            subprocess.run([*command, f"--screenshot={picture}", str(page)], check=True, capture_output=True)
            sheet = Image.open(picture).convert("RGB")
            pictures += [sheet.crop((0, height * n, width, height * (n + 1))) for n in range(len(shown))]
    ends = [*begun[1 : len(pictures)], 100.0]
    lengths = [round((end - start) / 100 * total) for start, end in zip(begun, ends)]
    # As the recording it begins with its end.
    pictures, lengths = pictures[-1:] + pictures[:-1], lengths[-1:] + lengths[:-1]
    pictures[0].save(film, save_all=True, append_images=pictures[1:], duration=lengths, loop=0, lossless=True, method=6)


main()
