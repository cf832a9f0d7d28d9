//! Networks that only say what runs.

use ladder_analysis::context::{Body, Context};
use ladder_analysis::networks::network::Meaning;
use ladder_analysis::networks::{BlockAt, NetworkAt};
use ladder_analysis::written::facts::NodeKind;
use ladder_notation::Project;
use ladder_syntax::Name;
use std::collections::HashSet;

/// The networks that are no rungs.
#[derive(Debug, Default)]
pub(in crate::write) struct Orders {
    /// The functions of which networks outside of functions say that they run.
    called: HashSet<Name>,
    /// The functions that are there for what a file runs first, where that is only such networks.
    mains: HashSet<Name>,
}

impl Orders {
    pub(super) fn add_called(&mut self, function: &str) {
        self.called.insert(Name::new(function));
    }

    pub(super) fn add_main(&mut self, function: &Name) {
        self.mains.insert(function.clone());
    }

    pub(super) fn is_main(&self, function: &Name) -> bool {
        self.mains.contains(function)
    }

    /// Whether a network says no more than what runs.
    pub(in crate::write) fn has(&self, context: &Context, network: NetworkAt<'_>) -> bool {
        match context.bodies[network.index] {
            Body::Main => ordered(context, network)
                .is_some_and(|order| self.called.contains(&Name::new(&order.function))),
            Body::Function(function) => self.mains.contains(&Name::new(&context.functions[function].name)),
            Body::Block(_) => false,
        }
    }
}

/// A network that only says that a function runs.
pub(super) struct Order {
    pub(super) function: String,
    /// Else something is there that nothing runs.
    pub(super) is_run: bool,
}

/// The function that a block calls.
pub(super) fn called(block: BlockAt<'_>) -> Option<String> {
    match block.meaning {
        Meaning::Instruction(row) if row.block() == "<CALL>" => {}
        _ => return None,
    }
    match &block.facts.operands.first()?.value.kind {
        NodeKind::Name(name) => Some(name.to_string()),
        _ => None,
    }
}

/// What a network orders, if it does nothing else.
pub(super) fn ordered(context: &Context, network: NetworkAt<'_>) -> Option<Order> {
    let blocks: Vec<BlockAt<'_>> = network.blocks().collect();
    let is_off = |block: BlockAt<'_>| {
        let text = context.parse.text_in(block.range());
        let bare: String = text.chars().filter(|c| !c.is_whitespace()).collect();
        bare.eq_ignore_ascii_case("[](SYS.OFF)")
    };
    let (call, is_run) = match blocks[..] {
        [call] => (call, true),
        [off, call] if is_off(off) => (call, false),
        _ => return None,
    };
    Some(Order {
        function: called(call)?,
        is_run,
    })
}

/// What a file runs first.
pub(super) enum First {
    Nothing,
    /// Functions of its own, one after the other.
    Calls(Vec<String>),
    /// That is a routine of its own.
    Rungs,
}

impl First {
    /// What a file of a project runs first, but for what other files run.
    pub(super) fn of(project: &Project, file: usize) -> First {
        let context = &project.analysis.context;
        let main = project.main(file);
        let is_head = |network: NetworkAt<'_>| network.blocks().count() == 1 && main.is_some();
        let is_first = |network: &NetworkAt<'_>| match context.bodies[network.index] {
            Body::Main => file == 0,
            Body::Function(function) => {
                main.is_some_and(|main| *main == Name::new(&context.functions[function].name))
            }
            Body::Block(_) => false,
        };
        let mut calls = Vec::new();
        for (number, network) in context.networks.iter().filter(is_first).enumerate() {
            if number == 0 && is_head(network) {
                continue;
            }
            let Some(order) = ordered(context, network) else {
                return First::Rungs;
            };
            let home = project.home_of_function(&order.function).map(|(file, _)| file);
            match (home == Some(file), order.is_run) {
                (true, true) => calls.push(order.function),
                (false, _) if file == 0 => {}
                _ => return First::Rungs,
            }
        }
        if calls.is_empty() {
            return First::Nothing;
        }
        First::Calls(calls)
    }
}
