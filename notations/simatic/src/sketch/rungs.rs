//! Strands that are more than what is in series and in parallel, as rungs with connectors.
//!
//! Each rung is one way through the network. Where a point is on several rungs, each is joined to the next of them; on
//! the rungs in between the connection passes in a segment of its own, to the left or the right of what is there.

use super::wiring::Strand;
use crate::model::RAIL;
use ladder_format::program::{Element, RungPiece};

/// A network has no more rungs.
const MOST_RUNGS: usize = 64;

/// A way through the network: what is on it, from a point on.
pub(crate) struct Way<'s, T = Element> {
    pub(crate) from: usize,
    pub(crate) pieces: Vec<Piece<'s, T>>,
}

/// What is on a way.
pub(crate) enum Piece<'s, T = Element> {
    Element(&'s T),
    Point(usize),
}

/// Which way power takes from one rung to the next.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Flow {
    /// From the lower rung to the upper one.
    Up,
    Down,
    Both,
}

/// Two rungs that are joined at a point.
struct Join {
    point: usize,
    upper: usize,
    lower: usize,
    flow: Flow,
}

/// What is on a rung: elements, and the ends of joins.
#[derive(Clone, Copy, PartialEq)]
enum Sign<'s> {
    Rail,
    Element(&'s Element),
    Down(usize),
    Up(usize),
}

/// The rungs. None: they would cross.
pub(super) fn drawn(strands: &[Strand]) -> Option<Vec<Vec<RungPiece>>> {
    let ways = ways(strands);
    if ways.len() > MOST_RUNGS {
        return None;
    }
    let joins = joins(&ways);
    let mut rungs = Vec::with_capacity(ways.len());
    // The joins that come from the rung above, from left to right.
    let mut incoming: Vec<usize> = Vec::new();
    for (number, way) in ways.iter().enumerate() {
        let own = signs(way, number, &joins);
        let segments = placed(own, number, &incoming, &joins)?;
        let signs = || segments.iter().flatten();
        incoming = signs()
            .filter_map(|sign| match sign {
                Sign::Down(join) => Some(*join),
                _ => None,
            })
            .collect();
        rungs.push(pieces(&segments));
    }
    incoming.is_empty().then_some(rungs)
}

/// Each strand goes on with the first after it that nothing has taken yet.
pub(crate) fn ways<T>(strands: &[Strand<T>]) -> Vec<Way<'_, T>> {
    let mut is_taken = vec![false; strands.len()];
    let mut ways = Vec::new();
    for first in 0..strands.len() {
        if is_taken[first] {
            continue;
        }
        let mut way = Way {
            from: strands[first].from,
            pieces: Vec::new(),
        };
        let mut next = Some(first);
        while let Some(number) = next {
            is_taken[number] = true;
            let strand = &strands[number];
            way.pieces.extend(strand.elements.iter().map(Piece::Element));
            next = None;
            if let Some(point) = strand.to {
                way.pieces.push(Piece::Point(point));
                next = (0..strands.len()).find(|other| !is_taken[*other] && strands[*other].from == point);
            }
        }
        ways.push(way);
    }
    ways
}

/// Where a point is on a way: its number, whether power comes to it there, and whether it goes on.
struct Stop {
    way: usize,
    comes: bool,
    goes: bool,
}

fn joins(ways: &[Way<'_>]) -> Vec<Join> {
    let mut stops: std::collections::BTreeMap<usize, Vec<Stop>> = std::collections::BTreeMap::new();
    for (number, way) in ways.iter().enumerate() {
        if way.from != RAIL {
            let stop = Stop {
                way: number,
                comes: false,
                goes: true,
            };
            stops.entry(way.from).or_default().push(stop);
        }
        for (at, piece) in way.pieces.iter().enumerate() {
            if let Piece::Point(point) = piece {
                let stop = Stop {
                    way: number,
                    comes: true,
                    goes: at + 1 < way.pieces.len(),
                };
                stops.entry(*point).or_default().push(stop);
            }
        }
    }
    let mut joins = Vec::new();
    for (point, stops) in stops {
        for (at, pair) in stops.windows(2).enumerate() {
            let (upper, lower) = (pair[0].way, pair[1].way);
            let comes = stops[at + 1..].iter().any(|stop| stop.comes);
            let goes = stops[at + 1..].iter().any(|stop| stop.goes);
            let flows: &[Flow] = match (comes, goes) {
                _ if at == 0 && lower == upper + 1 => &[Flow::Both],
                (true, true) => &[Flow::Up, Flow::Down],
                (true, false) => &[Flow::Up],
                (false, _) => &[Flow::Down],
            };
            joins.extend(flows.iter().map(|flow| Join {
                point,
                upper,
                lower,
                flow: *flow,
            }));
        }
    }
    joins
}

/// What is on the rung of a way, with its joins at their points.
fn signs<'s>(way: &Way<'s>, number: usize, joins: &[Join]) -> Vec<Sign<'s>> {
    let mut signs = Vec::new();
    let at_point = |point: usize, signs: &mut Vec<Sign<'s>>| {
        let all = || joins.iter().enumerate().filter(|(_, join)| join.point == point);
        let down = |flows: [Flow; 2]| {
            all().filter(move |(_, join)| join.upper == number && flows.contains(&join.flow))
        };
        signs.extend(down([Flow::Up, Flow::Up]).map(|(join, _)| Sign::Down(join)));
        signs.extend(
            all()
                .filter(|(_, join)| join.lower == number)
                .map(|(join, _)| Sign::Up(join)),
        );
        signs.extend(down([Flow::Down, Flow::Both]).map(|(join, _)| Sign::Down(join)));
    };
    match way.from {
        RAIL => signs.push(Sign::Rail),
        point => at_point(point, &mut signs),
    }
    for piece in &way.pieces {
        match piece {
            Piece::Element(element) => signs.push(Sign::Element(element)),
            Piece::Point(point) => at_point(*point, &mut signs),
        }
    }
    signs
}

/// The segments of a rung: what is on it, and what passes to its left and right. None: something would cross it.
fn placed<'s>(
    own: Vec<Sign<'s>>,
    number: usize,
    incoming: &[usize],
    joins: &[Join],
) -> Option<Vec<Vec<Sign<'s>>>> {
    let ups: Vec<usize> = own
        .iter()
        .filter_map(|sign| match sign {
            Sign::Up(join) => Some(*join),
            _ => None,
        })
        .collect();
    let ends_here = |join: &usize| joins[*join].lower == number;
    let first = incoming.iter().position(ends_here).unwrap_or(0);
    let here: Vec<usize> = incoming.iter().copied().filter(ends_here).collect();
    // What ends here is in one row, in the order of the rung.
    if here != ups || incoming[first..].iter().take(here.len()).ne(here.iter()) {
        return None;
    }
    let pass = |join: &usize| match joins[*join].flow {
        Flow::Up => vec![Sign::Down(*join), Sign::Up(*join)],
        _ => vec![Sign::Up(*join), Sign::Down(*join)],
    };
    let left: Vec<Vec<Sign<'_>>> = incoming[..first].iter().map(pass).collect();
    if own.first() == Some(&Sign::Rail) && !left.is_empty() {
        return None;
    }
    let mut segments = left;
    segments.push(own);
    segments.extend(incoming[first + here.len()..].iter().map(pass));
    Some(segments)
}

fn pieces(segments: &[Vec<Sign<'_>>]) -> Vec<RungPiece> {
    let mut pieces = Vec::new();
    for (number, segment) in segments.iter().enumerate() {
        if number > 0 {
            pieces.push(RungPiece::Gap);
        }
        pieces.extend(segment.iter().map(|sign| match sign {
            Sign::Rail => RungPiece::Rail,
            Sign::Element(element) => RungPiece::Element((*element).clone()),
            Sign::Down(_) => RungPiece::Down,
            Sign::Up(_) => RungPiece::Up,
        }));
    }
    let from_rail = segments.first().and_then(|segment| segment.first()) == Some(&Sign::Rail);
    if from_rail && matches!(pieces.last(), Some(RungPiece::Element(_))) {
        pieces.push(RungPiece::Rail);
    }
    pieces
}
