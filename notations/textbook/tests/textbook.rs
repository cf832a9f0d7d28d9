//! The textbook grammar, read and written.

use expect_test::{Expect, expect};
use ladder_format::Options;
use ladder_notation::{Foreign, Notation, Outcome, Source, convert};
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

            +--\--[ ]( I0 )--\--------------------------------------------------( )( Q0 )--+
            |  /--[ ]( I1 )--/                                                             |

            +--[ ]( Q0 )--------------------------------------------------------( )( I7 )--+
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
        1:1 tag `start`: the grammar knows names such as I0, M0 and Q0 only; it is `I0` there
        11:1 network: the grammar has no `[TON]`; the grammar has contacts and coils of single tags only
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
        no network of the program can be written in the textbook grammar: it does not begin with a contact
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

/// A coil takes all that is before it, up to a parenthesis.
#[test]
fn what_belongs_to_a_coil() {
    for (text, expected) in [
        (
            "start open contact I0.1 V open contact I1.0 & active coil Q0 end",
            expect![[r#"
                +--\--[ ]( I0 )--\--------------------------------------------------( )( Q0 )--+
                |  /--[ ]( I1 )--/                                                             |
            "#]],
        ),
        (
            "start (open contact I0.1 V open contact I1.0) & active coil Q0 end",
            expect![[r#"
                +--\--[ ]( I0 )--\--------------------------------------------------( )( Q0 )--+
                |  /--[ ]( I1 )--/                                                             |
            "#]],
        ),
        (
            "start open contact I0.1 V (open contact I1.0 & active coil Q0) end",
            expect![[r#"
                +--\--[ ]( I0 )-------------------------------------------------------------\--+
                |  /--[ ]( I1 )--------------------------------------------------( )( Q0 )--/  |
            "#]],
        ),
        (
            "start open contact I0.1 & open contact I1.0 V open contact I2.1 & active coil Q0 end",
            expect![[r#"
                +--\--[ ]( I0 )--[ ]( I1 )--\---------------------------------------( )( Q0 )--+
                |  /--[ ]( I2 )-------------/                                                  |
                1:7 textbook-precedence: the paper does not say what belongs together here: before a coil `&` takes all that is before it, between contacts it binds more tightly than `V`; put parentheses round what belongs together
            "#]],
        ),
        (
            "start open contact I0.1 V open contact I1.0 & (active coil Q0 V inactive coil Q1) end",
            expect![[r#"
                +--\--[ ]( I0 )--\--\--------------------------------------------( )( Q0 )--\--+
                |  /--[ ]( I1 )--/  /--------------------------------------------(/)( Q1 )--/  |
            "#]],
        ),
        (
            "start open contact I0.1 V open contact I1.0 & active coil Q0 & active coil Q1 end",
            expect![[r#"
                +--\--[ ]( I0 )--\---------------------------------------( )( Q0 )--( )( Q1 )--+
                |  /--[ ]( I1 )--/                                                             |
            "#]],
        ),
        (
            "start open contact I0.1 & active coil Q0 V open contact I1.0 & active coil Q1 end",
            expect![[r#"
                +--\--[ ]( I0 )---------------------------------------( )( Q0 )--\--( )( Q1 )--+
                |  /--[ ]( I1 )--------------------------------------------------/             |
                1:7 textbook-precedence: the paper does not say what belongs together here: before a coil `&` takes all that is before it, between contacts it binds more tightly than `V`; put parentheses round what belongs together
            "#]],
        ),
    ] {
        let whole = read(text);
        let network = whole.split("END_VAR\n").last().unwrap_or_default().trim_start();
        expected.assert_eq(network);
    }
}

#[test]
fn programs_over_several_lines_are_recognised_and_read() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/../../tests/corpus/field");
    let several = std::fs::read_to_string(format!("{folder}/paper_multiline.rung")).expect("it is there");
    let texts = [
        several.as_str(),
        "start closed contact I0.1 & active coil Q0 end",
        "|\nstart closed contact I0.1 & active coil Q0 end\n|\n",
        "\u{feff}|start\r\nclosed\r\ncontact I0.1\r\n&\r\nactive\tcoil Q0\r\nend|\r\n",
    ];
    let expected = read(texts[1]);
    for text in texts {
        assert!(Textbook.recognises(text.as_bytes()), "{text}");
        assert_eq!(read(text), expected, "{text}");
    }
    for other in [
        "start\nthe engine",
        "starting open",
        "start",
        "| + |\nstart open contact",
    ] {
        assert!(!Textbook.recognises(other.as_bytes()), "{other}");
    }
    check(
        "start open\n\n  # no comment\n contact",
        expect![[r#"
        1:7: `open` is followed by `contact`
    "#]],
    );
}

#[test]
fn a_program_has_a_limit_and_a_line_has_none() {
    let many = |count: usize, between: &str| {
        let contacts: Vec<String> = (0..count)
            .map(|number| format!("open contact M{number}"))
            .collect();
        format!("start ({}) & active coil Q0 end", contacts.join(between))
    };
    for between in [" V ", " & "] {
        assert!(converts(&many(255, between)));
        let refused = read(&many(20_000, between));
        assert!(refused.ends_with(": a program has at most 256 contacts and coils: make several of it, with a memory such as `M0` between them\n"), "{refused}");
    }
    // Places are found on a long line without reading it again.
    let line = "start open contact I0.1 & active coil Q0 end ".repeat(5_000);
    let source = Source::alone("test", line.as_bytes());
    let foreign = Foreign::read(&Textbook, &source).expect("it can be read");
    assert_eq!(foreign.ladder().matches("( )( Q0 )").count(), 5_000);
}

fn converts(text: &str) -> bool {
    let source = Source::alone("test", text.as_bytes());
    convert(&Textbook, &source, &Options::default()).is_ok()
}
