"""A program is typed into Neovim, corrected and run: keys are sent to a tmux, and its screens become a picture that moves.

    docs/picture/recording.py SOCKET >recording.svg

SOCKET is that of a tmux (`tmux -L SOCKET`) in which Neovim shows an empty program. Each row that was ever on the screen is
drawn once; a moment of the recording names the rows it shows. What moves is CSS, so it moves in a README, too.
"""

import subprocess
import sys
import time

from svg import CELL_WIDTH, DARK, LINE_HEIGHT, MARGIN, draw_rows, opening

# Seconds that a moment is shown: after a key, after the end of a line, and where there is something to see.
KEY, LINE, LOOK, END = 0.07, 0.5, 1.2, 4.0

# What is typed, and how long what comes of it is looked at. Names of keys are those of tmux.
SCRIPT = [
    ("i", LINE),
    *((key, KEY) for key in "+--\\--[ ]( start )--\\--[/]( stop )--( )( run )--+"),
    ("Enter", LOOK),
    *((key, KEY) for key in "[ ]( run )"),
    ("/", LOOK),
    ("Enter", LINE),
    ("Enter", LINE),
    *((key, KEY) for key in "[ ]( run )--[TNO]( warmup, 3s )--( )( ready )--+"),
    ("Escape", LOOK),
    # The finding is read, and its fix is taken.
    *((key, KEY) for key in "0fTgr"),
    ("a", LOOK),
    ("1", LINE),
    ("Enter", LOOK),
    *((key, KEY) for key in ":Ladder start"),
    ("Enter", LOOK),
    # On the contact `start` F4 is a finger on the button.
    *((key, KEY) for key in "gg0fs"),
    ("F4", 0),
    *(("", 0.4) for _ in range(9)),
    ("F6", END),
]


class Terminal:
    """The tmux in which Neovim runs."""

    def __init__(self, socket):
        self.socket = socket

    def tmux(self, *arguments):
        return subprocess.run(["tmux", "-L", self.socket, *arguments], check=True, capture_output=True, text=True).stdout

    def press(self, key):
        if len(key) == 1:
            # A `;` at the end would end tmux's own command.
            self.tmux("send-keys", "-l", key)
        elif key:
            self.tmux("send-keys", key)

    def screen(self):
        """The screen once it is settled, with the cell of the cursor."""
        before = None
        for _ in range(20):
            time.sleep(0.04)
            shown = self.tmux("capture-pane", "-e", "-p", "-N")
            if shown == before:
                break
            before = shown
        column, row = self.tmux("display-message", "-p", "#{cursor_x} #{cursor_y}").split()
        return shown.rstrip("\n"), int(column), int(row)


def record(terminal):
    """Moments: the screen, the cursor, and how long it is shown in seconds."""
    moments = [(*terminal.screen(), LOOK)]
    for key, seconds in SCRIPT:
        terminal.press(key)
        if not key:
            time.sleep(seconds)
        if seconds:
            moments.append((*terminal.screen(), seconds))
    return moments


def main():
    moments = record(Terminal(sys.argv[1]))
    rows, names, frames, columns, height = {}, [], [], 0, 0
    for screen, column, row, seconds in moments:
        drawn, wide = draw_rows(screen, DARK)
        columns, height = max(columns, wide), max(height, len(drawn))
        shown = []
        for number, elements in enumerate(drawn):
            if elements:
                name = rows.setdefault(elements, f"r{len(rows)}")
                shown.append(f'<use href="#{name}" y="{number * LINE_HEIGHT}"/>')
        x, y = MARGIN + column * CELL_WIDTH, MARGIN + row * LINE_HEIGHT
        cursor = f'<rect x="{x:.1f}" y="{y}" width="{CELL_WIDTH}" height="{LINE_HEIGHT}" fill-opacity=".45"/>'
        frames.append(("".join(shown) + cursor, seconds))
    total = sum(seconds for _, seconds in frames)
    print(opening(columns, height, DARK))
    print("<defs>")
    for elements, name in rows.items():
        print(f'<g id="{name}">{elements}</g>')
    print("</defs>")
    # All moments are next to each other, and the window moves from one to the next.
    width = columns * CELL_WIDTH + 2 * MARGIN
    steps, begun = [], 0.0
    for number, (_, seconds) in enumerate(frames):
        steps.append(f"{begun / total * 100:.3f}%{{transform:translateX({-number * width:.1f}px)}}")
        begun += seconds
    steps.append(f"100%{{transform:translateX({-(len(frames) - 1) * width:.1f}px)}}")
    # It begins with its end, the program that runs: an empty editor tells nobody what this is.
    print(f"<style>@keyframes play{{{''.join(steps)}}}#film{{animation:play {total:.2f}s steps(1,end) {END - total:.2f}s infinite}}")
    # Who wants nothing to move sees how it ends.
    print(f"@media(prefers-reduced-motion){{#film{{animation:none;transform:translateX({-(len(frames) - 1) * width:.1f}px)}}}}</style>")
    print('<g id="film">')
    for number, (elements, _) in enumerate(frames):
        print(f'<g transform="translate({number * width:.1f} 0)">{elements}</g>')
    print("</g>\n</svg>")


main()
