//! Where values are shown: above their operands where the text is blank, else below them, else in a line
//! of their own between the two, or after the end of the line, as the editor can. Never between the characters of a line, which would push
//! the drawing apart, and never over any.

use std::collections::HashMap;

use ladder_analysis::values::types::Scalar;
use ladder_format::display_width;

use crate::messages::Side;

/// A value that is to be shown.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Wanted {
    /// The line of the operand.
    pub(crate) row: u32,
    /// It is the name in a declaration, which has its value after its line.
    pub(crate) declared: bool,
    /// The column of the screen where the operand begins.
    pub(crate) column: u32,
    /// How many columns are kept for it.
    pub(crate) width: u32,
    /// How many the name of its tag takes, with `: `; not next to a declaration.
    pub(crate) name: u32,
}

/// How many columns a value of a type mostly takes, so that it can grow without moving.
pub(crate) fn room(ty: Scalar) -> u32 {
    match ty {
        Scalar::Bool => 1,
        Scalar::Time | Scalar::Real | Scalar::Lreal => 7,
        _ => 5,
    }
}

/// How many columns are between the end of a line and a value after it.
const GAP: usize = 2;

/// Where a value is shown; the fields are those of a [label](super::messages::Label).
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Place {
    pub(crate) side: Side,
    pub(crate) column: u32,
    pub(crate) after: Option<u32>,
}

/// Where each value is shown.
///
/// `wanted` is in the order of the text; `line_at` has no text for what is past its ends.
pub(crate) fn place(wanted: &[Wanted], line_at: impl Fn(u32) -> Option<String>) -> Vec<Place> {
    let mut lines: HashMap<u32, Option<Vec<bool>>> = HashMap::new();
    let mut free_between: HashMap<u32, u32> = HashMap::new();
    let places = wanted.iter().map(|wanted| {
        let &Wanted {
            row, column, width, ..
        } = wanted;
        let others = [
            (Side::Above, row.checked_sub(1)),
            (Side::Below, row.checked_add(1)),
        ];
        for (side, other) in others {
            let Some(other) = other.filter(|_| !wanted.declared) else {
                continue;
            };
            let taken = lines
                .entry(other)
                .or_insert_with(|| line_at(other).map(|line| taken(&line)));
            // A column on each side, so that two things do not look like one.
            let (start, end) = (column as usize, (column + width) as usize);
            let Some(taken) = taken else { continue };
            let mut around = taken.iter().take(end + 1).skip(start.saturating_sub(1));
            if around.any(|taken| *taken) {
                continue;
            }
            taken.resize(taken.len().max(end), false);
            taken[start..end].fill(true);
            return Place {
                side,
                column,
                after: None,
            };
        }
        let line = lines
            .entry(row)
            .or_insert_with(|| line_at(row).map(|line| taken(&line)));
        let line = line.get_or_insert_default();
        let start = line.len() + GAP;
        line.resize(start, false);
        let name = if wanted.declared { 0 } else { wanted.name };
        line.resize(start + (name + width) as usize, true);
        if wanted.declared {
            return Place {
                side: Side::After,
                column: u32::try_from(start).unwrap_or(u32::MAX),
                after: None,
            };
        }
        let free = free_between.entry(row).or_default();
        let column = column.max(*free);
        *free = column + width + 1;
        Place {
            side: Side::Between,
            column,
            after: u32::try_from(start).ok(),
        }
    });
    places.collect()
}

/// Which columns of a line hold something.
fn taken(line: &str) -> Vec<bool> {
    let mut taken = Vec::with_capacity(line.len());
    let mut letter = [0; 4];
    for c in line.chars() {
        let width = display_width(c.encode_utf8(&mut letter));
        taken.extend(std::iter::repeat_n(c != ' ', width as usize));
    }
    taken
}

#[cfg(test)]
mod tests {
    use super::Side::{Above, After, Below, Between};
    use super::*;

    /// Values at (row, column, width) over these lines.
    fn placed(lines: &[&str], values: &[(u32, u32, u32)]) -> Vec<(Side, u32)> {
        let found = all_placed(lines, values).into_iter();
        found
            .map(|place| (place.side, place.after.unwrap_or(place.column)))
            .collect()
    }

    fn all_placed(lines: &[&str], values: &[(u32, u32, u32)]) -> Vec<Place> {
        let values: Vec<Wanted> = values
            .iter()
            .map(|&(row, column, width)| Wanted {
                row,
                declared: false,
                column,
                width,
                name: 3,
            })
            .collect();
        place(&values, |row| {
            lines.get(row as usize).map(|&line| line.to_owned())
        })
    }

    #[test]
    fn above_where_it_is_blank() {
        let timer = "+--[TON]( t, 5s )--( )( y )--+";
        assert_eq!(placed(&["", timer], &[(1, 10, 7)]), [(Above, 10)]);
        // A rail leaves room next to it.
        let rail = "|                                  |";
        let lines = ["+--[ ]( a )-------------( )( b )--+", rail, timer];
        assert_eq!(placed(&lines, &[(2, 10, 7)]), [(Above, 10)]);
        // A column on each side is left.
        for (other, side) in [
            (" ".repeat(17) + "x", (Between, 32)),
            (" ".repeat(18) + "x", (Above, 10)),
        ] {
            assert_eq!(placed(&[&other, timer], &[(1, 10, 7)]), [side]);
        }
        // Two columns of the screen are one letter there.
        assert_eq!(placed(&["# 電電電 #", timer], &[(1, 10, 7)]), [(Between, 32)]);
        assert_eq!(placed(&["# 電電 #", timer], &[(1, 10, 7)]), [(Above, 10)]);
    }

    #[test]
    fn below_where_something_is_above() {
        let (above, timer) = ("# a comment above #", "+--[TON]( t, 5s )--+");
        assert_eq!(placed(&[above, timer, ""], &[(1, 10, 7)]), [(Below, 10)]);
    }

    #[test]
    fn apart_where_neither_leaves_room() {
        let (above, timer) = ("# a comment above #", "+--[TON]( t, 5s )--+");
        // Never on a wire, which would seem to have that value.
        let wire = "+-------------------( )( y )--+";
        for below in [wire, "# a comment below #"] {
            assert_eq!(placed(&[above, timer, below], &[(1, 10, 7)]), [(Between, 22)]);
        }
        // The first line has none above, the last none below.
        assert_eq!(placed(&[timer], &[(0, 10, 7)]), [(Between, 22)]);
        let sum = ["# a comment #", "+--[ADD]( n, m, 1 )--+", "# a comment #"];
        let both = placed(&sum, &[(1, 10, 5), (1, 13, 2)]);
        assert_eq!(both, [(Between, 24), (Between, 34)]);
        let columns = all_placed(&sum, &[(1, 10, 5), (1, 13, 2)]);
        assert_eq!([columns[0].column, columns[1].column], [10, 16]);
    }

    #[test]
    fn after_its_line_where_a_tag_is_declared() {
        let declared = |column, width| Wanted {
            row: 0,
            declared: true,
            column,
            width,
            name: 0,
        };
        let places = place(&[declared(4, 3), declared(7, 3)], |row| {
            (row == 0).then(|| "    a, b : INT; # both #".to_owned())
        });
        let columns: Vec<_> = places.iter().map(|place| (place.side, place.column)).collect();
        assert_eq!(columns, [(After, 26), (After, 31)]);
    }

    #[test]
    fn values_leave_a_column_between_them() {
        let sum = "+--[ADD]( n, m, 1 )--+";
        let next_to = placed(&["", sum, ""], &[(1, 10, 2), (1, 13, 2)]);
        assert_eq!(next_to, [(Above, 10), (Above, 13)]);
        // One that would cover another goes to the other side.
        let covers = placed(&["", sum, ""], &[(1, 10, 5), (1, 13, 2)]);
        assert_eq!(covers, [(Above, 10), (Below, 13)]);
        // One of the line below is in the way, too.
        let lines = ["# a comment #", sum, "", sum, "# a comment #"];
        let below = placed(&lines, &[(1, 10, 5), (3, 10, 5)]);
        assert_eq!(below, [(Below, 10), (Between, 24)]);
    }
}
