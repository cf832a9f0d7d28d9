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
    areas.sort_by_key(|area| (area.letter, area.first, std::cmp::Reverse(area.last)));
    // In this order an area overlaps the widest one before it, if it overlaps any.
    let mut widest: Option<Area<'_>> = None;
    for area in areas {
        let overlapped = widest.filter(|wide| wide.letter == area.letter && area.first <= wide.last);
        if let Some(wide) = overlapped {
            out.push(overlapping(context, &area, &wide));
        }
        if overlapped.is_none_or(|wide| area.last > wide.last) {
            widest = Some(area);
        }
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

fn overlapping(context: &Context, area: &Area<'_>, wide: &Area<'_>) -> Diagnostic {
    let (later, earlier) = if context.place_of(area.tag).start() < context.place_of(wide.tag).start() {
        (wide, area)
    } else {
        (area, wide)
    };
    let name = |area: &Area<'_>| {
        if area.tag.name == area.address {
            format!("`{}`", area.address)
        } else {
            format!("`{}` at {}", area.tag.name, area.address)
        }
    };
    Diagnostic::new(
        Rule::OverlappingAddress,
        context.place_of(later.tag),
        format!(
            "{} and {} would share memory in a controller; here each is a tag of its own",
            name(later),
            name(earlier)
        ),
    )
    .help(
        "use one address for one thing: name a bit of the word (tag.3), or put the bits into it with [PACK]",
    )
    .related(
        context.place_of(earlier.tag),
        format!("{} is here", name(earlier)),
    )
}
