//! The same with several files that see each other: whichever is edited, opened or closed, each of them says what it says
//! from scratch.

use crate::incremental::{asked, edited, settings, show};
use ladder_analysis::{
    Analysis, Exported, Exports, Others, RuleSettings, analyze_after, analyze_with, exports,
};
use ladder_syntax::{Parse, parse};
use ladder_tests::generator::Dice;
use std::collections::BTreeMap;
use std::sync::Arc;

/// A file that is open in an editor.
struct Open {
    text: String,
    parse: Arc<Parse>,
    analysis: Analysis,
    exports: Arc<Exports>,
}

/// Files of one workspace. As in the server, an edit has the others looked at again if it concerns them.
#[derive(Default)]
pub(crate) struct Files {
    open: BTreeMap<&'static str, Open>,
    exported: Arc<Exported>,
    settings: RuleSettings,
}

impl Files {
    /// A file is opened, or its text becomes another.
    pub(crate) fn becomes(&mut self, name: &'static str, text: String) {
        let others = self.others_of(name);
        let before = self.open.remove(name);
        let parsed = Arc::new(match &before {
            Some(before) => before.parse.updated(&before.text, &text),
            None => parse(&text),
        });
        let known = before.as_ref().map(|before| &before.analysis);
        let analysis = analyze_after(known, &parsed, name, &others, &self.settings);
        let shown = Arc::new(Exports::of_edited(&analysis.context, name));
        let concerned = before.is_none_or(|before| self.exported.concerns(&before.exports, &shown));
        let open = Open {
            text,
            parse: parsed,
            analysis,
            exports: shown,
        };
        self.open.insert(name, open);
        if concerned {
            self.look_again();
        }
        self.check();
    }

    /// A file is closed, and there is none on the disk.
    pub(crate) fn close(&mut self, name: &'static str) {
        self.open.remove(name);
        self.look_again();
        self.check();
    }

    /// The settings of the workspace change.
    pub(crate) fn are_set(&mut self, settings: RuleSettings) {
        self.settings = settings;
        self.look_again();
        self.check();
    }

    /// The text of a file that is open.
    pub(crate) fn text(&self, name: &str) -> &str {
        &self.open[name].text
    }

    fn look_again(&mut self) {
        let shown = self.open.values().map(|open| Arc::clone(&open.exports));
        self.exported = Arc::new(Exported::new(shown.collect()));
        for (name, open) in &mut self.open {
            let others = self.exported.others_of(name);
            let before = Some(&open.analysis);
            open.analysis = analyze_after(before, &open.parse, name, &others, &self.settings);
        }
    }

    fn others_of(&self, name: &str) -> Others {
        self.exported.others_of(name)
    }

    /// Compares all files with an analysis of everything from scratch.
    fn check(&self) {
        let parsed = self
            .open
            .iter()
            .map(|(name, open)| (*name, Arc::new(parse(&open.text))));
        let parsed: BTreeMap<&str, Arc<Parse>> = parsed.collect();
        let shown = parsed.iter().map(|(name, parse)| Arc::new(exports(parse, name)));
        let exported = Arc::new(Exported::new(shown.collect()));
        for (name, open) in &self.open {
            let others = exported.others_of(name);
            let fresh = analyze_with(&parsed[name], name, &others, &self.settings);
            let texts = || {
                let all = self.open.iter();
                let all: Vec<String> = all
                    .map(|(name, open)| format!("== {name}\n{}", open.text))
                    .collect();
                all.join("\n")
            };
            let (shown, wanted) = (show(&open.analysis), show(&fresh));
            assert_eq!(here(&shown), here(&wanted), "{name} of\n{}", texts());
            let alone = exports(&parsed[name], name);
            assert!(
                open.exports.says_the_same(&alone),
                "{name} of\n{}\n{:#?}\n{alone:#?}",
                texts(),
                open.exports
            );
        }
    }
}

/// Without the places in other files: those that only moved are no reason to look at a file again.
fn here(shown: &str) -> String {
    let mut pieces = shown.split("Location { file: ");
    let mut here = pieces.next().unwrap_or_default().to_owned();
    for piece in pieces {
        let behind = piece.find('}').filter(|_| !piece.starts_with("0,")).unwrap_or(0);
        here.push_str(&piece[behind..]);
    }
    here
}

const MAIN: &str = "\
VAR_INPUT go : BOOL; END_VAR
VAR_OUTPUT lamp : BOOL; END_VAR
VAR t : TON; END_VAR

+--[ ]( go )--<CALL>( count )--+

+--[$Hold]( go, lamp )--[GT]( total, 3 )--( )( alarm )--+

+--[ ]( alarm )--[TON]( t, T#1s )--( )( reset )--+

+--[ ]( go )--[/]( alarm )--(S)( latched )--+
";

const LIBRARY: &str = "\
VAR_GLOBAL total : DINT; alarm, latched : BOOL; END_VAR

+--[ ]( SYS.ON )--[MOV]( 0, total )--+

+--[ ]( reset )--(R)( latched )--+

+--<FUN>( count )--[ADD]( total, total, 1 )--+

FUNCTION_BLOCK [$Hold]
VAR_INPUT a : BOOL; END_VAR
VAR_OUTPUT q : BOOL; END_VAR
VAR_EXTERNAL total : DINT; END_VAR
+--[ ]( a )--[GT]( total, 5 )--(S)( q )--+
END_FUNCTION_BLOCK
";

const GLOBALS: &str = "\
VAR_GLOBAL reset : BOOL; total : INT; END_VAR
VAR_GLOBAL CONSTANT most : DINT := 5; END_VAR

+--[ ]( first )--( )( second )--+

+--[GT]( total, most )--(R)( latched )--+
";

/// What a hand puts in that concerns other files.
const SEEN: [&str; 12] = [
    "VAR_GLOBAL alarm : BOOL; END_VAR\n",
    "VAR_GLOBAL go : BOOL; END_VAR\n",
    "VAR_EXTERNAL total : DINT; END_VAR\n",
    "VAR_EXTERNAL reset : INT; END_VAR\n",
    "+--[ ]( alarm )--( )( reset )--+\n",
    "+--<CALL>( count )--+\n",
    "+--<FUN>( count )--+\n",
    "+--[$Hold]( reset, alarm )--+\n",
    "+--[ ]( latched )--[/]( latched )--( )( lamp )--+\n",
    "FUNCTION_BLOCK [$Hold]\nVAR_INPUT a : INT; END_VAR\n+--[ ]( EN )--( )( ENO )--+\nEND_FUNCTION_BLOCK\n",
    "+--[MOV]( 7, total )--+\n",
    "T",
];

fn edited_here(text: &str, dice: &mut Dice) -> String {
    if dice.one_in(2) {
        return edited(text, dice);
    }
    let lines: Vec<&str> = text.split_inclusive('\n').collect();
    let at = dice.below(lines.len() + 1);
    let piece = dice.of(&SEEN);
    [&lines[..at], &[piece], &lines[at..]].concat().concat()
}

#[test]
fn edits_of_several_files() {
    let originals = [("globals", GLOBALS), ("library", LIBRARY), ("main", MAIN)];
    for seed in 0..asked(40) {
        let mut dice = Dice::new(seed);
        let mut files = Files::default();
        for step in 0..25 {
            let (name, original) = dice.of(&originals);
            if dice.one_in(10) {
                files.are_set(settings(&mut dice));
            }
            match files.open.get(name) {
                None => files.becomes(name, original.to_owned()),
                Some(_) if dice.one_in(8) => files.close(name),
                Some(_) if step % 4 == 3 => files.becomes(name, original.to_owned()),
                Some(open) => {
                    let next = edited_here(&open.text, &mut dice);
                    files.becomes(name, next);
                }
            }
        }
    }
}

/// Letters come and go in networks of a file while a global that they name is in another.
#[test]
fn typing_in_a_file_that_sees_another() {
    for seed in 0..asked(40) / 4 {
        let mut dice = Dice::new(seed);
        let mut files = Files::default();
        files.becomes("library", LIBRARY.to_owned());
        files.becomes("main", MAIN.to_owned());
        if dice.one_in(2) {
            files.becomes("globals", GLOBALS.to_owned());
        }
        for _ in 0..6 {
            let (name, original) = dice.of(&[("main", MAIN), ("library", LIBRARY)]);
            let places: Vec<usize> = original.match_indices(" )").map(|(at, _)| at).collect();
            let at = dice.of(&places);
            let letters = dice.of(&["5", "xy", " )--[ ]( alarm", ", total", ".Q"]);
            for typed in 1..=letters.len() {
                let mut text = original.to_owned();
                text.insert_str(at, &letters[..typed]);
                files.becomes(name, text);
            }
            files.becomes(name, original.to_owned());
        }
    }
}

/// Files without a mistake, so that what one of them does with the tags, functions and blocks of another decides about
/// findings there: what begins each, and rungs and definitions that come and go.
const PIECES: [(&str, &str, &[&str]); 3] = [
    (
        "blocks",
        "VAR_INPUT key : BOOL; END_VAR\nVAR_OUTPUT horn : BOOL; END_VAR\n\n+--[ ]( key )--( )( horn )--+\n\n",
        &[
            "FUNCTION_BLOCK [$Hold]\nVAR_INPUT a : BOOL; END_VAR\nVAR_OUTPUT q : BOOL; END_VAR\n+--[ ]( a )--( )( q )--+\nEND_FUNCTION_BLOCK\n\n",
            "FUNCTION_BLOCK [$Twice]\nVAR_IN_OUT a : BOOL; END_VAR\n+--[/]( a )--(S)( a )--+\nEND_FUNCTION_BLOCK\n\n",
            "+--[ ]( key )--<CALL>( count )--+\n\n",
        ],
    ),
    (
        "library",
        "VAR_GLOBAL ready, done : BOOL; total : DINT; END_VAR\n\n",
        &[
            "+--[ ]( ready )--( )( done )--+\n\n",
            "+--[$Hold]( ready, done )--+\n\n",
            "+--[GT]( total, 3 )--( )( done )--+\n\n",
            "+--<FUN>( count )--[ADD]( total, 1, total )--+\n\n",
        ],
    ),
    (
        "main",
        "VAR_INPUT go, off : BOOL; END_VAR\nVAR_OUTPUT lamp, beep : BOOL; END_VAR\n\n+--[ ]( go )--( )( beep )--+\n\n",
        &[
            "+--[ ]( go )--( )( ready )--+\n\n",
            "+--[ ]( done )--( )( lamp )--+\n\n",
            "+--[ ]( off )--<CALL>( count )--+\n\n",
            "+--[$Hold]( go, lamp )--+\n\n",
            "+--[$Twice]( lamp )--[ ]( off )--+\n\n",
            "+--[$Hold]( off, ready )--[MOV]( 0, total )--+\n\n",
        ],
    ),
];

#[test]
fn what_others_use_comes_and_goes() {
    for seed in 0..asked(40) / 2 {
        let mut dice = Dice::new(seed);
        let mut files = Files::default();
        let mut there: BTreeMap<(&str, usize), bool> = BTreeMap::new();
        for _ in 0..20 {
            let (name, head, pieces) = dice.of(&PIECES);
            if dice.one_in(10) && files.open.contains_key(name) {
                files.close(name);
                continue;
            }
            let piece = dice.below(pieces.len());
            let is_there = there.entry((name, piece)).or_default();
            *is_there = !*is_there;
            let chosen = (0..pieces.len()).filter(|piece| there.get(&(name, *piece)) == Some(&true));
            // Where no file has tags for all, an edit of one is followed without a look at its whole text.
            let head = if seed % 2 == 0 {
                head.to_owned()
            } else {
                head.replace("VAR_GLOBAL", "VAR")
            };
            let text = chosen.fold(head, |text, piece| text + pieces[piece]);
            files.becomes(name, text);
        }
    }
}
