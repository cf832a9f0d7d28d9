//! Which tag is where.

use super::blocks::{GAP, Limits, blocks};
use super::place::{Place, Table, address_after};
use super::registers::{Words, width};
use crate::wrong::Wrong;
use ladder_analysis::program::Role;
use ladder_analysis::values::types::Scalar;
use ladder_simulator::{Point, Simulation};
use std::ops::Range;

/// Which places the direct addresses of a program have.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Layout {
    /// Those of `OpenPLC`: outputs are coils and holding registers, inputs what clients only read.
    #[default]
    OpenPlc,
    /// The same seen from the other side, for Factory I/O as a client: it writes the program's inputs and reads its outputs.
    FactoryIo,
}

impl Layout {
    /// As a setting has it.
    pub fn of_setting(set: Option<&str>) -> Layout {
        match set {
            Some("factory-io") => Layout::FactoryIo,
            _ => Layout::OpenPlc,
        }
    }
}

/// What is served, as it was written.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Places {
    /// Where direct addresses are.
    pub layout: Layout,
    /// The order of the words of a value.
    pub words: Words,
    /// Places and the tags that are there.
    pub named: Vec<Named>,
    /// The tags that clients may write, each with where it is named.
    pub write: Vec<(String, Range<usize>)>,
    /// Where all of this is written.
    pub at: Range<usize>,
}

/// A place and the tag that is there: `holding 100` and `level`. Of a run of places, `discrete 0..7`, the tag is the first of
/// as many addresses, or has as many elements.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Named {
    /// The place, or a run of places.
    pub place: String,
    /// The tag.
    pub tag: String,
    /// Where that is written.
    pub at: Range<usize>,
}

impl Named {
    /// As settings have them.
    pub fn of_settings(placed: &[ladder_workspace::Placed]) -> Vec<Named> {
        let named = placed.iter().map(|placed| Named {
            place: placed.place.clone(),
            tag: placed.tag.clone(),
            at: placed.range.clone(),
        });
        named.collect()
    }
}

/// Places that a client asks for with one request.
#[derive(Debug, Clone)]
pub struct Reading<'m> {
    /// The first of them.
    pub first: Place,
    /// How many bits or words.
    pub count: usize,
    /// Which tags are there.
    pub tags: Vec<(Place, &'m Point)>,
}

/// A tag at its place.
#[derive(Debug, Clone)]
pub(super) struct Entry {
    pub(super) place: Place,
    pub(super) point: Point,
    /// How many bits or words it takes.
    pub(super) width: usize,
    /// Where it is written; of what has its place by its address, where the map is.
    pub(super) at: Range<usize>,
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

#[cfg(test)]
impl Named {
    /// Places and tags, written at 1, 2, 3.
    pub(super) fn list(list: &[(&str, &str)]) -> Vec<Named> {
        let numbered = (1..).zip(list);
        let named = numbered.map(|(at, (place, tag))| Named {
            place: (*place).to_owned(),
            tag: (*tag).to_owned(),
            at: at..at,
        });
        named.collect()
    }
}

impl Map {
    /// Finds the tags of a program.
    ///
    /// # Errors
    /// A tag is not there or has no form on the wire, two are at one place, or something is to be written that cannot be.
    pub fn new(places: &Places, simulation: &Simulation) -> Result<Map, Vec<Wrong>> {
        let mut wrong = Vec::new();
        let mut entries = by_address(places, simulation);
        for named in &places.named {
            match at(named, simulation) {
                Ok(found) => {
                    // A place by name is instead of the one that the address has.
                    entries.retain(|entry| found.iter().all(|other| other.point != entry.point));
                    entries.extend(found);
                }
                Err(message) => wrong.push(Wrong {
                    at: named.at.clone(),
                    message,
                }),
            }
        }
        wrong.extend(in_order(&mut entries));
        for (tag, at) in &places.write {
            if let Err(message) = allow(tag, &mut entries, simulation) {
                wrong.push(Wrong {
                    at: at.clone(),
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

    /// The same of which nothing may be written.
    #[must_use]
    pub fn read_only(mut self) -> Map {
        for entry in &mut self.entries {
            entry.may_be_written = false;
        }
        self
    }

    /// Whether nothing has a place.
    pub fn is_empty(&self) -> bool {
        self.entries.is_empty()
    }

    /// The order of the words of a value.
    pub fn words(&self) -> Words {
        self.words
    }

    /// The requests that read all of it.
    pub fn readings(&self) -> impl Iterator<Item = Reading<'_>> {
        let blocks = blocks(&self.entries, Limits::of_reading(GAP));
        blocks.into_iter().map(|block| Reading {
            first: block.first,
            count: block.count,
            tags: self.entries[block.entries]
                .iter()
                .map(|entry| (entry.place, &entry.point))
                .collect(),
        })
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
                at: places.at.clone(),
                may_be_written: false,
            });
        }
    }
    entries
}

/// What a line of a map says: the values, one after the other, from the place on.
pub(super) fn at(named: &Named, simulation: &Simulation) -> Result<Vec<Entry>, String> {
    let (first, last) = Place::parse_run(&named.place)?;
    let tag = named.tag.trim();
    if let Some(last) = last.filter(|_| tag.starts_with('%')) {
        return addresses(first, last, tag, named, simulation);
    }
    let points = simulation
        .resolve_all(tag)
        .map_err(|unknown| unknown.to_string())?;
    let mut found = Vec::new();
    let mut number = usize::from(first.number);
    for point in points {
        let entry = entry(first.table, number, point, named)?;
        number += entry.width;
        found.push(entry);
    }
    if let Some(last) = last
        && number != usize::from(last) + 1
    {
        return Err(format!(
            "{tag} takes {} places, and {} is another number of them",
            number - usize::from(first.number),
            named.place
        ));
    }
    Ok(found)
}

/// A run of places and as many addresses, from one on. The program need not have all of them.
fn addresses(
    first: Place,
    last: u16,
    tag: &str,
    named: &Named,
    simulation: &Simulation,
) -> Result<Vec<Entry>, String> {
    let mut found = Vec::new();
    let mut address = Some(tag.to_ascii_uppercase());
    let mut number = usize::from(first.number);
    while let Some(own) = address.filter(|_| number <= usize::from(last)) {
        let widest = match own.as_bytes().get(2) {
            Some(b'D') => 2,
            Some(b'L') => 4,
            _ => 1,
        };
        if let Ok(point) = simulation.resolve(&own) {
            found.push(entry(first.table, number, point, named)?);
        }
        number += widest;
        address = address_after(&own);
    }
    if found.is_empty() {
        return Err(format!("the program has none of the addresses from {tag} on"));
    }
    Ok(found)
}

fn entry(table: Table, number: usize, point: Point, named: &Named) -> Result<Entry, String> {
    let (name, ty) = (&point.name, point.ty);
    let Some(width) = width_in(table, ty) else {
        let kind = if table.is_of_bits() { "bits" } else { "numbers" };
        let table = table.name();
        return Err(format!(
            "{name} is {ty}, and there are only {kind} in the table `{table}`"
        ));
    };
    let last = u16::try_from(number + width - 1);
    let (Ok(number), Ok(_)) = (u16::try_from(number), last) else {
        return Err(format!("{name} is beyond 65535, the last place of a table"));
    };
    Ok(Entry {
        place: Place { table, number },
        point,
        width,
        at: named.at.clone(),
        may_be_written: false,
    })
}

/// Puts entries in the order of their places. No two may be at one.
pub(super) fn in_order(entries: &mut [Entry]) -> Vec<Wrong> {
    entries.sort_by_key(|entry| entry.place);
    let mut wrong = Vec::new();
    for pair in entries.windows(2) {
        let [one, other] = pair else { continue };
        let end = usize::from(one.place.number) + one.width;
        if one.place.table == other.place.table && end > usize::from(other.place.number) {
            let (both, ty) = (
                format!("{} and {}", one.point.name, other.point.name),
                one.point.ty,
            );
            let room = match one.width {
                1 => String::new(),
                width => format!(": {ty} takes {width} places"),
            };
            wrong.push(Wrong {
                // One of the two may have its place by its address.
                at: if one.at.start > other.at.start {
                    one.at.clone()
                } else {
                    other.at.clone()
                },
                message: format!("{both} are both at {}{room}", other.place),
            });
        }
    }
    wrong
}

/// Whether a tag may be written from outside.
pub(super) fn may_be_given(point: &Point) -> Result<(), String> {
    if point.read_only {
        return Err(format!("{} is never written", point.name));
    }
    if point.role == Role::Output {
        return Err(format!("{} is an output: the program writes it", point.name));
    }
    Ok(())
}

/// Lets clients write a tag.
fn allow(tag: &str, entries: &mut [Entry], simulation: &Simulation) -> Result<(), String> {
    for point in simulation
        .resolve_all(tag)
        .map_err(|unknown| unknown.to_string())?
    {
        may_be_given(&point)?;
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
            named: Named::list(named),
            write: write.iter().map(|tag| ((*tag).to_owned(), 0..0)).collect(),
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
            Err(wrong) => Wrong::lines(&wrong),
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
                1: there is no tag `nothing` in this program
                2: rows[1] is beyond 65535, the last place of a table
                3: wanted is INT, and there are only bits in the table `coil`
                5: a place is a table and a number from 0, for example `holding 100`; the tables are coil, discrete, input and holding
                4: level and wanted are both at holding 2049: REAL takes 2 places
                0: start is at discrete 0, which clients only read; give it another place, or set layout = "factory-io"
                0: run is an output: the program writes it
                0: k is never written
                0: rows[1] has no place; give it one in [serve.modbus.map], for example "holding 100" = "rows[1]"
                0: there is no tag `none` in this program
            "#]],
        );
    }
}
