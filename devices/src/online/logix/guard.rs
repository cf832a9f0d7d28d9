//! The only socket to a Logix controller. Frames that do more than read are refused before a byte is sent; answers are waited for
//! no longer, and are no larger, than was agreed.

use super::allowed::{SEND_RR_DATA, SEND_UNIT_DATA, check};
use ciplink::transport::{Connector, HEADER_SIZE, Transport};
use std::io::{self, ErrorKind, Read, Write};
use std::net::{TcpStream, ToSocketAddrs};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};
use std::time::{Duration, Instant};

/// How much is read at once.
const CHUNK: usize = 4096;

/// Where the sequence count is in frames on a connection, and where the service comes after it.
const SEQUENCE: std::ops::Range<usize> = 44..46;
const SERVICE: usize = 46;

/// What was agreed for all connections of a controller, and why the last one failed.
#[derive(Debug, Clone)]
pub(super) struct Terms(Arc<Mutex<State>>);

#[derive(Debug)]
struct State {
    /// How long one answer may take.
    exchange: Duration,
    /// When everything must be over.
    until: Instant,
    /// How many bytes may still come.
    left: usize,
    failure: Option<String>,
}

impl Terms {
    pub(super) fn new(exchange: Duration) -> Terms {
        Terms(Arc::new(Mutex::new(State {
            exchange,
            until: Instant::now(),
            left: 0,
            failure: None,
        })))
    }

    /// From now on: how long everything may take, and how many bytes may come.
    pub(super) fn begin(&self, total: Duration, bytes: usize) {
        let mut state = self.lock();
        state.until = Instant::now() + total.max(state.exchange);
        state.left = bytes;
        state.failure = None;
    }

    /// Why the connection was lost, if it was.
    pub(super) fn failure(&self) -> Option<String> {
        self.lock().failure.take()
    }

    /// Keeps why it failed first: the driver tells only that it did, and closes in vain what is lost.
    fn failed(&self, why: String) -> ciplink::Error {
        let error = ciplink::Error::comm(why.clone());
        self.lock().failure.get_or_insert(why);
        error
    }

    /// When the answer to what is asked now must be there.
    fn due(&self) -> Instant {
        let state = self.lock();
        state.until.min(Instant::now() + state.exchange)
    }

    fn spend(&self, bytes: usize) -> Result<(), String> {
        let mut state = self.lock();
        state.left = (state.left.checked_sub(bytes)).ok_or("sends more than a controller has to tell")?;
        Ok(())
    }

    fn lock(&self) -> MutexGuard<'_, State> {
        self.0.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// Opens guarded connections.
pub(super) fn connector(terms: Terms) -> Connector {
    Box::new(move |host, port, _| {
        let stream = connect((host, port), &terms).map_err(|why| terms.failed(why))?;
        Ok(Box::new(Guard {
            stream,
            terms: terms.clone(),
            asked: Vec::new(),
            due: Instant::now(),
            received: Vec::new(),
        }))
    })
}

struct Guard {
    stream: TcpStream,
    terms: Terms,
    /// The last frame that was sent, up to its service, and when its answer must be there.
    asked: Vec<u8>,
    due: Instant,
    received: Vec<u8>,
}

impl Transport for Guard {
    fn send(&mut self, frame: &[u8]) -> ciplink::Result<()> {
        check(frame)
            .map_err(|why| format!("was not asked: a frame that does not only read was kept from it ({why})"))
            .and_then(|()| self.write(frame))
            .map_err(|why| self.terms.failed(why))
    }

    fn receive(&mut self) -> ciplink::Result<Vec<u8>> {
        self.answer().map_err(|why| self.terms.failed(why))
    }

    /// Times are agreed in [`Terms`].
    fn set_timeout(&mut self, _: Option<Duration>) -> ciplink::Result<()> {
        Ok(())
    }
}

impl Guard {
    fn write(&mut self, frame: &[u8]) -> Result<(), String> {
        self.due = self.terms.due();
        self.asked.clear();
        self.asked.extend(frame.iter().take(SERVICE + 1));
        let mut rest = frame;
        while !rest.is_empty() {
            self.stream
                .set_write_timeout(Some(left(self.due)?))
                .map_err(lost)?;
            match self.stream.write(rest) {
                Ok(0) => return Err(CLOSED.to_owned()),
                Ok(count) => rest = &rest[count..],
                Err(error) if error.kind() == ErrorKind::Interrupted => {}
                Err(error) => return Err(lost(error)),
            }
        }
        Ok(())
    }

    fn answer(&mut self) -> Result<Vec<u8>, String> {
        let mut chunk = [0; CHUNK];
        loop {
            if let Some(length) = self.received.get(2..4) {
                let whole = HEADER_SIZE + usize::from(u16::from_le_bytes([length[0], length[1]]));
                if self.received.len() > whole {
                    return Err("sends more than it was asked for".to_owned());
                }
                if self.received.len() == whole {
                    let answer = std::mem::take(&mut self.received);
                    return belongs(&answer, &self.asked).map(|()| answer);
                }
            }
            self.stream
                .set_read_timeout(Some(left(self.due)?))
                .map_err(lost)?;
            match self.stream.read(&mut chunk) {
                Ok(0) => return Err(CLOSED.to_owned()),
                Ok(count) => {
                    self.terms.spend(count)?;
                    self.received.extend(&chunk[..count]);
                }
                Err(error) if error.kind() == ErrorKind::Interrupted => {}
                Err(error) => return Err(lost(error)),
            }
        }
    }
}

/// Whether an answer is to what was asked: to another question its values would be those of other tags.
fn belongs(answer: &[u8], asked: &[u8]) -> Result<(), String> {
    let of_other = || Err("answers something that it was not asked".to_owned());
    if answer.get(..2) != asked.get(..2) {
        return of_other();
    }
    let command = u16::from_le_bytes([answer[0], answer[1]]);
    let has_failed = answer.get(8..12).is_some_and(|status| status != [0; 4]);
    if has_failed || !matches!(command, SEND_RR_DATA | SEND_UNIT_DATA) {
        return Ok(());
    }
    if command == SEND_RR_DATA {
        // Through an Unconnected Send it may be the controller or a module on the way that answers.
        return if answer.len() >= 44 {
            Ok(())
        } else {
            Err(CUT.to_owned())
        };
    }
    let (Some(service), Some(sequence)) = (answer.get(SERVICE), answer.get(SEQUENCE)) else {
        return Err(CUT.to_owned());
    };
    let is_right =
        Some(sequence) == asked.get(SEQUENCE) && asked.get(SERVICE).is_some_and(|it| *service == it | 0x80);
    if is_right { Ok(()) } else { of_other() }
}

const CLOSED: &str = "has closed the connection";
const CUT: &str = "sends half an answer";

/// How long there is until then.
fn left(due: Instant) -> Result<Duration, String> {
    let left = due.saturating_duration_since(Instant::now());
    if left.is_zero() {
        Err("does not answer in time".to_owned())
    } else {
        Ok(left)
    }
}

fn lost(error: io::Error) -> String {
    match error.kind() {
        ErrorKind::WouldBlock | ErrorKind::TimedOut => "does not answer in time".to_owned(),
        ErrorKind::ConnectionReset | ErrorKind::ConnectionAborted | ErrorKind::BrokenPipe => {
            CLOSED.to_owned()
        }
        _ => format!("cannot be reached any more: {error}"),
    }
}

fn connect(to: (&str, u16), terms: &Terms) -> Result<TcpStream, String> {
    let addresses = to
        .to_socket_addrs()
        .map_err(|error| format!("cannot be reached: the network does not know that name ({error})"))?;
    let due = terms.due();
    let mut why = "cannot be reached: the network does not know that name".to_owned();
    for address in addresses {
        match TcpStream::connect_timeout(&address, left(due)?) {
            Ok(stream) => {
                // Requests are small, and their answers are waited for.
                let _ = stream.set_nodelay(true);
                return Ok(stream);
            }
            Err(error) => why = unreachable(&error, to.1),
        }
    }
    Err(why)
}

fn unreachable(error: &io::Error, port: u16) -> String {
    match error.kind() {
        ErrorKind::ConnectionRefused => {
            format!(
                "cannot be reached: nothing listens on port {port} there; check the address (EtherNet/IP has port 44818)"
            )
        }
        ErrorKind::WouldBlock | ErrorKind::TimedOut => {
            "cannot be reached in time: check the address, the cable and the network".to_owned()
        }
        _ => format!("cannot be reached: {error}"),
    }
}

#[cfg(test)]
mod tests;
