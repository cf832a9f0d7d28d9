//! `ladder diff` of files and folders.

use crate::harness::{CROOKED, Folder, MOTOR};
use expect_test::expect;

fn edited() -> String {
    MOTOR.replace("[/]( stop )", "[ ]( stop )")
}

#[test]
fn the_same_and_drawn_differently_and_different() {
    let folder = Folder::with(&[
        ("a.clad", MOTOR),
        ("same.clad", MOTOR),
        ("crooked.clad", CROOKED),
        ("edited.clad", &edited()),
    ]);
    expect![[r#"
        exit status 0
    "#]]
    .assert_eq(&folder.ladder(&["diff", "a.clad", "same.clad"]).to_string());
    expect![[r#"
        exit status 1
        -- stdout
        --- a.clad
        +++ crooked.clad
            1 drawn differently

        drawn differently: network, line 1, writes run
    "#]]
    .assert_eq(&folder.ladder(&["diff", "a.clad", "crooked.clad"]).to_string());
    expect![[r#"
        exit status 1
        -- stdout
        --- a.clad
        +++ edited.clad
            1 edited

        edited, does another thing: network, line 1, writes run
            with run on and stop off, run goes on in the old and off in the new program
        - +--\--[ ]( start )--\--[/]( stop )-------------------------------( )( run )--+
                                 ^^^^^^^^^^^
        - |  /--[ ]( run )----/                                                        |
        + +--\--[ ]( start )--\--[ ]( stop )-------------------------------( )( run )--+
                                 ^^^^^^^^^^^
        + |  /--[ ]( run )----/                                                        |

        the programs differ in scan 0, at 0s
            start    -
            run   => -  (old)
            run   => _  (new)
    "#]]
    .assert_eq(&folder.ladder(&["diff", "a.clad", "edited.clad"]).to_string());
    for (arguments, message) in [
        (
            ["diff", "a.clad", "none.clad"],
            "none.clad: no such file or folder",
        ),
        (
            ["diff", "a.clad", "."],
            "a file and a folder cannot be compared; name two files or two folders",
        ),
    ] {
        folder.ladder(&arguments).refused_with(message);
    }
}

#[test]
fn no_file_is_one_that_was_added_or_removed() {
    let folder = Folder::with(&[("a.clad", MOTOR)]);
    expect![[r#"
        exit status 1
        -- stdout
        --- (no such file)
        +++ a.clad
            1 new

        new: network, line 1, writes run
        + +--\--[ ]( start )--\--[/]( stop )-------------------------------( )( run )--+
        + |  /--[ ]( run )----/                                                        |
    "#]]
    .assert_eq(&folder.ladder(&["diff", "/dev/null", "a.clad"]).to_string());
    assert_eq!(folder.ladder(&["diff", "a.clad", "/dev/null"]).status, Some(1));
}

#[test]
fn folders_with_their_settings() {
    let folder = Folder::with(&[
        ("old/a.clad", MOTOR),
        ("old/gone.clad", "+--[ ]( c )--( )( d )--+\n"),
        ("old/ladder.toml", "[format]\nwidth = 80\n"),
        ("new/a.clad", &edited()),
        ("new/line/b.clad", "+--[ ]( a )--( )( b )--+\n"),
        ("new/ladder.toml", "[format]\nwidth = 90\n"),
        ("new/notes.txt", "not compared"),
    ]);
    expect![[r#"
        exit status 1
        -- stdout
        --- old/a.clad
        +++ new/a.clad
            1 edited

        edited, does another thing: network, line 1, writes run
            with run on and stop off, run goes on in the old and off in the new program
        - +--\--[ ]( start )--\--[/]( stop )-------------------------------( )( run )--+
                                 ^^^^^^^^^^^
        - |  /--[ ]( run )----/                                                        |
        + +--\--[ ]( start )--\--[ ]( stop )-------------------------------( )( run )--+
                                 ^^^^^^^^^^^
        + |  /--[ ]( run )----/                                                        |

        the programs differ in scan 0, at 0s
            start    -
            run   => -  (old)
            run   => _  (new)

        --- old/gone.clad
        +++ (no such file)
            1 gone

        gone: network, was line 1, writes d
        - +--[ ]( c )--------------------------------------------------------( )( d )--+

        --- (no such file)
        +++ new/line/b.clad
            1 new

        new: network, line 1, writes b
        + +--[ ]( a )--------------------------------------------------------( )( b )--+

        --- old/ladder.toml
        +++ new/ladder.toml
          [format]
        - width = 80
        + width = 90
    "#]]
    .assert_eq(&folder.ladder(&["diff", "old", "new"]).to_string());
    expect![[r#"
        exit status 1
        -- stdout
        ### `new/a.clad` (was `old/a.clad`)

        1 edited

        edited, does another thing: network, line 1, writes run

        with run on and stop off, run goes on in the old and off in the new program

        ```diff
        - +--\--[ ]( start )--\--[/]( stop )-------------------------------( )( run )--+
                                 ^^^^^^^^^^^
        - |  /--[ ]( run )----/                                                        |
        + +--\--[ ]( start )--\--[ ]( stop )-------------------------------( )( run )--+
                                 ^^^^^^^^^^^
        + |  /--[ ]( run )----/                                                        |
        ```

        the programs differ in scan 0, at 0s

        ```diff
        start    -
        run   => -  (old)
        run   => _  (new)
        ```

        ### `old/gone.clad` (gone)

        1 gone

        gone: network, was line 1, writes d

        ```diff
        - +--[ ]( c )--------------------------------------------------------( )( d )--+
        ```

        ### `new/line/b.clad` (new file)

        1 new

        new: network, line 1, writes b

        ```diff
        + +--[ ]( a )--------------------------------------------------------( )( b )--+
        ```

        ### `new/ladder.toml`

        ```diff
          [format]
        - width = 80
        + width = 90
        ```

    "#]]
    .assert_eq(
        &folder
            .ladder(&["diff", "old", "new", "--format", "markdown"])
            .to_string(),
    );
    assert_eq!(
        folder.ladder(&["diff", "old", "old"]).to_string(),
        "exit status 0\n"
    );
}

#[test]
fn for_machines() {
    let folder = Folder::with(&[("a.clad", MOTOR), ("b.clad", &edited())]);
    expect![[r#"
        exit status 1
        -- stdout
        [
          {
            "old": "a.clad",
            "new": "b.clad",
            "same": 0,
            "changes": [
              {
                "change": "edited",
                "moved": false,
                "kind": "network",
                "names": [
                  "run"
                ],
                "meaning": "other",
                "reason": "with run on and stop off, run goes on in the old and off in the new program",
                "old": {
                  "line": 1,
                  "text": "+--\\--[ ]( start )--\\--[/]( stop )---------------------------------( )( run )--+\n|  /--[ ]( run )----/                                                          |\n"
                },
                "new": {
                  "line": 1,
                  "text": "+--\\--[ ]( start )--\\--[ ]( stop )---------------------------------( )( run )--+\n|  /--[ ]( run )----/                                                          |\n"
                }
              }
            ],
            "whole": {
              "meaning": "other",
              "reasons": [
                "the programs differ in scan 0, at 0s"
              ],
              "scan": 0,
              "interval_ns": 10000000,
              "given": [
                {
                  "tag": "start",
                  "values": [
                    "TRUE"
                  ]
                }
              ],
              "differs": [
                {
                  "tag": "run",
                  "old": [
                    "TRUE"
                  ],
                  "new": [
                    "FALSE"
                  ]
                }
              ],
              "scenario": "scenario \"the programs differ\"\nstart    -\nrun   => -\n"
            }
          }
        ]
    "#]].assert_eq(
        &folder
            .ladder(&["diff", "a.clad", "b.clad", "--format", "json"])
            .to_string(),
    );
}

/// A program of Logix.
fn logix(rung: &str) -> String {
    format!(
        "<RSLogix5000Content><Controller Name=\"C\"><Tags><Tag Name=\"a\" TagType=\"Base\" DataType=\"BOOL\"/>\
         <Tag Name=\"x\" TagType=\"Base\" DataType=\"BOOL\"/></Tags><Programs><Program Name=\"P\" MainRoutineName=\"Main\">\
         <Routines><Routine Name=\"Main\" Type=\"RLL\"><RLLContent><Rung Number=\"0\" Type=\"N\"><Text><![CDATA[{rung}]]></Text>\
         </Rung></RLLContent></Routine></Routines></Program></Programs></Controller></RSLogix5000Content>\n"
    )
}

#[test]
fn programs_of_other_systems() {
    let folder = Folder::with(&[
        ("a.L5X", &logix("XIC(a)OTE(x);")),
        ("b.L5X", &logix("XIO(a)OTE(x);")),
    ]);
    let converted = folder.ladder(&["convert", "a.L5X", "-o", "a.clad"]);
    assert_eq!(converted.status, Some(0), "{converted}");
    let same = folder.ladder(&["diff", "a.L5X", "a.clad"]);
    assert_eq!(same.to_string(), "exit status 0\n");
    for old in ["a.L5X", "a.clad"] {
        let shown = folder.ladder(&["diff", old, "b.L5X"]);
        assert_eq!(shown.status, Some(1), "{shown}");
        let heading = match old {
            "a.clad" => {
                "edited, does another thing: routine Main of program P, rung 0 (was line 10), writes x\n"
            }
            _ => "edited, does another thing: routine Main of program P, rung 0, writes x\n",
        };
        assert!(shown.stdout.contains(heading), "{shown}");
        assert!(!shown.stdout.contains("gone: network"), "{shown}");
    }
}

/// A change is where the other system has it, also after what has another name was given the new one.
#[test]
fn places_are_called_as_the_other_system_calls_them() {
    let project = |key: &str, contact: &str| {
        let next = "]]></Text></Rung><Rung Number=\"1\" Type=\"N\"><Text><![CDATA[";
        let rungs = format!("XIC({key})OTE(x);{next}XIO({key})OTL(y);{next}{contact}(y)OTE(z);");
        logix(&rungs).replace("Name=\"a\"", &format!("Name=\"{key}\""))
    };
    let folder = Folder::with(&[
        ("a.L5X", &project("start", "XIC")),
        ("b.L5X", &project("begin", "XIO")),
        ("old/Fan.s7dcl", &simatic("Contact( #go )")),
        ("new/Fan.s7dcl", &simatic("I_Contact( #go )")),
    ]);
    expect![[r#"
        exit status 1
        -- stdout
        --- a.L5X
        +++ b.L5X
            1 edited, 10 the same, 1 renamed

        renamed: input start -> begin (3 places)

            ... 10 the same

        edited, does another thing: routine Main of program P, rung 2, writes z
            with y off, z goes off in the old and on in the new program
        - +--[ ]( y )--------------------------------------------------------( )( z )--+
             ^^^^^^^^
        + +--[/]( y )--------------------------------------------------------( )( z )--+
             ^^^^^^^^

        the programs differ in scan 0, at 0s
            z => -  (old)
            z => _  (new)
    "#]]
    .assert_eq(&folder.ladder(&["diff", "a.L5X", "b.L5X"]).to_string());
    expect![[r#"
        exit status 1
        -- stdout
        --- old/Fan.s7dcl
        +++ new/Fan.s7dcl
            1 edited, 4 the same

            ... 4 the same

        edited, does another thing: network 2 of Fan, writes lamp
            with go off, lamp goes off in the old and on in the new program
        - +--[ ]( go )----------------------------------------------------( )( lamp )--+
             ^^^^^^^^^
        + +--[/]( go )----------------------------------------------------( )( lamp )--+
             ^^^^^^^^^

        the programs differ in scan 0, at 0s
            lamp => _  (old)
            lamp => -  (new)
    "#]]
    .assert_eq(
        &folder
            .ladder(&["diff", "old/Fan.s7dcl", "new/Fan.s7dcl"])
            .to_string(),
    );
    let json = folder.ladder(&["diff", "a.L5X", "b.L5X", "--format", "json"]);
    let part = "\"part\": \"routine Main of program P, rung 2\"";
    assert!(json.stdout.contains(part), "{json}");
}

/// A block of SIMATIC with two networks.
fn simatic(contact: &str) -> String {
    let network = |element: &str, coil: &str| {
        format!(
            "{{ S7_Language := \"LAD\" }}\nNETWORK\n    RUNG wire#powerrail\n        {element}\n        Coil( #{coil} )\n    \
             END_RUNG\nEND_NETWORK\n"
        )
    };
    format!(
        "FUNCTION_BLOCK \"Fan\"\n    VAR_INPUT\n        go : Bool;\n    END_VAR\n    VAR_OUTPUT\n        run : Bool;\n        lamp : Bool;\n    \
         END_VAR\n{}{}END_FUNCTION_BLOCK\n",
        network("Contact( #go )", "run"),
        network(contact, "lamp")
    )
}

#[test]
fn nothing_of_a_program_is_a_command_to_the_terminal() {
    let hostile = MOTOR.replace("+--\\", "# \u{1b}[2J ``` #\n+--\\");
    let folder = Folder::with(&[("a.clad", MOTOR), ("b.clad", &hostile)]);
    for format in ["text", "markdown", "json"] {
        let shown = folder.ladder(&["diff", "a.clad", "b.clad", "--format", format]);
        assert_eq!(shown.status, Some(1));
        assert!(!shown.stdout.contains('\u{1b}'), "{shown}");
    }
    let shown = folder.ladder(&["diff", "a.clad", "b.clad", "--format", "markdown"]);
    assert!(shown.stdout.contains("\n````diff\n"), "{shown}");
}

/// A program and one whose networks are written in another way, one of them moved.
const SAFE: [&str; 2] = [
    "\
+--\\--[/]( guard )--\\----------------------------------------------( )( alarm )--+
|  /--[ ]( stop )---/                                                            |

+--[ ]( door )---------------------------------------------------( )( lamp )--+
",
    "\
+--[ ]( door )---------------------------------------------------( )( lamp )--+

+--[ ]( guard )--[/]( stop )---------------------------------------(/)( alarm )--+
",
];

/// Of two forms of a program one says how often it runs: that is the interval of both.
#[test]
fn a_program_and_what_is_made_of_it_do_the_same() {
    let motor = include_str!("../../../examples/motor.clad");
    let folder = Folder::with(&[("motor.clad", motor)]);
    for file in ["motor.xml", "motor.s7dcl"] {
        folder.ladder(&["convert", "motor.clad", "-o", file]);
        let told = folder.ladder(&["diff", "--same", "motor.clad", file]).to_string();
        assert_eq!(told, "exit status 0\n-- stdout\nthe same\n", "{file}");
    }
}

#[test]
fn programs_that_do_the_same() {
    let folder = Folder::with(&[
        ("old.clad", SAFE[0]),
        ("new.clad", SAFE[1]),
        ("other.clad", &SAFE[1].replace("[/]( stop )", "[ ]( stop )")),
        ("moved.clad", &SAFE[1].replace("( lamp )", "( guard )")),
        ("order.clad", &SAFE[0].replace("( lamp )", "( guard )")),
        ("more.clad", &format!("{}\n+--[ ]( a )--( )( b )--+\n", SAFE[0])),
        ("broken.clad", &SAFE[0].replace("( lamp )", "( 5 )")),
    ]);
    let told = |old: &str, new: &str| folder.ladder(&["diff", "--same", old, new]).to_string();
    let all = [
        told("old.clad", "new.clad"),
        told("old.clad", "other.clad"),
        told("order.clad", "moved.clad"),
        told("old.clad", "more.clad"),
        told("old.clad", "broken.clad"),
    ];
    expect![[r#"
        exit status 0
        -- stdout
        the same
        exit status 1
        -- stdout
        not the same
          other.clad: the programs differ in scan 0, at 0s
            guard    -
            alarm => _  (old)
            alarm => -  (new)
        exit status 1
        -- stdout
        not the same
          moved.clad: the programs differ in scan 0, at 0s
            door     -
            alarm => -  (old)
            alarm => _  (new)
        exit status 1
        -- stdout
        not the same
          more.clad: only the new program has the output b
        exit status 1
        -- stdout
        not decided
          broken.clad: the new program has errors
    "#]]
    .assert_eq(&all.concat());
    folder
        .ladder(&["diff", "--same", "old.clad", "none.clad"])
        .refused_with("none.clad: no such file or folder");
}

/// Two programs whose last networks differ in a state that never is.
const GATE: &str = "\
+--[ ]( open_it )--[/]( down )---------------------------------------( )( up )--+

+--[ ]( close_it )--[/]( up )--------------------------------------( )( down )--+

+--[ ]( up )------------------------------------------------( )( lamp )--+
";

#[test]
fn whole_programs_are_compared_by_their_runs() {
    let folder = Folder::with(&[
        ("gate.clad", GATE),
        (
            "careful.clad",
            &GATE.replace("[ ]( up )-", "[ ]( up )--[/]( down )-"),
        ),
        ("late.clad", &GATE.replace("[/]( up )", "[TON]( t, 30ms )")),
        ("seal.clad", &GATE.replace("( )( lamp )", "(S)( lamp )")),
    ]);
    let told = |new: &str| {
        let same = folder.ladder(&["diff", "--same", "gate.clad", new]).to_string();
        let shown = folder.ladder(&["diff", "gate.clad", new]).to_string();
        let last = shown.rsplit("\n\n").next().unwrap_or_default().to_owned();
        format!("{same}--\n{last}")
    };
    expect![[r#"
        exit status 0
        -- stdout
        the same
        --
        the programs do the same in every run
    "#]]
    .assert_eq(&told("careful.clad"));
    expect![[r#"
        exit status 1
        -- stdout
        not the same
          late.clad: the programs differ in scan 0, at 0s
            close_it    -
            down     => -  (old)
            down     => _  (new)
        --
        the programs differ in scan 0, at 0s
            close_it    -
            down     => -  (old)
            down     => _  (new)
    "#]]
    .assert_eq(&told("late.clad"));
    expect![[r#"
        exit status 1
        -- stdout
        not the same
          seal.clad: the programs differ in scan 1, at 10ms
            open_it    -_
            lamp    => -_  (old)
            lamp    => --  (new)
        --
        the programs differ in scan 1, at 10ms
            open_it    -_
            lamp    => -_  (old)
            lamp    => --  (new)
    "#]]
    .assert_eq(&told("seal.clad"));
    let shown = folder.ladder(&["diff", "gate.clad", "seal.clad", "--format", "json"]);
    let whole = shown.stdout.split("\"whole\"").nth(1).unwrap_or_default();
    expect![[r#"
        : {
              "meaning": "other",
              "reasons": [
                "the programs differ in scan 1, at 10ms"
              ],
              "scan": 1,
              "interval_ns": 10000000,
              "given": [
                {
                  "tag": "open_it",
                  "values": [
                    "TRUE",
                    "FALSE"
                  ]
                }
              ],
              "differs": [
                {
                  "tag": "lamp",
                  "old": [
                    "TRUE",
                    "FALSE"
                  ],
                  "new": [
                    "TRUE",
                    "TRUE"
                  ]
                }
              ],
              "scenario": "scenario \"the programs differ\"\nopen_it    -_\nlamp    => -_\n"
            }
          }
        ]
    "#]]
    .assert_eq(whole);
}

#[test]
fn every_form_says_what_an_edited_network_does() {
    let folder = Folder::with(&[("old.clad", MOTOR), ("new.clad", &edited())]);
    for format in ["text", "html", "markdown", "json"] {
        let run = folder
            .ladder(&["diff", "old.clad", "new.clad", "--format", format])
            .to_string();
        let run = run.replace('\\', "");
        assert!(
            run.contains("run goes on in the old and off in the new program"),
            "{run}"
        );
        assert!(
            run.contains("does another thing") || run.contains("\"meaning\": \"other\""),
            "{run}"
        );
    }
}

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

#[test]
fn the_run_that_shows_a_difference_is_a_scenario() {
    let folder = Folder::with(&[("a.clad", MOTOR), ("b.clad", &edited()), ("in/c.clad", MOTOR)]);
    let write = [
        "diff",
        "--same",
        "a.clad",
        "b.clad",
        "--write",
        "found.ladder-test",
    ];
    let told = folder.ladder(&write).to_string();
    assert!(told.contains("not the same"), "{told}");
    expect![[r#"
        program b.clad
        interval 10ms

        scenario "as the old program does it"
        start    -
        run   => -
    "#]]
    .assert_eq(&folder.read("found.ladder-test"));
    let test = folder.ladder(&["test", "found.ladder-test"]).to_string();
    assert!(test.contains("exit status 1"), "{test}");
    let again = folder.ladder(&write).to_string();
    assert!(again.contains("exit status 2"), "{again}");
    let elsewhere = folder.ladder(&[
        "diff",
        "--same",
        "a.clad",
        "b.clad",
        "--write",
        "in/found.ladder-test",
    ]);
    let elsewhere = elsewhere.to_string();
    assert!(
        elsewhere.contains("in the folder of one of the programs"),
        "{elsewhere}"
    );
    let nothing = folder.ladder(&[
        "diff",
        "--same",
        "a.clad",
        "in/c.clad",
        "--write",
        "none.ladder-test",
    ]);
    assert!(nothing.to_string().contains("nothing is written"), "{nothing}");
}
