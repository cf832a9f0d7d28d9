//! Click's grid of cells, read and written.

use expect_test::{Expect, expect, expect_file};
use ladder_format::Options;
use ladder_notation::{Companion, Converted, Notation, Outcome, Source, convert};
use ladder_notation_click::ClickGrid;
use std::path::{Path, PathBuf};

fn notation() -> &'static dyn Notation {
    &ClickGrid
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
            bytes: std::fs::read(path).expect("the file can be read").into(),
        })
        .collect();
    companions.sort_by(|one, other| one.name.cmp(&other.name));
    let source = Source {
        name,
        bytes: &bytes,
        companions,
    };
    convert(notation(), &source, &Options::default()).map_err(|error| error.to_string())
}

/// What there is to say about a conversion, and what Click would complain about.
fn remarks(converted: &Converted) -> String {
    let mut out = reported(converted);
    for found in &converted.findings {
        out.push_str(&format!("{} {}: {}\n", found.place, found.check, found.message));
    }
    out
}

/// What there is to say about a conversion.
fn reported(converted: &Converted) -> String {
    let mut out = String::new();
    for entry in converted.report.remarks() {
        let (word, why) = match &entry.outcome {
            Outcome::Approximated(why) => ("approximated", why),
            Outcome::Refused(why) => ("refused", why),
            Outcome::Translated => continue,
        };
        out.push_str(&format!("{} {}: {word}: {why}\n", entry.place, entry.element));
    }
    out
}

fn own(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("tests/click/grid")
        .join(name)
}

#[track_caller]
fn check(name: &str, told: Expect) {
    let converted = converted(&own(name)).unwrap_or_else(|error| panic!("{error}"));
    expect_file![own(name).with_extension("clad")].assert_eq(&converted.written.text);
    told.assert_eq(&remarks(&converted));
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
            3:1 click-c0201: the main program needs an unconditional end(): write it on a rung without contacts at its end
            4:64 click-c000a: the inputs of this instruction come from different branches: its pins begin at the left rail, and its rung has other instructions; give it a rung of its own
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
            23:65 click-c0107: Click itself wants a contact before this instruction: SC1 always conducts
            25:68 click-element: `send(target=plc1,remote_start="DS1",source=DS3,count=1)` stays as a comment: ladder text has no counterpart for `send`
        "#]],
    );
}

/// The files that are written from a ladder text: the grid first.
fn write(ladder: &str) -> Result<Vec<(String, String)>, String> {
    let analysis = ladder_analysis::analyze(&ladder_syntax::parse(ladder).into(), "test.clad");
    let writing = notation().write(&analysis).map_err(|error| error.to_string())?;
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).map_err(|error| error.to_string());
    let mut files = vec![(String::new(), text(writing.bytes)?)];
    for companion in writing.companions {
        files.push((companion.name, text(companion.bytes.to_vec())?));
    }
    Ok(files)
}

/// Files as a program that lies in a folder.
fn read_files(name: &str, files: &[(String, String)]) -> Result<Converted, String> {
    let companions: Vec<Companion> = files[1..]
        .iter()
        .map(|(name, text)| Companion {
            name: name.clone(),
            bytes: text.clone().into(),
        })
        .collect();
    let source = Source {
        name: name.into(),
        bytes: files[0].1.as_bytes(),
        companions,
    };
    convert(notation(), &source, &Options::default()).map_err(|error| error.to_string())
}

/// What is written of a program, without the wires up to the outputs. Read and written again it is the same.
#[track_caller]
fn there_and_back(name: &str, ladder: &str) -> String {
    let written = write(ladder).unwrap_or_else(|error| panic!("{name}: {error}\n{ladder}"));
    let again = read_files(name, &written).unwrap_or_else(|error| panic!("{name}: {error}"));
    let text = &again.written.text;
    let twice = write(text).unwrap_or_else(|error| panic!("{name}: {error}\n{text}"));
    assert_eq!(twice, written, "{name}:\n{ladder}\n{text}");
    let mut out = String::new();
    for (name, text) in written {
        out.push_str(&format!("{name}\n"));
        for line in text.lines() {
            let line = line.trim_end_matches(',');
            match line.split_once(",-,-,-,-,-,-,-,") {
                Some((cells, output)) => {
                    let output = output.trim_start_matches("-,");
                    out.push_str(&format!("{},..,{output}\n", cells.trim_end_matches(",-")));
                }
                None => out.push_str(&format!("{line}\n")),
            }
        }
    }
    out
}

#[test]
fn a_folder_comes_back() {
    let ladder = converted(&own("washer/main.csv"))
        .expect("it can be read")
        .written
        .text;
    expect![[r#"

        marker,A,B,C,D,E,F,G,H,I,J,K,L,M,N,O,P,Q,R,S,T,U,V,W,X,Y,Z,AA,AB,AC,AD,AE,AF
        #,A machine that washes parts.
        #,"Start seals itself in, and stop or the lid ends it."
        R,X001,T:~X002,~X003,..,out(C1)
        ,C1
        #,"Filling: the valve opens, and the time it takes is watched."
        R,C1,T:~X004,T,..,out(Y001)
        ,,T:C10
        ,,T:~X004,T:rise(X005),..,latch(C11)
        ,,T:C10
        ,,..,"on_delay(T1,TD1,preset=DS1,unit=Ts)"
        R,T1,..,latch(C12)
        R,C1,X004,..,"call(""Rinse_and_dry"")"
        #,Parts are counted at the light barrier.
        R,rise(X006),..,"count_up(CT1,CTD1,preset=100)"
        ,X007,..,.reset()
        R,CT1,DS10>=5,T,..,"copy(DS10,DD1)"
        ,,,T,..,"math(DS10 * 100 / DS11,DF1,mode=decimal)"
        ,,,..,"copy(0,DS10,oneshot=1)"
        R,..,end()
        subroutines/Rinse_and_dry.csv
        marker,A,B,C,D,E,F,G,H,I,J,K,L,M,N,O,P,Q,R,S,T,U,V,W,X,Y,Z,AA,AB,AC,AD,AE,AF
        R,C1,..,"on_delay(T2,TD2,preset=30,unit=Ts)"
        ,C11,..,.reset()
        R,~T2,..,out(Y002)
        R,..,return()
        nicknames.csv
        Address,Data Type,Nickname,Initial Value,Retentive,Address Comment
        X001,BIT,"Start",0,No,"push button"
        X002,BIT,"Stop",0,No,""
        X003,BIT,"Lid open",0,No,""
        X004,BIT,"Full",0,No,"float switch"
        Y001,BIT,"Valve",0,No,""
        Y002,BIT,"Fan",0,No,""
        C1,BIT,"Running",0,No,""
        C11,BIT,"Jam",0,Yes,"kept over a loss of power"
        T1,BIT,"FillTime",0,No,""
        CT1,BIT,"Parts",0,Yes,""
        DS1,INT,"FillSeconds",20,Yes,"how long filling may take"
        DF1,FLOAT,"Share",0,Yes,""
    "#]]
    .assert_eq(&there_and_back("main", &ladder));
}

#[test]
fn bridges_come_back_as_their_paths() {
    let ladder = converted(&own("bridges.csv"))
        .expect("it can be read")
        .written
        .text;
    expect![[r#"

        marker,A,B,C,D,E,F,G,H,I,J,K,L,M,N,O,P,Q,R,S,T,U,V,W,X,Y,Z,AA,AB,AC,AD,AE,AF
        #,A bridge: power may go through C5 either way.
        R,C1,C3,-,T,T,..,out(Y001)
        ,C1,C5,C4,|,..,"on_delay(T1,TD1,preset=1,unit=Tms)"
        ,C2,C5,C3,|
        ,C2,C4,-
        ,C1,C3,-,T,..,.reset()
        ,C1,C5,C4,|
        ,C2,C5,C3,|
        ,C2,C4,-
        #,Two outputs behind a contact that both lend each other.
        R,X001,-,T:X003,..,out(Y002)
        ,X002,X005
        ,X001,X005,T:X004,..,out(Y003)
        ,X002,-
    "#]]
    .assert_eq(&there_and_back("bridges", &ladder));
}

#[test]
fn every_instruction_comes_back() {
    let ladder = converted(&own("instructions.csv"))
        .expect("it can be read")
        .written
        .text;
    expect![[r#"

        marker,A,B,C,D,E,F,G,H,I,J,K,L,M,N,O,P,Q,R,S,T,U,V,W,X,Y,Z,AA,AB,AC,AD,AE,AF
        R,X001,fall(X002),~C1,"TXT1==""A""",..,out(C2..C5)
        R,X001,T,..,"fill(0,DS1..DS4)"
        ,,T,..,"blockcopy(DS1..DS4,DS11..DS14)"
        ,,T,..,"pack_bits(C1..C16,DH1)"
        ,,T,..,"pack_words(DS1..DS2,DD1)"
        ,,T,..,"unpack_to_bits(DH1,C101..C116)"
        ,,T,..,"unpack_to_words(DD1,DS21..DS22)"
        ,,T,..,"copy(DS[DS1+9],DS[DS2-1])"
        ,,T,..,"math(LSH(DH1,0001h) OR DH2,DH3,mode=hex)"
        ,,..,"search(DS101..DS110 >= DS1,result=DS30,found=C30,continuous=1)"
        R,X001,..,shift(C201..C208)
        ,X002,..,.clock()
        ,X003,T,..,.reset()
        ,X004
        R,rise(X001),..,"count_up(CT1,CTD1,preset=DS5)"
        ,rise(X002),..,.down()
        ,X003,..,.reset()
        R,rise(X005),..,"count_down(CT2,CTD2,preset=3)"
        ,X003,..,.reset()
        R,Y001,..,"off_delay(T3,TD3,preset=500,unit=Tms)"
        R,X001,..,for(3)
        R,..,"math(DS1 + 1,DS1,mode=decimal)"
        R,..,next()
        R,X001,..,"send(target=plc1,remote_start=""DS1"",source=DS3,count=1)"
        R,X001,..,"event_drum(outputs=[Y001],events=[X001],pattern=[[1]],current_step=DS10,completion_flag=C10)"
        ,X006,..,.reset()
        R,..,end()
    "#]].assert_eq(&there_and_back("instructions", &ladder));
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
                "2:1: `S` is not a marker: a row begins with `R` (a rung), with nothing (the rung goes on) or with `#` (a comment)"
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
                2:1 click-c0201: the main program needs an unconditional end(): write it on a rung without contacts at its end
                2:65 click-element: `out(Y😀001)` stays as a comment: `Y😀001` is neither an address nor a value
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
    let is_grid = |bytes: &[u8]| ClickGrid.recognises(bytes);
    let grid = std::fs::read(own("bridges.csv")).expect("the file can be read");
    assert!(is_grid(&grid));
    assert!(!is_grid(b"Address,Data Type,Nickname\nDS1,INT,a\n"));
    assert!(!is_grid(b"marker,A,B\n"));
    assert!(!is_grid(b"scan,time_ms,a\n0,0,1\n"));
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
        out.push_str(&reported(&converted));
        let text = &converted.written.text;
        assert_eq!(ladder_syntax::parse(text).errors(), [], "{name}:\n{text}");
        let _ = there_and_back(name.trim_end_matches(".csv"), text);
    }
    expect![[r#"
        branch_Or_one_output.csv: Tally { translated: 6, approximated: 0, refused: 0 }
        branch_Or_two_outputs.csv: Tally { translated: 7, approximated: 0, refused: 0 }
        branch_Or_with_following_Rung_output.csv: Tally { translated: 8, approximated: 0, refused: 0 }
        click_or_topology.csv: Tally { translated: 49, approximated: 0, refused: 0 }
        main.csv: Tally { translated: 82, approximated: 0, refused: 3 }
        20:68 search("==","AB",TXT1..TXT8,DS4,C1): refused: [SEARCH] looks for one character, not for a text
        45:65 send(target=ModbusTcpTarget(name="plc1",ip="10.0.0.1",port=502,device_id=1),remote_start="DS1",source=DS3,sending=C20,success=C21,error=C22,exception_response=DS20,count=1): refused: ladder text has no counterpart for `send`
        46:65 receive(target=ModbusTcpTarget(name="plc1",ip="10.0.0.1",port=502,device_id=1),remote_start="DS10",dest=DS22,receiving=C23,success=C24,error=C25,exception_response=DS23,count=1): refused: ladder text has no counterpart for `receive`
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
