//! Programs with a piece missing, doubled or exchanged: whatever comes of it, findings lie in the text, fixes
//! can be made, and what has no errors is whole.

use ladder_analysis::findings::fix;
use ladder_analysis::program::Step;
use ladder_analysis::{Analysis, analyze, link};
use ladder_format::{Options, apply};
use ladder_syntax::parse;
use std::sync::Arc;

const PROGRAMS: [&str; 4] = [
    "# Start/stop #\nVAR_INPUT start, stop : BOOL; END_VAR\nVAR\n    run : BOOL;\n    t : TON;\nEND_VAR\n\n\
     +--\\--[ ]( start )--\\--[/]( stop )--( )( run )--+\n|  /--[ ]( run )----/                        |\n\n\
     +--[ ]( run )--[TON]( t, T#5s, R := stop )--[ ]( t.Q )--( )( Q1 )--+\n",
    "+--\\-----\\--[ ]( a )--\\-----\\--( )( y )--+\n|  /--\\  /--[ ]( b )--/  \\--/            |\n|     /--[ ]( c )--------/               |\n\n\
     +--[EQ]( n, 5 )--[CALC]( m, n * ( 3 + k ) )--<JMP>( out )--+\n\n+--<LBL>( out )--[MOV]( s, 'text' )--<CALL>( f )--+\n\n\
     +--<FUN>( f )--[CTU]( c1, 10 )--(S)( z )--<RET>--+\n",
    "FUNCTION_BLOCK [$Debounce]\nVAR_INPUT raw : BOOL; wait : TIME; END_VAR\nVAR_OUTPUT clean : BOOL; END_VAR\nVAR t : TON; END_VAR\n\
     +--[ ]( EN )--[ ]( raw )--[TON]( t, wait )--( )( clean )--( )( ENO )--+\nEND_FUNCTION_BLOCK\n\n\
     +--[$Debounce]( button, T#20ms, pressed )--( )( light )--+\n",
    "VAR\n    f : ARRAY[1..8] OF BOOL;\n    w : WORD := 16#FF;\nEND_VAR\n\
     +--[ ]( f[1..3] )--[PACK]( w, f[1..8] )--[ ]( w.3 )# shown #--( )( f[2] )--+  # two\nlines #\n",
];

/// What a mutation puts in.
const PIECES: [&str; 26] = [
    "",
    "\\",
    "/",
    "-",
    "+",
    "|",
    " ",
    "\n",
    "(",
    ")",
    "[",
    "]",
    "<",
    ">",
    "#",
    ",",
    ":=",
    ";",
    "'",
    "a",
    "5",
    "[|]",
    "[\\]",
    "END_VAR\n",
    "VAR\n",
    "é",
];

fn check(text: &str) {
    let analysis = Arc::new(analyze(&Arc::new(parse(text)), "test.clad"));
    for found in analysis.diagnostics() {
        assert!(
            text.get(std::ops::Range::<usize>::from(found.range)).is_some(),
            "{found:?} in:\n{text}"
        );
        for related in &found.related {
            assert!(
                text.get(std::ops::Range::<usize>::from(related.range)).is_some(),
                "{found:?} in:\n{text}"
            );
        }
        for fix in &found.fixes {
            for edits in fix.edits.windows(2) {
                assert!(
                    edits[0].range.end() <= edits[1].range.start(),
                    "{found:?} in:\n{text}"
                );
            }
            for edit in &fix.edits {
                assert!(
                    text.get(std::ops::Range::<usize>::from(edit.range)).is_some(),
                    "{found:?} in:\n{text}"
                );
            }
            let edits = fix::aligned(text, fix, &Options::default());
            apply(text, &edits);
        }
    }
    whole(text, &analysis);
}

/// A program that has no errors has every block of its networks, and those of the library that it uses.
fn whole(text: &str, analysis: &Arc<Analysis>) {
    let program = link(analysis, &|_| None);
    assert_eq!(program.is_ok(), !analysis.has_errors());
    let Ok(program) = program else { return };
    for network in &program.networks {
        let steps = network
            .steps
            .iter()
            .filter(|step| matches!(step, Step::Block { .. }));
        assert_eq!(steps.count(), network.blocks.len(), "in:\n{text}");
        for block in &network.blocks {
            if let ladder_analysis::program::BlockKind::Instruction(row) = block.kind {
                let given = block.arguments.iter().filter(|bound| {
                    bound
                        .operand
                        .is_some_and(|operand| row.named(operand.name).is_none())
                });
                assert!(row.takes(given.count()), "{} in:\n{text}", row.mnemonic);
            }
        }
    }
}

#[test]
fn whatever_comes_of_it() {
    let mut state = 7u32;
    let mut next = move |below: usize| {
        state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        (state >> 8) as usize % below
    };
    for program in PROGRAMS {
        check(program);
        let places: Vec<usize> = program.char_indices().map(|(at, _)| at).collect();
        for round in 0..700 {
            let mut text = program.to_owned();
            // From the back, so that the places stay true; one to three errors.
            let mut at: Vec<usize> = (0..=round % 3).map(|_| places[next(places.len())]).collect();
            at.sort_unstable();
            for at in at.into_iter().rev() {
                let long = if next(2) == 0 { 0 } else { 1 + next(3) };
                let end = (at + long).min(text.len());
                if text.is_char_boundary(at) && text.is_char_boundary(end) {
                    text.replace_range(at..end, PIECES[next(PIECES.len())]);
                }
            }
            check(&text);
        }
    }
}

/// Wire between brackets: fixes come to an end, and what they leave has no fix.
#[test]
fn fixes_of_wire_between_brackets_come_to_an_end() {
    for sign in ["|", "\\", " | ", "\\\\", "-", "--", "||"] {
        for contact in ["[ ]", "[/]"] {
            let mut text = PROGRAMS[0].replacen(contact, &format!("[{sign}]"), 1);
            let mut rounds = 0;
            loop {
                let analysis = analyze(&Arc::new(parse(&text)), "test.clad");
                let errors = analysis.errors();
                let Some(fix) = errors.flat_map(|found| &found.fixes).next() else {
                    break;
                };
                text = apply(&text, &fix::aligned(&text, fix, &Options::default()));
                rounds += 1;
                assert!(rounds < 4, "{text}");
            }
            let is_sound = !analyze(&Arc::new(parse(&text)), "test.clad").has_errors();
            assert_eq!(is_sound, sign == "\\", "{text}");
        }
    }
}
