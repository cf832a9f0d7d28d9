"""What the README begins with, and that each of its claims has a link to what shows it.

    python3 tests/packages/readme.py ROOT

A newcomer has one sentence, a picture that moves, one command and one link, in this order. Each item under `## What it does` has a
link into the book or to a figure, and each link of the README leads to a file, and to a heading in it.
"""

import re
import sys
from pathlib import Path

LINK = re.compile(r"(!?)\[((?:[^\[\]]|\[[^\]]*\])*)\]\(([^)\s]+)\)")


def anchors(page):
    """What a link can point to within a text: its headings, as GitHub names them."""
    text = re.sub(r"^```.*?^```", "", page.read_text(encoding="utf-8"), flags=re.MULTILINE | re.DOTALL)
    headings = re.findall(r"^#+ (.+)$", text, re.MULTILINE)
    return {re.sub(r"[^\w -]", "", heading).strip().lower().replace(" ", "-") for heading in headings}


def lead_nowhere(root, text):
    readme = root / "README.md"
    for _, words, address in LINK.findall(text):
        path, _, anchor = address.partition("#")
        page = root / path if path else readme
        if ":" in path:
            continue
        if not page.exists():
            yield f"[{words}] leads to no file: {path}"
        elif anchor and anchor not in anchors(page):
            yield f"[{words}] leads to no heading: {address}"


def first_screen(text):
    """What is wrong with all that is before the first heading of the second rank."""
    opening = text.split("\n## ")[0]
    # The badges are one paragraph of pictures that are links.
    paragraphs = [part for part in opening.split("\n\n")[1:] if not part.startswith("[![")]
    sentence, picture, command, link = (paragraphs + [""] * 4)[:4]
    if sentence.count(". ") or not sentence.endswith("."):
        yield "it does not begin with one sentence"
    if not re.fullmatch(r"!\[[^\]]+\]\(\S+\.svg\)", picture):
        yield "no picture is after the sentence"
    elif "@keyframes" not in (Path(sys.argv[1]) / LINK.match(picture)[3]).read_text(encoding="utf-8"):
        yield "the picture does not move"
    if not re.fullmatch(r"```sh\n[^\n]+\n```", command):
        yield "no command of one line is after the picture"
    if len(LINK.findall(link)) != 1:
        yield "not one link is after the command"


def claims(text):
    part = re.search(r"^## What it does\n(.*?)^## ", text, re.MULTILINE | re.DOTALL)
    if not part:
        yield "there is no part `## What it does`"
        return
    for item in re.split(r"^- ", part[1], flags=re.MULTILINE)[1:]:
        if not any(address.startswith("docs/") for _, _, address in LINK.findall(item)):
            yield f"nothing shows it: {' '.join(item.split())[:60]}"


def main():
    root = Path(sys.argv[1])
    text = (root / "README.md").read_text(encoding="utf-8")
    found = [*first_screen(text), *claims(text), *lead_nowhere(root, text)]
    for sentence in found:
        print(f"README.md: {sentence}")
    sys.exit(bool(found))


main()
