//! A picture shows the wiring of its program: power that runs along its lines, from left to right and up and down,
//! comes from every block to the same blocks as in the text, whatever the picture has made of the connectors.

use ladder_analysis::analyze;
use ladder_analysis::context::Context;
use ladder_analysis::networks::NetworkAt;
use ladder_format::{Circuit, ElementKind};
use ladder_picture::shapes::{Form, Placed, Role};
use ladder_picture::{Options, Picture, picture};
use ladder_syntax::parse;
use ladder_syntax::wiring::PartKind;
use ladder_tests::generator::{Dice, Mode, program};
use std::collections::{BTreeMap, BTreeSet};
use std::sync::Arc;

/// Where power comes from or goes to: a block by its rung and part, or a rail.
type End = Option<(usize, usize)>;
/// From where to where power can come.
type Ways = BTreeSet<(End, End)>;
type At = (i32, i32);

fn drawn(text: &str) -> (Arc<Context>, Picture) {
    let context = analyze(&Arc::new(parse(text)), "program").context.clone();
    let picture = picture(&context, &Options::default());
    (context, picture)
}

/// The ways of a network by its text.
fn ways_in_text(network: NetworkAt<'_>) -> Ways {
    let wiring = &network.wiring;
    let mut other_side = BTreeMap::new();
    for point in &wiring.points {
        other_side.insert((point.upper, point.down), (point.upper + 1, point.up));
        other_side.insert((point.upper + 1, point.up), (point.upper, point.down));
    }
    let mut ways = Ways::new();
    for (rung, parts) in wiring.rungs.iter().map(|rung| &rung.parts).enumerate() {
        for (part, it) in parts.iter().enumerate() {
            let from = match it.kind {
                PartKind::LeftRail => None,
                PartKind::Block => Some((rung, part)),
                _ => continue,
            };
            let mut open = vec![(rung, part)];
            let mut seen = BTreeSet::new();
            while let Some((rung, part)) = open.pop() {
                let parts = &wiring.rungs[rung].parts;
                let Some(next) = parts.get(part + 1) else { continue };
                let at = (rung, part + 1);
                if next.segment.is_none() || next.segment != parts[part].segment || !seen.insert(at) {
                    continue;
                }
                match next.kind {
                    PartKind::Block => {
                        ways.insert((from, Some(at)));
                    }
                    PartKind::RightRail => {
                        ways.insert((from, None));
                    }
                    _ => open.extend([Some(at), other_side.get(&at).copied()].into_iter().flatten()),
                }
            }
        }
    }
    ways
}

/// A network of a picture, as its lines alone.
#[derive(Default)]
struct Lines {
    wires: Vec<(At, At)>,
    verticals: Vec<(At, At)>,
    rails: Vec<i32>,
    placed: Vec<Placed>,
}

impl Lines {
    fn of(picture: &Picture, network: usize) -> Lines {
        let mut lines = Lines::default();
        let is_network = |block: &&ladder_picture::shapes::Block| match block.kind {
            ladder_picture::shapes::BlockKind::Network { index, .. } => index == network,
            _ => false,
        };
        let block = picture.blocks.iter().find(is_network).expect("it is drawn");
        for shape in &picture.shapes[block.shapes.clone()] {
            let Form::Line(from, to) = shape.form else {
                continue;
            };
            match shape.role {
                Role::Wire => lines.wires.push((from, to)),
                Role::Node => lines.verticals.push((from, to)),
                Role::Rail => lines.rails.push(from.0),
                Role::Symbol => {}
            }
        }
        let placed = picture.placed.iter();
        lines.placed = placed
            .filter(|it| it.element.network == network)
            .copied()
            .collect();
        lines
    }

    /// The places that vertical lines join with this one, itself included.
    fn joined_to(&self, at: At) -> BTreeSet<At> {
        let mut places = BTreeSet::from([at]);
        let mut open = vec![at];
        while let Some((x, y)) = open.pop() {
            for (upper, lower) in &self.verticals {
                if upper.0 == x && (upper.1..=lower.1).contains(&y) {
                    let new = [*upper, *lower].into_iter().filter(|&place| places.insert(place));
                    open.extend(new);
                }
            }
        }
        places
    }

    /// The number of vertical lines that do not touch another.
    fn bundles(&self) -> usize {
        let bundles: BTreeSet<_> = self.verticals.iter().map(|line| self.joined_to(line.0)).collect();
        bundles.len()
    }

    fn ways(&self) -> Ways {
        let mut ways = Ways::new();
        let left_rail = self.rails.iter().min().copied();
        let from_rail = self.wires.iter().filter(|(from, _)| Some(from.0) == left_rail);
        let mut sources: Vec<(End, At)> = from_rail.map(|(from, _)| (None, *from)).collect();
        let end = |placed: &Placed| Some((placed.element.rung, placed.element.part));
        for placed in &self.placed {
            sources.push((end(placed), (placed.columns.1, placed.wire)));
        }
        for (source, start) in sources {
            let mut seen = BTreeSet::new();
            let mut open = vec![start];
            while let Some(at) = open.pop() {
                for at in self.joined_to(at) {
                    if !seen.insert(at) {
                        continue;
                    }
                    let here = |placed: &&Placed| (placed.columns.0, placed.wire) == at;
                    if let Some(block) = self.placed.iter().find(here) {
                        ways.insert((source, end(block)));
                        continue;
                    }
                    if self.rails.contains(&at.0) && Some(at.0) != left_rail {
                        ways.insert((source, None));
                        continue;
                    }
                    open.extend(self.wires.iter().filter(|wire| wire.0 == at).map(|wire| wire.1));
                }
            }
        }
        ways
    }

    /// Nothing lies on anything else.
    fn check_room(&self, text: &str) {
        for (number, placed) in self.placed.iter().enumerate() {
            let (left, right) = placed.columns;
            for other in &self.placed[number + 1..] {
                let next_to = other.columns.0 >= right || other.columns.1 <= left;
                let apart = other.rows.0 >= placed.rows.1 || other.rows.1 <= placed.rows.0;
                assert!(next_to || apart, "{placed:?} lies on {other:?}\n{text}");
            }
            for (upper, lower) in &self.verticals {
                let next_to = upper.0 <= left || upper.0 >= right;
                let apart = upper.1 >= placed.rows.1 || lower.1 <= placed.rows.0;
                assert!(next_to || apart, "a line at {upper:?} crosses {placed:?}\n{text}");
            }
            for (from, to) in &self.wires {
                let next_to = to.0 <= left || from.0 >= right;
                assert!(
                    next_to || from.1 != placed.wire,
                    "a wire crosses {placed:?}\n{text}"
                );
            }
        }
        for (from, to) in &self.wires {
            assert!(from.0 < to.0 && from.1 == to.1, "{from:?} {to:?}\n{text}");
        }
    }
}

fn check(text: &str) -> usize {
    let (context, picture) = drawn(text);
    let mut checked = 0;
    for (index, network) in context.networks.iter().enumerate() {
        if network.broken {
            continue;
        }
        let lines = Lines::of(&picture, index);
        assert_eq!(lines.ways(), ways_in_text(network), "network {index} of\n{text}");
        lines.check_room(text);
        checked += 1;
    }
    checked
}

#[test]
fn power_goes_the_same_ways_in_the_picture() {
    let mut checked = 0;
    for mode in [Mode::Boolean, Mode::Wild, Mode::Sensible, Mode::Typed] {
        for seed in 0..150 {
            checked += check(&program(seed, mode));
        }
    }
    assert!(checked > 1000, "only {checked} networks were checked");
}

#[test]
fn branches_that_are_only_partly_one_line() {
    for text in [
        // One line down to both, and a wire from elsewhere to the second.
        "+--[ ]( s )--\\--[ ]( a )--( )( x )--+\n|            /--\\--( )( y )--+\n+--[ ]( c )-----/            |\n",
        // The same, read from the other end.
        "+--[ ]( a )--\\--( )( x )--+\n+--[ ]( b )--/--\\--( )( y )--+\n+--[ ]( c )-----/\n",
        // Two connectors next to each other that only one line can join.
        "+--\\--\\--( )( x )--+\n   /--[ ]( a )--/--( )( y )--+\n",
        "+--\\--[ ]( a )--\\--( )( x )--+\n   /--\\  /--\\--/\n      /-----/\n",
        // Bare wire next to bare wire.
        "+--\\--\\--( )( x )--+\n   /--/\n",
        "+--\\--\\--\\--( )( x )--+\n   /--/--/--( )( y )--+\n",
        // A comment between two connectors needs its place.
        "+--\\--[ ]( a )--\\--( )( y )--+\n   /--# why #--\\--[ ]( b )--/\n   /--[ ]( c )--( )( z )--+\n",
    ] {
        check(text);
    }
}

/// What a made circuit consists of, drawn as contacts.
type Made = Circuit<String>;

fn series(dice: &mut Dice, depth: usize, names: &mut usize) -> Made {
    let element = |names: &mut usize| {
        *names += 1;
        Circuit::Element(format!("[ ]( {} )", &"tag_with_a_name"[..=*names * 7 % 14]))
    };
    let mut parts = vec![element(names)];
    for _ in 0..dice.below(3) {
        if depth > 0 {
            let branches = 2 + dice.below(4);
            let branches = (0..branches).map(|_| series(dice, depth - 1, names));
            parts.push(Circuit::Parallel(branches.collect()));
        }
        parts.push(element(names));
    }
    Circuit::Series(parts)
}

fn parallels(circuit: &Made) -> usize {
    match circuit {
        Circuit::Element(_) => 0,
        Circuit::Series(parts) => parts.iter().map(parallels).sum(),
        Circuit::Parallel(parts) => 1 + parts.iter().map(parallels).sum::<usize>(),
    }
}

#[test]
fn branches_begin_at_one_line_and_end_at_one() {
    let mut met = 0;
    for seed in 0..100 {
        let circuit = series(&mut Dice::new(seed), 2, &mut 0);
        let text = circuit.draw(&ladder_format::Options::default(), "\n", |text| {
            (ElementKind::Condition, text.as_str())
        });
        assert_eq!(check(&text), 1, "{text}");
        let (_, picture) = drawn(&text);
        let bundles = Lines::of(&picture, 0).bundles();
        assert_eq!(bundles, 2 * parallels(&circuit), "{text}");
        met += parallels(&circuit);
    }
    assert!(met > 100, "only {met} times branches");
}
