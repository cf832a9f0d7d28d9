//! The items of a program that was read: blocks with the comments above them, and the lines around them.

use ladder_format::program::Item;
use ladder_syntax::Name;

/// The name in the header of a block, with its `$`.
pub(crate) fn block_name(header: &str) -> Name {
    Name::new(header.trim_matches(['[', ']']))
}

/// The comments directly above an item.
pub(crate) fn above(items: &[Item], at: usize) -> impl Iterator<Item = &str> {
    let comment = |item: &&Item| matches!(item, Item::Comment(_));
    let count = items[..at].iter().rev().take_while(comment).count();
    items[at - count..at].iter().filter_map(|item| match item {
        Item::Comment(told) => Some(told.as_str()),
        _ => None,
    })
}

/// The items without these blocks, and the comments above them.
pub(crate) fn without(items: Vec<Item>, is_one: &dyn Fn(&Name) -> bool) -> Vec<Item> {
    let mut out: Vec<Item> = Vec::new();
    for item in items {
        match &item {
            Item::Block { header, .. } if is_one(&block_name(header)) => {
                while matches!(out.last(), Some(Item::Comment(_))) {
                    out.pop();
                }
            }
            _ => out.push(item),
        }
    }
    out
}

/// Blank lines that nothing is left around go, and so do sections.
pub(crate) fn trim(items: &mut Vec<Item>) {
    items.retain(|item| !matches!(item, Item::Section(section) if section.declarations.is_empty()));
    items.dedup_by(|next, item| (&*next, &*item) == (&Item::Blank, &Item::Blank));
    while items.first() == Some(&Item::Blank) {
        items.remove(0);
    }
    while items.last() == Some(&Item::Blank) {
        items.pop();
    }
}
