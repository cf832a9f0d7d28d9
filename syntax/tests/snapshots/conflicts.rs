//! Conflicts of merges: their lines, and what is not read of them.

use expect_test::{Expect, expect};
use ladder_syntax::parse;
use std::fmt::Write as _;

/// The lines that are not ours, and the conflicts with their lines of signs.
#[track_caller]
fn check(text: &str, expect: Expect) {
    let parse = parse(text);
    assert_eq!(parse.to_string(), text);
    let mut out = String::new();
    for line in parse.lines() {
        let mark = if line.is_in_conflict() { '!' } else { '.' };
        let _ = writeln!(out, "{mark} {:?} {:?}", line.kind, line.text());
    }
    for conflict in parse.conflicts() {
        let range = conflict.range(parse.text_len());
        let signs = conflict.signs.iter().map(|(sign, line)| {
            let line = parse.text_in(*line).into_owned();
            format!("{sign:?} {line:?}")
        });
        let _ = writeln!(out, "{range:?}: {}", signs.collect::<Vec<_>>().join(", "));
    }
    for error in parse.errors() {
        let _ = writeln!(out, "{:?} {:?}", error.range, error.kind);
    }
    expect.assert_eq(&out);
}

#[test]
fn of_git() {
    check(
        "<<<<<<< HEAD\r\n+--[ ]( a )--+\r\n||||||| 1a2b\r\n+\r\n=======\r\n(\r\n>>>>>>> b\r\n+--+\r\n",
        expect![[r#"
            ! Conflict "<<<<<<< HEAD\r\n"
            ! Rung "+--[ ]( a )--+\r\n"
            ! Conflict "||||||| 1a2b\r\n+\r\n=======\r\n(\r\n>>>>>>> b\r\n"
            . Rung "+--+\r\n"
            0..70: Ours "<<<<<<< HEAD\r\n", Base "||||||| 1a2b\r\n", Theirs "=======\r\n", End ">>>>>>> b\r\n"
        "#]],
    );
}

#[test]
fn of_ladder_merge() {
    check(
        "+--\\--+\n# <<<<<<< ours: removed #\n# ======= #\n|  /--+\n# >>>>>>> theirs #\n|  /--+\n",
        expect![[r##"
            . Rung "+--\\--+\n"
            ! Conflict "# <<<<<<< ours: removed #\n"
            ! Conflict "# ======= #\n|  /--+\n# >>>>>>> theirs #\n"
            . Rung "|  /--+\n"
            8..73: Ours "# <<<<<<< ours: removed #\n", Theirs "# ======= #\n", End "# >>>>>>> theirs #\n"
        "##]],
    );
}

#[test]
fn in_a_section_and_in_a_declaration() {
    check(
        "VAR\n    a :\n<<<<<<< HEAD\n    INT\n=======\n    DINT\n>>>>>>> b\n    ;\n    # <<<<<<< ours #\n    # ======= #\n    b : INT;\n    # >>>>>>> theirs #\nEND_VAR\n",
        expect![[r#"
            . SectionHeader "VAR\n"
            ! Declaration "    a :\n<<<<<<< HEAD\n    INT\n=======\n    DINT\n>>>>>>> b\n    ;\n"
            ! Conflict "    # <<<<<<< ours #\n"
            ! Conflict "    # ======= #\n    b : INT;\n    # >>>>>>> theirs #\n"
            . SectionEnd "END_VAR\n"
            12..60: Ours "<<<<<<< HEAD\n", Theirs "=======\n", End ">>>>>>> b\n"
            66..139: Ours "    # <<<<<<< ours #\n", Theirs "    # ======= #\n", End "    # >>>>>>> theirs #\n"
        "#]],
    );
}

#[test]
fn in_a_comment() {
    check(
        "# Pump\n<<<<<<< HEAD\none #\n=======\ntwo #\n>>>>>>> b\n+--+\n<<<<<<< HEAD\n# one\n=======\n# two #\n>>>>>>> b\ngoes on #\n",
        expect![[r##"
            ! Comment "# Pump\n<<<<<<< HEAD\none #\n"
            ! Conflict "=======\ntwo #\n>>>>>>> b\n"
            . Rung "+--+\n"
            ! Conflict "<<<<<<< HEAD\n"
            ! Comment "# one\n=======\n# two #\n>>>>>>> b\ngoes on #\n"
            7..50: Ours "<<<<<<< HEAD\n", Theirs "=======\n", End ">>>>>>> b\n"
            55..100: Ours "<<<<<<< HEAD\n", Theirs "=======\n", End ">>>>>>> b\n"
        "##]],
    );
}

#[test]
fn inside_of_each_other() {
    check(
        "<<<<<<< a\n<<<<<<< b\nx\n=======\ny\n>>>>>>> b\n=======\n<<<<<<< c\n=======\n>>>>>>> c\n>>>>>>> a\n+--+\n",
        expect![[r#"
            ! Conflict "<<<<<<< a\n"
            ! Conflict "<<<<<<< b\n"
            ! Stray "x\n"
            ! Conflict "=======\ny\n>>>>>>> b\n"
            ! Conflict "=======\n<<<<<<< c\n=======\n>>>>>>> c\n>>>>>>> a\n"
            . Rung "+--+\n"
            0..88: Ours "<<<<<<< a\n", Theirs "=======\n", End ">>>>>>> a\n"
            20..21 UnexpectedCharacter { place: Rung, after_comment: false }
        "#]],
    );
}

#[test]
fn unfinished() {
    check(
        "<<<<<<< a\n+--+\n",
        expect![[r#"
        ! Conflict "<<<<<<< a\n"
        ! Rung "+--+\n"
        0..10: Ours "<<<<<<< a\n"
    "#]],
    );
    check(
        "<<<<<<< a\n+--+\n=======\n+--(\n",
        expect![[r#"
        ! Conflict "<<<<<<< a\n"
        ! Rung "+--+\n"
        ! Conflict "=======\n+--(\n"
        0..28: Ours "<<<<<<< a\n", Theirs "=======\n"
    "#]],
    );
    check(
        "<<<<<<< a\n+--+\n<<<<<<< b\n+\n=======\n-\n>>>>>>> b\n+--+\n",
        expect![[r#"
            ! Conflict "<<<<<<< a\n"
            ! Rung "+--+\n"
            ! Conflict "<<<<<<< b\n"
            ! Rung "+\n"
            ! Conflict "=======\n-\n>>>>>>> b\n"
            ! Rung "+--+\n"
            0..10: Ours "<<<<<<< a\n"
            15..47: Ours "<<<<<<< b\n", Theirs "=======\n", End ">>>>>>> b\n"
        "#]],
    );
    check(
        "+--+\n=======\n+--+\n>>>>>>> b\n>>>>>>> c\n+--+\n# >>>>>>> d #\n",
        expect![[r##"
            . Rung "+--+\n"
            ! Conflict "=======\n"
            . Rung "+--+\n"
            ! Conflict ">>>>>>> b\n"
            ! Conflict ">>>>>>> c\n"
            . Rung "+--+\n"
            ! Conflict "# >>>>>>> d #\n"
            5..28: Theirs "=======\n", End ">>>>>>> b\n"
            28..38: End ">>>>>>> c\n"
            43..57: End "# >>>>>>> d #\n"
        "##]],
    );
    check(
        "<<<<<<< a\n+--+\n>>>>>>> b\n=======",
        expect![[r#"
        ! Conflict "<<<<<<< a\n"
        ! Rung "+--+\n"
        ! Conflict ">>>>>>> b\n"
        ! Conflict "======="
        0..25: Ours "<<<<<<< a\n", End ">>>>>>> b\n"
        25..32: Theirs "======="
    "#]],
    );
}

/// Longer and shorter lines of signs, what is after something else, and a title are no conflicts.
#[test]
fn not_one() {
    check(
        "# Pumps #\n# ======= #\n|||||||\n# ||||||| #\n# <<<<<<<< #\n # a # # <<<<<<< b #\n# Drums\n=======\n>>>>>>> #\n# <<<<<<<\n #\n",
        expect![[r##"
            . Comment "# Pumps #\n"
            . Comment "# ======= #\n"
            . Rail "|||||||\n"
            . Comment "# ||||||| #\n"
            . Comment "# <<<<<<<< #\n"
            . Comment " # a # # <<<<<<< b #\n"
            . Comment "# Drums\n=======\n>>>>>>> #\n"
            . Comment "# <<<<<<<\n #\n"
        "##]],
    );
}
