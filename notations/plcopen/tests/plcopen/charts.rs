//! Charts: what they become, and what keeps one from being read.

use crate::harness::{check, project, text};
use expect_test::expect;
use std::fmt::Write as _;

/// A program with a chart. `body` has an element a line: `step 1 A initial`, `transition 2 from=1 a AND b`, `jump 3 from=2 A`,
/// `actions 4 from=1 N lamp; D late T#2s`, or XML.
fn chart(variables: &str, parts: &str, body: &str) -> String {
    let mut lists = String::new();
    for name in variables.split_whitespace() {
        let (name, ty) = name.split_once(':').unwrap_or((name, "BOOL"));
        let _ = write!(lists, "<variable name=\"{name}\"><type><{ty}/></type></variable>");
    }
    let mut chart = String::new();
    for line in body.lines().map(str::trim).filter(|line| !line.is_empty()) {
        if line.starts_with('<') {
            chart.push_str(line);
            continue;
        }
        let mut words = line.split(' ');
        let (kind, id) = (words.next().unwrap(), words.next().unwrap());
        let (mut point, mut priority, mut rest) = (String::new(), String::new(), Vec::new());
        for word in words {
            match word.split_once('=') {
                Some(("from", ends)) => {
                    let ends = ends
                        .split(',')
                        .map(|id| format!("<connection refLocalId=\"{id}\"/>"));
                    let ends: String = ends.collect();
                    let _ = write!(point, "<connectionPointIn>{ends}</connectionPointIn>");
                }
                Some(("priority", number)) => priority = format!(" priority=\"{number}\""),
                _ => rest.push(word),
            }
        }
        chart.push('\n');
        let _ = match kind {
            "step" => write!(
                chart,
                "<step localId=\"{id}\" name=\"{}\" initialStep=\"{}\">{point}</step>",
                rest[0],
                rest.get(1) == Some(&"initial")
            ),
            "transition" => write!(
                chart,
                "<transition localId=\"{id}\"{priority}>{point}<condition><inline name=\"\"><ST><![CDATA[{}]]></ST></inline></condition></transition>",
                rest.join(" ")
            ),
            "jump" => write!(
                chart,
                "<jumpStep localId=\"{id}\" targetName=\"{}\">{point}</jumpStep>",
                rest[0]
            ),
            "actions" => {
                let rest = rest.join(" ");
                let actions = rest.split("; ").map(|action| {
                    let words: Vec<&str> = action.split(' ').collect();
                    let time = words.get(2).map(|time| format!(" duration=\"{time}\""));
                    format!(
                        "<action qualifier=\"{}\"{}><reference name=\"{}\"/></action>",
                        words[0],
                        time.unwrap_or_default(),
                        words[1]
                    )
                });
                let actions: String = actions.collect();
                write!(
                    chart,
                    "<actionBlock localId=\"{id}\">{point}{actions}</actionBlock>"
                )
            }
            other => write!(chart, "<{other} localId=\"{id}\">{point}</{other}>"),
        };
    }
    let unit = format!(
        "<pou name=\"Main\" pouType=\"program\"><interface><localVars>{lists}</localVars></interface>{parts}<body><SFC>{chart}</SFC></body></pou>"
    );
    project("", &unit, "")
}

#[test]
fn steps_transitions_and_actions() {
    let parts =
        "<actions><action name=\"Count\"><body><ST>n := n + 1; m := n;</ST></body></action></actions>";
    let xml = chart(
        "go stop lamp late n:INT m:INT",
        parts,
        "step 1 Idle initial
         selectionDivergence 2 from=1
         transition 3 from=2 priority=2 go
         transition 4 from=2 priority=1 stop
         step 5 Run from=3
         transition 6 from=5 Run.T >= T#2s OR stop AND NOT Idle.X
         jump 7 from=6 Idle
         step 8 Halt from=4
         transition 9 from=8 NOT stop
         jump 10 from=9 Idle
         actions 11 from=5 N lamp; SD late T#500ms; P Count
         actions 12 from=8 R late; N Count",
    );
    check(
        &xml,
        expect![[r#"
            VAR
                go             : BOOL;
                stop           : BOOL;
                lamp           : BOOL;
                late           : BOOL;
                n              : INT;
                m              : INT;
                Idle           : BOOL := TRUE;  # step Idle #
                Run            : BOOL;  # step Run #
                Run_T          : TIME;  # how long step Run is active #
                Halt           : BOOL;  # step Halt #
                Idle_to_Run    : BOOL;  # from Idle to Run #
                Run_to_Idle    : BOOL;  # from Run to Idle #
                Idle_to_Halt   : BOOL;  # from Idle to Halt #
                Halt_to_Idle   : BOOL;  # from Halt to Idle #
                Run_before     : BOOL;  # step Run in the scan before #
                late_begins_in : TIME;  # time until action late begins #
                late_begins    : BOOL;  # action late begins now #
                Count          : BOOL;  # action Count runs #
                Halt_before    : BOOL;  # step Halt in the scan before #
            END_VAR

            # steps in the scan before #
            +--[ ]( Run )---------( )( Run_before )--[ADD]( Run_T, Run_T, SYS.SCAN_TIME )--+
            +--[ ]( Halt )---------------------------------------------( )( Halt_before )--+
            +--[GT]( late_begins_in, T#0s )--[SUB]( late_begins_in, late_begins_in, SYS.SCAN_TIME )--[LE]( late_begins_in, T#0s )--( )( late_begins )--+

            # transitions #
            +--[ ]( Idle )--[ ]( stop )------------------( )( Idle_to_Halt )--(R)( Idle )--+
            +--[ ]( Idle )--[ ]( go )---------------------( )( Idle_to_Run )--(R)( Idle )--+
            +--[ ]( Run )--\--[GT]( Run_T, T#2s )-------\--( )( Run_to_Idle )--(R)( Run )--+
            |              /--[ ]( stop )--[/]( Idle )--/                                  |
            +--[ ]( Halt )--[/]( stop )------------------( )( Halt_to_Idle )--(R)( Halt )--+

            # the steps that they lead to #
            +--[ ]( Idle_to_Run )------------------------[MOV]( Run_T, T#0s )--(S)( Run )--+
            +--[ ]( Run_to_Idle )---------------------------------------------(S)( Idle )--+
            +--[ ]( Idle_to_Halt )--------------------------------------------(S)( Halt )--+
            +--[ ]( Halt_to_Idle )--------------------------------------------(S)( Idle )--+

            # action lamp #
            +--[ ]( Run )-----------------------------------------------------(S)( lamp )--+
            +--[/]( Run )--[ ]( Run_before )----------------------------------(R)( lamp )--+

            # action late #
            +--[ ]( Run )--[/]( Run_before )-------------[MOV]( late_begins_in, T#500ms )--+
            +--[ ]( late_begins )--------------[MOV]( late_begins_in, T#0s )--(S)( late )--+
            +--[ ]( Halt )----------------------------------------------------(R)( late )--+

            # action Count #
            +--\--[ ]( Halt )----------------------------------------\-------( )( Count )--+
            |  /--[/]( Halt_before )--[ ]( Run )--[/]( Run_before )--/                     |

            # action Count #
            +--[ ]( Count )--------------------------------------------[CALC]( n, n + 1 )--+
            +--[ ]( Count )-------------------------------------------------[MOV]( m, n )--+
        "#]],
    );
}

#[test]
fn simultaneous_branches() {
    let xml = chart(
        "go done lamp",
        "",
        "step 1 Idle initial
         transition 2 from=1 go
         simultaneousDivergence 3 from=2
         step 4 Left from=3
         step 5 Right from=3
         simultaneousConvergence 6 from=4 from=5
         transition 7 from=6 done
         jump 8 from=7 Idle
         actions 9 from=4 L lamp T#2s",
    );
    check(
        &xml,
        expect![[r#"
        VAR
            go           : BOOL;
            done         : BOOL;
            lamp         : BOOL;
            Idle         : BOOL := TRUE;  # step Idle #
            Left         : BOOL;  # step Left #
            Left_T       : TIME;  # how long step Left is active #
            Right        : BOOL;  # step Right #
            Idle_to_Left : BOOL;  # from Idle to Left, Right #
            Left_to_Idle : BOOL;  # from Left, Right to Idle #
            Left_before  : BOOL;  # step Left in the scan before #
        END_VAR

        # steps in the scan before #
        +--[ ]( Left )-----( )( Left_before )--[ADD]( Left_T, Left_T, SYS.SCAN_TIME )--+

        # transitions #
        +--[ ]( Idle )--[ ]( go )--------------------( )( Idle_to_Left )--(R)( Idle )--+
        +--[ ]( Left )--[ ]( Right )--[ ]( done )----------( )( Left_to_Idle )--(R)( Left )--(R)( Right )--+

        # the steps that they lead to #
        +--[ ]( Idle_to_Left )--------------[MOV]( Left_T, T#0s )--\---(S)( Left )--\--+
        |                                                          /--(S)( Right )--/  |
        +--[ ]( Left_to_Idle )--------------------------------------------(S)( Idle )--+

        # action lamp #
        +--[ ]( Left )--[LE]( Left_T, T#2s )------------------------------(S)( lamp )--+
        +--\--[ ]( Left )--[GT]( Left_T, T#2s )--\------------------------(R)( lamp )--+
        |  /--[/]( Left )--[ ]( Left_before )----/                                     |
    "#]],
    );
}

/// Why a chart is not read: what the comment on it says.
fn why(xml: &str) -> String {
    let text = text(xml);
    let line = text.lines().find(|line| line.contains("is not read ("));
    let why = line.and_then(|line| line.split_once("is not read (")?.1.split_once("): a scan"));
    why.map_or(text.clone(), |(why, _)| why.to_owned())
}

#[test]
fn what_is_not_understood() {
    let two = "step 1 One initial\ntransition 2 from=1 a\nstep 3 Two from=2\ntransition 4 from=3 NOT a\njump 5 from=4 One\n";
    let with = |more: &str| why(&chart("a b t:TIME n:INT", "", &format!("{two}{more}")));
    let mut all = String::new();
    for more in [
        "macroStep 9",
        "step 9 One",
        "actions 9 from=1 D b",
        "actions 9 from=1 DL b T#1s",
        "actions 9 from=1 N nothing",
        "actions 9 from=1 N n",
        "actions 9 from=1 D b n",
        "transition 9 from=77 a",
        "transition 9 from=2 a",
        "transition 9 from=1 a AND\nstep 10 C from=9",
        "transition 9 from=1 E.X\nstep 10 C from=9",
        "transition 9 from=1 a\nstep 10 b from=9",
        "jump 9 from=2 F",
        "<transition localId=\"9\"><connectionPointIn><connection refLocalId=\"1\"/></connectionPointIn></transition>",
        "selectionDivergence 9 from=10\nselectionDivergence 10 from=9\ntransition 11 from=9 a\nstep 12 C from=11",
    ] {
        let _ = writeln!(all, "{}: {}", more.replace('\n', ", "), with(more));
    }
    expect![[r#"
        macroStep 9: line 9: `macroStep` is not read
        step 9 One: line 9: two steps are called One
        actions 9 from=1 D b: line 9: the qualifier D has no time
        actions 9 from=1 DL b T#1s: line 9: there is no qualifier `DL`
        actions 9 from=1 N nothing: line 9: `nothing` is neither an action nor a BOOL
        actions 9 from=1 N n: line 9: `n` is neither an action nor a BOOL
        actions 9 from=1 D b n: line 9: `n` is not of the type TIME
        transition 9 from=77 a: line 9: a line comes from 77, which is not there
        transition 9 from=2 a: line 9: a transition follows another without a step between them
        transition 9 from=1 a AND, step 10 C from=9: the text in line 9: line 1 does not parse: a value is expected here, not the end of the text
        transition 9 from=1 E.X, step 10 C from=9: `E` is not declared here
        transition 9 from=1 a, step 10 b from=9: a step and a variable are called b
        jump 9 from=2 F: line 9: there is no step F
        <transition localId="9"><connectionPointIn><connection refLocalId="1"/></connectionPointIn></transition>: line 8: no step is after it
        selectionDivergence 9 from=10, selectionDivergence 10 from=9, transition 11 from=9 a, step 12 C from=11: line 11: its lines have no end
    "#]].assert_eq(&all);
}

#[test]
fn what_nothing_leads_to_is_left_out_with_a_word() {
    let xml = chart(
        "a",
        "",
        "step 1 One initial\ntransition 2 from=1 a\njump 3 from=2 One\nstep 4 Lost\ntransition 5 from=4 a\njump 6 from=5 One",
    );
    let text = text(&xml);
    let told: Vec<&str> = text
        .lines()
        .filter(|line| line.contains("approximated"))
        .collect();
    expect![[r#"
        approximated step Lost: nothing leads to it from an initial step: it never runs
        approximated transition: nothing leads to it from an initial step: it never runs"#]]
    .assert_eq(&told.join("\n"));
}

#[test]
fn long_and_crooked_charts_end() {
    let mut long = String::from("step 0 S0 initial\n");
    for number in 1..5_000 {
        let _ = writeln!(
            long,
            "transition {} from={} a\nstep {} S{number} from={}",
            number * 2 - 1,
            number * 2 - 2,
            number * 2,
            number * 2 - 1
        );
    }
    let reversed: Vec<&str> = long.lines().rev().collect();
    for body in [long.clone(), reversed.join("\n")] {
        let told = why(&chart("a", "", &body));
        assert!(told.contains("one after the other"), "{told}");
    }
    let mut ring = String::new();
    for number in 0..100 {
        let (one, two) = ((number + 1) % 100, (number + 7) % 100);
        let _ = writeln!(ring, "simultaneousConvergence {number} from={one} from={two}");
    }
    let told = why(&chart(
        "a",
        "",
        &format!("step 500 A initial\n{ring}transition 501 from=3 a\njump 502 from=501 A"),
    ));
    assert!(told.contains("no end"), "{told}");
}
