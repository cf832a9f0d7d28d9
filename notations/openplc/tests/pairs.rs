//! The programs of OpenPLC Editor 4 become the same ladder text as the XML that the editor exports of them.

use expect_test::{Expect, expect};
use ladder_format::Options;
use ladder_notation::{Notation, Source, convert};
use ladder_notation_openplc::OpenPlc;
use ladder_notation_plcopen::Plcopen;
use std::path::{Path, PathBuf};

fn corpus() -> Option<PathBuf> {
    let corpus = std::env::var_os("LADDER_CORPUS").map(PathBuf::from);
    if corpus.is_none() {
        eprintln!("skipped: LADDER_CORPUS names no folder of real programs");
    }
    corpus
}

/// The ladder text of a file, and a line for each remark.
#[track_caller]
fn text(notation: &dyn Notation, bytes: &[u8]) -> String {
    let source = Source::alone("main", bytes);
    match convert(notation, &source, &Options::default()) {
        Ok(converted) => {
            let remarks = converted
                .report
                .remarks()
                .map(|entry| format!("{} {}: {:?}\n", entry.place, entry.element, entry.outcome));
            let remarks: String = remarks.collect();
            converted.written.text + &remarks
        }
        Err(error) => error.to_string(),
    }
}

/// What the two say alike: the XML has a task, and lost the comments on rungs.
fn program(file: &Path, notation: &dyn Notation) -> String {
    let bytes = std::fs::read(file).unwrap_or_else(|error| panic!("{}: {error}", file.display()));
    let text = text(notation, &bytes);
    let lines = text.lines().filter(|line| !line.starts_with("# "));
    let lines = lines.skip_while(|line| line.is_empty());
    lines.collect::<Vec<_>>().join("\n")
}

#[test]
fn the_same_text_as_from_xml() {
    let Some(corpus) = corpus() else { return };
    let mut different = String::new();
    // Practice 11 was edited after its export.
    for name in ["01", "02", "03", "04", "05", "06", "07", "10", "14", "15"]
        .map(|it| format!("practice{it}"))
        .into_iter()
        .chain(["session01".to_owned()])
    {
        let json = program(
            &corpus.join(format!("openplc-json/kato.{name}.main.ld")),
            &OpenPlc,
        );
        let xml = program(&corpus.join(format!("plcopen-xml/kato.{name}.xml")), &Plcopen);
        if json != xml {
            different.push_str(&format!("{name}:\n{json}\n{xml}\n"));
        }
    }
    assert!(different.is_empty(), "{different}");
}

/// Networks, contacts, of these negated, coils.
#[test]
fn counts_of_programs_without_xml() {
    let Some(corpus) = corpus() else { return };
    for (name, expected) in [
        ("08", [1, 2, 0, 1]),
        // Two parallels in series end at the right rail.
        ("09", [1, 4, 0, 0]),
        ("11", [2, 8, 1, 2]),
        ("12", [2, 5, 0, 2]),
        ("13", [2, 6, 1, 2]),
    ] {
        let text = program(
            &corpus.join(format!("openplc-json/kato.practice{name}.main.ld")),
            &OpenPlc,
        );
        let networks = text.lines().filter(|line| line.starts_with('+')).count();
        let count = |sign: &str| text.matches(sign).count();
        let counts = [networks, count("[ ]") + count("[/]"), count("[/]"), count("( )(")];
        assert_eq!(counts, expected, "{name}\n{text}");
    }
}

#[track_caller]
fn check(text_of_file: &str, expected: Expect) {
    expected.assert_eq(&text(&OpenPlc, text_of_file.as_bytes()));
}

#[test]
fn blocks_and_variables() {
    check(
        r#"PROGRAM main
VAR
    start : bool; (* { not a rung } *)
    t1 : TON;
    done : bool AT %QX0.0;
    n : ARRAY [0..3] OF int;
END_VAR
{"name":"main","rungs":[{"comment":"the timer","nodes":[
{"id":"l","type":"powerRail","data":{"variant":"left"}},
{"id":"c","type":"contact","position":{"x":50,"y":30},"data":{"variant":"risingEdge","variable":{"name":"start"}}},
{"id":"t","type":"block","position":{"x":90,"y":30},"data":{"variable":{"name":"t1"},"variant":{"name":"TON","type":"function-block","variables":[
 {"name":"IN","class":"input"},{"name":"PT","class":"input"},{"name":"Q","class":"output"},{"name":"ET","class":"output"}]}}},
{"id":"pt","type":"variable","position":{"x":40,"y":60},"data":{"variant":"input","variable":{"name":"T#1s"},"block":{"id":"t","handleId":"PT"}}},
{"id":"q","type":"coil","position":{"x":190,"y":30},"data":{"variant":"set","variable":{"name":"done"}}},
{"id":"x","type":"wormhole","data":{}},
{"id":"r","type":"powerRail","data":{"variant":"right"}}],
"edges":[{"source":"l","target":"c"},{"source":"c","sourceHandle":"output","target":"t","targetHandle":"IN"},
{"source":"t","sourceHandle":"Q","target":"q","targetHandle":"input"},{"source":"q","target":"r"},{"source":"q","target":"nowhere"}]}]}
END_PROGRAM
"#,
        expect![[r#"
            VAR
                start           : BOOL;  # { not a rung } #
                t1              : TON;
                done  AT %QX0.0 : BOOL;
                n               : ARRAY[0..3] OF INT;
            END_VAR

            # the timer #
            # wormhole, which has no counterpart here #
            +--[P]( start )--------------------------------[TON]( t1, T#1s )--(S)( done )--+
            15:1 wormhole: Refused("it has no counterpart")
            18:99 edge from q to nowhere: Refused("no element of the rung has this id")
        "#]],
    );
}

#[test]
fn what_is_no_program() {
    expect!["2:12: these are no rungs in JSON: expected value"]
        .assert_eq(&text_of("PROGRAM main\n{\"rungs\": [}"));
    expect!["the file has no rungs: a JSON object comes after the variables"]
        .assert_eq(&text_of("PROGRAM main\nVAR\nEND_VAR\n"));
    expect!["1:1: the file begins with `PROGRAM`, `FUNCTION_BLOCK` or `FUNCTION`"]
        .assert_eq(&text_of("VAR\nEND_VAR\n{\"rungs\": []}"));
}

fn text_of(file: &str) -> String {
    text(&OpenPlc, file.as_bytes())
}

#[test]
fn a_variable_without_a_name_is_nothing() {
    let field = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/corpus/field/output_pin_left_blank");
    let [blank, named] = ["blank.ld", "named.ld"].map(|name| {
        let bytes = std::fs::read(field.join(name)).expect("the file can be read");
        text(&OpenPlc, &bytes)
    });
    expect![[r#"
        VAR
            go   : BOOL;
            done : BOOL;
            t1   : TON;
            x    : TIME;
        END_VAR

        +--[ ]( go )---------------------------------[TON]( t1, T#50ms )--( )( done )--+
    "#]]
    .assert_eq(&blank);
    expect![[r#"
        VAR
            go   : BOOL;
            done : BOOL;
            t1   : TON;
            x    : TIME;
        END_VAR

        +--[ ]( go )---------------------------------[TON]( t1, T#50ms )--( )( done )--+

        +-----------------------------------------------------------[MOV]( x, t1.ET )--+
    "#]]
    .assert_eq(&named);
}

/// A block that is written in ST runs where it is drawn.
#[test]
fn a_text_in_a_box() {
    let json = r#"{"rungs":[{"nodes":[
{"id":"l","type":"powerRail","data":{"variant":"left"}},
{"id":"c","type":"contact","position":{"x":10,"y":0},"data":{"variant":"default","variable":{"name":"a"}}},
{"id":"e","type":"execute","position":{"x":20,"y":0},"data":{"code":"n := n + 1;\nIF n > 9 THEN\n  n := 0;\nEND_IF;"}},
{"id":"o","type":"coil","position":{"x":30,"y":0},"data":{"variant":"default","variable":{"name":"b"}}}],
"edges":[{"source":"l","target":"c"},{"source":"c","target":"e","targetHandle":"EN"},{"source":"e","sourceHandle":"ENO","target":"o"}]}]}"#;
    let file = format!("PROGRAM main\nVAR a, b : BOOL; n : INT; END_VAR\n{json}\nEND_PROGRAM\n");
    expect![[r#"
        VAR
            a     : BOOL;
            b     : BOOL;
            n     : INT;
            power : BOOL;  # the power after a block #
        END_VAR

        +--[ ]( a )--( )( power )--[NOT]-------------------------------<JMP>( past1 )--+

        +----------------------------------------------------------[CALC]( n, n + 1 )--+
        +--[GT]( n, 9 )-------------------------------------------------[MOV]( n, 0 )--+

        +--<LBL>( past1 )--[ ]( power )--------------------------------------( )( b )--+
    "#]]
    .assert_eq(&text(&OpenPlc, file.as_bytes()));
}
