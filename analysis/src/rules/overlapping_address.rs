//! `overlapping-address`: two direct addresses that would share memory in a controller, and do not here.
//!
//! Addresses count in units of their own size, as in IEC 61131-3 and CODESYS: `%IW1` is the bytes 2 and 3.

use crate::context::Context;
use crate::diagnostic::Diagnostic;
use crate::rule::Rule;
use crate::scope::TagFacts;

/// Looks at the tags that have an address.
pub(crate) fn check<'c>(
    context: &'c Context,
    addressed: impl Iterator<Item = &'c TagFacts>,
    out: &mut Vec<Diagnostic>,
) {
    let mut areas: Vec<Area<'_>> = addressed.filter_map(Area::of).collect();
    let start = |area: &Area<'_>| context.place_of(area.tag).start();
    areas.sort_by(|a, b| a.order().cmp(&b.order()).then_with(|| start(a).cmp(&start(b))));
    // Areas are of few sizes and begin at a multiple of their own: one is within another, or beside it.
    let mut around: Vec<usize> = Vec::new();
    // For each area those that it overlaps and that come before it.
    let mut earlier: Vec<Vec<usize>> = vec![Vec::new(); areas.len()];
    for (inner, area) in areas.iter().enumerate() {
        around.retain(|&outer| areas[outer].letter == area.letter && area.first <= areas[outer].last);
        // What is at one address is one tag.
        let is_other = |outer: &&usize| areas[**outer].order() != area.order();
        for &outer in around.iter().filter(is_other) {
            if start(&areas[outer]) < start(area) {
                earlier[inner].push(outer);
            } else {
                earlier[outer].push(inner);
            }
        }
        // Of tags at one address the first stands for all.
        if around
            .last()
            .is_none_or(|&outer| areas[outer].order() != area.order())
        {
            around.push(inner);
        }
    }
    for (area, mut earlier) in areas.iter().zip(earlier) {
        earlier.sort_by_cached_key(|&other| start(&areas[other]));
        let earlier = earlier.into_iter().map(|other| &areas[other]);
        out.extend(overlapping(context, area, earlier));
    }
}

/// The bits that an address takes.
#[derive(Clone, Copy)]
struct Area<'c> {
    letter: u8,
    first: u64,
    last: u64,
    address: &'c str,
    tag: &'c TagFacts,
}

impl<'c> Area<'c> {
    /// None for addresses of more levels, and for single bits without their byte: systems differ there.
    fn of(tag: &'c TagFacts) -> Option<Area<'c>> {
        let address = tag.rare.address.as_deref()?;
        let mut letters = address.strip_prefix('%')?.bytes();
        let letter = letters.next()?.to_ascii_uppercase();
        let size = letters.next()?.to_ascii_uppercase();
        let numbers = address.get(3..)?;
        let first = match (size, numbers.split_once('.')) {
            (b'X', Some((byte, bit))) => {
                let bit: u64 = bit.parse().ok().filter(|bit| *bit < 8)?;
                byte.parse::<u64>().ok()?.checked_mul(8)?.checked_add(bit)?
            }
            (b'X', None) | (_, Some(_)) => return None,
            _ => numbers.parse::<u64>().ok()?.checked_mul(bits(size)?)?,
        };
        Some(Area {
            letter,
            first,
            last: first.checked_add(bits(size)? - 1)?,
            address,
            tag,
        })
    }

    /// Areas that hold others come before them.
    fn order(&self) -> (u8, u64, std::cmp::Reverse<u64>) {
        (self.letter, self.first, std::cmp::Reverse(self.last))
    }
}

const fn bits(size: u8) -> Option<u64> {
    Some(match size {
        b'X' => 1,
        b'B' => 8,
        b'W' => 16,
        b'D' => 32,
        b'L' => 64,
        _ => return None,
    })
}

/// The finding at an address that overlaps others, which are in the order of their places.
fn overlapping<'c>(
    context: &Context,
    area: &Area<'_>,
    mut earlier: impl Iterator<Item = &'c Area<'c>>,
) -> Option<Diagnostic> {
    let first = earlier.next()?;
    let name = |area: &Area<'_>| {
        if area.tag.name == area.address {
            format!("`{}`", area.address)
        } else {
            format!("`{}` at {}", area.tag.name, area.address)
        }
    };
    let found = Diagnostic::new(
        Rule::OverlappingAddress,
        context.place_of(area.tag),
        format!(
            "{} and {} would share memory in a controller; here each is a tag of its own",
            name(area),
            name(first)
        ),
    )
    .help(
        "use one address for one thing: name a bit of the word (tag.3), or put the bits into it with [PACK]",
    );
    let all = std::iter::once(first).chain(earlier);
    Some(all.fold(found, |found, other| {
        found.related(context.place_of(other.tag), format!("{} is here", name(other)))
    }))
}
