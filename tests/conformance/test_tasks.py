"""The tasks for assistants: their own answers are right, and what they begin with is not."""

import pathlib
import subprocess


def test_the_answers_are_right():
    check = pathlib.Path(__file__).parents[1] / "tasks/check"
    run = subprocess.run([check], capture_output=True, text=True, timeout=300)
    assert run.returncode == 0, run.stdout
