//! `ladder render`

use crate::harness::{Folder, MOTOR};
use expect_test::expect;

#[test]
fn svg_goes_to_stdout_unless_a_file_is_named() {
    let folder = Folder::with(&[("motor.clad", MOTOR)]);
    let run = folder.ladder(&["render", "motor.clad"]);
    assert_eq!(run.status, Some(0));
    assert!(run.stdout.starts_with("<svg "), "{}", run.stdout);
    let into_file = folder.ladder(&["render", "motor.clad", "-o", "motor.svg"]);
    expect![[r#"
        exit status 0
    "#]]
    .assert_eq(&into_file.to_string());
    assert_eq!(folder.read("motor.svg"), run.stdout);
}

#[test]
fn png_is_made_of_pixels() {
    let folder = Folder::with(&[("motor.clad", MOTOR)]);
    let run = folder.ladder(&["render", "motor.clad", "-o", "motor.PNG", "--scale", "0.5"]);
    assert_eq!(run.status, Some(0), "{run}");
    let bytes = std::fs::read(folder.path("motor.PNG")).unwrap();
    assert!(bytes.starts_with(b"\x89PNG"));
}

#[test]
fn a_run_shows_power_and_values() {
    let folder = Folder::with(&[("motor.clad", MOTOR)]);
    let run = folder.ladder(&["render", "motor.clad", "--scans", "3", "--set", "start=1"]);
    assert!(run.stdout.contains(r#"class="live""#), "{run}");
    let at_rest = folder.ladder(&["render", "motor.clad"]);
    assert!(!at_rest.stdout.contains(r#"class="live""#));
}

#[test]
fn characters_at_rest_and_with_power() {
    let folder = Folder::with(&[("motor.clad", MOTOR)]);
    let rest = folder.ladder(&["render", "motor.clad", "--format", "text"]);
    expect![[r#"
        exit status 0
        -- stdout
        │     start     stop                                                    run   │
        ├──┬──┤   ├──┬──┤ / ├──────────────────────────────────────────────────(   )──┤
        │  │   run   │                                                                │
        │  └──┤   ├──┘                                                                │
    "#]]
    .assert_eq(&rest.to_string());
    let run = [
        "render",
        "motor.clad",
        "-o",
        "motor.txt",
        "--scans",
        "2",
        "--set",
        "start=1",
    ];
    assert_eq!(folder.ladder(&run).status, Some(0));
    expect![[r#"
        │     start     stop                                                    run   │
        ┝━━┳━━┥━━━┝━━┳━━┥━/━┝━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━━(━━━)━━┥
        │  ┃   run   ┃                                                                │
        │  ┗━━┥━━━┝━━┛                                                                │

        # drawn by ladder #
    "#]]
    .assert_eq(&folder.read("motor.txt"));
    // It is known for what it is.
    assert_eq!(folder.ladder(&run).status, Some(0));
    let forced = [
        "render",
        "motor.clad",
        "--format",
        "text",
        "--scans",
        "2",
        "--force",
        "stop=1",
    ];
    let forced = folder.ladder(&forced);
    assert!(forced.stdout.contains("stop!"), "{forced}");
}

#[test]
fn characters_of_ascii() {
    let folder = Folder::with(&[("motor.clad", MOTOR)]);
    let drawn = |more: &[&str]| {
        let arguments = ["render", "motor.clad", "--format", "text", "--style", "ascii"];
        folder.ladder(&[&arguments, more].concat())
    };
    expect![[r#"
        exit status 0
        -- stdout
        |     start     stop                                                    run   |
        +--+--|   |--+--| / |--------------------------------------------------(   )--+
        |  |   run   |                                                                |
        |  +--|   |--+                                                                |
    "#]]
    .assert_eq(&drawn(&[]).to_string());
    expect![[r#"
        exit status 0
        -- stdout
        |     start     stop                                                    run   |
        +==+==|===|==+==|=/=|==================================================(===)==+
        |  |   run   |                                                                |
        |  +==|===|==+                                                                |
    "#]]
    .assert_eq(&drawn(&["--scans", "2", "--set", "start=1"]).to_string());
    let unicode = folder.ladder(&["render", "motor.clad", "--format", "text", "--style", "unicode"]);
    let plain = folder.ladder(&["render", "motor.clad", "--format", "text"]);
    assert_eq!(unicode.stdout, plain.stdout);
    expect![[r#"
        exit status 2
        -- stderr
        error: --style is about a drawing with characters; add --format text, or end the file's name in .txt
    "#]]
    .assert_eq(
        &folder
            .ladder(&["render", "motor.clad", "--style", "ascii"])
            .to_string(),
    );
}

/// The texts of a picture.
fn texts(picture: &str) -> Vec<&str> {
    let texts = picture.lines().filter(|line| line.starts_with("<text"));
    texts
        .filter_map(|line| line.strip_suffix("</text>")?.rsplit('>').next())
        .collect()
}

#[test]
fn a_run_shows_the_values_of_every_type() {
    let program = "+--[ ]( a )--[/]( b )--[TON]( t, T#5s, R := b )--( )( y )--+\n\
                   +--[ADD]( n, n, 1 )--[GT]( n, 2 )--[ ]( t.Q )--[ ]( bits[1..2] )--+\n";
    let program =
        format!("VAR a, b, y : BOOL; t : TON; n : INT; bits : ARRAY[1..2] OF BOOL; END_VAR\n{program}");
    let folder = Folder::with(&[("values.clad", &program)]);
    let run = folder.ladder(&["render", "values.clad", "--scans", "3", "--set", "a=1"]);
    assert_eq!(run.status, Some(0), "{run}");
    expect![[r#"
        a
        = 1
        b
        = 0
        t
        = T#20ms
        TON
        IN
        Q
        PT
        T#5s
        R
        b
        = 0
        y
        = 0
        ADD
        EN
        ENO
        y ←
        n
        = 3
        a
        n
        = 3
        b
        1
        &gt;
        n
        = 3
        2
        t.Q
        = 0
        bits[1..2]"#]]
    .assert_eq(&texts(&run.stdout).join("\n"));
}

#[test]
fn a_fault_that_stops_the_run_is_a_finding() {
    let endless = "+--<LBL>( again )--[ ]( a )--( )( y )--+\n+--<JMP>( again )--+\n";
    let folder = Folder::with(&[("endless.clad", endless)]);
    let run = folder.ladder(&["render", "endless.clad", "--scans", "3", "-o", "endless.svg"]);
    assert_eq!(run.status, Some(1), "{run}");
    assert!(run.stderr.contains("fault in scan 0"), "{run}");
    assert!(folder.read("endless.svg").starts_with("<svg "));
}

#[test]
fn what_cannot_be_done_is_said_and_nothing_is_written() {
    let folder = Folder::with(&[("motor.clad", MOTOR), ("there/x", "")]);
    let told = |arguments: &[&str]| {
        let run = folder.ladder(&[&["render"], arguments].concat());
        assert_eq!((run.status, run.stdout.as_str()), (Some(2), ""), "{run}");
        format!("{}\n", run.stderr.trim_end())
    };
    let all = [
        told(&["missing.clad"]),
        told(&["there"]),
        told(&["motor.clad", "-o", "there", "--format", "svg"]),
        told(&["motor.clad", "-o", "motor"]),
        told(&["motor.clad", "-o", "motor.svg", "--scale", "3"]),
        told(&["motor.clad", "-o", "motor.svg", "--paper", "a4"]),
        told(&["motor.clad", "-o", "motor.png", "--landscape"]),
        told(&["motor.clad", "-o", "motor.pdf", "--scale", "3"]),
        told(&["motor.clad", "--set", "start=1"]),
        told(&["motor.clad", "--scans", "1", "--set", "begin=1"]),
        told(&["motor.clad", "--scans", "1", "--set", "start=maybe"]),
        told(&["motor.clad", "--scans", "1", "--inputs", "missing.csv"]),
    ];
    expect![[r#"
        error: missing.clad: no such file or folder
        error: there: this is a folder; name a file in it
        error: there: this is a folder; name a file in it
        error: motor: the name does not say which picture it is; end it in .svg, .png, .pdf or .txt, or add --format
        error: --scale is about the pixels of a PNG; other pictures are as large as they are shown
        error: --paper, --landscape and --title are about the pages of a PDF; end the file's name in .pdf
        error: --paper, --landscape and --title are about the pages of a PDF; end the file's name in .pdf
        error: --scale is about the pixels of a PNG; other pictures are as large as they are shown
        error: --dt, --inputs, --set and --force are about a run; add the number of scans, for example --scans 1
        error: --set begin=1: there is no tag `begin` in this program
        error: --set start=maybe: `maybe` is not a value for a BOOL: write 0, 1, TRUE or FALSE
        error: missing.csv: no such file or folder
    "#]]
    .assert_eq(&all.concat());
    let nowhere = told(&["motor.clad", "-o", "missing/motor.svg"]);
    assert!(
        nowhere.starts_with("error: missing/motor.svg: cannot be written"),
        "{nowhere}"
    );
}

#[test]
fn a_name_that_says_no_kind_of_picture() {
    let folder = Folder::with(&[("motor.clad", MOTOR)]);
    expect![[r#"
        exit status 2
        -- stderr
        error: motor.jpg: the name does not say which picture it is; end it in .svg, .png, .pdf or .txt, or add --format
    "#]]
    .assert_eq(
        &folder
            .ladder(&["render", "motor.clad", "-o", "motor.jpg"])
            .to_string(),
    );
}

#[test]
fn a_program_with_errors_is_drawn_but_not_run() {
    let folder = Folder::with(&[("wrong.clad", "+--[ ]( a --( )( b )--+\n")]);
    let drawn = folder.ladder(&["render", "wrong.clad"]);
    assert_eq!(drawn.status, Some(1));
    assert!(drawn.stdout.contains("+--[ ]( a --( )( b )--+"), "{drawn}");
    assert!(drawn.stderr.contains("error[unclosed-block]"), "{drawn}");
    assert!(
        drawn
            .stderr
            .ends_with("error: wrong.clad: drawn as far as it goes; the program has errors\n"),
        "{drawn}"
    );
    let run = folder.ladder(&["render", "wrong.clad", "--scans", "1"]);
    assert_eq!(run.status, Some(1), "{run}");
    assert!(run.stdout.is_empty());
}

#[test]
fn a_picture_that_no_machine_could_hold_is_refused() {
    let text = "+--[ ]( a )--( )( b )--+\n\n".repeat(1000);
    let folder = Folder::with(&[("long.clad", &text)]);
    let run = folder.ladder(&["render", "long.clad", "-o", "long.png"]);
    assert_eq!(run.status, Some(2), "{run}");
    assert!(run.stderr.contains("make it smaller with --scale"), "{run}");
}
