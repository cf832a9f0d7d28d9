//! Which tags functions and blocks share with the program: elementary ones and blocks are variables of the configuration, all others are
//! passed with each call. Compilers that are built on matiec hold two arrays without a name for two types, and take no block as an in-out.

use super::types::is_block;
use super::{Project, UnitKind};
use crate::network::is;
use ladder_analysis::program::{Argument, BlockKind, Expr, ExprKind, Place, RangeRef, TagId};
use ladder_analysis::values::types::{Scalar, Type};
use ladder_instructions::Op;
use std::collections::{BTreeMap, BTreeSet};

/// The tags that functions and blocks use.
#[derive(Debug, Default)]
pub(crate) struct Shared {
    /// Their names in the text.
    names: BTreeMap<String, String>,
    /// Those of the program that each unit is passed, as what it calls needs them too.
    passed: BTreeMap<UnitKind, BTreeSet<String>>,
    /// How many units call each function.
    callers: BTreeMap<usize, usize>,
    /// Units that call themselves, through others too.
    pub(crate) recursive: BTreeSet<UnitKind>,
}

impl Project<'_> {
    pub(super) fn find_shared(&mut self) {
        let mut used: BTreeMap<UnitKind, BTreeSet<String>> = BTreeMap::new();
        let mut calls: BTreeMap<UnitKind, BTreeSet<UnitKind>> = BTreeMap::new();
        for unit in self.units() {
            let (mut roots, mut called) = (Vec::new(), BTreeSet::new());
            for block in self.blocks_of(unit) {
                if let BlockKind::User(user) = block.kind {
                    called.insert(UnitKind::Block(user));
                }
                for bound in &block.arguments {
                    self.each_tag(&bound.argument, &mut |tag| roots.push(tag));
                    if let Argument::Function(function) = bound.argument
                        && is(block, Op::Call)
                    {
                        called.insert(UnitKind::Function(function));
                    }
                }
            }
            for called in &called {
                if let UnitKind::Function(function) = called {
                    *self.shared.callers.entry(*function).or_default() += 1;
                }
            }
            if unit == UnitKind::Program {
                continue;
            }
            let tags = roots.into_iter();
            let of_program = tags.filter(|id| self.source.program.tags[id.0 as usize].block.is_none());
            used.insert(unit, of_program.map(|id| self.root(id).to_owned()).collect());
            calls.insert(unit, called);
        }
        let mut reached = calls.clone();
        loop {
            let before: usize = reached.values().map(BTreeSet::len).sum();
            for (unit, called) in &calls {
                let more: BTreeSet<UnitKind> = called
                    .iter()
                    .filter_map(|unit| reached.get(unit))
                    .flatten()
                    .copied()
                    .collect();
                reached.entry(*unit).or_default().extend(more);
            }
            if reached.values().map(BTreeSet::len).sum::<usize>() == before {
                break;
            }
        }
        for root in used.values().flatten() {
            self.shared.names.insert(root.clone(), String::new());
        }
        for (unit, reached) in reached {
            if reached.contains(&unit) {
                self.shared.recursive.insert(unit);
            }
            let of_others = reached.iter().filter_map(|other| used.get(other)).flatten();
            let all = used.get(&unit).into_iter().flatten().chain(of_others);
            let passed = all.filter(|root| self.is_passed(root)).cloned().collect();
            self.shared.passed.insert(unit, passed);
        }
    }

    /// Gives the tags that are shared their names, which are the same in all units.
    pub(super) fn name_shared(&mut self) {
        for (root, name) in &mut self.shared.names {
            *name = self.given.names.name(root, "tag");
        }
    }

    /// Whether a function is called in one unit alone.
    pub(crate) fn is_called_in_one(&self, function: usize) -> bool {
        self.shared.callers.get(&function) == Some(&1)
    }

    /// Whether functions or blocks use a tag, too.
    pub(crate) fn is_shared(&self, root: &str) -> bool {
        self.shared.names.contains_key(root)
    }

    /// Whether calls pass a tag.
    pub(crate) fn is_passed(&self, root: &str) -> bool {
        self.is_shared(root)
            && match self.declared_type(None, root) {
                None => false,
                Some(Type::Scalar(scalar)) => matches!(scalar, Scalar::Enum(_)),
                Some(ty) => !is_block(ty),
            }
    }

    /// The tags that a unit is passed.
    pub(crate) fn passed(&self, unit: UnitKind) -> &BTreeSet<String> {
        static NONE: BTreeSet<String> = BTreeSet::new();
        self.shared.passed.get(&unit).unwrap_or(&NONE)
    }

    /// The name of a tag that several units share.
    pub(crate) fn name_of_shared(&self, root: &str) -> String {
        self.shared.names.get(root).cloned().unwrap_or_default()
    }

    /// The tag of a shared name.
    pub(crate) fn shared_root(&self, name: &str) -> Option<&str> {
        let mut all = self.shared.names.iter();
        all.find(|(_, own)| *own == name).map(|(root, _)| root.as_str())
    }

    /// Every tag that an argument is about.
    fn each_tag(&self, argument: &Argument, found: &mut impl FnMut(TagId)) {
        match argument {
            Argument::Value(expr) => self.tags_of(expr, found),
            Argument::Place(place, _) => self.tags_of_place(place, found),
            Argument::Parts(parts) => parts.iter().for_each(|part| self.each_tag(part, found)),
            Argument::State(tag) => found(*tag),
            Argument::ChosenState(chosen) => self.chosen(chosen).into_iter().for_each(found),
            Argument::Range(range) => self.tags_of_range(range, found),
            _ => {}
        }
    }

    fn tags_of_place(&self, place: &Place, found: &mut impl FnMut(TagId)) {
        match place {
            Place::Tag(tag) | Place::Member(tag, _) => found(*tag),
            Place::Element(tag, index) => {
                found(*tag);
                self.tags_of(index, found);
            }
            Place::Chosen(chosen) | Place::ChosenMember(chosen, _) => {
                self.chosen(chosen).into_iter().for_each(found);
            }
            Place::Bit(inner, ..) | Place::As(inner, ..) => self.tags_of_place(inner, found),
            Place::System(_) => {}
        }
    }

    fn tags_of_range(&self, range: &RangeRef, found: &mut impl FnMut(TagId)) {
        found(range.tag);
        self.tags_of(&range.first, found);
        if let Some(last) = &range.last {
            self.tags_of(last, found);
        }
    }

    fn tags_of(&self, expr: &Expr, found: &mut impl FnMut(TagId)) {
        match &expr.kind {
            ExprKind::Read(place) => self.tags_of_place(place, found),
            ExprKind::Pass(a) | ExprKind::Unary(_, a) => self.tags_of(a, found),
            ExprKind::Binary(_, a, b) | ExprKind::Compare(_, a, b) => {
                self.tags_of(a, found);
                self.tags_of(b, found);
            }
            ExprKind::Call(_, all) => all.iter().for_each(|one| self.tags_of(one, found)),
            ExprKind::Sum(range) => self.tags_of_range(range, found),
            ExprKind::Offset(subscripts) => {
                for subscript in subscripts {
                    self.tags_of(&subscript.index, found);
                }
            }
            ExprKind::Constant(_) => {}
        }
    }
}
