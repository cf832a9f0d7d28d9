//! The call stack: what is open in the scan, from the innermost block out to the main program and the scenario.

use ladder_analysis::program::{Location, Program};
use ladder_simulator::{Activation, Routine, Status};
use ladder_syntax::TextRange;
use serde_json::{Value as Json, json};

use crate::sources::Counting;
use crate::target::Target;

/// The frames, the innermost first. `place` is where the innermost shows itself, if not where it goes on.
pub(crate) fn frames(target: &Target, place: Option<Location>, counting: Counting) -> Vec<Json> {
    let is_open = target.session.is_open();
    let mut frames = Vec::new();
    for (depth, activation) in target.activations().iter().enumerate() {
        let location = place.filter(|_| depth == 0).unwrap_or(activation.location);
        let source = target.source(location.file);
        let mut frame = json!({
            "id": depth + 1,
            "name": match place.filter(|_| depth == 0).and_then(|place| network_of(target, place)) {
                Some(network) => name_after(target, activation, network, is_open),
                None => name(target, activation, is_open),
            },
            "source": source.json(),
        });
        extend(&mut frame, &counting.range(source, location.range));
        frames.push(frame);
    }
    if let Some(play) = &target.play {
        let scans = target.simulation().scans();
        // Between two scans what counts is the step that has ended, unless none has.
        let scan = if is_open { scans } else { scans.saturating_sub(1) };
        let step = play.step(scan);
        let mut frame = json!({
            "id": frames.len() + 1,
            "name": format!("scenario \"{}\", step {}", play.case.name, step),
            "source": play.file.json(),
            "presentationHint": "subtle",
        });
        extend(&mut frame, &counting.range(&play.file, play.case.place_of(step)));
        frames.push(frame);
    }
    frames
}

fn extend(frame: &mut Json, range: &Json) {
    if let (Some(frame), Some(range)) = (frame.as_object_mut(), range.as_object()) {
        frame.extend(range.clone());
    }
}

/// `main, rung in line 12`
fn name(target: &Target, activation: &Activation, is_open: bool) -> String {
    let routine = routine_name(target, activation);
    if !is_open && target.simulation().status() != Status::Faulted {
        return format!("{routine}, before scan {}", target.simulation().scans());
    }
    format!("{routine}, {}", rung(target, activation.network))
}

/// The same of a frame that shows a block of a network that was run: `main, rung in line 12, end of scan 3`
fn name_after(target: &Target, activation: &Activation, network: usize, is_open: bool) -> String {
    let routine = match routine_of(target.simulation().program(), network) {
        routine if routine == activation.routine => routine_name(target, activation),
        // It has gone back to what called it.
        routine => routine_name(
            target,
            &Activation {
                routine,
                instance: None,
                ..*activation
            },
        ),
    };
    let rung = rung(target, network);
    if is_open || target.simulation().status() == Status::Faulted {
        return format!("{routine}, {rung}");
    }
    let scan = target.simulation().scans().saturating_sub(1);
    format!("{routine}, {rung}, end of scan {scan}")
}

fn routine_name(target: &Target, activation: &Activation) -> String {
    let program = target.simulation().program();
    match activation.routine {
        Routine::Main => "main".to_owned(),
        Routine::Function(function) => program.functions[function].name.clone(),
        Routine::Block(block) => {
            let block = &program.blocks[block].name;
            match target.instance_of(activation) {
                // Its place has a name of its own, and not the block's and a number.
                Some(instance) if instance.is_tag() => format!("{block}  {}", instance.name),
                Some(instance) => instance.name.clone(),
                None => block.clone(),
            }
        }
    }
}

/// The network that a block is in.
fn network_of(target: &Target, place: Location) -> Option<usize> {
    let mut networks = target.simulation().program().networks.iter();
    networks.position(|network| {
        network.location.file == place.file && network.location.range.contains_range(place.range)
    })
}

/// What a network belongs to.
fn routine_of(program: &Program, network: usize) -> Routine {
    let is_in = |networks: &std::ops::Range<usize>| networks.contains(&network);
    let function = program.functions.iter().position(|it| is_in(&it.networks));
    let block = || program.blocks.iter().position(|it| is_in(&it.networks));
    match function
        .map(Routine::Function)
        .or_else(|| block().map(Routine::Block))
    {
        Some(routine) => routine,
        None => Routine::Main,
    }
}

/// `rung in line 12: what a comment above it says`
fn rung(target: &Target, network: usize) -> String {
    let Location { file, range } = target.simulation().program().networks[network].location;
    let line = target.source(file).line(range.start()) + 1;
    format!("rung in line {line}{}", comment_above(target, file, range))
}

/// What a comment directly above a rung says, if it is short.
fn comment_above(target: &Target, file: u32, network: TextRange) -> String {
    const LONGEST: usize = 60;
    let source = target.source(file);
    let line = source.line(network.start());
    let Some(above) = line.checked_sub(1) else {
        return String::new();
    };
    let text = source.text[source.line_range(above)].trim();
    let comment = text.strip_prefix('#').and_then(|text| text.strip_suffix('#'));
    match comment
        .map(str::trim)
        .filter(|comment| !comment.is_empty() && !comment.contains('#'))
    {
        None => String::new(),
        Some(comment) if comment.chars().count() <= LONGEST => format!(": {comment}"),
        Some(comment) => {
            let start: String = comment.chars().take(LONGEST - 1).collect();
            format!(": {}…", start.trim_end())
        }
    }
}
