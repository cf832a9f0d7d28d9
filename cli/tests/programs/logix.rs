//! Logix exports: as they are, and as the files of a folder.

use crate::harness::Folder;
use crate::scenarios::without_times;
use expect_test::expect;

/// Two programs; the second uses a tag of the first.
fn project() -> String {
    let program = |name: &str, rung: &str| {
        format!(
            "<Program Name=\"{name}\" MainRoutineName=\"Main\"><Tags><Tag Name=\"step\" TagType=\"Base\" DataType=\"DINT\"/></Tags>\
             <Routines><Routine Name=\"Main\" Type=\"RLL\"><RLLContent>\n<Rung Number=\"0\" Type=\"N\"><Text><![CDATA[{rung}]]></Text></Rung>\n\
             </RLLContent></Routine></Routines></Program>\n"
        )
    };
    format!(
        "<RSLogix5000Content>\n<Controller Name=\"Cell\"><Tags><Tag Name=\"all\" TagType=\"Base\" DataType=\"DINT\"/>\
         <Tag Name=\"timer\" TagType=\"Base\" DataType=\"TIMER\"/></Tags><Programs>\n{}{}</Programs></Controller></RSLogix5000Content>\n",
        program("First", "ADD(step,1,step)TON(timer,100,0)MSG(m);"),
        program("Second", "ADD(step,\\First.step,all)ADD(step,1,step);"),
    )
}

#[test]
fn a_project_goes_into_a_folder_and_runs_there() {
    let folder = Folder::with(&[("cell.L5X", &project())]);
    expect![[r#"
        exit status 0
        -- stderr
        cell.L5X:4:74: approximated: MSG(m): it has no counterpart here: it is not run, and power passes
        cell.L5X: 8 translated, 1 approximated, 0 refused
    "#]]
    .assert_eq(&folder.ladder(&["convert", "cell.L5X", "-o", "cell/"]).to_string());
    expect![[r#"
        exit status 0
        -- stdout
        scan,time_ms,all,timer.ACC
        0,0,1,0
        1,10,3,10
        2,20,5,20
        -- stderr
        note: cell/ladder.toml: the unread part `MSG` is not run, and what it may write is not known
    "#]]
    .assert_eq(
        &folder
            .ladder(&["sim", "cell", "--scans", "3", "--watch", "all,timer.ACC"])
            .to_string(),
    );
    expect![[r#"
        exit status 0
        -- stdout
        warning[unread-part]: `MSG` is an unread part: it is not run, and may write any tag that it sees
          --> cell/blocks.clad:25:16
           |
        25 | FUNCTION_BLOCK [$MSG]
           |                ^^^^^^
           |
           = help: look in the program that it comes from, or write in its place what it does

        Checked 5 files: 1 warning.
    "#]]
    .assert_eq(&folder.ladder(&["check", "cell"]).to_string());
}

#[test]
fn a_file_is_checked_run_and_tested_as_it_is() {
    let scenario = "program cell.L5X\nstep 10ms\n\nscenario \"it counts\"\nall => 1 3 5\n";
    let folder = Folder::with(&[("cell.L5X", &project()), ("cell.ladder-test", scenario)]);
    expect![[r#"
        exit status 0
        -- stdout
        cell.L5X:4:74: warning[unread-part] `MSG` is an unread part: it is not run, and may write any tag that it sees (routine Main of program First, rung 0)
        Checked 1 file: 1 warning.
    "#]]
    .assert_eq(
        &folder
            .ladder(&["check", "--format", "concise", "cell.L5X"])
            .to_string(),
    );
    let run = folder.ladder(&["sim", "cell.L5X", "--scans", "2", "--watch", "all,timer.TT"]);
    expect![[r#"
        exit status 0
        -- stdout
        scan,time_ms,all,timer.TT
        0,0,1,1
        1,10,3,1
        -- stderr
        note: cell.L5X: the unread part `MSG` is not run, and what it may write is not known
    "#]]
    .assert_eq(&run.to_string());
    let run = folder.ladder(&["test", "cell.ladder-test"]).to_string();
    assert!(run.contains("ok    it counts"), "{run}");
    let run = folder.ladder(&["convert", "cell.L5X", "-o", "again.l5k"]);
    expect![[r#"
        exit status 2
        -- stderr
        error: cell.L5X: this cannot be written as Logix L5K export: such files are read, and not written
    "#]]
    .assert_eq(&run.to_string());
}

/// A timer of theirs counts milliseconds in a member; how long it takes is decided all the same.
#[test]
fn what_its_timers_do_is_proved() {
    let project = include_str!("../../../tests/corpus/rockwell/cases/rung_out_of_a_timer/prog.L5X");
    let properties = "\
program prog.L5X

property \"done or timing, not both\"
never c and d

property \"done only while the rung is high\"
when c: a and b

property \"done at once\"
never c

possible c within 30ms
possible c within 20ms
";
    let folder = Folder::with(&[("prog.L5X", project), ("prog.ladder-test", properties)]);
    expect![[r#"
        exit status 1
        -- stdout
        prog.ladder-test
          proved      done or timing, not both          for any times
          proved      done only while the rung is high  for any times
          violated    done at once                      in scan 3, at 30ms
                      a    ----
                      c => ___-
          possible    possible c within 30ms            in scan 3, at 30ms
                      a    ----
                      c => ___-
          impossible  possible c within 20ms            for an interval of 10ms

        5 properties in 1 file: 2 proved, 1 possible, 1 violated, 1 impossible, in T s.
    "#]]
    .assert_eq(&without_times(
        &folder.ladder(&["prove", "prog.ladder-test"]).to_string(),
    ));
}

/// Findings name the part of the file as Studio 5000 does.
#[test]
fn findings_name_routine_and_rung() {
    let rungs = "XIC(go)OTE(lamp);]]></Text></Rung>\n<Rung Number=\"1\" Type=\"N\"><Text><![CDATA[XIC(stop)OTE(lamp);";
    let text = project().replace("ADD(step,\\First.step,all)ADD(step,1,step);", rungs);
    let tag = |name: &str| format!("<Tag Name=\"{name}\" TagType=\"Base\" DataType=\"BOOL\"/>");
    let tags = format!("<Tags>{}{}{}", tag("go"), tag("stop"), tag("lamp"));
    let folder = Folder::with(&[("cell.L5X", &text.replacen("<Tags>", &tags, 1))]);
    for format in ["concise", "full", "json"] {
        let expected = match format {
            "concise" => expect![[r#"
                exit status 0
                -- stdout
                cell.L5X:4:74: warning[unread-part] `MSG` is an unread part: it is not run, and may write any tag that it sees (routine Main of program First, rung 0)
                cell.L5X:8:51: warning[double-coil] `lamp` is written by 2 coils: the last one alone decides (routine Main of program Second, rung 1)
                Checked 1 file: 2 warnings.
            "#]],
            "full" => expect![[r#"
                exit status 0
                -- stdout
                warning[unread-part]: `MSG` is an unread part: it is not run, and may write any tag that it sees
                 --> cell.L5X:4:74
                  |
                4 | <Rung Number="0" Type="N"><Text><![CDATA[ADD(step,1,step)TON(timer,100,0)MSG(m);]]></Text></Rung>
                  |                                                                          ^^^^^^
                  |
                  = note: routine Main of program First, rung 0
                  = help: look in the program that it comes from, or write in its place what it does

                warning[double-coil]: `lamp` is written by 2 coils: the last one alone decides
                 --> cell.L5X:8:51
                  |
                7 | <Rung Number="0" Type="N"><Text><![CDATA[XIC(go)OTE(lamp);]]></Text></Rung>
                  |                                                 --------- `lamp` is written here as well
                8 | <Rung Number="1" Type="N"><Text><![CDATA[XIC(stop)OTE(lamp);]]></Text></Rung>
                  |                                                   ^^^^^^^^^
                  |
                  = note: routine Main of program Second, rung 1
                  = help: combine all conditions into one coil, joined with \ and /; or use (S) and (R)

                Checked 1 file: 2 warnings.
            "#]],
            _ => expect![[r#"
                exit status 0
                -- stdout
                [
                  {"file":"cell.L5X","rule":"unread-part","severity":"warning","message":"`MSG` is an unread part: it is not run, and may write any tag that it sees","line":4,"column":74,"end_line":4,"end_column":80,"part":"routine Main of program First, rung 0","help":"look in the program that it comes from, or write in its place what it does"},
                  {"file":"cell.L5X","rule":"double-coil","severity":"warning","message":"`lamp` is written by 2 coils: the last one alone decides","line":8,"column":51,"end_line":8,"end_column":60,"part":"routine Main of program Second, rung 1","help":"combine all conditions into one coil, joined with \\ and /; or use (S) and (R)","related":[{"file":"cell.L5X","message":"`lamp` is written here as well","line":7,"column":49,"end_line":7,"end_column":58}]}
                ]
            "#]],
        };
        expected.assert_eq(
            &folder
                .ladder(&["check", "--format", format, "cell.L5X"])
                .to_string(),
        );
    }
}
