//! Where networks, functions and blocks of the files are in the program that they make up together.

use crate::names::context::{Body, Callee, Context};
use crate::written::import::Import;
use rustc_hash::{FxHashMap, FxHashSet};
use std::cell::Cell;

/// A file that takes part in a program.
pub(crate) struct Unit<'c> {
    /// Its names, networks and blocks.
    pub(crate) context: &'c Context,
    /// Its name in messages.
    pub(crate) name: &'c str,
    /// The bodies that the program can reach. None: all, as in the program's own file.
    pub(crate) bodies: Option<FxHashSet<Body>>,
    /// Where it is a plant, what it is called: nothing of it is a tag of the program.
    pub(crate) plant: Option<&'c str>,
}

impl Unit<'_> {
    pub(crate) fn reaches(&self, body: Body) -> bool {
        self.bodies.as_ref().is_none_or(|bodies| bodies.contains(&body))
    }
}

/// The numbers that the program knows things by.
pub(crate) struct Numbers {
    /// For each unit its networks; none: not part of the program.
    networks: Vec<Vec<Option<usize>>>,
    functions: FxHashMap<(usize, usize), usize>,
    blocks: FxHashMap<(usize, usize), usize>,
    units: FxHashMap<String, usize>,
    /// Something was asked for that no unit has.
    lacking: Cell<bool>,
}

impl Numbers {
    pub(crate) fn of(units: &[Unit<'_>]) -> Numbers {
        let mut numbers = Numbers {
            networks: Vec::with_capacity(units.len()),
            functions: FxHashMap::default(),
            blocks: FxHashMap::default(),
            units: FxHashMap::default(),
            lacking: Cell::new(false),
        };
        let mut next = 0;
        for (index, unit) in units.iter().enumerate() {
            let context = unit.context;
            // Every body is one range: main first, then functions, then blocks.
            let mut order: Vec<usize> = (0..context.networks.len())
                .filter(|&network| unit.reaches(context.bodies[network]))
                .collect();
            order.sort_by_key(|&network| (context.bodies[network], network));
            let mut networks = vec![None; context.networks.len()];
            for network in order {
                networks[network] = Some(next);
                next += 1;
            }
            numbers.networks.push(networks);
            let functions = 0..context.functions.len();
            for item in functions.filter(|&item| unit.reaches(Body::Function(item))) {
                let number = numbers.functions.len();
                numbers.functions.insert((index, item), number);
            }
            for item in (0..context.own_blocks).filter(|&item| unit.reaches(Body::Block(item))) {
                let number = numbers.blocks.len();
                numbers.blocks.insert((index, item), number);
            }
            numbers.units.insert(unit.name.to_owned(), index);
        }
        numbers
    }

    /// The number of a unit's network.
    pub(super) fn network(&self, unit: usize, network: usize) -> Option<usize> {
        self.networks[unit][network]
    }

    pub(super) fn has_function(&self, unit: usize, item: usize) -> bool {
        self.functions.contains_key(&(unit, item))
    }

    pub(super) fn has_block(&self, unit: usize, item: usize) -> bool {
        self.blocks.contains_key(&(unit, item))
    }

    /// The number of a function that a unit calls.
    pub(super) fn function(&self, unit: usize, callee: &Callee) -> usize {
        let found = match callee {
            Callee::Own(item) => self.functions.get(&(unit, *item)),
            Callee::Other(import) => self.import(&self.functions, import),
        };
        self.or_lacking(found)
    }

    /// The number of a block that a unit uses, by its index in the unit's context.
    pub(super) fn block(&self, unit: usize, context: &Context, index: usize) -> usize {
        self.or_lacking(self.block_if_reached(unit, context, index))
    }

    /// The same of one that a part of the unit may use which the program does not reach.
    pub(super) fn block_if_reached(&self, unit: usize, context: &Context, index: usize) -> Option<&usize> {
        match &context.user_blocks[index].import {
            None => self.blocks.get(&(unit, index)),
            Some(import) => self.import(&self.blocks, import),
        }
    }

    /// The number of a block by its scope in a unit.
    pub(super) fn block_of_scope(&self, unit: usize, scope: usize) -> Option<usize> {
        self.blocks.get(&(unit, scope.checked_sub(1)?)).copied()
    }

    /// Whether everything that was asked for is there.
    pub(super) fn are_whole(&self) -> bool {
        !self.lacking.get()
    }

    fn import<'n>(&self, of: &'n FxHashMap<(usize, usize), usize>, import: &Import) -> Option<&'n usize> {
        let unit = self.units.get(&*import.file)?;
        of.get(&(*unit, import.item))
    }

    /// A program that lacks something is thrown away: any number does.
    fn or_lacking(&self, found: Option<&usize>) -> usize {
        if found.is_none() {
            self.lacking.set(true);
        }
        found.copied().unwrap_or(0)
    }
}
