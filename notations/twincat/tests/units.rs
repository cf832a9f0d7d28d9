//! Units of TwinCAT, and what becomes of them.

use expect_test::{Expect, expect};
use ladder_format::Options;
use ladder_notation::{Outcome, Source, convert};
use ladder_notation_twincat::TwinCat;
use std::path::PathBuf;

/// The ladder text of a unit, what there is to say about it, and the errors of the text.
fn text(xml: &str) -> String {
    let source = Source::alone("test", xml.as_bytes());
    let converted = match convert(&TwinCat, &source, &Options::default()) {
        Ok(converted) => converted,
        Err(error) => return format!("{error}\n"),
    };
    let mut out = converted.written.text;
    let analysis = ladder_analysis::analyze(&ladder_syntax::parse(&out).into(), "test.clad");
    for entry in converted.report.remarks() {
        match &entry.outcome {
            Outcome::Translated => {}
            Outcome::Approximated(why) => out.push_str(&format!("approximated {}: {why}\n", entry.element)),
            Outcome::Refused(why) => out.push_str(&format!("refused {}: {why}\n", entry.element)),
        }
    }
    out.extend(
        analysis
            .errors()
            .map(|error| format!("error: {}\n", error.message)),
    );
    out
}

#[track_caller]
fn check(xml: &str, expected: Expect) {
    expected.assert_eq(&text(xml));
}

/// A unit with these networks.
fn unit(declaration: &str, networks: &str) -> String {
    format!(
        "<?xml version=\"1.0\" encoding=\"utf-8\"?>\n<TcPlcObject Version=\"1.1.0.1\">\n<POU Name=\"Main\" Id=\"{{0}}\" SpecialFunc=\"None\">\n\
         <Declaration><![CDATA[{declaration}]]></Declaration>\n<Implementation><NWL><XmlArchive><Data>\n\
         <o xml:space=\"preserve\" t=\"NWLImplementationObject\"><v n=\"NetworkListComment\">\"\"</v>\n<l2 n=\"NetworkList\" cet=\"Network\">{networks}</l2></o>\n\
         </Data></XmlArchive></NWL></Implementation>\n</POU>\n</TcPlcObject>\n"
    )
}

fn network(items: &str) -> String {
    format!("<o><v n=\"OutCommented\">false</v><l2 n=\"NetworkItems\">{items}</l2></o>\n")
}

fn operand(text: &str, flags: u32) -> String {
    format!(
        "<v n=\"Operand\">\"{text}\"</v><v n=\"Type\">\"\"</v><o n=\"Flags\" t=\"Flags\"><v n=\"Flags\">{flags}</v></o><v n=\"Boolean\">false</v>"
    )
}

/// A contact or value.
fn leaf(text: &str, flags: u32) -> String {
    format!(
        "<o t=\"BoxTreeOperand\"><o n=\"Operand\" t=\"Operand\">{}</o></o>",
        operand(text, flags)
    )
}

/// The same as a field.
fn named(object: &str, name: &str) -> String {
    object.replacen("<o ", &format!("<o n=\"{name}\" "), 1)
}

fn target(text: &str, flags: u32) -> String {
    format!("<o t=\"Operand\">{}</o>", operand(text, flags))
}

fn assign(targets: &[String], value: &str) -> String {
    format!(
        "<o t=\"BoxTreeAssign\"><o n=\"OutputItems\" t=\"OutputItemList\"><l2 n=\"OutputItems\">{}</l2></o>{}</o>",
        targets.concat(),
        named(value, "RValue")
    )
}

/// A box: its name and instance, its inputs and outputs by name, the variables that take the outputs.
fn tree(name: &str, instance: &str, inputs: &[(&str, String)], outputs: &[(&str, &str)]) -> String {
    let items: String = inputs.iter().map(|(_, item)| item.as_str()).collect();
    let values = |names: &mut dyn Iterator<Item = &str>| {
        let all: Vec<String> = names.map(|name| format!("<v>{name}</v>")).collect();
        all.concat()
    };
    let taken: String = outputs
        .iter()
        .map(|(_, taken)| {
            if taken.is_empty() {
                "<n/>".to_owned()
            } else {
                target(taken, 0)
            }
        })
        .collect();
    format!(
        "<o t=\"BoxTreeBox\"><v n=\"BoxType\">\"{name}\"</v><o n=\"Instance\" t=\"Operand\">{}</o><o n=\"OutputItems\" t=\"OutputItemList\"><l2 n=\"OutputItems\">{taken}</l2></o>\
         <n n=\"InputFlags\"/><l2 n=\"InputItems\">{items}</l2><o n=\"InputParam\" t=\"ParamList\"><l2 n=\"Names\">{}</l2></o>\
         <o n=\"OutputParam\" t=\"ParamList\"><l2 n=\"Names\">{}</l2></o><n n=\"STSnippet\"/></o>",
        operand(instance, 0),
        values(&mut inputs.iter().map(|(name, _)| *name)),
        values(&mut outputs.iter().map(|(name, _)| *name)),
    )
}

const RAIL: &str = "<o t=\"BoxTreeTerminator\"><n n=\"Input\"/></o>";

#[test]
fn contacts_coils_and_boxes() {
    let or = tree("OR", "", &[("", leaf("start", 0)), ("", leaf("run", 0))], &[]);
    let and = tree(
        "AND",
        "",
        &[("", or), ("", leaf("halt", 1)), ("", leaf("door", 16))],
        &[],
    );
    let timer = tree(
        "TON",
        "wait",
        &[("IN", leaf("run", 0)), ("PT", leaf("T#2s", 0))],
        &[("Q", ""), ("ET", "passed")],
    );
    let sum = tree(
        "ADD",
        "",
        &[("EN", leaf("run", 0)), ("", leaf("n", 0)), ("", leaf("1", 0))],
        &[("ENO", ""), ("", "n")],
    );
    let networks = [
        network(&assign(&[target("run", 0), target("lamp", 1)], &and)),
        network(&assign(&[target("warm", 2)], &timer)),
        network(&assign(&[target("warm", 3)], &leaf("halt", 0))),
        network(&sum),
        network(&assign(
            &[target("n", 0)],
            &tree(
                "LIMIT",
                "",
                &[("MN", leaf("0", 0)), ("IN", leaf("n", 0)), ("MX", leaf("9", 0))],
                &[],
            ),
        )),
        network(&assign(&[target("done", 4)], &leaf("warm", 0))),
        network(&assign(&[target("???", 8)], RAIL)).replace(
            "<o><v n=\"Out",
            "<o><v n=\"Title\">\"The end\"</v><v n=\"Label\">\"done\"</v><v n=\"Out",
        ),
    ];
    check(
        &unit(
            "{attribute 'qualified_only'}\nPROGRAM Main // first\nVAR\n  start, halt, lamp, warm : BOOL; (* all *)\n  run AT %QX0.0 : BOOL;\n  door : BOOL := TRUE;\n  n : INT;\n  wait : TON;\n  passed : TIME;\nEND_VAR\n",
            &networks.concat(),
        ),
        expect![[r#"
            VAR
                start            : BOOL;  # all #
                halt             : BOOL;  # all #
                lamp             : BOOL;  # all #
                warm             : BOOL;  # all #
                run    AT %QX0.0 : BOOL;
                door             : BOOL := TRUE;
                n                : INT;
                wait             : TON;
                passed           : TIME;
            END_VAR

            +--\--[ ]( start )--\--[/]( halt )--[P]( door )--\--------------( )( run )--\--+
            |  /--[ ]( run )----/                            /-------------(/)( lamp )--/  |

            +--[ ]( run )---------------------------------------------[TON]( wait, T#2s )--+

            +----------------------------------------------------[MOV]( passed, wait.ET )--+

            +--[ ]( wait.Q )--------------------------------------------------(S)( warm )--+

            +--[ ]( halt )----------------------------------------------------(R)( warm )--+

            +--[ ]( run )------------------------------------------------[ADD]( n, n, 1 )--+

            +-------------------------------------------------------[LIMIT]( n, 0, n, 9 )--+

            +--[ ]( warm )--------------------------------------------------<JMP>( done )--+

            # The end #
            +--<LBL>( done )---------------------------------------------------------------+

            +-----------------------------------------------------------------------<RET>--+
        "#]],
    );
}

#[test]
fn branches_wires_and_what_is_not_known() {
    let parallel = |before: &str, trees: &str| {
        format!(
            "<o t=\"BoxTreeParallel\">{}<l2 n=\"Trees\">{trees}</l2><v n=\"Mode\">BoxShortCircuit</v></o>",
            named(before, "Input")
        )
    };
    let demux = |id: u32, inside: &str| format!("<o t=\"BoxTreeDemux\"><v n=\"VarId\">{id}</v>{inside}</o>");
    let wired = tree(
        "AND",
        "",
        &[("", demux(1, &named(&leaf("a", 0), "Input"))), ("", leaf("b", 0))],
        &[],
    );
    let again = tree("AND", "", &[("", demux(1, "")), ("", leaf("b", 1))], &[]);
    let timer = tree(
        "TON",
        "t",
        &[("IN", leaf("b", 0)), ("PT", leaf("T#1s", 0))],
        &[("Q", "")],
    );
    let flagged = tree("AND", "", &[("", leaf("a", 0)), ("", leaf("b", 0))], &[]).replace(
        "<n n=\"InputFlags\"/>",
        "<l2 n=\"InputFlags\"><o><v n=\"Flags\">1</v></o></l2>",
    );
    let inert = tree("EXECUTE", "", &[("EN", leaf("a", 0))], &[("ENO", "")]).replace(
        "<n n=\"STSnippet\"/>",
        "<o n=\"STSnippet\"><o n=\"TextDocument\"><a n=\"TextLines\"><o><v n=\"Text\">\"x := 1;\"</v></o><o><v n=\"Text\">\"y := 2;\"</v></o></a></o></o><v n=\"ProvidesSTSnippet\">true</v>",
    );
    let networks = [
        network(&assign(
            &[target("x", 0)],
            &parallel(&leaf("a", 0), &(leaf("b", 0) + &leaf("x", 1))),
        )),
        network(&(assign(&[target("x", 0)], &wired) + &assign(&[target("y", 0)], &again))),
        network(&assign(&[target("x", 0)], &parallel(&leaf("a", 0), &timer))),
        network(&assign(&[target("x", 0)], &flagged)),
        network(&assign(&[target("y", 0)], &inert)),
        network(&assign(&[target("y", 64)], RAIL)),
        network("<o t=\"BoxTreeWormhole\"/>"),
        network(&assign(
            &[target("y", 0)],
            &tree("FB_Pump", "pump", &[("go", leaf("a", 0))], &[("on", "")]),
        )),
        network(&assign(&[target("y", 0)], &leaf("a", 0)))
            .replace("OutCommented\">false", "OutCommented\">true"),
        "<o><v n=\"ILActive\">true</v></o>".to_owned(),
    ];
    let xml = unit(
        "PROGRAM Main\nVAR a, b, x, y : BOOL; t : TON; END_VAR",
        &networks.concat(),
    );
    let xml = xml.replace("</POU>", "<Method Name=\"Start\"/><Action Name=\"Stop\"/></POU>");
    check(
        &xml,
        expect![[r#"
            # line 2 of Main: a number is used as BOOL; it is not run here. #
            FUNCTION_BLOCK [$line_2_of_Main]
            # ladder: unread, writes y #
            # y := 2 #
            END_FUNCTION_BLOCK

            # FB_Pump is not read: a scan runs past it, and what it may write is not known. #
            FUNCTION_BLOCK [$FB_Pump]
            VAR_INPUT
                operands : STRING[254] := '';
            END_VAR
            # ladder: unread #
            END_FUNCTION_BLOCK

            VAR
                a     : BOOL;
                b     : BOOL;
                x     : BOOL;
                y     : BOOL;
                t     : TON;
                power : BOOL;  # the power after a block #
            END_VAR

            +--[ ]( a )--\--[ ]( b )--\------------------------------------------( )( x )--+
            |            /--[/]( x )--/                                                    |

            +--[ ]( a )--\--[ ]( b )------------------------------------------( )( x )--\--+
            |            /--[/]( b )------------------------------------------( )( y )--/  |

            # A network is not read: a box that acts stands in a branch, whose power is not known: x := branches(TON(b, T\x231s)) #
            # A network is not read: AND has flags at its inputs, which may invert them: x := AND(a, b) #
            +--[ ]( a )--( )( power )--[NOT]-------------------------------<JMP>( past1 )--+

            +------------------------------------------------------------[MOV]( x, TRUE )--+
            +-----------------------------------------------------------[$line_2_of_Main]--+

            +--<LBL>( past1 )--[ ]( power )--------------------------------------( )( y )--+

            # A network is not read: `y` has the flags 64, which are not known: y := wire #
            # A network is not read: a `BoxTreeWormhole` is not known: BoxTreeWormhole #
            +--------------------------------------[$FB_Pump]( 'pump, go := a, on => y' )--+

            # Commented out: y := a #
            # A network is not read: it is written in IL, which is not read #

            # method Start: #

            # action Stop: #
            refused network: a box that acts stands in a branch, whose power is not known: x := branches(TON(b, T#1s))
            refused network: AND has flags at its inputs, which may invert them: x := AND(a, b)
            approximated y := 2: a number is used as BOOL: it is not run
            refused network: `y` has the flags 64, which are not known: y := wire
            refused network: a `BoxTreeWormhole` is not known: BoxTreeWormhole
            approximated FB_Pump pump: neither the project nor ladder text has a block `FB_Pump`: a scan runs past it, and what it may write is not known
            approximated network y := a: it is commented out there: a comment here
            refused network: it is written in IL, which is not read
            approximated method Start: nothing that is read runs it: it is a function that nothing calls
            approximated action Stop: nothing that is read runs it: it is a function that nothing calls
        "#]],
    );
}

#[test]
fn other_bodies_and_files() {
    let body = |inside: &str| {
        format!(
            "<TcPlcObject><POU Name=\"F\"><Declaration><![CDATA[FUNCTION_BLOCK F\nVAR_INPUT a : BOOL; END_VAR]]></Declaration><Implementation>{inside}</Implementation></POU></TcPlcObject>"
        )
    };
    check(
        &body("<ST><![CDATA[x := a;]]></ST>"),
        expect![[r#"
            FUNCTION_BLOCK [$F]
            VAR_INPUT
                a : BOOL := FALSE;
            END_VAR

            +--------------------------------------------------------------[$line_1_of_F]--+
            END_FUNCTION_BLOCK

            # line 1 of F: `x` is not declared here; it is not run here. #
            FUNCTION_BLOCK [$line_1_of_F]
            # ladder: unread #
            # x := a #
            END_FUNCTION_BLOCK
            approximated x := a: `x` is not declared here: it is not run
        "#]],
    );
    check(
        &body("<CFC><Data/></CFC>"),
        expect![[r#"
            # F (CFC) is not read: a scan runs past it, and what it may write is not known. #
            FUNCTION_BLOCK [$F]
            VAR_INPUT
                a : BOOL := FALSE;
            END_VAR
            # ladder: unread #
            # CFC Data #
            END_FUNCTION_BLOCK
            approximated body of F: CFC is not read: a scan runs past it, and what it may write is not known
        "#]],
    );
    check(
        &body("<NWL/>"),
        expect![[r#"
            FUNCTION_BLOCK [$F]
            VAR_INPUT
                a : BOOL := FALSE;
            END_VAR
            END_FUNCTION_BLOCK
            refused body: the body has no networks in it
        "#]],
    );
    check(
        &body(""),
        expect![[r#"
        FUNCTION_BLOCK [$F]
        VAR_INPUT
            a : BOOL := FALSE;
        END_VAR
        END_FUNCTION_BLOCK
        refused body: there is none: what the unit declares is read
    "#]],
    );
    check(
        "<TcPlcObject><GVL Name=\"G\"/></TcPlcObject>",
        expect![[r#"
        1:1: only units (`<POU>`) are read, and this file has `<GVL>`
    "#]],
    );
    check(
        "<TcPlcObject><POU Name=\"F\"/></TcPlcObject>",
        expect![[r#"
        1:14: the unit has no declaration
    "#]],
    );
    check(
        "<TcPlcObject><POU>",
        expect![[r#"
            1:19: the file ends too early, as one that was not saved or copied whole: export it again
        "#]],
    );
}

#[test]
fn units_of_the_corpus() {
    let Some(corpus) = std::env::var_os("LADDER_CORPUS").map(PathBuf::from) else {
        eprintln!("skipped: LADDER_CORPUS names no folder of real programs");
        return;
    };
    let read = |name: &str| {
        let file = corpus.join("twincat").join(name);
        let xml =
            std::fs::read_to_string(&file).unwrap_or_else(|error| panic!("{}: {error}", file.display()));
        let text = text(xml.trim_start_matches('\u{feff}'));
        let networks: Vec<&str> = text
            .lines()
            .filter(|line| line.starts_with(['+', '|']) || line.contains(": "))
            .collect();
        networks.join("\n") + "\n"
    };
    expect![[r#"
            xoutput : BOOL;
            xtest   : BOOL;
            xtest2  : BOOL;
        +--\--[ ]( xtest )---\-----------------------------------------( )( xoutput )--+
        |  /--[ ]( xtest2 )--/                                                         |
    "#]]
    .assert_eq(&read("volt.ladder.TcPOU"));
    expect![[r#"
            coil : BOOL;
        +--<LBL>( testLabel )----------------------------------------------------------+
        +-----------------------------------------------------------------( )( coil )--+
        +--<LBL>( testLabe2 )----------------------------------------------------------+
    "#]]
    .assert_eq(&read("volt.ladderLabel.TcPOU"));
    expect![[r#"
            fbTimer : TON;  # a block that the project does not declare #
        +--[ ]( SYS.OFF )-------------------------------------[TON]( fbTimer, FALSE )--+
        # Commented out: AND(FALSE, FALSE) #
        approximated network AND(FALSE, FALSE): it is commented out there: a comment here
        error: FALSE is given, TIME is expected
    "#]]
    .assert_eq(&read("volt.FbCall.derived.TcPOU"));
}

#[test]
fn a_pin_whose_variable_is_not_filled_in_is_not_connected() {
    let blank = |outputs: &str| outputs.replace("<n/>", &target("", 0));
    let timer = tree(
        "TON",
        "t1",
        &[("IN", leaf("a", 0)), ("PT", leaf("T#5s", 0))],
        &[("Q", ""), ("ET", "")],
    );
    let sum = tree(
        "ADD",
        "",
        &[("", leaf("n", 0)), ("", leaf("", 0)), ("", leaf("2", 0))],
        &[("", "n")],
    );
    check(
        &unit(
            "PROGRAM Main\nVAR\n\ta : BOOL;\n\tq : BOOL;\n\tn : INT;\n\tt1 : TON;\nEND_VAR\n",
            &(network(&assign(&[target("q", 0)], &blank(&timer))) + &network(&sum)),
        ),
        expect![[r#"
            VAR
                a  : BOOL;
                q  : BOOL;
                n  : INT;
                t1 : TON;
            END_VAR

            +--[ ]( a )---------------------------------------[TON]( t1, T#5s )--( )( q )--+

            +------------------------------------------------------------[ADD]( n, n, 2 )--+
        "#]],
    );
}

#[test]
fn types_as_they_are_written() {
    let declaration = "PROGRAM Main\nVAR\n    a : ARRAY [0..2]OF INT;\n    b : ARRAY[1..2]\tOF \tTc2_Standard.TON;\n    c : Tc2_System.T_MaxString;\n    d : INT (0..100) := 7;\n    e : Tc2_Standard.TON(PT := T#1S, IN := TRUE);\n    f : STRING(80) := 'x:=(1..2)';\nEND_VAR\nVAR_INST\n    g : BOOL;\nEND_VAR";
    check(
        &unit(declaration, ""),
        expect![[r#"
        VAR
            a : ARRAY[0..2] OF INT;
            b : ARRAY[1..2] OF TON;
            d : INT(0..100) := 7;
            e : TON;
            f : STRING[80]  := 'x:=(1..2)';
            g : BOOL;
        END_VAR
        refused variable c: the project has no type `T_MaxString`, and neither has ladder text
        approximated Tc2_Standard.TON(PT := T#1S, IN := TRUE): constructors are not run: what is handed to it is left out
    "#]],
    );
}
