//! What is compared with what: the files that a program uses, and those that have another name.

use super::edited;
use crate::harness::{Folder, MOTOR};
use expect_test::expect;

const USES_LIFT: &str = "\
VAR_INPUT
    go : BOOL;
END_VAR
VAR_OUTPUT
    up : BOOL;
END_VAR

+--[ ]( go )-----------------------------------------------------[$Lift]( up )--+
";

fn lift(time: &str) -> String {
    format!(
        "FUNCTION_BLOCK [$Lift]\nVAR_OUTPUT\n    up : BOOL;\nEND_VAR\nVAR\n    t : TON;\nEND_VAR\n\n\
         +--[ ]( EN )--[TON]( t, {time} )--( )( up )--+\nEND_FUNCTION_BLOCK\n"
    )
}

#[test]
fn a_program_is_compared_with_the_files_that_it_uses() {
    let folder = Folder::with(&[
        ("old/blocks.clad", &lift("20ms")),
        ("old/main.clad", USES_LIFT),
        ("old/other.clad", MOTOR),
        ("new/blocks.clad", &lift("40ms")),
        ("new/main.clad", USES_LIFT),
        ("new/other.clad", MOTOR),
        (
            "told/blocks.clad",
            &format!("# told otherwise #\n{}", lift("T#20ms")),
        ),
        ("told/main.clad", USES_LIFT),
        ("told/other.clad", MOTOR),
    ]);
    expect![[r#"
        exit status 1
        -- stdout
        --- old/main.clad
        +++ new/main.clad
            3 the same, it uses blocks.clad, which is different

            ... 3 the same

        the programs differ in scan 2, at 20ms
            go    ---
            up => __-  (old)
            up => ___  (new)
    "#]]
    .assert_eq(
        &folder
            .ladder(&["diff", "old/main.clad", "new/main.clad"])
            .to_string(),
    );
    let both = folder.ladder(&["diff", "--same", "old", "new"]).to_string();
    assert!(
        both.contains("not the same") && both.contains("main.clad: the programs differ"),
        "{both}"
    );
    let told = folder.ladder(&["diff", "--same", "old/main.clad", "told/main.clad"]);
    assert_eq!(told.to_string(), "exit status 0\n-- stdout\nthe same\n");
    let json = folder
        .ladder(&["diff", "--format", "json", "old", "new"])
        .to_string();
    assert!(json.contains("\"difference\": \"content\""), "{json}");

    // A tag that another file declares.
    let user = "VAR_OUTPUT\n    y : BOOL;\nEND_VAR\n\n+--[GT]( limit, 3 )--( )( y )--+\n";
    let global = |initial: &str| format!("VAR_GLOBAL\n    limit : INT{initial};\nEND_VAR\n");
    folder.write("old/user.clad", user.as_bytes());
    folder.write("old/global.clad", global("").as_bytes());
    folder.write("new/user.clad", user.as_bytes());
    folder.write("new/global.clad", global(" := 5").as_bytes());
    let told = folder
        .ladder(&["diff", "old/user.clad", "new/user.clad"])
        .to_string();
    assert!(
        told.contains("it uses limit, which another file declares differently"),
        "{told}"
    );
}

/// In a program the bodies of blocks come after all other networks.
#[test]
fn networks_below_a_block_are_compared_with_themselves() {
    let text = |a: &str, b: &str| {
        format!(
            "{}\nVAR_INPUT\n    a, b, c : BOOL;\nEND_VAR\nVAR_OUTPUT\n    x, y, z : BOOL;\nEND_VAR\n\n\
             +--{a}--( )( x )--+\n\n+--{b}--( )( y )--+\n\n+--[ ]( c )--[$Lift]( z )--+\n",
            lift("20ms")
        )
    };
    let folder = Folder::with(&[
        ("old.clad", &text("[ ]( a )--[ ]( b )", "[ ]( b )")),
        ("new.clad", &text("[ ]( b )--[ ]( a )", "[/]( b )")),
    ]);
    let told = folder.ladder(&["diff", "old.clad", "new.clad"]).to_string();
    let headings: Vec<&str> = told.lines().filter(|line| line.starts_with("edited")).collect();
    expect![[r#"
        edited, does the same: network, line 19, writes x
        edited, does another thing: network, line 21, writes y"#]]
    .assert_eq(&headings.join("\n"));
}

#[test]
fn a_file_with_another_name_is_known_by_what_it_holds() {
    let folder = Folder::with(&[
        ("old/motor.clad", MOTOR),
        ("old/lift.clad", &lift("20ms")),
        ("new/lines/motor.clad", &edited()),
        ("new/lift.clad", &lift("20ms")),
    ]);
    let told = folder.ladder(&["diff", "old", "new"]).to_string();
    expect![[r#"
        exit status 1
        -- stdout
        --- old/motor.clad
        +++ new/lines/motor.clad
            renamed, 1 edited
    "#]]
    .assert_eq(&(told.lines().take(5).collect::<Vec<_>>().join("\n") + "\n"));
    folder.write("new/lines/motor.clad", MOTOR.as_bytes());
    expect![[r#"
        exit status 1
        -- stdout
        --- old/motor.clad
        +++ new/lines/motor.clad
            renamed, 1 the same

            ... 1 the same
    "#]]
    .assert_eq(&folder.ladder(&["diff", "old", "new"]).to_string());
    let same = folder.ladder(&["diff", "--same", "old", "new"]).to_string();
    assert_eq!(same, "exit status 0\n-- stdout\nthe same\n");
}
