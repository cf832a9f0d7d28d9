"""Draws a terminal's screen as SVG: reads what `tmux capture-pane -e -p` writes, from stdin to stdout.

With --light the terminal is one of dark letters on light ground.
"""

import re
import sys
import unicodedata
from dataclasses import dataclass, replace
from xml.sax.saxutils import escape

CELL_WIDTH, LINE_HEIGHT, FONT_SIZE, MARGIN = 8.4, 18, 14, 14
# Blanks in a row are drawn as one, whatever xml:space says; these are not.
NBSP = "\u00a0"


@dataclass(frozen=True)
class Theme:
    """What a terminal draws with where a program says nothing; as Neovim's own schemes have it."""

    foreground: str
    background: str
    # The sixteen colours.
    palette: tuple[str, ...]


DARK = Theme(
    "#e0e2ea",
    "#14161b",
    (
        "#07080d", "#ffc0b9", "#b3f6c0", "#fce094", "#a6dbff", "#ffcaff", "#8cf8f7", "#eef1f8",
        "#4f5258", "#ffc0b9", "#b3f6c0", "#fce094", "#a6dbff", "#ffcaff", "#8cf8f7", "#eef1f8",
    ),
)  # fmt: skip
LIGHT = Theme(
    "#14161b",
    "#e0e2ea",
    (
        "#07080d", "#590008", "#005523", "#6b5300", "#004c73", "#470045", "#007373", "#eef1f8",
        "#4f5258", "#590008", "#005523", "#6b5300", "#004c73", "#470045", "#007373", "#eef1f8",
    ),
)  # fmt: skip


@dataclass(frozen=True)
class Style:
    foreground: str | None = None
    background: str | None = None
    bold: bool = False
    italic: bool = False
    underline: bool = False
    reverse: bool = False


def colour(codes, theme):
    """The colour behind a 38 or 48; takes its codes from the list."""
    kind = codes.pop(0)
    if kind == 2:
        return "#%02x%02x%02x" % tuple(codes.pop(0) for _ in range(3))
    index = codes.pop(0)
    if index < 16:
        return theme.palette[index]
    if index >= 232:
        return "#%02x%02x%02x" % ((8 + (index - 232) * 10,) * 3)
    index -= 16
    levels = [0, 95, 135, 175, 215, 255]
    return "#%02x%02x%02x" % (levels[index // 36], levels[index // 6 % 6], levels[index % 6])


def restyle(style, sequence, theme):
    """The style behind `ESC [ sequence m`."""
    # 4:3 is a curly underline; what is behind a colon is a kind of the same.
    codes = [int(code.split(":")[0] or 0) if code != "4:0" else 24 for code in sequence.split(";")]
    while codes:
        code = codes.pop(0)
        if code == 0:
            style = Style()
        elif code in (1, 22):
            style = replace(style, bold=code == 1)
        elif code in (3, 23):
            style = replace(style, italic=code == 3)
        elif code in (4, 24):
            style = replace(style, underline=code == 4)
        elif code in (7, 27):
            style = replace(style, reverse=code == 7)
        elif code in (38, 48, 58):
            seen = colour(codes, theme)
            # 58 is the underline's own colour.
            if code != 58:
                style = replace(style, **{"foreground" if code == 38 else "background": seen})
        elif code == 39:
            style = replace(style, foreground=None)
        elif code == 49:
            style = replace(style, background=None)
        elif 30 <= code <= 37 or 90 <= code <= 97:
            style = replace(style, foreground=theme.palette[code - 30 if code < 90 else code - 82])
        elif 40 <= code <= 47 or 100 <= code <= 107:
            style = replace(style, background=theme.palette[code - 40 if code < 100 else code - 92])
    return style


def runs(line, style, theme):
    """Pieces of a line that look alike: column, text, style. And the style at its end."""
    pieces, column = [], 0
    for part in re.split(r"(\x1b\[[0-9;:]*m)", line):
        if part.startswith("\x1b["):
            style = restyle(style, part[2:-1], theme)
        elif part:
            pieces.append((column, part, style))
            column += sum(2 if unicodedata.east_asian_width(letter) in "WF" else 1 for letter in part)
    return pieces, style


def draw(column, row, text, style, theme):
    """One piece of a line, in elements of SVG."""
    foreground, background = style.foreground or theme.foreground, style.background
    if style.reverse:
        foreground, background = background or theme.background, foreground
    left, top, width = MARGIN + column * CELL_WIDTH, MARGIN + row * LINE_HEIGHT, len(text) * CELL_WIDTH
    drawn = []
    if background and background != theme.background:
        drawn.append(f'<rect x="{left:.1f}" y="{top}" width="{width:.1f}" height="{LINE_HEIGHT}" fill="{background}"/>')
    if text.strip() or style.underline:
        shown = escape(text).replace(" ", NBSP)
        look = f' fill="{foreground}"' if foreground != theme.foreground else ""
        look += ' font-weight="bold"' if style.bold else ""
        look += ' font-style="italic"' if style.italic else ""
        look += ' text-decoration="underline"' if style.underline else ""
        # The width is said, so that columns stay columns in whatever font there is.
        drawn.append(f'<text x="{left:.1f}" y="{top + 13}" textLength="{width:.1f}"{look}>{shown}</text>')
    return drawn


def draw_rows(screen, theme):
    """The elements of each row of a screen, drawn as if it were the first; and how many columns there are."""
    rows, style, columns = [], Style(), 0
    for line in screen.split("\n"):
        pieces, style = runs(line, style, theme)
        rows.append("".join(element for piece in pieces for element in draw(piece[0], 0, piece[1], piece[2], theme)))
        columns = max([columns, *(column + len(text) for column, text, _ in pieces)])
    return rows, columns


def opening(columns, rows, theme):
    """The beginning of a picture of this many columns and rows."""
    width, height = columns * CELL_WIDTH + 2 * MARGIN, rows * LINE_HEIGHT + 2 * MARGIN
    return (
        f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {width:.0f} {height}" width="{width:.0f}" height="{height}"'
        f' font-family="ui-monospace, Menlo, Consolas, \'DejaVu Sans Mono\', monospace" font-size="{FONT_SIZE}"'
        f' fill="{theme.foreground}">\n<rect width="100%" height="100%" rx="8" fill="{theme.background}"/>'
    )


def main():
    theme = LIGHT if "--light" in sys.argv else DARK
    rows, columns = draw_rows(sys.stdin.read().rstrip(), theme)
    print(opening(columns, len(rows), theme))
    for number, row in enumerate(rows):
        if row:
            print(f'<g transform="translate(0 {number * LINE_HEIGHT})">{row}</g>')
    print("</svg>")


if __name__ == "__main__":
    main()
