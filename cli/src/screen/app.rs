//! The view, and the program that it shows: events go in, scans are run, commands are carried out.

use super::draw::{self, Scene};
use super::load::{self, Request};
use super::plant::{Plant, Ran, Restart, StepUnit};
use super::theme::Theme;
use super::update::Command;
use super::view::{Mode, Reasons, View};
use ladder_simulator::Changeover;
use ladder_workspace::Stamp;
use ratatui::Frame;
use ratatui::crossterm::event::Event;
use ratatui::layout::Rect;
use std::time::{Duration, Instant};

/// A screen and its program.
pub(super) struct App<'r> {
    pub(super) view: View,
    pub(super) plant: Plant,
    theme: Theme,
    pub(super) request: &'r Request<'r>,
    stamp: Stamp,
    /// Simulated time that has passed and was not scanned yet.
    debt: i64,
}

/// What the loop around it has to do.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Next {
    Go,
    Redraw,
    Stop,
    Quit,
}

impl<'r> App<'r> {
    pub(super) fn new(area: Rect, plant: Plant, theme: Theme, request: &'r Request<'r>) -> App<'r> {
        let mut view = View::new(area, &plant);
        if let Some(note) = plant.simulation().program().unread_note() {
            view.say(note);
        }
        App {
            view,
            plant,
            theme,
            stamp: request.stamp(),
            request,
            debt: 0,
        }
    }

    /// Takes in what happened at the terminal.
    pub(super) fn handle(&mut self, event: &Event) -> Next {
        #[cfg(debug_assertions)]
        panic_if_asked(event);
        let mut next = Next::Go;
        for command in self.view.update(event, &self.plant) {
            let generation = self.plant.generation();
            match self.carry_out(command) {
                Next::Go => {}
                other => next = other,
            }
            if self.plant.generation() != generation {
                self.view.check_again(&self.plant);
            }
        }
        next
    }

    fn carry_out(&mut self, command: Command) -> Next {
        if self.plant.watching().is_some() && command.is_for_a_simulation() {
            self.view.running = true;
            self.view
                .refuse("this is a controller that is only watched: nothing is written to it");
            return Next::Go;
        }
        let result = match command {
            Command::Set(point, value) => self.plant.set(&point, value),
            Command::Force(point, value) => self.plant.force(&point, value),
            Command::Unforce(point) => {
                self.plant.unforce(&point);
                Ok(())
            }
            Command::UnforceAll => {
                self.plant.unforce_all();
                Ok(())
            }
            Command::Scan => {
                self.step();
                Ok(())
            }
            Command::StepBlock => {
                self.step_part(StepUnit::Block);
                Ok(())
            }
            Command::StepRung => {
                self.step_part(StepUnit::Rung);
                Ok(())
            }
            Command::Back => {
                self.step_back();
                Ok(())
            }
            Command::Break(breakpoint) => {
                self.toggle(breakpoint);
                Ok(())
            }
            Command::Why(point) => {
                self.view.mode = Mode::Why(Reasons {
                    text: self.plant.why(&point),
                    top: 0,
                });
                Ok(())
            }
            Command::Restart(restart) => {
                self.plant.restart(restart);
                self.debt = 0;
                self.view.say(match restart {
                    Restart::Cold => {
                        "restarted cold: all tags as at the beginning, inputs and forces as they are"
                    }
                    Restart::Warm => "restarted warm: retentive tags have kept their values",
                });
                Ok(())
            }
            Command::Watch(point) => {
                self.plant.watch(&point);
                self.view.say(format!("{} is watched", point.name));
                self.view.show_selected(&self.plant);
                Ok(())
            }
            Command::Unwatch(point) => {
                self.plant.unwatch(&point);
                self.view.say(format!("{} is watched no more", point.name));
                Ok(())
            }
            Command::Reload => {
                self.reload();
                Ok(())
            }
            Command::Record(outputs) => self.record(&outputs),
            Command::Redraw => return Next::Redraw,
            Command::Stop => return Next::Stop,
            Command::Quit => return Next::Quit,
        };
        if let Err(problem) = result {
            self.view.refuse(problem);
        }
        Next::Go
    }

    /// Runs the scans that are due after some real time, as far as they fit into `room`. A program that is slower
    /// than its clock is slow; it does not catch up. Whether anything was run.
    pub(super) fn pass(&mut self, real: Duration, room: Duration) -> bool {
        if !self.view.running {
            self.debt = 0;
            return false;
        }
        let generation = self.plant.generation();
        let ran = self.run_due(real, room);
        if self.plant.generation() != generation {
            self.view.check_again(&self.plant);
        }
        ran
    }

    fn run_due(&mut self, real: Duration, room: Duration) -> bool {
        let interval = self.plant.simulation().options().interval;
        let begun = Instant::now();
        let before = self.plant.scans();
        let due = self.view.speed.simulated(real);
        self.debt = self.debt.saturating_add(due.unwrap_or(0));
        while due.is_none() || self.debt >= interval {
            self.debt -= if due.is_none() { 0 } else { interval };
            match self.plant.run_scan() {
                Ran::On => {}
                Ran::Out => {
                    self.view.running = false;
                    return true;
                }
                Ran::Break(hit) => {
                    self.stopped_at(hit);
                    return true;
                }
            }
            if begun.elapsed() >= room {
                self.debt = 0;
                break;
            }
        }
        self.plant.scans() != before
    }

    /// Looks whether the file is still what runs. Whether that is news.
    pub(super) fn look_at_file(&mut self) -> bool {
        let stamp = self.request.stamp();
        // An editor may put the new file in place of the old in two steps.
        let changed = stamp != self.stamp && stamp.exists();
        std::mem::replace(&mut self.view.changed_on_disk, changed) != changed
    }

    /// Loads the file again. The program goes on from where it was; if what the file holds cannot be run, the old one goes
    /// on.
    fn reload(&mut self) {
        let stamp = self.request.stamp();
        let changed = load::again(self.request).and_then(|(source, program)| {
            let changed = self.plant.change(&source, program);
            changed.map_err(|error| format!("{error}; the old program goes on"))
        });
        let changed = match changed {
            Ok(changed) => changed,
            Err(problem) => {
                self.view.refuse(problem);
                return;
            }
        };
        self.stamp = stamp;
        self.view.take_over(&self.plant);
        let file = &self.plant.sheet.file;
        let told = match changed {
            Changeover::None => format!("{file} was loaded again: the program does what it did"),
            Changeover::Carried { lost } => match lost.as_slice() {
                [] => format!("{file} was loaded again: the program goes on with all that it held"),
                [lost] => format!("{file} was loaded again: {}", lost.message),
                [first, rest @ ..] => {
                    format!(
                        "{file} was loaded again: {} (and {} more)",
                        first.message,
                        rest.len()
                    )
                }
            },
        };
        self.view.say(told);
    }

    /// Draws the screen.
    pub(super) fn draw(&mut self, frame: &mut Frame) {
        if frame.area() != self.view.area {
            let area = frame.area();
            self.handle(&Event::Resize(area.width, area.height));
        }
        draw::screen(
            frame,
            Scene {
                view: &self.view,
                plant: &self.plant,
                theme: self.theme,
            },
        );
    }
}

/// A test wants to see the terminal after a panic. Programs that are built for use do not know this.
#[cfg(debug_assertions)]
fn panic_if_asked(event: &Event) {
    use ratatui::crossterm::event::{KeyCode, KeyEvent};
    let percent = matches!(
        event,
        Event::Key(KeyEvent {
            code: KeyCode::Char('%'),
            ..
        })
    );
    assert!(
        !percent || std::env::var_os("LADDER_TEST_PANIC").is_none(),
        "a test asked for this panic"
    );
}
