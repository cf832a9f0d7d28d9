//! Every feature, asked at every kind of name that declared types bring: the table shows where one says nothing.

use crate::fixture::Fixture;
use crate::{
    callers_at, definition, folds, highlights, hover, implementation, inlays, prepare_rename, references,
    selections, semantic_tokens, type_definition, workspace_symbols,
};
use expect_test::{Expect, expect};
use ladder_syntax::{TextRange, TextSize};
use std::fmt::Write;

const PLANT: &str = "\
%% main.clad
TYPE
    Phase : (IDLE, FILLING);
    Valve : STRUCT
        open : BOOL;
        wait : TON;
    END_STRUCT;
    Cell : STRUCT
        valve : Valve;
        drive : $Motor;
    END_STRUCT;
END_TYPE

FUNCTION_BLOCK [$Motor]
VAR_INPUT
    start : BOOL;
END_VAR
VAR_OUTPUT
    running : BOOL;
END_VAR
+--[ ]( start )--( )( running )--( )( ENO )--+
END_FUNCTION_BLOCK

VAR
    cell : ARRAY[1..4] OF Cell;
    m1   : $Motor;
    step : Phase := FILLING;
    v    : Valve := (open := TRUE);
    k    : INT;
END_VAR

+--[EQ]( step, IDLE )--[MOV]( step, Phase.FILLING )--( )( cell[k + 1].valve.open )--+
+--[ ]( v.open )--[$Motor]( m1, a )--( )( y )--+
+--[ ]( m1.running )--[$Motor]( cell[2].drive, a, b )--( )( x )--+
+--[ ]( cell[2].drive.running )--[TON]( cell[1].valve.wait, 5s )--( )( z )--+
%% line.ladder-test
program main.clad
scenario \"all\"
cell[2].valve.open => _-
step               => IDLE FILLING
m1.running         => __
";

/// A name of each kind: a part of the text whose marked character is asked about.
const PLACES: [(&str, &str); 15] = [
    ("type, declared", "^Valve : STRUCT"),
    ("type of a member", "valve : ^Valve"),
    ("type of elements", "OF ^Cell"),
    ("type before a value", "step, ^Phase.FILLING"),
    ("member, declared", "^open : BOOL"),
    ("member, initial", "(^open := TRUE"),
    ("member in a path", "valve.^open )"),
    ("inner member", "[k + 1].^valve"),
    ("value, declared", "(^IDLE"),
    ("value alone", "step, ^IDLE"),
    ("value, initial", ":= ^FILLING"),
    ("block as a type", "m1   : ^$Motor"),
    ("instance", "( ^m1, a"),
    ("output of a tag", "m1.^running"),
    ("output of a member", "drive.^running"),
];

fn offset_of(text: &str, marked: &str) -> TextSize {
    let before = marked.find('^').expect("a mark");
    let at = text
        .find(&marked.replacen('^', "", 1))
        .expect("a place of the text");
    TextSize::new((at + before) as u32)
}

#[test]
fn at_names() {
    let fixture = Fixture::new(PLANT);
    let context = &fixture.files[0].0.context;
    assert!(
        !fixture.files[0].0.has_errors(),
        "{:?}",
        fixture.files[0].0.diagnostics()
    );
    let others = fixture.others(0);
    let text = fixture.text("main.clad").to_owned();
    let tokens = semantic_tokens(context, None);
    let mut table = format!(
        "{:<20} {:<9} {:<9} {:<5} {:<6} {:<6} {:<9} {:<11} {:<26} {}\n",
        "", "defined", "type", "done", "places", "marked", "renamed", "colour", "selected", "shown"
    );
    for (what, marked) in PLACES {
        let at = offset_of(&text, marked);
        let lines = |targets: Vec<crate::Target>| {
            let lines = targets
                .iter()
                .map(|it| context.line_number(it.focus.start()).to_string());
            match lines.collect::<Vec<_>>().join(",") {
                none if none.is_empty() => "-".to_owned(),
                lines => lines,
            }
        };
        let renamed = match prepare_rename(context, at) {
            Ok(Some(it)) => it.name,
            Ok(None) => "-".to_owned(),
            Err(_) => "refused".to_owned(),
        };
        let token = tokens.iter().find(|token| token.range.contains(at));
        let ranges = selections(context, at);
        let selected = ranges
            .iter()
            .take(3)
            .map(|range| text[*range].split_whitespace().collect::<String>());
        let shown = hover(context, at).map_or("-".to_owned(), |hover| {
            let mut lines = hover.markdown.lines();
            let first = lines.find(|line| !line.starts_with("```")).unwrap_or_default();
            first.to_owned()
        });
        let _ = writeln!(
            table,
            "{what:<20} {:<9} {:<9} {:<5} {:<6} {:<6} {renamed:<9} {:<11} {:<26} {shown}",
            lines(definition(context, at, &others)),
            lines(type_definition(context, at, &others)),
            lines(implementation(context, at, &others)),
            references(context, at, &others).len(),
            highlights(context, at).len(),
            token.map_or("-".to_owned(), |token| format!("{:?}", token.kind)),
            selected
                .collect::<Vec<_>>()
                .join(" < ")
                .chars()
                .take(26)
                .collect::<String>(),
        );
    }
    check(
        &table,
        expect![[r#"
                                 defined   type      done  places marked renamed   colour      selected                   shown
            type, declared       3         3         -     3      3      Valve     Type        Valve < Valve:STRUCT < TYP Valve : STRUCT
            type of a member     3         3         -     3      3      Valve     Type        Valve < valve:Valve; < TYP Valve : STRUCT
            type of elements     7         7         -     2      2      Cell      Type        Cell < ARRAY[1..4]OFCell < Cell : STRUCT
            type before a value  2         2         -     3      3      Phase     Type        Phase < Phase.FILLING < (s Phase : (IDLE := 0, FILLING := 1)
            member, declared     4         -         31    5      4      open      Property    open < open:BOOL; < TYPEPh Valve.open : BOOL
            member, initial      4         -         31    5      4      open      Property    open < open:=TRUE < (open: Valve.open : BOOL
            member in a path     4         -         31    5      4      open      Property    open < cell[k+1].valve.ope Valve.open : BOOL
            inner member         8         3         31,34 4      3      valve     Property    valve < cell[k+1].valve <  Cell.valve : Valve
            value, declared      2         2         -     3      2      IDLE      EnumMember  IDLE < (IDLE,FILLING) < Ph Phase.IDLE = 0
            value alone          2         2         -     3      2      IDLE      EnumMember  IDLE < (step,IDLE) < [EQ]( Phase.IDLE = 0
            value, initial       2         2         -     4      3      FILLING   EnumMember  FILLING < :=FILLING < step Phase.FILLING = 1
            block as a type      13        13        20    5      5      $Motor    Class       $Motor < m1:$Motor; < VARc [$Motor]( start, running )
            instance             25        13        32    4      3      m1        Variable    m1 < (m1,a) < [$Motor](m1, m1 : $Motor
            output of a tag      18        -         20    5      4      running   Property    running < m1.running < (m1 $Motor.running : BOOL
            output of a member   18        -         20    5      4      running   Property    running < cell[2].drive.ru $Motor.running : BOOL
        "#]],
    );
}

/// The features that are asked of a file as a whole.
#[test]
fn of_files() {
    let fixture = Fixture::new(PLANT);
    let context = &fixture.files[0].0.context;
    let others = fixture.others(0);
    let text = fixture.text("main.clad");
    let mut shown = String::new();
    let all = TextRange::up_to(TextSize::of(text));
    for inlay in inlays(context, all) {
        let _ = writeln!(shown, "hint: {}", inlay.whole.unwrap_or(inlay.label));
    }
    for fold in folds(context) {
        let lines = text[fold.range].lines();
        let _ = writeln!(
            shown,
            "fold: {} lines from {}",
            lines.clone().count(),
            lines.clone().next().unwrap_or_default().trim()
        );
    }
    for query in ["Valve", "open", "FILLING", "$Motor", "m1"] {
        let found = workspace_symbols(query, context, &others);
        for named in found.iter().take(2) {
            let _ = writeln!(
                shown,
                "symbol {query}: {} {:?} in {:?}",
                named.name, named.kind, named.container
            );
        }
    }
    for marked in ["m1   : ^$Motor", "^$Motor]( cell", "( ^m1, a"] {
        let callers = callers_at(context, offset_of(text, marked), &others);
        let _ = writeln!(
            shown,
            "calls at {marked}: {:?}",
            callers.iter().map(|it| &it.name).collect::<Vec<_>>()
        );
    }
    check(
        &shown,
        expect![[r#"
            hint: running := start; ENO := start
            hint: cell[k + 1].valve.open := step = IDLE
            hint: y := $Motor.ENO
            hint: x := $Motor.ENO
            hint: z := cell[1].valve.wait.Q
            fold: 11 lines from TYPE
            fold: 4 lines from Valve : STRUCT
            fold: 4 lines from Cell : STRUCT
            fold: 9 lines from FUNCTION_BLOCK [$Motor]
            fold: 3 lines from VAR_INPUT
            fold: 3 lines from VAR_OUTPUT
            fold: 7 lines from VAR
            symbol Valve: Valve Type in None
            symbol Valve: valve Member in Some("Cell")
            symbol open: open Member in Some("Valve")
            symbol FILLING: FILLING Value in Some("Phase")
            symbol $Motor: [$Motor] Block in None
            symbol m1: m1 Tag in None
            calls at m1   : ^$Motor: ["$Motor"]
            calls at ^$Motor]( cell: ["$Motor"]
            calls at ( ^m1, a: []
        "#]],
    );
}

fn check(shown: &str, expected: Expect) {
    expected.assert_eq(shown);
}
