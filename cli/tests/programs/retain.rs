//! `ladder sim --retain`

use crate::harness::Folder;
use expect_test::{Expect, expect};

const HOURS: &str = "\
VAR_INPUT run : BOOL; END_VAR
VAR RETAIN starts : INT; hours : RTO; END_VAR
VAR n : INT; END_VAR
+--[ ]( run )--[OSR]--[ADD]( starts, starts, 1 )--+
+--[ ]( run )--[RTO]( hours, T#100h )--[ADD]( n, n, 1 )--+
";

fn folder() -> Folder {
    Folder::with(&[("pump.clad", HOURS)])
}

fn sim(folder: &Folder, program: &str, expected: Expect) {
    let arguments = [
        "sim",
        program,
        "--scans",
        "3",
        "--set",
        "run=1",
        "--retain",
        "pump.retain",
        "--watch",
        "starts,hours.ET",
    ];
    expected.assert_eq(&folder.ladder(&arguments).to_string());
}

#[test]
fn a_second_run_goes_on_where_the_first_ended() {
    let folder = folder();
    sim(
        &folder,
        "pump.clad",
        expect![[r#"
        exit status 0
        -- stdout
        scan,time_ms,starts,hours.ET
        0,0,1,0
        1,10,1,10
        2,20,1,20
    "#]],
    );
    sim(
        &folder,
        "pump.clad",
        expect![[r#"
        exit status 0
        -- stdout
        scan,time_ms,starts,hours.ET
        0,0,2,30
        1,10,2,40
        2,20,2,50
    "#]],
    );
    expect![[r#"
        ladder-retain 1
        program pump.clad
        starts	INT	2
        hours	RTO	1	0	0	1	360000000000000	50000000	-10000000
        end 0d20d807
    "#]]
    .assert_eq(&folder.read("pump.retain"));
    assert_eq!(folder.names(), ["pump.clad", "pump.retain"]);
}

#[test]
fn without_the_option_nothing_is_read_or_written() {
    let folder = folder();
    folder.write("ladder.toml", b"[simulate]\nretain = \"pump.retain\"\n");
    let run = folder.ladder(&["sim", "pump.clad", "--scans", "1"]);
    assert_eq!(run.status, Some(0));
    assert_eq!(folder.names(), ["ladder.toml", "pump.clad"]);
}

#[test]
fn what_the_command_line_sets_wins() {
    let folder = folder();
    sim(
        &folder,
        "pump.clad",
        expect![[r#"
        exit status 0
        -- stdout
        scan,time_ms,starts,hours.ET
        0,0,1,0
        1,10,1,10
        2,20,1,20
    "#]],
    );
    let arguments = [
        "sim",
        "pump.clad",
        "--scans",
        "1",
        "--set",
        "starts=40",
        "--retain",
        "pump.retain",
        "--watch",
        "starts",
    ];
    expect![[r#"
        exit status 0
        -- stdout
        scan,time_ms,starts
        0,0,40
    "#]]
    .assert_eq(&folder.ladder(&arguments).to_string());
}

#[test]
fn a_damaged_file_means_a_cold_start() {
    let folder = folder();
    folder.write(
        "pump.retain",
        b"ladder-retain 1\nprogram pump.clad\nstarts\tINT\t7\n",
    );
    sim(
        &folder,
        "pump.clad",
        expect![[r#"
        exit status 0
        -- stdout
        scan,time_ms,starts,hours.ET
        0,0,1,0
        1,10,1,10
        2,20,1,20
        -- stderr
        warning: pump.retain: the file is damaged; the program starts cold, and the file is kept as pump.retain.damaged
    "#]],
    );
    assert_eq!(
        folder.names(),
        ["pump.clad", "pump.retain", "pump.retain.damaged"]
    );
    assert!(folder.read("pump.retain.damaged").ends_with("\t7\n"));
}

#[test]
fn a_program_that_was_changed_takes_what_still_fits() {
    let folder = folder();
    sim(
        &folder,
        "pump.clad",
        expect![[r#"
        exit status 0
        -- stdout
        scan,time_ms,starts,hours.ET
        0,0,1,0
        1,10,1,10
        2,20,1,20
    "#]],
    );
    folder.write(
        "pump2.clad",
        HOURS.replace("starts : INT", "other, starts : DINT").as_bytes(),
    );
    sim(
        &folder,
        "pump2.clad",
        expect![[r#"
        exit status 0
        -- stdout
        scan,time_ms,starts,hours.ET
        0,0,1,30
        1,10,1,40
        2,20,1,50
        -- stderr
        warning: pump.retain: the values were kept by pump.clad; pump2.clad takes those that fit
        warning: pump.retain: starts was kept as INT, but it is DINT now: it begins with its initial value
    "#]],
    );
}

#[test]
fn a_file_that_cannot_be_used_is_refused() {
    let folder = folder();
    let run = folder.ladder(&["sim", "pump.clad", "--scans", "1", "--retain", "."]);
    run.refused_with(".: this is a folder; name a file in it");
    let run = folder.ladder(&["sim", "pump.clad", "--scans", "1", "--retain", "none/pump.retain"]);
    assert_eq!(
        (
            run.status,
            run.stderr.contains("none/pump.retain: cannot be written")
        ),
        (Some(2), true)
    );
}
