//! The guard before servers that answer badly, on real sockets.

use super::*;
use std::net::TcpListener;
use std::thread::JoinHandle;

/// A frame that asks who it is.
const LIST_IDENTITY: [u8; 24] = {
    let mut frame = [0; 24];
    frame[0] = 0x63;
    frame
};

const SHORT: Duration = Duration::from_millis(300);

/// A server that does something with its first connection.
fn server(act: impl FnOnce(TcpStream) + Send + 'static) -> (u16, JoinHandle<()>) {
    let listener = TcpListener::bind("127.0.0.1:0").expect("a port");
    let port = listener.local_addr().expect("an address").port();
    let work = move || act(listener.accept().expect("a connection").0);
    (port, std::thread::spawn(work))
}

/// What is told of an exchange with such a server, and how long it took.
fn exchange(
    bytes: usize,
    act: impl FnOnce(TcpStream) + Send + 'static,
) -> (Result<Vec<u8>, String>, Duration) {
    let (port, server) = server(act);
    let began = Instant::now();
    let terms = Terms::new(SHORT);
    terms.begin(SHORT, bytes);
    let mut guard = connector(terms.clone())("127.0.0.1", port, None).expect("a connection");
    let answer = guard.send(&LIST_IDENTITY).and_then(|()| guard.receive());
    let answer = answer.map_err(|_| terms.failure().expect("why it failed"));
    let took = began.elapsed();
    drop(guard);
    server.join().expect("a server without panic");
    (answer, took)
}

/// Answers with those bytes, and waits for the end.
fn says(bytes: Vec<u8>) -> impl FnOnce(TcpStream) + Send + 'static {
    move |mut stream| {
        let mut asked = [0; 24];
        stream.read_exact(&mut asked).expect("a question");
        let _ = stream.write_all(&bytes);
        let _ = stream.read(&mut asked);
    }
}

#[test]
fn an_answer() {
    assert_eq!(
        exchange(24, says(LIST_IDENTITY.to_vec())).0,
        Ok(LIST_IDENTITY.to_vec())
    );
}

#[test]
fn half_an_answer_and_none() {
    for answer in [
        Vec::new(),
        LIST_IDENTITY[..23].to_vec(),
        vec![0x63, 0, 0xFF, 0xFF],
    ] {
        let (answer, took) = exchange(24, says(answer));
        assert_eq!(answer, Err("does not answer in time".to_owned()));
        assert!(took < SHORT * 5, "{took:?}");
    }
}

#[test]
fn a_byte_now_and_then_does_not_prolong_it() {
    let (answer, took) = exchange(4096, |mut stream| {
        while stream.write_all(&[0x63]).is_ok() {
            std::thread::sleep(SHORT / 10);
        }
    });
    assert_eq!(answer, Err("does not answer in time".to_owned()));
    assert!(took < SHORT * 5, "{took:?}");
}

#[test]
fn more_than_was_agreed() {
    let mut large = vec![0; 24 + 60_000];
    large[..4].copy_from_slice(&[0x63, 0, 0x60, 0xEA]);
    assert_eq!(
        exchange(50_000, says(large)).0,
        Err("sends more than a controller has to tell".to_owned())
    );
    let two = [LIST_IDENTITY, LIST_IDENTITY].concat();
    assert_eq!(
        exchange(4096, says(two)).0,
        Err("sends more than it was asked for".to_owned())
    );
}

#[test]
fn an_answer_to_something_else() {
    let mut other = LIST_IDENTITY.to_vec();
    other[0] = 0x65;
    assert_eq!(
        exchange(4096, says(other)).0,
        Err("answers something that it was not asked".to_owned())
    );
}

#[test]
fn answers_on_a_connection_have_the_number_of_the_question() {
    let frame = |sequence: u8, service: u8| {
        let mut frame = vec![0; 50];
        (frame[0], frame[2], frame[44], frame[46]) = (0x70, 26, sequence, service);
        frame
    };
    let asked = frame(7, 0x4C);
    assert_eq!(belongs(&frame(7, 0xCC), &asked), Ok(()));
    for other in [frame(6, 0xCC), frame(7, 0xCD)] {
        assert_eq!(
            belongs(&other, &asked),
            Err("answers something that it was not asked".to_owned())
        );
    }
    assert_eq!(belongs(&frame(7, 0xCC)[..45], &asked), Err(CUT.to_owned()));
}

#[test]
fn a_closed_connection() {
    assert_eq!(exchange(4096, drop).0, Err(CLOSED.to_owned()));
}

#[test]
fn nothing_is_sent_of_a_refused_frame() {
    let (port, server) = server(|mut stream| {
        let mut received = Vec::new();
        let _ = stream.read_to_end(&mut received);
        assert_eq!(received, [0_u8; 0]);
    });
    let terms = Terms::new(SHORT);
    terms.begin(SHORT, 4096);
    let mut guard = connector(terms.clone())("127.0.0.1", port, None).expect("a connection");
    let mut write = LIST_IDENTITY.to_vec();
    write[0] = 0x64;
    assert!(guard.send(&write).is_err());
    assert_eq!(
        terms.failure().as_deref(),
        Some("was not asked: a frame that does not only read was kept from it (command 64)")
    );
    drop(guard);
    server.join().expect("a server without panic");
}

#[test]
fn nobody_there() {
    let port = {
        let listener = TcpListener::bind("127.0.0.1:0").expect("a port");
        listener.local_addr().expect("an address").port()
    };
    let terms = Terms::new(SHORT);
    terms.begin(SHORT, 4096);
    assert!(connector(terms.clone())("127.0.0.1", port, None).is_err());
    let why = terms.failure().expect("why it failed");
    assert!(
        why.starts_with(&format!(
            "cannot be reached: nothing listens on port {port} there"
        )),
        "{why}"
    );
}
