//! Click's grid of cells, read and written.

use expect_test::{Expect, expect, expect_file};
use ladder_format::Options;
use ladder_interchange::notation::{
    Companion, Converted, Notation, Outcome, Source, by_name, convert, recognise,
};
use std::path::{Path, PathBuf};

fn notation() -> &'static dyn Notation {
    by_name("click-csv").expect("the notation is registered")
}

/// A program of a folder, with what belongs to it.
fn converted(file: &Path) -> Result<Converted, String> {
    let bytes = std::fs::read(file).expect("the file can be read");
    let name = file.file_stem().expect("it has a name").to_string_lossy();
    let folder = file.parent().expect("it lies in a folder");
    let mut companions: Vec<Companion> = std::fs::read_dir(folder)
        .expect("the folder can be read")
        .map(|entry| entry.expect("an entry can be read").path())
        .filter(|path| path != file && path.is_file())
        .map(|path| {
            (
                path.file_name()
                    .expect("it has a name")
                    .to_string_lossy()
                    .into_owned(),
                path,
            )
        })
        .filter(|(other, _)| notation().has_companion(&name, other))
        .map(|(name, path)| Companion {
            name,
            bytes: std::fs::read(path).expect("the file can be read"),
        })
        .collect();
    companions.sort_by(|one, other| one.name.cmp(&other.name));
    let source = Source {
        name: &name,
        bytes: &bytes,
        companions: &companions,
    };
    convert(notation(), &source, &Options::default()).map_err(|error| error.to_string())
}

/// What there is to say about a conversion.
fn remarks(converted: &Converted) -> String {
    let mut out = String::new();
    for entry in converted.report.remarks() {
        let (word, why) = match &entry.outcome {
            Outcome::Approximated(why) => ("approximated", why),
            Outcome::Refused(why) => ("refused", why),
            Outcome::Translated => continue,
        };
        out.push_str(&format!("{} {}: {word}: {why}\n", entry.place, entry.element));
    }
    for found in &converted.findings {
        out.push_str(&format!("{} {}: {}\n", found.place, found.check, found.message));
    }
    out
}

fn own(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("tests/click/grid")
        .join(name)
}

#[track_caller]
fn check(name: &str, said: Expect) {
    let converted = converted(&own(name)).unwrap_or_else(|error| panic!("{error}"));
    expect_file![own(name).with_extension("clad")].assert_eq(&converted.written.text);
    said.assert_eq(&remarks(&converted));
}

#[test]
fn a_folder_with_a_subroutine_and_nicknames() {
    check(
        "washer/main.csv",
        expect![[r#"
        1:1 x[3]: approximated: it is spelled `Lid_open` here
        11:69 Rinse and dry: approximated: sub_rinse_and_dry.csv:2:1: it is spelled `Rinse_and_dry` here
    "#]],
    );
}

#[test]
fn bridges() {
    check(
        "bridges.csv",
        expect![[r#"
        4:3 C5: approximated: power goes through it both ways; the rung is written as the paths that this makes
        8:3 X005: approximated: power goes through it both ways; the rung is written as the paths that this makes
    "#]],
    );
}

#[test]
fn every_instruction() {
    check(
        "instructions.csv",
        expect![[r#"
            2:3 immediate(X001): approximated: it reads the input itself; here all inputs are read before the scan
            25:68 send(target=plc1,remote_start="DS1",source=DS3,count=1): refused: ladder text has no counterpart for `send`
            26:68 event_drum(outputs=[Y001],events=[X001],pattern=[[1]],current_step=DS10,completion_flag=C10): refused: ladder text has no counterpart for `event_drum`
            26:68 click-grid: the rung stays as a comment, for `event_drum(outputs=[Y001],events=[X001],pattern=[[1]],curren`: ladder text has no counterpart for `event_drum`
        "#]],
    );
}

#[test]
fn what_is_wrong_has_a_place() {
    let header = std::fs::read_to_string(own("bridges.csv")).expect("the file can be read");
    let header = header.lines().next().expect("it has a header");
    let wires = ",-".repeat(31);
    for (rows, expected) in [
        (
            ",X001".to_owned(),
            expect![
                "2:1: a row without `R` goes on with the rung above it, and there is none: mark the first row of a rung with `R`"
            ],
        ),
        (
            "R,X001".to_owned(),
            expect![
                "2:1: this row has 2 fields; a row of the grid has 33: a marker, the cells A to AE, and AF"
            ],
        ),
        (
            "S,X001".to_owned(),
            expect![
                "2:1: `S` is no marker: a row begins with `R` (a rung), with nothing (the rung goes on) or with `#` (a comment)"
            ],
        ),
        (
            format!("#,a\n{wires},out(Y001)"),
            expect![
                "3:1: a row without `R` goes on with the rung above it, and there is none: mark the first row of a rung with `R`"
            ],
        ),
        (
            format!(
                "R{wires},out(Y001)\n{}",
                format!("{wires},out(Y001)\n").repeat(64)
            ),
            expect!["66:1: the rung has more than 64 rows: make several rungs of it"],
        ),
        (
            format!("R{wires},out(Y\u{1f600}001)"),
            expect![[r#"
            2:65 out(Y😀001): refused: `Y😀001` is neither an address nor a value
        "#]],
        ),
    ] {
        let text = format!("{header}\n{rows}\n");
        let source = Source::alone("test", text.as_bytes());
        let found = match convert(notation(), &source, &Options::default()) {
            Ok(converted) => remarks(&converted),
            Err(error) => error.to_string(),
        };
        expected.assert_eq(&found);
    }
    assert!(convert(notation(), &Source::alone("test", b"a,b\n"), &Options::default()).is_err());
}

#[test]
fn only_grids_are_recognised() {
    let name = |bytes: &[u8]| recognise(bytes).map(Notation::name);
    let grid = std::fs::read(own("bridges.csv")).expect("the file can be read");
    assert_eq!(name(&grid), Some("click-csv"));
    assert_eq!(name(b"Address,Data Type,Nickname\nDS1,INT,a\n"), None);
    assert_eq!(name(b"marker,A,B\n"), None);
    assert_eq!(name(b"scan,time_ms,a\n0,0,1\n"), None);
}

#[test]
fn real_grids_become_ladder_text() {
    let Some(corpus) = std::env::var_os("LADDER_CORPUS") else {
        eprintln!("skipped: LADDER_CORPUS names no folder of real programs");
        return;
    };
    let folder = Path::new(&corpus).join("click/csv");
    let entries = std::fs::read_dir(folder).expect("the folder can be read");
    let mut files: Vec<PathBuf> = entries
        .map(|entry| entry.expect("an entry can be read").path())
        .collect();
    files.sort();
    assert!(!files.is_empty());
    let mut out = String::new();
    for file in files {
        let name = file
            .file_name()
            .expect("it has a name")
            .to_string_lossy()
            .into_owned();
        let converted = converted(&file).unwrap_or_else(|error| panic!("{name}: {error}"));
        out.push_str(&format!("{name}: {:?}\n", converted.report.tally()));
        out.push_str(&remarks(&converted));
        let text = &converted.written.text;
        assert_eq!(ladder_syntax::parse(text).errors(), [], "{name}:\n{text}");
    }
    expect![[r#"
        branch_Or_one_output.csv: Tally { translated: 6, approximated: 0, refused: 0 }
        branch_Or_two_outputs.csv: Tally { translated: 7, approximated: 0, refused: 0 }
        branch_Or_with_following_Rung_output.csv: Tally { translated: 8, approximated: 0, refused: 0 }
        click_or_topology.csv: Tally { translated: 49, approximated: 0, refused: 0 }
        main.csv: Tally { translated: 67, approximated: 0, refused: 6 }
        20:68 search("==","AB",TXT1..TXT8,DS4,C1): refused: [SEARCH] looks for one character, not for a text
        24:68 event_drum(outputs=[Y011,C11,C12],events=[X011,X012,X013,X014],pattern=[[1,0,0],[0,1,0],[0,0,1],[1,1,0]],current_step=DS10,completion_flag=C10): refused: ladder text has no counterpart for `event_drum`
        28:68 time_drum(outputs=[Y011,C11,C12],presets=[50,100,75,200],unit=Tms,pattern=[[1,0,0],[0,1,0],[0,0,1],[1,1,0]],current_step=DS10,accumulator=TD10,completion_flag=C10): refused: ladder text has no counterpart for `time_drum`
        34:63 pack_text(TXT1..TXT8,DD1,allow_whitespace=1): refused: its options have no counterpart here
        45:65 send(target=ModbusTcpTarget(name="plc1",ip="10.0.0.1",port=502,device_id=1),remote_start="DS1",source=DS3,sending=C20,success=C21,error=C22,exception_response=DS20,count=1): refused: ladder text has no counterpart for `send`
        46:65 receive(target=ModbusTcpTarget(name="plc1",ip="10.0.0.1",port=502,device_id=1),remote_start="DS10",dest=DS22,receiving=C23,success=C24,error=C25,exception_response=DS23,count=1): refused: ladder text has no counterpart for `receive`
        24:68 click-grid: the rung stays as a comment, for `event_drum(outputs=[Y011,C11,C12],events=[X011,X012,X013,X01`: ladder text has no counterpart for `event_drum`
        28:68 click-grid: the rung stays as a comment, for `time_drum(outputs=[Y011,C11,C12],presets=[50,100,75,200],uni`: ladder text has no counterpart for `time_drum`
        multiple_pins_separate.csv: Tally { translated: 6, approximated: 0, refused: 0 }
        multiple_pins_shared_reset.csv: Tally { translated: 7, approximated: 0, refused: 0 }
        multiple_pins_tee_feed.csv: Tally { translated: 6, approximated: 0, refused: 0 }
        non_trivial_reset_pin.csv: Tally { translated: 8, approximated: 0, refused: 0 }
        pyrung_to_ladder_examples.csv: Tally { translated: 36, approximated: 0, refused: 0 }
        reset_wire_and_output.csv: Tally { translated: 5, approximated: 0, refused: 0 }
        sub_service.csv: Tally { translated: 6, approximated: 0, refused: 0 }
        wheatstone_bridge.csv: Tally { translated: 5, approximated: 1, refused: 0 }
        3:3 X005: approximated: power goes through it both ways; the rung is written as the paths that this makes
        wheatstone_bridge_with_reset.csv: Tally { translated: 7, approximated: 1, refused: 0 }
        6:3 X005: approximated: power goes through it both ways; the rung is written as the paths that this makes
    "#]].assert_eq(&out);
}
