//! What instances of Add-On Instructions begin with. An instance has no initial value here: where an input of it begins
//! with another value than the instruction has for all, the first scan writes it.

use crate::scope::CONTROLLER;
use crate::sketch::{Sketcher, alone, network};
use crate::types::Elem;
use crate::values::{Value, literal};
use ladder_format::Circuit;
use ladder_format::program::{Block, Expression, Item, Operand, Path};
use ladder_instructions::Op;

impl Sketcher<'_> {
    /// The networks for the instances that are declared in some scopes.
    pub(crate) fn begin(&self, of: impl Fn(usize) -> bool) -> Vec<Item> {
        let first = Block::contact(Path::system("FIRST_SCAN"));
        let networks = self.instances(of).into_iter();
        let networks = networks.map(|(name, blocks)| set(&first, &name, blocks));
        networks.flatten().collect()
    }

    /// Those for the instances in a body, which may not run in the first scan.
    pub(crate) fn begin_in_body(&mut self, scope: usize) -> Vec<Item> {
        debug_assert!(scope > CONTROLLER + self.translator.project.programs.len());
        let mut instances = self.instances(|of| of == scope);
        let Some((_, last)) = instances.last_mut() else {
            return Vec::new();
        };
        let what = "helper: the inputs of the instances in it are written";
        let done = self.translator.tags.helper(scope, "begun", Elem::Bool, what);
        last.extend(Block::of(Op::SetCoil, [done.clone()]));
        let first = Block::negated_contact(done);
        let networks = instances.into_iter();
        let networks = networks.map(|(name, blocks)| set(&first, &name, blocks));
        networks.flatten().collect()
    }

    /// The blocks that write inputs, for each tag with instances in it.
    fn instances(&self, of: impl Fn(usize) -> bool) -> Vec<(String, Vec<Block>)> {
        let tags = &self.translator.tags;
        let mut all: Vec<(String, Vec<Block>)> = Vec::new();
        for begins in &tags.begins {
            let symbol = &tags.symbols[begins.symbol];
            if !of(symbol.declared_in()) {
                continue;
            }
            let is_on = begins.value != Value::Int(0);
            let input = begins.input.clone();
            let block = match (begins.elem, is_on) {
                (Elem::Bool, true) => Block::of(Op::SetCoil, [input]),
                (Elem::Bool, false) => Block::of(Op::ResetCoil, [input]),
                (elem, _) => Expression::literal(literal(&begins.value, elem))
                    .and_then(|value| Block::of(Op::Mov, [Operand::from(input), value.into()])),
            };
            match all.last_mut() {
                Some((name, blocks)) if *name == symbol.name => blocks.extend(block),
                _ => all.push((symbol.name.clone(), block.into_iter().collect())),
            }
        }
        all
    }
}

fn set(first: &Block, name: &str, blocks: Vec<Block>) -> [Item; 2] {
    let comment = format!("The inputs that {name} begins with");
    let blocks = std::iter::once(first.clone()).chain(blocks);
    let blocks = blocks.map(|block| alone(block, None)).collect();
    [Item::Blank, network(vec![comment], Circuit::Series(blocks))]
}
