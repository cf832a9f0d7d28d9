//! A tag with its uses, for the rules about it.

use super::double_coil::Leaving;
use super::parts::{Part, Parts, Touched};
use super::undeclared_tag::Undeclaring;
use crate::names::context::Context;
use crate::names::scope::{Origin, SectionKind, TagFacts};
use crate::networks::control_flow::ControlFlow;
use crate::other_files::outward::TagUse;
use crate::program::Role;
use ladder_syntax::Name;
use rustc_hash::FxHashMap;
use std::cell::{OnceCell, RefCell};

/// A tag, and what of the rest of the file decides about it.
pub(crate) struct TagView<'c> {
    pub(super) context: &'c Context,
    pub(super) tag: &'c TagFacts,
    /// Index of its scope; 0 is the file's.
    pub(super) scope: usize,
    pub(super) around: &'c AroundTags<'c>,
    /// What the places of the file do with it, by whichever of the names of its address.
    pub(super) places: Touched,
    parts: OnceCell<Parts>,
    /// How the other files of the workspace use it, if it is a VAR_GLOBAL tag.
    elsewhere: TagUse,
    /// What unread parts may do with it.
    pub(super) unread: TagUse,
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
    at_addresses: RefCell<FxHashMap<Name, Touched>>,
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
    fn places(&self, tag: &TagFacts) -> Touched {
        let mut others = self.context.others_at_address(tag).peekable();
        let shared = tag.address().filter(|_| others.peek().is_some());
        let Some(address) = shared else {
            return Touched::of(self.context, tag);
        };
        *self.at_addresses.borrow_mut().entry(address).or_insert_with(|| {
            let mut places = Touched::of(self.context, tag);
            others.for_each(|other| places.add(&Touched::of(self.context, other)));
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
            parts: OnceCell::new(),
            elsewhere: TagUse::default(),
            unread: around.context.unread.done_with(scope, tag),
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
        self.places.reads > 0 || self.elsewhere.read || self.unread.read
    }

    /// Whether something writes it, in whichever file.
    pub(super) fn is_written(&self) -> bool {
        self.places.writes > 0 || self.elsewhere.written || self.unread.written
    }

    /// The parts of it that places mean.
    pub(super) fn parts(&self) -> impl Iterator<Item = Part<'_>> {
        let parts = || Parts::of(self.context, self.tag, &self.places);
        self.parts.get_or_init(parts).each()
    }

    /// Whether it is a VAR_GLOBAL tag that this file declares.
    fn is_global(&self) -> bool {
        self.tag.origin == Origin::Declared(SectionKind::Global)
    }

    /// Whether what this file does with it is all that is done: no other file uses it, it is not an alias of another tag, and its
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
