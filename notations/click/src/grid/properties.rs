//! What must hold for any grid: the rungs that are read of it, and the grid that is drawn of those, let power through
//! for the same contacts.

use super::super::model::{Bits, Condition, ContactKind, Program, Routine};
use super::addresses::Addresses;
use super::cell::{Body, COLUMNS, Grid, GridRung, Row};
use super::netlist::{Netlist, RAIL};
use super::rungs::Reader;
use super::{file, output, write};
use crate::ClickGrid;
use ladder_notation::{Notation, Report, Source, convert};

/// A generator of numbers, so that failures come back.
struct Numbers(u64);

impl Numbers {
    fn below(&mut self, limit: usize) -> usize {
        self.0 = self
            .0
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) as usize % limit.max(1)
    }
}

/// This many control relays are in the contacts.
const RELAYS: u16 = 5;

/// A rung with wires and contacts anywhere in its first columns.
fn any_rung(numbers: &mut Numbers) -> String {
    let width = 1 + numbers.below(6);
    let mut out = String::new();
    for row in 0..=numbers.below(4) {
        out.push_str(if row == 0 { "R" } else { "" });
        let mut cells = Vec::new();
        for _ in 0..width {
            let down = if numbers.below(3) == 0 { "T:" } else { "" };
            cells.push(match numbers.below(8) {
                0 => String::new(),
                1 => "|".to_owned(),
                2 => "-".to_owned(),
                3 => "T".to_owned(),
                4 => format!("{down}~C{}", 1 + numbers.below(RELAYS.into())),
                _ => format!("{down}C{}", 1 + numbers.below(RELAYS.into())),
            });
        }
        let output = match numbers.below(4) {
            0 if row > 0 => "",
            0 | 1 if row == 0 => "\"count_up(CT1,CTD1,preset=5)\"",
            1 => ".reset()",
            _ => "out(Y00N)",
        };
        let output = output.replace('N', &(row + 1).to_string());
        let fill = if output.is_empty() { "" } else { "-" };
        cells.resize(COLUMNS, fill.to_owned());
        out.push_str(&format!(",{},{output}\n", cells.join(",")));
    }
    out
}

fn grid_of(rungs: &str) -> Grid {
    let header = file::write(&Grid::default());
    file::read(format!("{header}{rungs}").as_bytes(), 0).expect("the grid is sound")
}

/// Whether a contact lets power through, by its text.
fn passes(contact: &str, relays: usize) -> bool {
    let (closed, name) = match contact.strip_prefix('~') {
        Some(name) => (true, name),
        None => (false, contact),
    };
    let number: usize = name[1..].parse().expect("it is a control relay");
    (relays >> number & 1 == 1) != closed
}

/// What is under power at the right edge, row by row, when power runs through wire and contacts as it does in a cabinet.
fn powered(rows: &[Row], relays: usize) -> Vec<(String, bool)> {
    let netlist = Netlist::of(rows);
    let mut on = vec![false; netlist.nets];
    on[RAIL] = true;
    let mut changed = true;
    while changed {
        changed = false;
        for wired in &netlist.contacts {
            if on[wired.left] != on[wired.right] && passes(&wired.contact.text, relays) {
                (on[wired.left], on[wired.right], changed) = (true, true, true);
            }
        }
    }
    netlist
        .outputs
        .iter()
        .map(|fed| (fed.output.text.clone(), on[fed.net]))
        .collect()
}

fn holds(condition: &Condition, relays: usize) -> bool {
    match condition {
        Condition::All(parts) => parts.iter().all(|part| holds(part, relays)),
        Condition::Any(parts) => parts.iter().any(|part| holds(part, relays)),
        Condition::Contact(contact) => {
            let Bits::One(tag) = &contact.bits else {
                panic!("it is one relay")
            };
            let on = relays >> tag.address().expect("it has an address").number & 1 == 1;
            on != (contact.kind == ContactKind::Closed)
        }
        Condition::Compare(_) => panic!("there are no comparisons"),
    }
}

/// The same of the model.
fn active(routine: &Routine, relays: usize) -> Vec<(String, bool)> {
    let mut out = Vec::new();
    for rung in &routine.rungs {
        let common = holds(&rung.condition, relays);
        for action in &rung.actions {
            let written = output::write(&action.what, action.oneshot, &Addresses::default())
                .expect("it can be written");
            out.push((written.output, common && holds(&action.condition, relays)));
            out.extend(
                written
                    .pins
                    .iter()
                    .map(|(pin, condition)| (pin.clone(), holds(condition, relays))),
            );
        }
    }
    out
}

fn model(grid: &Grid) -> (Routine, bool) {
    let mut reader = Reader::default();
    for rung in &grid.rungs {
        reader.rung(rung);
    }
    let rungs = std::mem::take(&mut reader.rungs);
    let after = reader.finish(&grid.end);
    let whole = reader.findings.is_empty();
    (
        Routine {
            rungs,
            after,
            ..Routine::default()
        },
        whole,
    )
}

fn drawn(main: &Routine) -> String {
    let program = Program {
        main: main.clone(),
        ..Program::default()
    };
    write::write(&program, &mut Report::default()).0
}

#[test]
fn power_takes_the_same_ways() {
    let mut numbers = Numbers(12);
    let mut read = 0;
    for _ in 0..1_000 {
        let text = any_rung(&mut numbers);
        let grid = grid_of(&text);
        let (routine, whole) = model(&grid);
        if !whole {
            continue;
        }
        read += 1;
        let again = drawn(&routine);
        let second = file::read(again.as_bytes(), 0).expect("the grid that was written can be read");
        let rows: Vec<&GridRung> = second.rungs.iter().collect();
        for relays in (0..1usize << RELAYS).map(|relays| relays << 1) {
            let expected = powered(&grid.rungs[0].rows, relays);
            assert_eq!(active(&routine, relays), expected, "{text}");
            let drawn: Vec<(String, bool)> =
                rows.iter().flat_map(|rung| powered(&rung.rows, relays)).collect();
            assert_eq!(drawn, expected, "{text}\n{again}");
        }
        let (twice, _) = model(&second);
        assert_eq!(drawn(&twice), again, "{text}");
    }
    assert!(read > 100, "only {read} of the grids could be read");
}

/// A program of rungs that use everything once.
fn any_program(numbers: &mut Numbers) -> String {
    let mut out = file::write(&Grid::default());
    for rung in 1..=1 + numbers.below(4) {
        let text = any_rung(numbers);
        for (row, line) in text.lines().enumerate() {
            let output = match numbers.below(8) {
                0 => format!("latch(C{rung}{row}0)"),
                1 => format!("reset(C{rung}{row}1..C{rung}{row}3)"),
                2 => format!("\"copy(DS[DS{rung}+{row}],DD{rung})\""),
                3 => format!("\"on_delay(T{rung}{row},TD{rung}{row},preset={row},unit=Ts)\""),
                4 => format!("\"math(DS1 * {row} + DS2,DS{rung},mode=decimal)\""),
                5 => format!("\"fill({row},DS{rung}..DS{rung}9)\""),
                6 => format!("\"send(a,{row})\""),
                _ => format!("out(Y{rung}0{})", row + 1),
            };
            let counter = format!("count_up(CT{rung},CTD{rung},");
            let line = line.replace("count_up(CT1,CTD1,", &counter);
            let line = match line.rsplit_once(",out(") {
                Some((cells, _)) => format!("{cells},{output}"),
                None => line,
            };
            out.push_str(&format!("{line}\n"));
        }
    }
    out
}

#[test]
fn programs_come_back_from_ladder_text() {
    let options = ladder_format::Options::default();
    let read = |grid: &str| {
        let source = Source::alone("any", grid.as_bytes());
        let converted =
            convert(&ClickGrid, &source, &options).unwrap_or_else(|error| panic!("{error}:\n{grid}"));
        let text = converted.written.text;
        let parse = ladder_syntax::parse(&text);
        assert_eq!(parse.errors(), [], "{grid}\n{text}");
        assert_eq!(ladder_format::format_text(&text, &options), text, "{grid}");
        (text, parse)
    };
    let write = |parse: ladder_syntax::Parse| {
        let analysis = ladder_analysis::analyze(&parse.into(), "any.clad");
        let written = ClickGrid
            .write(&analysis)
            .unwrap_or_else(|error| panic!("{error}"));
        String::from_utf8(written.bytes).expect("it is text")
    };
    let mut numbers = Numbers(3);
    let mut whole = 0;
    for _ in 0..60 {
        let grid = any_program(&mut numbers);
        let (text, parse) = read(&grid);
        let first = write(parse);
        let (again, parse) = read(&first);
        assert_eq!(write(parse), first, "{grid}\n{text}\n{again}");
        if first.contains("click:") {
            continue;
        }
        whole += 1;
        for relays in (0..1usize << RELAYS).map(|relays| relays << 1) {
            assert_eq!(
                power_of(&first, relays),
                power_of(&grid, relays),
                "{grid}\n{text}\n{first}"
            );
        }
    }
    assert!(whole > 15, "only {whole} programs could be written whole");
}

/// What is under power in the rungs of a file: which output, and whether.
fn power_of(file: &str, relays: usize) -> Vec<(String, bool)> {
    let grid = file::read(file.as_bytes(), 0).expect("the grid is sound");
    let outputs = grid.rungs.iter().flat_map(|rung| powered(&rung.rows, relays));
    let name = |output: &str| output.split('(').next().unwrap_or_default().to_owned();
    outputs.map(|(output, on)| (name(&output), on)).collect()
}

#[test]
fn broken_grids_are_read_or_have_a_place() {
    let mut numbers = Numbers(7);
    let pieces = [
        "T:",
        "|",
        "T",
        "-",
        ",",
        "R",
        "\n",
        "\"",
        "~",
        "rise(",
        "DS1==",
        "..",
        "[",
        ")",
        "#",
        "immediate(",
        "\u{e9}",
    ];
    for _ in 0..300 {
        let mut text = file::write(&grid_of(
            &[any_rung(&mut numbers), any_rung(&mut numbers)].concat(),
        ));
        for _ in 0..=numbers.below(4) {
            let at = numbers.below(text.len());
            let piece = pieces[numbers.below(pieces.len())];
            match numbers.below(3) {
                0 => text.insert_str(at, piece),
                1 if text.len() > 1 => _ = text.remove(at),
                _ => text.truncate(at.max(1)),
            }
            if !text.is_ascii() {
                break;
            }
        }
        match file::read(text.as_bytes(), 0) {
            Ok(grid) => {
                let (routine, _) = model(&grid);
                let _ = drawn(&routine);
            }
            Err(error) => assert!(!error.message.is_empty()),
        }
    }
}

#[test]
fn hostile_rungs_are_refused_soon() {
    // A wall of contacts, joined like bricks: there are more paths than anybody could count.
    let row = |number: usize| {
        let marker = if number == 0 { "R" } else { "" };
        let end = if number == 0 { "out(Y001)" } else { "" };
        let cells: String = (0..COLUMNS)
            .map(|column| {
                if (column + number).is_multiple_of(2) {
                    ",T:C1"
                } else {
                    ",C1"
                }
            })
            .collect();
        format!("{marker}{cells},{end}\n")
    };
    let net: String = (0..64).map(row).collect();
    let grid = grid_of(&net.repeat(3));
    let (routine, whole) = model(&grid);
    assert!(!whole && routine.rungs.is_empty());
    assert_eq!(routine.after.len(), 3 * 64, "the rungs are kept as they are");
    // Branches in branches, one in each row.
    let mut deep = String::new();
    for row in 0..60 {
        let marker = if row == 0 { "R" } else { "" };
        let end = if row == 0 { "out(Y001)" } else { "" };
        let mut cells = vec![String::new(); COLUMNS];
        let first = (row / 2) % 29;
        cells[first] = "T:C1".to_owned();
        cells[first + 1] = "T".to_owned();
        cells[first + 2..]
            .iter_mut()
            .for_each(|cell| "-".clone_into(cell));
        deep.push_str(&format!("{marker},{},{end}\n", cells.join(",")));
    }
    let _ = model(&grid_of(&deep));
}

#[test]
fn cells_are_read_and_written() {
    for text in ["", "-", "|", "T", "C1", "T:C1", "T:~C1", "T:rise(C1)", "DS1==5"] {
        let cell = super::cell::Cell::read(text, ladder_notation::LineColumn::START);
        assert_eq!(cell.text(), text);
        assert_eq!(matches!(cell.body, Body::Contact(_)), text.len() > 1);
    }
}
