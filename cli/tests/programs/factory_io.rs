//! `ladder tags --import`: the tags of a scene of Factory I/O.
#![cfg(feature = "run")]

use crate::harness::Folder;
use expect_test::{Expect, expect};

fn import(table: &str, arguments: &[&str], expected: Expect) {
    let folder = Folder::with(&[("tags.csv", table)]);
    let arguments = [&["tags", "--import", "tags.csv"], arguments].concat();
    expected.assert_eq(&folder.ladder(&arguments).to_string());
}

const CLIENT: &str = "Name,Type,Data Type,Address\nAt entry,Input,Bool,Coil 0\nAuto,Input,Bool,\nFACTORY I/O (Time Scale),Input,Real,Holding Reg 0\n\
    Box conveyor,Output,Bool,Input 0\nBox Conveyor,Output,Bool,Input 1\nCounter,Output,Int,Input Reg 0\n";

#[test]
fn a_scene_becomes_declarations_and_settings() {
    import(
        CLIENT,
        &[],
        expect![[r#"
        exit status 0
        -- stdout
        # The sensors and actuators of a scene of Factory I/O, from tags.csv #

        VAR_INPUT
            at_entry               : BOOL;  # At entry #
            factory_i_o_time_scale : INT;  # FACTORY I/O (Time Scale), times the scale of the driver #
        END_VAR
        VAR_OUTPUT
            box_conveyor   : BOOL;  # Box conveyor #
            box_conveyor_2 : BOOL;  # Box Conveyor #
            counter        : INT;  # Counter #
        END_VAR
        -- stderr
        note: without an address in the driver, and left out: 1
    "#]],
    );
    import(
        CLIENT,
        &["--map", "modbus"],
        expect![[r#"
        exit status 0
        -- stdout
        # Factory I/O is the Modbus TCP client: its driver connects to this computer, port 1502, unit 1.
        [serve.modbus]
        write = [
            "at_entry",
            "factory_i_o_time_scale",
        ]

        [serve.modbus.map]
        "coil 0" = "at_entry"
        "holding 0" = "factory_i_o_time_scale"
        "discrete 0" = "box_conveyor"
        "discrete 1" = "box_conveyor_2"
        "input 0" = "counter"
        -- stderr
        note: without an address in the driver, and left out: 1
    "#]],
    );
    let server = "Name,Type,Data Type,Address\r\nAt entry,Input,Bool,Input 0\r\nLevel,Input,Real,Input Reg 3\r\nand,Output,Bool,Coil 0\r\n";
    import(
        server,
        &["--map", "modbus"],
        expect![[r#"
        exit status 0
        -- stdout
        # Factory I/O is the Modbus TCP server: here is the address of its computer.
        [[device]]
        name = "factory_io"
        modbus = "127.0.0.1:502"
        poll = "20ms"

        [device.read]
        "discrete 0" = "at_entry"
        "input 3" = "level"

        [device.write]
        "coil 0" = "_and"
    "#]],
    );
}

/// What comes out is a program and settings that fit each other.
#[test]
fn a_scene_can_be_served() {
    let folder = Folder::with(&[("tags.csv", CLIENT)]);
    for (arguments, file) in [(&["--map", "modbus"][..], "ladder.toml"), (&[], "scene.clad")] {
        let made = folder.ladder(&[&["tags", "--import", "tags.csv"], arguments].concat());
        folder.write(file, made.stdout.as_bytes());
    }
    let text = folder.read("scene.clad");
    folder.write(
        "scene.clad",
        format!("{text}\n+--[ ]( at_entry )--( )( box_conveyor )--+\n").as_bytes(),
    );
    let run = folder.ladder(&["run", "scene.clad", "--modbus", "127.0.0.1:0", "--for", "1ms"]);
    assert_eq!(run.status, Some(0), "{run}");
    assert!(run.stderr.contains("5 tags, 2 can be written"), "{run}");
}

#[test]
fn tables_that_are_something_else_are_refused() {
    let row = |row: &str, expected: Expect| {
        import(
            &format!("Name,Type,Data Type,Address\na,Input,Bool,Coil 0\n{row}\n"),
            &[],
            expected,
        );
    };
    import(
        "Name;Type\n",
        &[],
        expect![[r#"
        exit status 2
        -- stderr
        error: tags.csv:1: an export of the tags of Factory I/O begins with Name,Type,Data Type,Address
    "#]],
    );
    import(
        "Name,Type,Data Type,Address\na,Input,Bool,\n",
        &[],
        expect![[r#"
        exit status 2
        -- stderr
        error: tags.csv:1: no tag has an address: choose a Modbus driver in Factory I/O and place the tags in it
    "#]],
    );
    row(
        "b,Output,Bool,Coil 1",
        expect![[r#"
        exit status 2
        -- stderr
        error: tags.csv:3: Output at Coil 1 has Factory I/O as the server, and line 2 as the client
    "#]],
    );
    row(
        "b,Input,Bool,Coil 0",
        expect![[r#"
        exit status 2
        -- stderr
        error: tags.csv:3: line 2 has Coil 0 already
    "#]],
    );
    row(
        "b,Input,Bool,%IX0.0",
        expect![[r#"
        exit status 2
        -- stderr
        error: tags.csv:3: `%IX0.0` is not an address of a Modbus driver: Coil 0, Input 0, Holding Reg 0, Input Reg 0
    "#]],
    );
    row(
        "b,Input,Int,Coil 1",
        expect![[r#"
        exit status 2
        -- stderr
        error: tags.csv:3: Int cannot be at Coil 1
    "#]],
    );
    row(
        "b,Input,String,Coil 1",
        expect![[r#"
        exit status 2
        -- stderr
        error: tags.csv:3: `String` is not one of Bool, Int and Real
    "#]],
    );
    row(
        "b,In,Bool,Coil 1",
        expect![[r#"
        exit status 2
        -- stderr
        error: tags.csv:3: `In` is neither Input, which is a sensor, nor Output, an actuator
    "#]],
    );
    row(
        "b,Input",
        expect![[r#"
        exit status 2
        -- stderr
        error: tags.csv:3: this row has not the four cells of the header
    "#]],
    );
}
