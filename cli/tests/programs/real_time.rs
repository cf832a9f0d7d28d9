//! `ladder run`: programs in real time, until a signal comes.
#![cfg(feature = "run")]

use crate::harness::{Folder, MOTOR};
use expect_test::expect;
use std::io::{BufRead, BufReader, Read, Write};
use std::net::{SocketAddr, TcpStream};
use std::process::{Child, ChildStderr, Stdio};
use std::time::Duration;

const PUMP: &str = "VAR_INPUT\n    go : BOOL;\nEND_VAR\nVAR_OUTPUT\n    on AT %QX0.3 : BOOL;\nEND_VAR\nVAR RETAIN\n    starts : INT;\nEND_VAR\n\
    +--[ ]( go )----------------------------------------------------------( )( on )--+\n\
    +--[P]( go )-----------------------------------------[ADD]( starts, starts, 1 )--+\n";

const SERVED: &str = "[simulate]\nretain = \"pump.retain\"\n\n[serve.modbus]\nlisten = \"127.0.0.1:0\"\nwrite = \"go\"\n\n[serve.modbus.map]\n\"coil 0\" = \"go\"\n\"holding 5\" = \"starts\"\n";

/// A run that goes on.
pub(crate) struct Running {
    child: Child,
    stderr: BufReader<ChildStderr>,
}

impl Drop for Running {
    /// A test that fails leaves no program that runs.
    fn drop(&mut self) {
        let _ = self.child.kill();
    }
}

impl Running {
    pub(crate) fn new(folder: &Folder, arguments: &[&str]) -> Running {
        let mut command = folder.command(env!("CARGO_BIN_EXE_ladder"), arguments);
        let mut child = command.stderr(Stdio::piped()).spawn().unwrap();
        let stderr = BufReader::new(child.stderr.take().unwrap());
        Running { child, stderr }
    }

    /// Reads until a line has these words.
    pub(crate) fn line_with(&mut self, words: &str) -> String {
        let mut line = String::new();
        while !line.contains(words) {
            line.clear();
            assert!(
                self.stderr.read_line(&mut line).unwrap() > 0,
                "no line has {words}"
            );
        }
        line
    }

    /// Where it serves Modbus.
    pub(crate) fn address(&mut self) -> SocketAddr {
        let line = self.line_with("Modbus is served on");
        let mut words = line.split(' ');
        let address = words.find_map(|word| word.strip_suffix(':')?.parse().ok());
        address.expect("an address")
    }

    pub(crate) fn modbus(&mut self) -> TcpStream {
        let stream = TcpStream::connect(self.address()).unwrap();
        stream.set_read_timeout(Some(Duration::from_secs(30))).unwrap();
        stream
    }

    #[cfg(unix)]
    pub(crate) fn signal(&self, name: &str) {
        let id = self.child.id().to_string();
        let sent = std::process::Command::new("kill")
            .args([name, &id])
            .status()
            .unwrap();
        assert!(sent.success());
    }

    pub(crate) fn ended(mut self) -> (Option<i32>, String) {
        let mut rest = String::new();
        self.stderr.read_to_string(&mut rest).unwrap();
        (self.child.wait().unwrap().code(), rest)
    }
}

/// What the server answers to a request: the bytes after the header.
pub(crate) fn asked(stream: &mut TcpStream, request: &[u8]) -> Vec<u8> {
    let mut frame = vec![0, 1, 0, 0, 0, request.len() as u8 + 1, 1];
    frame.extend(request);
    stream.write_all(&frame).unwrap();
    let mut header = [0; 7];
    stream.read_exact(&mut header).unwrap();
    let mut answer = vec![0; usize::from(header[5]) - 1];
    stream.read_exact(&mut answer).unwrap();
    answer
}

/// Asks until the answer is this one, as long as the slowest machine needs.
pub(crate) fn becomes(stream: &mut TcpStream, request: &[u8], answer: &[u8]) {
    let is_it = |stream: &mut TcpStream| {
        std::thread::sleep(Duration::from_millis(10));
        asked(stream, request) == answer
    };
    assert!(
        (0..3000).any(|_| is_it(stream)),
        "{request:?} is never answered by {answer:?}"
    );
}

const WRITE_GO: [u8; 5] = [5, 0, 0, 0xFF, 0];
const READ_ON: [u8; 5] = [1, 0, 3, 0, 1];
const READ_STARTS: [u8; 5] = [3, 0, 5, 0, 1];

#[cfg(unix)]
#[test]
fn a_client_starts_the_pump_and_a_signal_ends_the_run() {
    let folder = Folder::with(&[("pump.clad", PUMP), ("ladder.toml", SERVED)]);
    let mut running = Running::new(&folder, &["run", "pump.clad"]);
    let mut stream = running.modbus();
    assert_eq!(asked(&mut stream, &WRITE_GO), WRITE_GO);
    becomes(&mut stream, &READ_ON, &[1, 1, 1]);
    becomes(&mut stream, &READ_STARTS, &[3, 2, 0, 1]);
    // The program is edited and taken again: what is retentive stays, and the client sees the other program.
    folder.write("pump.clad", PUMP.replace("starts, 1 )", "starts, 5 )").as_bytes());
    running.signal("-HUP");
    running.line_with("pump.clad is taken again");
    assert_eq!(asked(&mut stream, &WRITE_GO), WRITE_GO);
    becomes(&mut stream, &READ_STARTS, &[3, 2, 0, 6]);
    // One that has errors is not taken.
    folder.write("pump.clad", b"+--[ ]( go )--( )( on --+\n");
    running.signal("-HUP");
    running.line_with("the program has errors, and the one that ran goes on");
    becomes(&mut stream, &READ_STARTS, &[3, 2, 0, 6]);
    running.signal("-USR1");
    running.line_with(" scans, ");
    running.signal("-TERM");
    let (status, rest) = running.ended();
    assert_eq!(status, Some(0), "{rest}");
    assert!(rest.contains(" scans, "), "{rest}");
    // And after a restart it is there again.
    folder.write("pump.clad", PUMP.as_bytes());
    let mut running = Running::new(&folder, &["run", "pump.clad", "--read-only"]);
    let mut stream = running.modbus();
    becomes(&mut stream, &READ_STARTS, &[3, 2, 0, 6]);
    assert_eq!(asked(&mut stream, &WRITE_GO), [0x85, 2]);
    running.signal("-INT");
    assert_eq!(running.ended().0, Some(0));
}

#[test]
fn it_says_what_it_is_not_and_ends_after_its_time() {
    let folder = Folder::with(&[("motor.clad", MOTOR)]);
    let run = folder.ladder(&["run", "motor.clad", "--for", "100ms", "--set", "start=1"]);
    assert_eq!(run.status, Some(0), "{run}");
    let told: Vec<&str> = run.stderr.lines().collect();
    let [first, second, last] = told[..] else {
        panic!("{run}")
    };
    expect!["note: this is a soft controller for tests and teaching, not a safety device: nothing that can hurt anybody may depend on it"].assert_eq(first);
    expect!["note: motor.clad runs every 10ms; Ctrl+C ends it"].assert_eq(second);
    assert!(last.contains(" missed; late: 50 % "), "{last}");
}

#[test]
fn faults_end_it() {
    let divides = "VAR\n    n, zero : INT;\nEND_VAR\n+--[DIV]( n, 7, zero )--+\n+--<CALL>( again )--+\n\n+--<FUN>( again )--<CALL>( again )--+\n+--<RET>--+\n";
    let folder = Folder::with(&[("a.clad", divides)]);
    let run = folder.ladder(&["run", "a.clad", "--for", "10s"]);
    assert_eq!(run.status, Some(1), "{run}");
    let ended = folder.ladder(&["run", "a.clad", "--for", "x"]);
    assert_eq!(ended.status, Some(2), "{ended}");
}

#[test]
fn what_cannot_be_served_is_refused() {
    let refused = |toml: &str| {
        let folder = Folder::with(&[("pump.clad", PUMP), ("motor.clad", MOTOR), ("ladder.toml", toml)]);
        let program = if toml.is_empty() {
            "motor.clad"
        } else {
            "pump.clad"
        };
        let run = folder.ladder(&["run", program, "--modbus", "127.0.0.1:0", "--for", "1ms"]);
        assert_eq!(run.status, Some(2), "{run}");
        run.stderr.lines().skip(1).collect::<Vec<_>>().join("\n")
    };
    expect!["error: there is nothing to serve on Modbus: no tag has a direct address such as %QX0.0, and [serve.modbus.map] in ladder.toml names none"].assert_eq(&refused(""));
    expect![[r#"
        error: ladder.toml:2:10: on is an output: the program writes it
        ladder.toml:5:1: on and go are both at coil 3
        ladder.toml:6:1: a place is a table and a number from 0, for example `holding 100`; the tables are coil, discrete, input and holding"#]].assert_eq(&refused("[serve.modbus]\nwrite = [\"on\", \"go\"]\n\n[serve.modbus.map]\n\"coil 3\" = \"go\"\n\"holding\" = \"starts\"\n"));
    expect![[r#"
        error: ladder.toml:2:8: units are numbers from 0 to 255, for example [1, 255]
        ladder.toml:3:10: `localhost` is not an address with a port, for example "127.0.0.1:1502"
        ladder.toml:4:9: `bigg` is not one of them: did you mean `big`?
        ladder.toml:5:1: `maps` is not a setting in [serve.modbus]: did you mean `map`?"#]]
    .assert_eq(&refused(
        "[serve.modbus]\nunit = 256\nlisten = \"localhost\"\nwords = \"bigg\"\nmaps = 1\n",
    ));
    expect!["error: ladder.toml:2:9: `192.168.1` is not a network; write an address and how many of its bits count, as in 192.168.1.0/24"].assert_eq(&refused("[serve.modbus]\nallow = \"192.168.1\"\n"));
}
