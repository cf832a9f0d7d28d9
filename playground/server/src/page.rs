//! The server with its loop and its files.

use std::collections::VecDeque;
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};
use std::time::Duration;

use futures::StreamExt;
use futures::channel::mpsc::{UnboundedSender, channel, unbounded};
use ladder_host::{Busy, Clock, EventLoop, Host, Wait, World};
use ladder_service::{Received, serve};
use ladder_workspace::MemoryDisk;

/// The folder in which the page's files lie.
pub const WORKSPACE: &str = "/work";

/// The server of one page. Nothing goes on by itself: see [`Page::turn`].
#[derive(Debug)]
pub struct Page {
    disk: MemoryDisk,
    event_loop: EventLoop,
    /// Messages for the server.
    messages: UnboundedSender<Received>,
    /// What it has said that nobody has taken yet.
    said: Arc<Mutex<VecDeque<String>>>,
}

impl Page {
    /// A server without files to which nothing was said yet.
    pub fn new(clock: Clock) -> Page {
        let disk = MemoryDisk::default();
        let event_loop = EventLoop::new(World {
            disk: Arc::new(disk.clone()),
            clock,
            wires: None,
        });
        let (messages, received) = unbounded();
        let (out, mut spoken) = channel::<String>(0);
        let said = Arc::<Mutex<VecDeque<String>>>::default();
        let host = Arc::new(event_loop.clone());
        event_loop.spawn(Box::pin(async {
            serve(host, received, out, Busy::default()).await;
        }));
        let heap = said.clone();
        event_loop.spawn(Box::pin(async move {
            while let Some(message) = spoken.next().await {
                heap.lock()
                    .unwrap_or_else(PoisonError::into_inner)
                    .push_back(message);
            }
        }));
        Page {
            disk,
            event_loop,
            messages,
            said,
        }
    }

    /// Writes a file, by its name as it is seen from [`WORKSPACE`].
    pub fn write(&self, name: &str, bytes: &[u8]) {
        self.disk.write(&path(name), bytes);
    }

    /// Removes a file, if it is there.
    pub fn remove(&self, name: &str) {
        self.disk.remove(&path(name));
    }

    /// Takes a message for the server: JSON, without a header.
    pub fn receive(&self, mut message: Vec<u8>) {
        // Nobody takes it only after `exit`.
        let _ = self.messages.unbounded_send(Received::read(&mut message));
    }

    /// Does what is to be done, for about this time. What is next, from when on it has to be called again.
    pub fn turn(&self, time: Duration) -> Wait {
        self.event_loop.turn(self.event_loop.world().clock.now() + time)
    }

    /// How long until this moment.
    pub fn time_until(&self, moment: Duration) -> Duration {
        moment.saturating_sub(self.event_loop.world().clock.now())
    }

    /// What the server says next: JSON.
    pub fn said(&self) -> Option<String> {
        self.said
            .lock()
            .unwrap_or_else(PoisonError::into_inner)
            .pop_front()
    }
}

fn path(name: &str) -> PathBuf {
    Path::new(WORKSPACE).join(name.trim_start_matches('/'))
}
