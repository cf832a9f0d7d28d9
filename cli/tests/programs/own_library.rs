//! `[workspace] library`: folders of blocks that a workspace names.

use crate::harness::Folder;
use expect_test::expect;

const HOLD: &str = "\
# Holds what was: as long as power is there. #
FUNCTION_BLOCK [$Hold]
VAR_INPUT
    a : BOOL;
END_VAR
VAR_OUTPUT
    q : BOOL;
END_VAR
+--[ ]( a )--(S)( q )--( )( ENO )--+
END_FUNCTION_BLOCK

+--[ ]( nowhere )--[TON]( 5s )--( )( Q1 )--+
";

const MAIN: &str = "\
VAR_INPUT
    go : BOOL;
END_VAR
VAR_OUTPUT
    held : BOOL;
END_VAR
+--[$Hold]( go, held )--+
";

/// A repository in the repository: it is a workspace of its own, and `.gitignore` passes over it.
fn plant(settings: &str) -> Folder {
    Folder::with(&[
        ("plant/ladder.toml", settings),
        ("plant/.gitignore", "shared/\n"),
        ("plant/main.clad", MAIN),
        ("plant/shared/blocks/ladder.toml", ""),
        (
            "plant/shared/blocks/hold.clad",
            &HOLD.replace("[TON]( 5s )--", ""),
        ),
        ("plant/shared/blocks/other/ladder.toml", ""),
        (
            "plant/shared/blocks/other/no.clad",
            "FUNCTION_BLOCK [$No]\nEND_FUNCTION_BLOCK\n",
        ),
        ("blocks/hold.clad", HOLD),
    ])
}

const LIBRARY: &str = "[workspace]\nlibrary = [\"shared/blocks\"]\n";

#[test]
fn its_blocks_are_there_in_every_program() {
    let check = |settings: &str| plant(settings).ladder(&["check", "plant/main.clad"]).to_string();
    expect![[r#"
        exit status 1
        -- stdout
        error[unknown-block]: there is no block [$Hold]
         --> plant/main.clad:7:4
          |
        7 | +--[$Hold]( go, held )--+
          |    ^^^^^^^
          |
          = help: define it: FUNCTION_BLOCK [$Hold], its declarations and rungs, END_FUNCTION_BLOCK

        Checked 1 file: 1 error.
    "#]]
    .assert_eq(&check(""));
    expect![[r#"
        exit status 0
        -- stdout
        Checked 1 file: no errors found.
    "#]]
    .assert_eq(&check(LIBRARY));
    let folder = plant(LIBRARY);
    let sim = ["sim", "plant/main.clad", "--scans", "2", "--set", "go=1"];
    expect![[r#"
        exit status 0
        -- stdout
        scan,time_ms,go,held
        0,0,1,1
        1,10,1,1
    "#]]
    .assert_eq(&folder.ladder(&sim).to_string());
    expect![[r#"
        exit status 0
        -- stdout
            [$Hold]( a, q )
        User-defined block in `plant/shared/blocks/hold.clad`

        - `a`: BOOL, input
        - `q`: BOOL, output
    "#]]
    .assert_eq(
        &folder
            .ladder(&["explain", "$Hold", "plant/main.clad"])
            .to_string(),
    );
}

/// It is what others use that must be right, and not the rest of its file; that is reported where the file itself is checked.
#[test]
fn what_is_wrong_in_it_is_said_where_it_is_checked() {
    let folder = Folder::with(&[
        ("ladder.toml", "[workspace]\nlibrary = [\"blocks\"]\n"),
        ("main.clad", MAIN),
        ("blocks/hold.clad", HOLD),
        (
            "blocks/toggle.clad",
            "FUNCTION_BLOCK [$Toggle]\n+--[ ]( EN )--( )( ENO )--+\nEND_FUNCTION_BLOCK\n",
        ),
    ]);
    expect![[r#"
        exit status 0
        -- stdout
        Checked 1 file: no errors found.
    "#]]
    .assert_eq(&folder.ladder(&["check", "main.clad"]).to_string());
    expect![[r#"
        exit status 1
        -- stdout
        blocks/hold.clad:9:24: warning[latched-power] ( )( ENO ) is after (S): its power is `q`, and stays on when the rung before goes off
        blocks/hold.clad:12:20: error[bad-arity] [TON] takes 2 operands, 1 is given
        blocks/toggle.clad:1:16: info[library-name] the library has a block $Toggle too: programs of this workspace are given this one
        Checked 2 files: 1 error, 1 warning, 1 info.
    "#]].assert_eq(
        &folder
            .ladder(&["check", "blocks", "--format", "concise"])
            .to_string(),
    );
}

#[test]
fn it_lies_inside_of_the_workspace() {
    let mut shown = String::new();
    for library in [
        "../blocks",
        "/etc",
        "shared/../../blocks",
        ".",
        ".git/modules",
        "none",
        "main.clad",
        "link",
        "inner",
    ] {
        let folder = plant(&format!("[workspace]\nlibrary = [\"{library}\"]\n"));
        #[cfg(unix)]
        {
            std::os::unix::fs::symlink("../blocks", folder.path("plant/link")).unwrap();
            std::os::unix::fs::symlink("shared/blocks", folder.path("plant/inner")).unwrap();
        }
        let told = folder
            .ladder(&["check", "plant/main.clad", "--format", "concise"])
            .to_string();
        shown.push_str(&format!("{library}: {told}"));
    }
    expect![[r#"
        ../blocks: exit status 2
        -- stderr
        error[bad-setting]: `../blocks` cannot be used: this leads out of the workspace, the folder of ladder.toml (without one: the file's own folder); an empty ladder.toml in a folder above both makes them one
         --> plant/ladder.toml:2:12
          |
        2 | library = ["../blocks"]
          |            ^^^^^^^^^^^
        /etc: exit status 2
        -- stderr
        error[bad-setting]: `/etc` cannot be used: a path in a workspace is relative: write it as it is seen from the file that names it
         --> plant/ladder.toml:2:12
          |
        2 | library = ["/etc"]
          |            ^^^^^^
        shared/../../blocks: exit status 2
        -- stderr
        error[bad-setting]: `shared/../../blocks` cannot be used: this leads out of the workspace, the folder of ladder.toml (without one: the file's own folder); an empty ladder.toml in a folder above both makes them one
         --> plant/ladder.toml:2:12
          |
        2 | library = ["shared/../../blocks"]
          |            ^^^^^^^^^^^^^^^^^^^^^
        .: exit status 2
        -- stderr
        error[bad-setting]: `.` cannot be used: name a folder in the workspace, whose own programs are seen anyway
         --> plant/ladder.toml:2:12
          |
        2 | library = ["."]
          |            ^^^
        .git/modules: exit status 2
        -- stderr
        error[bad-setting]: `.git/modules` cannot be used: this leads out of the workspace, the folder of ladder.toml (without one: the file's own folder); an empty ladder.toml in a folder above both makes them one
         --> plant/ladder.toml:2:12
          |
        2 | library = [".git/modules"]
          |            ^^^^^^^^^^^^^^
        none: exit status 2
        -- stderr
        error[bad-setting]: `none` cannot be used: no such file or folder
         --> plant/ladder.toml:2:12
          |
        2 | library = ["none"]
          |            ^^^^^^
        main.clad: exit status 2
        -- stderr
        error[bad-setting]: `main.clad` cannot be used: this is a file, and a folder is expected here
         --> plant/ladder.toml:2:12
          |
        2 | library = ["main.clad"]
          |            ^^^^^^^^^^^
        link: exit status 2
        -- stderr
        error[bad-setting]: `link` cannot be used: this leads out of the workspace, the folder of ladder.toml (without one: the file's own folder); an empty ladder.toml in a folder above both makes them one
         --> plant/ladder.toml:2:12
          |
        2 | library = ["link"]
          |            ^^^^^^
        inner: exit status 2
        -- stderr
        error[bad-setting]: `inner` cannot be used: a link leads to it: name the folder itself
         --> plant/ladder.toml:2:12
          |
        2 | library = ["inner"]
          |            ^^^^^^^
    "#]].assert_eq(&shown);
}
