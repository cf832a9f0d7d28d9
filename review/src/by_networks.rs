//! What is known of whole programs by their networks, without running them.

use crate::comparison::{Change, Comparison};
use crate::independence::Touched;
use crate::meaning::number;
use crate::outline::{Entry, Kind};
use crate::used::Used;
use crate::verdict::Verdict;
use crate::words::{heading, reason};
use ladder_analysis::program::{Program, Role, Tag, TagId};
use ladder_prover::{Meaning, other_tags};
use ladder_syntax::Name;
use rustc_hash::{FxHashMap, FxHashSet};
use std::cell::Cell;
use std::sync::Arc;

/// So many pairs of networks are asked whether their order matters.
const MOST_PASSED: usize = 20_000_000;

/// Comments that hold this are for the tools.
const DIRECTIVE: &str = "ladder:";

/// Whether the networks say it one by one: all must be there in both and do the same, in an order that is the same or does not
/// matter.
///
/// # Errors
/// They do not: why.
pub(crate) fn by_networks(comparison: &Comparison<'_>) -> Result<(), Vec<String>> {
    let is_as_written = |change: &Change<'_>| is_harmless(change) && change.meaning.is_none();
    if comparison.uses.is_empty() && comparison.changes.iter().all(is_as_written) {
        return Ok(());
    }
    let programs = comparison.programs().map_err(|cause| vec![cause])?;
    let sides = programs.each_ref().map(|program| Touches::of(program));
    let mut open: Vec<String> = comparison.uses.iter().map(Used::to_string).collect();
    let order = Order::of(comparison);
    for change in &comparison.changes {
        let may_be_here = || order.is_free(change, &sides[1]);
        if is_harmless(change) || is_header(change) || is_unused(change, &programs, &sides) {
            continue;
        }
        if change.moved && change.entry().kind == Kind::Network && says_the_same(change) && may_be_here() {
            continue;
        }
        if change.entry().kind == Kind::Unread {
            open.push(change.entry().title.clone());
            continue;
        }
        let mut told = heading(comparison, change);
        if let Some(reason) = reason(change) {
            told.push_str(&format!(": {reason}"));
        }
        if change.moved && says_the_same(change) {
            told.push_str(": it has passed others, and the order may matter");
        }
        open.push(told);
    }
    if programs[0].profiles.first() != programs[1].profiles.first() || programs[0].cycle != programs[1].cycle
    {
        open.push("other settings hold".to_owned());
    }
    for tag in other_tags(&programs[0], &programs[1]) {
        open.push(format!("{tag} is declared or used differently"));
    }
    if open.is_empty() { Ok(()) } else { Err(open) }
}

/// Whether a change cannot matter by itself.
pub(crate) fn is_harmless(change: &Change<'_>) -> bool {
    let is_as_before = !change.moved && matches!(change.verdict, Verdict::Same | Verdict::Redrawn);
    if directs(change) && !is_as_before {
        return false;
    }
    change.entry().kind == Kind::Comment
        || (!(change.moved && has_order(change.entry())) && says_the_same(change))
}

/// Whether a comment in it or above it is one for the tools.
fn directs(change: &Change<'_>) -> bool {
    let mut forms = [change.old, change.new].into_iter().flatten();
    forms.any(|entry| {
        entry.comments.contains(DIRECTIVE)
            || (entry.kind == Kind::Comment && entry.told.key.contains(DIRECTIVE))
    })
}

/// Whether its place among the others says something: networks run in their order, operands and values are given in that of the
/// declarations, and a setting holds for what is below it.
fn has_order(entry: &Entry) -> bool {
    let in_order = [Kind::Structure, Kind::Block].map(Kind::text);
    matches!(entry.kind, Kind::Network | Kind::Setting)
        || in_order.iter().any(|word| entry.place.starts_with(word))
}

fn says_the_same(change: &Change<'_>) -> bool {
    matches!(
        change.verdict,
        Verdict::Same | Verdict::Redrawn | Verdict::Commented | Verdict::Value
    ) || change.meaning == Some(Meaning::Same)
}

/// Whether it is the first line of a section that only one program has: what is declared in it is asked for itself.
fn is_header(change: &Change<'_>) -> bool {
    let entry = change.entry();
    let is_of_one = matches!(change.verdict, Verdict::New | Verdict::Gone);
    entry.kind == Kind::Section && entry.place.is_empty() && is_of_one
}

/// Whether it declares tags that only one program has, which uses and shows none of them.
fn is_unused(change: &Change<'_>, programs: &[Arc<Program>; 2], sides: &[Touches; 2]) -> bool {
    let entry = change.entry();
    if entry.kind != Kind::Declaration || !entry.place.is_empty() {
        return false;
    }
    let (own, other) = match change.verdict {
        Verdict::New => (1, 0),
        Verdict::Gone => (0, 1),
        _ => return false,
    };
    entry.names.iter().all(|name| {
        let parts = sides[own].declared.get(name);
        let is_idle =
            |tag: &TagId| !sides[own].used.contains(tag) && is_hidden(&programs[own].tags[tag.0 as usize]);
        parts.is_some_and(|parts| parts.iter().all(is_idle)) && !sides[other].declared.contains_key(name)
    })
}

/// Whether nothing outside a program sees a tag, nor what it was after a restart.
fn is_hidden(tag: &Tag) -> bool {
    tag.role != Role::Output && !tag.shared && !tag.retain && tag.address.is_none()
}

/// What the networks of a program touch.
struct Touches {
    networks: Vec<Touched>,
    used: FxHashSet<TagId>,
    /// The tags that each declared one is in the program, where it has parts.
    declared: FxHashMap<Name, Vec<TagId>>,
    /// An unread part of another task may write between any two networks.
    is_interrupted: bool,
}

impl Touches {
    fn of(program: &Program) -> Touches {
        let networks = program.networks.iter();
        let networks: Vec<Touched> = networks.map(|network| Touched::by(program, network)).collect();
        let mut declared: FxHashMap<Name, Vec<TagId>> = FxHashMap::default();
        let tags = (0..).map(TagId).zip(&program.tags);
        for (id, tag) in tags.filter(|(_, tag)| tag.block.is_none()) {
            let name = tag.name.split(['.', '[']).next().unwrap_or_default();
            declared.entry(Name::new(name)).or_default().push(id);
        }
        Touches {
            used: networks.iter().flat_map(Touched::tags).collect(),
            networks,
            declared,
            is_interrupted: program
                .unread_parts()
                .any(|(_, _, unread)| unread.directive.at_any_time),
        }
    }
}

/// The numbers of all networks that both programs have, in the old and in the new one.
struct Order<'c> {
    comparison: &'c Comparison<'c>,
    both: Vec<(usize, usize)>,
    /// So many pairs of networks are still asked about.
    left: Cell<usize>,
}

impl<'c> Order<'c> {
    fn of(comparison: &'c Comparison<'c>) -> Order<'c> {
        let networks = comparison
            .changes
            .iter()
            .filter(|change| change.entry().kind == Kind::Network);
        let both = networks.filter_map(|change| numbers(comparison, change));
        Order {
            comparison,
            both: both.collect(),
            left: Cell::new(MOST_PASSED),
        }
    }

    /// Whether a network that has moved may change places with each of those that it has passed. Where another task may write between
    /// any two networks, none may.
    fn is_free(&self, change: &Change<'_>, touches: &Touches) -> bool {
        if touches.is_interrupted {
            return false;
        }
        let Some((old, new)) = numbers(self.comparison, change) else {
            return false;
        };
        let Some(left) = self.left.get().checked_sub(self.both.len()) else {
            return false;
        };
        self.left.set(left);
        let own = &touches.networks[new];
        let has_passed = |(was, is): &&(usize, usize)| (old < *was) != (new < *is) && *was != old;
        let mut passed = self.both.iter().filter(has_passed);
        passed.all(|(_, is)| own.may_swap(&touches.networks[*is]))
    }
}

fn numbers(comparison: &Comparison<'_>, change: &Change<'_>) -> Option<(usize, usize)> {
    let old = number((comparison.old, change.old?))?;
    Some((old, number((comparison.new, change.new?))?))
}
