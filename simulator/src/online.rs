//! A running controller beside its program: its values, and the power that they say.
//!
//! The values of a snapshot are not of one scan: the controller goes on between the requests that bring them. So a value that
//! contradicts the program is at first only marked, and reported when it does so several times in a row.

use crate::members::members_of;
use crate::session::{Judged, Moment};
use crate::simulation::{Options, Simulation};
use crate::tags::Point;
use ladder_analysis::program::Program;
use ladder_analysis::values::types::Type;
use ladder_analysis::values::value::Value;
use std::collections::HashSet;
use std::fmt;
use std::sync::Arc;
use std::time::Duration;

/// So many snapshots in a row a value has to contradict the program in until that is reported.
pub const PATIENCE: u32 = 3;

/// So many values are judged in a snapshot.
const MOST: usize = 100;

/// A value of the program that a controller is asked for.
#[derive(Debug, Clone, PartialEq)]
pub struct Wanted {
    /// It, in the program.
    pub point: Point,
    /// What the controller calls it, or where it is there.
    pub name: String,
}

/// What a controller has of something that is wanted.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Found {
    /// It is there, as far as the controller tells.
    Here,
    /// It is not.
    Missing,
    /// It is of another type: the name of that.
    OtherType(String),
}

/// Whether a controller answers.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Connection {
    /// Not yet, and nothing has failed.
    Opening,
    /// It does.
    Open,
    /// It does not, and why; it is tried again.
    Lost(String),
}

/// What is known of a controller.
#[derive(Debug, Clone)]
pub struct Newest {
    /// Whether it answers.
    pub connection: Connection,
    /// What it has of what is wanted, in the order of that; nothing before it was first connected.
    pub found: Arc<[Found]>,
    /// How many snapshots have come.
    pub snapshots: u64,
    /// The values of the last one, in the order of what is wanted. None: it could not be read.
    pub values: Arc<[Option<Value>]>,
    /// How long ago that was complete.
    pub age: Option<Duration>,
}

/// A controller that is watched until this is dropped.
pub trait Watched: Send {
    /// What is asked for. It stays the same.
    fn wanted(&self) -> &[Wanted];

    /// What is known now.
    fn newest(&self) -> Newest;
}

/// A program, and what a controller that runs it is doing.
#[derive(Debug)]
pub struct Online {
    moment: Moment,
    /// What contradicts the program.
    doubts: Vec<Doubt>,
    /// Of each part of the drawing whether its power is not known.
    unknown: Vec<bool>,
}

/// A value that contradicts the program.
#[derive(Debug, Clone, PartialEq)]
pub struct Doubt {
    /// It.
    pub point: Point,
    /// The network that would write another value.
    pub network: usize,
    /// In how many snapshots in a row.
    pub times: u32,
}

impl Doubt {
    /// It has been so for longer than a read between two scans explains.
    pub fn is_reported(&self) -> bool {
        self.times >= PATIENCE
    }
}

impl fmt::Display for Doubt {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let name = &self.point.name;
        if self.is_reported() {
            write!(
                f,
                "{name} is not what this rung makes it: something else writes it, or the controller runs another program"
            )
        } else {
            write!(f, "{name} changed while reading")
        }
    }
}

impl Online {
    /// A program of which nothing is known yet.
    ///
    /// # Errors
    /// It needs more memory than there is, or does not come through a scan: a sentence.
    pub fn new(program: Arc<Program>) -> Result<Online, String> {
        // No time passes.
        let options = Options {
            interval: 0,
            ..Options::default()
        };
        let simulation = Simulation::new(program, options).map_err(|error| error.message)?;
        let mut moment = Moment::new(simulation, Vec::new()).map_err(|faults| told(&faults))?;
        Ok(Online {
            unknown: moment.open_elements(),
            moment,
            doubts: Vec::new(),
        })
    }

    /// What there is to know of a running controller: all but constants and what the system keeps. Of timers and counters every
    /// member, for those decide what they do.
    pub fn points(&self) -> Vec<Point> {
        let simulation = self.simulation();
        let tags = simulation.program().tags.iter().filter(|tag| tag.block.is_none());
        let members = tags.filter_map(|tag| match tag.ty {
            Type::State(state) => Some(members_of(state).map(|member| format!("{}.{member}", tag.name))),
            _ => None,
        });
        let members = members
            .flatten()
            .filter_map(|name| simulation.resolve(&name).ok());
        let listed: HashSet<&str> = simulation.points().iter().map(|it| it.name.as_str()).collect();
        let others = members.filter(|point| !listed.contains(point.name.as_str()));
        let mut points = simulation.points().to_vec();
        points.extend(others);
        points.retain(|point| !point.read_only);
        points
    }

    /// The values of a snapshot, in the order of what was wanted.
    ///
    /// # Errors
    /// With these values the program does not come through a scan: a sentence.
    pub fn see(&mut self, wanted: &[Wanted], values: &[Option<Value>]) -> Result<(), String> {
        let given = wanted.iter().zip(values);
        let given = given.filter_map(|(wanted, value)| Some((wanted.point.clone(), value.clone()?)));
        let given: Vec<(Point, Value)> = given.collect();
        let seen = self.moment.become_another(given);
        seen.map_err(|faults| {
            format!(
                "with these values the program does not come through a scan: {}",
                told(&faults)
            )
        })?;
        self.unknown = self.moment.open_elements();
        let before = std::mem::take(&mut self.doubts);
        let now = self.moment.contradictions(MOST).into_iter();
        self.doubts = now
            .map(|(point, network)| {
                let before = before.iter().find(|doubt| doubt.point == point);
                Doubt {
                    times: before.map_or(0, |doubt| doubt.times) + 1,
                    point,
                    network,
                }
            })
            .collect();
        Ok(())
    }

    /// The program with the values, and the power that they say.
    pub fn simulation(&self) -> &Simulation {
        self.moment.simulation()
    }

    /// What contradicts the program now.
    pub fn doubts(&self) -> &[Doubt] {
        &self.doubts
    }

    /// Whether the last snapshot had a value; without it the program has the one that it begins with.
    pub fn is_known(&self, point: &Point) -> bool {
        self.moment.is_given(point)
    }

    /// The networks whose power the last snapshot does not say: they read what it had not.
    pub fn unknown(&mut self) -> Vec<usize> {
        self.moment.open_networks()
    }

    /// Whether the last snapshot does not say the power of a part of the drawing, by its place in [`Simulation::power`]: what it had not
    /// decides it, or what was before, of which an edge comes.
    pub fn is_unknown(&self, element: usize) -> bool {
        self.unknown.get(element).copied().unwrap_or_default()
    }

    /// Why a tag holds what it holds, by the values of the last snapshot.
    pub fn why(&mut self, point: &Point) -> Judged {
        self.moment.why(point)
    }
}

/// What went wrong first.
fn told(faults: &[crate::fault::Fault]) -> String {
    faults
        .first()
        .map_or_else(String::new, |fault| fault.message.clone())
}

/// A program beside the controller that runs it, while it is watched.
pub struct Watching {
    online: Online,
    watched: Box<dyn Watched>,
    newest: Newest,
    /// Why the last snapshot says nothing of the program.
    unusable: Option<String>,
}

impl fmt::Debug for Watching {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Watching")
            .field("newest", &self.newest)
            .finish_non_exhaustive()
    }
}

impl Watching {
    /// A program of which nothing is known yet, and what is asked for there.
    pub fn new(online: Online, watched: Box<dyn Watched>) -> Watching {
        Watching {
            newest: watched.newest(),
            online,
            watched,
            unusable: None,
        }
    }

    /// Takes in what is new. Whether there is another snapshot.
    pub fn look(&mut self) -> bool {
        let before = std::mem::replace(&mut self.newest, self.watched.newest());
        if before.snapshots == self.newest.snapshots {
            return false;
        }
        let seen = self.online.see(self.watched.wanted(), &self.newest.values);
        self.unusable = seen.err();
        true
    }

    /// The program with the values of the last snapshot.
    pub fn online(&self) -> &Online {
        &self.online
    }

    /// Why a tag holds what it holds, by the values of the last snapshot.
    pub fn why(&mut self, point: &Point) -> Judged {
        self.online.why(point)
    }

    /// The networks whose power the last snapshot does not say: they read what it had not.
    pub fn unknown(&mut self) -> Vec<usize> {
        self.online.unknown()
    }

    /// What is known of the controller.
    pub fn newest(&self) -> &Newest {
        &self.newest
    }

    /// How it is, in one line: whether the controller answers, how old the values are, and how many of them are in doubt.
    pub fn status(&self) -> String {
        let mut parts = vec!["READ ONLY".to_owned()];
        match (&self.newest.connection, self.newest.age) {
            (Connection::Opening, _) => parts.push("connecting".to_owned()),
            (Connection::Open, Some(age)) => parts.push(format!("values {}", old(age))),
            (Connection::Open, None) => parts.push("connected".to_owned()),
            (Connection::Lost(why), None) => parts.push(format!("it {why}; tried again")),
            (Connection::Lost(why), Some(age)) => {
                parts.push(format!("it {why}; tried again; values {}", old(age)));
            }
        }
        let of = |count: usize, one: &str, more: &str| match count {
            0 => None,
            1 => Some(format!("1 {one}")),
            count => Some(format!("{count} {more}")),
        };
        let lost = self
            .newest
            .found
            .iter()
            .filter(|found| **found != Found::Here)
            .count();
        parts.extend(of(lost, "tag is not there as here", "tags are not there as here"));
        let (against, changed): (Vec<&Doubt>, Vec<&Doubt>) =
            self.online.doubts().iter().partition(|doubt| doubt.is_reported());
        parts.extend(of(
            against.len(),
            "value is against the program",
            "values are against the program",
        ));
        parts.extend(of(
            changed.len(),
            "value changed while reading",
            "values changed while reading",
        ));
        parts.join("; ")
    }

    /// What a person should know of how controller and program differ: a sentence for each tag, up to so many.
    pub fn differences(&self, most: usize) -> Vec<String> {
        let pairs = self.watched.wanted().iter().zip(self.newest.found.iter());
        let pairs = pairs.filter(|(_, found)| **found != Found::Here);
        let mut told: Vec<String> = Vec::new();
        let mut more = 0;
        for (wanted, found) in pairs {
            if told.len() == most {
                more += 1;
                continue;
            }
            let (point, name) = (&wanted.point, &wanted.name);
            let there = if point.name.eq_ignore_ascii_case(name) {
                String::new()
            } else {
                format!(" as {name}")
            };
            told.push(match found {
                Found::OtherType(ty) => {
                    format!(
                        "{} is {} here, and {ty} in the controller{there}",
                        point.name, point.ty
                    )
                }
                _ => format!("{} is not in the controller{there}", point.name),
            });
        }
        if more > 0 {
            told.push(format!("and {more} more"));
        }
        told.extend(self.unusable.clone());
        told
    }
}

/// An age in words.
fn old(age: Duration) -> String {
    match age.as_secs() {
        0..60 => format!("{:.1} s old", age.as_secs_f64()),
        seconds => format!("{} min {} s old", seconds / 60, seconds % 60),
    }
}
