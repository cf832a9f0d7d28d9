//! What is not read: texts in other languages, what leads elsewhere, what runs at events.

use super::{analysis, read, read_as, read_xml, remarks, write};
use expect_test::expect;
use ladder_notation::Companion;

const FAN: &str = "FUNCTION_BLOCK \"Fan\"
    VAR_INPUT
        Go : Bool;
    END_VAR
    VAR_OUTPUT
        Run : Bool;
        Speed : Int;
    END_VAR

    { S7_Language := \"LAD\" }
    NETWORK
        RUNG wire#powerrail
            Contact( #Go )
            Coil( #Run )
        END_RUNG
    END_NETWORK
    { S7_Language := \"SCL\" }
    NETWORK
        IF #Go THEN
            #Speed := 16#0A; // \\ fast
        END_IF;
        POKE(area := 16#84, dbNumber := 1, byteOffset := 0, value := #Speed /* \\ fast */);
    END_NETWORK
END_FUNCTION_BLOCK
";

#[test]
fn a_statement_in_scl_there_and_back() {
    let converted = read_as("Fan", FAN, Vec::new());
    let ladder = converted.written.text.clone();
    expect![[r#"
        # line 4 of network 2 of Fan (SCL): `POKE`: it works on memory by address, which ladder text does not have; it is not run here. #
        FUNCTION_BLOCK [$line_4_of_network_2_of_Fan_SCL]
        # ladder: unread #
        # POKE(area := 16\h84, dbNumber := 1, byteOffset := 0, value := \hSpeed /* \\ fast */) #
        END_FUNCTION_BLOCK

        VAR_INPUT
            Go : BOOL;
        END_VAR
        VAR_OUTPUT
            Run   : BOOL;
            Speed : INT;
        END_VAR

        +--[ ]( Go )-------------------------------------------------------( )( Run )--+

        # \ fast #
        +--[ ]( Go )--------------------------------------------[MOV]( Speed, 16#0A )--+
        +-------------------------------------------[$line_4_of_network_2_of_Fan_SCL]--+
        # \ fast #

        22:9: approximated: POKE(area := 16#84, dbNumber := 1, byteOffset := 0, value :=: `POKE`: it works on memory by address, which ladder text does not have: it is not run
    "#]]
    .assert_eq(&format!("{ladder}\n{}", remarks(&converted)));
    let writing = write(&ladder).expect("it is written");
    let back = String::from_utf8(writing.bytes)
        .expect("it is text")
        .replace("\r\n", "\n");
    let (_, scl) = back.split_once("\"SCL\"").expect("the network is in SCL");
    expect![[r#"

            }
            NETWORK
                POKE(area := 16#84, dbNumber := 1, byteOffset := 0, value := #Speed /* \ fast */);
            END_NETWORK
        END_FUNCTION_BLOCK
    "#]]
    .assert_eq(scl);
    assert!(
        writing
            .companions
            .iter()
            .all(|file| file.name.starts_with("test"))
    );
    // Names that are not declared are not written.
    let other = ladder.replace("hSpeed /*", "hPace /*");
    let writing = write(&other).expect("the rest is written");
    let refused: Vec<String> = (writing.report.remarks())
        .map(|entry| format!("{:?}", entry.outcome))
        .collect();
    assert_eq!(
        refused,
        ["Refused(\"its text in SCL names `#Pace`, which the block does not declare\")"]
    );
}

#[test]
fn what_may_lead_elsewhere_takes_the_block_along() {
    let converted = read_as(
        "Fan",
        &FAN.replace("#Speed := ", "IF PEEK(1) THEN RETURN; END_IF; #Speed := "),
        Vec::new(),
    );
    expect![[r#"
        # body of Fan is not read: a scan runs past it, and what it may write is not known. #
        FUNCTION_BLOCK [$body_of_Fan]
        # ladder: unread #
        # NETWORK 1 #
        # RUNG wire\hpowerrail #
        #     Contact( \hGo ) #
        #     Coil( \hRun ) #
        # END_RUNG #
        # NETWORK 2 #
        # IF \hGo THEN #
        #     IF PEEK(1) THEN RETURN; END_IF; \hSpeed := 16\h0A; // \\ fast #
        # END_IF; #
        # POKE(area := 16\h84, dbNumber := 1, byteOffset := 0, value := \hSpeed /* \\ fast */); #
        END_FUNCTION_BLOCK

        VAR_INPUT
            Go : BOOL;
        END_VAR
        VAR_OUTPUT
            Run   : BOOL;
            Speed : INT;
        END_VAR

        +--------------------------------------------------------------[$body_of_Fan]--+

        1:1: approximated: body of Fan: something in it that is not read may lead elsewhere, so that all of it is not read: a scan runs past it, and what it may write is not known
    "#]]
    .assert_eq(&format!("{}\n{}", converted.written.text, remarks(&converted)));
}

#[test]
fn other_organisation_blocks_run_at_any_time() {
    let block = |name: &str, coil: &str| {
        format!(
            "{{ S7_Version := \"0.1\" }}\nORGANIZATION_BLOCK \"{name}\"\n{{ S7_Language := \"LAD\" }}\nNETWORK\nRUNG wire#powerrail Contact( \"Go\" ) Coil( {coil} ) END_RUNG\nEND_NETWORK\nEND_ORGANIZATION_BLOCK\n"
        )
    };
    let file = |name: &str, coil: &str| Companion {
        name: format!("{name}.s7dcl"),
        bytes: block(name, coil).into(),
    };
    let companions = vec![
        file("Cyclic", "\"Lamp\""),
        file("Startup", "%Q0.0"),
        file("Other", "\"Elsewhere\""),
    ];
    let converted = read(&block("Main", "\"Lamp\""), companions);
    expect![[r#"
        # Cyclic runs at an event, between any two networks of this program. #
        FUNCTION_BLOCK [$Cyclic2]
        # ladder: unread, at any time, writes Go, Lamp #
        # VAR_GLOBAL #
        #     Go   : BOOL; #
        #     Lamp : BOOL; #
        # END_VAR #
        #  #
        # +--[ ]( Go )------------------------------------------------------( )( Lamp )--+ #
        END_FUNCTION_BLOCK

        # Other runs at an event, between any two networks of this program. #
        FUNCTION_BLOCK [$Other2]
        # ladder: unread, at any time, writes Go #
        # VAR_GLOBAL #
        #     Elsewhere : BOOL; #
        #     Go        : BOOL; #
        # END_VAR #
        #  #
        # +--[ ]( Go )-------------------------------------------------( )( Elsewhere )--+ #
        END_FUNCTION_BLOCK

        # Startup runs at an event, between any two networks of this program. #
        FUNCTION_BLOCK [$Startup2]
        # ladder: unread, at any time #
        # VAR_GLOBAL #
        #     Go : BOOL; #
        # END_VAR #
        #  #
        # +--[ ]( Go )----------------------------------------------------( )( %QX0.0 )--+ #
        END_FUNCTION_BLOCK

        VAR_GLOBAL
            Go   : BOOL;
            Lamp : BOOL;
        END_VAR

        +------------------------------------------------------------------[$Cyclic2]--+

        +-------------------------------------------------------------------[$Other2]--+

        +-----------------------------------------------------------------[$Startup2]--+

        +--[ ]( Go )------------------------------------------------------( )( Lamp )--+

        1:1: approximated: tag Go: another file of the project declares it: its type is the one that its place asks for
        1:1: approximated: tag Lamp: another file of the project declares it: its type is the one that its place asks for
        2:1: approximated: ORGANIZATION_BLOCK Main: it is the program here, and runs in every scan: what starts it is not in the file
        2:1: approximated: ORGANIZATION_BLOCK Cyclic: it runs at an event there, and not here: what it writes is not known at any time
        2:1: approximated: ORGANIZATION_BLOCK Other: it runs at an event there, and not here: what it writes is not known at any time
        2:1: approximated: ORGANIZATION_BLOCK Startup: it runs at an event there, and not here: what it writes is not known at any time
    "#]].assert_eq(&format!("{}\n{}", converted.written.text, remarks(&converted)));
}

#[test]
fn a_text_of_an_export_has_its_operands_and_places() {
    let text = r#"<Document><SW.Blocks.FB ID="0"><AttributeList><Name>Fan</Name><Interface><Sections><Section Name="Output"><Member Name="Speed" Datatype="Int"/></Section></Sections></Interface></AttributeList>
<ObjectList><SW.Blocks.CompileUnit ID="3"><AttributeList><NetworkSource><StructuredText>
<Access Scope="LocalVariable" UId="21"><Symbol UId="22"><Component Name="Speed" UId="23"/></Symbol></Access><Blank UId="24"/><Token Text=":=" UId="25"/><Blank UId="26"/>
<Access Scope="LiteralConstant" UId="27"><Constant UId="28"><ConstantValue UId="29">9000</ConstantValue></Constant></Access><Token Text=";" UId="30"/><NewLine UId="31"/>
<LineComment UId="32"><Text UId="33">fast</Text></LineComment>
</StructuredText></NetworkSource><ProgrammingLanguage>SCL</ProgrammingLanguage></AttributeList></SW.Blocks.CompileUnit></ObjectList></SW.Blocks.FB></Document>"#;
    let text = text.replace("9000", "PEEK(1)");
    let converted = read_xml(&text);
    let ladder = converted.written.text.clone();
    let (_, text) = ladder.split_once("# ladder: unread").expect("it is not read");
    let (text, _) = text.split_once("END_FUNCTION_BLOCK").expect("it ends");
    expect![[r#"
         #
        # \hSpeed := PEEK(1) #

        3:57: approximated: #Speed := PEEK(1): `PEEK`: it works on memory by address, which ladder text does not have: it is not run
    "#]].assert_eq(&format!("{text}\n{}", remarks(&converted)));
    assert!(analysis(&ladder).errors().next().is_none());
}
