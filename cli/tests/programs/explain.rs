//! `ladder explain`

use crate::harness::Folder;
use expect_test::expect;

#[test]
fn the_page_of_an_instruction() {
    let folder = Folder::with(&[]);
    expect![[r#"
        exit status 0
        -- stdout
        [SEL]( y, g, a, b )  Select one of two

        Puts one of two values into y: a while g is low, b while g is high.

        Any elementary type will do; both values are brought to y's type. IEC 61131-3: SEL.

        Operands
          y  out     The result.
          g  in      The switch: low takes a, high takes b.
          a  in      The value while g is low.
          b  in      The value while g is high.

        Power out
          EN, low on a fault

        Acts
          only while power enters it

        In other profiles
          ldmicro  The system has no such instruction.
          iot      The system has no such instruction.

        Example
          VAR_INPUT
              fast : BOOL;
          END_VAR
          VAR_OUTPUT
              speed : INT;
          END_VAR

          +------------------------------------------------[SEL]( speed, fast, 10, 50 )--+
    "#]]
    .assert_eq(&folder.ladder(&["explain", "[SEL]"]).to_string());
}

#[test]
fn brackets_are_understood_and_told_apart() {
    let folder = Folder::with(&[]);
    let first_line = |name: &str| {
        let run = folder.ladder(&["explain", name]);
        run.stdout.lines().next().unwrap_or_default().to_owned()
    };
    expect![[r#"
        [TON]( t, PT, R := )  On-delay timer
        (S)( tag )  Set coil
        [ ]( tag )  Open contact
        ( )( tag )  Coil
        <JMP>( name )  Jump
        [EQ]( a, b, ... )  Equal"#]]
    .assert_eq(
        &["ton", "( S )", "[ ]", "()", "<jmp>( name )", "EQU"]
            .map(first_line)
            .join("\n"),
    );
}

#[test]
fn every_row_with_the_name_is_shown() {
    let run = Folder::with(&[]).ladder(&["explain", "NOT"]);
    assert!(
        run.stdout.contains("Inverter") && run.stdout.contains("Bitwise not"),
        "{run}"
    );
}

#[test]
fn the_page_of_a_rule() {
    let folder = Folder::with(&[]);
    let page = folder.ladder(&["explain", "double-coil"]).to_string();
    assert!(
        page.starts_with("exit status 0\n-- stdout\ndouble-coil\n\nA tag is written"),
        "{page}"
    );
    for heading in ["Wrong", "Right", "What to do"] {
        assert!(page.contains(&format!("\n\n{heading}\n\n")), "{page}");
    }
    assert_eq!(folder.ladder(&["explain", "Double_Coil"]).to_string(), page);
}

#[test]
fn an_unknown_name_is_refused_with_what_was_meant() {
    let folder = Folder::with(&[]);
    let explain = |name: &str| folder.ladder(&["explain", name]);
    explain("TOM")
        .refused_with("no rule or instruction is called `TOM`; did you mean `[TON]` (on-delay timer)?");
    explain("XIC").refused_with("no rule or instruction is called `XIC`; did you mean `[ ]` (open contact)?");
    explain("duoble-coil")
        .refused_with("no rule or instruction is called `duoble-coil`; did you mean `double-coil`?");
    explain("blubber").refused_with("no rule or instruction is called `blubber`; `ladder explain` lists all");
    explain("").refused_with("no rule or instruction is called ``; `ladder explain` lists all");
}

#[test]
fn a_word_leads_to_what_it_stands_for() {
    let folder = Folder::with(&[]);
    let explain = |name: &str| folder.ladder(&["explain", name]).stderr;
    expect![[r#"
        error: no rule or instruction is called `timer`; did you mean `[TON]` (on-delay timer), `[TOF]` (off-delay timer), `[TP]` (pulse timer), `[RTO]` (retentive on-delay timer), `[RTOF]` (retentive off-delay timer) or `(RES)` (reset timer or counter)?
        error: no rule or instruction is called `coil`; did you mean `( )` (coil), `(/)` (negated coil), `(S)` (set coil), `(R)` (reset coil), `(P)` (rising-edge coil) or `(N)` (falling-edge coil)?
        error: no rule or instruction is called `contact`; did you mean `[ ]` (open contact), `[/]` (closed contact), `[P]` (rising-edge contact), `[N]` (falling-edge contact) or `contact-after-coil`?
        error: no rule or instruction is called `counter`; did you mean `[CTU]` (up counter), `[CTD]` (down counter), `[CTUD]` (up-down counter), `[CTC]` (circular counter), `(RES)` (reset timer or counter) or `duplicate-counter`?
        error: no rule or instruction is called `Latched`; did you mean `latched-power`?
        error: no rule or instruction is called `edge`; did you mean `[P]` (rising-edge contact), `[N]` (falling-edge contact), `(P)` (rising-edge coil), `(N)` (falling-edge coil) or `edge-of-varying-index`?
    "#]].assert_eq(
        &["timer", "coil", "contact", "counter", "Latched", "edge"]
            .map(explain)
            .concat(),
    );
}

#[test]
fn without_a_name_all_are_listed() {
    let folder = Folder::with(&[]);
    let run = folder.ladder(&["explain"]);
    assert_eq!((run.status, run.stderr.as_str()), (Some(0), ""));
    for rule in ladder_analysis::rules::ALL {
        assert!(
            run.stdout.contains(&format!("\n  {rule} ")),
            "{rule} is not listed"
        );
    }
    for row in ladder_instructions::TABLE {
        assert!(
            run.stdout.contains(&format!("\n  {} ", row.block())),
            "{} is not listed",
            row.block()
        );
    }
    expect_test::expect_file!["explain_list.txt"].assert_eq(&run.stdout);
}

/// The widest line of a page on a terminal of this many columns, but for drawings.
fn widest(arguments: &[&str], columns: &str) -> usize {
    let run = Folder::with(&[]).run(
        env!("CARGO_BIN_EXE_ladder"),
        arguments,
        b"",
        &[("COLUMNS", columns)],
    );
    let (text, _) = run.stdout.split_once("\nExample\n").unwrap_or((&run.stdout, ""));
    let filled = text.lines().filter(|line| !line.starts_with("    "));
    filled.map(|line| line.chars().count()).max().unwrap_or(0)
}

#[test]
fn pages_are_as_wide_as_the_terminal() {
    for page in [
        &["explain"][..],
        &["explain", "double-coil"],
        &["explain", "CTU"],
        &["explain", "PID"],
    ] {
        for columns in [60, 80, 100] {
            let widest = widest(page, &columns.to_string());
            assert!(widest <= columns, "{page:?}: {widest} of {columns} columns");
        }
    }
    // Wider lines are hard to read.
    assert!(widest(&["explain", "double-coil"], "200") <= 100);
}

#[test]
fn a_block_of_a_program() {
    const ALARM: &str = "FUNCTION_BLOCK [$Alarm]\nVAR_INPUT  high : BOOL;  wait : TIME := T#5s;  END_VAR\n\
        VAR_OUTPUT  lamp : BOOL;  END_VAR\n+--[ ]( high )--( )( lamp )--+\nEND_FUNCTION_BLOCK\n";
    let folder = Folder::with(&[
        ("ladder.toml", ""),
        ("lib/alarms.clad", ALARM),
        ("plant.clad", "+--[$Alarm]( a, 2s, y )--+\n"),
    ]);
    let explain = |arguments: &[&str]| folder.ladder(&[&["explain"], arguments].concat()).to_string();
    expect![[r#"
        exit status 0
        -- stdout
            [$Alarm]( high, wait, lamp )
        User-defined block in `lib/alarms.clad`

        - `high`: BOOL, input
        - `wait`: TIME, input, may be left out
        - `lamp`: BOOL, output
    "#]]
    .assert_eq(&explain(&["[$alarm]"]));
    assert_eq!(explain(&["$Alarm", "plant.clad"]), explain(&["$Alarm"]));
    expect![[r#"
        exit status 2
        -- stderr
        error: no block is called `$Alram` in this folder; did you mean `$Alarm`?
    "#]]
    .assert_eq(&explain(&["$Alram"]));
    expect![[r#"
        exit status 2
        -- stderr
        error: no block is called `$Other` in plant.clad
    "#]]
    .assert_eq(&explain(&["$Other", "plant.clad"]));
    expect![[r#"
        exit status 2
        -- stderr
        error: a program is only asked for a block, whose name begins with `$`; `TON` is the same in all
    "#]]
    .assert_eq(&explain(&["TON", "plant.clad"]));
    expect![[r#"
        exit status 2
        -- stderr
        error: none.clad: no such file or folder
    "#]]
    .assert_eq(&explain(&["$Alarm", "none.clad"]));
}

#[test]
fn a_block_is_found_without_its_sign() {
    let folder = Folder::with(&[]);
    let page = |name: &str| folder.ladder(&["explain", name]).to_string();
    assert_eq!(page("PID"), page("$PID"));
    assert_eq!(page("debounce"), page("$Debounce"));
}
