//! One slip is reported once, whatever it does to what is after it.

use crate::check::{check, clean};
use expect_test::expect;

#[test]
fn on_its_line() {
    check(
        "+--\\--[ ] start )--\\--[/]( stop )--( )( run )--+\n|  /--[ ]( run )---/                          |\n",
        expect![[r#"
            > +--\--[ ] start )--\--[/]( stop )--( )( run )--+
                        ^^^^^^^ error[unexpected-character]: `start )` means nothing on a rung
                help: a rung is drawn with - + | \ / and blocks; text is in # comments #
        "#]],
    );
    check(
        "+--[ ]( run )--TON]( t, T#5s, R := stop )--[ ]( t.Q )--( )( lamp )--+\n",
        expect![[r#"
            > +--[ ]( run )--TON]( t, T#5s, R := stop )--[ ]( t.Q )--( )( lamp )--+
                             ^^^^ error[unexpected-character]: `TON]` means nothing on a rung
                help: a rung is drawn with - + | \ / and blocks; text is in # comments #
        "#]],
    );
    check(
        "+--[ ]( a )--[\\]( b )--( )( y )--+\n",
        expect![[r#"
            > +--[ ]( a )--[\]( b )--( )( y )--+
                           ^^^ error[unclosed-block]: `[\]` is no block
                help: a contact that lets power through while its tag is low is [/]
                fix: Write `[/]`
                  +--[ ]( a )--[/]( b )------------------------------------------------( )( y )--+
        "#]],
    );
    check(
        "+--[EQ]( n, 5 )--[CALC]( m, n * 3 + k ) )--( )( y )--+\n",
        expect![[r#"
            > +--[EQ]( n, 5 )--[CALC]( m, n * 3 + k ) )--( )( y )--+
                                                      ^ error[unexpected-character]: `)` means nothing on a rung
                help: a rung is drawn with - + | \ / and blocks; text is in # comments #
        "#]],
    );
    check(
        "+--[ ]( a )--[MOV]( s, text' )--( )( y )--+\n",
        expect![[r#"
            > +--[ ]( a )--[MOV]( s, text' )--( )( y )--+
                                         ^ error[bad-literal]: this text is not closed: `'` is missing
                help: a text ends on its own line; a quote in it is written $'
                fix: Insert `'`
                  +--[ ]( a )--------------------------------------[MOV]( s, text'' )--( )( y )--+
        "#]],
    );
    check(
        "+--[TON]( t- T#5s )--( )( y )--+\n",
        expect![[r#"
            > +--[TON]( t- T#5s )--( )( y )--+
                 ^^^^^^^^^^^^^^^^ error[bad-arity]: [TON] takes 2 operands, 1 is given
                help: it is written [TON]( t, PT, R := )
                fix: Add PT
                  +-------------------------------------------[TON]( t - T#5s, T#1s )--( )( y )--+
        "#]],
    );
    check(
        "+--[ ]( a b c )--( )( y, , )--+\n",
        expect![[r#"
            > +--[ ]( a b c )--( )( y, , )--+
                        ^ error[bad-operand]: a comma is missing before this operand
                help: operands are separated by commas
            > +--[ ]( a b c )--( )( y, , )--+
                                       ^ error[bad-operand]: an operand is missing here
                help: write the operand, or take the comma away
        "#]],
    );
}

#[test]
fn labels_and_functions_that_cannot_be_read() {
    check(
        "+--[ ]( a )--<JMP>( out )--+\n\n+--<LBL> out )--( )( y )--+\n",
        expect![[r#"
            > +--<LBL> out )--( )( y )--+
                       ^^^^^ error[unexpected-character]: `out )` means nothing on a rung
                help: a rung is drawn with - + | \ / and blocks; text is in # comments #
        "#]],
    );
    check(
        "+--[ ]( a )--<JMP>( out )--+\n\n+--<LBK>( out )--( )( y )--+\n",
        expect![[r#"
            > +--<LBK>( out )--( )( y )--+
                 ^^^^^ error[unknown-instruction]: there is no instruction <LBK>
                help: did you mean <LBL> (label)?
        "#]],
    );
    check(
        "+--[ ]( a )--<JMP>( out )--+\n\n+--<LBL>( o t )--( )( y )--+\n",
        expect![[r#"
            > +--<LBL>( o t )--( )( y )--+
                          ^ error[bad-operand]: a comma is missing before this operand
                help: operands are separated by commas
        "#]],
    );
    check(
        "+--<CALL>( f )--+\n\n+--<FUN>( )--( )( y )--+\n",
        expect![[r#"
            > +--<FUN>( )--( )( y )--+
                 ^^^^^^^^ error[bad-arity]: <FUN> takes 1 operand, none is given
                help: it is written <FUN>( name )
                fix: Add name
                  +--<FUN>( ? )--( )( y )--+
        "#]],
    );
}

#[test]
fn frames_of_sections() {
    check(
        "VAR_INPT\n    a : BOOL;\nEND_VAR\nVAR x : BOOL; END_VAR\n\n+--[ ]( a )--( )( x )--+\n",
        expect![[r#"
            > VAR_INPT
              ^^^^^^^^ error[unexpected-character]: `VAR_INPT` is outside of any block
                help: did you mean VAR_INPUT?
                fix: Replace with VAR_INPUT
                  VAR_INPUT
        "#]],
    );
    check(
        "VAR\n    a : BOOL;\nEND_VR\n\n+--[ ]( a )--( )( x )--+\n",
        expect![[r#"
            > END_VR
              ^^^^^^ error[bad-declaration]: `END_VR` is not a declaration
                help: did you mean END_VAR?
                fix: Replace with END_VAR
                  END_VAR
        "#]],
    );
    check(
        "VAR_INPUT a : BOOL; END_VAR+--[ ]( a )--( )( y )--+\n",
        expect![[r#"
            > VAR_INPUT a : BOOL; END_VAR+--[ ]( a )--( )( y )--+
                                         ^ error[bad-declaration]: `+` does not belong onto this line
                help: rungs and sections begin on a line of their own
        "#]],
    );
}

#[test]
fn frames_of_blocks() {
    let rest = "VAR_INPUT\n    raw : BOOL;\nEND_VAR\n+--[ ]( EN )--[ ]( raw )--( )( ENO )--+\nEND_FUNCTION_BLOCK\n\n+--[$Pass]( a )--( )( y )--+\n";
    check(
        &format!("FUNCTON_BLOCK [$Pass]\n{rest}"),
        expect![[r#"
        > FUNCTON_BLOCK [$Pass]
          ^^^^^^^^^^^^^ error[unexpected-character]: `FUNCTON_BLOCK` is outside of any block
            help: did you mean FUNCTION_BLOCK?
            fix: Replace with FUNCTION_BLOCK
              FUNCTION_BLOCK [$Pass]
    "#]],
    );
    check(
        &format!("FUNCTION_BLOCK [$Pass\n{rest}"),
        expect![[r#"
            > FUNCTION_BLOCK [$Pass
                             ^^^^^^ error[unclosed-block]: `[$Pass` is not closed: `]` is missing
                help: a block is closed on its own line
                safe fix: Insert `]`
                  FUNCTION_BLOCK [$Pass]
        "#]],
    );
    let text = format!("FUNCTION_BLOCK [$Pass]\n{rest}");
    check(
        &text.replace("END_FUNCTION", "END-FUNCTION"),
        expect![[r#"
            > END-FUNCTION_BLOCK
              ^^^ error[unexpected-character]: `END` is outside of any block
                help: a contact is written [ ]( END ), a coil ( )( END )
        "#]],
    );
    check(
        &text.replace("raw : BOOL", "raw BOOL"),
        expect![[r#"
        >     raw BOOL;
                  ^^^^ error[bad-declaration]: expected `:` and a type, found `BOOL`
            help: a declaration is written: start : BOOL; the types are BOOL, INT, DINT, REAL, TIME, TON, CTU and others
    "#]],
    );
    check(
        &text.replace("raw : BOOL", "raw : BOL"),
        expect![[r#"
            >     raw : BOL;
                        ^^^ error[unknown-type]: there is no type `BOL`: did you mean BOOL?
                fix: Replace with BOOL
                      raw : BOOL;
        "#]],
    );
}

#[test]
fn rails() {
    check(
        "-+--[ ]( a )--( )( y )--+\n",
        expect![[r#"
            > -+--[ ]( a )--( )( y )--+
               ^ error[misplaced-rail]: `+` is in the middle of a line
                help: `+` is where a line leaves the left rail or ends at the right rail; lines are joined with \ and /
        "#]],
    );
    check(
        "+--\\[ ]( a )--( )( y )--+\n",
        expect![[r#"
            > +--\[ ]( a )--( )( y )--+
                 ^ error[unpaired-connector]: the `\` on line 1 has no partner: there is no rung below it
                help: every `\` needs a `/` on the rung below: together they join the two lines
                fix: Replace `\` with wire
                  +--[ ]( a )----------------------------------------------------------( )( y )--+
        "#]],
    );
}

#[test]
fn names_that_differ_in_capitals_only() {
    check(
        "VAR_OUTPUT red, amber : BOOL; END_VAR\nVAR state : INT; END_VAR\nVAR CONSTANT RED : INT := 0; AMBER : INT := 1; END_VAR\n\
         +--[EQ]( state, RED )--( )( red )--[MOV]( state, AMBER )--+\n+--[EQ]( AMBER, state )--( )( amber )--+\n",
        expect![[r#"
            > VAR CONSTANT RED : INT := 0; AMBER : INT := 1; END_VAR
                           ^^^ error[duplicate-declaration]: `RED` is declared twice
                help: remove one of the declarations, or give one tag another name; capitals do not tell names apart
                at 1:12 `red`: `red` is first declared here
            > VAR CONSTANT RED : INT := 0; AMBER : INT := 1; END_VAR
                                           ^^^^^ error[duplicate-declaration]: `AMBER` is declared twice
                help: remove one of the declarations, or give one tag another name; capitals do not tell names apart
                at 1:17 `amber`: `amber` is first declared here
        "#]],
    );
    check(
        "VAR CONSTANT RED : INT := 0; END_VAR\nVAR_OUTPUT red : BOOL; END_VAR\nVAR state : INT; END_VAR\n\
         +--[EQ]( state, RED )--( )( red )--+\n",
        expect![[r#"
            > VAR_OUTPUT red : BOOL; END_VAR
                         ^^^ error[duplicate-declaration]: `red` is declared twice
                help: remove one of the declarations, or give one tag another name; capitals do not tell names apart
                at 1:14 `RED`: `RED` is first declared here
        "#]],
    );
    check(
        "VAR t : TON; END_VAR\nVAR_INPUT T : BOOL; END_VAR\nVAR_OUTPUT y : BOOL; END_VAR\n\
         +--[ ]( T )--[TON]( t, T#5s )--[ ]( t.Q )--( )( y )--+\n",
        expect![[r#"
            > VAR_INPUT T : BOOL; END_VAR
                        ^ error[duplicate-declaration]: `T` is declared twice
                help: remove one of the declarations, or give one tag another name; capitals do not tell names apart
                at 1:5 `t`: `t` is first declared here
        "#]],
    );
}

#[test]
fn a_type_that_cannot_be_read() {
    check(
        "VAR x : BOLL; END_VAR\nVAR_OUTPUT y : BOOL; END_VAR\n+--[ ]( x )--[EQ]( x, 5 )--( )( y )--+\n",
        expect![[r#"
            > VAR x : BOLL; END_VAR
                      ^^^^ error[unknown-type]: there is no type `BOLL`: did you mean BOOL?
                fix: Replace with BOOL
                  VAR
                      x : BOOL;
                  END_VAR
        "#]],
    );
}

#[test]
fn connectors_that_touch_are_no_comment() {
    check(
        "+--\\--\\--[ ]( a )--( )( y )--+\n//--[ ]( b )--( )( z )--+\n",
        expect![[""]],
    );
}

#[test]
fn comments_of_other_languages() {
    check(
        "// a note: wait T#5s\n+--[ ]( a )--( )( y )--+\n",
        expect![[r#"
            > // a note: wait T#5s
              ^^^^^^^^^^^^^^^^^^^^ error[unexpected-character]: `//` begins no comment: a comment is written # .. #
                help: write the text between two `#`; it cannot hold a `#` itself
                safe fix: Write it as a comment
                  # a note: wait 5s #
        "#]],
    );
    check(
        "+--[ ]( a )--( )( y )--+\n(* two\n + lines *)\n",
        expect![[r#"
        > (* two
          ^^^^^^ error[unexpected-character]: `(*` begins no comment: a comment is written # .. #
            help: write the text between two `#`; it cannot hold a `#` itself
            safe fix: Write it as a comment
              # two
               + lines #
    "#]],
    );
    check(
        "+--[ ]( a )--( )( y )--+  ; a note\n",
        expect![[r#"
            > +--[ ]( a )--( )( y )--+  ; a note
                                        ^^^^^^^^ error[unexpected-character]: `;` begins no comment: a comment is written # .. #
                help: write the text between two `#`; it cannot hold a `#` itself
                safe fix: Write it as a comment
                  +--[ ]( a )----------------------------------------------------------( )( y )--+  # a note #
        "#]],
    );
    check(
        "VAR_INPUT\n    a : BOOL;\n    // a note\n    b : BOOL; // another\nEND_VAR\n+--[ ]( a )--[ ]( b )--( )( Q1 )--+\n",
        expect![[r#"
            >     // a note
                  ^^^^^^^^^ error[unexpected-character]: `//` begins no comment: a comment is written # .. #
                help: write the text between two `#`; it cannot hold a `#` itself
                safe fix: Write it as a comment
                      # a note #
        "#]],
    );
    for comment in [
        "// a note: see +-- below",
        "(* a note; with [TON]( t ) and a | b *)",
        "; a note",
        "/* a note, /--/ */",
        "//",
        "/// wait T#5s",
        "// +--[ ]( old )--( )( y )--+",
        "(* over\nseveral + lines\n+--[ ]( old )--( )( y )--+\n*)",
    ] {
        // On top, between networks, within a network, and at the end.
        for program in [
            format!("{comment}\n+--[ ]( a )--( )( y )--+\n"),
            format!("+--[ ]( a )--( )( y )--+\n\n  {comment}\n+--[ ]( b )--( )( z )--+\n"),
            format!("+--\\--[ ]( a )--\\--( )( y )--+\n{comment}\n|  /--[ ]( y )--/            |\n"),
            format!("+--[ ]( a )--( )( y )--+\n{comment}"),
        ] {
            assert_eq!(found(&program), 1, "in:\n{program}");
        }
        // In a section, between declarations.
        let program = format!(
            "VAR_INPUT\n    a : BOOL;\n    {comment}\n    b : BOOL;\nEND_VAR\n+--[ ]( a )--[ ]( b )--( )( Q1 )--+\n"
        );
        assert_eq!(found(&program), 1, "in:\n{program}");
    }
    // After a rung, and after a declaration.
    for comment in ["// a note", "(* a note *)", "; a note", "/* a note */"] {
        let program = format!("+--[ ]( a )--( )( y )--+  {comment}\n");
        assert_eq!(found(&program), 1, "in:\n{program}");
        let program = format!(
            "VAR_INPUT\n    a : BOOL;  {comment}\n    b : BOOL;\nEND_VAR\n+--[ ]( a )--[ ]( b )--( )( Q1 )--+\n"
        );
        assert_eq!(found(&program), 1, "in:\n{program}");
    }
}

#[test]
fn what_is_no_comment() {
    clean("+--\\--\\--( )( y )--+\n//--[ ]( a )--( )( z )--+\n");
    assert_eq!(
        found("VAR\n    a : BOOL\n    ; b : BOOL;\nEND_VAR\n+--[ ]( a )--( )( b )--+\n"),
        0
    );
}

/// How many findings there are that are errors or warnings.
fn found(program: &str) -> usize {
    let parse = std::sync::Arc::new(ladder_syntax::parse(program));
    let found = ladder_analysis::analyze(&parse, "test.clad")
        .diagnostics()
        .to_vec();
    let serious = found
        .iter()
        .filter(|found| found.severity > ladder_analysis::Severity::Info);
    serious.count()
}
