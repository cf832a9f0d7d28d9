//! What is kept from one text to the next is a memo: after every edit the analysis that has one says the same as one without,
//! and as one from scratch, whichever of several files that see each other is edited, opened or closed.

mod pieces;

use ladder_analysis::context::Context;
use ladder_analysis::names::scope::Scope;
use ladder_analysis::networks::use_place::Use;
use ladder_analysis::{
    Analysis, AnalyzeOptions, Cancel, Diagnostic, Exported, Exports, Level, RuleSettings, Severity, analyze,
    context, exports,
};
use ladder_syntax::{Parse, TextRange, parse};
use ladder_tests::generator::{Dice, Mode, program};
use pieces::{GLOBALS, LIBRARY, MAIN, NETWORKS, OTHERS, PIECES, SEEN, WORDS};
use std::collections::BTreeMap;
use std::sync::Arc;

/// A file that is open in an editor.
struct Open {
    text: String,
    parse: Arc<Parse>,
    analysis: Analysis,
    exports: Arc<Exports>,
}

/// Files of one workspace. As in the server, an edit has the others analysed again if it concerns them.
#[derive(Default)]
struct Files {
    open: BTreeMap<&'static str, Open>,
    exported: Arc<Exported>,
    settings: RuleSettings,
}

impl Files {
    /// A file is opened, or its text becomes another.
    fn becomes(&mut self, name: &'static str, text: String) {
        let others = self.exported.others_of(name);
        let before = self.open.remove(name);
        let parsed = Arc::new(match &before {
            Some(before) => before.parse.updated(&before.text, &text),
            None => parse(&text),
        });
        assert_eq!(parsed.to_string(), text);
        let known = before.as_ref().map(|before| &before.analysis);
        let analysis = analyze(
            &parsed,
            AnalyzeOptions::new(name)
                .among(&others)
                .with_rules(&self.settings)
                .after(known),
        );
        let shown = Arc::new(Exports::of(&analysis.context, name));
        let concerned = before.is_none_or(|before| self.exported.concerns(&before.exports, &shown));
        let open = Open {
            text,
            parse: parsed,
            analysis,
            exports: shown,
        };
        self.open.insert(name, open);
        if concerned {
            self.analyze_again();
        }
        self.check();
    }

    /// A file is closed, and there is none on the disk.
    fn close(&mut self, name: &'static str) {
        self.open.remove(name);
        self.analyze_again();
        self.check();
    }

    /// The settings of the workspace change.
    fn are_set(&mut self, settings: RuleSettings) {
        self.settings = settings;
        self.analyze_again();
        self.check();
    }

    fn analyze_again(&mut self) {
        let shown = self.open.values().map(|open| Arc::clone(&open.exports));
        self.exported = Arc::new(Exported::new(shown.collect()));
        for (name, open) in &mut self.open {
            let others = self.exported.others_of(name);
            let before = Some(&open.analysis);
            open.analysis = analyze(
                &open.parse,
                AnalyzeOptions::new(name)
                    .among(&others)
                    .with_rules(&self.settings)
                    .after(before),
            );
        }
    }

    /// Compares all files with an analysis without a memo, and with one of everything from scratch.
    fn check(&self) {
        let fresh = self
            .open
            .iter()
            .map(|(name, open)| (*name, Arc::new(parse(&open.text))));
        let fresh: BTreeMap<&str, Arc<Parse>> = fresh.collect();
        let shown = fresh.iter().map(|(name, parse)| Arc::new(exports(parse, name)));
        let exported = Arc::new(Exported::new(shown.collect()));
        for (name, open) in &self.open {
            let others = exported.others_of(name);
            let kept = show(&open.analysis);
            let rules = AnalyzeOptions::new(name)
                .among(&others)
                .with_rules(&self.settings);
            let known = rules.after_context(Some(&open.analysis.context));
            let context = Arc::new(context(&open.parse, known));
            let without = rules
                .check_unless(context, &Cancel::default())
                .expect("nothing cancels it");
            let without = show(&without);
            assert_eq!(
                here(&kept),
                here(&without),
                "{name} with a memo, of\n{}",
                self.texts()
            );
            let scratch = show(&analyze(
                &fresh[name],
                AnalyzeOptions::new(name)
                    .among(&others)
                    .with_rules(&self.settings),
            ));
            assert_eq!(
                here(&kept),
                here(&scratch),
                "{name} from scratch, of\n{}",
                self.texts()
            );
            let alone = exports(&fresh[name], name);
            assert!(open.exports.says_the_same(&alone), "{name} of\n{}", self.texts());
        }
    }

    fn texts(&self) -> String {
        let all = self.open.iter();
        let texts: Vec<String> = all
            .map(|(name, open)| format!("== {name}\n{}\n", open.text))
            .collect();
        texts.concat()
    }
}

/// All that an analysis says. Where things are in other files is not kept up to date.
fn show(analysis: &Analysis) -> String {
    let context = &analysis.context;
    let here = |found: &Diagnostic| {
        let mut found = found.clone();
        let elsewhere = found.related.iter_mut().filter(|related| related.file.is_some());
        elsewhere.for_each(|related| related.range = TextRange::default());
        found
    };
    format!(
        "{:#?}\n{:#?}\n{:?}\n{:?}\n{:?}",
        analysis.diagnostics().iter().map(here).collect::<Vec<_>>(),
        analysis.hidden_errors().iter().map(here).collect::<Vec<_>>(),
        analysis.program(),
        tags(context),
        context
            .networks
            .iter()
            .map(|network| {
                let blocks: Vec<_> = network
                    .blocks()
                    .map(|b| (&b.bound().facts, b.base, b.meaning, &b.bound().formals))
                    .collect();
                (
                    network.first_line,
                    network.range,
                    network.scope,
                    network.broken,
                    &network.facts().wiring,
                    &network.facts().order,
                    blocks,
                )
            })
            .collect::<Vec<_>>(),
    )
}

/// The tags of each scope, and where they are used.
fn tags(context: &Context) -> Vec<String> {
    let of_scope = |scope: &Scope| {
        let tags = scope.tags.iter().map(|tag| {
            let uses: Vec<Use> = context.uses(tag).collect();
            let what = (&tag.name, tag.ty, tag.role, tag.origin, tag.mistyped);
            let declared = (tag.retain, tag.constant, &tag.cold.initial, &tag.cold.address);
            let elsewhere = (context.alias_of(tag), &tag.cold.foreign);
            let place = context.place_of(tag);
            format!("{what:?} {declared:?} {elsewhere:?} {place:?} {uses:?}")
        });
        tags.collect::<Vec<_>>().join("\n")
    };
    context.scopes.iter().map(of_scope).collect()
}

/// Without the places in other files: those that only moved are no reason to look at a file again.
fn here(shown: &str) -> String {
    let mut pieces = shown.split("Location { file: ");
    let mut here = pieces.next().unwrap_or_default().to_owned();
    for piece in pieces {
        let end = piece.find('}').filter(|_| !piece.starts_with("0,")).unwrap_or(0);
        here.push_str(&piece[end..]);
    }
    here
}

fn somewhere(text: &str, dice: &mut Dice) -> usize {
    let mut at = dice.below(text.len() + 1);
    while !text.is_char_boundary(at) {
        at -= 1;
    }
    at
}

/// One to three pieces put in, taken out or exchanged; now and then lines are doubled, moved or taken away.
fn edited(text: &str, dice: &mut Dice) -> String {
    let mut text = text.to_owned();
    for _ in 0..=dice.below(3) {
        if dice.one_in(4) {
            let mut lines: Vec<&str> = text.split_inclusive('\n').collect();
            if lines.is_empty() {
                continue;
            }
            let from = dice.below(lines.len());
            let taken = lines[from];
            if dice.one_in(2) {
                lines.remove(from);
            }
            if dice.one_in(2) {
                lines.insert(dice.below(lines.len() + 1), taken);
            }
            text = lines.concat();
            continue;
        }
        // A declaration that changes says something of networks that do not.
        let word = dice.of(&WORDS);
        let from = somewhere(&text, dice);
        if dice.one_in(3)
            && let Some(at) = text[from..].find(word)
        {
            let at = from + at;
            text.replace_range(at..at + word.len(), dice.of(&WORDS));
            continue;
        }
        let at = somewhere(&text, dice);
        let mut end = (at + dice.below(4) * dice.below(3)).min(text.len());
        while !text.is_char_boundary(end) {
            end -= 1;
        }
        text.replace_range(at..end.max(at), dice.of(&PIECES));
    }
    text
}

/// A program of pieces, each of which decides about what rules find in others.
fn of_pieces(dice: &mut Dice) -> String {
    let declared = (0..dice.below(5)).map(|_| dice.of(OTHERS).to_owned());
    let mut text: String = declared.collect();
    for _ in 0..2 + dice.below(12) {
        text.push_str(dice.of(NETWORKS));
        text.push_str("\n\n");
    }
    text
}

/// One such piece comes or goes, or something is typed.
fn changed(text: &str, dice: &mut Dice) -> String {
    let mut parts: Vec<&str> = text.split_inclusive("\n\n").collect();
    let at = dice.below(parts.len() + 1);
    match dice.below(5) {
        0 if at < parts.len() => {
            parts.remove(at);
        }
        1 => parts.insert(at, dice.of(OTHERS)),
        2 => {
            let network = format!("{}\n\n", dice.of(NETWORKS));
            return [&parts[..at], &[network.as_str()], &parts[at..]]
                .concat()
                .concat();
        }
        3 => parts.insert(at, dice.of(&SEEN)),
        _ => return edited(text, dice),
    }
    parts.concat()
}

/// As the table of rules says, or everything, or with some rules off or counting otherwise.
fn settings(dice: &mut Dice) -> RuleSettings {
    let mut settings = if dice.one_in(3) {
        RuleSettings::everything()
    } else {
        RuleSettings::default()
    };
    for _ in 0..dice.below(6) {
        let level = dice.of(&[
            Level::Off,
            Level::Shown(Severity::Error),
            Level::Shown(Severity::Info),
        ]);
        settings.set(dice.of(ladder_analysis::rules::ALL), level);
    }
    settings.scan_interval = dice.of(&[settings.scan_interval, Some(5_000_000)]);
    settings
}

#[test]
fn random_edits_of_several_files() {
    for seed in 0..asked(20) {
        let mut dice = Dice::new(seed);
        let generated = dice.of(&[Mode::Sensible, Mode::Wild, Mode::Typed]);
        let main = match dice.below(3) {
            0 => MAIN.to_owned(),
            1 => program(seed, generated),
            _ => of_pieces(&mut dice),
        };
        let originals = [
            ("globals", GLOBALS.to_owned()),
            ("library", LIBRARY.to_owned()),
            ("main", main),
        ];
        let mut files = Files::default();
        for step in 0..40 {
            // Most happens in one file.
            let (name, original) = &originals[if dice.one_in(2) { 2 } else { dice.below(3) }];
            if dice.one_in(10) {
                files.are_set(settings(&mut dice));
            }
            match files.open.get(name) {
                None => files.becomes(name, original.clone()),
                Some(_) if dice.one_in(12) => files.close(name),
                // Errors come and go, as when a person types.
                Some(_) if step % 5 == 4 => files.becomes(name, original.clone()),
                Some(open) => {
                    let next = changed(&open.text, &mut dice);
                    files.becomes(name, next);
                }
            }
        }
    }
}

#[test]
fn a_type_with_a_member_that_cannot_be_read() {
    let mut files = Files::default();
    let types = "TYPE\n    M : STRUCT\n        on --BOOL;\n    END_STRUCT;\nEND_TYPE\n";
    files.becomes("library", types.to_owned());
    files.becomes("main", "VAR\n    m : M;\nEND_VAR\n".to_owned());
    files.becomes("library", format!("\n{types}"));
}

/// `GENERATED_PROGRAMS` asks for more of them.
fn asked(usual: u64) -> u64 {
    let asked = std::env::var("GENERATED_PROGRAMS");
    asked.ok().and_then(|count| count.parse().ok()).unwrap_or(usual)
}
