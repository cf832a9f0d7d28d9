//! What is read.

use super::{errors, read, read_xml, remarks};
use expect_test::{Expect, expect};
use ladder_notation::Companion;

/// A block around some networks.
fn block(declared: &str, networks: &str) -> String {
    format!(
        "{{ S7_Optimized := \"TRUE\" }}\nFUNCTION_BLOCK \"Test block\"\nVAR_INPUT\na, b, c : Bool; n : Int;\nEND_VAR\nVAR_OUTPUT\ny, z : \
         Bool;\nEND_VAR\n{declared}\n{networks}\nEND_FUNCTION_BLOCK\n"
    )
}

fn network(inside: &str) -> String {
    format!("{{ S7_Language := \"LAD\" }}\nNETWORK\n{inside}\nEND_NETWORK\n")
}

/// The networks that come out, without the declarations of the frame, and what is remarked.
#[track_caller]
fn check(declared: &str, inside: &str, expected: Expect) {
    let converted = read(&block(declared, &network(inside)), Vec::new());
    let text = &converted.written.text;
    assert_eq!(errors(text), Vec::<String>::new(), "{text}");
    let frame = "    a : BOOL;\n    b : BOOL;\n    c : BOOL;\n    n : INT;\n";
    let (before, rest) = text
        .split_once(&format!("VAR_INPUT\n{frame}END_VAR\n"))
        .unwrap_or(("", text));
    let rest = rest.replacen("VAR_OUTPUT\n    y : BOOL;\n    z : BOOL;\nEND_VAR\n", "", 1);
    expected.assert_eq(&format!("{before}{}\n{}", rest.trim(), remarks(&converted)));
}

#[test]
fn a_bridge_is_drawn_as_one() {
    check(
        "",
        "RUNG wire#powerrail Contact( #a ) wire#w1 Contact( #b ) wire#w2 Coil( #y ) END_RUNG
         RUNG wire#w1 I_Contact( #n.%X3 ) wire#w3 END_RUNG wire#w2
         RUNG wire#powerrail Contact( #c ) wire#w3 Coil( #z ) END_RUNG",
        expect![[r#"
            +--[ ]( a )--\--[ ]( b )-------\-------------------------------------( )( y )--+
            |            /--[/]( n.3 )--\--/                                               |
            +--[ ]( c )-----------------/----------------------------------------( )( z )--+
        "#]],
    );
}

#[test]
fn wires_that_cross_go_by_way_of_tags() {
    check(
        "",
        "RUNG wire#powerrail Contact( #a ) wire#p Contact( #b ) wire#q Contact( #c ) wire#r Coil( #y ) END_RUNG
         RUNG wire#p I_Contact( #b ) END_RUNG wire#r
         RUNG wire#q I_Contact( #c ) wire#s Coil( #z ) END_RUNG
         RUNG wire#powerrail I_Contact( #a ) END_RUNG wire#s",
        expect![[r#"
            VAR
                point   : BOOL;  # power at a point of a network #
                point_2 : BOOL;  # power at a point of a network #
                point_3 : BOOL;  # power at a point of a network #
                point_4 : BOOL;  # power at a point of a network #
            END_VAR

            +--[ ]( a )------------------------------------------------------( )( point )--+

            +--[ ]( point )--[ ]( b )--------------------------------------( )( point_2 )--+

            +--\--[ ]( point_2 )--[ ]( c )--\------------------------------( )( point_3 )--+
            |  /--[ ]( point )--[/]( b )----/                                              |

            +--[ ]( point_3 )----------------------------------------------------( )( y )--+

            +--\--[ ]( point_2 )--[/]( c )--\------------------------------( )( point_4 )--+
            |  /--[/]( a )------------------/                                              |

            +--[ ]( point_4 )----------------------------------------------------( )( z )--+
            11:8: approximated: network: its wires would cross here: the power at their points goes by way of tags
        "#]],
    );
}

#[test]
fn edges_and_flip_flops() {
    check(
        "VAR m : Array[1..3] of Bool; keep : Bool; state : Bool; END_VAR",
        "RUNG wire#powerrail P_Contact( operand := #a, bit := #m[1] ) N_Trig( #m[2] ) S_SR( operand := #state, r1 := #b ) Coil( #y ) END_RUNG
         RUNG wire#powerrail Contact( #c ) N_Coil( operand => #z, bit := #keep ) END_RUNG",
        expect![[r#"
            VAR
                state : BOOL;
                power : BOOL;  # the power before a flip-flop #
            END_VAR

            +--\--[P]( a )--[OSF]-------------------------------------------------------------( )( power )--\--+
            |  /--\--[CALC]( state, (state OR power) AND NOT b )--[ ]( state )-----------------( )( y )--\--/  |
            |     /--[ ]( c )------------------------------------------------------------------(N)( z )--/     |
        "#]],
    );
}

#[test]
fn pins_that_take_power() {
    check(
        "VAR count : CTUD_INT; value : Int; END_VAR",
        "RUNG wire#powerrail Contact( #a ) { S7_Templates := \"value_type := Int\" } #count.CTUD( cd := wire#d, r := wire#r, ld := , pv := 5, qd => #z, cv => #value ) Coil( #y ) END_RUNG
         RUNG wire#powerrail Contact( #b ) END_RUNG wire#d
         RUNG wire#powerrail Contact( #c ) Not() END_RUNG wire#r",
        expect![[r#"
            VAR
                count : CTUD;
                value : INT;
                pin   : BOOL;  # the power at a pin #
            END_VAR

            +--\--[ ]( c )--[NOT]-------------------------------------------( )( pin )--\--+
            |  /--[ ]( a )-------------[CTUD]( count, 5, CD := b, R := pin )--( )( y )--/  |

            +--[ ]( count.QD )---------------------------------------------------( )( z )--+

            +----------------------------------------------------[TYP]( value, count.CV )--+
            12:75: approximated: #count.CTUD( cd := wire#d, r := wire#r, ld := , pv := 5, qd => #z, cv => #value ): the values of its other pins are written after the network
        "#]],
    );
}

#[test]
fn values_and_conversions() {
    check(
        "VAR long : DInt; r : Real; w : Word; END_VAR",
        "RUNG wire#powerrail
            { S7_Templates := \"SrcType := DInt\" } Add( in1 := #long, in2 := L#5, in3 := #n, out => #n )
            Move( in := #r, out1 => #n, out2 => #r )
            Convert{ [SrcType := Int, DestType := Real] }( in := #n, out => #r )
            { S7_Templates := \"SrcType := Real\"; S7_Expression := \"(IN1 + in2) ** 2.0\" } Calculate( in1 := #r, in2 := 1.5, out => #r )
            OutRange{ SrcType := Int }( min := 1, in := #n, max := 9 )
            GT{ SrcType := Int }( in1 := #n, in2 := 3, out => #y )
            S_BitfieldCoil( operand := #w, n := 3 )
        END_RUNG",
        expect![[r#"
            # S_BitfieldCoil is not read: a scan runs past it, and what it may write is not known. #
            FUNCTION_BLOCK [$S_BitfieldCoil]
            VAR_INPUT
                operands : STRING[254] := '';
            END_VAR
            # ladder: unread #
            END_FUNCTION_BLOCK

            VAR
                long    : DINT;
                r       : REAL;
                w       : WORD;
                result  : DINT;  # a result before it is converted #
                outside : BOOL;  # whether a value is outside of its range #
            END_VAR

            +--[ADD]( result, long, DINT#5, n )--[TYP]( n, result )--[TYP]( n, r )--[MOV]( r, r )--[TYP]( r, n )--[CALC]( r, (r + 1.5) ^ 2.0 )--[CALC]( outside, n < 1 OR n > 9 )--[ ]( outside )--------------[CALC]( y, n > 3 )--[$S_BitfieldCoil]( 'S_BitfieldCoil( operand := #w, n := 3 )' )--+
            19:13: approximated: S_BitfieldCoil( operand := #w, n := 3 ): only bits of an array, from a constant index on, can be set together here: a scan runs past it, and what it may write is not known
        "#]],
    );
}

#[test]
fn what_is_unknown_does_nothing_and_says_so() {
    check(
        "VAR pid : PID_Compact; END_VAR",
        "RUNG wire#powerrail Contact( #a ) #pid( Setpoint := 5.0, Output => #y ) wire#w1 \"Other\"( x := #n ) END_RUNG
         RUNG wire#w1 Contact( \"Plant\".pumps[3].run ) Coil( %Q0.5 ) END_RUNG",
        expect![[r##"
            # pid is not read: a scan runs past it, and what it may write is not known. #
            FUNCTION_BLOCK [$pid]
            VAR_INPUT
                operands : STRING[254] := '';
            END_VAR
            # ladder: unread #
            END_FUNCTION_BLOCK

            # Other is not read: a scan runs past it, and what it may write is not known. #
            FUNCTION_BLOCK [$Other]
            VAR_INPUT
                operands : STRING[254] := '';
            END_VAR
            # ladder: unread #
            END_FUNCTION_BLOCK

            VAR_GLOBAL
                Plant_pumps_3_run : BOOL;  # Plant.pumps.3.run in the project #
            END_VAR

            +--[ ]( a )--[$pid]( '#pid( Setpoint := 5.0, Output => #y )' )--\-----------------[$Other]( '"Other"( x := #n )' )--\--+
            |                                                               /--[ ]( Plant_pumps_3_run )----------( )( %QX0.5 )--/  |
            1:1: approximated: tag Plant.pumps.3.run: another file of the project declares it: its type is the one that its place asks for
            9:5: approximated: variable pid: it is not declared here: the type `PID_Compact` is declared in no file of the project (the folder that is converted or opened, or one above with a ladder.toml)
            12:35: approximated: #pid( Setpoint := 5.0, Output => #y ): `pid` is not declared here: the project does not have its type: a scan runs past it, and what it may write is not known
            12:81: approximated: "Other"( x := #n ): `Other` is no instruction that is known here, and no block of the project: a scan runs past it, and what it may write is not known
        "##]],
    );
}

#[test]
fn jumps_and_returns() {
    let text = block(
        "",
        &format!(
            "{}{}",
            network("RUNG wire#powerrail Contact( #a ) JumpCoil( Past ) END_RUNG"),
            network("Label( past )\nRUNG wire#powerrail Contact( #b ) Coil( #y ) Return() END_RUNG"),
        ),
    );
    let converted = read(&text, Vec::new());
    assert_eq!(errors(&converted.written.text), Vec::<String>::new());
    let networks = converted
        .written
        .text
        .split("END_VAR\n")
        .last()
        .unwrap_or_default()
        .trim()
        .to_owned();
    expect![[r#"
        +--[ ]( a )-----------------------------------------------------<JMP>( Past )--+

        +--<LBL>( Past )--[ ]( b )------------------------------------( )( y )--<RET>--+"#]]
    .assert_eq(&networks);
}

#[test]
fn a_set_coil_does_not_change_what_comes_after() {
    check(
        "",
        "RUNG wire#powerrail Contact( #a ) S_Coil( #y ) Coil( #z ) END_RUNG",
        expect![[r#"
            +--[ ]( a )--\----------------------------------------------------(S)( y )--\--+
            |            /----------------------------------------------------( )( z )--/  |
        "#]],
    );
}

#[test]
fn blocks_types_and_data_of_files_next_to_it() {
    let file = |name: &str, text: &str| Companion {
        name: name.to_owned(),
        bytes: text.to_owned().into(),
    };
    let companions = vec![
        file(
            "Motor.s7dcl",
            "{ S7_Version := \"0.1\" }\nFUNCTION_BLOCK \"Motor\"\nVAR_INPUT\ngo : Bool; limit : \"Limits\";\nEND_VAR\nVAR_OUTPUT\nrunning : Bool;\nEND_VAR\nVAR\nt : TON_TIME;\nEND_VAR\n{ S7_Language := \"LAD\" }\nNETWORK\nRUNG wire#powerrail Contact( #go ) #t.TON( pt := T#2s, et => ) Coil( #running ) END_RUNG\nEND_NETWORK\nEND_FUNCTION_BLOCK\n",
        ),
        file(
            "Limits.s7dcl",
            "{ S7_Version := \"0.1\" }\nTYPE \"Limits\"\nSTRUCT\n\"low end\" : Int; // mm\nhigh : Int := 9;\nEND_STRUCT;\nEND_TYPE\n",
        ),
        file(
            "Plant.s7dcl",
            "{ S7_Version := \"0.1\" }\nDATA_BLOCK \"Plant\"\nVAR\nlimits : \"Limits\";\npumps : Array[1..2] of Bool;\nEND_VAR\nEND_DATA_BLOCK\n",
        ),
        file("Broken.s7dcl", "FUNCTION \"Broken"),
    ];
    let text = block(
        "VAR pump : \"Motor\"; END_VAR",
        &network(
            "RUNG wire#powerrail Contact( #a ) #pump( go := \"Plant\".pumps[2], limit := \"Plant\".limits, running => #y ) \"Broken\"() END_RUNG",
        ),
    );
    let converted = read(&text, companions);
    let ladder = &converted.written.text;
    assert_eq!(errors(ladder), Vec::<String>::new(), "{ladder}");
    expect![[r#"
        TYPE
            Limits     : STRUCT
                low_end : INT;  # low end in the project: mm #
                high    : INT := 9;
            END_STRUCT;
            Plant_type : STRUCT
                limits : Limits;
                pumps  : ARRAY[1..2] OF BOOL;
            END_STRUCT;  # Plant in the project #
        END_TYPE

        # Broken is not read: a scan runs past it, and what it may write is not known. #
        FUNCTION_BLOCK [$Broken]
        VAR_INPUT
            operands : STRING[254] := '';
        END_VAR
        # ladder: unread #
        END_FUNCTION_BLOCK

        FUNCTION_BLOCK [$Motor]
        VAR_INPUT
            go    : BOOL;
            limit : Limits;
        END_VAR
        VAR_OUTPUT
            running : BOOL;
        END_VAR
        VAR
            t : TON;
        END_VAR

        +--[/]( EN )------------------------------------------------------------<RET>--+

        +--[ ]( go )---------------------------------[TON]( t, T#2s )--( )( running )--+
        END_FUNCTION_BLOCK

        VAR_INPUT
            a : BOOL;
            b : BOOL;
            c : BOOL;
            n : INT;
        END_VAR
        VAR_OUTPUT
            y : BOOL;
            z : BOOL;
        END_VAR
        VAR
            pump : $Motor;
        END_VAR
        VAR_GLOBAL
            Plant : Plant_type;
        END_VAR

        +--[ ]( a )----[$Motor]( pump, go := Plant.pumps[2], limit := Plant.limits, running => y )--[$Broken]( '"Broken"()' )--+

        12:107: approximated: "Broken"(): the file of `Broken` cannot be read: 1:11: a quote `"` is not closed on its line: a scan runs past it, and what it may write is not known
    "#]].assert_eq(&format!("{ladder}\n{}", remarks(&converted)));
}

#[test]
fn a_block_opened_alone_is_a_program_and_in_a_folder_a_block() {
    let converted = read(
        &block(
            "",
            &network("RUNG wire#powerrail Contact( #a ) Coil( #y ) END_RUNG"),
        ),
        Vec::new(),
    );
    let [file] = &converted.files[..] else {
        panic!("one file");
    };
    let text = String::from_utf8_lossy(&file.bytes);
    expect![[r#"
        Test_block.clad
        FUNCTION_BLOCK [$Test_block]
        # Test block in the project #
        VAR_INPUT
            a : BOOL;
            b : BOOL;
            c : BOOL;
            n : INT;
        END_VAR
        VAR_OUTPUT
            y : BOOL;
            z : BOOL;
        END_VAR

        +--[/]( EN )------------------------------------------------------------<RET>--+

        +--[ ]( a )----------------------------------------------------------( )( y )--+
        END_FUNCTION_BLOCK
    "#]]
    .assert_eq(&format!("{}\n{text}", file.name));
}

#[test]
fn broken_frames_are_refused_and_broken_networks_stay() {
    let source = |text: &str| {
        let source = ladder_notation::Source::alone("x", text.as_bytes());
        let read = ladder_notation::Notation::read(&ladder_notation_simatic::Simatic, &source);
        read.err().map(|error| error.to_string()).unwrap_or_default()
    };
    expect![[r#"
        4:1: `END_VAR` stands where `;` is expected
        2:1: the file ends without `END_FUNCTION_BLOCK`
        2:1: a block of SIMATIC begins with FUNCTION_BLOCK, FUNCTION, ORGANIZATION_BLOCK, DATA_BLOCK or TYPE
        3:8: the file ends without `END_NETWORK`"#]]
    .assert_eq(
        &[
            source("FUNCTION_BLOCK x\nVAR\na : Bool\nEND_VAR\n"),
            source("FUNCTION_BLOCK x\n"),
            source("{ S7_Version := \"0.1\" }\nPROGRAM x"),
            source("FUNCTION_BLOCK x\n{ S7_Language := \"LAD\" }\nNETWORK\n"),
        ]
        .join("\n"),
    );
    let converted = read(
        &block("", &network("RUNG wire#powerrail Contact( #a ) Coil #y END_RUNG")),
        Vec::new(),
    );
    expect![[r#"
        12:35: approximated: network: the network cannot be read: one of `({` is missing after `Coil`: a scan runs past it, and what it may write is not known
    "#]]
    .assert_eq(&remarks(&converted));
}

#[test]
fn power_in_a_circle_does_not_run() {
    check(
        "",
        "RUNG wire#p Contact( #a ) wire#q Coil( #y ) END_RUNG
         RUNG wire#q Contact( #b ) END_RUNG wire#p
         RUNG wire#powerrail Contact( #c ) END_RUNG wire#p",
        expect![[r#"
            # network 1 of Test block (LAD) is not read: a scan runs past it, and what it may write is not known. #
            FUNCTION_BLOCK [$network_1_of_Test_block_LAD]
            # ladder: unread #
            # RUNG wire\hp Contact( \ha ) wire\hq Coil( \hy ) END_RUNG #
            #          RUNG wire\hq Contact( \hb ) END_RUNG wire\hp #
            #          RUNG wire\hpowerrail Contact( \hc ) END_RUNG wire\hp #
            END_FUNCTION_BLOCK

            +----------------------------------------------[$network_1_of_Test_block_LAD]--+
            11:8: approximated: network: power would run in a circle: a scan runs past it, and what it may write is not known
        "#]],
    );
}

#[test]
fn an_export_with_a_call_and_values_between_boxes() {
    let text = include_str!("../../../../fuzz/seeds/notations/simatic_xml");
    let converted = read_xml(text);
    assert_eq!(errors(&converted.written.text), Vec::<String>::new());
    expect![[r#"
        TYPE
            s_type : STRUCT
                n : INT := 7;
            END_STRUCT;
        END_TYPE

        VAR_INPUT
            go : BOOL;  # the key #
            a  : ARRAY[0..3] OF INT;
        END_VAR
        VAR_OUTPUT
            y : BOOL;
        END_VAR
        VAR
            s : s_type;
        END_VAR

        +--<LBL>( top )--\--[ ]( go )------\--------[ADD]( s.n, a[2], s.n )--( )( y )--+
        |                /--[/]( %IX1.3 )--/                                           |

        12:30: approximated: variable s: it keeps its value from one scan to the next here
    "#]]
    .assert_eq(&(converted.written.text.clone() + "\n" + &remarks(&converted)));
}
