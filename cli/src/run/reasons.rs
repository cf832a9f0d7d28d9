//! Words for why a tag holds what it holds, with the places of a program's files.

use ladder_analysis::program::Location;
use ladder_simulator::Wording;
use ladder_workspace::Member;

/// Asks with the words for a program of these files, which are called so.
pub(crate) fn with_wording<T>(
    members: &[Member],
    files: &[String],
    ask: impl FnOnce(&Wording<'_>) -> T,
) -> T {
    let texts: Vec<&str> = members.iter().map(Member::ladder).collect();
    let places = |block: Location| members.get(block.file as usize)?.translated_place(block.range);
    ask(&Wording::new(&texts, files).with_places(&places))
}
