//! What other files of a project declare, and instances of the standard's blocks.

use super::{read, read_as, read_with, remarks};
use expect_test::expect;
use ladder_notation::Companion;
use ladder_notation_simatic::SimaticMl;

#[test]
fn a_data_block_of_a_type_and_an_empty_one() {
    let ty = Companion {
        name: "UdtS.s7dcl".to_owned(),
        bytes: b"TYPE\n    UdtS : STRUCT\n        a : Bool;\n    END_STRUCT;\nEND_TYPE\n"
            .to_vec()
            .into(),
    };
    let converted = read_as("Cfg", "DATA_BLOCK Cfg : UdtS\nEND_DATA_BLOCK\n", vec![ty]);
    expect![[r#"
        TYPE
            UdtS : STRUCT
                a : BOOL;
            END_STRUCT;
        END_TYPE

        VAR_GLOBAL
            Cfg : UdtS;
        END_VAR

    "#]]
    .assert_eq(&format!("{}\n{}", converted.written.text, remarks(&converted)));
    let converted = read("DATA_BLOCK \"Leer\"\nEND_DATA_BLOCK\n", Vec::new());
    assert_eq!(
        (converted.written.text.as_str(), remarks(&converted).as_str()),
        ("", "")
    );
}

#[test]
fn a_tag_that_no_file_declares_holds_what_is_moved_into_it() {
    let text = "FUNCTION \"F\" : Void\n    { S7_Language := \"LAD\" }\n    NETWORK\n        RUNG wire#powerrail\n            Move( in := 40001, out1 => \"Start\" )\n            Move( in := 5, out1 => \"Small\" )\n        END_RUNG\n    END_NETWORK\nEND_FUNCTION\n";
    let converted = read(text, Vec::new());
    expect![[r#"
        VAR_GLOBAL
            Small : INT;
            Start : DINT;
        END_VAR

        +------------------------------------[MOV]( Start, 40001 )--[MOV]( Small, 5 )--+

        1:1: approximated: tag Small: another file of the project declares it: its type is the one that its place asks for
        1:1: approximated: tag Start: another file of the project declares it: its type is the one that its place asks for
    "#]]
    .assert_eq(&format!("{}\n{}", converted.written.text, remarks(&converted)));
}

/// Multi-instances; what they hold is read as `#rise.Q`. A fall is none in the first cycle.
#[test]
fn edge_detectors_with_instances() {
    let text = "FUNCTION_BLOCK \"F\"\n    VAR_INPUT\n        go : Bool;\n    END_VAR\n    VAR_OUTPUT\n        on : Bool;\n    END_VAR\n    VAR\n        rise : R_TRIG;\n        fall : F_TRIG;\n    END_VAR\n    { S7_Language := \"LAD\" }\n    NETWORK\n        RUNG wire#powerrail\n            #rise.R_TRIG( clk := #go, q => #on )\n        END_RUNG\n        RUNG wire#powerrail\n            Contact( #rise.Q )\n            Coil( #on )\n        END_RUNG\n    END_NETWORK\n    { S7_Language := \"SCL\" }\n    NETWORK\n        #fall(CLK := #go);\n        IF #fall.Q THEN #on := FALSE; END_IF;\n    END_NETWORK\nEND_FUNCTION_BLOCK\n";
    let converted = read(text, Vec::new());
    expect![[r#"
        VAR_INPUT
            go : BOOL;
        END_VAR
        VAR_OUTPUT
            on : BOOL;
        END_VAR
        VAR
            rise   : BOOL;
            fall   : BOOL;
            rise_M : BOOL;  # what an edge detector remembers #
        END_VAR

        +--\-----------------[CALC]( rise, go AND NOT rise_M )--[MOV]( rise_M, go )--[MOV]( on, rise )--\--+
        |  /--[ ]( rise )--------------------------------------------------------------------( )( on )--/  |

        +--[ ]( go )--[OSF]-----------------------------------------------( )( fall )--+

        # IF fall.Q THEN on := FALSE; END_IF #
        +--[ ]( fall )------------------------------------------------------(R)( on )--+

    "#]]
    .assert_eq(&format!("{}\n{}", converted.written.text, remarks(&converted)));
}

#[test]
fn tags_of_a_table() {
    let table = r#"<Document><Engineering version="V17"/><SW.Tags.PlcTagTable ID="0"><AttributeList><Name>Inputs</Name></AttributeList><ObjectList><SW.Tags.PlcTag ID="1" CompositionName="Tags"><AttributeList><DataTypeName>Word</DataTypeName><LogicalAddress>%IW0</LogicalAddress><Name>Level</Name></AttributeList></SW.Tags.PlcTag></ObjectList></SW.Tags.PlcTagTable></Document>"#;
    let text = r#"<Document><SW.Blocks.FC ID="0"><AttributeList><Name>Fan</Name></AttributeList>
<ObjectList><SW.Blocks.CompileUnit ID="3"><AttributeList><NetworkSource><StructuredText>
<Access Scope="GlobalVariable"><Symbol><Component Name="Level"/></Symbol></Access><Blank/><Token Text=":="/><Blank/><Access Scope="LiteralConstant"><Constant><ConstantValue>9</ConstantValue></Constant></Access><Token Text=";"/>
</StructuredText></NetworkSource><ProgrammingLanguage>SCL</ProgrammingLanguage></AttributeList></SW.Blocks.CompileUnit></ObjectList></SW.Blocks.FC></Document>"#;
    let table = Companion {
        name: "Inputs.xml".to_owned(),
        bytes: table.to_owned().into(),
    };
    let converted = read_with(&SimaticMl, "Fan", text, vec![table]);
    expect![[r#"
        VAR_GLOBAL
            Level : WORD;
        END_VAR

        +-----------------------------------------------------------[MOV]( Level, 9 )--+

    "#]]
    .assert_eq(&format!("{}\n{}", converted.written.text, remarks(&converted)));
}

#[test]
fn constants_of_a_table() {
    let table = r#"<Document><Engineering version="V17"/><SW.Tags.PlcTagTable ID="0"><AttributeList><Name>Limits</Name></AttributeList><ObjectList><SW.Tags.PlcUserConstant ID="1" CompositionName="UserConstants"><AttributeList><DataTypeName>Int</DataTypeName><Name>MOST</Name><Value>5</Value></AttributeList></SW.Tags.PlcUserConstant></ObjectList></SW.Tags.PlcTagTable></Document>"#;
    let text = "FUNCTION_BLOCK \"Fan\"\n    VAR_INPUT\n        level : Int;\n    END_VAR\n    VAR_OUTPUT\n        run : Bool;\n    END_VAR\n\
                {\n    S7_Language := \"LAD\"\n}\nNETWORK\n    RUNG wire#powerrail\n        { S7_Templates := \"SrcType := Int\" }\n        \
                GT_Contact( in1 := #level, in2 := \"MOST\" )\n        Coil( #run )\n    END_RUNG\nEND_NETWORK\nEND_FUNCTION_BLOCK\n";
    let table = Companion {
        name: "Limits.xml".to_owned(),
        bytes: table.to_owned().into(),
    };
    let converted = read_as("Fan", text, vec![table]);
    expect![[r#"
        VAR_INPUT
            level : INT;
        END_VAR
        VAR_OUTPUT
            run : BOOL;
        END_VAR
        VAR CONSTANT
            MOST : INT := 5;
        END_VAR

        +--[GT]( level, MOST )---------------------------------------------( )( run )--+

    "#]]
    .assert_eq(&format!("{}\n{}", converted.written.text, remarks(&converted)));
}
