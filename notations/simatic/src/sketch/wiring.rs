//! The wires of a network as a drawing: in series and in parallel where they are that, else rung by rung with connectors
//! in between, else in pieces.

use super::rungs;
use crate::model::RAIL;
use ladder_format::Circuit;
use ladder_format::program::{Block, Drawing, Element, Path};
use ladder_notation::circuit::{Wires, in_order};

/// A network with more is drawn in pieces: what draws it nests as deep as its branches do.
const MOST_STRANDS: usize = 400;

/// A wire with the elements on it.
#[derive(Debug, Clone)]
pub(crate) struct Strand<T = Element> {
    pub(crate) from: usize,
    pub(crate) to: Option<usize>,
    pub(crate) elements: Vec<T>,
    /// The strands that must have run before: what they write is read here.
    pub(crate) needs: Vec<usize>,
}

impl<T> Strand<T> {
    /// A wire from a point, without elements.
    pub(crate) const fn new(from: usize, to: Option<usize>) -> Strand<T> {
        Strand {
            from,
            to,
            elements: Vec::new(),
            needs: Vec::new(),
        }
    }
}

/// What a network became.
pub(crate) enum Drawn {
    /// One network.
    Whole(Drawing),
    /// Several: the power at points goes by way of tags.
    Pieces(Vec<Drawing>),
}

/// The drawing of strands between points. `tag` makes a tag for the power at a point.
///
/// # Errors
///
/// If power would run in a circle.
pub(crate) fn drawn(
    strands: &mut [Strand],
    points: usize,
    mut tag: impl FnMut() -> String,
) -> Result<Drawn, String> {
    without_dead_ends(strands, points);
    let order = order(strands).ok_or("power would run in a circle")?;
    let is_small = strands.len() <= MOST_STRANDS;
    if is_small && let Some(circuit) = in_series_and_parallel(strands, &order, points) {
        return Ok(Drawn::Whole(Drawing::Circuit(circuit)));
    }
    if is_small
        && strands.iter().all(|strand| strand.needs.is_empty())
        && let Some(rungs) = rungs::drawn(strands)
    {
        return Ok(Drawn::Whole(Drawing::Rungs(rungs)));
    }
    let mut tags: Vec<Option<String>> = vec![None; points];
    let mut pieces = Vec::new();
    for &number in &order {
        let strand = &strands[number];
        piece_before(strands, strand.from, &mut tags, &mut pieces, &mut tag);
        if strand.to.is_none() {
            let parts = from_point(strand, &tags);
            pieces.push(Drawing::Circuit(Circuit::Series(parts)));
        }
    }
    Ok(Drawn::Pieces(pieces))
}

/// The network that puts the power at a point into a tag. All wires that end at the point are in it; in their order
/// each point is asked for after those before it.
fn piece_before(
    strands: &[Strand],
    point: usize,
    tags: &mut [Option<String>],
    pieces: &mut Vec<Drawing>,
    tag: &mut impl FnMut() -> String,
) {
    if point == RAIL || tags[point].is_some() {
        return;
    }
    let branches: Vec<Circuit<Element>> = strands
        .iter()
        .filter(|strand| strand.to == Some(point))
        .map(|strand| Circuit::Series(from_point(strand, tags)))
        .collect();
    let name = tag();
    let coil = Circuit::Element(Element::of(Block::coil(Path::tag(&name)), None));
    let before = match branches.len() {
        1 => branches.into_iter().next().unwrap_or(Circuit::Series(Vec::new())),
        _ => Circuit::Parallel(branches),
    };
    tags[point] = Some(name);
    let parts = match before {
        Circuit::Series(mut parts) => {
            parts.push(coil);
            parts
        }
        other => vec![other, coil],
    };
    pieces.push(Drawing::Circuit(Circuit::Series(parts)));
}

/// The elements of a strand, after a contact on the tag that holds the power where it begins.
fn from_point(strand: &Strand, tags: &[Option<String>]) -> Vec<Circuit<Element>> {
    let contact = tags[strand.from]
        .as_ref()
        .map(|tag| Element::of(Block::contact(Path::tag(tag)), None));
    contact
        .into_iter()
        .chain(strand.elements.iter().cloned())
        .map(Circuit::Element)
        .collect()
}

/// Where no power comes from begins at the rail, with a contact that is never closed.
fn without_dead_ends(strands: &mut [Strand], points: usize) {
    let mut is_fed = vec![false; points];
    is_fed[RAIL] = true;
    for strand in strands.iter() {
        if let Some(to) = strand.to {
            is_fed[to] = true;
        }
    }
    for strand in strands {
        if !is_fed[strand.from] {
            strand.from = RAIL;
            let never = Block::contact(Path::system("OFF"));
            strand.elements.insert(0, Element::of(never, None));
        }
    }
}

/// The strands, each after those before it. None: there is a circle.
fn order(strands: &[Strand]) -> Option<Vec<usize>> {
    #[derive(Clone, Copy, PartialEq)]
    enum State {
        New,
        Open,
        Done,
    }
    let points = strands
        .iter()
        .flat_map(|strand| [strand.from, strand.to.unwrap_or(0)])
        .max()?
        + 1;
    let mut into: Vec<Vec<usize>> = vec![Vec::new(); points];
    for (number, strand) in strands.iter().enumerate() {
        if let Some(to) = strand.to {
            into[to].push(number);
        }
    }
    let mut state = vec![State::New; strands.len()];
    let mut order = Vec::with_capacity(strands.len());
    for start in 0..strands.len() {
        let mut stack = vec![(start, 0)];
        while let Some((number, next)) = stack.pop() {
            if state[number] == State::Done {
                continue;
            }
            let strand = &strands[number];
            let own: &[usize] = if strand.from == RAIL {
                &[]
            } else {
                &into[strand.from]
            };
            let before = own
                .get(next)
                .or_else(|| strand.needs.get(next - own.len().min(next)));
            match before {
                Some(&before) => {
                    state[number] = State::Open;
                    stack.push((number, next + 1));
                    match state[before] {
                        State::Open => return None,
                        State::New => stack.push((before, 0)),
                        State::Done => {}
                    }
                }
                None => {
                    state[number] = State::Done;
                    order.push(number);
                }
            }
        }
    }
    Some(order)
}

fn in_series_and_parallel(strands: &[Strand], order: &[usize], points: usize) -> Option<Circuit<Element>> {
    let mut wires = Wires::new(points);
    let mut elements = Vec::new();
    let place = |point: usize| match point {
        RAIL => Wires::SOURCE,
        point => Wires::point(point - 1),
    };
    for strand in order.iter().map(|number| &strands[*number]) {
        let first = elements.len();
        elements.extend(&strand.elements);
        let to = strand.to.map_or(Wires::SINK, place);
        wires.add(place(strand.from), to, (first..elements.len()).collect());
    }
    let circuit = wires.into_circuit()?;
    in_order(&circuit).then(|| circuit.replaced(&|number| Circuit::Element(elements[number].clone())))
}
