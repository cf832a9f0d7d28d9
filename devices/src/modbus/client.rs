//! A connection to what answers on Modbus TCP: blocks of places are read and written, one request after the other.

use super::blocks::Block;
use super::place::Table;
use std::borrow::Cow;
use std::fmt::Debug;
use std::io::ErrorKind;
use std::time::Duration;
use tokio::io::{AsyncRead, AsyncWrite};
use tokio::net::TcpStream;
use tokio::time::timeout;
use tokio_modbus::client::{Client as _, Context, tcp::attach_slave};
use tokio_modbus::{Error, ExceptionCode, Request, Response, Slave};

/// Why a request was not answered as it should be: words that follow what the other end is called.
#[derive(Debug, PartialEq, Eq)]
pub(super) enum Failed {
    /// It was refused; others may be answered.
    Refused(String),
    /// The connection is of no use any more.
    Lost(String),
}

/// A connection.
pub(super) struct Client {
    context: Context,
    unit: u8,
    /// An answer that has not come for so long does not come.
    patience: Duration,
}

/// Opens a connection.
///
/// # Errors
/// Nothing answers there: words that follow what it is called.
pub(super) async fn open(address: &str, patience: Duration) -> Result<TcpStream, String> {
    let stream = timeout(patience, TcpStream::connect(address)).await;
    let stream = stream
        .map_err(|_| format!("cannot be reached at {address} within {patience:?}"))?
        .map_err(|error| format!("cannot be reached at {address}: {error}"))?;
    // Requests are small, and their answers are waited for.
    let _ = stream.set_nodelay(true);
    Ok(stream)
}

impl Client {
    /// A client of a unit over a connection.
    pub(super) fn over<S>(stream: S, unit: u8, patience: Duration) -> Client
    where
        S: AsyncRead + AsyncWrite + Debug + Unpin + Send + 'static,
    {
        Client {
            context: attach_slave(stream, Slave(unit)),
            unit,
            patience,
        }
    }

    /// Reads the places of a block: words, bits as 0 and 1.
    pub(super) async fn read(&mut self, block: &Block) -> Result<Vec<u16>, Failed> {
        let (first, count) = (block.first.number, block.count as u16);
        let asked = match block.first.table {
            Table::Coil => Request::ReadCoils(first, count),
            Table::Discrete => Request::ReadDiscreteInputs(first, count),
            Table::Input => Request::ReadInputRegisters(first, count),
            Table::Holding => Request::ReadHoldingRegisters(first, count),
        };
        let words = match self.ask(block, asked).await? {
            Response::ReadCoils(bits) | Response::ReadDiscreteInputs(bits) => {
                bits.into_iter().map(u16::from).collect()
            }
            Response::ReadInputRegisters(words) | Response::ReadHoldingRegisters(words) => words,
            _ => Vec::new(),
        };
        // Bits come in whole bytes.
        if words.len() < block.count {
            return Err(Failed::Lost(format!(
                "answers with {} of the {} places of {block}",
                words.len(),
                block.count
            )));
        }
        Ok(words)
    }

    /// Writes the places of a block.
    pub(super) async fn write(&mut self, block: &Block, words: &[u16]) -> Result<(), Failed> {
        self.ask(block, request(block, words)).await.map(|_| ())
    }

    async fn ask(&mut self, block: &Block, request: Request<'_>) -> Result<Response, Failed> {
        match timeout(self.patience, self.context.call(request)).await {
            Err(_) => Err(Failed::Lost(format!(
                "does not answer within {:?}",
                self.patience
            ))),
            Ok(Ok(Ok(response))) => Ok(response),
            Ok(Ok(Err(exception))) => Err(Failed::Refused(format!(
                "refuses {block}: {}",
                self.reason(exception)
            ))),
            Ok(Err(Error::Protocol(_))) => Err(Failed::Lost(format!(
                "does not answer what it is asked for {block}"
            ))),
            Ok(Err(Error::Transport(error))) if error.kind() == ErrorKind::InvalidData => {
                Err(Failed::Lost(format!("answers what is not Modbus: {error}")))
            }
            // What the system says then is of something else if the other end has closed it in good order.
            Ok(Err(Error::Transport(_))) => Err(Failed::Lost("has closed the connection".to_owned())),
        }
    }

    fn reason(&self, exception: ExceptionCode) -> String {
        let code: u8 = exception.into();
        let unit = self.unit;
        let why = match code {
            1 => "it does not know the function".to_owned(),
            2 => "it has no such places; numbers count from 0 here".to_owned(),
            3 => "it does not take the value, or so many at once".to_owned(),
            4 => "it has failed".to_owned(),
            6 => "it is busy".to_owned(),
            10 | 11 => format!("nothing answers as unit {unit} beyond the gateway"),
            _ => exception.to_string(),
        };
        format!("{why} (exception {code})")
    }
}

/// A single place has a function of its own: some devices know no other.
fn request<'w>(block: &Block, words: &'w [u16]) -> Request<'w> {
    let first = block.first.number;
    match (block.first.table.is_of_bits(), words) {
        (true, [bit]) => Request::WriteSingleCoil(first, *bit != 0),
        (true, bits) => Request::WriteMultipleCoils(first, bits.iter().map(|bit| *bit != 0).collect()),
        (false, [word]) => Request::WriteSingleRegister(first, *word),
        (false, words) => Request::WriteMultipleRegisters(first, Cow::Borrowed(words)),
    }
}
