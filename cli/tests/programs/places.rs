//! `ladder tags --map modbus`: places of tags for settings and for screens.
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

/// A bit, and a value of two words.
const FEW: &str =
    "[serve.modbus]\nlisten = \"0.0.0.0:1503\"\nunit = 7\n[serve.modbus.map]\n\"holding 100\" = \"wanted\"\n";

#[test]
fn fuxa_imports_a_device() {
    check(
        FEW,
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
              }
            },
            "type": "ModbusTCP"
          }
        ]
        -- stderr
        warning: inputs and outputs without a place, which are left out: 3; `ladder tags pump.clad --map modbus` writes the lines for ladder.toml
    "#]],
    );
}

#[test]
fn node_red_imports_a_flow() {
    check(
        FEW,
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
            "adr": "100",
            "dataType": "HoldingRegister",
            "id": "9817b1ed5da63dde",
            "name": "holding 100..101 (40101..40102)",
            "quantity": "2",
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
            "y": 160,
            "z": "9817b1ed73e3430c"
          },
          {
            "func": "// holding 100..101 (40101..40102)\nconst read = msg.payload;\nconst bytes = (first, count) => {\n    const all = Buffer.alloc(2 * count);\n    for (let nth = 0; nth < count; nth++) all.writeUInt16BE(read[first + nth] & 0xffff, 2 * nth);\n    return all;\n};\nmsg.payload = {\n    \"wanted\": bytes(0, 2).readFloatBE(),  // holding 100 (40101)\n};\nreturn msg;\n",
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
            "y": 160,
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
            "y": 160,
            "z": "9817b1ed73e3430c"
          }
        ]
        -- stderr
        warning: inputs and outputs without a place, which are left out: 3; `ladder tags pump.clad --map modbus` writes the lines for ladder.toml
    "#]],
    );
}

#[test]
fn what_a_screen_has_no_type_for_is_left_out() {
    let folder = Folder::with(&[
        ("pump.clad", PUMP),
        (
            "ladder.toml",
            &SETTINGS.replace("unit", "words = \"little\"\nunit"),
        ),
    ]);
    let run = folder.ladder(&["tags", "pump.clad", "--map", "modbus", "--format", "fuxa"]);
    expect![[r#"
        warning: FUXA has no type for these tags: total
    "#]]
    .assert_eq(&run.stderr);
}

#[test]
fn check_tells_what_fits_no_program() {
    let folder = Folder::with(&[
        ("pump.clad", PUMP),
        ("motor.clad", MOTOR),
        ("ladder.toml", SETTINGS),
    ]);
    let check = |folder: &Folder| folder.ladder(&["check", "motor.clad"]).to_string();
    expect![[r#"
        exit status 0
        -- stdout
        Checked 1 file: no errors found.
    "#]]
    .assert_eq(&check(&folder));
    let device = "[[device]]\nname = \"rio\"\nmodbus = \"a:502\"\nread = { \"coil 0\" = \"gone\" }\n";
    folder.write(
        "ladder.toml",
        format!("{SETTINGS}\"holding 0\" = \"gone\"\n{device}").as_bytes(),
    );
    expect![[r#"
        exit status 1
        -- stdout
        error[bad-setting]: there is no tag `gone`; did you mean go?
          --> ladder.toml:11:1
           |
        11 | "holding 0" = "gone"
           | ^^^^^^^^^^^^^^^^^^^^

        error[bad-setting]: there is no tag `gone`; did you mean go?
          --> ladder.toml:15:10
           |
        15 | read = { "coil 0" = "gone" }
           |          ^^^^^^^^^^^^^^^^^

        Checked 1 file: 2 errors.
    "#]]
    .assert_eq(&check(&folder));
    for (format, expected) in [
        (
            "json",
            expect![[r#"
            exit status 1
            -- stdout
            [
              {"file":"ladder.toml","line":11,"column":1,"end_line":11,"end_column":21,"rule":"bad-setting","severity":"error","message":"there is no tag `gone`; did you mean go?"},
              {"file":"ladder.toml","line":15,"column":10,"end_line":15,"end_column":27,"rule":"bad-setting","severity":"error","message":"there is no tag `gone`; did you mean go?"}
            ]
        "#]],
        ),
        (
            "github",
            expect![[r#"
            exit status 1
            -- stdout
            ::error file=ladder.toml,line=11,col=1,endColumn=21,title=bad-setting::there is no tag `gone`; did you mean go?
            ::error file=ladder.toml,line=15,col=10,endColumn=27,title=bad-setting::there is no tag `gone`; did you mean go?
        "#]],
        ),
        (
            "concise",
            expect![[r#"
            exit status 1
            -- stdout
            ladder.toml:11:1: error[bad-setting] there is no tag `gone`; did you mean go?
            ladder.toml:15:10: error[bad-setting] there is no tag `gone`; did you mean go?
            Checked 1 file: 2 errors.
        "#]],
        ),
    ] {
        expected.assert_eq(
            &folder
                .ladder(&["check", "motor.clad", "--format", format])
                .to_string(),
        );
    }
    let sarif = folder
        .ladder(&["check", "motor.clad", "--format", "sarif"])
        .to_string();
    assert!(
        sarif.contains("\"ruleId\": \"bad-setting\"") && sarif.contains("\"startLine\": 11"),
        "{sarif}"
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
