//! What a program does otherwise: compared by runs.

use super::edited;
use crate::harness::{Folder, MOTOR};
use expect_test::expect;

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
