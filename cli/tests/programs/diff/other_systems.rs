//! Programs of other systems.

use crate::harness::Folder;
use expect_test::expect;

/// A program of Logix.
fn logix(rung: &str) -> String {
    format!(
        "<RSLogix5000Content><Controller Name=\"C\"><Tags><Tag Name=\"a\" TagType=\"Base\" DataType=\"BOOL\"/>\
         <Tag Name=\"x\" TagType=\"Base\" DataType=\"BOOL\"/></Tags><Programs><Program Name=\"P\" MainRoutineName=\"Main\">\
         <Routines><Routine Name=\"Main\" Type=\"RLL\"><RLLContent><Rung Number=\"0\" Type=\"N\"><Text><![CDATA[{rung}]]></Text>\
         </Rung></RLLContent></Routine></Routines></Program></Programs></Controller></RSLogix5000Content>\n"
    )
}

#[test]
fn programs_of_other_systems() {
    let folder = Folder::with(&[
        ("a.L5X", &logix("XIC(a)OTE(x);")),
        ("b.L5X", &logix("XIO(a)OTE(x);")),
    ]);
    let converted = folder.ladder(&["convert", "a.L5X", "-o", "a.clad"]);
    assert_eq!(converted.status, Some(0), "{converted}");
    let same = folder.ladder(&["diff", "a.L5X", "a.clad"]);
    assert_eq!(same.to_string(), "exit status 0\n");
    for old in ["a.L5X", "a.clad"] {
        let shown = folder.ladder(&["diff", old, "b.L5X"]);
        assert_eq!(shown.status, Some(1), "{shown}");
        let heading = match old {
            "a.clad" => {
                "edited, does another thing: routine Main of program P, rung 0 (was line 10), writes x\n"
            }
            _ => "edited, does another thing: routine Main of program P, rung 0, writes x\n",
        };
        assert!(shown.stdout.contains(heading), "{shown}");
        assert!(!shown.stdout.contains("gone: network"), "{shown}");
    }
}

/// A change is where the other system has it, also after what has another name was given the new one.
#[test]
fn places_are_called_as_the_other_system_calls_them() {
    let project = |key: &str, contact: &str| {
        let next = "]]></Text></Rung><Rung Number=\"1\" Type=\"N\"><Text><![CDATA[";
        let rungs = format!("XIC({key})OTE(x);{next}XIO({key})OTL(y);{next}{contact}(y)OTE(z);");
        logix(&rungs).replace("Name=\"a\"", &format!("Name=\"{key}\""))
    };
    let folder = Folder::with(&[
        ("a.L5X", &project("start", "XIC")),
        ("b.L5X", &project("begin", "XIO")),
        ("old/Fan.s7dcl", &simatic("Contact( #go )")),
        ("new/Fan.s7dcl", &simatic("I_Contact( #go )")),
    ]);
    expect![[r#"
        exit status 1
        -- stdout
        --- a.L5X
        +++ b.L5X
            1 edited, 10 the same, 1 renamed

        renamed: input start -> begin (3 places)

            ... 10 the same

        edited, does another thing: routine Main of program P, rung 2, writes z
            with y off, z goes off in the old and on in the new program
        - +--[ ]( y )--------------------------------------------------------( )( z )--+
             ^^^^^^^^
        + +--[/]( y )--------------------------------------------------------( )( z )--+
             ^^^^^^^^

        the programs differ in scan 0, at 0s
            z => -  (old)
            z => _  (new)
    "#]]
    .assert_eq(&folder.ladder(&["diff", "a.L5X", "b.L5X"]).to_string());
    expect![[r#"
        exit status 1
        -- stdout
        --- old/Fan.s7dcl
        +++ new/Fan.s7dcl
            1 edited, 4 the same

            ... 4 the same

        edited, does another thing: network 2 of Fan, writes lamp
            with go off, lamp goes off in the old and on in the new program
        - +--[ ]( go )----------------------------------------------------( )( lamp )--+
             ^^^^^^^^^
        + +--[/]( go )----------------------------------------------------( )( lamp )--+
             ^^^^^^^^^

        the programs differ in scan 0, at 0s
            lamp => _  (old)
            lamp => -  (new)
    "#]]
    .assert_eq(
        &folder
            .ladder(&["diff", "old/Fan.s7dcl", "new/Fan.s7dcl"])
            .to_string(),
    );
    let json = folder.ladder(&["diff", "a.L5X", "b.L5X", "--format", "json"]);
    let part = "\"part\": \"routine Main of program P, rung 2\"";
    assert!(json.stdout.contains(part), "{json}");
}

/// A block of SIMATIC with two networks.
fn simatic(contact: &str) -> String {
    let network = |element: &str, coil: &str| {
        format!(
            "{{ S7_Language := \"LAD\" }}\nNETWORK\n    RUNG wire#powerrail\n        {element}\n        Coil( #{coil} )\n    \
             END_RUNG\nEND_NETWORK\n"
        )
    };
    format!(
        "FUNCTION_BLOCK \"Fan\"\n    VAR_INPUT\n        go : Bool;\n    END_VAR\n    VAR_OUTPUT\n        run : Bool;\n        lamp : Bool;\n    \
         END_VAR\n{}{}END_FUNCTION_BLOCK\n",
        network("Contact( #go )", "run"),
        network(contact, "lamp")
    )
}

/// Of two forms of a program one says how often it runs: that is the interval of both.
#[test]
fn a_program_and_what_is_made_of_it_do_the_same() {
    let motor = include_str!("../../../../examples/motor.clad");
    let folder = Folder::with(&[("motor.clad", motor)]);
    for file in ["motor.xml", "motor.s7dcl"] {
        folder.ladder(&["convert", "motor.clad", "-o", file]);
        let told = folder.ladder(&["diff", "--same", "motor.clad", file]).to_string();
        assert_eq!(told, "exit status 0\n-- stdout\nthe same\n", "{file}");
    }
}
