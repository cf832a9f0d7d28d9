//! The task of a device: it connects, asks again and again, and tries again when there is no answer.

use super::Device;
use super::exchange::{Exchange, Plan};
use crate::modbus::client::{Client, Failed, open};
use std::sync::Arc;
use std::time::{Duration, Instant};
use tokio::sync::watch;
use tokio::time::{MissedTickBehavior, interval, timeout};

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
    let mut client = None;
    while !*ending.borrow() {
        let connected = match client.take() {
            Some(client) => Ok(client),
            None => tokio::select! {
                opened = open(&device.address, device.timeout) => {
                    opened.map(|stream| Client::over(stream, device.unit, device.timeout))
                }
                () = end_of(&mut ending) => return,
            },
        };
        let failed = match connected {
            Ok(mut connected) => match line.exchange(&mut connected, &mut ending).await {
                Ok(()) => return exchange.lost(),
                Err(Failed::Refused(why)) => {
                    // It answers: the connection is good.
                    client = Some(connected);
                    why
                }
                Err(Failed::Lost(why)) => why,
            },
            Err(why) => why,
        };
        exchange.lost();
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

    /// Exchanges values until the end is asked for. Outputs are written only after everything was read once.
    async fn exchange(
        &mut self,
        client: &mut Client,
        ending: &mut watch::Receiver<bool>,
    ) -> Result<(), Failed> {
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
                let words = client.read(block).await?;
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
        client: &mut Client,
        plan: &Arc<Plan>,
        outputs: Vec<u16>,
        written: &mut Option<Written>,
    ) -> Result<(), Failed> {
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
                client.write(block, words).await?;
            }
        }
        *written = Some(Written {
            plan: plan.clone(),
            words: outputs,
            at: before.map_or(now, |before| before.at),
        });
        Ok(())
    }
}
