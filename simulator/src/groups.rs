//! Tags that open: an array is a group of its elements, a timer one of its members.
//!
//! Whatever lists tags asks here what a tag opens into: the tables of a run, the screen, the views of the editors.

use crate::layout::{self, Home, MemberSlot};
use crate::members::shown;
use crate::memory::TextSlot;
use crate::tags::{Point, PointSlot, Within};
use ladder_analysis::program::{Program, Role, Tag};
use ladder_analysis::values::types::Type;
use ladder_instructions::StateType;

/// Of an array with more elements than this a list of all tags has none: it would be a list of that array.
const MOST_LISTED: u64 = 256;

/// A tag as a list shows it.
#[derive(Debug, Clone, PartialEq)]
pub enum Entry {
    /// One value.
    Value(Point),
    /// What opens.
    Group(Group),
}

/// A tag that opens into others.
#[derive(Debug, Clone, PartialEq)]
pub struct Group {
    /// As declared, or as first written.
    pub name: String,
    /// As declared: `ARRAY[1..2] OF BOOL`.
    pub ty: String,
    /// Input, output or neither.
    pub role: Role,
    /// It is a constant.
    pub read_only: bool,
    /// How many it opens into.
    pub parts: u64,
    /// Which timer, counter or bistable it is.
    pub state: Option<StateType>,
}

impl Group {
    /// Whether what it opens into are elements.
    pub fn is_array(&self) -> bool {
        self.ty.starts_with("ARRAY[")
    }
}

impl Point {
    /// Whether it is in what a path names: `a[3].b` in `a`, `a[3]`, and itself.
    pub fn is_in(&self, path: &str) -> bool {
        is_in(&self.name, path)
    }

    /// Which element of it, or bit of one: `[3]` of `a[3]`.
    pub fn index(&self) -> Option<&str> {
        self.name.find('[').map(|at| &self.name[at..])
    }
}

fn is_in(name: &str, path: &str) -> bool {
    let Some((start, rest)) = name.split_at_checked(path.len()) else {
        return false;
    };
    start.eq_ignore_ascii_case(path) && (rest.is_empty() || rest.starts_with(['.', '[']))
}

/// Every value that a list of all tags has, in the order of the program's tags.
pub(crate) fn points(program: &Program, homes: &[Home]) -> Vec<Point> {
    let listed = own(program, homes).filter(|(tag, _)| !is_long(tag));
    listed.flat_map(|(tag, home)| parts(program, tag, home)).collect()
}

/// The tags outside of the bodies of user-defined blocks, which exist once for each place.
pub(crate) fn own<'p>(program: &'p Program, homes: &'p [Home]) -> impl Iterator<Item = (&'p Tag, Home)> {
    let all = program.tags.iter().zip(homes.iter().copied());
    all.filter(|(tag, _)| tag.block.is_none())
}

/// Whether an array has too many elements for a list of all tags.
pub(crate) fn is_long(tag: &Tag) -> bool {
    matches!(tag.ty, Type::Array { first, last, .. } if last.abs_diff(first) >= MOST_LISTED)
}

/// What a tag opens into; one that does not open is its only part.
pub(crate) fn parts<'p>(
    program: &'p Program,
    tag: &'p Tag,
    home: Home,
) -> impl Iterator<Item = Point> + use<'p> {
    let (first, last) = match tag.ty {
        Type::Array { first, last, .. } => (first, last),
        // Read as an array of one.
        Type::Scalar(_) => (0, 0),
        Type::State(_) | Type::Compound(_) => (0, -1),
    };
    (first..=last)
        .filter_map(move |at| element(tag, home, at))
        .chain(state_points(program, tag, home))
}

/// The members of a timer, counter or bistable that show what it does.
pub(crate) fn state_points<'p>(
    program: &'p Program,
    tag: &'p Tag,
    home: Home,
) -> impl Iterator<Item = Point> + use<'p> {
    let members = match home {
        Home::State { state, .. } => shown(state),
        _ => &[],
    };
    members.iter().filter_map(move |&(name, member)| {
        let Home::State { state, bits, words } = home else {
            return None;
        };
        let slot = match layout::member(state, bits, words, member)? {
            MemberSlot::Bit(slot) => PointSlot::Bit(slot),
            MemberSlot::Word(slot) => PointSlot::Word(slot),
            MemberSlot::Timing { .. } => return None,
        };
        Some(Point {
            name: format!("{}.{name}", tag.name),
            ty: program.member_type(tag, member),
            role: tag.role,
            is_input: tag.is_input,
            read_only: tag.constant,
            within: Within::State(state),
            slot,
        })
    })
}

/// An element of an array, by its index; an elementary tag is itself.
pub(crate) fn element(tag: &Tag, home: Home, index: i64) -> Option<Point> {
    let (name, ty, offset) = match tag.ty {
        Type::Scalar(ty) => (tag.name.clone(), ty, 0),
        Type::Array { first, last, element } if (first..=last).contains(&index) => {
            (tag.element_name(index), element, (index - first) as u32)
        }
        _ => return None,
    };
    let slot = match home {
        Home::Bits { at, .. } => PointSlot::Bit(at.offset(offset)),
        Home::Words { at, .. } => PointSlot::Word(at.offset(offset)),
        Home::Texts { at, .. } => PointSlot::Text(TextSlot(at.0 + offset)),
        _ => return None,
    };
    Some(Point {
        name,
        ty,
        role: tag.role,
        is_input: tag.is_input,
        read_only: tag.constant,
        within: Within::of(tag),
        slot,
    })
}

/// `a[2..5]`, `g[1, 2..5]`: what is before the range, and its ends.
pub(crate) fn range_of(text: &str) -> Option<(&str, i64, i64)> {
    let inside = text.trim().strip_suffix(']')?;
    let (before, range) = inside.split_at(inside.rfind(['[', ','])? + 1);
    let (first, last) = range.split_once("..")?;
    Some((before, first.trim().parse().ok()?, last.trim().parse().ok()?))
}
