//! The textbook grammar, read and written.

use expect_test::{Expect, expect};
use ladder_format::Options;
use ladder_notation::{Notation, Outcome, Source, convert};
use ladder_notation_textbook::Textbook;

/// The ladder text, then what there is to say about it; or the error.
fn read(text: &str) -> String {
    let source = Source::alone("test", text.as_bytes());
    match convert(&Textbook, &source, &Options::default()) {
        Err(error) => format!("{error}\n"),
        Ok(converted) => {
            let mut out = converted.written.text.clone();
            for found in &converted.findings {
                out.push_str(&format!("{} {}: {}\n", found.place, found.check, found.message));
            }
            out
        }
    }
}

fn write(ladder: &str) -> String {
    let analysis = ladder_analysis::analyze(&ladder_syntax::parse(ladder).into(), "test.clad");
    match Textbook.write(&analysis) {
        Err(error) => format!("{error}\n"),
        Ok(writing) => {
            let mut out = String::from_utf8(writing.bytes).expect("it is text");
            for entry in writing.report.remarks() {
                let (Outcome::Approximated(why) | Outcome::Refused(why)) = &entry.outcome else {
                    continue;
                };
                out.push_str(&format!("{} {}: {why}\n", entry.place, entry.element));
            }
            out
        }
    }
}

#[track_caller]
fn check(text: &str, expected: Expect) {
    expected.assert_eq(&read(text));
}

#[test]
fn the_papers_program() {
    check(
        "start closed contact I0.1 & active coil Q0 end",
        expect![[r#"
            VAR_INPUT
                I0 : BOOL := TRUE;
            END_VAR
            VAR_OUTPUT
                Q0 : BOOL;
            END_VAR

            +--[/]( I0 )--------------------------------------------------------( )( Q0 )--+
        "#]],
    );
}

#[test]
fn branches_memories_and_words_written_together() {
    check(
        "# two programs\n| start (openContact I0.1 V closedContact M3) & activeCoil M1 end |\n\
         start open contact M1 & (inactive coil Q0 V active coil Q1) end\n",
        expect![[r#"
            VAR_INPUT
                I0 : BOOL := TRUE;
            END_VAR
            VAR_OUTPUT
                Q0 : BOOL;
                Q1 : BOOL;
            END_VAR
            VAR
                M1 : BOOL;
                M3 : BOOL;
            END_VAR

            # two programs #
            +--\--[ ]( I0 )--\--------------------------------------------------( )( M1 )--+
            |  /--[/]( M3 )--/                                                             |

            +--[ ]( M1 )--\--------------------------------------------------(/)( Q0 )--\--+
            |             /--------------------------------------------------( )( Q1 )--/  |
        "#]],
    );
}

#[test]
fn remarks_of_the_paper() {
    check(
        "start open contact I0.1 V open contact I1.0 & active coil Q0 end\nstart open contact Q0 & active coil I7 end",
        expect![[r#"
            VAR_INPUT
                I0 : BOOL := TRUE;
                I1 : BOOL;
            END_VAR
            VAR
                I7 : BOOL;
            END_VAR
            VAR_OUTPUT
                Q0 : BOOL;
            END_VAR

            +--\--[ ]( I0 )-------------------------------------------------------------\--+
            |  /--[ ]( I1 )--------------------------------------------------( )( Q0 )--/  |

            +--[ ]( Q0 )--------------------------------------------------------( )( I7 )--+
            1:7 textbook-precedence: the paper does not say whether `&` or `V` binds more tightly; `&` does here, put parentheses round what belongs together
            2:25 textbook-name: a coil is better called `Q7` or `M7` than `I7`
        "#]],
    );
}

#[test]
fn what_the_grammar_refuses() {
    for (text, expected) in [
        (
            "",
            expect![[r#"
            there is no program in the file; it begins with `start`
        "#]],
        ),
        (
            "start end",
            expect![[r#"
            1:7: a contact, a coil or `(` is missing here
        "#]],
        ),
        (
            "| start open contact I0.1 | active coil Q0 end |",
            expect![[r#"
                1:27: `|` is before `start` and after `end` only; `V` is between branches
            "#]],
        ),
        (
            "start active coil Q0 end",
            expect![[r#"
            1:7: a program begins with a contact, not with a coil
        "#]],
        ),
        (
            "start open contact I0.1 end",
            expect![[r#"
            1:7: a program has a contact, a coil and an operation between them
        "#]],
        ),
        (
            "start open contact I0 & active coil Q0 end",
            expect![[r#"
            1:7: an input has a value: write `I0.0` or `I0.1`
        "#]],
        ),
        (
            "start open contact I0.1 & active coil Q0.1 end",
            expect![[r#"
            1:27: a coil has no value: write `Q0`
        "#]],
        ),
        (
            "start open contact M0.1 & active coil Q0 end",
            expect![[r#"
            1:7: a memory has no value: write `M0`
        "#]],
        ),
        (
            "start open contact I0.1 & active coil Q0",
            expect![[r#"
            1:39: a program ends with `end`, and `&` or `V` is between two elements
        "#]],
        ),
        (
            "start (open contact I0.1 & active coil Q0 end",
            expect![[r#"
            1:43: this parenthesis is not closed
        "#]],
        ),
        (
            "start open contact I0.1\n   & open coil Q0 end",
            expect![[r#"
            2:6: `open` is followed by `contact`
        "#]],
        ),
        (
            "start open contact I0.1 + active coil Q0 end",
            expect![[r#"
            1:25: `+` is not a word of the textbook grammar; its words are `start`, `end`, `(`, `)`, `&`, `V`, `open contact`, `closed contact`, `active coil`, `inactive coil` and names such as `I0.1`, `M2` and `Q3`
        "#]],
        ),
        (
            "start open contact I0.1 & open contact I0.0 & active coil Q0 end",
            expect![[r#"
            1:27: `I0` has another value at 1:7: an input has one
        "#]],
        ),
    ] {
        check(text, expected);
    }
    let deep = format!("start {}open contact I0.1", "(".repeat(100_000));
    check(
        &deep,
        expect![[r#"
        1:107: parentheses are nested more than 100 deep
    "#]],
    );
}

#[test]
fn a_program_is_written_and_reads_back_the_same() {
    let ladder = "\
VAR_INPUT
    start : BOOL := TRUE;
    I5    : BOOL;
END_VAR
VAR_OUTPUT
    Q2 : BOOL;
END_VAR

+--\\--[ ]( start )--\\--[/]( I5 )-------( )( Q2 )--+
|  /--[ ]( Q2 )-----/                            |
+--[ ]( Q2 )---------------[TON]( t, 5s )--( )( Q3 )--+
";
    let written = write(ladder);
    expect![[r#"
        start (open contact I0.1 V open contact Q2) & closed contact I5.0 & active coil Q2 end
        # +--[ ]( Q2 )---------------[TON]( t, 5s )--( )( Q3 )--+
        11:1 network: the grammar has no `[TON]`; the grammar has contacts and coils of single tags only
        1:1 tag `start`: the grammar knows names such as I0, M0 and Q0 only; it is `I0` there
    "#]]
    .assert_eq(&written);
    let lines: Vec<&str> = written.lines().filter(|line| line.starts_with("start")).collect();
    expect![[r#"
        VAR_INPUT
            I0 : BOOL := TRUE;
            I5 : BOOL;
        END_VAR
        VAR_OUTPUT
            Q2 : BOOL;
        END_VAR

        +--\--[ ]( I0 )--\--[/]( I5 )---------------------------------------( )( Q2 )--+
        |  /--[ ]( Q2 )--/                                                             |
    "#]]
    .assert_eq(&read(&lines.join("\n")));
}

#[test]
fn nothing_to_write() {
    expect![[r#"
        no network of the program can be said in the textbook grammar: it does not begin with a contact
    "#]]
    .assert_eq(&write("+--( )( y )--+\n"));
}

#[test]
fn its_files_are_recognised() {
    let is_rung = |bytes: &[u8]| Textbook.recognises(bytes);
    assert!(is_rung(b"\n# a\n| start open contact I0.1"));
    assert!(!is_rung(b"start_it"));
    assert!(!is_rung(b"+--[ ]( start )--+"));
    assert!(!is_rung(b"\xff\xfe"));
}
