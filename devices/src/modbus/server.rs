//! The server: connections, their limits, and what each function asks of the image.

use super::image::{Image, Refused};
use super::place::Table;
use std::collections::HashSet;
use std::future::{Ready, ready};
use std::io;
use std::net::{IpAddr, Ipv4Addr, SocketAddr, TcpListener};
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::{Duration, Instant};
use tokio::sync::oneshot;
use tokio_io_timeout::TimeoutStream;
use tokio_modbus::server::Service;
use tokio_modbus::server::tcp::Server;
use tokio_modbus::{ExceptionCode, Request, Response, SlaveRequest};

/// Where it listens if nothing else is asked for: on this machine alone, and not on the port that needs a right.
pub const ADDRESS: SocketAddr = SocketAddr::new(IpAddr::V4(Ipv4Addr::LOCALHOST), 1502);

/// Who may ask, and how much.
#[derive(Debug, Clone)]
pub struct Rules {
    /// The units that answer; requests to others get exception 11.
    pub units: Vec<u8>,
    /// From where connections are taken; empty: from everywhere that reaches the address.
    pub allow: Vec<Subnet>,
    /// So many connections at once; further ones are closed.
    pub connections: usize,
    /// A connection that sends nothing for so long is closed.
    pub idle: Duration,
}

impl Default for Rules {
    fn default() -> Rules {
        Rules {
            units: vec![1, 255],
            allow: Vec::new(),
            connections: 16,
            idle: Duration::from_secs(60),
        }
    }
}

/// Addresses that have their first bits in common: `192.168.1.0/24`.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Subnet {
    network: IpAddr,
    bits: u8,
}

impl Subnet {
    /// Reads `192.168.1.0/24`, or a single address.
    ///
    /// # Errors
    /// It is neither.
    pub fn parse(text: &str) -> Result<Subnet, String> {
        let form = || {
            format!(
                "`{text}` is not a network; write an address and how many of its bits count, as in 192.168.1.0/24"
            )
        };
        let (network, bits) = text.split_once('/').unzip();
        let network: IpAddr = network.unwrap_or(text).trim().parse().map_err(|_| form())?;
        let most = if network.is_ipv4() { 32 } else { 128 };
        let bits = match bits {
            Some(bits) => bits
                .trim()
                .parse()
                .ok()
                .filter(|bits| *bits <= most)
                .ok_or_else(form)?,
            None => most,
        };
        Ok(Subnet { network, bits })
    }

    /// Whether an address is one of them.
    pub fn contains(&self, address: IpAddr) -> bool {
        let bits = u32::from(self.bits);
        match (self.network, address.to_canonical()) {
            (IpAddr::V4(network), IpAddr::V4(address)) => {
                let differs = network.to_bits() ^ address.to_bits();
                differs.checked_shr(32 - bits).unwrap_or(0) == 0
            }
            (IpAddr::V6(network), IpAddr::V6(address)) => {
                let differs = network.to_bits() ^ address.to_bits();
                differs.checked_shr(128 - bits).unwrap_or(0) == 0
            }
            _ => false,
        }
    }
}

/// A server that runs until this is dropped.
#[derive(Debug)]
pub struct Listening {
    /// Where it listens: the port that it got where 0 was asked for.
    pub address: SocketAddr,
    _ending: oneshot::Sender<()>,
}

/// Says something to the person who runs the program.
type Tell = Arc<dyn Fn(&str) + Send + Sync>;

/// Serves an image on a thread of its own.
///
/// # Errors
/// The address cannot be listened on, or there is no thread for it.
pub fn serve(
    address: SocketAddr,
    image: &Image,
    rules: Rules,
    tell: impl Fn(&str) + Send + Sync + 'static,
) -> io::Result<Listening> {
    let listener = TcpListener::bind(address)?;
    listener.set_nonblocking(true)?;
    let address = listener.local_addr()?;
    let runtime = tokio::runtime::Builder::new_current_thread()
        .enable_all()
        .build()?;
    let door = Arc::new(Door {
        rules,
        image: image.clone(),
        open: AtomicUsize::new(0),
        told: Mutex::default(),
        tell: Arc::new(tell),
    });
    let (ending, ended) = oneshot::channel();
    // Only its other end ends it, and that with nothing to say.
    let ended = async {
        let _ = ended.await;
    };
    let listen = move || {
        let listened = runtime.block_on(async {
            let listener = tokio::net::TcpListener::from_std(listener)?;
            let connected = |stream, from| ready(Ok(door.open(stream, from)));
            // What goes wrong with one connection ends that connection.
            Server::new(listener).serve_until(&connected, |_| {}, ended).await
        });
        if let Err(error) = listened {
            (door.tell)(&format!("the Modbus server has stopped: {error}"));
        }
    };
    std::thread::Builder::new()
        .name("modbus".to_owned())
        .spawn(listen)?;
    Ok(Listening {
        address,
        _ending: ending,
    })
}

/// What all connections share.
struct Door {
    rules: Rules,
    image: Image,
    open: AtomicUsize,
    /// What was told already: once for each client.
    told: Mutex<HashSet<(IpAddr, &'static str)>>,
    tell: Tell,
}

type Stream = std::pin::Pin<Box<TimeoutStream<tokio::net::TcpStream>>>;

impl Door {
    /// Takes a connection, or closes it.
    fn open(self: &Arc<Door>, stream: tokio::net::TcpStream, from: SocketAddr) -> Option<(Client, Stream)> {
        let from = from.ip();
        let is_allowed = self.rules.allow.is_empty() || self.rules.allow.iter().any(|own| own.contains(from));
        if !is_allowed {
            self.tell_once(from, "is not allowed to connect");
            return None;
        }
        let client = Client {
            door: self.clone(),
            from,
        };
        if self.open.fetch_add(1, Ordering::SeqCst) >= self.rules.connections {
            self.tell_once(from, "finds all connections taken");
            return None;
        }
        self.tell_once(from, "is connected");
        // Answers are small, and are waited for.
        let _ = stream.set_nodelay(true);
        let mut stream = TimeoutStream::new(stream);
        stream.set_read_timeout(Some(self.rules.idle));
        stream.set_write_timeout(Some(self.rules.idle));
        Some((client, Box::pin(stream)))
    }

    fn tell_once(&self, from: IpAddr, what: &'static str) {
        /// Who asks from ever new addresses does not fill the memory.
        const MOST_TOLD: usize = 1000;
        let mut told = self.told.lock().unwrap_or_else(PoisonError::into_inner);
        if told.len() < MOST_TOLD && told.insert((from, what)) {
            (self.tell)(&format!("Modbus client {from} {what}"));
        }
    }
}

/// One connection.
struct Client {
    door: Arc<Door>,
    from: IpAddr,
}

impl Drop for Client {
    fn drop(&mut self) {
        self.door.open.fetch_sub(1, Ordering::SeqCst);
    }
}

impl Service for Client {
    type Request = SlaveRequest<'static>;
    type Response = Response;
    type Exception = ExceptionCode;
    type Future = Ready<Result<Response, ExceptionCode>>;

    fn call(&self, request: SlaveRequest<'static>) -> Self::Future {
        ready(self.answer(&request))
    }
}

impl Client {
    fn answer(&self, SlaveRequest { slave, request }: &SlaveRequest<'_>) -> Result<Response, ExceptionCode> {
        if !self.door.rules.units.contains(slave) {
            self.door.tell_once(self.from, "asks for a unit that is not here");
            return Err(ExceptionCode::GatewayTargetDevice);
        }
        let read = |table, first, count| {
            self.door
                .image
                .read(table, first, count, Instant::now())
                .map_err(exception)
        };
        let bits = |table, first, count| -> Result<Vec<bool>, ExceptionCode> {
            Ok(read(table, first, count)?
                .into_iter()
                .map(|bit| bit != 0)
                .collect())
        };
        Ok(match request {
            Request::ReadCoils(first, count) => Response::ReadCoils(bits(Table::Coil, *first, *count)?),
            Request::ReadDiscreteInputs(first, count) => {
                Response::ReadDiscreteInputs(bits(Table::Discrete, *first, *count)?)
            }
            Request::ReadInputRegisters(first, count) => {
                Response::ReadInputRegisters(read(Table::Input, *first, *count)?)
            }
            Request::ReadHoldingRegisters(first, count) => {
                Response::ReadHoldingRegisters(read(Table::Holding, *first, *count)?)
            }
            Request::WriteSingleCoil(at, high) => {
                self.write(Table::Coil, *at, &[u16::from(*high)])?;
                Response::WriteSingleCoil(*at, *high)
            }
            Request::WriteMultipleCoils(first, values) => {
                let bits: Vec<u16> = values.iter().map(|high| u16::from(*high)).collect();
                self.write(Table::Coil, *first, &bits)?;
                Response::WriteMultipleCoils(*first, bits.len() as u16)
            }
            Request::WriteSingleRegister(at, word) => {
                self.write(Table::Holding, *at, &[*word])?;
                Response::WriteSingleRegister(*at, *word)
            }
            Request::WriteMultipleRegisters(first, words) => {
                self.write(Table::Holding, *first, words)?;
                Response::WriteMultipleRegisters(*first, words.len() as u16)
            }
            _ => return Err(ExceptionCode::IllegalFunction),
        })
    }

    fn write(&self, table: Table, first: u16, values: &[u16]) -> Result<(), ExceptionCode> {
        let written = self.door.image.write(table, first, values, Instant::now());
        let what = match written {
            Ok(()) => "writes",
            Err(_) => "writes what it may not",
        };
        self.door.tell_once(self.from, what);
        written.map_err(exception)
    }
}

fn exception(refused: Refused) -> ExceptionCode {
    match refused {
        Refused::Address => ExceptionCode::IllegalDataAddress,
        Refused::Value => ExceptionCode::IllegalDataValue,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn networks_are_an_address_and_its_bits() {
        let contains =
            |network: &str, address: &str| Subnet::parse(network).unwrap().contains(address.parse().unwrap());
        assert!(contains("192.168.1.0/24", "192.168.1.77"));
        assert!(!contains("192.168.1.0/24", "192.168.2.77"));
        assert!(contains("10.0.0.5", "10.0.0.5") && !contains("10.0.0.5", "10.0.0.6"));
        assert!(contains("0.0.0.0/0", "8.8.8.8") && !contains("0.0.0.0/0", "::1"));
        // As a socket for both kinds has it.
        assert!(contains("127.0.0.0/8", "::ffff:127.0.0.1"));
        assert!(contains("fe80::/10", "fe80::1") && !contains("fe80::/10", "::1"));
        for wrong in ["", "192.168.1.0/33", "192.168.1/24", "fe80::/129", "10.0.0.5/x"] {
            assert!(Subnet::parse(wrong).is_err(), "{wrong}");
        }
    }
}
