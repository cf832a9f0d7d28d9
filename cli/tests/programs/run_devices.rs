//! `ladder run` with devices: inputs and outputs at the other end of a network.
#![cfg(feature = "run")]

use crate::harness::Folder;
use crate::real_time::Running;
#[cfg(unix)]
use crate::real_time::{asked, becomes};
use expect_test::expect;

/// What is at the other end: a valve that reports when it is open.
#[cfg(unix)]
const VALVE: &str = "VAR_INPUT\n    open : BOOL;\n    flow : REAL;\nEND_VAR\nVAR_OUTPUT\n    is_open AT %QX0.3 : BOOL;\nEND_VAR\n\
    +--[ ]( open )--[GT]( flow, 1.0 )--( )( is_open )--+\n";

#[cfg(unix)]
const SERVED: &str = "[serve.modbus]\nlisten = \"127.0.0.1:0\"\nwrite = [\"open\", \"flow\"]\n[serve.modbus.map]\n\"coil 0\" = \"open\"\n\"holding 5\" = \"flow\"\n";

const FILLER: &str = "VAR_INPUT\n    fill, rio_ok : BOOL;\nEND_VAR\nVAR_OUTPUT\n    flow : REAL := 0.5;\n    lamp : BOOL;\nEND_VAR\n\
    +--[ ]( rio_ok )--[ ]( fill )--( )( %QX10.0 )--[MOV]( flow, 2.5 )--+\n+--[ ]( %IX10.3 )--( )( lamp )--+\n";

#[cfg(unix)]
#[test]
fn a_program_works_through_another_one() {
    let valve = Folder::with(&[("valve.clad", VALVE), ("ladder.toml", SERVED)]);
    let mut valve = Running::new(&valve, &["run", "valve.clad"]);
    let address = valve.address();
    let wired = format!(
        "[serve.modbus]\nlisten = \"127.0.0.1:0\"\nwrite = \"fill\"\n[serve.modbus.map]\n\"coil 0\" = \"fill\"\n\"discrete 0\" = \"lamp\"\n\n\
         [[device]]\nname = \"rio\"\nmodbus = \"{address}\"\npoll = \"5ms\"\nok = \"rio_ok\"\n\
         read = {{ \"coil 0..7\" = \"%IX10.0\" }}\nwrite = {{ \"coil 0..7\" = \"%QX10.0\", \"holding 5\" = \"flow\" }}\n"
    );
    let folder = Folder::with(&[("filler.clad", FILLER), ("ladder.toml", &wired)]);
    let mut filler = Running::new(&folder, &["run", "filler.clad"]);
    let mut stream = filler.modbus();
    let told = filler
        .line_with("device rio at ")
        .replace(&address.to_string(), "ADDRESS");
    expect![[r#"
        note: device rio at ADDRESS: values read 1, written 2
    "#]]
    .assert_eq(&told);
    filler.line_with("device rio answers");
    assert_eq!(asked(&mut stream, &[5, 0, 0, 0xFF, 0]), [5, 0, 0, 0xFF, 0]);
    becomes(&mut stream, &[2, 0, 0, 0, 1], &[2, 1, 1]);
    // It is taken again, and goes on with the same device.
    filler.signal("-HUP");
    filler.line_with("filler.clad is taken again");
    assert_eq!(asked(&mut stream, &[5, 0, 0, 0xFF, 0]), [5, 0, 0, 0xFF, 0]);
    becomes(&mut stream, &[2, 0, 0, 0, 1], &[2, 1, 1]);
    filler.signal("-TERM");
    let (status, rest) = filler.ended();
    assert_eq!(status, Some(0), "{rest}");
    assert!(!rest.contains("device"), "{rest}");
    // The outputs are what they are before the program does anything.
    let mut stream = std::net::TcpStream::connect(address).unwrap();
    becomes(&mut stream, &[3, 0, 5, 0, 2], &[3, 4, 0x3F, 0, 0, 0]);
    becomes(&mut stream, &[1, 0, 0, 0, 4], &[1, 1, 0]);
    valve.signal("-INT");
    assert_eq!(valve.ended().0, Some(0));
}

#[test]
fn what_cannot_be_wired_is_refused() {
    let refused = |toml: &str| {
        let folder = Folder::with(&[("filler.clad", FILLER), ("ladder.toml", toml)]);
        let run = folder.ladder(&["run", "filler.clad", "--for", "1ms"]);
        assert_eq!(run.status, Some(2), "{run}");
        run.stderr.lines().skip(1).collect::<Vec<_>>().join("\n")
    };
    expect![[r#"
        error: ladder.toml:1:1: a device has `name`, for example name = "rio"
        ladder.toml:2:10: `192.168.1.20` is not an address with its port, for example "192.168.1.20:502"
        ladder.toml:3:8: a whole number from 0 to 255 is expected here
        ladder.toml:4:9: `write` is a table of places and tags, for example write = { "coil 0..7" = "%QX10.0", "holding 4" = "speed" }
        ladder.toml:5:1: a device has `read`, `write` or both, for example read = { "discrete 0..7" = "%IX10.0", "input 0" = "level" }
        ladder.toml:8:1: `reads` is not a setting in [device]: did you mean `read`?
        ladder.toml:9:1: there are two devices `A`
        ladder.toml:13:1: there are two devices `a`"#]].assert_eq(&refused(
        "[[device]]\nmodbus = \"192.168.1.20\"\nunit = 256\nwrite = \"speed\"\n[[device]]\nname = \"a\"\nmodbus = \"a:502\"\nreads = {}\n\
         [[device]]\nname = \"A\"\nmodbus = \"a:502\"\nread = {}\n[[device]]\nname = \"a\"\nmodbus = \"a:502\"\nread = {}\n",
    ));
    expect![[r#"
        error: ladder.toml:9:6: flow is REAL, and BOOL is needed here
        ladder.toml:11:1: fill is written by clients of [serve.modbus] already
        ladder.toml:12:1: lamp is an output: the program writes it
        ladder.toml:14:1: input 0 cannot be written: only coils and holding registers can"#]].assert_eq(&refused(
        "[serve.modbus]\nwrite = \"fill\"\n[serve.modbus.map]\n\"coil 0\" = \"fill\"\n\n[[device]]\nname = \"rio\"\nmodbus = \"a:502\"\n\
         ok = \"flow\"\n[device.read]\n\"coil 0\" = \"fill\"\n\"coil 1\" = \"lamp\"\n[device.write]\n\"input 0\" = \"flow\"\n",
    ));
}

#[test]
fn devices_are_left_alone_if_asked() {
    let toml = "[[device]]\nname = \"rio\"\nmodbus = \"a:502\"\nread = { \"coil 0\" = \"fill\" }\n";
    let folder = Folder::with(&[("filler.clad", FILLER), ("ladder.toml", toml)]);
    let run = folder.ladder(&["run", "filler.clad", "--no-devices", "--for", "1ms"]);
    assert_eq!(run.status, Some(0), "{run}");
    assert!(!run.stderr.contains("device rio"), "{run}");
}
