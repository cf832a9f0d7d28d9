//! Which tags of `SYS` a unit names: [`along`](crate::along) has globals for them.

use super::unit::Unit;
use ladder_analysis::context::Body;
use ladder_analysis::program::SystemTag;

/// The key of a system tag among the names of a unit.
pub(super) fn key(tag: SystemTag) -> String {
    format!("SYS.{}", tag.name())
}

/// Whether there is a global for it: ON and OFF are literals, and nothing there counts faults.
fn is_written(tag: SystemTag) -> bool {
    !matches!(tag, SystemTag::On | SystemTag::Off | SystemTag::Fault)
}

/// The system tags that the networks of a unit name: of the program of the file, or of one of its blocks.
pub(super) fn used(unit: &Unit<'_>, block: Option<usize>) -> Vec<SystemTag> {
    let context = unit.context();
    let own = context
        .networks
        .iter()
        .filter(|network| match (context.bodies[network.index], block) {
            (Body::Block(own), Some(block)) => own == block,
            (Body::Block(_), None) | (_, Some(_)) => false,
            (_, None) => true,
        });
    let text: String = own
        .map(|network| unit.text[network.range].to_ascii_uppercase())
        .collect();
    let is_named = |tag: &SystemTag| {
        let key = key(*tag);
        text.match_indices(&key).any(|(at, _)| {
            let next = text[at + key.len()..].chars().next();
            !next.is_some_and(|c| c.is_alphanumeric() || c == '_')
        })
    };
    let all = SystemTag::ALL.into_iter();
    all.filter(|tag| is_written(*tag)).filter(is_named).collect()
}
