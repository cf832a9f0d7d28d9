//! `ladder tags --map modbus` and `--import`: places of tags for settings and for screens.
#![cfg(feature = "run")]

use crate::harness::{Folder, MOTOR};
use expect_test::{Expect, expect};

const PUMP: &str = "VAR_INPUT\n    go : BOOL;  # the desk #\n    wanted : REAL;\n    rest : TIME;\nEND_VAR\nVAR_OUTPUT\n    on AT %QX0.3 : BOOL;\n    total : LINT;\nEND_VAR\n\
    +--[ ]( go )--( )( on )--+\n+--[TRUNC]( total, wanted )--+\n";

const SETTINGS: &str = "[serve.modbus]\nlisten = \"0.0.0.0:1503\"\nunit = 7\nwrite = [\"go\", \"wanted\"]\n\n[serve.modbus.map]\n\
    \"coil 20\" = \"go\"\n\"holding 100\" = \"wanted\"\n\"holding 102\" = \"rest\"\n\"input 0\" = \"total\"\n";

fn check(settings: &str, arguments: &[&str], expected: Expect) {
    let folder = Folder::with(&[("pump.clad", PUMP), ("ladder.toml", settings)]);
    let arguments = [&["tags", "pump.clad", "--map", "modbus"], arguments].concat();
    expected.assert_eq(&folder.ladder(&arguments).to_string());
}

#[test]
fn places_are_frozen_where_they_are() {
    check(
        SETTINGS,
        &["--format", "csv"],
        expect![[r#"
        exit status 0
        -- stdout
        tag,type,table,from 0,from 1,access,comment
        on,BOOL,coil,3,4,read,
        go,BOOL,coil,20,21,read and write,the desk
        total,LINT,input,0,30001,read,
        wanted,REAL,holding,100,40101,read and write,
        rest,TIME,holding,102,40103,read,
    "#]],
    );
    check(
        "[serve.modbus.map]\n\"coil 20\" = \"go\"\n",
        &[],
        expect![[r#"
        exit status 0
        -- stdout
        [serve.modbus.map]
        "coil 3" = "on"
        "coil 20" = "go"
        "input 0" = "total"
        "holding 0" = "wanted"
        "holding 2" = "rest"
    "#]],
    );
    let folder = Folder::with(&[("motor.clad", MOTOR)]);
    expect![[r#"
        exit status 0
        -- stdout
        [serve.modbus.map]
        "coil 0" = "start"
        "coil 1" = "stop"
    "#]]
    .assert_eq(
        &folder
            .ladder(&["tags", "motor.clad", "--map", "modbus"])
            .to_string(),
    );
}

#[test]
fn screens_have_files_of_their_own() {
    check(
        SETTINGS,
        &["--format", "fuxa"],
        expect![[r#"
        exit status 0
        -- stdout
        [
          {
            "enabled": true,
            "id": "d_9817b1ed-00000000",
            "name": "pump",
            "polling": 500,
            "property": {
              "address": "127.0.0.1:1503",
              "connectionOption": "TcpPort",
              "delay": 10,
              "slaveid": "7"
            },
            "tags": {
              "t_9817b1ed-09b629c8": {
                "address": 4,
                "daq": {
                  "changed": false,
                  "enabled": false,
                  "interval": 60,
                  "restored": false
                },
                "description": "coil 3 (4)",
                "divisor": 1,
                "id": "t_9817b1ed-09b629c8",
                "memaddress": "000000",
                "name": "on",
                "type": "Bool"
              },
              "t_9817b1ed-b6689356": {
                "address": 21,
                "daq": {
                  "changed": false,
                  "enabled": false,
                  "interval": 60,
                  "restored": false
                },
                "description": "coil 20 (21), the desk",
                "divisor": 1,
                "id": "t_9817b1ed-b6689356",
                "memaddress": "000000",
                "name": "go",
                "type": "Bool"
              },
              "t_9817b1ed-c22fe15e": {
                "address": 1,
                "daq": {
                  "changed": false,
                  "enabled": false,
                  "interval": 60,
                  "restored": false
                },
                "description": "input 0 (30001)",
                "divisor": 1,
                "id": "t_9817b1ed-c22fe15e",
                "memaddress": "300000",
                "name": "total",
                "type": "Int64"
              },
              "t_9817b1ed-d9e3b838": {
                "address": 101,
                "daq": {
                  "changed": false,
                  "enabled": false,
                  "interval": 60,
                  "restored": false
                },
                "description": "holding 100 (40101)",
                "divisor": 1,
                "id": "t_9817b1ed-d9e3b838",
                "memaddress": "400000",
                "name": "wanted",
                "type": "Float32"
              },
              "t_9817b1ed-fd1421d0": {
                "address": 103,
                "daq": {
                  "changed": false,
                  "enabled": false,
                  "interval": 60,
                  "restored": false
                },
                "description": "holding 102 (40103)",
                "divisor": 1,
                "id": "t_9817b1ed-fd1421d0",
                "memaddress": "400000",
                "name": "rest",
                "type": "Int32"
              }
            },
            "type": "ModbusTCP"
          }
        ]
    "#]],
    );
    check(
        SETTINGS,
        &["--format", "node-red"],
        expect![[r#"
        exit status 0
        -- stdout
        [
          {
            "disabled": false,
            "id": "9817b1ed73e3430c",
            "info": "",
            "label": "pump",
            "type": "tab"
          },
          {
            "bufferCommands": true,
            "clientTimeout": 1000,
            "clienttype": "tcp",
            "commandDelay": 1,
            "id": "9817b1ed5a6dd5f6",
            "name": "pump",
            "parallelUnitIdsAllowed": true,
            "reconnectOnTimeout": true,
            "reconnectTimeout": 2000,
            "tcpHost": "127.0.0.1",
            "tcpPort": "1503",
            "tcpType": "DEFAULT",
            "type": "modbus-client",
            "unit_id": 7
          },
          {
            "adr": "3",
            "dataType": "Coil",
            "id": "9817b1ed92b6c5c1",
            "name": "coil 3 (4)",
            "quantity": "1",
            "rate": "1",
            "rateUnit": "s",
            "server": "9817b1ed5a6dd5f6",
            "topic": "",
            "type": "modbus-read",
            "unitid": "7",
            "wires": [
              [
                "9817b1ed152fc03d"
              ],
              []
            ],
            "x": 160,
            "y": 80,
            "z": "9817b1ed73e3430c"
          },
          {
            "func": "// coil 3 (4)\nconst read = msg.payload;\nmsg.payload = {\n    \"on\": Boolean(read[0]),  // coil 3 (4)\n};\nreturn msg;\n",
            "id": "9817b1ed152fc03d",
            "name": "names",
            "outputs": 1,
            "type": "function",
            "wires": [
              [
                "9817b1ed9c307ceb"
              ]
            ],
            "x": 400,
            "y": 80,
            "z": "9817b1ed73e3430c"
          },
          {
            "active": true,
            "complete": "payload",
            "id": "9817b1ed9c307ceb",
            "name": "",
            "targetType": "msg",
            "tosidebar": true,
            "type": "debug",
            "wires": [],
            "x": 600,
            "y": 80,
            "z": "9817b1ed73e3430c"
          },
          {
            "adr": "20",
            "dataType": "Coil",
            "id": "9817b1ed0131aa83",
            "name": "coil 20 (21)",
            "quantity": "1",
            "rate": "1",
            "rateUnit": "s",
            "server": "9817b1ed5a6dd5f6",
            "topic": "",
            "type": "modbus-read",
            "unitid": "7",
            "wires": [
              [
                "9817b1edb5bd8db1"
              ],
              []
            ],
            "x": 160,
            "y": 160,
            "z": "9817b1ed73e3430c"
          },
          {
            "func": "// coil 20 (21)\nconst read = msg.payload;\nmsg.payload = {\n    \"go\": Boolean(read[0]),  // coil 20 (21)\n};\nreturn msg;\n",
            "id": "9817b1edb5bd8db1",
            "name": "names",
            "outputs": 1,
            "type": "function",
            "wires": [
              [
                "9817b1edda84e5ec"
              ]
            ],
            "x": 400,
            "y": 160,
            "z": "9817b1ed73e3430c"
          },
          {
            "active": true,
            "complete": "payload",
            "id": "9817b1edda84e5ec",
            "name": "",
            "targetType": "msg",
            "tosidebar": true,
            "type": "debug",
            "wires": [],
            "x": 600,
            "y": 160,
            "z": "9817b1ed73e3430c"
          },
          {
            "adr": "0",
            "dataType": "InputRegister",
            "id": "9817b1ed3dbd3d31",
            "name": "input 0..3 (30001..30004)",
            "quantity": "4",
            "rate": "1",
            "rateUnit": "s",
            "server": "9817b1ed5a6dd5f6",
            "topic": "",
            "type": "modbus-read",
            "unitid": "7",
            "wires": [
              [
                "9817b1ed89311a03"
              ],
              []
            ],
            "x": 160,
            "y": 240,
            "z": "9817b1ed73e3430c"
          },
          {
            "func": "// input 0..3 (30001..30004)\nconst read = msg.payload;\nconst bytes = (first, count) => {\n    const all = Buffer.alloc(2 * count);\n    for (let nth = 0; nth < count; nth++) all.writeUInt16BE(read[first + nth] & 0xffff, 2 * nth);\n    return all;\n};\nmsg.payload = {\n    \"total\": Number(bytes(0, 4).readBigInt64BE()),  // input 0 (30001)\n};\nreturn msg;\n",
            "id": "9817b1ed89311a03",
            "name": "names",
            "outputs": 1,
            "type": "function",
            "wires": [
              [
                "9817b1ede608725e"
              ]
            ],
            "x": 400,
            "y": 240,
            "z": "9817b1ed73e3430c"
          },
          {
            "active": true,
            "complete": "payload",
            "id": "9817b1ede608725e",
            "name": "",
            "targetType": "msg",
            "tosidebar": true,
            "type": "debug",
            "wires": [],
            "x": 600,
            "y": 240,
            "z": "9817b1ed73e3430c"
          },
          {
            "adr": "100",
            "dataType": "HoldingRegister",
            "id": "9817b1ed5da63dde",
            "name": "holding 100..103 (40101..40104)",
            "quantity": "4",
            "rate": "1",
            "rateUnit": "s",
            "server": "9817b1ed5a6dd5f6",
            "topic": "",
            "type": "modbus-read",
            "unitid": "7",
            "wires": [
              [
                "9817b1ed61bcfd43"
              ],
              []
            ],
            "x": 160,
            "y": 320,
            "z": "9817b1ed73e3430c"
          },
          {
            "func": "// holding 100..103 (40101..40104)\nconst read = msg.payload;\nconst bytes = (first, count) => {\n    const all = Buffer.alloc(2 * count);\n    for (let nth = 0; nth < count; nth++) all.writeUInt16BE(read[first + nth] & 0xffff, 2 * nth);\n    return all;\n};\nmsg.payload = {\n    \"wanted\": bytes(0, 2).readFloatBE(),  // holding 100 (40101)\n    \"rest\": bytes(2, 2).readInt32BE(),  // holding 102 (40103)\n};\nreturn msg;\n",
            "id": "9817b1ed61bcfd43",
            "name": "names",
            "outputs": 1,
            "type": "function",
            "wires": [
              [
                "9817b1edcd9641d7"
              ]
            ],
            "x": 400,
            "y": 320,
            "z": "9817b1ed73e3430c"
          },
          {
            "active": true,
            "complete": "payload",
            "id": "9817b1edcd9641d7",
            "name": "",
            "targetType": "msg",
            "tosidebar": true,
            "type": "debug",
            "wires": [],
            "x": 600,
            "y": 320,
            "z": "9817b1ed73e3430c"
          }
        ]
    "#]],
    );
    let little = SETTINGS.replace("unit", "words = \"little\"\nunit");
    check(
        &little,
        &["--format", "fuxa"],
        expect![[r#"
        exit status 0
        -- stdout
        [
          {
            "enabled": true,
            "id": "d_9817b1ed-00000000",
            "name": "pump",
            "polling": 500,
            "property": {
              "address": "127.0.0.1:1503",
              "connectionOption": "TcpPort",
              "delay": 10,
              "slaveid": "7"
            },
            "tags": {
              "t_9817b1ed-09b629c8": {
                "address": 4,
                "daq": {
                  "changed": false,
                  "enabled": false,
                  "interval": 60,
                  "restored": false
                },
                "description": "coil 3 (4)",
                "divisor": 1,
                "id": "t_9817b1ed-09b629c8",
                "memaddress": "000000",
                "name": "on",
                "type": "Bool"
              },
              "t_9817b1ed-b6689356": {
                "address": 21,
                "daq": {
                  "changed": false,
                  "enabled": false,
                  "interval": 60,
                  "restored": false
                },
                "description": "coil 20 (21), the desk",
                "divisor": 1,
                "id": "t_9817b1ed-b6689356",
                "memaddress": "000000",
                "name": "go",
                "type": "Bool"
              },
              "t_9817b1ed-d9e3b838": {
                "address": 101,
                "daq": {
                  "changed": false,
                  "enabled": false,
                  "interval": 60,
                  "restored": false
                },
                "description": "holding 100 (40101)",
                "divisor": 1,
                "id": "t_9817b1ed-d9e3b838",
                "memaddress": "400000",
                "name": "wanted",
                "type": "Float32MLE"
              },
              "t_9817b1ed-fd1421d0": {
                "address": 103,
                "daq": {
                  "changed": false,
                  "enabled": false,
                  "interval": 60,
                  "restored": false
                },
                "description": "holding 102 (40103)",
                "divisor": 1,
                "id": "t_9817b1ed-fd1421d0",
                "memaddress": "400000",
                "name": "rest",
                "type": "Int32MLE"
              }
            },
            "type": "ModbusTCP"
          }
        ]
        -- stderr
        warning: FUXA has no type for these tags: total
    "#]],
    );
}

#[test]
fn what_is_not_in_the_map_is_told() {
    check(
        "",
        &["--format", "csv"],
        expect![[r#"
        exit status 0
        -- stdout
        tag,type,table,from 0,from 1,access,comment
        on,BOOL,coil,3,4,read,
        -- stderr
        warning: inputs and outputs without a place, which are left out: 4; `ladder tags pump.clad --map modbus` writes the lines for ladder.toml
    "#]],
    );
    check(
        "",
        &["--format", "json"],
        expect![[r#"
        exit status 2
        -- stderr
        error: --map modbus is written as text, which is TOML, or with --format csv, fuxa or node-red
    "#]],
    );
    let folder = Folder::with(&[("pump.clad", PUMP)]);
    expect![[r#"
        exit status 2
        -- stderr
        error: this format is for places: add --map modbus
    "#]]
    .assert_eq(
        &folder
            .ladder(&["tags", "pump.clad", "--format", "fuxa"])
            .to_string(),
    );
}

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
        error: tags.csv:3: Output at Coil 1 is for Factory I/O as a server, and line 2 for a client
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
