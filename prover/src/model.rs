//! A program with its properties as one machine of bits: what is remembered, what goes in, and for each property a bit that is
//! high in a scan that violates it.

use crate::encode::{Cells, Gap, Kept, Memory, Scan, Times, World};
use crate::graph::Lit;
use crate::limits::End;
use crate::number::Number;
use crate::system;
use ladder_analysis::values::types::Scalar;
use ladder_simulator::compiled::{Compiled, Instr, PointSlot, Routine};
use ladder_simulator::expression::{Expression, Kind, Past, PastKind, Source};
use ladder_simulator::scenario::{Form, Watched};
use ladder_simulator::{Options, Point, Simulation};
use rustc_hash::FxHashMap;
use std::collections::BTreeSet;
use std::ops::Range;

/// See the module.
#[derive(Debug)]
pub(crate) struct Model {
    pub(crate) world: World,
    /// In the order of the properties.
    pub(crate) properties: Vec<Target>,
    /// What is assumed of each scan, and what inputs cannot be is excluded.
    pub(crate) assumed: Vec<Lit>,
    /// What always holds before a scan.
    pub(crate) lemmas: Vec<Lit>,
}

/// A property.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Target {
    /// High in a scan that violates it; of one that is to be possible, in a scan that has it.
    pub(crate) bad: Lit,
    /// High in a scan in which what is on its left side is so.
    pub(crate) trigger: Option<Lit>,
    /// High in a scan after which a fault happens in one of its expressions.
    pub(crate) fault: Lit,
}

/// Builds the model of a program; one that cannot be followed is blocked, and its properties mean nothing.
pub(crate) fn build(simulation: &Simulation, watched: &Watched, times: Times, end: &End) -> Model {
    let mut seen = Vec::new();
    let mut see = |expression: &Expression| {
        expression.for_each_point(&mut |point| seen.push(point.slot()));
        Ok::<(), ()>(())
    };
    for property in &watched.properties {
        let _: Result<Form<()>, ()> = property.form.try_map(&mut see);
    }
    watched.assumptions.iter().for_each(|assumption| {
        let _: Result<(), ()> = see(assumption);
    });
    let mut world = World::until(end);
    world.ranges = ranges(simulation, &seen, times, end);
    follow(&mut world, simulation, &seen, times, |builder| {
        builder.properties(watched)
    })
}

/// The model of a program without properties, with the bits of each point after the scan.
pub(crate) fn build_with_points(simulation: &Simulation, times: Times) -> (Model, Vec<(Point, Vec<Lit>)>) {
    let seen: Vec<PointSlot> = simulation.points().iter().map(Point::slot).collect();
    follow(&mut World::default(), simulation, &seen, times, |builder| {
        let points = simulation.points().iter();
        let points = points.filter(|point| !matches!(point.slot(), PointSlot::Text(_)));
        let points = points.map(|point| {
            let bits = if point.ty == Scalar::Bool { 1 } else { 64 };
            (point.clone(), builder.point(point).low(bits))
        });
        let points = points.collect();
        let nothing = Watched {
            assumptions: Vec::new(),
            properties: Vec::new(),
        };
        (builder.properties(&nothing), points)
    })
}

/// A program that was followed into a world in which another one may be.
pub(crate) struct Followed {
    /// What the points hold after the scan.
    pub(crate) points: Vec<Number>,
    /// What is assumed of each scan.
    pub(crate) assumed: Vec<Lit>,
    pub(crate) faulted: Lit,
    /// An earlier scan ended the program.
    pub(crate) is_over: Lit,
    /// What is remembered for the system tags: the same states in the same order of every program.
    pub(crate) system: Range<usize>,
    /// The state that says whether the program is over, of one that may come to its end.
    pub(crate) over: Option<usize>,
    pub(crate) kept: FxHashMap<Kept, Vec<usize>>,
}

/// Follows a program into a world, with exact times, and no texts among the points.
pub(crate) fn follow_into(
    world: &mut World,
    simulation: &Simulation,
    points: &[Point],
    assumptions: &[Expression],
) -> Followed {
    let mut seen: Vec<PointSlot> = points.iter().map(Point::slot).collect();
    for assumption in assumptions {
        assumption.for_each_point(&mut |point| seen.push(point.slot()));
    }
    follow(world, simulation, &seen, Times::Exact, |builder| {
        let assumed = builder.assumed(assumptions);
        let points = points.iter().map(|point| builder.point(point)).collect();
        let kept = builder.memory.kept().collect();
        builder.memory.finish(builder.world);
        Followed {
            points,
            assumed,
            faulted: builder.faulted,
            is_over: builder.is_over,
            system: builder.system.clone(),
            over: builder.over,
            kept,
        }
    })
}

/// More numbers of a program are not tried as inputs.
const MOST_NUMBERS: usize = 200;

/// What the words of a program can hold before any scan.
fn ranges(
    simulation: &Simulation,
    seen: &[PointSlot],
    times: Times,
    end: &End,
) -> FxHashMap<u32, (i128, i128)> {
    let mut world = World::until(end);
    follow(&mut world, simulation, seen, times, |builder| {
        builder.memory.ranges()
    })
}

/// Follows a scan, and then what else is to be done with it.
fn follow<T>(
    world: &mut World,
    simulation: &Simulation,
    seen: &[PointSlot],
    times: Times,
    then: impl FnOnce(&mut Builder<'_, '_>) -> T,
) -> T {
    let compiled = simulation.compiled();
    let cells = Cells::of(simulation.program(), compiled, seen);
    let options = simulation.options();
    // The longest presets must be known before ages have their room.
    let mut first = World {
        end: world.end.clone(),
        ..World::default()
    };
    Builder::scan(&mut first, compiled, &cells, Times::Open, options);
    world.presets = first.presets;
    let numbers = compiled
        .initial
        .words
        .iter()
        .copied()
        .filter(|number| *number != 0);
    let numbers: BTreeSet<i64> = numbers.take(MOST_NUMBERS).collect();
    world.constants.extend(numbers);
    let mut builder = Builder::scan(world, compiled, &cells, times, options);
    then(&mut builder)
}

/// A scan that was followed, while properties are added.
struct Builder<'w, 'c> {
    world: &'w mut World,
    memory: Memory<'c>,
    faulted: Lit,
    /// An earlier scan ended the program.
    is_over: Lit,
    /// A fault happens in the expressions that were added last.
    fault: Lit,
    over: Option<usize>,
    system: Range<usize>,
    interval: i64,
}

impl<'w, 'c> Builder<'w, 'c> {
    fn scan(
        world: &'w mut World,
        compiled: &'c Compiled,
        cells: &'c Cells,
        times: Times,
        options: Options,
    ) -> Builder<'w, 'c> {
        let interval = options.interval;
        let mut memory = Memory::new(&compiled.initial, Some(cells));
        let first = world.states.len();
        let had_fault = system::set(world, &mut memory, interval, compiled.system_of_plants());
        let system = first..world.states.len();
        let may_end = compiled.code.instrs.iter().any(|instr| {
            matches!(
                instr,
                Instr::End { .. }
                    | Instr::Routine {
                        routine: Routine::EndOnDivision,
                        ..
                    }
            )
        }) || compiled.code.relays.stop.is_some();
        let over = may_end.then(|| world.remember(false));
        let is_over = over.map_or(Lit::FALSE, |(leaf, _)| leaf);
        let scan = Scan::new(world, &compiled.code, memory, (times, interval), !is_over);
        let mut scan = scan.within(options.watchdog);
        if cells.has_unknown_writes {
            scan.stop("an index reaches into something that is not known", 0);
        }
        scan.run();
        let (in_plants, in_program, mut ended) = (scan.faulted_before, scan.faulted, scan.ended);
        let mut memory = scan.memory;
        if let Some(stop) = compiled.code.relays.stop {
            let stops = memory.bit(world, stop);
            ended = world.graph.or(ended, stops);
        }
        world.states[had_fault.program].next = in_program;
        if let Some(number) = had_fault.plants {
            world.states[number].next = in_plants;
        }
        let faulted = world.graph.or(in_plants, in_program);
        if let Some((leaf, number)) = over {
            world.states[number].next = world.graph.or(leaf, ended);
        }
        Builder {
            world,
            memory,
            faulted,
            is_over,
            fault: Lit::FALSE,
            over: over.map(|(_, number)| number),
            system,
            interval,
        }
    }

    /// Adds the properties, and ends the scan.
    fn properties(&mut self, watched: &Watched) -> Model {
        let mut assumed = self.assumed(&watched.assumptions);
        let mut properties = Vec::new();
        for property in &watched.properties {
            self.fault = Lit::FALSE;
            let (bad, trigger) = self.form(&property.form);
            let [bad, fault] = [bad, self.fault].map(|lit| self.world.graph.and(lit, !self.is_over));
            properties.push(Target { bad, trigger, fault });
        }
        self.memory.finish(self.world);
        assumed.append(&mut self.world.valid);
        let world = std::mem::take(self.world);
        assumed.retain(|lit| *lit != Lit::TRUE);
        Model {
            world,
            properties,
            assumed,
            lemmas: Vec::new(),
        }
    }

    fn assumed(&mut self, assumptions: &[Expression]) -> Vec<Lit> {
        let assumed = assumptions.iter().map(|assumption| {
            let holds = self.holds(assumption);
            // Nothing is checked after the end.
            self.world.graph.or(holds, self.is_over)
        });
        assumed.collect()
    }

    fn form(&mut self, form: &Form<Expression>) -> (Lit, Option<Lit>) {
        match form {
            Form::Always(e) => (!self.holds(e), None),
            Form::Never(e) => (self.holds(e), None),
            Form::Possible { what, within } => {
                let what = self.holds(what);
                let Some(within) = within else {
                    return (what, None);
                };
                let scans = Number::constant(within.scans(self.interval) as i64);
                let (count, numbers) = self.counter(&scans);
                let graph = &mut self.world.graph;
                let soon = !graph.less(&scans, &count);
                let more = graph.add(&count, &Number::constant(1));
                let next = graph.choose_number(soon, &more, &count);
                self.becomes(&numbers, &next);
                (self.world.graph.and(what, soon), None)
            }
            Form::When {
                condition,
                then,
                until,
            } => {
                let (condition, then) = (self.holds(condition), self.holds(then));
                let Some(until) = until else {
                    return (self.world.graph.and(condition, !then), Some(condition));
                };
                let until = self.holds(until);
                let (was_armed, number) = self.world.remember(false);
                let graph = &mut self.world.graph;
                let armed = graph.or(was_armed, condition);
                let armed = graph.and(armed, !until);
                self.world.states[number].next = armed;
                (self.world.graph.and(armed, !then), Some(condition))
            }
            Form::After { condition, then } => {
                let (condition, then) = (self.holds(condition), self.holds(then));
                let (was, number) = self.world.remember(false);
                self.world.states[number].next = condition;
                (self.world.graph.and(was, !then), Some(condition))
            }
            Form::Within {
                span,
                condition,
                then,
            } => {
                let (condition, then) = (self.holds(condition), self.holds(then));
                // 0: nothing waits; else one more than the scans that it waits.
                let most = Number::constant(span.scans(self.interval) as i64 + 1);
                let (waits, numbers) = self.counter(&most);
                self.world.waits.push(numbers.clone());
                let zero = Number::constant(0);
                let graph = &mut self.world.graph;
                let waiting = graph.less(&zero, &waits);
                let more = graph.add(&waits, &Number::constant(1));
                let more = graph.min(&more, &most);
                let begins = Number::of_bit(condition);
                let next = graph.choose_number(waiting, &more, &begins);
                let next = graph.choose_number(then, &zero, &next);
                let late = !graph.less(&next, &most);
                self.becomes(&numbers, &next);
                (late, Some(condition))
            }
            Form::NoFaults => (self.faulted, None),
        }
    }

    /// A number that is remembered and never more than one more than this.
    fn counter(&mut self, most: &Number) -> (Number, Vec<usize>) {
        let bits = most.len() + 1;
        let (leaves, numbers) = (0..bits).map(|_| self.world.remember(false)).unzip();
        (Number::unsigned(leaves), numbers)
    }

    fn becomes(&mut self, numbers: &[usize], next: &Number) {
        for (n, number) in numbers.iter().enumerate() {
            self.world.states[*number].next = next.bit(n);
        }
    }

    /// Whether a condition holds after the scan: a fault in it makes it FALSE.
    fn holds(&mut self, expression: &Expression) -> Lit {
        self.value(expression).bit(0)
    }

    /// The value after the scan; 0 where a fault happens in it.
    fn value(&mut self, expression: &Expression) -> Number {
        let (small, inputs, result) = match expression.kind() {
            Kind::Point(point) => return self.point(point),
            Kind::Computed {
                small,
                inputs,
                result,
            } => (small, inputs, result),
        };
        let compiled = small.compiled();
        let mut values = Vec::with_capacity(inputs.len());
        for (source, _) in inputs {
            values.push(match source {
                Source::Point(point) => self.point(point),
                Source::Past(past) => self.past(past),
            });
        }
        let mut memory = Memory::new(&compiled.initial, None);
        for ((_, to), value) in inputs.iter().zip(values) {
            match to.slot() {
                PointSlot::Bit(bit) => memory.set_bit(bit, value.bit(0)),
                PointSlot::Word(word) => memory.set_word(word, value),
                _ => {}
            }
        }
        let mut scan = Scan::of_expression(self.world, (&compiled.code, &compiled.initial), memory);
        scan.run();
        if scan.has_lost() {
            let what = String::from("an expression of a property is not followed");
            let bits = self.world.open_bits(Gap { what, location: None }, 64);
            return Number::of_bits(bits);
        }
        let (faulted, mut memory) = (scan.faulted, scan.memory);
        self.fault = self.world.graph.or(self.fault, faulted);
        let value = match result.slot() {
            PointSlot::Bit(bit) => Number::of_bit(memory.bit(self.world, bit)),
            PointSlot::Word(word) => memory.word(self.world, word),
            _ => Number::constant(0),
        };
        self.world
            .graph
            .choose_number(faulted, &Number::constant(0), &value)
    }

    /// What an expression was, with what it is now.
    fn past(&mut self, past: &Past) -> Number {
        let now = self.value(&past.of);
        let bits = if past.of.ty() == Scalar::Bool { 1 } else { 64 };
        let (leaves, numbers): (Vec<Lit>, Vec<usize>) = (0..bits).map(|_| self.world.remember(false)).unzip();
        self.becomes(&numbers, &now);
        let graph = &mut self.world.graph;
        match past.kind {
            PastKind::Was if bits == 1 => Number::of_bit(leaves[0]),
            PastKind::Was => Number::of_bits(leaves),
            PastKind::Rises => Number::of_bit(graph.and(now.bit(0), !leaves[0])),
            PastKind::Falls => Number::of_bit(graph.and(!now.bit(0), leaves[0])),
        }
    }

    fn point(&mut self, point: &Point) -> Number {
        match point.slot() {
            PointSlot::Bit(bit) => Number::of_bit(self.memory.bit(self.world, bit)),
            PointSlot::Word(word) => self.memory.word(self.world, word),
            PointSlot::BitOf { word, bit, .. } => {
                let word = self.memory.word(self.world, word);
                Number::of_bit(word.bit(usize::from(bit)))
            }
            PointSlot::Timing { input, done } => {
                let (input, done) = (
                    self.memory.bit(self.world, input),
                    self.memory.bit(self.world, done),
                );
                Number::of_bit(self.world.graph.and(input, !done))
            }
            PointSlot::Text(_) => Number::constant(0),
        }
    }
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;
    use ladder_simulator::Options;
    use ladder_simulator::scenario::{bind_properties, parse};
    use std::sync::Arc;
    use std::time::Duration;

    /// The model of a program with the times that it has, and of its properties, with scans of 100 ms.
    pub(crate) fn model_of(program: &str, properties: &str) -> Model {
        let analysis = ladder_analysis::analyze(&Arc::new(ladder_syntax::parse(program)), "p.clad");
        let options = Options {
            interval: 100_000_000,
            ..Options::default()
        };
        let program = analysis.program().cloned().expect("it has no errors");
        let simulation = Simulation::new(program, options).expect("it compiles");
        let suite = parse(&format!("program p.clad\n{properties}\n"));
        let (watched, _) = bind_properties(&suite, &simulation);
        let end = End::in_time(Duration::from_secs(20));
        build(&simulation, &watched, Times::Exact, &end)
    }
}
