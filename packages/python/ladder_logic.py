"""Starts `ladder` under the name of its package, which is what `uvx ladder-logic` looks for."""

import os
import subprocess
import sys
from pathlib import Path


def start():
    # Both are in one folder; a link to this one may be elsewhere.
    program = Path(sys.argv[0]).resolve().with_name("ladder.exe" if os.name == "nt" else "ladder")
    command = [str(program), *sys.argv[1:]]
    if os.name == "nt":
        # There a program that replaces another does not keep the terminal.
        sys.exit(subprocess.call(command))
    os.execv(program, command)
