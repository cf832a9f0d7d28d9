//! Programs of other systems that are at hand: of the tests, of the field, drawn with characters.

use crate::foreign::{DRAFT, FAULTY};
use crate::harness::Folder;
use expect_test::expect;
use std::path::{Path, PathBuf};

/// Whatever is in the programs of other systems, the commands say what they can and end.
#[test]
fn every_foreign_program_that_is_at_hand() {
    let own = Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/corpus");
    let more = std::env::var_os("LADDER_CORPUS").map(PathBuf::from);
    if more.is_none() {
        eprintln!("LADDER_CORPUS names no folder: the programs of other people are not checked");
    }
    let folder = Folder::with(&[]);
    let mut files = Vec::new();
    for corpus in std::iter::once(own).chain(more) {
        for below in ["ldmicro/elements", "ldmicro/programs"] {
            let Ok(entries) = std::fs::read_dir(corpus.join(below)) else {
                continue;
            };
            let paths = entries.map(|entry| entry.unwrap().path());
            files.extend(paths.filter(|path| path.extension().is_some_and(|ending| ending == "ld")));
        }
        for list in ["textbook/constructed-examples.txt", "textbook/examples.txt"] {
            files.extend(Some(corpus.join(list)).filter(|list| list.exists()));
        }
        // This one has many programs, each with its title.
        let many = std::fs::read_to_string(corpus.join("iot/element-programs.txt")).unwrap_or_default();
        for (number, program) in many.split("\n=").enumerate() {
            let name = format!("{number}.iot");
            folder.write(
                &name,
                format!("={}\n", program.trim_start_matches('=')).as_bytes(),
            );
            files.push(folder.path(&name));
        }
    }
    folder.write("lamp.cplc", DRAFT.as_bytes());
    folder.write("share.cplc", FAULTY.as_bytes());
    files.extend([folder.path("lamp.cplc"), folder.path("share.cplc")]);
    assert!(files.len() > 20, "{files:?}");
    let mut problems = Vec::new();
    for file in &files {
        let file = file.to_str().unwrap();
        for arguments in [
            &["check", file][..],
            &["render", file, "-o", "out.svg"],
            &["sim", file, "--scans", "3"],
        ] {
            let run = folder.ladder(arguments);
            if !matches!(run.status, Some(0 | 1)) || run.stderr.contains("panicked") {
                problems.push(format!("{arguments:?}\n{run}"));
            }
        }
    }
    assert!(problems.is_empty(), "{}", problems.join("\n"));
}

/// Programs that people have, as they are.
#[test]
fn programs_from_the_field_run() {
    let field = Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/corpus/field");
    let folder = Folder::with(&[]);
    for (file, set, coil, row) in [
        ("ld_bare_header/input.ld", "Xgo=1", "Yfan", "0,0,1\n"),
        (
            "ld_named_piecewise/input.ld",
            "PORT.ADC[3]=100",
            "deg",
            "0,0,50\n",
        ),
        ("iot_reset_int.iot", "I01=1", "MI01", "0,0,0\n"),
        ("paper_multiline.rung", "I0=1", "Q0", "0,0,0\n"),
        ("paper_or.rung", "I0=1", "Q0", "0,0,1\n"),
    ] {
        let file = field.join(file);
        let file = file.to_str().unwrap();
        let run = folder.ladder(&["sim", file, "--scans", "1", "--set", set, "--watch", coil]);
        assert_eq!((run.status, run.stderr.as_str()), (Some(0), ""), "{file}");
        assert_eq!(run.stdout, format!("scan,time_ms,{coil}\n{row}"), "{file}");
    }
}

/// As people post it.
const DRAWING: &str = "\
Rung 1: seal-in
   start      stop       run
 |--] [---+---]/[--------( )--|  main drive
 |  run   |                   |
 |--] [---+                   |

            ?
 |--] [---{PID}----------(S)--|
";

#[test]
fn a_drawing_in_characters() {
    let folder = Folder::with(&[("forum.txt", DRAWING), ("pasted.clad", DRAWING)]);
    expect![[r#"
        exit status 1
        -- stdout
        # Rung 1: seal-in #
        # main drive #
        +--[ ]( start )--\--[/]( stop )------------------------------------( )( run )--+
        +--[ ]( run )----/                                                             |

        # ? #
        # |--] [---{PID}----------(S)--| #
        -- stderr
        forum.txt:8:5: refused: ] [: no name is above this contact or inside it
        forum.txt:8:10: refused: |--] [---{PID}----------(S)--|: the wire ends here, and no line leads on from it
        forum.txt:8:11: refused: |--] [---{PID}----------(S)--|: `{PID}` is in the wire: a name belongs above its contact, or inside it
        forum.txt:8:16: refused: |--] [---{PID}----------(S)--|: no wire leads here from the left, and no line from above or below
        forum.txt:8:26: refused: (S): no name is above this coil, and `S` inside tells only its kind
        forum.txt: 4 translated, 0 approximated, 5 refused
    "#]].assert_eq(&folder.ladder(&["convert", "forum.txt"]).to_string());
    expect![[r#"
        exit status 1
        -- stdout
        error[ascii-unread]: `] [` stays as a comment: no name is above this contact or inside it
         --> forum.txt:8:5
          |
        8 |  |--] [---{PID}----------(S)--|
          |     ^^^

        error[ascii-unread]: `|--] [---{PID}----------(S)--|` stays as a comment: the wire ends here, and no line leads on from it
         --> forum.txt:8:10
          |
        8 |  |--] [---{PID}----------(S)--|
          |          ^

        error[ascii-unread]: `|--] [---{PID}----------(S)--|` stays as a comment: `{PID}` is in the wire: a name belongs above its contact, or inside it
         --> forum.txt:8:11
          |
        8 |  |--] [---{PID}----------(S)--|
          |           ^

        error[ascii-unread]: `|--] [---{PID}----------(S)--|` stays as a comment: no wire leads here from the left, and no line from above or below
         --> forum.txt:8:16
          |
        8 |  |--] [---{PID}----------(S)--|
          |                ^^^^^^^^^^

        error[ascii-unread]: `(S)` stays as a comment: no name is above this coil, and `S` inside tells only its kind
         --> forum.txt:8:26
          |
        8 |  |--] [---{PID}----------(S)--|
          |                          ^^^

        Checked 1 file: 5 errors.
    "#]].assert_eq(&folder.ladder(&["check", "forum.txt"]).to_string());
    expect![[r#"
        exit status 1
        -- stdout
        error[unexpected-character]: this looks like a ladder diagram that is drawn with characters
         --> pasted.clad:1:1
          |
        1 | / Rung 1: seal-in
        2 | |    start      stop       run
        3 | |  |--] [---+---]/[--------( )--|  main drive
        4 | |  |  run   |                   |
        ... |
        7 | |             ?
        8 | |  |--] [---{PID}----------(S)--|
          | |_____---__---------------------^
          |       |    ||    |         |
          |       |    ||    |         this cannot be read: no name is above this coil, and `S` inside tells only its kind
          |       |    ||    this cannot be read: no wire leads here from the left, and no line from above or below
          |       |    |this cannot be read: `{PID}` is in the wire: a name belongs above its contact, or inside it
          |       |    this cannot be read: the wire ends here, and no line leads on from it
          |       this cannot be read: no name is above this contact or inside it
          |
          = help: convert it with `ladder convert --from ascii`: what cannot be read stays as a comment

        Checked 1 file: 1 error.
    "#]].assert_eq(&folder.ladder(&["check", "pasted.clad"]).to_string());
    // Only what is read whole is drawn.
    let (whole, _) = DRAWING.split_once("\n\n").expect("there are two rungs");
    let folder = Folder::with(&[("pasted.clad", whole)]);
    expect![[r#"
        exit status 1
        -- stdout
        error[unexpected-character]: this looks like a ladder diagram that is drawn with characters
         --> pasted.clad:1:1
          |
        1 | / Rung 1: seal-in
        2 | |    start      stop       run
        3 | |  |--] [---+---]/[--------( )--|  main drive
        4 | |  |  run   |                   |
        5 | |  |--] [---+                   |
          | |_______________________________^
          |
          = help: convert it with `ladder convert --from ascii`, or draw these lines as ladder text with the fix
        help: Draw it with - + | \ / and blocks
          |
        1 + # Rung 1: seal-in #
        2 + # main drive #
        3 + +--[ ]( start )--\--[/]( stop )------------------------------------( )( run )--+
        4 + +--[ ]( run )----/                                                             |
          |

        Checked 1 file: 1 error.
    "#]].assert_eq(&folder.ladder(&["check", "--fix", "pasted.clad"]).to_string());
    folder.ladder(&["check", "--fix", "--unsafe-fixes", "pasted.clad"]);
    expect![[r#"
        # Rung 1: seal-in #
        # main drive #
        +--[ ]( start )--\--[/]( stop )------------------------------------( )( run )--+
        +--[ ]( run )----/                                                             |"#]]
    .assert_eq(&folder.read("pasted.clad"));
}
