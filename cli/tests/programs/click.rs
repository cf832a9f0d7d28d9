//! Click programs on the command line: what cannot be read is refused with its place, nothing is half-written, and
//! nothing of a file is run.

use crate::harness::Folder;
use expect_test::{Expect, expect};

fn refused(text: &str, expected: Expect) {
    let folder = Folder::with(&[("tank.py", text), ("out.clad", "as it was\n")]);
    let run = folder.ladder(&[
        "convert", "--from", "click", "tank.py", "--force", "-o", "out.clad",
    ]);
    assert_eq!((run.status, &*run.stdout), (Some(2), ""), "{run}");
    expected.assert_eq(&run.stderr);
    assert_eq!(folder.read("out.clad"), "as it was\n");
    assert_eq!(folder.names(), ["out.clad", "tank.py"]);
    for command in ["check", "sim", "render"] {
        let run = folder.ladder(&[command, "--from", "click", "tank.py"]);
        assert_eq!(run.status, Some(2), "{command}: {run}");
    }
    assert_eq!(folder.names(), ["out.clad", "tank.py"]);
}

#[test]
fn no_python() {
    refused(
        "def main():\n    if c.A:\n        out(c.B\n",
        expect![[r#"
            error: tank.py:4:1: this is not Python: unexpected EOF while parsing
        "#]],
    );
}

#[test]
fn constructs_that_are_not_of_the_dsl() {
    refused(
        "import os\ndef main():\n    if c.A and not c.B:\n        x = 5\n",
        expect![[r#"
            error: tank.py:1:1: an import outside a function is not in the DSL; 3:8: `and` is not in the DSL: write all(a, b); 4:9: an assignment is not in the DSL
        "#]],
    );
}

#[test]
fn what_is_too_large_or_too_deep() {
    refused(
        &format!(
            "def main():\n{}",
            "    if c.A:\n        out(c.B)\n".repeat(60_000)
        ),
        expect![[r#"
            error: tank.py: a Python file of more than 1 MB is not read
        "#]],
    );
    refused(
        &format!("def main():\n    if {}\n", "all(\n".repeat(9_000)),
        expect![[r#"
            error: tank.py:25:1: what is written here nests too deeply to be read
        "#]],
    );
}

#[test]
fn planted_code() {
    refused(
        "open('planted', 'w')\ndef main():\n    if open('planted', 'w'):\n        out(y[1])\n",
        expect![[r#"
            error: tank.py:1:1: an expression by itself outside a function is not in the DSL; 3:8: `open` is not a condition of the DSL: it has all, any, nc, re and fe
        "#]],
    );
}
