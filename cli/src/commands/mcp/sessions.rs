//! Simulations that go on from call to call.

use super::given::Given;
use super::pages::Answer;
use super::roots::Roots;
use crate::findings::Source;
use crate::outcome::Failure;
use crate::run::{Plants, program, simulation, with_wording};
use ladder_analysis::program::Role;
use ladder_simulator::{HistoryLimits, Point, Session, Status, value_text};
use ladder_workspace::Settings;
use serde_json::{Value, json};
use std::collections::BTreeMap;
use std::time::{Duration, Instant};

/// So many go on at once: each keeps a history.
const MOST: usize = 8;
/// So many scans run in one call.
const MOST_SCANS: u64 = 100_000;
/// So long the scans of one call may take.
const LONGEST: Duration = Duration::from_secs(30);

/// See the module.
#[derive(Default)]
pub(super) struct Sessions {
    going: BTreeMap<u64, Going>,
    last: u64,
}

struct Going {
    session: Session,
    source: Source,
}

impl Sessions {
    /// Does what a call asks for.
    ///
    /// # Errors
    /// A sentence for who called.
    pub(super) fn call(&mut self, given: &Given, roots: &Roots) -> Result<Answer, String> {
        if given.needed("action")? == "start" {
            return self.start(given, roots);
        }
        let number = given.number("session").unwrap_or(self.last);
        if given.text("action") == Some("end") {
            let ended = self.going.remove(&number);
            let ended = ended.ok_or_else(|| not_there(number))?;
            return Ok(ended.answer(number, given)?.with("ended", json!(true)));
        }
        let going = self.going.get_mut(&number).ok_or_else(|| not_there(number))?;
        going.act(number, given)
    }

    fn start(&mut self, given: &Given, roots: &Roots) -> Result<Answer, String> {
        if self.going.len() == MOST {
            return Err(format!("{MOST} simulations go on already: end one of them"));
        }
        let file = roots.there(given.needed("path")?)?.whole();
        let plant = given.text("plant").map(|plant| roots.there(plant)).transpose()?;
        let plant = plant.map(|plant| plant.whole().to_string_lossy().into_owned());
        let going = Going::begin(&file, plant).map_err(|failure| failure.to_string())?;
        self.last += 1;
        let answer = going.answer(self.last, given)?;
        self.going.insert(self.last, going);
        Ok(answer)
    }
}

fn not_there(number: u64) -> String {
    format!("there is no simulation {number}: start one with its `path`")
}

impl Going {
    fn begin(file: &std::path::Path, plant: Option<String>) -> Result<Going, Failure> {
        let source = Plants::named(plant).beside(Source::read(file, None)?)?;
        let whole = program(&source).ok_or_else(|| {
            Failure::new("the program has errors, or uses a file that has some: `check` shows them")
        })?;
        let options = Settings::of(file)?.simulate.options(&whole, file);
        let simulation = simulation(&source, whole, options)?;
        Ok(Going {
            session: Session::of(simulation, HistoryLimits::default()),
            source,
        })
    }

    fn act(&mut self, number: u64, given: &Given) -> Result<Answer, String> {
        match given.needed("action")? {
            "step" => self.step(given)?,
            "set" => self.set(given)?,
            "force" => {
                for (point, value) in self.values(given)? {
                    let forced = self.session.force(&point, value);
                    forced.map_err(|refused| format!("{}: {refused}", point.name))?;
                }
            }
            "release" => self.release(given)?,
            "back" => {
                let scans = given.number("scans").unwrap_or(1);
                self.session
                    .step_back(usize::try_from(scans).unwrap_or(usize::MAX));
            }
            "why" => {
                let point = self.point(given.needed("tag")?)?;
                let why = self.why(&point);
                return Ok(self.answer(number, given)?.with("why", json!(why)));
            }
            _ => {}
        }
        self.answer(number, given)
    }

    fn step(&mut self, given: &Given) -> Result<(), String> {
        self.set(given)?;
        let scans = given.number("scans").unwrap_or(1);
        if scans > MOST_SCANS {
            return Err(format!("at most {MOST_SCANS} scans run in one call"));
        }
        let begun = Instant::now();
        for _ in 0..scans {
            // The watchdog ends a scan that takes long.
            if begun.elapsed() > LONGEST {
                let (scan, seconds) = (self.session.simulation().scans(), LONGEST.as_secs());
                return Err(format!(
                    "the scans took longer than {seconds} seconds; it is at scan {scan}: run fewer"
                ));
            }
            if !self.session.scan() {
                break;
            }
        }
        Ok(())
    }

    fn set(&mut self, given: &Given) -> Result<(), String> {
        for (point, value) in self.values(given)? {
            let set = self.session.set(&point, value);
            set.map_err(|refused| format!("{}: {refused}", point.name))?;
        }
        Ok(())
    }

    fn release(&mut self, given: &Given) -> Result<(), String> {
        let tags = given.texts("tags");
        if tags.is_empty() {
            self.session.unforce_all();
        }
        for tag in tags {
            let point = self.point(tag)?;
            self.session.unforce(&point);
        }
        Ok(())
    }

    fn point(&self, name: &str) -> Result<Point, String> {
        self.session.find(name).map_err(|unknown| unknown.to_string())
    }

    /// The values of a call; none is given if one of them does not fit.
    fn values(&self, given: &Given) -> Result<Vec<(Point, ladder_analysis::values::value::Value)>, String> {
        let values = given.values("values").into_iter();
        let value = values.map(|(name, text)| {
            let point = self.point(&name)?;
            let value = value_text::parse(&text, point.ty).map_err(|wrong| format!("{name}: {wrong}"))?;
            Ok((point, value))
        });
        value.collect()
    }

    fn why(&mut self, point: &Point) -> String {
        let why = self.session.why(point);
        let program = self.session.simulation().program();
        let members = self.source.members(&program.files);
        with_wording(&members, &program.files, |wording| wording.text(&why))
    }

    /// Where it is, with the values of the tags that are asked for.
    fn answer(&self, number: u64, given: &Given) -> Result<Answer, String> {
        let simulation = self.session.simulation();
        let tags = given.texts("tags");
        let asked = tags.iter().map(|name| self.point(name));
        let mut points = asked.collect::<Result<Vec<Point>, String>>()?;
        if points.is_empty() {
            let seen = |point: &&Point| !point.read_only && (point.is_input || point.role == Role::Output);
            points.extend(simulation.points().iter().filter(seen).cloned());
        }
        let value = |point: &Point| {
            json!({
                "tag": point.name,
                "type": point.ty.to_string(),
                "value": value_text::display(&simulation.value(point), point.ty),
                "forced": simulation.is_forced(point),
            })
        };
        let values: Vec<Value> = points.iter().map(value).collect();
        let is_ready = simulation.status() == Status::Ready;
        let mut answer = Answer::list(is_ready, "values", values, given.from())
            .with("session", json!(number))
            .with("scan", json!(simulation.scans()));
        if let Some((fault, times)) = self.session.last_fault() {
            answer = answer.with("fault", json!(format!("{} ({times} times)", fault.message)));
        }
        Ok(answer)
    }
}
