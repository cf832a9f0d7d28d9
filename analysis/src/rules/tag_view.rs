//! A tag with its uses, for the rules about it.

use super::double_coil::Leaving;
use super::undeclared_tag::Undeclaring;
use crate::context::Context;
use crate::names::scope::{Origin, SectionKind, TagFacts};
use crate::networks::control_flow::ControlFlow;
use crate::networks::use_kind::Effect;
use crate::other_files::outward::TagUse;
use crate::program::Role;
use crate::values::types::Type;
use ladder_syntax::Name;
use rustc_hash::FxHashMap;
use std::cell::RefCell;

/// A tag, and what of the rest of the file decides about it.
pub(crate) struct TagView<'c> {
    pub(super) context: &'c Context,
    pub(super) tag: &'c TagFacts,
    /// Index of its scope; 0 is the file's.
    pub(super) scope: usize,
    pub(super) around: &'c AroundTags<'c>,
    /// How many places of the file use it, by whichever of the names of its address.
    pub(super) places: Places,
    /// How the other files of the workspace use it, if it is a VAR_GLOBAL tag.
    elsewhere: TagUse,
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

/// What the rules about tags need to know of the rest of the file.
pub(crate) struct AroundTags<'c> {
    context: &'c Context,
    /// What the networks of the file have together of program flow.
    pub(super) any: ControlFlow,
    pub(super) leaving: Leaving,
    pub(super) undeclaring: Undeclaring<'c>,
    /// The file has outputs. In one that has none, its internal tags are what people look at.
    has_outputs: bool,
    /// The places that use what several names at one address mean, by this address: counted once for all of these names.
    at_addresses: RefCell<FxHashMap<Name, Places>>,
}

impl<'c> AroundTags<'c> {
    /// `any` is what the networks of the file have together of program flow.
    pub(crate) fn of(context: &'c Context, any: ControlFlow) -> AroundTags<'c> {
        AroundTags {
            context,
            any,
            leaving: Leaving::of(context, any),
            undeclaring: Undeclaring::of(context),
            has_outputs: context.scopes[0].tags.iter().any(|tag| tag.role == Role::Output),
            at_addresses: RefCell::default(),
        }
    }

    /// The places that use a tag, by whichever of the names of its address.
    fn places(&self, tag: &TagFacts) -> Places {
        let mut places = Places::default();
        let mut others = self.context.others_at_address(tag).peekable();
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

impl<'c> TagView<'c> {
    pub(crate) fn new(scope: usize, tag: &'c TagFacts, around: &'c AroundTags<'c>) -> TagView<'c> {
        let mut view = TagView {
            context: around.context,
            tag,
            scope,
            around,
            places: around.places(tag),
            elsewhere: TagUse::default(),
        };
        if view.is_global() {
            view.elsewhere = around.context.others.tag_use(&Name::new(&tag.name));
        }
        view
    }

    /// Whether the file has outputs, or it is a tag of a body.
    pub(super) fn has_outputs(&self) -> bool {
        self.around.has_outputs || self.scope > 0
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
    fn is_global(&self) -> bool {
        self.tag.origin == Origin::Declared(SectionKind::Global)
    }

    /// Whether what this file does with it is all that is done: no other file uses it, it is no alias of another tag, and its
    /// declaration can be read.
    pub(super) fn is_all_known(&self) -> bool {
        let is_shared = matches!(
            self.tag.origin,
            Origin::Shared
                | Origin::Implicit
                | Origin::Declared(SectionKind::Global | SectionKind::External | SectionKind::InOut)
        );
        !is_shared && !self.tag.mistyped
    }

    /// Whether this file is where it is reported that nothing reads or writes it.
    pub(super) fn reports_use(&self) -> bool {
        // A global is reported in the first file that declares it.
        let counts = if self.is_global() {
            !self.tag.mistyped && !self.context.others.is_declared_before(&Name::new(&self.tag.name))
        } else {
            self.is_all_known()
        };
        // A file of declarations only has just been begun, unless others use them.
        let has_begun =
            !self.context.networks.is_empty() || (self.is_global() && self.context.others.have_files());
        counts && has_begun
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
            match place.effect() {
                Effect::Sets => self.sets += 1,
                Effect::Resets => self.resets += 1,
                _ => {}
            }
        }
    }
}
