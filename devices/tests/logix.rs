//! A Logix controller from the address to values, without one: what a peer that others wrote has answered is answered again.
//!
//! `LADDER_LOGIX_HOST=127.0.0.1:PORT cargo test -p ladder-devices --test logix` asks `tests/conformance/logix_host.py` instead,
//! and writes what both send to `tests/recordings/`.
#![cfg(feature = "logix")]

use expect_test::expect_file;
use ladder_devices::online::logix::Logix;
use ladder_devices::online::{Found, Source, Wanted};
use ladder_simulator::{Options, Simulation};
use proptest::prelude::*;
use std::fmt::Write as _;
use std::io::{Read, Write as _};
use std::net::{TcpListener, TcpStream};
use std::path::PathBuf;
use std::sync::Arc;
use std::thread::JoinHandle;
use std::time::Duration;

const PATIENCE: Duration = Duration::from_secs(10);

/// The program whose values are wanted. `missing` is not in the controller, `tall` is too large for its type here.
const PROGRAM: &str = "\
# ladder: profile logix #
TYPE
    TIMER : STRUCT
        PRE : DINT;
        ACC : DINT;
        EN  : BOOL;
        TT  : BOOL;
        DN  : BOOL;
    END_STRUCT;
    Motor : STRUCT
        speed   : REAL;
        cmd     : INT;
        running : BOOL;
        fault   : BOOL;
        past    : ARRAY[0..3] OF INT;
        delay   : TIMER;
        flags   : ARRAY[0..63] OF BOOL;
    END_STRUCT;
    Closed : STRUCT
        open : DINT;
    END_STRUCT;
    Line : STRUCT
        number : SINT;
        motors : ARRAY[0..1] OF Motor;
    END_STRUCT;
END_TYPE
VAR
    start, run, missing : BOOL;
    level  : REAL;
    exact  : LREAL;
    count  : DINT;
    small  : SINT;
    tall   : SINT;
    wide   : LINT;
    short  : USINT;
    table  : ARRAY[0..1999] OF DINT;
    grid   : ARRAY[0..1, 0..2] OF INT;
    lamps  : ARRAY[0..63] OF BOOL;
    recipe : STRING[82];
    warmup : TON;
    pieces : CTU;
    pump   : Motor;
    lines  : ARRAY[0..3] OF Line;
    safe   : Closed;
    step   : DINT;
END_VAR
+--[ ]( start )--[TON]( warmup, T#5s )--( )( run )--+
+--[ ]( start )--[CTU]( pieces, 10 )--( )( missing )--+
";

/// What is wanted of it: a name in the program, and the name in the controller where that is another.
const WANTED: [(&str, &str); 37] = [
    ("start", ""),
    ("run", ""),
    ("missing", ""),
    ("level", "LEVEL"),
    ("exact", ""),
    ("count", ""),
    ("count.0", ""),
    ("count.2", ""),
    ("small", ""),
    ("tall", ""),
    ("wide", ""),
    ("short", "BYTE"),
    ("table[3]", ""),
    ("table[300]", ""),
    ("grid[1, 2]", ""),
    ("lamps[5]", ""),
    ("lamps[6]", ""),
    ("lamps[63]", ""),
    ("recipe", ""),
    ("warmup.PT", ""),
    ("warmup.ET", ""),
    ("warmup.IN", ""),
    ("warmup.TT", ""),
    ("warmup.Q", ""),
    ("pieces.PV", ""),
    ("pieces.CV", "pieces.acc"),
    ("pieces.Q", ""),
    ("pump.speed", ""),
    ("pump.running", ""),
    ("pump.fault", ""),
    ("pump.past[3]", ""),
    ("pump.delay.DN", ""),
    ("pump.flags[35]", ""),
    ("lines[2].motors[1].cmd", ""),
    ("safe.open", ""),
    ("step", ""),
    ("step", "Program:Other.step"),
];

fn wanted() -> Vec<Wanted> {
    let analysis = ladder_analysis::analyze(&Arc::new(ladder_syntax::parse(PROGRAM)), "program");
    let program = analysis.program().expect("a program without errors").clone();
    let simulation = Simulation::new(program, Options::default()).expect("a program that runs");
    let wanted = WANTED.iter().map(|(own, name)| Wanted {
        point: simulation.resolve(own).expect("a value of the program"),
        name: (if name.is_empty() { own } else { name }).to_string(),
    });
    wanted.collect()
}

/// Everything that is found and read, on a connection and on the next one.
fn session(address: &str) -> String {
    let program = Some("Main".to_owned());
    let mut logix = Logix::new(address, program, wanted(), PATIENCE).expect("an address");
    let once = |logix: &mut Logix| {
        (
            logix.connect().expect("a connection"),
            logix.read().expect("values"),
        )
    };
    let (found, values) = once(&mut logix);
    assert_eq!(once(&mut logix), (found.clone(), values.clone()));
    let mut text = String::new();
    for ((own, name), (found, value)) in WANTED.iter().zip(found.iter().zip(values)) {
        let _ = write!(text, "{own} {name}: ");
        let _ = match (found, value) {
            (Found::Here, Some(value)) => writeln!(text, "{value:?}"),
            (found, value) => writeln!(text, "{found:?} {value:?}"),
        };
    }
    text
}

/// A conversation: `+` is a connection, after each `>` is a frame that was sent, after each `<` one that was answered.
struct Recording(PathBuf);

impl Recording {
    fn of(name: &str) -> Recording {
        Recording(PathBuf::from(env!("CARGO_MANIFEST_DIR")).join(format!("tests/recordings/{name}.txt")))
    }

    fn text(&self) -> String {
        std::fs::read_to_string(&self.0).expect("a recording")
    }

    /// A port where it is played, to one who sends the same frames.
    fn play(&self) -> (u16, JoinHandle<()>) {
        let text = self.text();
        let (listener, port) = listen();
        let thread = std::thread::spawn(move || {
            let mut stream = None;
            for line in text.lines() {
                let (direction, frame) = (&line[..1], bytes(line[1..].trim()));
                if direction == "+" {
                    stream = Some(listener.accept().expect("a connection").0);
                }
                let stream = stream.as_mut().expect("a connection first");
                match direction {
                    ">" => {
                        let sent = receive(stream).expect("a frame");
                        assert_eq!(hex(&comparable(sent)), hex(&comparable(frame)));
                    }
                    _ => stream.write_all(&frame).expect("a client that reads"),
                }
            }
        });
        (port, thread)
    }

    /// A port from which so many conversations with a host are passed on, and written.
    fn record(&self, host: String, connections: usize) -> (u16, JoinHandle<()>) {
        let (listener, port) = listen();
        let path = self.0.clone();
        let thread = std::thread::spawn(move || {
            let mut text = String::new();
            for _ in 0..connections {
                let mut client = listener.accept().expect("a connection").0;
                let mut server = TcpStream::connect(&host).expect("the host");
                text += "+\n";
                while let Some(frame) = receive(&mut client) {
                    let _ = writeln!(text, "> {}", hex(&frame));
                    server.write_all(&frame).expect("a host that reads");
                    // The end of a session is not answered.
                    if frame[0] == 0x66 {
                        break;
                    }
                    let answer = receive(&mut server).expect("an answer");
                    let _ = writeln!(text, "< {}", hex(&answer));
                    client.write_all(&answer).expect("a client that reads");
                }
            }
            std::fs::write(path, text).expect("a recording");
        });
        (port, thread)
    }
}

fn listen() -> (TcpListener, u16) {
    let listener = TcpListener::bind("127.0.0.1:0").expect("a port");
    let port = listener.local_addr().expect("an address").port();
    (listener, port)
}

fn receive(stream: &mut TcpStream) -> Option<Vec<u8>> {
    let mut frame = vec![0; 24];
    stream.read_exact(&mut frame).ok()?;
    let length = usize::from(u16::from_le_bytes([frame[2], frame[3]]));
    frame.resize(24 + length, 0);
    stream.read_exact(&mut frame[24..]).ok()?;
    Some(frame)
}

/// Without the numbers of a connection, which are drawn by lot.
fn comparable(mut frame: Vec<u8>) -> Vec<u8> {
    if frame[0] == 0x6F && matches!(frame[40], 0x54 | 0x5B) {
        frame[52..66].fill(0);
    }
    if frame[0] == 0x6F && frame[40] == 0x4E {
        frame[48..56].fill(0);
    }
    frame
}

fn hex(bytes: &[u8]) -> String {
    bytes.iter().fold(String::new(), |mut text, byte| {
        let _ = write!(text, "{byte:02x}");
        text
    })
}

fn bytes(hex: &str) -> Vec<u8> {
    let byte = |at| u8::from_str_radix(&hex[at..at + 2], 16).expect("hexadecimal digits");
    (0..hex.len()).step_by(2).map(byte).collect()
}

fn check(name: &str, host: &str, slot: u8) -> Recording {
    let recording = Recording::of(name);
    let (port, peer) = match std::env::var(host) {
        Ok(host) => recording.record(host, 2),
        Err(_) => recording.play(),
    };
    // Large or small, the values are the same.
    expect_file!["recordings/values.txt"].assert_eq(&session(&format!("127.0.0.1:{port}/{slot}")));
    peer.join().expect("all was as then");
    recording
}

/// How many requests to open connections with large packets it has.
fn large_openings(recording: &Recording) -> usize {
    let text = recording.text();
    let frames = text.lines().filter_map(|line| line.strip_prefix("> ")).map(bytes);
    frames
        .filter(|frame| frame[0] == 0x6F && frame[40] == 0x5B)
        .count()
}

#[test]
fn values_of_a_controller() {
    let recording = check("large", "LADDER_LOGIX_HOST", 0);
    assert_eq!(large_openings(&recording), 2);
}

/// Old processors refuse large packets: everything comes in many small ones. They are asked once.
#[test]
fn values_of_an_old_controller() {
    let recording = check("small", "LADDER_LOGIX_SMALL_HOST", 3);
    assert_eq!(large_openings(&recording), 1);
}

/// What is told of a controller that refuses services of its connection manager.
fn refusing(services: &'static [u8]) -> String {
    let text = Recording::of("large").text();
    let (listener, port) = listen();
    let server = std::thread::spawn(move || {
        let mut stream = listener.accept().expect("a connection").0;
        let mut answers = text.lines().filter_map(|line| line.strip_prefix("< ")).map(bytes);
        while let Some(asked) = receive(&mut stream).filter(|asked| asked[0] != 0x66) {
            let answer = if asked[0] == 0x6F && services.contains(&asked[40]) {
                let mut answer = asked[..40].to_vec();
                (answer[2], answer[3], answer[38], answer[39]) = (20, 0, 4, 0);
                answer.extend([asked[40] | 0x80, 0, 1, 0]);
                answer
            } else {
                answers.next().expect("an answer")
            };
            stream.write_all(&answer).expect("a client that reads");
        }
    });
    let mut logix = Logix::new(&format!("127.0.0.1:{port}"), None, wanted(), PATIENCE).expect("an address");
    let why = logix.connect().expect_err("a refusal");
    drop(logix);
    server.join().expect("a server without panic");
    why
}

#[test]
fn a_slot_without_a_controller() {
    let why = "answers, but not as a controller does: check the slot of the processor";
    assert_eq!(refusing(&[0x52]), why);
}

#[test]
fn a_controller_with_too_many_connections() {
    let why = "takes no more connections: end other programs that are connected to it";
    assert_eq!(refusing(&[0x54, 0x5B]), why);
}

/// A controller whose answers are not what they were: bytes changed, cut, or more of them.
fn hostile(changes: Vec<(usize, usize, u8)>, length: Option<(usize, u16)>) {
    let text = Recording::of("large").text();
    let mut answers: Vec<Vec<u8>> = text
        .lines()
        .filter_map(|line| line.strip_prefix("< "))
        .map(bytes)
        .collect();
    for (answer, at, byte) in changes {
        let count = answers.len();
        let answer = &mut answers[answer % count];
        let at = at % answer.len();
        answer[at] = byte;
    }
    if let Some((answer, length)) = length {
        let count = answers.len();
        let answer = &mut answers[answer % count];
        answer.resize(24 + usize::from(length), 0xFF);
        answer[2..4].copy_from_slice(&length.to_le_bytes());
    }
    let (listener, port) = listen();
    let server = std::thread::spawn(move || {
        let mut stream = listener.accept().expect("a connection").0;
        let mut answers = answers.into_iter().cycle();
        while receive(&mut stream).is_some() {
            if stream.write_all(&answers.next().expect("an answer")).is_err() {
                break;
            }
        }
    });
    let timeout = Duration::from_millis(50);
    let mut logix = Logix::new(&format!("127.0.0.1:{port}"), None, wanted(), timeout).expect("an address");
    if logix.connect().is_ok() {
        let _ = logix.read();
    }
    drop(logix);
    // Whoever is not connected to has nothing to end.
    let _ = TcpStream::connect(("127.0.0.1", port));
    server.join().expect("a server without panic");
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 64, ..ProptestConfig::default() })]

    #[test]
    fn answers_that_are_wrong(
        changes in proptest::collection::vec((any::<usize>(), any::<usize>(), any::<u8>()), 0..6),
        length in proptest::option::of((any::<usize>(), any::<u16>())),
    ) {
        hostile(changes, length);
    }
}
