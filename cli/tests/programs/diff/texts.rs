//! Files and folders of ladder text, and the forms of the answer.

use super::edited;
use crate::harness::{CROOKED, Folder, MOTOR};
use expect_test::expect;

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
