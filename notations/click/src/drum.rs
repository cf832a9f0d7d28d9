//! Drums. Ladder text has none, so each kind of drum, of so many steps and outputs, becomes a block that is defined in front
//! of the program; a drum is one call of it, with its events or times and its pattern as operands.

use super::act::{Acts, Refusal, pin, written};
use super::bank::{Bank, Kind};
use super::model::{Drum, Operand, Steps};
use super::operand::{kind, passes};
use super::tags::Tags;
use ladder_format::Circuit;
use ladder_format::program::{Declaration, Drawing, Element, Item, Network, Section, SectionKind};

/// What drums that share a block have in common.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Shape {
    /// Whether times end its steps; else events do.
    pub(super) is_timed: bool,
    pub(super) steps: usize,
    pub(super) outputs: usize,
}

impl Shape {
    const fn of(drum: &Drum) -> Shape {
        Shape {
            is_timed: matches!(drum.steps, Steps::Times { .. }),
            steps: drum.steps.len(),
            outputs: drum.outputs.len(),
        }
    }

    /// The name of its block, with the `$`.
    fn name(self) -> String {
        let kind = if self.is_timed { "Time" } else { "Event" };
        format!("${kind}Drum{}x{}", self.steps, self.outputs)
    }

    /// The shape whose block has this name.
    pub(super) fn named(name: &str) -> Option<Shape> {
        let (kind, size) = name.strip_prefix('$')?.split_once("Drum")?;
        let (steps, outputs) = size.split_once('x')?;
        let shape = Shape {
            is_timed: kind == "Time",
            steps: steps.parse().ok()?,
            outputs: outputs.parse().ok()?,
        };
        (shape.name() == name).then_some(shape)
    }

    /// What ends a step is `t1` or `e1`.
    const fn letter(self) -> char {
        if self.is_timed { 't' } else { 'e' }
    }

    /// `e1, e2, e3`
    fn list(letter: char, count: usize) -> String {
        let names: Vec<String> = (1..=count).map(|number| format!("{letter}{number}")).collect();
        names.join(", ")
    }

    /// Its block, as a text defines it.
    pub(super) fn definition(self) -> Item {
        // What a drum may lack is given a value: it is called without it.
        let initial = |ty: &str, names: &str| match (ty, names) {
            ("BOOL", "jump, jog") => Some("FALSE".to_owned()),
            ("INT", "jump_to") => Some("0".to_owned()),
            _ => None,
        };
        let section = |kind, declarations: &[(&str, &str)]| {
            let mut section = Section::new(kind);
            section.declarations = declarations
                .iter()
                .map(|(names, ty)| Declaration {
                    names: names.split(", ").map(str::to_owned).collect(),
                    initial: initial(ty, names),
                    ..Declaration::new("", *ty)
                })
                .collect();
            Item::Section(section)
        };
        let steps = self.steps;
        let ends = Shape::list(self.letter(), steps);
        let patterns = Shape::list('p', steps);
        let outputs = Shape::list('q', self.outputs);
        let mut inputs = vec![("reset", "BOOL"), ("jump, jog", "BOOL"), ("jump_to", "INT")];
        let mut state = vec![("now", "INT"), ("valid, came, acts", "BOOL"), ("pattern", "WORD")];
        let mut places = vec![("step", "INT"), ("done", "BOOL")];
        if self.is_timed {
            inputs.extend([("unit", "TIME"), (&ends, "DINT")]);
            state.extend([("moved", "BOOL"), ("clock", "RTO"), ("preset", "DINT")]);
            places.push(("acc", "INT"));
        } else {
            inputs.push((&ends, "BOOL"));
            state.extend([("before", "INT"), ("event, was", "BOOL")]);
        }
        inputs.push((&patterns, "WORD"));
        places.push((&outputs, "BOOL"));
        let items = vec![
            section(SectionKind::VarInput, &inputs),
            section(SectionKind::VarInOut, &places),
            section(SectionKind::Var, &state),
        ];
        let mut rungs = Rungs {
            items,
            moves: self.is_timed.then_some("[MOV]( moved, TRUE )"),
        };
        self.body(&mut rungs, &ends, &patterns);
        Item::Block {
            header: format!("[{}]", self.name()),
            items: rungs.items,
        }
    }

    /// The networks of its block.
    fn body(self, rungs: &mut Rungs, ends: &str, patterns: &str) {
        let last = self.steps;
        // A step that there is not is the first one, and nothing ends in the scan that finds it.
        rungs.add(&[
            "[GE]( step, 1 )",
            &format!("[LE]( step, {last} )"),
            "( )( valid )",
        ]);
        rungs.add(&["[SEL]( now, valid, 1, step )"]);
        if self.is_timed {
            rungs.add(&["[ ]( EN )", "[/]( valid )", "( )( moved )"]);
            // The program may have written the time.
            rungs.add(&["[NE]( clock.ACC, acc )", "[MOV]( clock.ACC, acc )"]);
            rungs.add(&["[ ]( EN )", "[RTO]( clock, T#32767d, B := unit )"]);
            let choose = format!("[MUX]( preset, now, 0, {ends} )");
            rungs.add(&["[ ]( EN )", &choose, "[GE]( clock.ACC, preset )", "( )( came )"]);
        } else {
            rungs.add(&[&format!("[MUX]( event, now, FALSE, {ends} )")]);
            let in_step = ["[ ]( valid )", "[EQ]( before, now )"];
            rungs.add(&[
                "[ ]( EN )",
                in_step[0],
                in_step[1],
                "[ ]( event )",
                "[/]( was )",
                "( )( came )",
            ]);
        }
        let (at_last, on) = (format!("[EQ]( now, {last} )"), format!("[LT]( now, {last} )"));
        rungs.add(&["[ ]( came )", &at_last, "[MOV]( done, TRUE )"]);
        rungs.add_move(&["[ ]( came )", &on, "[ADD]( now, now, 1 )"]);
        rungs.add_move(&["[ ]( reset )", "[MOV]( now, 1 )", "[MOV]( done, FALSE )"]);
        let upto = format!("[LE]( jump_to, {last} )");
        rungs.add_move(&[
            "[ ]( EN )",
            "[P]( jump )",
            "[GE]( jump_to, 1 )",
            &upto,
            "[MOV]( now, jump_to )",
        ]);
        rungs.add_move(&["[ ]( EN )", "[P]( jog )", &on, "[ADD]( now, now, 1 )"]);
        if self.is_timed {
            rungs.add(&["[ ]( moved )", "(RES)( clock )"]);
        } else {
            rungs.add(&[
                &format!("[MUX]( was, now, FALSE, {ends} )"),
                "[MOV]( before, now )",
            ]);
        }
        let either = ["[ ]( EN )", "[ ]( reset )"].map(|contact| series(&[contact]));
        rungs.network(Circuit::Series(vec![
            Circuit::Parallel(either.to_vec()),
            series(&["( )( acts )"]),
        ]));
        let pattern = format!("[MUX]( pattern, now, 0, {patterns} )");
        rungs.add(&["[ ]( acts )", &pattern, "[MOV]( step, now )"]);
        if self.is_timed {
            rungs.add(&["[ ]( acts )", "[MOV]( acc, clock.ACC )"]);
        }
        for output in 0..self.outputs {
            rungs.add(&[
                "[ ]( acts )",
                &format!("[MOV]( q{}, pattern.{output} )", output + 1),
            ]);
        }
    }
}

/// The networks of a block that is being defined.
struct Rungs {
    items: Vec<Item>,
    /// What is done in each move to another step.
    moves: Option<&'static str>,
}

impl Rungs {
    fn network(&mut self, circuit: Circuit<Element>) {
        self.items.push(Item::Blank);
        self.items.push(Item::Network(Network {
            comments: Vec::new(),
            drawing: Drawing::Circuit(circuit),
        }));
    }

    fn add(&mut self, blocks: &[&str]) {
        self.network(series(blocks));
    }

    fn add_move(&mut self, blocks: &[&str]) {
        let all: Vec<&str> = blocks.iter().copied().chain(self.moves).collect();
        self.add(&all);
    }
}

fn series(blocks: &[&str]) -> Circuit<Element> {
    let element = |block: &&str| Circuit::Element(Element::block(*block, None));
    Circuit::Series(blocks.iter().map(element).collect())
}

/// The patterns of the steps as numbers, whose lowest bit is the first output.
///
/// # Errors
///
/// A step has not a value for each output.
pub(super) fn patterns(steps: &[Vec<bool>], outputs: usize) -> Result<Vec<u16>, String> {
    if outputs > Drum::MOST || steps.iter().any(|step| step.len() != outputs) {
        return Err(format!(
            "each step of its pattern has a value for each of the outputs, {} at most",
            Drum::MOST
        ));
    }
    let number = |step: &Vec<bool>| (0..).zip(step).map(|(at, on)| u16::from(*on) << at).sum();
    Ok(steps.iter().map(number).collect())
}

/// Why Click has no such drum.
fn problem(drum: &Drum) -> Option<&'static str> {
    let is_bit = |bank| matches!(bank, Bank::Y | Bank::C);
    let (steps, outputs) = (drum.steps.len(), drum.outputs.len());
    if !(1..=Drum::MOST).contains(&steps) || !(1..=Drum::MOST).contains(&outputs) {
        return Some("a drum has one to sixteen steps, and one to sixteen outputs");
    }
    if drum.pattern.len() != steps {
        return Some("its pattern has not as many steps as there are events or times");
    }
    if !drum.outputs.iter().all(|output| is_bit(output.bank)) || drum.completion_flag.bank != Bank::C {
        return Some("the outputs of a drum are addresses of Y and C, its completion flag is one of C");
    }
    if drum.current_step.bank != Bank::Ds {
        return Some("the step of a drum is in an address of DS");
    }
    match &drum.steps {
        Steps::Times { accumulator, .. } if accumulator.bank != Bank::Td => {
            return Some("the time of a drum is in an address of TD");
        }
        _ => {}
    }
    if drum.reset.is_none() {
        return Some("a drum needs its reset");
    }
    if drum.jump.is_some() != drum.jump_step.is_some() {
        return Some("a jump has its contact and its step");
    }
    None
}

/// The call of a drum's block.
///
/// # Errors
///
/// Click has no such drum.
pub(super) fn acts(tags: &mut Tags<'_>, acts: &mut Acts, drum: &Drum) -> Result<(), Refusal> {
    if let Some(why) = problem(drum) {
        return Err(why.to_owned());
    }
    let shape = Shape::of(drum);
    tags.drums.push(shape);
    let of = format!("drum{}", tags.drums.len());
    let mut operands: Vec<String> = Vec::new();
    let pins = [("reset", &drum.reset), ("jump", &drum.jump), ("jog", &drum.jog)];
    for (name, condition) in pins {
        if let Some(condition) = condition {
            operands.push(format!("{name} := {}", pin(tags, acts, &of, name, condition)));
        }
    }
    if let Some(step) = &drum.jump_step {
        operands.push(format!("jump_to := {}", number(tags, acts, step, Kind::Int)?));
    }
    match &drum.steps {
        Steps::Events(events) => {
            for (at, event) in (1..).zip(events) {
                let event = pin(tags, acts, &of, &format!("event{at}"), event);
                operands.push(format!("e{at} := {event}"));
            }
        }
        Steps::Times { presets, unit, .. } => {
            operands.push(format!("unit := T#1{}", unit.suffix()));
            for (at, preset) in (1..).zip(presets) {
                operands.push(format!("t{at} := {}", number(tags, acts, preset, Kind::Int2)?));
            }
        }
    }
    for (at, pattern) in (1..).zip(&drum.pattern) {
        operands.push(format!("p{at} := 2#{pattern:0width$b}", width = shape.outputs));
    }
    let mut place = |name: &str, tag| -> Result<(), Refusal> {
        written(tag)?;
        operands.push(format!("{name} := {}", tags.text(tag)));
        Ok(())
    };
    place("step", &drum.current_step)?;
    place("done", &drum.completion_flag)?;
    if let Steps::Times { accumulator, .. } = &drum.steps {
        place("acc", accumulator)?;
    }
    for (at, output) in (1..).zip(&drum.outputs) {
        place(&format!("q{at}"), output)?;
    }
    acts.chain
        .push(format!("[{}]( {} )", shape.name(), operands.join(", ")));
    Ok(())
}

/// A whole number where one is asked for.
fn number(tags: &mut Tags<'_>, acts: &mut Acts, value: &Operand, most: Kind) -> Result<String, Refusal> {
    let goes = match value {
        Operand::Constant(constant) => super::operand::fits(constant, most),
        other => kind(other).is_some_and(|from| from != Kind::Hex && passes(from, most)),
    };
    if !goes {
        return Err("the steps and times of a drum are whole numbers, or addresses of DS".to_owned());
    }
    Ok(acts.chain.value(tags, value, Some(most)))
}

#[cfg(test)]
mod tests {
    use crate::Click;
    use ladder_notation::{Notation, Source};

    /// Why a drum with these arguments stays as a comment.
    fn refused(drum: &str) -> String {
        let text = format!("def main():\n    if x[1]:\n        {drum}\n    if True:\n        end()\n");
        match Click.read(&Source::alone("test", text.as_bytes())) {
            Ok(reading) => {
                let all = reading.report.entries.iter();
                let outcomes = all.filter_map(|entry| match &entry.outcome {
                    ladder_notation::Outcome::Refused(why) => Some(why.clone()),
                    _ => None,
                });
                outcomes.collect()
            }
            Err(error) => error.to_string(),
        }
    }

    #[test]
    fn drums_that_click_has_not() {
        let many = vec!["x[1]"; 17].join(", ");
        let rows = vec!["[1]"; 17].join(", ");
        let of = "current_step=ds[1], completion_flag=c[1], reset=lambda: x[2]";
        for (drum, why) in [
            (format!("event_drum([y[1]], [x[1]], [[1]], {of})"), ""),
            (
                format!("event_drum([y[1]], [x[1], x[2]], [[1]], {of})"),
                "its pattern has not as many steps as there are events or times",
            ),
            (
                format!("event_drum([y[1]], [{many}], [{rows}], {of})"),
                "a drum has one to sixteen steps, and one to sixteen outputs",
            ),
            (
                format!("event_drum([ds[1]], [x[1]], [[1]], {of})"),
                "the outputs of a drum are addresses of Y and C, its completion flag is one of C",
            ),
            (
                "event_drum([y[1]], [x[1]], [[1]], ds[1], c[1])".to_owned(),
                "a drum needs its reset",
            ),
            (
                format!("event_drum([y[1]], [x[1]], [[1]], {of}, jump=lambda: x[3])"),
                "a jump has its contact and its step",
            ),
            (
                "time_drum([y[1]], [5], Ts, [[1]], ds[1], ds[2], c[1], lambda: x[2])".to_owned(),
                "the time of a drum is in an address of TD",
            ),
            (
                format!("event_drum([y[1]], [x[1]], [[1, 0]], {of})"),
                "3:36: each step of its pattern has a value for each of the outputs, 16 at most",
            ),
            (
                format!("event_drum([y[1]], [x[1]], [[2]], {of})"),
                "3:38: a drum's output is 0 or 1 in each step",
            ),
            (
                format!("event_drum(y[1], [x[1]], [[1]], {of})"),
                "3:20: a drum has lists here: [y[1], y[2]]",
            ),
        ] {
            assert_eq!(refused(&drum), why, "{drum}");
        }
    }
}
