//! A client, the loop that the server runs on, and all that it has said.

use std::path::Path;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::sync::{Arc, Mutex};
use std::time::Duration;

use futures::StreamExt;
use futures::channel::mpsc::{UnboundedSender, channel, unbounded};
use ladder_host::{Busy, Clock, EventLoop, Host, Wait, Wires, World};
use ladder_service::{Received, serve};
use ladder_workspace::{Disk, MemoryDisk};
use serde_json::{Value, json};

use crate::online::Desk;

/// What comes this much later is not waited for after a message.
const SOON: Duration = Duration::from_secs(2);

pub(crate) struct Session {
    disk: MemoryDisk,
    host: EventLoop,
    /// In nanoseconds.
    time: Arc<AtomicU64>,
    /// By how many it goes on whenever it is asked.
    per_look: Arc<AtomicU64>,
    messages: UnboundedSender<Received>,
    told: Arc<Mutex<Vec<Value>>>,
    heard: Vec<Value>,
    asked: i64,
    over: Arc<AtomicBool>,
}

impl Session {
    pub(crate) fn with(files: &[(&str, &str)]) -> Session {
        Session::beside(None, files)
    }

    /// The same, where there is a way to wires.
    pub(crate) fn beside(wires: Option<Desk>, files: &[(&str, &str)]) -> Session {
        let disk = MemoryDisk::default();
        for (name, text) in files {
            disk.write(&Path::new("/plant").join(name), text.as_bytes());
        }
        let (time, per_look) = (Arc::<AtomicU64>::default(), Arc::<AtomicU64>::default());
        let (shown, step) = (time.clone(), per_look.clone());
        let host = EventLoop::new(World {
            disk: Arc::new(disk.clone()),
            clock: Clock::new(move || {
                Duration::from_nanos(shown.fetch_add(step.load(Ordering::Relaxed), Ordering::Relaxed))
            }),
            wires: wires.map(|desk| Arc::new(desk) as Arc<dyn Wires>),
        });
        let (messages, received) = unbounded();
        let (out, mut spoken) = channel::<String>(0);
        let told = Arc::<Mutex<Vec<Value>>>::default();
        let over = Arc::<AtomicBool>::default();
        let (server, ended) = (Arc::new(host.clone()), over.clone());
        host.spawn(Box::pin(async move {
            serve(server, received, out, Busy::default()).await;
            ended.store(true, Ordering::Relaxed);
        }));
        let heap = told.clone();
        host.spawn(Box::pin(async move {
            while let Some(message) = spoken.next().await {
                heap.lock().unwrap().push(serde_json::from_str(&message).unwrap());
            }
        }));
        Session {
            disk,
            host,
            time,
            per_look,
            messages,
            told,
            heard: Vec::new(),
            asked: 1000,
            over,
        }
    }

    /// Sends a message, and waits until all that follows from it soon is done; while a program runs, only until there is nothing
    /// more to do now.
    pub(crate) fn send(&mut self, message: &Value) {
        let mut bytes = message.to_string().into_bytes();
        self.messages.unbounded_send(Received::read(&mut bytes)).unwrap();
        self.turn(Duration::ZERO);
    }

    /// The answer to a request.
    pub(crate) fn ask(&mut self, method: &str, params: Value) -> Value {
        self.asked += 1;
        let id = json!(self.asked);
        self.send(&json!({"jsonrpc": "2.0", "id": id, "method": method, "params": params}));
        let begun = self.host.world().clock.now();
        while self.answer(&id).is_none() {
            let waited = self.host.world().clock.now().saturating_sub(begun);
            assert!(waited < SOON, "{method} has no answer");
            self.turn(Duration::from_millis(1));
        }
        self.answer(&id).unwrap().clone()
    }

    pub(crate) fn notify(&mut self, method: &str, params: Value) {
        self.send(&json!({"jsonrpc": "2.0", "method": method, "params": params}));
    }

    pub(crate) fn open(&mut self, uri: &str, text: &str) {
        let document = json!({"uri": uri, "languageId": "clad", "version": 1, "text": text});
        self.notify("textDocument/didOpen", json!({"textDocument": document}));
    }

    /// Lets so many milliseconds pass.
    pub(crate) fn wait(&mut self, time: u64) {
        self.turn(Duration::from_millis(time));
    }

    /// From now on the clock goes on whenever it is asked.
    pub(crate) fn time_passes_with_work(&self) {
        self.per_look.store(1_000_000, Ordering::Relaxed);
    }

    fn turn(&mut self, time: Duration) {
        let end = self.host.world().clock.now() + time;
        loop {
            let wait = self
                .host
                .turn(end.max(self.host.world().clock.now()) + Duration::from_millis(1));
            match wait {
                Wait::Until(moment) if moment <= end => {
                    let time = moment.as_nanos() as u64;
                    self.time.fetch_max(time, Ordering::Relaxed);
                }
                Wait::No if self.host.world().clock.now() < end + Duration::from_millis(20) => {}
                _ => break,
            }
        }
        self.time.fetch_max(end.as_nanos() as u64, Ordering::Relaxed);
        self.heard.append(&mut self.told.lock().unwrap());
    }

    pub(crate) fn answer(&self, id: &Value) -> Option<&Value> {
        let mut told = self.heard.iter();
        told.find(|message| message["id"] == *id && message.get("method").is_none())
    }

    pub(crate) fn has_said(&self, message: &Value) -> bool {
        self.heard.contains(message)
    }

    /// The parameters of all notifications of this kind.
    pub(crate) fn heard(&self, method: &str) -> Vec<Value> {
        let these = self.heard.iter().filter(|message| message["method"] == method);
        these.map(|message| message["params"].clone()).collect()
    }

    /// Another program writes a file, and the client tells.
    pub(crate) fn write(&mut self, name: &str, text: &str) {
        self.disk.write(&Path::new("/plant").join(name), text.as_bytes());
        let changed = json!({"uri": format!("file:///plant/{name}"), "type": 2});
        self.notify("workspace/didChangeWatchedFiles", json!({"changes": [changed]}));
    }

    /// The text of a file.
    pub(crate) fn file(&self, name: &str) -> String {
        self.disk.read(&Path::new("/plant").join(name)).unwrap()
    }

    /// Whether the server has ended, once it has had the time for that.
    pub(crate) fn is_over(&mut self) -> bool {
        self.turn(SOON);
        self.over.load(Ordering::Relaxed)
    }
}
