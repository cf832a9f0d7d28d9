//! Blocks that do nothing without power. One of ladder text runs all the same, one of other systems does not.

use ladder_analysis::program::{BlockKind, Network, Program, TagId, UserBlock};

/// Whether the body of a block begins with `+--[/]( EN )--<RET>--+`, and nothing else in it knows the power: then it does the same
/// where a block without power does not run.
pub fn is_guarded(program: &Program, block: &UserBlock) -> bool {
    let networks = &program.networks[block.networks.clone()];
    let Some((first, rest)) = networks.split_first() else {
        return false;
    };
    let heads = first.blocks.iter().map(|block| match block.kind {
        BlockKind::Instruction(row) => row.block(),
        BlockKind::User(_) => String::new(),
    });
    heads.eq(["[/]", "<RET>"])
        && uses(&networks[..1], block.en)
        && !uses(rest, block.en)
        && !uses(rest, block.eno)
}

/// Whether anything in some networks names a tag.
pub fn uses(networks: &[Network], tag: TagId) -> bool {
    let blocks = networks.iter().flat_map(|network| &network.blocks);
    blocks.flat_map(|block| &block.arguments).any(|bound| {
        let mut places = bound.places().into_iter();
        bound.argument.root() == Some(tag) || places.any(|(place, _)| place.root() == Some(tag))
    })
}
