//! Outputs of which one excludes the other, as far as a program shows it: each has the other's closed contact before its coil, or
//! their names say opposites. Whether they are ever on together is for the prover to say: this proposes the property.

use ladder_analysis::context::{Body, Context};
use ladder_analysis::names::scope::{Origin, TagFacts};
use ladder_analysis::networks::network::BoundBlock;
use ladder_analysis::program::Role;
use ladder_analysis::values::types::{Scalar, Type};
use ladder_instructions::Op;
use ladder_simulator::scenario::{Form, Suite};
use ladder_syntax::{TextRange, TextSize, line_around};
use std::collections::BTreeSet;

/// Of more outputs not all are compared.
const MOST: usize = 500;

/// Words of which two things that exclude each other have one each.
const OPPOSITES: [(&str, &str); 22] = [
    ("up", "down"),
    ("open", "close"),
    ("opening", "closing"),
    ("forward", "reverse"),
    ("forward", "backward"),
    ("forwards", "backwards"),
    ("fwd", "rev"),
    ("left", "right"),
    ("raise", "lower"),
    ("lift", "lower"),
    ("extend", "retract"),
    ("cw", "ccw"),
    ("in", "out"),
    ("fill", "drain"),
    ("heat", "cool"),
    ("heating", "cooling"),
    ("star", "delta"),
    ("fast", "slow"),
    ("clamp", "release"),
    ("lock", "unlock"),
    ("advance", "return"),
    ("charge", "discharge"),
];

/// Two outputs that are not to be on together.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Exclusive {
    /// The one that comes first in the program.
    pub one: String,
    /// The other.
    pub other: String,
}

impl Exclusive {
    /// The property, without an end of line after it.
    pub fn property(&self) -> String {
        let (one, other) = (&self.one, &self.other);
        format!("property \"{}\"\nnever {one} and {other}", self.name())
    }

    /// What it is called.
    pub fn name(&self) -> String {
        format!("not both {} and {}", self.one, self.other)
    }

    /// Whether a file says so already.
    pub fn is_stated(&self, suite: &Suite) -> bool {
        let words = |text: &str| {
            let text = text
                .to_ascii_lowercase()
                .replace(['(', ')'], " ")
                .replace('&', " and ");
            text.split_whitespace()
                .map(str::to_owned)
                .collect::<BTreeSet<String>>()
        };
        let own = words(&format!("{} and {}", self.one, self.other));
        suite.properties.iter().any(|property| {
            let says_so = match &property.form {
                Form::Never(written) => words(&written.text) == own,
                Form::Always(written) => {
                    let negated = format!("not {} and {}", self.one, self.other);
                    words(&written.text) == words(&negated)
                }
                _ => false,
            };
            says_so || property.name == self.name()
        })
    }
}

/// An output with the words of its name, the networks that write it by a coil, and those with a closed contact of it.
struct Output<'c> {
    tag: &'c TagFacts,
    words: Vec<String>,
    is_touched: bool,
    coils: BTreeSet<usize>,
    closed: BTreeSet<usize>,
}

/// The pairs of a program's outputs that exclude each other. With `touched` only those of which one is named in this range: it is asked
/// wherever the cursor goes.
pub fn exclusive_outputs(context: &Context, touched: Option<TextRange>) -> Vec<Exclusive> {
    let outputs: Vec<Output<'_>> = outputs(context, touched);
    let mut found = Vec::new();
    for (at, one) in outputs.iter().enumerate() {
        for other in outputs[at + 1..]
            .iter()
            .filter(|other| one.is_touched || other.is_touched)
        {
            let locks = |one: &Output<'_>, other: &Output<'_>| !one.closed.is_disjoint(&other.coils);
            let locked = locks(one, other) && locks(other, one);
            if locked || are_opposites(&one.words, &other.words) {
                found.push(Exclusive {
                    one: one.tag.name.to_string(),
                    other: other.tag.name.to_string(),
                });
            }
        }
    }
    found
}

fn outputs(context: &Context, touched: Option<TextRange>) -> Vec<Output<'_>> {
    let Some(scope) = context.scopes.first() else {
        return Vec::new();
    };
    let output = |tag: &TagFacts| {
        let shared = context.shared(tag);
        // One that is not declared and that its own program reads, too, may be an output as well.
        let may_be = shared.role == Role::Output || shared.origin == Origin::Undeclared;
        may_be && shared.ty == Some(Type::Scalar(Scalar::Bool)) && !tag.name.starts_with('%')
    };
    let is_touched = |tag: &TagFacts| {
        touched.is_none_or(|touched| {
            let mut places =
                std::iter::once(context.place_of(tag)).chain(context.uses(tag).map(|it| it.range));
            places.any(|place| place.intersect(touched).is_some())
        })
    };
    if !scope.tags.iter().any(|tag| output(tag) && is_touched(tag)) {
        return Vec::new();
    }
    let of = |tag| {
        let (mut coils, mut closed) = (BTreeSet::new(), BTreeSet::new());
        for place in context.uses(tag).filter(|place| place.whole) {
            if context.bodies[place.network] != Body::Main {
                continue;
            }
            let facts = context.networks.at(place.network);
            let block = facts.facts().blocks.get(place.block);
            match block.and_then(BoundBlock::op) {
                Some(Op::Coil | Op::SetCoil) => coils.insert(place.network),
                Some(Op::NegatedContact) => closed.insert(place.network),
                _ => false,
            };
        }
        Output {
            tag,
            words: words(&tag.name),
            is_touched: is_touched(tag),
            coils,
            closed,
        }
    };
    let outputs = scope.tags.iter().filter(|tag| output(tag)).map(of);
    let mut outputs: Vec<Output<'_>> = outputs
        .filter(|output| !output.coils.is_empty())
        .take(MOST)
        .collect();
    outputs.sort_by_key(|output| output.coils.first().copied());
    outputs
}

/// Whether two names differ in one word, and that by its opposite.
fn are_opposites(one: &[String], other: &[String]) -> bool {
    if one.len() != other.len() {
        return false;
    }
    let mut differ = one.iter().zip(other).filter(|(a, b)| a != b);
    let (Some((a, b)), None) = (differ.next(), differ.next()) else {
        return false;
    };
    let mut pairs = OPPOSITES.iter();
    pairs.any(|(x, y)| (a == x && b == y) || (a == y && b == x))
}

/// The words of a name, in small letters: `motor_up`, `motorUp`.
fn words(name: &str) -> Vec<String> {
    let mut words: Vec<String> = vec![String::new()];
    let mut was_small = false;
    for letter in name.chars() {
        let begins = letter == '_' || letter == '.' || (letter.is_uppercase() && was_small);
        was_small = letter.is_lowercase() || letter.is_numeric();
        if begins {
            words.push(String::new());
        }
        if let Some(word) = words.last_mut().filter(|_| letter.is_alphanumeric()) {
            word.extend(letter.to_lowercase());
        }
    }
    words.retain(|word| !word.is_empty());
    words
}

/// Where another property goes in a file: below the last one, else above the first scenario, else at the end. With it what is
/// between that and what is before it, and after it.
pub fn place_of_new(text: &str, suite: &Suite) -> (TextSize, &'static str, &'static str) {
    let end = TextSize::of(text);
    if let Some(last) = suite.properties.iter().map(|it| it.place.end()).max() {
        return (line_around(text, last).end(), "\n\n", "");
    }
    if let Some(first) = suite.scenarios.first() {
        let mut at = line_around(text, first.range.start()).start();
        // The comment of a scenario stays above it.
        while let Some(before) = at.checked_sub(TextSize::new(1)) {
            let line = line_around(text, before);
            if !text[line].trim_start().starts_with('#') {
                break;
            }
            at = line.start();
        }
        return (at, "", "\n\n");
    }
    let before = match text {
        "" => "",
        text if text.ends_with('\n') => "\n",
        _ => "\n\n",
    };
    (end, before, "\n")
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::fixture::Fixture;
    use ladder_simulator::scenario::parse;

    fn pairs(text: &str) -> Vec<String> {
        let fixture = Fixture::new(text);
        let found = exclusive_outputs(&fixture.files[0].0.context, None);
        found.iter().map(Exclusive::name).collect()
    }

    #[test]
    fn coils_that_lock_each_other() {
        let locked = "+--[ ]( a )--[/]( y )--( )( x )--+\n+--[ ]( b )--[/]( x )--( )( y )--+\n";
        assert_eq!(pairs(locked), ["not both x and y"]);
        let set = "+--[ ]( a )--[/]( y )--(S)( x )--+\n+--[ ]( b )--[/]( x )--(S)( y )--+\n";
        assert_eq!(pairs(set), ["not both x and y"]);
        let one_way = "+--[ ]( a )--[/]( y )--( )( x )--+\n+--[ ]( b )--( )( y )--+\n";
        assert!(pairs(one_way).is_empty());
        let internal = format!("VAR x, y : BOOL; END_VAR\n{locked}");
        assert!(pairs(&internal).is_empty(), "outputs only");
    }

    #[test]
    fn names_that_say_opposites() {
        let of = |one: &str, other: &str| {
            pairs(&format!(
                "+--[ ]( a )--( )( {one} )--+\n+--[ ]( b )--( )( {other} )--+\n"
            ))
        };
        assert_eq!(of("up", "down"), ["not both up and down"]);
        assert_eq!(
            of("valve_close", "valve_open"),
            ["not both valve_close and valve_open"]
        );
        assert_eq!(of("motorForward", "motorReverse").len(), 1);
        for (one, other) in [
            ("up", "run"),
            ("up_1", "down_2"),
            ("up", "motor_down"),
            ("up", "UP_"),
        ] {
            assert!(of(one, other).is_empty(), "{one} {other}");
        }
    }

    #[test]
    fn what_is_stated_is_not_proposed() {
        let fixture = Fixture::new("+--[ ]( a )--( )( up )--+\n+--[ ]( b )--( )( down )--+\n");
        let found = exclusive_outputs(&fixture.files[0].0.context, None);
        let is_stated = |form: &str| found[0].is_stated(&parse(&format!("program p.clad\n{form}\n")));
        assert!(is_stated("never up and down"));
        assert!(is_stated("never (Down & up)"));
        assert!(is_stated("always not (up and down)"));
        assert!(!is_stated("never up or down"));
        assert!(!is_stated("never up and down and a"));
    }
}
