//! The interactive screen of `ladder sim`: a program with its power, live, and the keys to try it with.
//!
//! ```text
//! terminal --events--> View::update --commands--> Plant (session, recorder of watched tags)
//!     ^                    (view)                    | scans, as the clock and the speed have it
//!     +------------- draw::screen <------------------+
//! ```
//!
//! - `view` is what a person sees, a plain value; `update` and `mouse` change it and give back what is to be
//!   done with the program as commands; `app` carries them out and runs the scans.
//! - `plant` is all that the screen knows of the simulator.
//! - `sheet` is the program on paper: what is where. It is made once, so that a frame costs what it shows and
//!   not what the program is long.
//! - `fold` makes wide networks as narrow as the screen, where they have nothing but wire; `bands` says which lines belong
//!   together there.
//! - `draw` reads view and plant and writes characters; what a colour shows is also shown by a heavier line or a sign.
//! - `guard` and `signals` give the terminal back as it was, however the screen ends.

mod app;
mod bands;
mod columns;
mod draw;
mod fault;
mod fold;
#[cfg(test)]
mod fold_tests;
mod guard;
mod inputs;
mod keys;
mod load;
mod mouse;
mod operands;
mod outputs;
mod panes;
mod picker;
mod plant;
mod prompt;
mod record;
mod sheet;
mod signals;
mod speed;
mod stepping;
#[cfg(test)]
mod tests;
mod theme;
mod update;
mod values;
mod view;
mod wave;

pub(crate) use load::Request;

#[cfg(feature = "run")]
use crate::findings::Source;
use crate::outcome::{Failure, Outcome};
#[cfg(feature = "run")]
use crate::run::{Plants, Stimulus};
use crate::terminal::raw_stdout;
use app::{App, Next};
use guard::Guard;
use ladder_analysis::Cancel;
#[cfg(feature = "run")]
use ladder_simulator::online::Watching;
use plant::Plant;
use ratatui::Terminal;
use ratatui::backend::CrosstermBackend;
use ratatui::crossterm::event;
use ratatui::layout::Rect;
use signals::Signals;
use std::io::{self, BufWriter, Stdout};
#[cfg(feature = "run")]
use std::path::Path;
use std::sync::Mutex;
use std::time::{Duration, Instant};
use theme::Theme;

/// Twenty-five pictures a second are fluid, and leave the machine to others.
const FRAME: Duration = Duration::from_millis(40);

/// So long the program waits for a key while nothing runs.
const REST: Duration = Duration::from_millis(200);

/// The part of a frame that scans may take.
const ROOM: Duration = Duration::from_millis(25);

/// How often the file is checked.
const LOOK: Duration = Duration::from_secs(1);

/// Shows the screen until the person has seen enough.
pub(crate) fn run(request: &Request) -> Result<Outcome, Failure> {
    match load::first(request)? {
        Some(plant) => show_whole(request, plant),
        None => Ok(Outcome::Findings),
    }
}

/// From the terminal as it is found to the terminal as it was.
fn show_whole(request: &Request, plant: Plant) -> Result<Outcome, Failure> {
    let signals = Signals::watch().map_err(unusable)?;
    let mut app = App::new(Rect::new(0, 0, 80, 24), plant, Theme::of_environment(), request);
    let guard = Guard::enter().map_err(unusable)?;
    let ended = show(&mut app, guard, &signals);
    let saved = app.plant.finish();
    if let Some(signal) = signals.ending() {
        signals::obey(signal);
    }
    ended.map_err(unusable)?;
    saved?;
    Ok(Outcome::Fine)
}

/// Shows what a controller does until the person has seen enough.
#[cfg(feature = "run")]
pub(crate) fn watch(
    file: &Path,
    source: &Source,
    controller: String,
    (watching, every): (Watching, Duration),
) -> Result<Outcome, Failure> {
    let request = Request {
        file,
        from: None,
        plants: &Plants::default(),
        stimulus: &Stimulus::default(),
        retain: None,
        watch: &[],
    };
    show_whole(
        &request,
        load::of_controller(source, controller, watching, every)?,
    )
}

fn unusable(error: io::Error) -> Failure {
    Failure::new(format!("the terminal cannot be used: {error}"))
}

/// The loop: waits for a key or the next frame, runs the scans that are due, draws if anything changed.
fn show(app: &mut App, mut guard: Guard, signals: &Signals) -> io::Result<()> {
    let mut terminal = terminal()?;
    let mut before = Instant::now();
    let mut looked = before;
    let mut drawn: Option<Instant> = None;
    let mut changed = true;
    let cancel = at_key(signals);
    while signals.ending().is_none() {
        let mut wait = match drawn {
            _ if changed => Duration::ZERO,
            Some(drawn) if app.view.running => FRAME.saturating_sub(drawn.elapsed()),
            _ => REST,
        };
        while event::poll(wait)? {
            match app.handle(&event::read()?) {
                Next::Go => {}
                Next::Redraw => terminal.clear()?,
                Next::Stop => {
                    drop(guard);
                    signals::stop();
                    guard = Guard::enter()?;
                    terminal.clear()?;
                    before = Instant::now();
                }
                Next::Quit => return Ok(()),
            }
            changed = true;
            wait = Duration::ZERO;
        }
        let now = Instant::now();
        app.plant.obey(&cancel);
        changed |= app.pass(now - before, ROOM);
        before = now;
        app.plant.keep();
        if looked.elapsed() >= LOOK {
            looked = now;
            changed |= app.look_at_file();
        }
        if changed {
            terminal.draw(|frame| app.draw(frame))?;
            drawn = Some(Instant::now());
            changed = false;
        }
    }
    drop(guard);
    Ok(())
}

/// Cancels a scan that takes long when a key was pressed, or a signal came.
fn at_key(signals: &Signals) -> Cancel {
    let ending = signals.clone();
    let looked = Mutex::new(Instant::now());
    Cancel::when(move || {
        // A look at the terminal takes longer than a thousand blocks.
        let Ok(mut looked) = looked.lock() else {
            return false;
        };
        if looked.elapsed() < FRAME {
            return false;
        }
        *looked = Instant::now();
        ending.ending().is_some() || event::poll(Duration::ZERO).unwrap_or(false)
    })
}

fn terminal() -> io::Result<Terminal<CrosstermBackend<BufWriter<Stdout>>>> {
    Terminal::new(CrosstermBackend::new(BufWriter::with_capacity(
        1 << 16,
        raw_stdout(),
    )))
}
