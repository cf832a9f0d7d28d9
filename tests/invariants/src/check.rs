//! Findings lie in the text, and fixes can be made: inside the text, apart from each other, and a text comes of them.
//!
//! The input is a text.

use crate::features::apart;
use crate::input;
use ladder_analysis::findings::fix;
use ladder_analysis::program::{BlockKind, Step};
use ladder_analysis::{Analysis, Diagnostic, analyze};
use ladder_format::{Options, apply};
use ladder_ide::fix_all;
use ladder_syntax::{TextRange, TextSize, parse};
use std::ops::Range;
use std::sync::Arc;

/// Of so many findings the fixes are tried: each reads the whole text.
const MOST_FIXES: usize = 40;

pub(crate) fn check(data: &[u8]) {
    let text = input::text(data);
    let analysis = analyze(&Arc::new(parse(&text)), "main.clad");
    let mut tried = 0;
    for found in analysis.diagnostics() {
        places(&text, found);
        for fix in &found.fixes {
            apart(&fix.edits, TextSize::of(text.as_str()));
            for edit in &fix.edits {
                lies_in(&text, edit.range, found);
            }
            tried += 1;
            if tried <= MOST_FIXES {
                let edits = fix::aligned(&text, fix, &Options::default());
                apart(&edits, TextSize::of(text.as_str()));
                reads(&apply(&text, &edits));
            }
        }
    }
    if let Some(action) = fix_all(&analysis) {
        let edits = action.aligned(&analysis, &text, &Options::default());
        apart(&edits, TextSize::of(text.as_str()));
        reads(&apply(&text, &edits));
    }
    whole(&text, &analysis);
}

fn places(text: &str, found: &Diagnostic) {
    assert!(!found.message.is_empty(), "{found:?} in:\n{text}");
    lies_in(text, found.range, found);
    for related in found.related.iter().filter(|place| place.file.is_none()) {
        lies_in(text, related.range, found);
    }
}

fn lies_in(text: &str, range: TextRange, found: &Diagnostic) {
    let lies = text.get(Range::<usize>::from(range)).is_some();
    assert!(lies, "{range:?} of {found:?} in:\n{text}");
}

/// A text that a fix made is parsed and analysed like any other.
fn reads(text: &str) {
    let parse = parse(text);
    assert_eq!(parse.to_string(), text);
    for found in analyze(&Arc::new(parse), "main.clad").diagnostics() {
        places(text, found);
    }
}

/// A program that has no errors has every block of its networks, with all of their operands.
fn whole(text: &str, analysis: &Analysis) {
    let Some(program) = analysis.program() else { return };
    assert!(!analysis.has_errors());
    for network in &program.networks {
        let steps = network.steps.iter();
        let steps = steps.filter(|step| matches!(step, Step::Block { .. }));
        assert_eq!(steps.count(), network.blocks.len(), "in:\n{text}");
        for block in &network.blocks {
            let BlockKind::Instruction(row) = block.kind else {
                continue;
            };
            let given = block.arguments.iter().filter(|bound| {
                let operand = bound.operand;
                operand.is_some_and(|operand| row.named(operand.name).is_none())
            });
            assert!(row.takes(given.count()), "{} in:\n{text}", row.mnemonic);
        }
    }
}
