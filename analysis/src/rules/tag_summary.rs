//! How a tag is used in the whole program, for the rules about that.

use super::{input_written, never_read, never_written, set_without_reset};
use crate::context::Context;
use crate::findings::diagnostic::Diagnostic;
use crate::findings::rule::Rule;
use crate::names::scope::{Origin, SectionKind, TagFacts};
use crate::networks::use_kind::Deed;
use crate::other_files::outward::TagUse;
use crate::program::Role;
use crate::values::types::Type;
use ladder_syntax::Name;
use rustc_hash::FxHashMap;
use std::cell::RefCell;

/// How a tag is used, counted over all its places.
pub(super) struct Summary<'c> {
    pub(super) context: &'c Context,
    pub(super) tag: &'c TagFacts,
    /// Index of its scope; 0 is the file's.
    pub(super) scope: usize,
    /// The file has outputs. In one that has none, its internal tags are what people look at.
    pub(super) has_outputs: bool,
    /// How many places of the file use it, by whichever of the names of its address.
    pub(super) places: Places,
    /// How the other files of the workspace use it, if it is a VAR_GLOBAL tag.
    pub(super) elsewhere: TagUse,
}

/// How many places use a tag.
#[derive(Debug, Clone, Copy, Default)]
pub(super) struct Places {
    pub(super) reads: usize,
    pub(super) writes: usize,
    /// Those of the writing ones that set it. A timer or counter is not set.
    pub(super) sets: usize,
    /// Those that reset it, likewise.
    pub(super) resets: usize,
}

/// What is counted once for all tags of a file.
pub(crate) struct Summaries {
    /// The file has outputs. In one that has none, its internal tags are what people look at.
    has_outputs: bool,
    /// The places that use what several names at one address mean, by this address.
    at_addresses: RefCell<FxHashMap<Name, Places>>,
}

impl<'c> Summary<'c> {
    fn new(context: &'c Context, (scope, tag): (usize, &'c TagFacts), summaries: &Summaries) -> Summary<'c> {
        let mut summary = Summary {
            has_outputs: summaries.has_outputs || scope > 0,
            context,
            tag,
            scope,
            places: summaries.places(context, tag),
            elsewhere: TagUse::default(),
        };
        if summary.is_global() {
            summary.elsewhere = context.others.tag_use(&Name::new(&tag.name));
        }
        summary
    }

    /// Whether something reads it, in whichever file.
    pub(super) fn is_read(&self) -> bool {
        self.places.reads > 0 || self.elsewhere.read
    }

    /// Whether something writes it, in whichever file.
    pub(super) fn is_written(&self) -> bool {
        self.places.writes > 0 || self.elsewhere.written
    }

    /// Whether it is a VAR_GLOBAL tag that this file declares.
    pub(super) fn is_global(&self) -> bool {
        self.tag.origin == Origin::Declared(SectionKind::Global)
    }

    /// Whether other files may use it as well, or it stands for another tag: what this file does with it is not
    /// all that is done.
    pub(super) fn is_shared(&self) -> bool {
        matches!(
            self.tag.origin,
            Origin::Shared
                | Origin::Implicit
                | Origin::Declared(SectionKind::Global | SectionKind::External | SectionKind::InOut)
        )
    }
}

impl Places {
    fn add(&mut self, tag: &TagFacts) {
        for access in tag.uses.accesses() {
            self.reads += usize::from(access.reads());
            self.writes += usize::from(access.writes());
        }
        if matches!(tag.ty, Some(Type::State(_))) {
            return;
        }
        for place in tag.uses.writers() {
            match place.deed() {
                Deed::Sets => self.sets += 1,
                Deed::Resets => self.resets += 1,
                _ => {}
            }
        }
    }
}

impl Summaries {
    pub(super) fn of(context: &Context) -> Summaries {
        let mut tags = context.scopes[0].tags.iter();
        Summaries {
            has_outputs: tags.any(|tag| tag.role == Role::Output),
            at_addresses: RefCell::default(),
        }
    }

    /// The places that use a tag, by whichever of the names of its address.
    fn places(&self, context: &Context, tag: &TagFacts) -> Places {
        let mut places = Places::default();
        let mut others = context.others_at_address(tag).peekable();
        let shared = tag.address().filter(|_| others.peek().is_some());
        let Some(address) = shared else {
            places.add(tag);
            return places;
        };
        *self.at_addresses.borrow_mut().entry(address).or_insert_with(|| {
            places.add(tag);
            others.for_each(|other| places.add(other));
            places
        })
    }
}

/// Asks the rules about the use of a tag.
pub(super) fn check(
    context: &Context,
    (scope, tag): (usize, &TagFacts),
    summaries: &Summaries,
    out: &mut Vec<Diagnostic>,
) {
    if tag.mistyped {
        return;
    }
    let summary = Summary::new(context, (scope, tag), summaries);
    input_written::check(&summary, out);
    // A global is reported in the first file that declares it.
    let counts = if summary.is_global() {
        !context.others.is_declared_before(&Name::new(&tag.name))
    } else {
        !summary.is_shared()
    };
    // A file of declarations only has just been begun, unless others use them.
    let has_begun = !context.networks.is_empty() || (summary.is_global() && context.others.have_files());
    if counts && has_begun {
        never_read::check(&summary, out);
        never_written::check(&summary, out);
    }
    if !summary.is_shared() {
        set_without_reset::check(&summary, out);
    }
}

/// What is known of the file as a whole.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq)]
pub(crate) struct Known {
    /// See [`Survey`](super::survey::Survey).
    pub(crate) whole: bool,
    /// No tag is undeclared that should not be: a slip in a name is one finding.
    pub(crate) names: bool,
}

/// When what a rule says of a tag's use or of a body is true.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum When {
    Always,
    /// Where the file as a whole is known.
    Whole,
    /// Where its names are known too.
    WholeAndNames,
}

impl When {
    /// When what a rule finds is true.
    pub(crate) const fn of(rule: Rule) -> When {
        match rule {
            Rule::NeverRead | Rule::NeverWritten => When::WholeAndNames,
            Rule::SetWithoutReset
            | Rule::ResetWithoutSet
            | Rule::ReadBeforeWrite
            | Rule::Unreachable
            | Rule::EndlessJump
            | Rule::UnconditionalEnd
            | Rule::UnbalancedLoop
            | Rule::UnusedFunction
            | Rule::UnusedLabel => When::Whole,
            _ => When::Always,
        }
    }

    /// Whether a rule is silent because of mistakes elsewhere: that it finds nothing says nothing then.
    pub(crate) fn is_silent(rule: Rule, known: Known) -> bool {
        let when = When::of(rule);
        matches!(when, When::Whole | When::WholeAndNames) && !when.holds(known)
    }

    /// Whether it is true where so much is known.
    pub(crate) const fn holds(self, known: Known) -> bool {
        match self {
            When::Always => true,
            When::Whole => known.whole,
            When::WholeAndNames => known.whole && known.names,
        }
    }
}
