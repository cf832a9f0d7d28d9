//! The rules that decide on a network's boolean function, next to the reference evaluation tried with every combination
//! of values: what they say is so, and where they are silent there is nothing to say.

use ladder_analysis::{Analysis, Rule, analyze};
use ladder_syntax::{TextRange, parse};
use ladder_tests::generator::{Mode, program};
use ladder_tests::reference::Boolean;
use std::sync::Arc;

/// More combinations than of so many tags are not tried.
const MOST_TAGS: usize = 7;

/// What the blocks of a network do for one combination of values.
#[derive(Clone, PartialEq, Eq)]
struct Outcome {
    enabled: Vec<bool>,
    power: Vec<bool>,
    left: Vec<bool>,
}

/// A network of a program, by itself.
struct Lone {
    text: String,
    analysis: Analysis,
    outcomes: Vec<Outcome>,
}

/// Every outcome of a network: one for each combination of the values of these tags.
fn outcomes(text: &str, tags: &[String]) -> Vec<Outcome> {
    let mut reference = Boolean::new(text);
    (0..1_usize << tags.len())
        .map(|values| {
            for (bit, tag) in tags.iter().enumerate() {
                reference.tags.insert(tag.clone(), values >> bit & 1 == 1);
            }
            reference.scan();
            Outcome {
                enabled: reference.enabled.clone(),
                power: reference.power.clone(),
                left: reference.left.clone(),
            }
        })
        .collect()
}

impl Lone {
    fn tags(text: &str) -> Vec<String> {
        Boolean::new(text).tags.into_keys().collect()
    }

    fn block_at(&self, range: TextRange) -> usize {
        let mut blocks = self.analysis.context.networks.at(0).blocks();
        blocks
            .position(|block| block.range() == range)
            .expect("a block is there")
    }

    fn is_contact(&self, block: usize) -> bool {
        let text = &self.text[self.analysis.context.networks.at(0).block(block).range()];
        text.starts_with('[') && !text.starts_with("[NOT")
    }

    fn is_coil(&self, block: usize) -> bool {
        self.text[self.analysis.context.networks.at(0).block(block).range()].starts_with('(')
    }

    /// What every coil leaves in its tag, if a block is replaced by these characters.
    fn acts_with(&self, block: usize, by: &str) -> Vec<Vec<bool>> {
        let range = std::ops::Range::<usize>::from(self.analysis.context.networks.at(0).block(block).range());
        let mut text = self.text.clone();
        text.replace_range(range.clone(), &by.repeat(range.len()));
        let mut given = outcomes(&text, &Self::tags(&self.text));
        for outcome in &mut given {
            outcome.left.insert(block, false);
        }
        self.acting(&given)
    }

    fn acting(&self, outcomes: &[Outcome]) -> Vec<Vec<bool>> {
        let of = |outcome: &Outcome| {
            let blocks = outcome.left.iter().enumerate();
            blocks
                .filter(|(block, _)| self.is_coil(*block))
                .map(|(_, &left)| left)
                .collect()
        };
        outcomes.iter().map(of).collect()
    }

    /// Whether replacing a contact by wire, or taking it away, changes nothing.
    fn is_redundant(&self, block: usize) -> bool {
        let as_it_is = self.acting(&self.outcomes);
        ["-", " "].iter().any(|by| self.acts_with(block, by) == as_it_is)
    }

    /// Whether another contact of the network asks for the same tag.
    fn is_asked_twice(&self, block: usize) -> bool {
        let network = self.analysis.context.networks.at(0);
        let tag = |block: usize| {
            let text = &self.text[network.block(block).range()];
            text[text.find('(').unwrap_or(0)..]
                .trim_matches(['(', ')', ' '])
                .to_lowercase()
        };
        (0..network.blocks.len())
            .any(|other| other != block && self.is_contact(other) && tag(other) == tag(block))
    }
}

/// The networks of generated programs that are small enough, each with all of its outcomes.
fn each(check: impl Fn(&Lone)) {
    let asked = std::env::var("GENERATED_PROGRAMS")
        .ok()
        .and_then(|count| count.parse().ok());
    let mut tried = 0;
    for seed in 0..asked.unwrap_or(150_u64) {
        let text = program(seed, Mode::Boolean);
        let parsed = parse(&text);
        for network in &parsed.structure().networks {
            let range = TextRange::new(
                parsed.line_start(network.lines.start),
                parsed.line_range(network.lines.end - 1).end(),
            );
            let text = text[range].to_owned();
            let tags = Lone::tags(&text);
            if tags.len() > MOST_TAGS {
                continue;
            }
            let analysis = analyze(&Arc::new(parse(&text)), "lone");
            if analysis.has_errors() || analysis.context.networks.len() != 1 {
                continue;
            }
            let outcomes = outcomes(&text, &tags);
            check(&Lone {
                text,
                analysis,
                outcomes,
            });
            tried += 1;
        }
    }
    assert!(tried > 100, "only {tried} networks were small enough");
}

#[test]
fn constant_power_is_just_where_no_power_comes_through() {
    each(|lone| {
        let found = |block: usize| {
            lone.analysis.diagnostics().iter().any(|found| {
                found.rule.name() == "constant-power"
                    && found.message.starts_with("no power ever")
                    && lone.block_at(found.range) == block
            })
        };
        for block in
            (0..lone.analysis.context.networks.at(0).blocks.len()).filter(|&block| lone.is_contact(block))
        {
            let fed = lone.outcomes.iter().any(|outcome| outcome.enabled[block]);
            let conducts = lone.outcomes.iter().any(|outcome| outcome.power[block]);
            assert_eq!(found(block), fed && !conducts, "block {block} of\n{}", lone.text);
        }
    });
}

#[test]
fn redundant_elements_are_redundant_and_all_others_are_not() {
    each(|lone| {
        let of = |rule: Rule| {
            lone.analysis
                .diagnostics()
                .iter()
                .filter(move |found| found.rule == rule)
        };
        let mut reported =
            of(ladder_analysis::rules::rule_named("redundant-element").expect("a rule")).peekable();
        if reported.peek().is_some() {
            for found in reported {
                let block = lone.block_at(found.range);
                assert!(lone.is_redundant(block), "block {block} of\n{}", lone.text);
            }
            return;
        }
        // What never conducts, or leads nowhere, makes others redundant, and is reported in their place.
        let others = [
            ladder_analysis::rules::rule_named("constant-power").expect("a rule"),
            ladder_analysis::rules::rule_named("duplicate-branch").expect("a rule"),
            ladder_analysis::rules::rule_named("dead-end").expect("a rule"),
            ladder_analysis::rules::rule_named("no-output").expect("a rule"),
            ladder_analysis::rules::rule_named("open-wire").expect("a rule"),
        ];
        if others.into_iter().any(|rule| of(rule).next().is_some()) {
            return;
        }
        for block in
            (0..lone.analysis.context.networks.at(0).blocks.len()).filter(|&block| lone.is_contact(block))
        {
            if lone.is_asked_twice(block) {
                assert!(!lone.is_redundant(block), "block {block} of\n{}", lone.text);
            }
        }
    });
}
