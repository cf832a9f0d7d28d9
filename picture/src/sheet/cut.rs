//! Where a drawing that is larger than a page may be cut: nowhere through a letter or a symbol, if that can be helped.

use super::super::shapes::{Extent, Form, Role, Shape};
use super::super::style::Look;
use std::ops::Range;

/// Pixels next to a shape that a cut keeps away from. Above and below there is room enough between rungs, and the rows of
/// a box are closer than that.
const NEXT_TO: i32 = 3;

/// Which way a drawing is cut.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Along {
    /// Into strips next to each other: only wires are cut.
    Width,
    /// Into strips below each other: only lines from rung to rung, rails, and boxes between their rows.
    Height,
}

/// Cuts the stretch from `whole.start` to `whole.end` into pieces that are at most `limit` long.
pub(super) fn cut(shapes: &[Shape], along: Along, whole: Range<i32>, limit: i32) -> Vec<Range<i32>> {
    if whole.end - whole.start <= limit {
        return vec![whole];
    }
    let limit = limit.max(1);
    let strict = blocked(shapes, along, Boxes::Whole);
    let loose = blocked(shapes, along, Boxes::BetweenRows);
    let pieces = pieces(&strict, &loose, &whole, limit);
    if along == Along::Height {
        return pieces;
    }
    // Strips next to each other are about as wide as each other, so that the last is not a mere end of wire.
    let (mut too_small, mut enough) = (limit / 2, limit);
    let mut even = pieces;
    while too_small + 1 < enough {
        let middle = i32::midpoint(too_small, enough);
        let tried = self::pieces(&strict, &loose, &whole, middle);
        if tried.len() > even.len() {
            too_small = middle;
        } else {
            enough = middle;
            even = tried;
        }
    }
    even
}

fn pieces(strict: &[Range<i32>], loose: &[Range<i32>], whole: &Range<i32>, limit: i32) -> Vec<Range<i32>> {
    let limit = limit.max(1);
    let mut pieces = Vec::new();
    let mut start = whole.start;
    while whole.end - start > limit {
        let last = start + limit;
        // A piece that is half empty for the sake of one box is no better than a box in two pieces.
        let strict = free_before(strict, last);
        let loose = free_before(loose, last);
        let at = if strict > start + limit / 2 {
            strict
        } else if loose > start + limit / 4 {
            loose
        } else {
            last
        };
        pieces.push(start..at);
        start = at;
    }
    pieces.push(start..whole.end);
    pieces
}

#[derive(Clone, Copy, PartialEq, Eq)]
enum Boxes {
    Whole,
    BetweenRows,
}

/// Where no cut may be, in order and none touching the next.
fn blocked(shapes: &[Shape], along: Along, boxes: Boxes) -> Vec<Range<i32>> {
    let mut all: Vec<Range<i32>> = shapes
        .iter()
        .filter(|shape| {
            let is_box = shape.look == Look::Box && matches!(shape.form, Form::Rect { .. });
            match along {
                Along::Width => shape.role != Role::Wire,
                Along::Height if matches!(shape.role, Role::Node | Role::Rail) => false,
                Along::Height => !is_box || boxes == Boxes::Whole,
            }
        })
        .map(|shape| {
            let stretch = stretch(shape.extent(), along);
            match along {
                Along::Width => stretch.start - NEXT_TO..stretch.end + NEXT_TO,
                // A wire has no height of its own.
                Along::Height => stretch.start..stretch.end.max(stretch.start + 2),
            }
        })
        .collect();
    all.sort_unstable_by_key(|range| range.start);
    let mut merged: Vec<Range<i32>> = Vec::new();
    for range in all {
        match merged.last_mut() {
            Some(last) if range.start < last.end => last.end = last.end.max(range.end),
            _ => merged.push(range),
        }
    }
    merged
}

/// How far something reaches.
pub(super) fn stretch(extent: Extent, along: Along) -> Range<i32> {
    match along {
        Along::Width => extent.left..extent.right,
        Along::Height => extent.top..extent.bottom,
    }
}

/// The last place up to here where a cut may be.
fn free_before(blocked: &[Range<i32>], last: i32) -> i32 {
    let before = blocked.partition_point(|range| range.start < last);
    match blocked[..before].last() {
        Some(range) if range.end > last => range.start,
        _ => last,
    }
}
