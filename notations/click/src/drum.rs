//! Drums. Ladder text has none, so each kind of drum, of so many steps and outputs, becomes a block that is defined in front
//! of the program; a drum is one call of it, with its events or times and its pattern as operands.

use super::act::{Acts, Refusal, duration, given, pin, written};
use super::bank::{Bank, Kind};
use super::model::{Drum, Operand, Steps};
use super::operand::{kind, passes};
use super::tags::Tags;
use ladder_format::Circuit;
use ladder_format::program::{
    Block, Declaration, Drawing, Element, Expression, Invalid, Item, Literal, Network, Path, Section,
    SectionKind,
};
use ladder_instructions::Op;
use std::collections::btree_map::Entry;

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

    /// The name of its block, without the `$`.
    fn name(self) -> String {
        let kind = if self.is_timed { "Time" } else { "Event" };
        format!("{kind}Drum{}x{}", self.steps, self.outputs)
    }

    /// The shape whose block has this name, with the `$`.
    pub(super) fn named(name: &str) -> Option<Shape> {
        let name = name.strip_prefix('$')?;
        let (kind, size) = name.split_once("Drum")?;
        let (steps, outputs) = size.split_once('x')?;
        let shape = Shape {
            is_timed: kind == "Time",
            steps: steps.parse().ok()?,
            outputs: outputs.parse().ok()?,
        };
        (shape.name() == name).then_some(shape)
    }

    /// What ends its steps: `e1, e2, e3`, or `t1, t2, t3`.
    fn ends(self) -> Vec<String> {
        numbered(if self.is_timed { "t" } else { "e" }, self.steps)
    }

    /// Its block, as a text defines it.
    fn definition(self) -> Result<Item, Invalid> {
        let all = |names: Vec<String>, ty: &str| Declaration {
            names,
            ..Declaration::new("", ty)
        };
        let named = |names: &str, ty| all(names.split(", ").map(str::to_owned).collect(), ty);
        // What a drum may lack is given a value: it is called without it.
        let optional = |names, ty, initial: &str| Declaration {
            initial: Some(initial.to_owned()),
            ..named(names, ty)
        };
        let mut inputs = vec![
            named("reset", "BOOL"),
            optional("jump, jog", "BOOL", "FALSE"),
            optional("jump_to", "INT", "0"),
        ];
        let mut state = vec![named("now", "INT"), named("valid, came, acts", "BOOL")];
        state.push(named("pattern", "WORD"));
        let mut places = vec![named("step", "INT"), named("done", "BOOL")];
        if self.is_timed {
            inputs.extend([named("unit", "TIME"), all(self.ends(), "DINT")]);
            state.extend([
                named("moved", "BOOL"),
                named("clock", "RTO"),
                named("preset", "DINT"),
            ]);
            places.push(named("acc", "INT"));
        } else {
            inputs.push(all(self.ends(), "BOOL"));
            state.extend([named("before", "INT"), named("event, was", "BOOL")]);
        }
        inputs.push(all(numbered("p", self.steps), "WORD"));
        places.push(all(numbered("q", self.outputs), "BOOL"));
        let sections = [
            (SectionKind::VarInput, inputs),
            (SectionKind::VarInOut, places),
            (SectionKind::Var, state),
        ];
        let section = |(kind, declarations)| Section {
            declarations,
            ..Section::new(kind)
        };
        let items = sections.map(section).map(Item::Section).to_vec();
        let mut rungs = Rungs {
            items,
            moves: self.is_timed,
        };
        self.body(&mut rungs)?;
        Ok(Item::Block {
            header: format!("[${}]", self.name()),
            origin: None,
            items: rungs.items,
        })
    }

    /// The networks of its block.
    fn body(self, rungs: &mut Rungs) -> Result<(), Invalid> {
        use Op::{Eq, Ge, Le, Lt, Mov, Ne};
        let last = self.steps as i64;
        let now = || tag("now");
        let elapsed = || Path::tag("clock").member("ACC");
        let on = |name| Block::of(Op::Contact, [tag(name)]);
        let off = |name| Block::of(Op::NegatedContact, [tag(name)]);
        let rises = |name| Block::of(Op::RisingContact, [tag(name)]);
        let coil = |name| Block::of(Op::Coil, [tag(name)]);
        let no = || Expression::from(Literal::from(false));
        let next = || Block::of(Op::Add, [now(), now(), 1.into()]);
        // Of several values for a step each, that of the step.
        let chosen = |to: &str, none: Expression, of: Vec<String>| {
            let values = of.iter().map(|name| tag(name));
            Block::of(Op::Mux, [tag(to), now(), none].into_iter().chain(values))
        };
        // A step that there is not is the first one, and nothing ends in the scan that finds it.
        rungs.add([of(Ge, tag("step"), 1), of(Le, tag("step"), last), coil("valid")])?;
        rungs.add([Block::of(Op::Sel, [now(), tag("valid"), 1.into(), tag("step")])])?;
        if self.is_timed {
            rungs.add([on("EN"), off("valid"), coil("moved")])?;
            // The program may have written the time.
            rungs.add([of(Ne, elapsed(), tag("acc")), of(Mov, elapsed(), tag("acc"))])?;
            let longest = Expression::literal("T#32767d")?;
            let clock = [tag("clock").into(), longest.into(), given("B", tag("unit"))];
            rungs.add([on("EN"), Block::of(Op::Rto, clock)])?;
            let preset = chosen("preset", 0.into(), self.ends());
            rungs.add([on("EN"), preset, of(Ge, elapsed(), tag("preset")), coil("came")])?;
        } else {
            rungs.add([chosen("event", no(), self.ends())])?;
            let same = of(Eq, tag("before"), now());
            rungs.add([on("EN"), on("valid"), same, on("event"), off("was"), coil("came")])?;
        }
        let done = |done: bool| of(Mov, tag("done"), Literal::from(done));
        rungs.add([on("came"), of(Eq, now(), last), done(true)])?;
        rungs.add_move([on("came"), of(Lt, now(), last), next()])?;
        rungs.add_move([on("reset"), of(Mov, now(), 1), done(false)])?;
        let [first, upto] = [(Ge, 1), (Le, last)].map(|(op, step)| of(op, tag("jump_to"), step));
        let jumps = of(Mov, now(), tag("jump_to"));
        rungs.add_move([on("EN"), rises("jump"), first, upto, jumps])?;
        rungs.add_move([on("EN"), rises("jog"), of(Lt, now(), last), next()])?;
        if self.is_timed {
            rungs.add([on("moved"), Block::of(Op::Res, [tag("clock")])])?;
        } else {
            rungs.add([chosen("was", no(), self.ends()), of(Mov, tag("before"), now())])?;
        }
        let either = Circuit::Parallel(vec![series([on("EN")])?, series([on("reset")])?]);
        rungs.network(Circuit::Series(vec![either, series([coil("acts")])?]));
        let pattern = chosen("pattern", 0.into(), numbered("p", self.steps));
        rungs.add([on("acts"), pattern, of(Mov, tag("step"), now())])?;
        if self.is_timed {
            rungs.add([on("acts"), of(Mov, tag("acc"), elapsed())])?;
        }
        for (output, name) in (0..).zip(numbered("q", self.outputs)) {
            rungs.add([on("acts"), of(Mov, tag(&name), Path::tag("pattern").bit(output))])?;
        }
        Ok(())
    }
}

/// A block of the definition, if it can be one.
type Made = Result<Block, Invalid>;

fn of(op: Op, left: impl Into<Expression>, right: impl Into<Expression>) -> Made {
    Block::of(op, [left.into(), right.into()])
}

fn tag(name: &str) -> Expression {
    Path::tag(name).into()
}

/// `e1`, `e2`, `e3`
fn numbered(letter: &str, count: usize) -> Vec<String> {
    (1..=count).map(|number| format!("{letter}{number}")).collect()
}

/// The networks of a block that is being defined.
struct Rungs {
    items: Vec<Item>,
    /// Whether each move to another step is noted.
    moves: bool,
}

impl Rungs {
    fn network(&mut self, circuit: Circuit<Element>) {
        self.items.push(Item::Blank);
        self.items.push(Item::Network(Network {
            comments: Vec::new(),
            drawing: Drawing::Circuit(circuit),
        }));
    }

    fn add(&mut self, blocks: impl IntoIterator<Item = Made>) -> Result<(), Invalid> {
        self.network(series(blocks)?);
        Ok(())
    }

    fn add_move(&mut self, blocks: impl IntoIterator<Item = Made>) -> Result<(), Invalid> {
        let moved = self.moves.then(|| of(Op::Mov, tag("moved"), Literal::from(true)));
        self.add(blocks.into_iter().chain(moved))
    }
}

fn series(blocks: impl IntoIterator<Item = Made>) -> Result<Circuit<Element>, Invalid> {
    let element = |block: Made| Ok(Circuit::Element(Element::of(block?, None)));
    let elements: Result<_, Invalid> = blocks.into_iter().map(element).collect();
    Ok(Circuit::Series(elements?))
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
    if let Entry::Vacant(new) = tags.drum_blocks.entry(shape) {
        new.insert(shape.definition()?);
    }
    tags.drums += 1;
    let of = format!("drum{}", tags.drums);
    let mut operands = Vec::new();
    let pins = [("reset", &drum.reset), ("jump", &drum.jump), ("jog", &drum.jog)];
    for (name, condition) in pins {
        if let Some(condition) = condition {
            operands.push(given(name, pin(tags, acts, &of, name, condition)));
        }
    }
    if let Some(step) = &drum.jump_step {
        operands.push(given("jump_to", number(tags, acts, step, Kind::Int)?));
    }
    let ends = shape.ends().into_iter();
    match &drum.steps {
        Steps::Events(events) => {
            for ((at, name), event) in (1..).zip(ends).zip(events) {
                let event = pin(tags, acts, &of, &format!("event{at}"), event);
                operands.push(given(name, event));
            }
        }
        Steps::Times { presets, unit, .. } => {
            operands.push(given("unit", duration(1, *unit)?));
            for (name, preset) in ends.zip(presets) {
                operands.push(given(name, number(tags, acts, preset, Kind::Int2)?));
            }
        }
    }
    for (name, pattern) in numbered("p", shape.steps).into_iter().zip(&drum.pattern) {
        let bits = format!("2#{pattern:0width$b}", width = shape.outputs);
        operands.push(given(name, Expression::literal(bits)?));
    }
    let accumulator = match &drum.steps {
        Steps::Times { accumulator, .. } => Some(("acc".to_owned(), accumulator)),
        Steps::Events(_) => None,
    };
    let places = [("step", &drum.current_step), ("done", &drum.completion_flag)];
    let places = places.map(|(name, place)| (name.to_owned(), place));
    let outputs = numbered("q", shape.outputs).into_iter().zip(&drum.outputs);
    for (name, place) in places.into_iter().chain(accumulator).chain(outputs) {
        written(place)?;
        operands.push(given(name, tags.place(place)));
    }
    acts.chain.blocks.push(Block::user(shape.name(), operands)?);
    Ok(())
}

/// A whole number where one is asked for.
fn number(tags: &mut Tags<'_>, acts: &mut Acts, value: &Operand, most: Kind) -> Result<Expression, Refusal> {
    let goes = match value {
        Operand::Constant(constant) => super::operand::fits(constant, most),
        other => kind(other).is_some_and(|from| from != Kind::Hex && passes(from, most)),
    };
    if !goes {
        return Err("the steps and times of a drum are whole numbers, or addresses of DS".to_owned());
    }
    acts.chain.value(tags, value, Some(most))
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
