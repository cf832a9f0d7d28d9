//! What a key or a click changes. The view changes at once; what concerns the program is given back as commands.

use super::keys::{self, Action};
use super::outputs::Outputs;
use super::picker::{self, Picker};
use super::plant::{Plant, Restart};
use super::prompt::{self, Prompt};
use super::sheet::Block;
use super::view::{Mode, Reasons, View};
use super::{inputs, mouse};
use ladder_analysis::values::types::Scalar;
use ladder_analysis::values::value::Value;
use ladder_simulator::{Breakpoint, Point, Status};
use ratatui::crossterm::event::{Event, KeyCode, KeyEvent, KeyEventKind, KeyModifiers};
use ratatui::layout::Rect;

/// Something to be done with the program.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Command {
    Set(Point, Value),
    Force(Point, Value),
    Unforce(Point),
    UnforceAll,
    Scan,
    StepBlock,
    StepRung,
    Back,
    /// Sets a breakpoint, or takes it away.
    Break(Breakpoint),
    Why(Point),
    Restart(Restart),
    Watch(Point),
    Unwatch(Point),
    Reload,
    /// Writes a test that expects something of these tags.
    Record(Vec<String>),
    Redraw,
    Stop,
    Quit,
}

impl Command {
    /// Whether only a simulation can do it: what is watched is neither written nor stepped.
    pub(super) fn is_for_a_simulation(&self) -> bool {
        match self {
            Command::Why(_)
            | Command::Watch(_)
            | Command::Unwatch(_)
            | Command::Redraw
            | Command::Stop
            | Command::Quit => false,
            Command::Set(..)
            | Command::Force(..)
            | Command::Unforce(_)
            | Command::UnforceAll
            | Command::Scan
            | Command::StepBlock
            | Command::StepRung
            | Command::Back
            | Command::Break(_)
            | Command::Restart(_)
            | Command::Reload
            | Command::Record(_) => true,
        }
    }
}

type Commands = Vec<Command>;

impl View {
    /// Takes in what happened at the terminal.
    pub(super) fn update(&mut self, event: &Event, plant: &Plant) -> Commands {
        match event {
            // A key that is let go is no news.
            Event::Key(key) if key.kind != KeyEventKind::Release => self.key(*key, plant),
            Event::Mouse(mouse) => mouse::update(self, *mouse, plant),
            Event::Resize(width, height) => {
                self.area = Rect::new(0, 0, *width, *height);
                self.show_selected(plant);
                Vec::new()
            }
            _ => Vec::new(),
        }
    }

    fn key(&mut self, key: KeyEvent, plant: &Plant) -> Commands {
        if keys::quits_at_once(key) {
            return vec![Command::Quit];
        }
        self.note = None;
        // Each mode returns itself if it goes on.
        match std::mem::replace(&mut self.mode, Mode::Diagram) {
            Mode::Diagram => match keys::action(key) {
                Some(action) => self.act(action, plant),
                None => Vec::new(),
            },
            Mode::Help => match keys::action(key) {
                Some(Action::Quit) => vec![Command::Quit],
                _ => Vec::new(),
            },
            Mode::Why(why) => self.why_key(why, key),
            Mode::Prompt(prompt) => self.prompt_key(prompt, key),
            Mode::Force(point) => self.force_key(point, key),
            Mode::Pick(picker) => self.picker_key(picker, key, plant),
            Mode::Outputs(outputs) => self.outputs_key(outputs, key),
        }
    }

    /// Does what a person wants.
    pub(super) fn act(&mut self, action: Action, plant: &Plant) -> Commands {
        match action {
            Action::Left => self.step_sideways(-1, plant),
            Action::Right => self.step_sideways(1, plant),
            Action::Up => self.step_line(-1, plant),
            Action::Down => self.step_line(1, plant),
            Action::Next => self.select(self.selected + 1, plant),
            Action::Previous => self.select(self.selected.saturating_sub(1), plant),
            Action::PageUp => self.page(-1, plant),
            Action::PageDown => self.page(1, plant),
            Action::First => {
                self.select(0, plant);
                self.top = 0;
                self.show_selected(plant);
            }
            Action::Last => self.select(usize::MAX, plant),
            Action::Switch => return self.switch_selected(plant),
            Action::Input(index) => {
                if let Some(point) = inputs::numbered(plant).get(index) {
                    return self.switch(&point.clone(), plant);
                }
                self.say(format!("there is no input {}", index + 1));
            }
            Action::SetValue => {
                return self.with_tag(plant, |view, point| view.ask(point, prompt::Purpose::Set));
            }
            Action::Force => return self.with_tag(plant, View::ask_force),
            Action::Unforce => return self.with_tag(plant, |view, point| view.let_go(point, plant)),
            Action::UnforceAll => {
                self.say(match plant.forces() {
                    0 => "nothing is forced".to_owned(),
                    1 => "1 tag was let go".to_owned(),
                    more => format!("{more} tags were let go"),
                });
                return vec![Command::UnforceAll];
            }
            Action::RunOrPause => self.run_or_pause(plant),
            Action::Scan => {
                self.running = false;
                return vec![Command::Scan];
            }
            Action::StepBlock => {
                self.running = false;
                return vec![Command::StepBlock];
            }
            Action::StepRung => {
                self.running = false;
                return vec![Command::StepRung];
            }
            Action::BreakAtRung => match plant.sheet.blocks.get(self.selected) {
                Some(block) => return vec![Command::Break(Breakpoint::Network(block.network))],
                None => self.say("there is no rung to stop at"),
            },
            Action::BreakAtChange => {
                return self.with_tag(plant, |_, point| vec![Command::Break(Breakpoint::Change(point))]);
            }
            Action::Why => return self.with_tag(plant, |_, point| vec![Command::Why(point)]),
            Action::Back => {
                self.running = false;
                return vec![Command::Back];
            }
            Action::Faster => self.speed = self.speed.faster(),
            Action::Slower => self.speed = self.speed.slower(),
            Action::RestartCold => return vec![Command::Restart(Restart::Cold)],
            Action::RestartWarm => return vec![Command::Restart(Restart::Warm)],
            Action::Watch => self.pick(picker::Purpose::Watch, plant),
            Action::Find => self.pick(picker::Purpose::Find, plant),
            Action::FindNext => self.find(1, plant),
            Action::FindPrevious => self.find(-1, plant),
            Action::ShorterTime => self.scale = self.scale.shorter(),
            Action::LongerTime => self.scale = self.scale.longer(),
            Action::GoToFault => self.go_to_fault(plant),
            Action::Reload => return vec![Command::Reload],
            Action::Record => match Outputs::new(plant) {
                Ok(outputs) => self.mode = Mode::Outputs(outputs),
                Err(why) => self.refuse(why),
            },
            Action::Help => self.mode = Mode::Help,
            Action::Close => self.note = None,
            Action::Redraw => return vec![Command::Redraw],
            Action::Stop => return vec![Command::Stop],
            Action::Quit => return vec![Command::Quit],
        }
        Vec::new()
    }

    fn run_or_pause(&mut self, plant: &Plant) {
        match plant.status() {
            Status::Ready => self.running = !self.running,
            Status::Ended => self.say("the program has ended: c starts it again"),
            Status::Faulted => self.say("a fault has stopped the program: c starts it again, b goes back"),
        }
    }

    /// To the neighbour on the same line.
    fn step_sideways(&mut self, by: isize, plant: &Plant) {
        let Some(block) = plant.sheet.blocks.get(self.selected) else {
            self.scroll_sideways(by * 8, plant);
            return;
        };
        let next = self.selected.saturating_add_signed(by);
        if plant.sheet.blocks_of(block.line).contains(&next) {
            self.select(next, plant);
        }
    }

    /// To the nearest block on the next line that has any.
    fn step_line(&mut self, by: isize, plant: &Plant) {
        let sheet = &plant.sheet;
        let Some(block) = sheet.blocks.get(self.selected) else {
            self.scroll(by, plant);
            return;
        };
        let on_line = sheet.blocks_of(block.line);
        let next = if by < 0 {
            on_line.start.checked_sub(1)
        } else {
            Some(on_line.end)
        };
        let Some(line) = next
            .and_then(|next| sheet.blocks.get(next))
            .map(|block| block.line)
        else {
            // Nothing to select there, but there may be something to read.
            self.scroll(by, plant);
            return;
        };
        let start = |block: &Block| block.start - sheet.line_start(block.line);
        let here = start(block);
        let nearest = sheet
            .blocks_of(line)
            .min_by_key(|&index| start(&sheet.blocks[index]).abs_diff(here));
        if let Some(nearest) = nearest {
            self.select(nearest, plant);
        }
    }

    fn page(&mut self, by: isize, plant: &Plant) {
        let height = self.panes(plant).diagram.height as usize;
        let page = height.saturating_sub(2).max(1) as isize;
        self.scroll(by * page, plant);
        let sheet = &plant.sheet;
        let Some(block) = sheet.blocks.get(self.selected) else {
            return;
        };
        let line = block.line.saturating_add_signed(by * page);
        let found = if by < 0 {
            let after = sheet.blocks.partition_point(|block| block.line < line);
            Some(after)
        } else {
            let after = sheet.blocks.partition_point(|block| block.line <= line);
            after.checked_sub(1).filter(|&found| found > self.selected)
        };
        self.select(found.unwrap_or(usize::MAX), plant);
    }

    /// The tag of the selected block that keys act on.
    pub(super) fn tag(&self, plant: &Plant) -> Option<Point> {
        let block = plant.sheet.blocks.get(self.selected)?;
        Some(plant.operands(block).first()?.point.clone())
    }

    fn with_tag(&mut self, plant: &Plant, act: impl FnOnce(&mut View, Point) -> Commands) -> Commands {
        match self.tag(plant) {
            Some(point) => act(self, point),
            None => {
                self.say("the selected block has no tag of this program");
                Vec::new()
            }
        }
    }

    /// Space: the tag that the selected block reads.
    pub(super) fn switch_selected(&mut self, plant: &Plant) -> Commands {
        let Some(block) = plant.sheet.blocks.get(self.selected) else {
            self.say("there is no block to switch");
            return Vec::new();
        };
        let operands = plant.operands(block);
        let read = operands
            .iter()
            .find(|operand| !operand.written && !operand.point.read_only);
        match read.or(operands.first()) {
            Some(operand) => self.switch(&operand.point, plant),
            None => {
                self.say("nothing of this block can be switched");
                Vec::new()
            }
        }
    }

    /// Switches a BOOL, asks for the value of anything else.
    pub(super) fn switch(&mut self, point: &Point, plant: &Plant) -> Commands {
        if point.read_only {
            self.refuse(format!("{} is read-only", point.name));
            return Vec::new();
        }
        if plant.is_forced(point) {
            self.say(format!(
                "{} is forced: u lets it go, f forces it again",
                point.name
            ));
            return Vec::new();
        }
        if point.ty != Scalar::Bool {
            return self.ask(point.clone(), prompt::Purpose::Set);
        }
        let high = !plant.is_high(point);
        if !Plant::is_input(point) {
            self.say(format!(
                "{} is not an input: the program may write it at once{}",
                point.name,
                if point.takes_force() { "; f forces it" } else { "" }
            ));
        } else if !self.running && plant.status() == Status::Ready {
            self.say(format!(
                "{} is {}; the program sees it in the next scan: s or p",
                point.name,
                if high { "on" } else { "off" }
            ));
        }
        vec![Command::Set(point.clone(), Value::Bool(high))]
    }

    fn ask(&mut self, point: Point, purpose: prompt::Purpose) -> Commands {
        if point.read_only {
            self.refuse(format!("{} is read-only", point.name));
        } else {
            self.mode = Mode::Prompt(Prompt::new(point, purpose));
        }
        Vec::new()
    }

    fn ask_force(&mut self, point: Point) -> Commands {
        if point.ty == Scalar::Bool && !point.read_only {
            self.mode = Mode::Force(point);
            return Vec::new();
        }
        self.ask(point, prompt::Purpose::Force)
    }

    fn let_go(&mut self, point: Point, plant: &Plant) -> Commands {
        if !plant.is_forced(&point) {
            self.say(format!("{} is not forced", point.name));
            return Vec::new();
        }
        vec![Command::Unforce(point)]
    }

    fn why_key(&mut self, mut why: Reasons, key: KeyEvent) -> Commands {
        match keys::action(key) {
            Some(Action::Up) => why.top = why.top.saturating_sub(1),
            Some(Action::Down) => why.top += 1,
            Some(Action::Quit) => return vec![Command::Quit],
            _ => return Vec::new(),
        }
        self.mode = Mode::Why(why);
        Vec::new()
    }

    fn prompt_key(&mut self, mut prompt: Prompt, key: KeyEvent) -> Commands {
        match key.code {
            KeyCode::Esc => return Vec::new(),
            KeyCode::Enter => {
                if let Some(value) = prompt.value() {
                    return vec![match prompt.purpose {
                        prompt::Purpose::Set => Command::Set(prompt.point, value),
                        prompt::Purpose::Force => Command::Force(prompt.point, value),
                    }];
                }
            }
            KeyCode::Backspace => prompt.delete(),
            KeyCode::Char('u') if key.modifiers.contains(KeyModifiers::CONTROL) => prompt.clear(),
            KeyCode::Char(letter) if !key.modifiers.contains(KeyModifiers::CONTROL) => prompt.put(letter),
            _ => {}
        }
        self.mode = Mode::Prompt(prompt);
        Vec::new()
    }

    fn force_key(&mut self, point: Point, key: KeyEvent) -> Commands {
        match key.code {
            KeyCode::Char('1') => vec![Command::Force(point, Value::Bool(true))],
            KeyCode::Char('0') => vec![Command::Force(point, Value::Bool(false))],
            KeyCode::Char('u') => vec![Command::Unforce(point)],
            KeyCode::Esc | KeyCode::Char('q') => Vec::new(),
            _ => {
                self.mode = Mode::Force(point);
                Vec::new()
            }
        }
    }

    fn pick(&mut self, purpose: picker::Purpose, plant: &Plant) {
        let block = plant.sheet.blocks.get(self.selected);
        let mut near: Vec<Point> = Vec::new();
        let operands = block.map(|block| plant.operands(block)).unwrap_or_default();
        for point in operands.iter().map(|operand| &operand.point) {
            if near.iter().all(|other| other.name != point.name) {
                near.push(point.clone());
            }
        }
        self.mode = Mode::Pick(Picker::new(purpose, near, plant));
    }

    fn picker_key(&mut self, mut picker: Picker, key: KeyEvent, plant: &Plant) -> Commands {
        let control = key.modifiers.contains(KeyModifiers::CONTROL);
        match key.code {
            KeyCode::Esc => return Vec::new(),
            KeyCode::Enter => match picker.opens() {
                Some(is_open) => picker.fold(!is_open, plant),
                None => return self.picked(&picker, plant),
            },
            KeyCode::Right => picker.fold(true, plant),
            KeyCode::Left => picker.fold(false, plant),
            KeyCode::Up | KeyCode::BackTab => picker.move_by(-1),
            KeyCode::Down | KeyCode::Tab => picker.move_by(1),
            KeyCode::Backspace => picker.delete(plant),
            KeyCode::Char('p') if control => picker.move_by(-1),
            KeyCode::Char('n') if control => picker.move_by(1),
            KeyCode::Char('u') if control => picker.clear(plant),
            KeyCode::Char(letter) if !control => picker.put(letter, plant),
            _ => {}
        }
        self.mode = Mode::Pick(picker);
        Vec::new()
    }

    fn outputs_key(&mut self, mut outputs: Outputs, key: KeyEvent) -> Commands {
        match key.code {
            KeyCode::Esc => return Vec::new(),
            KeyCode::Enter => return vec![Command::Record(outputs.chosen())],
            KeyCode::Up | KeyCode::BackTab | KeyCode::Char('k') => outputs.move_by(-1),
            KeyCode::Down | KeyCode::Tab | KeyCode::Char('j') => outputs.move_by(1),
            KeyCode::Char(' ') => outputs.toggle(),
            KeyCode::Char('a') => outputs.toggle_all(),
            _ => {}
        }
        self.mode = Mode::Outputs(outputs);
        Vec::new()
    }

    fn picked(&mut self, picker: &Picker, plant: &Plant) -> Commands {
        let Some(point) = picker.choice().cloned() else {
            let wanted = picker.text.trim();
            match plant.simulation().resolve(wanted) {
                Err(unknown) => self.refuse(unknown.message),
                Ok(_) => self.refuse("no tag was chosen"),
            }
            return Vec::new();
        };
        match picker.purpose {
            picker::Purpose::Watch if plant.watches(&point) => vec![Command::Unwatch(point)],
            picker::Purpose::Watch => vec![Command::Watch(point)],
            picker::Purpose::Find => {
                self.go_to_tag(&point, plant);
                Vec::new()
            }
        }
    }

    /// To the first block of a tag that is after the selected one, or to the first.
    pub(super) fn go_to_tag(&mut self, point: &Point, plant: &Plant) {
        let uses = plant.sheet.uses(point);
        let after = uses.iter().find(|&&block| block > self.selected);
        match after.or(uses.first()) {
            Some(&block) => {
                self.select(block, plant);
                self.sought = Some(point.clone());
                if uses.len() > 1 {
                    self.say(format!("{} is in {} blocks: n, N", point.name, uses.len()));
                }
            }
            None => self.say(format!("{} is in no block of {}", point.name, plant.sheet.file)),
        }
    }

    fn find(&mut self, by: isize, plant: &Plant) {
        let Some(point) = self.sought.clone().or_else(|| self.tag(plant)) else {
            self.say("/ finds a tag");
            return;
        };
        let uses = plant.sheet.uses(&point);
        let found = if by < 0 {
            let before = uses.iter().rev().find(|&&block| block < self.selected);
            before.or(uses.last())
        } else {
            let after = uses.iter().find(|&&block| block > self.selected);
            after.or(uses.first())
        };
        if let Some(&block) = found {
            self.select(block, plant);
        }
        self.sought = Some(point);
    }

    fn go_to_fault(&mut self, plant: &Plant) {
        let Some((fault, _)) = plant.last_fault() else {
            self.say("there was no fault");
            return;
        };
        if fault.location.file != 0 {
            self.say("the fault happened in another file");
            return;
        }
        if let Some(block) = plant.sheet.block_at(fault.location.range.start().into()) {
            self.select(block, plant);
        }
    }
}
