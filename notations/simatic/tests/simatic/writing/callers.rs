//! What calls a program: an organization block, and the data block of its call.

use crate::{analysis, errors, read_as, read_with, remarks, write};
use expect_test::{Expect, expect};
use ladder_notation::{Companion, Notation, Writing};
use ladder_notation_simatic::SimaticMl;

const TEXT: &str = "VAR_INPUT\n    start AT %IX0.0 : BOOL;\n    level AT %IW4 : INT;\n    open : BOOL;\nEND_VAR\n\
                    VAR_OUTPUT\n    run AT %QX0.1 : BOOL;\nEND_VAR\nVAR\n    seen AT %MX1.0 : BOOL;\nEND_VAR\n\n\
                    +--[ ]( start )--[GT]( level, 3 )--[ ]( open )--( )( run )--( )( seen )--+\n";

/// A companion without the texts that each file begins with.
fn companion(writing: &Writing, name: &str) -> String {
    let file = writing.companions.iter().find(|file| file.name == name);
    let file = file.unwrap_or_else(|| panic!("{name} is not written"));
    String::from_utf8_lossy(&file.bytes)
        .trim_start_matches('\u{feff}')
        .replace('\r', "")
}

fn check(text: &str, expected: Expect) {
    expected.assert_eq(text);
}

#[test]
fn of_documents() {
    let writing = write(TEXT).expect("it is written");
    check(
        &companion(&writing, "test_Main.s7dcl"),
        expect![[r#"
        {
            S7_BlockTitle := "MLC_1";
            S7_Optimized := "TRUE";
            S7_PreferredLanguage := "LAD";
            S7_Version := "0.1"
        }
        ORGANIZATION_BLOCK "test_Main"

            {
                S7_Language := "LAD"
            }
            NETWORK
                RUNG wire#powerrail
                    "test_DB"( "start" := %I0.0, "level" := %IW4, "run" => %Q0.1 )
                END_RUNG
            END_NETWORK
        END_ORGANIZATION_BLOCK
    "#]],
    );
    check(
        &companion(&writing, "test_DB.s7dcl"),
        expect![[r#"
        {
            S7_Optimized := "TRUE";
            S7_Version := "0.1"
        }
        DATA_BLOCK "test_DB" : "test"

        END_DATA_BLOCK
    "#]],
    );
    let told: Vec<String> = writing
        .report
        .remarks()
        .map(|entry| format!("{} {}: {:?}\n", entry.place, entry.element, entry.outcome))
        .collect();
    check(
        &told.concat(),
        expect![[r#"
        2:1 tag `start`: Approximated("a variable of a block has no address: the organization block connects it to %I0.0")
        3:1 tag `level`: Approximated("a variable of a block has no address: the organization block connects it to %IW4")
        7:1 tag `run`: Approximated("a variable of a block has no address: the organization block connects it to %Q0.1")
        10:1 tag `seen`: Approximated("a variable of a block has no address: %MX1.0 is not kept")
    "#]],
    );
}

#[test]
fn of_simaticml() {
    let writing = SimaticMl.write(&analysis(TEXT)).expect("it is written");
    check(
        &companion(&writing, "test_DB.xml"),
        expect![[r#"
        <?xml version="1.0" encoding="utf-8"?>
        <Document>
          <Engineering version="V17"/>
          <SW.Blocks.InstanceDB ID="0">
            <AttributeList>
              <AutoNumber>true</AutoNumber>
              <InstanceOfName>test</InstanceOfName>
              <InstanceOfType>FB</InstanceOfType>
              <MemoryLayout>Optimized</MemoryLayout>
              <Name>test_DB</Name>
              <Number>2</Number>
              <ProgrammingLanguage>DB</ProgrammingLanguage>
            </AttributeList>
            <ObjectList/>
          </SW.Blocks.InstanceDB>
        </Document>
    "#]],
    );
    let main = companion(&writing, "test_Main.xml");
    for part in [
        "<SW.Blocks.OB ",
        "<SecondaryType>ProgramCycle</SecondaryType>",
        "<CallInfo Name=\"test\" BlockType=\"FB\">",
        "<Component Name=\"test_DB\"/>",
    ] {
        assert!(main.contains(part), "{part} in\n{main}");
    }
}

#[test]
fn a_call_is_read_again() {
    let writing = write(TEXT).expect("it is written");
    let mut files: Vec<Companion> = writing.companions.clone();
    files.push(Companion {
        name: "test.s7dcl".to_owned(),
        bytes: writing.bytes.clone().into(),
    });
    let documents = read_as("test_Main", &companion(&writing, "test_Main.s7dcl"), files);
    let writing = SimaticMl.write(&analysis(TEXT)).expect("it is written");
    let mut files: Vec<Companion> = writing.companions.clone();
    files.push(Companion {
        name: "test.xml".to_owned(),
        bytes: writing.bytes.clone().into(),
    });
    let xml = read_with(
        &SimaticMl,
        "test_Main",
        &companion(&writing, "test_Main.xml"),
        files,
    );
    assert_eq!(documents.written.text, xml.written.text);
    assert_eq!(errors(&documents.written.text), Vec::<String>::new());
    check(
        &format!("{}\n{}", documents.written.text, remarks(&documents)),
        expect![[r#"
        # Calls test in every cycle #

        FUNCTION_BLOCK [$test]
        VAR_INPUT
            start : BOOL;
            level : INT;
            open  : BOOL;
        END_VAR
        VAR_OUTPUT
            run : BOOL;
        END_VAR
        VAR
            seen : BOOL;
        END_VAR

        +--[/]( EN )------------------------------------------------------------<RET>--+

        +--[ ]( start )--[GT]( level, 3 )--[ ]( open )--------( )( run )--( )( seen )--+
        END_FUNCTION_BLOCK

        VAR_GLOBAL
            test_DB : $test;
        END_VAR

        +-----------[$test]( test_DB, start := %IX0.0, level := %IW4, run => %QX0.1 )--+

        7:1: approximated: ORGANIZATION_BLOCK test_Main: it is the program here, and runs in every scan: what starts it is not in the file
    "#]],
    );
}

#[test]
fn a_file_of_blocks_is_not_called() {
    let text = "FUNCTION_BLOCK [$Lamp]\nVAR_INPUT\n    on : BOOL;\nEND_VAR\nVAR_OUTPUT\n    lit : BOOL;\nEND_VAR\n\n\
                +--[ ]( on )--( )( lit )--+\nEND_FUNCTION_BLOCK\n";
    let writing = write(text).expect("it is written");
    let names: Vec<&str> = writing.companions.iter().map(|file| file.name.as_str()).collect();
    assert!(!names.iter().any(|name| name.contains("_Main")), "{names:?}");
}
