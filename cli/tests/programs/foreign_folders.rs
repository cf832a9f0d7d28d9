//! Programs of other systems whose types, tags and blocks lie in other folders of their project.

use crate::harness::Folder;
use expect_test::expect;
use std::fs;
use std::path::Path;

const PUMP: &str = r#"<?xml version="1.0" encoding="utf-8"?>
<TcPlcObject Version="1.1.0.1"><POU Name="FB_Pump" Id="{1}"><Declaration><![CDATA[FUNCTION_BLOCK FB_Pump
VAR_INPUT
    mode : E_Mode;
END_VAR
VAR_OUTPUT
    on : BOOL;
END_VAR]]></Declaration><Implementation><ST><![CDATA[on := mode = E_Mode.Auto;]]></ST></Implementation></POU></TcPlcObject>
"#;
const MODE: &str = r#"<TcPlcObject Version="1.1.0.1"><DUT Name="E_Mode" Id="{2}"><Declaration><![CDATA[TYPE E_Mode : (Off, Auto); END_TYPE]]></Declaration></DUT></TcPlcObject>"#;
const GLOBALS: &str = r#"<TcPlcObject Version="1.1.0.1"><GVL Name="GVL" Id="{3}"><Declaration><![CDATA[VAR_GLOBAL
    lamp : BOOL;
    other : BOOL;
END_VAR]]></Declaration></GVL></TcPlcObject>"#;
const MAIN: &str = r#"<?xml version="1.0" encoding="utf-8"?>
<TcPlcObject Version="1.1.0.1"><POU Name="MAIN" Id="{4}"><Declaration><![CDATA[PROGRAM MAIN
VAR
    pump : FB_Pump;
    mode : E_Mode := E_Mode.Auto;
END_VAR]]></Declaration><Implementation><ST><![CDATA[pump(mode := mode);
lamp := pump.on;]]></ST></Implementation></POU></TcPlcObject>
"#;

#[test]
fn a_simatic_project_is_converted_whole() {
    let field =
        Path::new(env!("CARGO_MANIFEST_DIR")).join("../tests/corpus/field/simatic_project_in_folders/plant");
    let folder = Folder::with(&[]);
    for name in [
        "Blocks/Control.s7dcl",
        "Blocks/Sub/Data.s7dcl",
        "Tags/Inputs.xml",
        "Types/Motor.s7dcl",
    ] {
        folder.write(&format!("plant/{name}"), &fs::read(field.join(name)).unwrap());
    }
    let run = folder.ladder(&["convert", "plant", "-o", "out/"]);
    expect![[r#"
        exit status 0
        -- stderr
        plant/Blocks/Control.s7dcl: 4 translated, 0 approximated, 0 refused
        plant/Blocks/Sub/Data.s7dcl: 1 translated, 0 approximated, 0 refused
        plant/Types/Motor.s7dcl: 1 translated, 0 approximated, 0 refused
    "#]]
    .assert_eq(&run.to_string());
    expect![[r#"
        TYPE
            Motor     : STRUCT
                Run   : BOOL;
                Fault : BOOL;
            END_STRUCT;
            Data_type : STRUCT
                pump : Motor;
            END_STRUCT;  # Data in the project #
        END_TYPE

        FUNCTION_BLOCK [$Control]
        VAR_INPUT
            Go : BOOL;
        END_VAR
        VAR_GLOBAL
            Data : Data_type;
        END_VAR

        +--[/]( EN )------------------------------------------------------------<RET>--+

        +--[ ]( Go )---------------------------------------------( )( Data.pump.Run )--+
        END_FUNCTION_BLOCK
    "#]]
    .assert_eq(&folder.read("out/Blocks/Control/Control.clad"));
    // A block that is named alone knows its folder; a settings file makes a project of those above it.
    let run = folder.ladder(&["check", "plant/Blocks/Control.s7dcl"]);
    expect![[r#"
        exit status 1
        -- stdout
        error[not-translated]: `tag Data` stays as a comment: member `pump`: the type `Motor` is declared in no file of the project (the folder that is converted or opened, or one above with a ladder.toml)
         --> plant/Blocks/Control.s7dcl:1:1
          |
        1 | FUNCTION_BLOCK "Control"
          | ^^^^^^^^^^^^^^
          |
          = note: function block Control

        error[unknown-member]: DINT has the bits 0 to 31, there is no `pump`
          --> plant/Blocks/Control.s7dcl:10:13
           |
        10 |             Coil( "Data".pump.Run )
           |             ^^^^^^^^^^^^^^^^^^^^^^^
           |
           = note: network 1 of Control

        Checked 1 file: 2 errors.
    "#]].assert_eq(&run.to_string());
    folder.write("plant/ladder.toml", b"");
    let run = folder.ladder(&["check", "plant/Blocks/Control.s7dcl"]);
    expect![[r#"
        exit status 0
        -- stdout
        info[never-read]: the member `Fault` of Motor is declared and never used
         --> plant/Blocks/Control.s7dcl:3:9
          |
        3 |         Go : Bool;
          |         ^^
          |
          = note: function block Control
          = help: use it, or remove its declaration

        Checked 1 file: 1 info.
    "#]]
    .assert_eq(&run.to_string());
}

#[test]
fn a_twincat_project_is_found_by_its_file() {
    let folder = Folder::with(&[]);
    for (name, text) in [
        ("plc/Plant.plcproj", ""),
        ("plc/POUs/MAIN.TcPOU", MAIN),
        ("plc/POUs/Pumps/FB_Pump.TcPOU", PUMP),
        ("plc/DUTs/E_Mode.TcDUT", MODE),
        ("plc/GVLs/GVL.TcGVL", GLOBALS),
        // Of another project.
        ("old/DUTs/E_Mode.TcDUT", &MODE.replace("Auto", "Hand")),
    ] {
        folder.write(name, text.as_bytes());
    }
    folder.write("plc/lib/Lib.plcproj", b"");
    folder.write(
        "plc/lib/FB_Lib.TcPOU",
        PUMP.replace("FB_Pump", "FB_Lib").as_bytes(),
    );
    // All of a folder are programs, also those of projects in it, which see what is around them.
    let run = folder.ladder(&["convert", "plc", "-o", "out"]);
    expect![[r#"
        exit status 0
        -- stderr
        plc/POUs/MAIN.TcPOU: 11 translated, 0 approximated, 0 refused
        plc/POUs/Pumps/FB_Pump.TcPOU: 5 translated, 0 approximated, 0 refused
        plc/lib/FB_Lib.TcPOU: 5 translated, 0 approximated, 0 refused
    "#]]
    .assert_eq(&run.to_string());
    let run = folder.ladder(&["sim", "plc/POUs/MAIN.TcPOU", "--scans", "1"]);
    expect![[r#"
        exit status 0
        -- stdout
        scan,time_ms,lamp,mode
        0,0,1,Auto
    "#]]
    .assert_eq(&run.to_string());
}

#[test]
fn an_openplc_project_is_found_by_its_file() {
    let folder = Folder::with(&[]);
    let rungs = r#"{"name": "main", "rungs": []}"#;
    let main = format!(
        "PROGRAM main\nVAR_EXTERNAL\n  lamp : bool;\n  cfg : Settings;\nEND_VAR\nVAR\n  blink : Blink;\n  mode : Mode := Auto;\nEND_VAR\n\n{rungs}\nEND_PROGRAM\n"
    );
    for (name, text) in [
        (
            "project.json",
            r#"{"meta": {"name": "p", "type": "plc-project"}, "data": {"pous": [],
"dataTypes": [{"name": "Settings", "derivation": "structure", "variable": [
  {"name": "rate", "type": {"definition": "base-type", "value": "int"}, "initialValue": {"simpleValue": {"value": "5"}}},
  {"name": "steps", "type": {"definition": "array", "value": "ARRAY [0..2] OF int", "data": {"baseType": {"definition": "base-type", "value": "int"}, "dimensions": [{"dimension": "0..2"}]}}}]}],
"configuration": {"resource": {"tasks": [{"name": "task0", "triggering": "Cyclic", "interval": "T#20ms", "priority": 1}],
"instances": [{"name": "instance0", "program": "main", "task": "task0"}],
"globalVariables": [{"name": "lamp", "type": {"definition": "base-type", "value": "bool"}, "location": "%QX0.0", "initialValue": null, "documentation": "the lamp"},
{"name": "cfg", "type": {"definition": "user-data-type", "value": "Settings"}, "location": "", "documentation": ""}]}}}}"#,
        ),
        (
            "datatypes/Mode.dt",
            "TYPE\n  Mode : (Hand, Auto) := Hand;\nEND_TYPE\n",
        ),
        (
            "pous/function-blocks/Blink.st",
            "FUNCTION_BLOCK Blink\nVAR_OUTPUT\n  on : bool;\nEND_VAR\non := NOT on;\nEND_FUNCTION_BLOCK\n",
        ),
        ("pous/programs/main.ld", &main),
    ] {
        folder.write(name, text.as_bytes());
    }
    let run = folder.ladder(&["convert", "pous/programs/main.ld"]);
    expect![[r#"
        exit status 0
        -- stdout
        # ladder: cycle 20ms #

        TYPE
            Settings : STRUCT
                rate  : INT := 5;
                steps : ARRAY[0..2] OF INT;
            END_STRUCT;
            Mode     : (Hand, Auto) := Hand;
        END_TYPE

        VAR_GLOBAL
            lamp AT %QX0.0 : BOOL;  # the lamp #
            cfg            : Settings;
        END_VAR

        FUNCTION_BLOCK [$Blink]
        VAR_OUTPUT
            on : BOOL;
        END_VAR

        +--[/]( on )--------------------------------------------------------( )( on )--+
        END_FUNCTION_BLOCK

        VAR
            blink : $Blink;
            mode  : Mode := Auto;
        END_VAR
        -- stderr
        pous/programs/main.ld: 14 translated, 0 approximated, 0 refused
    "#]]
    .assert_eq(&run.to_string());
}
