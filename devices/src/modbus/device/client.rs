//! The task of a device: it connects, asks again and again, and tries again when there is no answer.

use super::Device;
use super::exchange::{Exchange, Plan};
use crate::modbus::blocks::Block;
use crate::modbus::place::Table;
use std::borrow::Cow;
use std::io::ErrorKind;
use std::sync::Arc;
use std::time::{Duration, Instant};
use tokio::net::TcpStream;
use tokio::sync::watch;
use tokio::time::{MissedTickBehavior, interval, timeout};
use tokio_modbus::client::{Client as _, Context, tcp::attach_slave};
use tokio_modbus::{Error, ExceptionCode, Request, Response, Slave};

/// Says something to the person who runs the program.
pub(super) type Tell = Arc<dyn Fn(&str) + Send + Sync>;

/// After a failure it is tried again after the first time, and after twice as long each time up to the last.
const WAITS: [Duration; 2] = [Duration::from_secs(1), Duration::from_secs(60)];

/// Serves a device until the end is asked for.
pub(super) async fn attend(
    device: &Device,
    exchange: &Exchange,
    mut ending: watch::Receiver<bool>,
    tell: &Tell,
) {
    let mut line = Line {
        device,
        exchange,
        tell,
        told: String::new(),
        wait: WAITS[0],
    };
    while !*ending.borrow() {
        let connected = tokio::select! {
            connected = line.connect() => connected,
            () = end_of(&mut ending) => return,
        };
        let failed = match connected {
            Ok(mut client) => line.exchange(&mut client, &mut ending).await,
            Err(failed) => Err(failed),
        };
        exchange.lost();
        let Err(failed) = failed else { return };
        line.tell(&format!("{failed}; it is tried again"));
        let _ = timeout(line.wait, end_of(&mut ending)).await;
        line.wait = (line.wait * 2).min(WAITS[1]);
    }
}

/// Comes back when the end is asked for.
async fn end_of(ending: &mut watch::Receiver<bool>) {
    // Who asks is gone, too, when the run has ended.
    let _ = ending.wait_for(|is_ending| *is_ending).await;
}

struct Line<'d> {
    device: &'d Device,
    exchange: &'d Exchange,
    tell: &'d Tell,
    /// What was told last.
    told: String,
    /// How long to wait after the next failure.
    wait: Duration,
}

/// What was written last on this connection, and when.
struct Written {
    plan: Arc<Plan>,
    words: Vec<u16>,
    at: Instant,
}

impl Line<'_> {
    /// One line for each change: that it answers, or why it does not.
    fn tell(&mut self, what: &str) {
        let line = format!("device {} {what}", self.device.name);
        if line != self.told {
            (self.tell)(&line);
            self.told = line;
        }
    }

    async fn connect(&self) -> Result<Context, String> {
        let address = &self.device.address;
        let stream = timeout(self.device.timeout, TcpStream::connect(address)).await;
        let stream = stream
            .map_err(|_| format!("cannot be reached at {address} within {:?}", self.device.timeout))?
            .map_err(|error| format!("cannot be reached at {address}: {error}"))?;
        // Requests are small, and their answers are waited for.
        let _ = stream.set_nodelay(true);
        Ok(attach_slave(stream, Slave(self.device.unit)))
    }

    /// Exchanges values until the end is asked for. Outputs are written only after everything was read once.
    async fn exchange(
        &mut self,
        client: &mut Context,
        ending: &mut watch::Receiver<bool>,
    ) -> Result<(), String> {
        let mut poll = interval(self.device.poll);
        // What is late is not caught up: a slow device would never be left alone.
        poll.set_missed_tick_behavior(MissedTickBehavior::Delay);
        let mut written = None;
        let mut has_answered = false;
        loop {
            tokio::select! {
                _ = poll.tick() => {}
                () = end_of(ending) => {
                    let plan = self.exchange.plan();
                    if let Some(outputs) = self.exchange.outputs(&plan).filter(|_| has_answered) {
                        self.write(client, &plan, outputs, &mut written).await?;
                    }
                    return Ok(());
                }
            }
            let plan = self.exchange.plan();
            let mut read = Vec::new();
            for block in &plan.read_blocks {
                let words = self.read(client, block).await?;
                for entry in &plan.reads[block.entries.clone()] {
                    let from = usize::from(entry.place.number - block.first.number);
                    read.extend(&words[from..from + entry.width]);
                }
            }
            if let Some(outputs) = self.exchange.swap(&plan, read) {
                self.write(client, &plan, outputs, &mut written).await?;
            } else if plan.read_blocks.is_empty() {
                // Nothing was asked yet.
                continue;
            }
            has_answered = true;
            self.exchange.answered();
            self.wait = WAITS[0];
            self.tell("answers");
        }
    }

    /// Writes the blocks that have changed, or all if that has not been done for long.
    async fn write(
        &self,
        client: &mut Context,
        plan: &Arc<Plan>,
        outputs: Vec<u16>,
        written: &mut Option<Written>,
    ) -> Result<(), String> {
        let now = Instant::now();
        let before = written
            .as_ref()
            .filter(|written| Arc::ptr_eq(&written.plan, plan) && now - written.at < self.device.repeat);
        let mut first = 0;
        for block in &plan.write_blocks {
            let own = first..first + block.count;
            first = own.end;
            let words = &outputs[own.clone()];
            if before.is_none_or(|before| before.words[own] != *words) {
                self.request(client, block, request(block, words)).await?;
            }
        }
        *written = Some(Written {
            plan: plan.clone(),
            words: outputs,
            at: before.map_or(now, |before| before.at),
        });
        Ok(())
    }

    async fn read(&self, client: &mut Context, block: &Block) -> Result<Vec<u16>, String> {
        let (first, count) = (block.first.number, block.count as u16);
        let asked = match block.first.table {
            Table::Coil => Request::ReadCoils(first, count),
            Table::Discrete => Request::ReadDiscreteInputs(first, count),
            Table::Input => Request::ReadInputRegisters(first, count),
            Table::Holding => Request::ReadHoldingRegisters(first, count),
        };
        let words = match self.request(client, block, asked).await? {
            Response::ReadCoils(bits) | Response::ReadDiscreteInputs(bits) => {
                bits.into_iter().map(u16::from).collect()
            }
            Response::ReadInputRegisters(words) | Response::ReadHoldingRegisters(words) => words,
            _ => Vec::new(),
        };
        // Bits come in whole bytes.
        if words.len() < block.count {
            return Err(format!(
                "answers with {} of the {} places of {block}",
                words.len(),
                block.count
            ));
        }
        Ok(words)
    }

    async fn request(
        &self,
        client: &mut Context,
        block: &Block,
        request: Request<'_>,
    ) -> Result<Response, String> {
        let answer = timeout(self.device.timeout, client.call(request)).await;
        match answer {
            Err(_) => Err(format!("does not answer within {:?}", self.device.timeout)),
            Ok(Ok(Ok(response))) => Ok(response),
            Ok(Ok(Err(exception))) => Err(format!("refuses {block}: {}", self.reason(exception))),
            Ok(Err(Error::Protocol(_))) => Err(format!("does not answer what it is asked for {block}")),
            Ok(Err(Error::Transport(error))) if error.kind() == ErrorKind::InvalidData => {
                Err(format!("answers what is not Modbus: {error}"))
            }
            // What the system says then is of something else if the other end has closed it in good order.
            Ok(Err(Error::Transport(_))) => Err("has closed the connection".to_owned()),
        }
    }

    fn reason(&self, exception: ExceptionCode) -> String {
        let code: u8 = exception.into();
        let unit = self.device.unit;
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
