//! The columns against the rules as they are written, applied again and again until nothing changes.

use super::*;
use proptest::prelude::*;

const SPACING: Spacing = 2;

/// Every element starts far left and is pushed by its neighbour and its partner until all distances hold.
fn pushed_left(sketch: &Sketch) -> Vec<u32> {
    let railed =
        |r: &Range<u32>| sketch.elements.get(r.start as usize).map(|e| e.kind) == Some(ElementKind::LeftRail);
    let margin = if sketch.rungs.iter().any(railed) {
        1 + SPACING
    } else {
        0
    };
    let mut columns = vec![0; sketch.elements.len()];
    loop {
        let before = columns.clone();
        for rung in &sketch.rungs {
            for at in rung.clone().map(|n| n as usize) {
                let element = &sketch.elements[at];
                let at_rail = matches!(element.kind, ElementKind::LeftRail | ElementKind::LeftBar);
                let least = if at > rung.start as usize {
                    columns[at - 1] + sketch.elements[at - 1].width + apart(sketch, at)
                } else if at_rail {
                    0
                } else {
                    margin
                };
                columns[at] = columns[at].max(least);
                if element.partner != NONE {
                    columns[at] = columns[at].max(columns[element.partner as usize]);
                }
            }
        }
        if columns == before {
            return columns;
        }
        hold_stubs(sketch, &mut columns);
    }
}

/// How far an element and the one before it are apart: a stub is part of the wire.
fn apart(sketch: &Sketch, at: usize) -> u32 {
    let stubs = [at - 1, at].map(|n| sketch.elements[n].kind == ElementKind::Stub);
    if sketch.elements[at].joined && stubs.contains(&true) {
        0
    } else {
        SPACING
    }
}

/// Where a wire begins at nothing it is two dashes long, so that its stub comes along with what it leads to.
fn hold_stubs(sketch: &Sketch, columns: &mut [u32]) {
    for at in (1..columns.len()).rev() {
        if sketch.elements[at].joined && sketch.elements[at - 1].kind == ElementKind::Stub {
            columns[at - 1] = columns[at] - sketch.elements[at - 1].width;
        }
    }
}

/// What moves, by taking away what does not until all that is left may.
fn moving(sketch: &Sketch) -> Vec<bool> {
    let mut moves: Vec<bool> = sketch.elements.iter().map(|e| could_move(e.kind)).collect();
    let rung_of = |at: usize| {
        sketch
            .rungs
            .iter()
            .find(|r| r.contains(&(at as u32)))
            .unwrap()
            .clone()
    };
    loop {
        let before = moves.clone();
        for (at, element) in sketch.elements.iter().enumerate() {
            let right_moves = |at: usize| (at + 1..rung_of(at).end as usize).all(|n| before[n]);
            let left_moves =
                |at: usize| at > rung_of(at).start as usize && before[at - 1] && sketch.elements[at].joined;
            let may = match element.kind {
                ElementKind::Acting | ElementKind::RightRail | ElementKind::RightBar => right_moves(at),
                ElementKind::Comment => right_moves(at) && left_moves(at),
                ElementKind::Down | ElementKind::Up if element.partner != NONE => {
                    let other = element.partner as usize;
                    right_moves(at) && right_moves(other) && (left_moves(at) || left_moves(other))
                }
                _ => false,
            };
            moves[at] &= may;
        }
        if moves == before {
            return moves;
        }
    }
}

/// What moves is pulled left from the rail until all distances hold.
fn pulled_right(sketch: &Sketch, rail: u32, left: &[u32]) -> Vec<u32> {
    let moves = moving(sketch);
    let mut columns = left.to_vec();
    for (at, element) in sketch.elements.iter().enumerate() {
        if moves[at] {
            let at_rail = matches!(element.kind, ElementKind::RightRail | ElementKind::RightBar);
            columns[at] = if at_rail {
                rail
            } else {
                rail - SPACING - element.width
            };
        }
    }
    loop {
        let before = columns.clone();
        for rung in &sketch.rungs {
            for at in rung.clone().rev().map(|n| n as usize).filter(|&n| moves[n]) {
                let element = &sketch.elements[at];
                if at + 1 < rung.end as usize {
                    columns[at] = columns[at].min(columns[at + 1] - SPACING - element.width);
                }
                if element.partner != NONE {
                    columns[at] = columns[at].min(columns[element.partner as usize]);
                }
            }
        }
        if columns == before {
            hold_stubs(sketch, &mut columns);
            return columns;
        }
    }
}

/// Any network: between the connectors, which pair up from rung to rung, is anything.
fn sketches() -> impl Strategy<Value = Sketch> {
    let element = (0..10u8, any::<bool>(), 1..12u32);
    let rung = (
        prop::collection::vec(element, 0..6),
        0..4usize,
        any::<[bool; 3]>(),
        any::<u32>(),
    );
    prop::collection::vec(rung, 1..6).prop_map(|rungs| {
        let mut sketch = Sketch::new();
        let mut ups = 0;
        let last = rungs.len() - 1;
        for (n, (elements, downs, [left, right, bar], order)) in rungs.into_iter().enumerate() {
            let downs = if n == last { 0 } else { downs };
            let mut kinds: Vec<(ElementKind, bool, u32)> = elements
                .into_iter()
                .map(|(kind, joined, width)| match kind {
                    0 | 1 => (ElementKind::Condition, joined, width),
                    2..=5 => (ElementKind::Acting, true, width),
                    6 => (ElementKind::Stub, joined, 2),
                    7 => (ElementKind::Comment, joined, width),
                    8 => (ElementKind::Stray, true, 1),
                    _ => (ElementKind::Acting, joined, width),
                })
                .collect();
            let mut order = order as usize;
            for kind in
                std::iter::repeat_n(ElementKind::Down, downs).chain(std::iter::repeat_n(ElementKind::Up, ups))
            {
                let places = kinds.len() + 1;
                kinds.insert(order % places, (kind, !order.is_multiple_of(5), 1));
                order = order / places + order % 7;
            }
            sketch.begin_rung();
            if left {
                sketch.push(
                    if bar {
                        ElementKind::LeftBar
                    } else {
                        ElementKind::LeftRail
                    },
                    false,
                    1,
                );
            }
            for (kind, joined, width) in kinds {
                sketch.push(kind, joined, width);
            }
            if right {
                sketch.push(
                    if bar {
                        ElementKind::RightBar
                    } else {
                        ElementKind::RightRail
                    },
                    true,
                    1,
                );
            }
            ups = downs;
        }
        sketch.pair(0..sketch.rungs.len());
        sketch
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 3000, ..ProptestConfig::default() })]

    #[test]
    fn as_the_rules_say(sketch in sketches(), more in 0..50u32) {
        let rungs = 0..sketch.rungs.len();
        let mut columns = vec![0; sketch.elements.len()];
        let mut placer = Placer::default();
        let outline = placer.place_left(&sketch, rungs.clone(), SPACING, &mut columns);
        let left = pushed_left(&sketch);
        prop_assert_eq!(&columns, &left);
        let rail = outline.rail + more;
        placer.place_right(&sketch, rungs, SPACING, rail, &mut columns);
        prop_assert_eq!(&columns, &pulled_right(&sketch, rail, &left));
        for (new, old) in columns.iter().zip(&left) {
            prop_assert!(new >= old);
        }
    }
}
