//! The body of a block as a program of its own.

use ladder_analysis::program::{ParameterKind, Program, Role};
use std::collections::HashSet;

/// The program whose main networks are those of a block's body, and whose tags are the block's: what its networks do from any state is
/// what they do at each place of the block. Networks keep their numbers.
///
/// # Errors
/// What a network does depends on the place: why.
pub(crate) fn program(whole: &Program, block: usize) -> Result<Program, String> {
    let body = &whole.blocks[block];
    if body
        .parameters
        .iter()
        .any(|(_, kind)| *kind == ParameterKind::InOut)
    {
        // Two of them may be one tag there.
        return Err("it is in the body of a block with in-outs".into());
    }
    if !whole.functions.is_empty() {
        return Err("it is in the body of a block, in a program with functions".into());
    }
    let mut program = whole.clone();
    program.main = body.networks.clone();
    program.instances.retain(|instance| instance.block != block);
    let is_own = |tag: &ladder_analysis::program::Tag| tag.block == Some(block);
    let names = whole.tags.iter().filter(|tag| is_own(tag));
    let names: HashSet<String> = names.map(|tag| tag.name.to_ascii_lowercase()).collect();
    for tag in &mut program.tags {
        if is_own(tag) {
            tag.block = None;
            (tag.role, tag.is_input) = (Role::Internal, false);
        } else if tag.block.is_none() && names.contains(&tag.name.to_ascii_lowercase()) {
            // The body does not see it.
            tag.name = format!("{} of the program", tag.name);
        }
    }
    Ok(program)
}
