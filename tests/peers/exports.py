"""L5X files that Ladder writes, in the hands of the package l5x: tags and their values are what the program declares, and a
file that it changed is still one that Ladder reads."""

import os
import subprocess
import tempfile
from pathlib import Path
from xml.etree import ElementTree

import l5x

LADDER = os.environ["LADDER_BIN"]
ROOT = Path(__file__).resolve().parents[2]

VALUES = """TYPE
    Motor : STRUCT
        speed   : REAL := 50.0;
        running : BOOL := TRUE;
        steps   : ARRAY[0..2] OF INT;
    END_STRUCT;
END_TYPE

VAR_INPUT
    start : BOOL;
END_VAR

VAR
    count  : DINT := -7;
    pump   : Motor := (speed := 12.5);
    line   : ARRAY[0..3] OF Motor;
    matrix : ARRAY[0..1, 0..2] OF DINT := [1, 2, 3, 4, 5, 6];
    delay  : TON;
END_VAR

VAR_GLOBAL
    shared : INT := 3;
END_VAR

+--[ ]( start )---------------------------[TON]( delay, T#5s )--( )( pump.running )--+
"""


def ladder(*arguments):
    return subprocess.run([LADDER, *arguments], capture_output=True, text=True, check=False)


def written(source, folder):
    target = folder / f"{source.stem}.L5X"
    said = ladder("convert", str(source), "--to", "l5x", "-o", str(target), "--force")
    assert target.exists(), f"{source}: {said.stderr}"
    return target


def values(folder):
    source = folder / "values.clad"
    source.write_text(VALUES)
    project = l5x.Project(str(written(source, folder)))
    tags = project.programs["MainProgram"].tags
    assert project.controller.tags["shared"].value == 3
    assert tags["count"].value == -7
    assert tags["pump"]["speed"].value == 12.5
    assert tags["pump"]["running"].value == 1
    assert tags["line"][2]["speed"].value == 50.0
    assert tags["line"][1]["steps"].shape == (3,)
    assert tags["matrix"].value == [[1, 2, 3], [4, 5, 6]], tags["matrix"].value
    assert tags["start"].value == 0
    assert tags["delay"]["PRE"].value == 5000
    # Changed there, read here.
    tags["count"].value = 41
    tags["pump"]["speed"].value = 2.5
    tags["count"].description = "how many"
    changed = folder / "changed.L5X"
    project.write(str(changed))
    back = folder / "changed.clad"
    said = ladder("convert", str(changed), "-o", str(back), "--force")
    text = back.read_text()
    assert ":= 41;  # how many #" in text, f"{said.stderr}\n{text}"
    assert "speed := 2.5" in text, text
    assert ladder("check", str(back)).returncode == 0, text


def examples(folder):
    """Every example that can be written is loaded, with all of its tags."""
    count = 0
    for source in sorted((ROOT / "examples").glob("*.clad")):
        target = folder / f"{source.stem}.L5X"
        ladder("convert", str(source), "--to", "l5x", "-o", str(target), "--force")
        if not target.exists():
            continue
        project = l5x.Project(str(target))
        names = list(project.programs["MainProgram"].tags.names) + list(project.controller.tags.names)
        assert len(names) > 3, source
        # An instance of an Add-On Instruction has no data in the file, which is how it begins with zeros: the package shows no such tag.
        shown = {tag.get("Name") for tag in ElementTree.parse(target).iter("Tag") if tag.find("Data") is not None}
        for name in shown.intersection(project.programs["MainProgram"].tags.names):
            assert project.programs["MainProgram"].tags[name].data_type, name
        count += 1
    assert count >= 8, count
    return count


with tempfile.TemporaryDirectory() as name:
    folder = Path(name)
    values(folder)
    print(f"{examples(folder)} examples are loaded; values are what they are declared as, and can be changed")
