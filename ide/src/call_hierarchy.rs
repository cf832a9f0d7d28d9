//! Who calls a function or holds a user-defined block, and what it calls and holds itself.

use crate::body;
use crate::definition::defined;
use crate::neighbour::{Workspace, named};
use crate::symbol::{Found, Symbol, Usage, everywhere, find};
use crate::target::Target;
use ladder_analysis::context::{Body, Context};
use ladder_instructions::Op;
use ladder_syntax::{Name, TextRange, TextSize};
use std::sync::Arc;

/// Something that calls or is called.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Caller {
    /// What it is.
    pub kind: CallerKind,
    /// As written; of a program the name of its file.
    pub name: String,
    /// Where it is, and its name in it.
    pub target: Target,
}

/// What calls or is called.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum CallerKind {
    /// The main program of a file.
    Program,
    /// A function.
    Function,
    /// A user-defined block.
    Block,
}

/// The calls between two of them.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Calls {
    /// The other one.
    pub other: Caller,
    /// Where the calls are, in the file of the one that calls.
    pub places: Vec<TextRange>,
}

/// The functions or blocks that are named at an offset.
pub fn callers_at(context: &Context, offset: TextSize, workspace: &dyn Workspace) -> Vec<Caller> {
    let found = find(context, offset);
    let Some(Found { symbol, .. }) = found else {
        return Vec::new();
    };
    callees(context, &symbol, workspace)
}

/// Everything that calls a function, or holds a block; nothing calls a program.
pub fn incoming_calls(context: &Context, of: &Caller, workspace: &dyn Workspace) -> Vec<Calls> {
    let Some(symbol) = symbol(of) else {
        return Vec::new();
    };
    let mut calls: Vec<Calls> = Vec::new();
    for (file, places) in everywhere(context, &symbol, workspace) {
        with_file(context, &file, workspace, |file| {
            for place in places.iter().filter(|place| place.usage == Usage::Mention) {
                if let Some(network) = network_at(file, place.range.start()) {
                    let caller = caller(file, file.bodies[network]);
                    enter(&mut calls, caller, place.range);
                }
            }
        });
    }
    calls
}

/// All functions and blocks that one calls or holds.
pub fn outgoing_calls(context: &Context, of: &Caller, workspace: &dyn Workspace) -> Vec<Calls> {
    let mut named: Vec<(Symbol, TextRange)> = Vec::new();
    with_file(context, &of.target.file, workspace, |file| {
        let context = file;
        let Some(wanted) = body_of(context, of) else {
            return;
        };
        for (network, body) in context.networks.iter().zip(context.bodies.iter()) {
            if *body != wanted {
                continue;
            }
            for block in network.blocks() {
                let at = match (block.user_name(), block.op()) {
                    (Some(_), _) => block.head_range().start() + TextSize::new(1),
                    (None, Some(Op::Call)) => match block.facts.operands.first() {
                        Some(operand) => block.absolute(operand.value.range).start(),
                        None => continue,
                    },
                    _ => continue,
                };
                if let Some(found) = find(file, at) {
                    named.push((found.symbol, found.range));
                }
            }
        }
    });
    let mut calls = Vec::new();
    for (symbol, place) in named {
        for callee in callees(context, &symbol, workspace) {
            enter(&mut calls, callee, place);
        }
    }
    calls
}

fn enter(calls: &mut Vec<Calls>, other: Caller, place: TextRange) {
    match calls.iter_mut().find(|calls| calls.other == other) {
        Some(calls) => calls.places.push(place),
        None => calls.push(Calls {
            other,
            places: vec![place],
        }),
    }
}

/// What calls of a function, or uses of a block, refer to.
fn callees(context: &Context, symbol: &Symbol, workspace: &dyn Workspace) -> Vec<Caller> {
    let kind = match symbol {
        Symbol::Function { .. } => CallerKind::Function,
        Symbol::Block { .. } => CallerKind::Block,
        _ => return Vec::new(),
    };
    // Of several of one name the first counts.
    let targets = defined(context, symbol, workspace).into_iter().take(1);
    let mut callers = Vec::new();
    for target in targets {
        let file = Arc::clone(&target.file);
        with_file(context, &file, workspace, |file| {
            let name = crate::outline::text_of(&file.parse, target.focus);
            callers.push(Caller {
                kind,
                name,
                target: target.clone(),
            });
        });
    }
    callers
}

fn symbol(of: &Caller) -> Option<Symbol> {
    let (file, name) = (Arc::clone(&of.target.file), Name::new(&of.name));
    match of.kind {
        CallerKind::Program => None,
        CallerKind::Function => Some(Symbol::Function { file, name }),
        CallerKind::Block => Some(Symbol::Block { file, name }),
    }
}

fn body_of(context: &Context, of: &Caller) -> Option<Body> {
    let name = Name::new(&of.name);
    match of.kind {
        CallerKind::Program => Some(Body::Main),
        CallerKind::Function => context.function(&name).map(Body::Function),
        CallerKind::Block => {
            let blocks = &context.user_blocks[..context.own_blocks];
            blocks.iter().position(|block| block.key == name).map(Body::Block)
        }
    }
}

fn caller(file: &Context, body: Body) -> Caller {
    let context = file;
    let whole = TextRange::up_to(context.parse.text_len());
    let (kind, name, focus) = match body {
        Body::Main => (
            CallerKind::Program,
            file.name.to_string(),
            TextRange::empty(TextSize::new(0)),
        ),
        Body::Function(function) => {
            let facts = &context.functions[function];
            (CallerKind::Function, facts.name.to_string(), facts.at)
        }
        Body::Block(block) => {
            let facts = &context.user_blocks[block];
            let at = crate::symbol::block_name(context, facts.at).unwrap_or(facts.at);
            (CallerKind::Block, facts.name.clone(), at)
        }
    };
    let range = match body {
        Body::Main => whole,
        _ => body::extent(context, body).unwrap_or(focus),
    };
    Caller {
        kind,
        name,
        target: Target {
            file: Arc::clone(&file.name),
            range,
            focus,
        },
    }
}

fn network_at(context: &Context, offset: TextSize) -> Option<usize> {
    let line = context.parse.line_at(offset)?;
    context.networks.on_line(line).map(|network| network.index)
}

fn with_file(context: &Context, name: &str, workspace: &dyn Workspace, act: impl FnOnce(&Context)) {
    let own = context;
    if own.is_called(name) {
        return act(own);
    }
    if let Some(neighbour) = named(workspace, name) {
        act(&neighbour);
    }
}

#[cfg(test)]
mod tests {
    use super::{Calls, callers_at, incoming_calls, outgoing_calls};
    use crate::fixture::Fixture;
    use expect_test::{Expect, expect};

    fn check(text: &str, expected: Expect) {
        let fixture = Fixture::new(text);
        let (context, offset, others) = fixture.ask();
        let mut shown = String::new();
        for item in callers_at(context, offset, &others) {
            let target = &item.target;
            shown += &format!("{:?} {}\n", item.kind, fixture.show(&target.file, target.focus));
            let mut list = |way: &str, calls: Vec<Calls>, file: Option<&str>| {
                for call in calls {
                    let other = &call.other.target;
                    let name = &call.other.name;
                    shown += &format!("  {way} {:?} {name} in {}:", call.other.kind, other.file);
                    for place in call.places {
                        let place = fixture.show(file.unwrap_or(&other.file), place);
                        shown += &format!(" {}", place.split_once(':').unwrap().1);
                    }
                    shown += "\n";
                }
            };
            list("from", incoming_calls(context, &item, &others), None);
            let outgoing = outgoing_calls(context, &item, &others);
            list("to", outgoing, Some(&target.file));
        }
        expected.assert_eq(&shown);
    }

    #[test]
    fn functions_and_blocks_call_each_other() {
        let plant = "%% main.clad\n+--<CALL>( count )--[$Hold]( a, b )--+\n+--<CALL>( cou$0nt )--+\n\
             +--<FUN>( twice )--<CALL>( count )--<CALL>( COUNT )--+\n\
             FUNCTION_BLOCK [$Hold]\nVAR_INPUT i : BOOL; END_VAR\nVAR_OUTPUT o : BOOL; END_VAR\n\
             +--<CALL>( count )--[$Other]( i )--+\nEND_FUNCTION_BLOCK\n\
             %% lib.clad\n+--<FUN>( count )--<CALL>( helper )--[$Other]( x )--+\n+--<CALL>( count )--<CALL>( none )--+\n\
             +--<FUN>( helper )--+\n\
             FUNCTION_BLOCK [$Other]\nVAR_INPUT i : BOOL; END_VAR\n+--( )( ENO )--+\nEND_FUNCTION_BLOCK\n";
        check(
            plant,
            expect![[r#"
            Function lib.clad:1:11 count
              from Program main.clad in main.clad: 1:12 count 2:12 count
              from Function twice in main.clad: 3:28 count 3:45 COUNT
              from Block $Hold in main.clad: 7:12 count
              from Function count in lib.clad: 2:12 count
              to Function helper in lib.clad: 1:28 helper
              to Block $Other in lib.clad: 1:39 $Other
              to Function count in lib.clad: 2:12 count
        "#]],
        );
        check(
            &plant
                .replace("cou$0nt", "count")
                .replace("[$Hold]( a", "[$Ho$0ld]( a"),
            expect![[r#"
                Block main.clad:4:17 $Hold
                  from Program main.clad in main.clad: 1:22 $Hold
                  to Function count in lib.clad: 7:12 count
                  to Block $Other in lib.clad: 7:22 $Other
            "#]],
        );
        check(
            &plant
                .replace("cou$0nt", "count")
                .replace("( helper )--[", "( hel$0per )--["),
            expect![[r#"
                Function lib.clad:3:11 helper
                  from Function count in lib.clad: 1:28 helper
            "#]],
        );
        check("+--[ ]( a$0 )--<CALL>( x )--+\n", expect![[""]]);
        check("+--<CALL>( x$0 )--+\n", expect![[""]]);
    }
}
