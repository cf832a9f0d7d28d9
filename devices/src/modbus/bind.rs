//! Which tag is where.

use super::place::{Place, Table};
use super::registers::{Words, width};
use ladder_analysis::program::Role;
use ladder_analysis::values::types::Scalar;
use ladder_simulator::{Point, Simulation};

/// Which places the direct addresses of a program have.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Layout {
    /// Those of `OpenPLC`: outputs are coils and holding registers, inputs what clients only read.
    #[default]
    OpenPlc,
    /// The same seen from the other side, for Factory I/O as a client: it writes the program's inputs and reads its outputs.
    FactoryIo,
}

/// What is served, as it was written.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Places {
    /// Where direct addresses are.
    pub layout: Layout,
    /// The order of the words of a value.
    pub words: Words,
    /// Places and the tags that are there: `holding 100` and `level`.
    pub named: Vec<(String, String)>,
    /// The tags that clients may write.
    pub write: Vec<String>,
}

/// Something about [`Places`] that cannot be.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Wrong {
    /// The place or tag that it is about, as it is written.
    pub about: String,
    /// What is wrong, and what to do.
    pub message: String,
}

/// A tag at its place.
#[derive(Debug, Clone)]
pub(super) struct Entry {
    pub(super) place: Place,
    pub(super) point: Point,
    /// How many bits or words it takes.
    pub(super) width: usize,
    /// Clients may write it.
    pub(super) may_be_written: bool,
}

/// Which tag is where: those with addresses, and those that have a place by name. No two are at one place.
#[derive(Debug, Clone)]
pub struct Map {
    pub(super) words: Words,
    /// In the order of their places.
    pub(super) entries: Vec<Entry>,
}

impl Map {
    /// Finds the tags of a program.
    ///
    /// # Errors
    /// A tag is not there or has no form on the wire, two are at one place, or something is to be written that cannot be.
    pub fn new(places: &Places, simulation: &Simulation) -> Result<Map, Vec<Wrong>> {
        let mut wrong = Vec::new();
        let mut entries = by_address(places, simulation);
        for (place, tag) in &places.named {
            match at(place, tag, simulation) {
                Ok(found) => {
                    // A place by name is instead of the one that the address has.
                    let is_moved = |entry: &Entry| found.iter().any(|(_, point, _)| *point == entry.point);
                    entries.retain(|entry| !is_moved(entry));
                    entries.extend(found.into_iter().map(|(place, point, width)| Entry {
                        place,
                        point,
                        width,
                        may_be_written: false,
                    }));
                }
                Err(message) => wrong.push(Wrong {
                    about: place.clone(),
                    message,
                }),
            }
        }
        entries.sort_by_key(|entry| entry.place);
        wrong.extend(overlaps(&entries));
        for tag in &places.write {
            if let Err(message) = allow(tag, &mut entries, simulation) {
                wrong.push(Wrong {
                    about: tag.clone(),
                    message,
                });
            }
        }
        if wrong.is_empty() {
            let words = places.words;
            Ok(Map { words, entries })
        } else {
            Err(wrong)
        }
    }

    /// Whether nothing has a place.
    pub fn is_empty(&self) -> bool {
        self.entries.is_empty()
    }

    /// Each tag with its place, and whether clients may write it.
    pub fn tags(&self) -> impl Iterator<Item = (Place, &Point, bool)> {
        let tags = self.entries.iter();
        tags.map(|entry| (entry.place, &entry.point, entry.may_be_written))
    }
}

/// How many bits or words of a table a value takes.
pub(super) fn width_in(table: Table, ty: Scalar) -> Option<usize> {
    match (table.is_of_bits(), ty) {
        (true, Scalar::Bool) => Some(1),
        (true, _) | (false, Scalar::Bool) => None,
        (false, _) => width(ty),
    }
}

/// The tags at direct addresses, but those that have no place.
fn by_address(places: &Places, simulation: &Simulation) -> Vec<Entry> {
    let mut entries: Vec<Entry> = Vec::new();
    let tags = simulation.program().tags.iter().filter(|tag| tag.block.is_none());
    for tag in tags {
        let place = tag.address.as_deref().and_then(Place::of_address);
        let Some(place) = place.map(|place| match places.layout {
            Layout::OpenPlc => place,
            Layout::FactoryIo => place.mirrored(),
        }) else {
            continue;
        };
        let Ok(point) = simulation.resolve(&tag.name) else {
            continue;
        };
        if let Some(width) = width_in(place.table, point.ty) {
            entries.push(Entry {
                place,
                point,
                width,
                may_be_written: false,
            });
        }
    }
    entries
}

/// What a line of the map says: the values, one after the other, from the place on.
fn at(place: &str, tag: &str, simulation: &Simulation) -> Result<Vec<(Place, Point, usize)>, String> {
    let first = Place::parse(place)?;
    let points = simulation
        .resolve_all(tag)
        .map_err(|unknown| unknown.to_string())?;
    let mut found = Vec::new();
    let mut number = usize::from(first.number);
    for point in points {
        let Some(width) = width_in(first.table, point.ty) else {
            let kind = if first.table.is_of_bits() {
                "bits"
            } else {
                "numbers"
            };
            return Err(format!(
                "{} is {}, and there are only {kind} in the table `{}`",
                point.name,
                point.ty,
                first.table.name()
            ));
        };
        let at = u16::try_from(number + width - 1)
            .ok()
            .and(u16::try_from(number).ok());
        let Some(at) = at else {
            return Err(format!(
                "{} is beyond 65535, the last place of a table",
                point.name
            ));
        };
        found.push((Place { number: at, ..first }, point, width));
        number += width;
    }
    Ok(found)
}

fn overlaps(entries: &[Entry]) -> Vec<Wrong> {
    let mut wrong = Vec::new();
    for pair in entries.windows(2) {
        let [one, other] = pair else { continue };
        let end = usize::from(one.place.number) + one.width;
        if one.place.table == other.place.table && end > usize::from(other.place.number) {
            wrong.push(Wrong {
                about: other.place.to_string(),
                message: format!(
                    "{} is there, too: {} takes {} of them",
                    one.point.name, one.point.ty, one.width
                ),
            });
        }
    }
    wrong
}

/// Lets clients write a tag.
fn allow(tag: &str, entries: &mut [Entry], simulation: &Simulation) -> Result<(), String> {
    for point in simulation
        .resolve_all(tag)
        .map_err(|unknown| unknown.to_string())?
    {
        if point.read_only {
            return Err(format!("{} is never written", point.name));
        }
        if point.role == Role::Output {
            return Err(format!("{} is an output: the program writes it", point.name));
        }
        let entry = entries.iter_mut().find(|entry| entry.point == point);
        let Some(entry) = entry else {
            return Err(format!(
                "{} has no place; give it one in [serve.modbus.map], for example \"holding 100\" = \"{}\"",
                point.name, point.name
            ));
        };
        if !entry.place.table.is_written() {
            return Err(format!(
                "{} is at {}, which clients only read; give it another place, or set layout = \"factory-io\"",
                point.name, entry.place
            ));
        }
        entry.may_be_written = true;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::tests::simulation;
    use expect_test::{Expect, expect};

    pub(crate) const PRESS: &str = "VAR_INPUT\n    start AT %IX0.0 : BOOL;\n    stop AT %IX0.1 : BOOL;\n    wanted : INT := 20;\nEND_VAR\n\
        VAR_OUTPUT\n    run AT %QX1.2 : BOOL;\n    level AT %MD0 : REAL;\nEND_VAR\nVAR\n    rows : ARRAY[1..3] OF DINT;\nEND_VAR\n\
        VAR CONSTANT\n    k : INT := 5;\nEND_VAR\n\
        +--\\--[ ]( start )--\\--[/]( stop )--( )( run )--+\n|  /--[ ]( run )----/                           |\n\
        +--[MOV]( level, wanted )--[MOV]( rows[1], k )--+\n";

    fn places(layout: Layout, named: &[(&str, &str)], write: &[&str]) -> Places {
        Places {
            layout,
            named: named
                .iter()
                .map(|(place, tag)| ((*place).to_owned(), (*tag).to_owned()))
                .collect(),
            write: write.iter().map(|tag| (*tag).to_owned()).collect(),
            ..Places::default()
        }
    }

    fn check(places: &Places, expected: Expect) {
        let shown: Vec<String> = match Map::new(places, &simulation(PRESS, 10_000_000)) {
            Ok(map) => map
                .tags()
                .map(|(place, point, may_be_written)| {
                    let star = if may_be_written { " *" } else { "" };
                    format!("{place} {}{star}", point.name)
                })
                .collect(),
            Err(wrong) => wrong
                .iter()
                .map(|wrong| format!("{}: {}", wrong.about, wrong.message))
                .collect(),
        };
        expected.assert_eq(&(shown.join("\n") + "\n"));
    }

    #[test]
    fn addresses_have_places_and_all_else_has_them_by_name() {
        let named = [("holding 100", "wanted"), ("input 7", "rows[1..3]")];
        check(
            &places(Layout::OpenPlc, &named, &["wanted"]),
            expect![[r#"
            coil 10 run
            discrete 0 start
            discrete 1 stop
            input 7 rows[1]
            input 9 rows[2]
            input 11 rows[3]
            holding 100 wanted *
            holding 2048 level
        "#]],
        );
    }

    #[test]
    fn factory_io_writes_what_the_program_reads() {
        check(
            &places(Layout::FactoryIo, &[], &["start", "stop"]),
            expect![[r#"
            coil 0 start *
            coil 1 stop *
            discrete 10 run
            input 2048 level
        "#]],
        );
    }

    #[test]
    fn what_cannot_be_is_told() {
        let named = [
            ("holding 5", "nothing"),
            ("holding 65535", "rows[1]"),
            ("coil 3", "wanted"),
            ("holding 2049", "wanted"),
            ("register 5", "wanted"),
        ];
        check(
            &places(Layout::OpenPlc, &named, &["start", "run", "k", "rows[1]", "none"]),
            expect![[r#"
            holding 5: there is no tag `nothing` in this program
            holding 65535: rows[1] is beyond 65535, the last place of a table
            coil 3: wanted is INT, and there are only bits in the table `coil`
            register 5: a place is a table and a number from 0, for example `holding 100`; the tables are coil, discrete, input and holding
            holding 2049: level is there, too: REAL takes 2 of them
            start: start is at discrete 0, which clients only read; give it another place, or set layout = "factory-io"
            run: run is an output: the program writes it
            k: k is never written
            rows[1]: rows[1] has no place; give it one in [serve.modbus.map], for example "holding 100" = "rows[1]"
            none: there is no tag `none` in this program
        "#]],
        );
    }
}
