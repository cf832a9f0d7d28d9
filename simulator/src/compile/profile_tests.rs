//! A program of the profile `iec` is compiled to what it was before there were others.

use super::compile;
use crate::code::Instr;
use expect_test::expect;
use ladder_analysis::analyze;
use std::sync::Arc;

const PROGRAM: &str = "\
VAR start, stop, run, late, full, r : BOOL; t : TON; c : CTU; n, m : DINT; x : REAL; END_VAR
+--[ ]( start )--[/]( stop )--(S)( run )--( )( late )--+
+--[P]( start )--[TON]( t, T#1s, R := r )--[CTU]( c, 3 )--( )( full )--+
+--[P]( start )--[DIV]( n, n, m )--[MUL]( x, x, 2.0 )--[LUT]( n, m, 1, 2 )--+
+--[NOT]( n, m )--(RES)( t )--(RES)( c )--<MCR>--+
+--[USND]( n )--[URCV]( n )--[FMT]( 'a %d', n )--+
";

fn code(profile: &str) -> String {
    let text = format!("# ladder: profile {profile} #\n{PROGRAM}");
    let analysis = analyze(&Arc::new(ladder_syntax::parse(&text)), "test.clad");
    let program = analysis.program().expect("it has no errors");
    let compiled = compile(program, 10_000_000).expect("it can be compiled");
    let names = compiled.code.instrs.iter().map(|instr| match instr {
        Instr::Routine { routine, .. } => format!("{routine:?}"),
        Instr::Integer { op, .. } | Instr::IntegerWhen { op, .. } => format!("{op:?}"),
        other => {
            let text = format!("{other:?}");
            text.split([' ', '{', '(']).next().unwrap_or_default().to_owned()
        }
    });
    names.collect::<Vec<_>>().join(" ")
}

#[test]
fn nothing_is_added_for_other_profiles() {
    expect!["Rail Contact NegatedContact Set Contact Coil Rail Rising MoveBit Ton Ctu Coil Rail Rising Div RealWhen Powered SelectWord Move Xor Clear Clear Mcr Rail Powered Send Powered Receive Powered Convert Powered SendText Finish"].assert_eq(&code("iec"));
}
