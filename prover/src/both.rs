//! Two programs over one graph with the same inputs: what they show, and which of what they remember may be the same.
//!
//! What both remember has one variable as far as it stays the same by its form: then equal logic is one node. With clauses that
//! say that two variables are equal a solver finds nothing in useful time.

use crate::encode::{Kept, Twins, World};
use crate::graph::{Lit, Node};
use crate::limits::End;
use crate::model::{Followed, Model, follow_into};
use crate::number::Number;
use crate::shown_tags::{Shared, Watched};
use ladder_analysis::values::types::Scalar;
use ladder_simulator::compiled::{Bit, Cell, Word, counterparts};
use ladder_simulator::expression::Expression;
use ladder_simulator::{Point, Simulation};
use rustc_hash::{FxHashMap, FxHashSet};

/// See the module.
pub(crate) struct Both {
    pub(crate) model: Model,
    /// High in a scan after which they differ: in each value that is compared, in faults, in whether they have ended.
    pub(crate) differs: Vec<Lit>,
    /// States of the old and of the new program that begin with the same value, may always hold the same, and have a variable each.
    pub(crate) pairs: Vec<(usize, usize)>,
}

/// A bit of a cell of the old program, that of the new one which it may be the same as, and the bit's number.
type Twin = (Kept, Kept, usize);

/// Follows both: first with one variable for all that may be the same, and then without what depends on something that is not.
///
/// # Errors
/// One cannot be followed, or they do not take the same inputs: why.
pub(crate) fn both(
    old: &Simulation,
    new: &Simulation,
    shared: &Shared,
    assumptions: &[Expression],
    end: &End,
) -> Result<Both, String> {
    let counterparts = counterparts(old, new);
    let mut apart: FxHashSet<Twin> = FxHashSet::default();
    loop {
        let two = Two::follow((old, new), (shared, assumptions), &counterparts, &apart, end)?;
        let different = two.different();
        if different.is_empty() {
            return Ok(two.finish(&shared.watched));
        }
        apart.extend(different);
    }
}

/// Both programs, followed.
struct Two {
    world: World,
    before: Followed,
    after: Followed,
    /// What has one variable, with the states of both programs.
    merged: Vec<(Twin, usize, usize)>,
    /// What has not.
    apart: Vec<(usize, usize)>,
}

/// In the place of a cell: the system tags, and whether the program is over.
const SYSTEM: Kept = Kept::Bit(u32::MAX);

impl Two {
    fn follow(
        (old, new): (&Simulation, &Simulation),
        (shared, assumptions): (&Shared, &[Expression]),
        counterparts: &[(Cell, Cell)],
        apart: &FxHashSet<Twin>,
        end: &End,
    ) -> Result<Two, String> {
        let mut world = World::until(end);
        world.compares = true;
        let watched = &shared.watched;
        let points: Vec<Point> = watched.iter().map(|watched| watched.old.clone()).collect();
        let before = follow_into(&mut world, old, &points, assumptions);
        let cells = cells(&before, counterparts);
        let mut twins = Twins {
            names: shared.renamed.formerly(),
            ..Twins::default()
        };
        let system: Vec<usize> = before.system.clone().chain(before.over).collect();
        twins.first.extend(system.iter().enumerate().map(|(bit, number)| {
            (!apart.contains(&(SYSTEM, SYSTEM, bit))).then_some(world.states[*number].leaf)
        }));
        for (is, (was, numbers)) in &cells {
            let bits = numbers.iter().enumerate().map(|(bit, number)| {
                let state = world.states[*number];
                (!apart.contains(&(*was, *is, bit))).then_some((state.leaf, state.initial))
            });
            twins.cells.insert(*is, bits.collect());
        }
        world.twins = twins;
        let points: Vec<Point> = watched.iter().map(|watched| watched.new.clone()).collect();
        let after = follow_into(&mut world, new, &points, &[]);
        if let Some(gap) = &world.blocked {
            return Err(gap.what.clone());
        }
        inputs_agree(&world)?;
        let mut two = Two {
            world,
            before,
            after,
            merged: Vec::new(),
            apart: Vec::new(),
        };
        let also: Vec<usize> = two.after.system.clone().chain(two.after.over).collect();
        for (bit, (was, is)) in system.into_iter().zip(also).enumerate() {
            two.pair((SYSTEM, SYSTEM, bit), was, is);
        }
        for (is, (was, numbers)) in cells {
            let also = two.after.kept.get(&is).cloned().unwrap_or_default();
            for (bit, (old, new)) in numbers.into_iter().zip(also).enumerate() {
                two.pair((was, is, bit), old, new);
            }
        }
        Ok(two)
    }

    fn pair(&mut self, twin: Twin, old: usize, new: usize) {
        let [was, is] = [old, new].map(|number| self.world.states[number]);
        if was.leaf == is.leaf {
            self.merged.push((twin, old, new));
        } else if was.initial == is.initial {
            self.apart.push((old, new));
        }
    }

    /// What has one variable and is not the same next, or depends on something that is not.
    fn different(&self) -> Vec<Twin> {
        let states = &self.world.states;
        let next = |number: usize| states[number].next;
        let (mut same, other): (Vec<_>, Vec<_>) =
            (self.merged.iter().copied()).partition(|(_, old, new)| next(*old) == next(*new));
        let mut different: Vec<Twin> = other.iter().map(|(twin, ..)| *twin).collect();
        if different.is_empty() {
            return different;
        }
        let graph = &self.world.graph;
        let mut touched = vec![false; graph.len()];
        for (_, old, _) in other {
            touched[states[old].leaf.node()] = true;
        }
        loop {
            for node in 0..graph.len() {
                if let Node::And(a, b) = graph.node(node) {
                    touched[node] |= touched[a.node()] || touched[b.node()];
                }
            }
            let count = same.len();
            same.retain(|(twin, old, _)| {
                let is_touched = touched[next(*old).node()];
                if is_touched {
                    touched[states[*old].leaf.node()] = true;
                    different.push(*twin);
                }
                !is_touched
            });
            if same.len() == count {
                return different;
            }
        }
    }

    fn finish(mut self, watched: &[Watched]) -> Both {
        let differs = self.differs(watched);
        // Of what has one variable one state is left.
        let gone: FxHashSet<usize> = self.merged.iter().map(|(_, _, new)| *new).collect();
        let mut numbers = Vec::with_capacity(self.world.states.len());
        let mut count = 0;
        for number in 0..self.world.states.len() {
            let stays = !gone.contains(&number);
            numbers.push(stays.then_some(count));
            count += usize::from(stays);
        }
        let mut world = self.world;
        let states = world.states.iter().zip(&numbers);
        world.states = (states.filter(|(_, number)| number.is_some()))
            .map(|(state, _)| *state)
            .collect();
        world.renumber(&numbers);
        let apart = self.apart.iter();
        let apart = apart.chain(&world.always);
        let pairs = apart.filter_map(|(old, new)| numbers[*old].zip(numbers[*new]));
        let pairs = pairs.collect();
        let mut assumed = std::mem::take(&mut world.valid);
        assumed.extend(&self.before.assumed);
        assumed.retain(|lit| *lit != Lit::TRUE);
        let model = Model {
            world,
            properties: Vec::new(),
            assumed,
            lemmas: Vec::new(),
        };
        Both {
            model,
            differs,
            pairs,
        }
    }

    fn differs(&mut self, watched: &[Watched]) -> Vec<Lit> {
        let (before, after) = (&self.before, &self.after);
        let ends = [before, after].map(|followed| match followed.over {
            Some(number) => self.world.states[number].next,
            None => Lit::FALSE,
        });
        let graph = &mut self.world.graph;
        let mut differs = Vec::with_capacity(watched.len() + 2);
        for ((old, new), watched) in before.points.iter().zip(&after.points).zip(watched) {
            let mut same = graph.equal(old, new);
            if watched.old.ty.is_real() {
                // 0 has two forms.
                let [old, new] = [old, new].map(|number| Number::unsigned(number.low(63)));
                let [old, new] = [old, new].map(|number| graph.equal(&number, &Number::constant(0)));
                let zeros = graph.and(old, new);
                same = graph.or(same, zeros);
            }
            differs.push(!same);
        }
        differs.push(graph.xor(before.faulted, after.faulted));
        differs.push(graph.xor(ends[0], ends[1]));
        // Nothing is compared after the end of one of them: that is a difference itself, or all stays as it is.
        let runs = graph.and(!before.is_over, !after.is_over);
        differs.into_iter().map(|lit| graph.and(lit, runs)).collect()
    }
}

/// An input of one name has one type.
fn inputs_agree(world: &World) -> Result<(), String> {
    let mut types: FxHashMap<&str, Scalar> = FxHashMap::default();
    for (name, ty) in world.shared.keys() {
        if *types.entry(name).or_insert(*ty) != *ty {
            return Err(format!("{name} is declared differently"));
        }
    }
    Ok(())
}

/// Of each cell of the new program that of the old one which is remembered there, with its states.
fn cells(before: &Followed, counterparts: &[(Cell, Cell)]) -> FxHashMap<Kept, (Kept, Vec<usize>)> {
    let mut cells: FxHashMap<Kept, (Kept, Vec<usize>)> = FxHashMap::default();
    let mut taken: FxHashSet<Kept> = FxHashSet::default();
    let mut add = |was: Kept, is: Kept| {
        if let Some(numbers) = before.kept.get(&was)
            && taken.insert(was)
        {
            cells.entry(is).or_insert_with(|| (was, numbers.clone()));
        }
    };
    for (was, is) in counterparts {
        match (*was, *is) {
            (Cell::Bit(Bit(was)), Cell::Bit(Bit(is))) => {
                add(Kept::Bit(was), Kept::Bit(is));
                // A timer has its phase and its age by its first bit.
                add(Kept::Phase(was), Kept::Phase(is));
                add(Kept::Age(was), Kept::Age(is));
            }
            (Cell::Word(Word(was)), Cell::Word(Word(is))) => add(Kept::Word(was), Kept::Word(is)),
            _ => {}
        }
    }
    cells
}
