//! What comes first for what people begin to write.

use super::found;

const PROGRAM: &str = "\
VAR_INPUT start, stop, run_request : BOOL; level : INT; temperature : REAL; END_VAR
VAR_OUTPUT run, pump_run : BOOL; speed : INT; END_VAR
VAR warmup, run_on : TON; parts : CTU; total : DINT; state : INT; run_time, wait : TIME; flags : WORD; END_VAR
FUNCTION_BLOCK [$Tower]
VAR_INPUT go : BOOL; END_VAR
+--[ ]( go )--( )( ENO )--+
END_FUNCTION_BLOCK
";

/// What is written on the line, and what Tab puts in.
const FIRST: [(&str, &str); 62] = [
    // Blocks, by their brackets.
    ("+--[T", "[TON]"),
    ("+--[TO", "[TON]"),
    ("+--[TON", "[TON]"),
    ("+--[TOF", "[TOF]"),
    ("+--[to", "[TON]"),
    ("+--[TP", "[TP]"),
    ("+--[R", "[RTO]"),
    ("+--[RT", "[RTO]"),
    ("+--[TONR", "[RTO]"),
    ("+--[C", "[CTU]"),
    ("+--[CT", "[CTU]"),
    ("+--[CTD", "[CTD]"),
    ("+--[M", "[MOV]"),
    ("+--[MO", "[MOV]"),
    ("+--[MOD", "[MOD]"),
    ("+--[A", "[ADD]"),
    ("+--[S", "[SUB]"),
    ("+--[D", "[DIV]"),
    ("+--[G", "[GT]"),
    ("+--[GE", "[GE]"),
    ("+--[L", "[LT]"),
    ("+--[LE", "[LE]"),
    ("+--[N", "[N]"),
    ("+--[NO", "[NOT]"),
    ("+--[P", "[P]"),
    ("+--[E", "[EQ]"),
    ("+--[O", "[OSR]"),
    ("+--[XIC", "[ ]"),
    ("+--[XIO", "[/]"),
    ("+--[/", "[/]"),
    ("+--[tim", "[TON]"),
    ("+--[count", "[CTU]"),
    ("+--[$T", "[$Tower]"),
    ("+--[tow", "[$Tower]"),
    ("+--(", "( )"),
    ("+--(S", "(S)"),
    ("+--(R", "(R)"),
    ("+--(RE", "(RES)"),
    ("+--<J", "<JMP>"),
    ("+--<C", "<CALL>"),
    // The same on a bare wire.
    ("+--TO", "[TON]"),
    ("+--mo", "[MOV]"),
    ("+--coil", "( )"),
    // Operands: the declared tag that fits.
    ("+--[ ]( st", "start"),
    ("+--[ ]( sto", "stop"),
    ("+--[ ]( r", "run"),
    ("+--[ ]( run", "run"),
    ("+--[ ]( req", "run_request"),
    ("+--( )( r", "run"),
    ("+--( )( pu", "pump_run"),
    ("+--[TON]( w", "warmup"),
    ("+--[TON]( ru", "run_on"),
    ("+--[TON]( warmup, w", "wait"),
    ("+--[TON]( warmup, T", "T#1s"),
    ("+--[GT]( l", "level"),
    ("+--[MOV]( s", "speed"),
    ("+--(RES)( ", "parts"),
    // Declarations.
    ("V", "VAR_INPUT"),
    ("VAR_O", "VAR_OUTPUT"),
    ("VAR\n    a : B", "BOOL"),
    ("VAR\n    a : T", "TIME"),
    ("VAR\n    a : BOOL;\nEND", "END_VAR"),
];

#[test]
fn the_likeliest_comes_first() {
    let mut wrong = Vec::new();
    for (line, first) in FIRST {
        let (_, found) = found(&format!("{PROGRAM}{line}$0\n"));
        let labels: Vec<&str> = found.items.iter().map(|item| &*item.label).collect();
        if labels.first() != Some(&first) {
            wrong.push(format!(
                "{line}: {first} is not first of {:?}",
                &labels[..labels.len().min(6)]
            ));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// Editors rank a list by how well each proposal agrees with what is written: VS Code and Zed by a score of their own, which
/// prefers what agrees to the last letter, Neovim and Emacs by whether it agrees at all. So the order holds in all of them.
#[test]
fn every_proposal_agrees_alike_with_what_is_written() {
    for (line, _) in FIRST {
        let fixture = format!("{PROGRAM}{line}$0\n");
        let cursor = fixture.find("$0").unwrap_or_default();
        let (text, found) = found(&fixture);
        for (place, item) in found.items.iter().enumerate() {
            let written = &text[item.range.start().into()..cursor];
            assert!(item.filter.starts_with(written), "{} for {line}", item.filter);
            let is_whole = written.len() > 1 && item.filter == written;
            let before = &found.items[..place];
            assert!(
                !is_whole || before.iter().all(|before| before.filter == written),
                "{} for {line}",
                item.label
            );
        }
    }
}
