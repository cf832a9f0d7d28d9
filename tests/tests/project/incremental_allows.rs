//! The same for comments that switch rules off: they come, go and change, and so does what they hide.

use crate::incremental::{Document, asked, settings};
use ladder_analysis::{Others, RuleSettings, analyze_with};
use ladder_syntax::parse;
use ladder_tests::generator::Dice;
use std::sync::Arc;

const NETWORKS: &[&str] = &[
    "+--[ ]( a )--( )( y )--+\n",
    "+--[ ]( a )--( )( y )--[/]( y )--( )( z )--+\n",
    "+--[ ]( b )--[/]( b )--( )( y )--+\n",
    "+--[TOM]( a )--( )( y )--+\n",
    "+--[MOV]( n, 70000 )--+\n",
    "+--[ ]( c )--(S)( z )--+\n",
    "+--\\--[ ]( a )--\\--( )( y )--+\n|  /--[ ]( b )--/\n",
    "+--[ ]( a )--\\--( )( y )--+\n",
    "+--<LBL>( l )--[ ]( a )--( )( w )--+\n",
    "+--[ ]( a )--<JMP>( l )--+\n",
    "+--[ ]( a )--<JMP>( k )--+\n",
    "+--[TON]( t, T#1s )--( )( y )--+\n",
    "|\n",
    "# note #\n",
];

const RULES: &[&str] = &[
    "double-coil",
    "never-read",
    "never-written",
    "undeclared-tag",
    "unknown-instruction",
    "unknown-label",
    "unused-label",
    "set-without-reset",
    "constant-power",
    "redundant-element",
    "literal-out-of-range",
    "unpaired-connector",
    "duplicate-timer",
    "bad-directive",
    "suppression-unused",
    "dubble-coil",
    "double-coil, never-read",
    "undeclared-tag, double-coil, never-written",
];

const SECTION: &str = "VAR\n    v : BOOL;\nEND_VAR\n";

/// Edits that decide about what comments cover, and whether they are read.
const PIECES: &[&str] = &[
    "",
    "\n",
    "\n\n",
    "#",
    "a",
    "# two\n lines #\n",
    "END_VAR\n",
    SECTION,
    "FUNCTION_BLOCK [$F]\n",
    "END_FUNCTION_BLOCK\n",
    "# ladder: profile iot #\n",
    "# ladder: profile click #\n",
    // What is neither a network nor a section is covered as well.
    "stray\n",
];

fn comment(dice: &mut Dice) -> String {
    let word = if dice.one_in(12) { "allow-file" } else { "allow" };
    let reason = if dice.one_in(6) { "" } else { ": meant" };
    let split = if dice.one_in(8) { "\n " } else { "" };
    format!("# ladder: {word}({}){reason}{split} #", dice.of(RULES))
}

/// What a program is made of: few kinds of rungs, as there are programs without a mistake.
struct Kinds {
    rungs: Vec<&'static str>,
    /// What is between two things: many lines, so that what a comment is about is in another part of the text, or few.
    far: bool,
}

impl Kinds {
    fn new(dice: &mut Dice) -> Kinds {
        let mut rungs: Vec<&str> = (0..=dice.below(4)).map(|_| dice.of(NETWORKS)).collect();
        rungs.push(NETWORKS[0]);
        let far = dice.one_in(2);
        Kinds { rungs, far }
    }

    fn gap(&self, dice: &mut Dice) -> String {
        if self.far && dice.one_in(3) {
            return dice.of(&["# note #\n", "\n", "|\n"]).repeat(dice.below(150));
        }
        dice.of(&["", "\n", "\n"]).to_owned()
    }
}

/// A rung or a comment, with a line end.
fn line(kinds: &Kinds, dice: &mut Dice) -> String {
    match dice.below(8) {
        0 | 1 => format!("{}\n", comment(dice)),
        2 => {
            let rung = dice.of(&kinds.rungs).trim_end_matches('\n');
            format!("{rung}  {}\n", comment(dice))
        }
        3 => format!("|  {}\n", comment(dice)),
        4 if dice.one_in(8) => SECTION.to_owned(),
        _ => dice.of(&kinds.rungs).to_owned(),
    }
}

/// A text of so many things. Something is below each comment.
fn text(count: usize, kinds: &Kinds, dice: &mut Dice) -> String {
    let declared = dice.of(&[
        "",
        "",
        "VAR\n    a, b, c, y, z, w : BOOL;\nEND_VAR\n\n",
        "VAR\n    a, b, c, y, z, w : BOOL;\n    n : INT;\n    t : TON;\nEND_VAR\n\n",
        "VAR_INPUT\n    a, b : BOOL;\nEND_VAR\nVAR_OUTPUT\n    y : BOOL;\nEND_VAR\n\
         # ladder: allow(never-read): meant #\nVAR\n    c, z, w : BOOL;\n    n : INT;\n    t : TON;\nEND_VAR\n\n",
    ]);
    let mut text = declared.to_owned();
    for _ in 0..count {
        text += &line(kinds, dice);
        text += &kinds.gap(dice);
    }
    text + NETWORKS[0]
}

/// A line comes, goes, moves or is exchanged, the rules of a comment change, or something is typed.
fn edited(text: &str, kinds: &Kinds, dice: &mut Dice) -> String {
    let mut lines: Vec<String> = text.split_inclusive('\n').map(str::to_owned).collect();
    let at = dice.below(lines.len().max(1));
    let comments: Vec<usize> = (0..lines.len())
        .filter(|line| lines[*line].contains("ladder:"))
        .collect();
    let framed: Vec<usize> = (0..lines.len())
        .filter(|line| lines[*line].ends_with("VAR\n"))
        .collect();
    match dice.below(9) {
        0 => lines.insert(at, line(kinds, dice)),
        1 if !lines.is_empty() => _ = lines.remove(at),
        2 if !comments.is_empty() => {
            let from = dice.of(&comments);
            let moved = lines.remove(from);
            lines.insert(dice.below(lines.len() + 1), moved);
        }
        3 if !comments.is_empty() => {
            let from = dice.of(&comments);
            let rule = dice.of(RULES);
            if let (Some(start), Some(end)) = (lines[from].find('('), lines[from].rfind(')'))
                && lines[from][..start].ends_with("allow")
                && start < end
            {
                lines[from].replace_range(start + 1..end, rule);
            }
        }
        4 if !comments.is_empty() => _ = lines.remove(dice.of(&comments)),
        5 if !lines.is_empty() => lines[at] = line(kinds, dice),
        6 => lines.insert(at, kinds.gap(dice)),
        7 if !framed.is_empty() => _ = lines.remove(dice.of(&framed)),
        _ => {
            let mut text = text.to_owned();
            let at = dice.below(text.len() + 1);
            let end = (at + dice.below(3)).min(text.len());
            text.replace_range(at..end, dice.of(PIECES));
            return text;
        }
    }
    lines.concat()
}

#[test]
fn comments_and_what_they_hide_come_and_go() {
    for seed in 0..asked(40) {
        let mut dice = Dice::new(seed);
        // Of one part, and of several.
        let (count, kinds) = (dice.of(&[6, 20, 60]), Kinds::new(&mut dice));
        let settings = if dice.one_in(3) {
            settings(&mut dice)
        } else {
            RuleSettings::default()
        };
        let mut document = Document::with(text(count, &kinds, &mut dice), settings);
        for _ in 0..25 {
            let before = document.text.clone();
            let next = edited(&before, &kinds, &mut dice);
            document.becomes(next);
            if dice.one_in(3) {
                document.becomes(before);
            }
        }
    }
}

/// A comment behind all else, which covers nothing, has all findings gone through one by one: they are the same.
#[test]
fn kept_and_gone_through() {
    for seed in 0..asked(200) {
        let mut dice = Dice::new(seed);
        let count = dice.of(&[1, 3, 6, 20]);
        let kinds = Kinds::new(&mut dice);
        let text = text(count, &kinds, &mut dice);
        let settings = if dice.one_in(3) {
            settings(&mut dice)
        } else {
            RuleSettings::default()
        };
        let analyse =
            |text: &str| analyze_with(&Arc::new(parse(text)), "main", &Others::default(), &settings);
        let (kept, listed) = (
            analyse(&text),
            analyse(&format!("{text}\n# ladder: allow(double-coil): x #\n")),
        );
        let above = |found: &&ladder_analysis::Diagnostic| usize::from(found.range.start()) < text.len();
        let all = |analysis: &ladder_analysis::Analysis| {
            let shown: Vec<_> = analysis.diagnostics().iter().filter(above).cloned().collect();
            (shown, analysis.hidden_errors().to_vec())
        };
        assert_eq!(all(&kept), all(&listed), "{text}");
    }
}

/// What a rule says of the whole program counts only without mistakes: one elsewhere decides whether a comment hides something.
#[test]
fn a_mistake_elsewhere() {
    let with = |rung: &str| {
        format!(
            "+--[ ]( I1 )--( )( Q1 )--+\n\n# ladder: allow(never-read): meant #\n+--[ ]( I2 )--( )( M2 )--+\n\n\
             # ladder: allow(never-read): meant #\n+--[ ]( I3 )--( )( Q3 )--+\n\n{rung}\n"
        )
    };
    let mut document = Document::new(with("+--[ ]( I4 )--( )( Q4 )--+"));
    for rung in ["+--[TOM]( I4 )--( )( Q4 )--+", "+--[ ]( I4 )--( )( Q4 )--+"] {
        document.becomes(with(rung));
    }
}
