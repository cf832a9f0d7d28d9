//! Grids and what becomes of them, side by side.

use super::super::model::{Action, Condition, Program, Routine, Rung};
use super::addresses::Addresses;
use super::rungs::Reader;
use super::*;
use expect_test::{Expect, expect};
use ladder_notation::Report;

/// A routine from rows, of which all but the first cells are left out: `..` stands for wire up to the output.
fn grid(rows: &str) -> String {
    let mut out =
        String::from("marker,A,B,C,D,E,F,G,H,I,J,K,L,M,N,O,P,Q,R,S,T,U,V,W,X,Y,Z,AA,AB,AC,AD,AE,AF\n");
    for line in rows.lines() {
        let (cells, output) = match line.split_once(",..,") {
            Some((cells, output)) => (cells, output),
            None => (line, ""),
        };
        let missing = 32 - cells.split(',').count();
        let fill = if output.is_empty() { "," } else { ",-" };
        if line.starts_with('#') {
            out.push_str(line);
        } else {
            out.push_str(&format!("{cells}{},{output}", fill.repeat(missing)));
        }
        out.push('\n');
    }
    out
}

/// The other way round.
fn short(grid: &str) -> String {
    let lines = grid.lines().skip(1).map(|line| {
        let Some((cells, output)) = line
            .split_once(",-,-,-,-,-,-,-,-,")
            .map(|(cells, rest)| (cells, rest.trim_start_matches("-,")))
        else {
            return line.trim_end_matches(',').to_owned() + "\n";
        };
        format!("{},..,{output}\n", cells.trim_end_matches(",-"))
    });
    lines.collect()
}

fn read(text: &str) -> (Routine, Reader) {
    let grid = file::read(text.as_bytes(), 0).expect("the grid is sound");
    let mut reader = Reader::default();
    for rung in &grid.rungs {
        reader.rung(rung);
    }
    let after = reader.finish(&grid.end);
    let rungs = std::mem::take(&mut reader.rungs);
    (
        Routine {
            rungs,
            after,
            ..Routine::default()
        },
        reader,
    )
}

fn shown(condition: &Condition) -> String {
    let all = |parts: &[Condition], between: &str| {
        let parts: Vec<String> = parts.iter().map(shown).collect();
        format!("({})", parts.join(between))
    };
    match condition {
        Condition::All(parts) => all(parts, " "),
        Condition::Any(parts) => all(parts, " | "),
        leaf => contact::write(leaf, &Addresses::default()).unwrap_or_default(),
    }
}

fn model(routine: &Routine, reader: &Reader) -> String {
    let mut out = String::new();
    for Rung {
        comments,
        condition,
        actions,
        ..
    } in &routine.rungs
    {
        for comment in comments {
            out.push_str(&format!("# {comment}\n"));
        }
        out.push_str(&shown(condition));
        for Action {
            condition,
            what,
            oneshot,
            ..
        } in actions
        {
            let written = output::write(what, *oneshot, &Addresses::default()).expect("it can be written");
            out.push_str(&format!("\n    {} {}", shown(condition), written.output));
            for (pin, condition) in written.pins {
                out.push_str(&format!(" {pin} {}", shown(condition)));
            }
        }
        out.push('\n');
    }
    for comment in &routine.after {
        out.push_str(&format!("# {comment}\n"));
    }
    for entry in reader.report.remarks() {
        out.push_str(&format!(
            "{} {}: {:?}\n",
            entry.place, entry.element, entry.outcome
        ));
    }
    for found in &reader.findings {
        out.push_str(&format!("{} {}: {}\n", found.place, found.check, found.message));
    }
    out
}

fn written(main: &Routine) -> String {
    let program = Program {
        main: main.clone(),
        ..Program::default()
    };
    write::write(&program, &mut Report::default()).0
}

/// What is read, and what is written of it: once more, that is the same.
#[track_caller]
fn check(rows: &str, expected: Expect) {
    let (routine, reader) = read(&grid(rows));
    let text = written(&routine);
    let (again, _) = read(&text);
    assert_eq!(text, written(&again));
    expected.assert_eq(&format!("{}---\n{}", model(&routine, &reader), short(&text)));
}

#[test]
fn series_and_branches() {
    check(
        r#"#,Start and stop.
R,X001,T,~X002,..,out(Y001)
,Y001
R,X001,T:X002,-,-,T,..,out(Y002)
,,T:C1,rise(C2),fall(C3),|
,,DS1>=5,-,-
R,..,end()"#,
        expect![[r#"
                # Start and stop.
                ((X001 | Y001) ~X002)
                    () out(Y001)
                (X001 (X002 | (C1 rise(C2) fall(C3)) | DS1>=5))
                    () out(Y002)
                ()
                    () end()
                ---
                #,Start and stop.
                R,X001,T:~X002,..,out(Y001)
                ,Y001
                R,X001,T:X002,-,-,T,..,out(Y002)
                ,,T:C1,rise(C2),fall(C3),|
                ,,DS1>=5,-,-
                R,..,end()
            "#]],
    );
}

#[test]
fn outputs_with_branches_of_their_own() {
    check(
        r#"R,C1,T,..,out(Y001)
,,T:C2,T,T,..,out(Y002)
,,T:C3,..,out(Y003)
,,..,out(Y004)"#,
        expect![[r#"
                C1
                    () out(Y001)
                    (C2 | C3) out(Y002)
                    (C2 | C3) out(Y003)
                    () out(Y004)
                ---
                R,C1,T,..,out(Y001)
                ,,T:C2,T,T,..,out(Y002)
                ,,T:C3,,..,out(Y003)
                ,,..,out(Y004)
            "#]],
    );
}

#[test]
fn pins_and_rungs_that_go_on() {
    check(
        r#"R,C1,..,"count_up(CT1,CTD1,preset=1)"
,C2,T,..,.reset()
,,T,..,"on_delay(T1,TD1,preset=1,unit=Ts)"
,,C4,..,.reset()
R,X001,..,shift(C100..C107)
,X005,..,.clock()
,X006,..,.reset()
R,C1,..,out(Y001)
,C2,..,out(Y002)"#,
        expect![[r#"
                C1
                    () count_up(CT1,CTD1,preset=1) .reset() C2
                # click: goes on in the same rung of the grid
                C2
                    () on_delay(T1,TD1,preset=1,unit=Ts) .reset() (C2 C4)
                X001
                    () shift(C100..C107) .clock() X005 .reset() X006
                C1
                    () out(Y001)
                # click: goes on in the same rung of the grid
                C2
                    () out(Y002)
                ---
                R,C1,..,"count_up(CT1,CTD1,preset=1)"
                ,C2,..,.reset()
                ,C2,..,"on_delay(T1,TD1,preset=1,unit=Ts)"
                ,C2,C4,..,.reset()
                R,X001,..,shift(C100..C107)
                ,X005,..,.clock()
                ,X006,..,.reset()
                R,C1,..,out(Y001)
                ,C2,..,out(Y002)
            "#]],
    );
}

#[test]
fn a_bridge_becomes_its_paths() {
    check(
        r#"R,X001,T,X003,T,..,out(Y001)
,,X005,|,|
,X002,-,X004"#,
        expect![[r#"
                ((X001 X003) | (X001 X005 X004) | (X002 X005 X003) | (X002 X004))
                    () out(Y001)
                3:3 X005: Approximated("power goes through it both ways; the rung is written as the paths that this makes")
                ---
                R,X001,X003,-,T,..,out(Y001)
                ,X001,X005,X004,|
                ,X002,X005,X003,|
                ,X002,X004,-
            "#]],
    );
}

#[test]
fn what_cannot_be_read_stays() {
    check(
        r#"R,X001,..,"send(a,b)"
,X002,..,.reset()
R,X001,Z9,..,out(Y001)
R,X001,T,..,out(Y001)
,,X002,|
R,X001,,-,..,out(Y001)
R,X001,..,"send(target=1)"
#,At the end."#,
        expect![[r##"
            # click: grid R,X001,..,"send(a,b)"
            # click: grid ,X002,..,.reset()
            # click: grid R,X001,Z9,..,out(Y001)
            # click: without effect in the grid: X002
            X001
                () out(Y001)
            # click: grid R,X001,,..,out(Y001)
            X001
                () send(target=1)
            # At the end.
            2:68 send(a,b): Refused("ladder text has no counterpart for `send`")
            4:8 Z9: Refused("`Z9` is not a cell of the grid: `X001`, `~X001`, `rise(X001)`, `fall(X001)`, `DS1==5`, `-`, `T`, `|` and `T:X001` are")
            6:3 X002: Refused("no output depends on it: what it lets through leads nowhere, or a wire leads round it")
            7:67 out(Y001): Refused("nothing joins it to the left rail")
            2:68 click-grid: the rung stays as a comment, for `send(a,b)`: ladder text has no counterpart for `send`
            4:8 click-grid: the rung stays as a comment, for `Z9`: `Z9` is not a cell of the grid: `X001`, `~X001`, `rise(X001)`, `fall(X001)`, `DS1==5`, `-`, `T`, `|` and `T:X001` are
            6:3 click-c0202: a line is missing at `X002`: no output depends on it: what it lets through leads nowhere, or a wire leads round it
            7:67 click-c0202: the rung stays as a comment, for `out(Y001)`: nothing joins it to the left rail
            ---
            R,X001,..,"send(a,b)"
            ,X002,..,.reset()
            R,X001,Z9,..,out(Y001)
            #,click: without effect in the grid: X002
            R,X001,..,out(Y001)
            R,X001,,..,out(Y001)
            #,At the end.
            R,X001,..,send(target=1)
        "##]],
    );
}
