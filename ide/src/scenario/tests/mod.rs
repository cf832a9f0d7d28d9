//! Features of scenario files, each at a cursor.

mod completion;
mod hover;
mod places;
mod plants;
mod properties;

use super::{Scenarios, scenario_completions};
use crate::fixture::Fixture;
use ladder_simulator::scenario::parse;
use ladder_syntax::TextSize;

const PLANT: &str = "\
%% main.clad
VAR_INPUT start : BOOL; # the green *button* # END_VAR
VAR_OUTPUT run : BOOL; END_VAR
VAR warm : TON; total : DINT; list : ARRAY[1..2] OF INT; END_VAR
+--[ ]( start )--[TON]( warm, 5s )--( )( run )--+
+--[ ]( run )--[ADD]( total, total, 1 )--[MOV]( list[1], 2 )--+
+--<CALL>( count )--+
%% lib.clad
VAR total, go : BOOL; list : ARRAY[1..2] OF INT; END_VAR
+--<FUN>( count )--[ ]( go )--( )( total )--+
%% other.ladder-test
program main.clad
scenario \"other\"
start _-
run => _-
";

/// The workspace of [`PLANT`] with one more file of scenarios, in which the cursor is.
struct Asked {
    fixture: Fixture,
    text: String,
    offset: TextSize,
}

impl Asked {
    fn at(text: &str) -> Asked {
        let at = text.find("$0").expect("a cursor");
        let text = text.replacen("$0", "", 1);
        let fixture = Fixture::new(&format!("{PLANT}%% main.ladder-test\n{text}"));
        Asked {
            fixture,
            text,
            offset: TextSize::new(at as u32),
        }
    }

    /// Asks, as an editor does: of a text that was read once, and of all files of the workspace.
    fn ask<T>(&self, question: impl FnOnce(&Scenarios<'_>) -> T) -> T {
        question(&Scenarios {
            text: &self.text,
            suite: &parse(&self.text),
            program: Some(&self.fixture.files[0].0.context),
            workspace: &self.fixture.others(0),
        })
    }

    fn completions(&self, trigger: Option<char>) -> String {
        let programs = ["a.clad".to_owned(), "main.clad".to_owned()];
        let found = self.ask(|it| scenario_completions(it, self.offset, &programs, trigger));
        let item = |it: &crate::completion::Completion| {
            format!("{}|{}|{}\n", it.label, it.detail, it.text.snippet())
        };
        found.items.iter().map(item).collect::<Vec<_>>().concat()
    }
}

const HEAD: &str = "program main.clad\nstep 100ms\n\nscenario \"one\"\n";
