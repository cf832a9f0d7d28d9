//! Projects of several programs.

use crate::exports::routine;
use crate::run::{converted, trace};
use expect_test::expect;
use ladder_notation_logix::L5x;

/// Two programs and a task. Both have a tag `step` and a routine `Sub`.
fn project() -> String {
    let program = |name: &str, rungs: &[&str]| {
        format!(
            "<Program Name=\"{name}\" MainRoutineName=\"Main\">\n<Tags>\n<Tag Name=\"step\" TagType=\"Base\" \
             DataType=\"DINT\"/>\n</Tags>\n<Routines>\n{}{}</Routines>\n</Program>\n",
            routine("Main", &["JSR(Sub,0);"]),
            routine("Sub", rungs),
        )
    };
    format!(
        "<RSLogix5000Content>\n<Controller Name=\"Cell\">\n<Tags>\n<Tag Name=\"all\" TagType=\"Base\" \
         DataType=\"DINT\"/>\n<Tag Name=\"timer\" TagType=\"Base\" DataType=\"TIMER\"/>\n</Tags>\n<Programs>\n{}{}{}</Programs>\n<Tasks>\n<Task \
         Name=\"Main\" Type=\"PERIODIC\" Rate=\"5\">\n<ScheduledPrograms>\n<ScheduledProgram Name=\"Second\"/>\n<ScheduledProgram \
         Name=\"First\"/>\n</ScheduledPrograms>\n</Task>\n</Tasks>\n</Controller>\n</RSLogix5000Content>\n",
        program(
            "First",
            &[
                "ADD(step,1,step)MUL(all,10,all)ADD(all,step,all);",
                "TON(timer,100,0);"
            ]
        ),
        program("Second", &["ADD(step,2,step)ADD(all,step,all);"]),
        program("Third", &["ADD(step,100,step)MOV(\\Second.step,all);"]),
    )
}

#[test]
fn programs_run_in_the_order_of_their_tasks() {
    let converted = converted(&L5x, project().as_bytes());
    expect![[r#"
        all
        21
        252"#]]
    .assert_eq(&trace(&converted.written.text, "", 2, "all"));
    let remarks = converted
        .report
        .remarks()
        .map(|entry| format!("{} {}", entry.place, entry.element));
    expect!["63:1 program Third"].assert_eq(&remarks.collect::<Vec<_>>().join("\n"));
}

#[test]
fn a_project_is_the_files_of_a_folder() {
    let converted = converted(&L5x, project().as_bytes());
    let files = converted.files.iter().map(|file| {
        let text = String::from_utf8_lossy(&file.bytes);
        format!(
            "=== {}\n{}",
            file.name,
            text.split("# On-delay").next().unwrap_or_default()
        )
    });
    expect![[r#"
        === Cell.clad
        # ladder: profile logix #

        VAR_GLOBAL
            all         : DINT;
            timer       : TIMER := (PRE := 100);
            Second_step : DINT;  # step #
        END_VAR
        === First.clad
        # ladder: profile logix #

        VAR
            First_step : DINT;  # step #
        END_VAR

        +--------------------------------------------------------<CALL>( First_Main )--+

        +--<FUN>( First_Main )---------------------------------------------------------+

        +---------------------------------------------------------<CALL>( First_Sub )--+

        +--<FUN>( First_Sub )----------------------------------------------------------+

        +--------[ADD]( First_step, First_step, 1 )--[MUL]( all, all, 10 )--[ADD]( all, all, First_step )--+

        +-------------------------------------------------------------[$TON]( timer )--+
        === Second.clad
        # ladder: profile logix #

        +-------------------------------------------------------<CALL>( Second_Main )--+

        +--<FUN>( Second_Main )--------------------------------------------------------+

        +--------------------------------------------------------<CALL>( Second_Sub )--+

        +--<FUN>( Second_Sub )---------------------------------------------------------+

        +--------[ADD]( Second_step, Second_step, 2 )--[ADD]( all, all, Second_step )--+
        === Third.clad
        # ladder: profile logix #

        VAR
            Third_step : DINT;  # step #
        END_VAR

        +--<FUN>( Third_Main )---------------------------------------------------------+

        +---------------------------------------------------------<CALL>( Third_Sub )--+

        +--<FUN>( Third_Sub )----------------------------------------------------------+

        +-------------[ADD]( Third_step, Third_step, 100 )--[MOV]( all, Second_step )--+
        === types.clad
        # ladder: profile logix #

        TYPE
            TIMER : STRUCT
                PRE  : DINT;
                ACC  : DINT;
                EN   : BOOL;
                TT   : BOOL;
                DN   : BOOL;
                LAST : LINT;  # when the time was last counted, in ms #
            END_STRUCT;
        END_TYPE
        === blocks.clad
        # ladder: profile logix #

        === ladder.toml
        [lint]
        never-written = "off"
        never-read = "off"
        set-without-reset = "off"
        reset-without-set = "off"
        contact-after-coil = "off"

        [[task]]
        name = "Main"
        interval = "5ms"
        priority = 16
        programs = ["Second.clad", "First.clad"]
    "#]]
    .assert_eq(&files.collect::<String>());
}
