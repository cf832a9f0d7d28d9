//! `unknown-instruction`: no instruction has this name.

use super::form::Form;
use super::{missing_wire, wrong_shape};
use crate::findings::article::with_article;
use crate::findings::diagnostic::{Applicability, Diagnostic};
use crate::findings::excerpt::in_sentence;
use crate::findings::rule::{Rule, RuleFacts, RuleGroup, Severity};
use crate::networks::BlockAt;
use crate::networks::network::Meaning;
use ladder_instructions::{Accepts, Instruction, Operand, Profile, Shape, TABLE, closest};
use ladder_syntax::is_identifier;
use std::fmt::Write;

pub(crate) const RULE: Rule = Rule(
    &RuleFacts::new(RuleGroup::Blocks, "unknown-instruction", Severity::Error).fixed(Applicability::Unsafe),
);

pub(super) fn check(form: &Form<'_>, out: &mut Vec<Diagnostic>) {
    let network = form.network;
    for (index, bound) in network.blocks().enumerate() {
        if let Meaning::Instruction(row) = bound.meaning {
            out.extend(not_in_profile(form.profile, row, bound));
            continue;
        }
        if !matches!(bound.meaning, Meaning::Unknown) || bound.faulty {
            continue;
        }
        let before = index.checked_sub(1);
        if before.is_some_and(|before| missing_wire::takes_next_head(network, before)) {
            continue;
        }
        out.push(match wrong_shape::elsewhere(bound) {
            Some(row) => wrong_shape::brackets(form.parse, bound, row),
            None => unknown(bound),
        });
    }
}

/// A timer or counter that a profile does not have: it would count what nothing there counts. Other instructions work
/// in every profile.
fn not_in_profile(profile: Profile, row: &Instruction, bound: BlockAt<'_>) -> Option<Diagnostic> {
    let counts = |operand: &Operand| match operand.accepts {
        Accepts::State(state) => state.is_timer() || state.is_counter(),
        _ => false,
    };
    if row.profiles.contain(profile) || !row.operands.iter().any(counts) {
        return None;
    }
    let known = TABLE
        .iter()
        .filter(|row| row.profiles.contain(profile) && row.operands.iter().any(counts));
    let known: Vec<String> = known.map(Instruction::block).collect();
    let message = format!("there is no {} in the profile `{profile}`", row.block());
    let found = Diagnostic::new(RULE, bound.head_range(), message);
    Some(found.help(format!("its timers and counters are {}", known.join(" "))))
}

fn unknown(bound: BlockAt<'_>) -> Diagnostic {
    let found = Diagnostic::new(
        RULE,
        bound.head_range(),
        format!("there is no instruction {}", bound.head_text()),
    );
    let text = bound.facts.head.text();
    let shape = bound.facts.shape;
    let count = bound.positional_count();
    // A likeness across shapes says something only if the operands fit as well.
    let near = closest(shape, text).filter(|row| row.shape == shape || row.takes(count));
    // `[start]`, `(run)`: the tag is where the kind of contact or coil belongs.
    let bare = bound.facts.list_range.is_none() && is_identifier(text) && shape != Shape::Function;
    let (block, kind) = match shape {
        Shape::Coil => ("( )", "coil"),
        _ => ("[ ]", "contact"),
    };
    let written = format!("{block}( {text} )");
    let title = format!("Write {written}");
    let like_a_tag = || text.chars().count() > 3 && text.chars().any(char::is_lowercase);
    if bare && (near.is_none() || like_a_tag()) {
        return found
            .help(format!(
                "{} of the tag `{text}` is written {written}",
                with_article(kind)
            ))
            .fix(Applicability::Unsafe, title, bound.head_range(), written);
    }
    match near {
        Some(row) => {
            let mut meant = format!("did you mean {} ({})?", row.block(), in_sentence(row.title));
            if bare {
                let _ = write!(meant, " The {kind} of a tag is written {written}");
            }
            let replace = format!("Replace with {}", row.block());
            let found = found.help(meant);
            let found = found.fix(Applicability::Unsafe, replace, bound.head_range(), row.block());
            if !bare {
                return found;
            }
            found.fix(Applicability::Unsafe, title, bound.head_range(), written)
        }
        None if shape == Shape::Coil => {
            found.help("a coil is ( ), (/), (S), (R), (P), (N), (M), (SM), (RM) or (RES)")
        }
        None if shape == Shape::Function => {
            found.help("a block in < > is <LBL>, <JMP>, <FUN>, <CALL>, <RET>, <END>, <FOR>, <NEXT> or <MCR>")
        }
        None => found.help("contacts are [ ] and [/]; the language reference lists all instructions"),
    }
}
