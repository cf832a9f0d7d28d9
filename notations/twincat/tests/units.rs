//! Units of TwinCAT, and what becomes of them.

use expect_test::{Expect, expect};
use ladder_format::Options;
use ladder_notation::{Companion, Outcome, Source, convert};
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
            TYPE
                T_MaxString : STRING[255];  # of the system's library #
            END_TYPE

            VAR
                a : ARRAY[0..2] OF INT;
                b : ARRAY[1..2] OF TON;
                c : T_MaxString;
                d : INT(0..100) := 7;
                e : TON;
                f : STRING[80]  := 'x:=(1..2)';
                g : BOOL;
            END_VAR
            approximated Tc2_Standard.TON(PT := T#1S, IN := TRUE): constructors are not run: what is handed to it is left out
        "#]],
    );
}

/// A unit in Structured Text, with what follows its body.
fn in_text(declaration: &str, body: &str, more: &str) -> String {
    format!(
        "<TcPlcObject><POU Name=\"Main\"><Declaration><![CDATA[{declaration}]]></Declaration>\n<Implementation><ST><![CDATA[{body}]]></ST></Implementation>{more}</POU></TcPlcObject>"
    )
}

#[test]
fn what_has_no_type_here_is_not_declared() {
    check(
        &in_text(
            "PROGRAM Main\nVAR\n\tname : T_MaxString := 'a;$'b';\n\tbusy : BOOL;\n\tfile : FB_FileOpen;\n\tat : POINTER TO INT;\n\tone : ST_One;\nEND_VAR\nVAR_STAT\n\tcount : INT(1..5);\n\tangle : LREAL := 3.0 / 4 * 2;\nEND_VAR",
            "name := CONCAT(STR1 := name, STR2 := 'x');\nfile(bExecute := TRUE, bBusy => busy);\nIF file.bBusy THEN\n\tcount := 1;\nEND_IF\nat := ADR(count);",
            "",
        ),
        expect![[r#"
            TYPE
                T_MaxString : STRING[255];  # of the system's library #
            END_TYPE

            # line 2 of Main: `file` is not a block that can be called; it is not run here. #
            FUNCTION_BLOCK [$line_2_of_Main]
            # ladder: unread #
            # file(bExecute := TRUE, bBusy => busy) #
            END_FUNCTION_BLOCK

            # line 3 of Main: `file` has no member `bBusy` that is read; it is not run here. #
            FUNCTION_BLOCK [$line_3_of_Main]
            # ladder: unread, writes count #
            # IF file.bBusy THEN #
            # 	count := 1; #
            # END_IF #
            END_FUNCTION_BLOCK

            # line 6 of Main: `ADR`: it works on memory by address, which ladder text does not have; it is not run here. #
            FUNCTION_BLOCK [$line_6_of_Main]
            # ladder: unread #
            # at := ADR(count) #
            END_FUNCTION_BLOCK

            VAR
                name  : T_MaxString := 'a;$'b';
                busy  : BOOL;
                count : INT(1..5);
                angle : LREAL       := 1.5;
            END_VAR

            +-------------------------------------------------[CONCAT]( name, name, 'x' )--+
            +-----------------------------------------------------------[$line_2_of_Main]--+
            +-----------------------------------------------------------[$line_3_of_Main]--+
            +-----------------------------------------------------------[$line_6_of_Main]--+
            approximated variable file: the project has no type `FB_FileOpen`, and neither has ladder text; it is not declared
            approximated variable at: `POINTER TO INT`, which is an address, has no counterpart; it is not declared
            approximated variable one: the project has no type `ST_One`, and neither has ladder text; it is not declared
            approximated file(bExecute := TRUE, bBusy => busy): `file` is not a block that can be called: it is not run
            approximated IF file.bBusy THEN: `file` has no member `bBusy` that is read: it is not run
            approximated at := ADR(count): `ADR`: it works on memory by address, which ladder text does not have: it is not run
        "#]],
    );
    check(
        &in_text(
            "FUNCTION_BLOCK Main\nVAR_INPUT\n\tmode : E_Mode;\n\tsize : UINT(1..9);\nEND_VAR\nVAR_STAT\n\tcount : INT;\nEND_VAR",
            "count := count + 1;\nsize := 2;",
            "",
        ),
        expect![[r#"
            FUNCTION_BLOCK [$Main]
            VAR_INPUT
                size : UINT(1..9);
            END_VAR

            +-----------------------------------------------------------[$line_1_of_Main]--+
            +------------------------------------------------------------[MOV]( size, 2 )--+
            END_FUNCTION_BLOCK

            # line 1 of Main: the type of `count` is not known here; it is not run here. #
            FUNCTION_BLOCK [$line_1_of_Main]
            # ladder: unread #
            # count := count + 1 #
            END_FUNCTION_BLOCK
            approximated variable mode: the project has no type `E_Mode`, and neither has ladder text; it is not declared
            approximated variable count: a variable that all instances have in common has no counterpart; it is not declared
            approximated count := count + 1: the type of `count` is not known here: it is not run
        "#]],
    );
    let block = tree("FB_Drive", "drive", &[("bEnable", leaf("a", 0))], &[]);
    let coil = assign(&[target("b", 0)], &leaf("drive.bReady", 0));
    check(
        &unit(
            "PROGRAM Main\nVAR\n\tdrive : FB_Drive;\n\ta, b : BOOL;\nEND_VAR",
            &(network(&block) + &network(&coil)),
        ),
        expect![[r#"
            # FB_Drive is not read: a scan runs past it, and what it may write is not known. #
            FUNCTION_BLOCK [$FB_Drive]
            VAR_INPUT
                operands : STRING[254] := '';
            END_VAR
            # ladder: unread #
            END_FUNCTION_BLOCK

            # input drive.bReady: `drive` is not declared here: the project has no type `FB_Drive`, and neither has ladder text; it is not run here. #
            FUNCTION_BLOCK [$input_drive_bReady]
            VAR_INPUT
                operands : STRING[254] := '';
            END_VAR
            # ladder: unread, writes #
            +------------------------------------------------------------------(R)( ENO )--+
            END_FUNCTION_BLOCK

            VAR
                a : BOOL;
                b : BOOL;
            END_VAR

            +----------------------------------------[$FB_Drive]( 'drive, bEnable := a' )--+

            +---------------------------[$input_drive_bReady]( 'drive.bReady' )--( )( b )--+
            approximated variable drive: it holds the state of a block that is not read, and is left out with that
            approximated FB_Drive drive: neither the project nor ladder text has a block `FB_Drive`: a scan runs past it, and what it may write is not known
            approximated input drive.bReady: `drive` is not declared here: the project has no type `FB_Drive`, and neither has ladder text: it is not run
        "#]],
    );
}

#[test]
fn actions_stand_where_they_are_called() {
    let action = |name: &str, text: &str| {
        format!(
            "<Action Name=\"{name}\"><Implementation><ST><![CDATA[{text}]]></ST></Implementation></Action>"
        )
    };
    check(
        &in_text(
            "PROGRAM Main\nVAR\n\ta, b : BOOL;\n\tn : INT;\nEND_VAR",
            "// Count();\nIF a THEN\n\tCount();\nEND_IF\nStop();\nOther();",
            &(action("Count", "n := n + 1; (* one more *)\nInner ( ) ;")
                + &action("Inner", "b := Unknown(n);\nCount();")
                + &action("Stop", "IF b THEN RETURN; END_IF")),
        ),
        expect![[r#"
            # line 6 of Main: `Unknown` is not declared, and is not a function that is read; it is not run here. #
            FUNCTION_BLOCK [$line_6_of_Main]
            # ladder: unread #
            # b := Unknown(n) #
            END_FUNCTION_BLOCK

            # line 10 of Main: `Unknown` is not declared, and is not a function that is read; it is not run here. #
            FUNCTION_BLOCK [$line_10_of_Main]
            # ladder: unread #
            # b := Unknown(n) #
            END_FUNCTION_BLOCK

            # line 14 of Main: `Unknown` is not declared, and is not a function that is read; it is not run here. #
            FUNCTION_BLOCK [$line_14_of_Main]
            # ladder: unread #
            # b := Unknown(n) #
            END_FUNCTION_BLOCK

            # line 18 of Main: `Unknown` is not declared, and is not a function that is read; it is not run here. #
            FUNCTION_BLOCK [$line_18_of_Main]
            # ladder: unread #
            # b := Unknown(n) #
            END_FUNCTION_BLOCK

            # line 19 of Main: `Count` is not declared, and is not a function that is read; it is not run here. #
            FUNCTION_BLOCK [$line_19_of_Main]
            # ladder: unread #
            # Count() #
            END_FUNCTION_BLOCK

            # line 29 of Main: `Stop` is not declared, and is not a function that is read; it is not run here. #
            FUNCTION_BLOCK [$line_29_of_Main]
            # ladder: unread #
            # Stop() #
            END_FUNCTION_BLOCK

            # line 30 of Main: `Other` is not declared, and is not a function that is read; it is not run here. #
            FUNCTION_BLOCK [$line_30_of_Main]
            # ladder: unread #
            # Other() #
            END_FUNCTION_BLOCK

            VAR
                a : BOOL;
                b : BOOL;
                n : INT;
            END_VAR

            # Count(); #
            # IF a THEN #
            +--[/]( a )---------------------------------------------------<JMP>( endif1 )--+

            # one more #
            +----------------------------------------------------------[CALC]( n, n + 1 )--+
            +-----------------------------------------------------------[$line_6_of_Main]--+

            # one more #
            +----------------------------------------------------------[CALC]( n, n + 1 )--+
            +----------------------------------------------------------[$line_10_of_Main]--+

            # one more #
            +----------------------------------------------------------[CALC]( n, n + 1 )--+
            +----------------------------------------------------------[$line_14_of_Main]--+

            # one more #
            +----------------------------------------------------------[CALC]( n, n + 1 )--+
            +----------------------------------------------------------[$line_18_of_Main]--+
            +----------------------------------------------------------[$line_19_of_Main]--+
            +--<LBL>( endif1 )-----------------------------------------[$line_29_of_Main]--+
            +----------------------------------------------------------[$line_30_of_Main]--+

            # action Stop: #
            # IF b THEN RETURN; END_IF #
            approximated Stop(): `Stop` is not declared, and is not a function that is read: it is not run
            approximated Other(): `Other` is not declared, and is not a function that is read: it is not run
            approximated b := Unknown(n): `Unknown` is not declared, and is not a function that is read: it is not run
            approximated b := Unknown(n): `Unknown` is not declared, and is not a function that is read: it is not run
            approximated b := Unknown(n): `Unknown` is not declared, and is not a function that is read: it is not run
            approximated b := Unknown(n): `Unknown` is not declared, and is not a function that is read: it is not run
            approximated Count(): `Count` is not declared, and is not a function that is read: it is not run
            approximated action Stop: nothing that is read runs it: it is a function that nothing calls
        "#]],
    );
}

#[test]
fn programs_are_called_as_blocks_that_are_there_once() {
    let other = "<TcPlcObject><POU Name=\"Lift\"><Declaration><![CDATA[PROGRAM Lift\nVAR_INPUT\n\tup : BOOL;\nEND_VAR\nVAR_OUTPUT\n\ttop : BOOL;\nEND_VAR]]></Declaration><Implementation><ST><![CDATA[top := up;]]></ST></Implementation></POU></TcPlcObject>";
    let idle = "<TcPlcObject><POU Name=\"Idle\"><Declaration><![CDATA[PROGRAM Idle]]></Declaration><Implementation><ST><![CDATA[;]]></ST></Implementation></POU></TcPlcObject>";
    let own = in_text(
        "PROGRAM Main\nVAR\n\ta, Idle : BOOL;\nEND_VAR",
        "Lift(up := a);\nIdle := Lift.top;",
        "",
    );
    let companion = |name: &str, text: &str| Companion {
        name: name.to_owned(),
        bytes: text.as_bytes().to_vec().into(),
    };
    let source = Source {
        companions: vec![companion("Lift.TcPOU", other), companion("Idle.TcPOU", idle)],
        ..Source::alone("test", own.as_bytes())
    };
    let converted = convert(&TwinCat, &source, &Options::default()).expect("it is read");
    expect![[r#"
        VAR_GLOBAL
            Lift : $Lift;
        END_VAR

        FUNCTION_BLOCK [$Lift]
        VAR_INPUT
            up : BOOL := FALSE;
        END_VAR
        VAR_OUTPUT
            top : BOOL;
        END_VAR

        +--[ ]( up )-------------------------------------------------------( )( top )--+
        END_FUNCTION_BLOCK

        VAR
            a    : BOOL;
            Idle : BOOL;
        END_VAR

        +----------------------------------------------------[$Lift]( Lift, up := a )--+
        +--[ ]( Lift.top )------------------------------------------------( )( Idle )--+
    "#]]
    .assert_eq(&converted.written.text);
}
