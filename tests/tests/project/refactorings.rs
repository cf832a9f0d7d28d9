//! What holds for every refactoring at every place of generated programs and of the examples: it leaves a program
//! without new errors, in the layout if it stood in it, that does what the program did. Where the title says that it
//! changes something, it can be taken back.
//!
//! A failure names the seed. `GENERATED_PROGRAMS=5000 cargo test -p ladder-tests refactorings` tries more.

use ladder_analysis::written::facts::NodeKind;
use ladder_analysis::{Analysis, analyze};
use ladder_format::{Options, apply, format_text};
use ladder_ide::{Action, ActionKind, refactorings};
use ladder_instructions::Op;
use ladder_syntax::{TextRange, TextSize, parse};
use ladder_tests::generator::{Dice, Mode, program};
use ladder_tests::project;
use ladder_tests::trace::{Stimulus, next_to};
use std::collections::BTreeMap;
use std::sync::Arc;

fn analysis(text: &str) -> Analysis {
    analyze(&Arc::new(parse(text)), "program")
}

fn formatted(text: &str) -> String {
    format_text(text, &Options::default())
}

fn done(text: &str, action: &Action) -> String {
    apply(text, &action.aligned(&analysis(text), text, &Options::default()))
}

/// A place to look at: a cursor on a block, or a selection from one block to another of the same network.
fn place(dice: &mut Dice, analysis: &Analysis) -> Option<TextRange> {
    let networks = &analysis.context.networks;
    if networks.is_empty() {
        return None;
    }
    let network = networks.at(dice.below(networks.len()));
    let first = network.blocks().nth(dice.below(network.blocks.len().max(1)))?;
    let inside = first.range().start() + TextSize::new(1);
    Some(match dice.below(4) {
        0 => TextRange::empty(inside),
        1 => network.range,
        _ => {
            // With the connectors around it, or without.
            let same: Vec<_> = network
                .blocks()
                .filter(|it| it.facts.rung == first.facts.rung)
                .collect();
            let last = same[dice.below(same.len())];
            let range = first.range().cover(last.range());
            let rung = &network.wiring.rungs[first.facts.rung];
            let wider = |part: &&ladder_syntax::wiring::RungPart| {
                let part = part.range + first.base;
                part.end() + TextSize::new(4) >= range.start()
                    && part.start() <= range.end() + TextSize::new(4)
            };
            let around = rung
                .parts
                .iter()
                .filter(wider)
                .map(|part| part.range + first.base);
            if dice.one_in(2) {
                around.fold(range, TextRange::cover)
            } else {
                range
            }
        }
    })
}

/// What an action promises, by its title.
fn changes(action: &Action) -> bool {
    action.title.contains("changes what the rung does")
}

/// The first words of a title: which action it is.
fn name(action: &Action) -> String {
    let named = |word: &&str| !word.starts_with(|c: char| "`(0123456789".contains(c));
    let words: Vec<&str> = action.title.split(' ').take_while(named).collect();
    words.join(" ")
}

#[derive(Default)]
struct Tally(BTreeMap<String, usize>);

/// Does everything that is offered at some places of a program.
fn try_out(what: &str, text: &str, seed: u64, places: usize, tally: &mut Tally) {
    let before = analysis(text);
    if before.has_errors() {
        return;
    }
    let was_laid_out = formatted(text) == text;
    let mut dice = Dice::new(seed ^ 0x5eed);
    for _ in 0..places {
        let Some(range) = place(&mut dice, &before) else {
            return;
        };
        for action in refactorings(&before, range) {
            if action.disabled.is_some() {
                *tally
                    .0
                    .entry(format!("{} (disabled)", name(&action)))
                    .or_default() += 1;
                continue;
            }
            *tally.0.entry(name(&action)).or_default() += 1;
            let new = done(text, &action);
            let shown = || format!("{what}: {} at {range:?} of\n{text}\n=>\n{new}", action.title);
            let after = analysis(&new);
            let errors: Vec<_> = after.errors().collect();
            assert!(errors.is_empty(), "{errors:#?}\n{}", shown());
            if was_laid_out {
                assert_eq!(formatted(&new), new, "{}", shown());
            }
            assert_eq!(comments(&new), comments(text), "{}", shown());
            if changes(&action) {
                taken_back(text, &new, &action, range, &shown);
                continue;
            }
            assert_ne!(new, text, "{}", shown());
            let stimulus = Stimulus { seed, scans: 10 };
            assert_eq!(next_to(text, &new, stimulus), None, "{}", shown());
            if let Some(action) = inlined(&after) {
                *tally.0.entry(name(&action)).or_default() += 1;
                let back = done(&new, &action);
                let shown = || format!("{}\n=>\n{back}", shown());
                let errors: Vec<_> = analysis(&back).errors().cloned().collect();
                assert!(errors.is_empty(), "{errors:#?}\n{}", shown());
                if was_laid_out {
                    assert_eq!(formatted(&back), back, "{}", shown());
                }
                // The definition of a block stays, with its comments.
                let (mut left, mut right) = (comments(&back), comments(text));
                left.dedup();
                right.dedup();
                assert_eq!(left, right, "{}", shown());
                assert_eq!(next_to(text, &back, stimulus), None, "{}", shown());
            }
        }
    }
}

/// What puts a new function or block back in its place.
fn inlined(analysis: &Analysis) -> Option<Action> {
    let blocks = analysis
        .context
        .networks
        .iter()
        .flat_map(ladder_analysis::networks::NetworkAt::blocks);
    let calls = blocks.filter(|block| {
        let text = block.facts.operands.first().map(|operand| &operand.value.kind);
        let function = matches!(text, Some(NodeKind::Name(name)) if name.starts_with("function_"));
        (block.op() == Some(Op::Call) && function)
            || block.user_name().is_some_and(|name| name.starts_with("$Block"))
    });
    let at = calls.map(|block| TextRange::empty(block.range().start() + TextSize::new(1)));
    at.flat_map(|at| refactorings(analysis, at))
        .find(|action| action.kind == ActionKind::Inline && action.disabled.is_none())
}

/// No comment is lost or made.
fn comments(text: &str) -> Vec<String> {
    let mut comments: Vec<String> = parse(text)
        .syntax()
        .descendants_with_tokens()
        .filter_map(ladder_syntax::NodeOrToken::into_token)
        .filter(|token| token.kind() == ladder_syntax::SyntaxKind::COMMENT)
        .map(|token| token.text().to_owned())
        .collect();
    comments.sort();
    comments
}

/// A block that took the place of another gives way to it again.
fn taken_back(text: &str, new: &str, action: &Action, range: TextRange, shown: &impl Fn() -> String) {
    if action.title.starts_with("Remove") {
        return;
    }
    let spelled = action.edits(&analysis(text))[0].range;
    let at = TextRange::empty(range.start());
    // The first edit lies before or after the cursor; the layout may have moved the block.
    let after = analysis(new);
    let networks = &after.context.networks;
    let block = analysis(text)
        .context
        .networks
        .iter()
        .enumerate()
        .find_map(|(network, facts)| {
            let block = facts.blocks().position(|block| block.head_range() == spelled)?;
            Some((network, block))
        });
    let (network, block) = block.unwrap_or_else(|| panic!("{at:?}: {}", shown()));
    let inside = networks.at(network).block(block).range().start() + TextSize::new(1);
    let back = refactorings(&after, TextRange::empty(inside));
    let text = formatted(text);
    assert!(
        back.iter().any(|action| formatted(&done(new, action)) == text),
        "nothing takes it back: {}",
        shown()
    );
}

fn count(default: u64) -> u64 {
    let asked = std::env::var("GENERATED_PROGRAMS").ok();
    asked.and_then(|count| count.parse().ok()).unwrap_or(default)
}

/// The text without its sections; the tags have the types that their places give them.
fn without_declarations(text: &str) -> String {
    let parse = parse(text);
    let mut bare = text.to_owned();
    let sections = parse.structure().sections.iter().rev();
    for section in sections.filter(|section| section.block.is_none()) {
        let (first, last) = (section.lines.start, section.lines.end - 1);
        let range = TextRange::new(parse.line_start(first), parse.line_range(last).end());
        bare.replace_range(std::ops::Range::<usize>::from(range), "");
    }
    formatted(&bare)
}

#[test]
fn in_programs_of_the_generator() {
    let mut tally = Tally::default();
    for (mode, programs) in [
        (Mode::Sensible, 60),
        (Mode::Wild, 90),
        (Mode::Boolean, 40),
        (Mode::Typed, 30),
    ] {
        for seed in 0..count(programs) {
            let text = program(seed, mode);
            let text = if seed % 3 == 0 { text } else { formatted(&text) };
            let what = format!("program({seed}, Mode::{mode:?})");
            try_out(&what, &text, seed, 4, &mut tally);
            if mode == Mode::Sensible {
                let bare = without_declarations(&text);
                try_out(
                    &format!("{what} without declarations"),
                    &bare,
                    seed,
                    2,
                    &mut tally,
                );
            }
        }
    }
    eprintln!("{:#?}", tally.0);
    for name in [
        "Make",
        "Draw a parallel contact",
        "Draw a parallel coil",
        "Wrap",
        "Remove the parallel branch with",
        "Split the network before",
        "Split the network above this rung",
        "Make a seal-in of the set and reset coils of",
        "Write the seal-in of",
        "Extract the network into the function",
        "Extract the selected blocks into the block",
        "Inline the function",
        "Inline the block",
        "Declare the undeclared tags of the file",
    ] {
        assert!(
            tally.0.contains_key(name),
            "nothing was tried of `{name}`: {:#?}",
            tally.0
        );
    }
}

#[test]
fn in_the_examples() {
    let mut tally = Tally::default();
    for folder in ["examples", "tests/corpus/semantics"] {
        for (seed, file) in project::files(&project::root().join(folder), "clad")
            .iter()
            .enumerate()
        {
            let text = project::read(file);
            try_out(&file.display().to_string(), &text, seed as u64, 25, &mut tally);
        }
    }
    assert!(tally.0.len() > 8, "{:#?}", tally.0);
}
