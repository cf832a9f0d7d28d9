//! What steps do with actions, and the bodies of those.

use super::lower::Lowering;
use super::model::{Act, Action, Qualifier, Step};
use super::networks::{Networks, Part, any, block, contact, element, not, zero};
use super::whole_seconds;
use ladder_format::Circuit;
use ladder_format::program::{Block, Drawing, Element, Expression, Item, Network, Origin, Path};
use ladder_instructions::Op;

/// As many steps that decide about one body are drawn as one network.
const MOST_IN_ONE: usize = 8;

/// A body of no more networks has the contact of its action in each of them.
const MOST_GUARDED: usize = 3;

/// What a step does with an action.
struct Told<'c> {
    step: usize,
    qualifier: &'c Qualifier,
}

/// What an action remembers.
#[derive(Default)]
struct Memory {
    /// The TIME until it is set, and the BOOL that says that it is now.
    set: Option<(String, String)>,
    /// The same until it is reset.
    reset: Option<(String, String)>,
    /// What holds that it is stored, where it is no variable.
    stored: Option<String>,
}

/// The actions of a chart.
pub(super) fn lower(
    lowering: &mut Lowering<'_>,
    steps: &[Step],
    actions: Vec<Action>,
    networks: &mut Networks,
) -> Result<(), String> {
    let mut told: Vec<Vec<Told<'_>>> = actions.iter().map(|_| Vec::new()).collect();
    for (number, step) in steps.iter().enumerate() {
        for association in &step.associations {
            let qualifier = &association.qualifier;
            told[association.action].push(Told {
                step: number,
                qualifier,
            });
        }
    }
    let mut lower = Actions {
        lowering,
        steps,
        networks,
    };
    let mut bodies = Vec::new();
    for (action, told) in actions.into_iter().zip(&told) {
        // What nothing does never runs.
        if told.is_empty() {
            continue;
        }
        if let Some(body) = lower.action(action, told)? {
            bodies.push(body);
        }
    }
    for (action, guard, items) in bodies {
        lower.body(&action, &guard, items);
    }
    Ok(())
}

struct Actions<'a, 'f> {
    lowering: &'a mut Lowering<'f>,
    steps: &'a [Step],
    networks: &'a mut Networks,
}

/// The name of a body, the tag that says whether it runs, and its networks.
type Guarded = (String, String, Vec<Item>);

impl Actions<'_, '_> {
    /// What is decided about an action in a scan.
    fn action(&mut self, action: Action, told: &[Told<'_>]) -> Result<Option<Guarded>, String> {
        let Action { name, act, origin } = action;
        let mut memory = self.memory(&name, told, &act)?;
        let direct: Vec<&Told<'_>> = told.iter().filter(|one| is_direct(one.qualifier)).collect();
        let act = match (act, told) {
            // A body that one step runs while it is active needs no tag of its own.
            (
                Act::Body(items),
                [
                    Told {
                        step,
                        qualifier: Qualifier::While,
                    },
                ],
            ) => {
                let active = self.steps[*step].active.clone();
                return Ok(Some((name, active, items)));
            }
            (act, _) => act,
        };
        self.networks.comment(format!("action {name}"));
        let items = match act {
            Act::Variable(path) => {
                self.one_by_one(&path, &direct)?;
                self.timers(told, &memory)?;
                self.stored(&path, told, &memory, origin)?;
                return Ok(None);
            }
            Act::Body(items) => items,
        };
        self.timers(told, &memory)?;
        if let Some(stored) = &memory.stored {
            let path = Path::tag(stored);
            self.stored(&path, told, &memory, origin)?;
        }
        let stored = memory.stored.take();
        let guard = match (&direct[..], stored) {
            ([], Some(stored)) => stored,
            (direct, stored) => self.running(&name, direct, stored, origin)?,
        };
        Ok(Some((name, guard, items)))
    }

    /// The tag that says whether a body runs in this scan.
    fn running(
        &mut self,
        name: &str,
        direct: &[&Told<'_>],
        stored: Option<String>,
        origin: Option<Origin>,
    ) -> Result<String, String> {
        let tag = self.lowering.tag(name, "BOOL", format!("action {name} runs"));
        let stored = stored.map(|stored| contact(&stored, origin));
        if direct.len() <= MOST_IN_ONE {
            let mut power = None;
            for one in direct {
                power = Some(self.power(one, power)?);
            }
            let parts = vec![
                any(power.into_iter().chain(stored).collect()),
                element(Block::coil(Path::tag(&tag)), origin),
            ];
            self.networks.push(parts);
            return Ok(tag);
        }
        self.networks
            .push(vec![block(Op::ResetCoil, [Path::tag(&tag).into()], origin)?]);
        self.one_by_one(&Path::tag(&tag), direct)?;
        if let Some(stored) = stored {
            self.networks.push(vec![
                stored,
                block(Op::SetCoil, [Path::tag(&tag).into()], origin)?,
            ]);
        }
        Ok(tag)
    }

    /// Whether a body runs after what a step does with it; `so_far` is what the steps before it have made of that.
    fn power(&mut self, one: &Told<'_>, so_far: Option<Part>) -> Result<Part, String> {
        let step = &self.steps[one.step];
        let origin = step.origin;
        let active = || contact(&step.active, origin);
        let ended = || not(&step.active, origin);
        let is_late = self.lowering.counts_late;
        let mut was_not = || not(&self.lowering.before(one.step, &step.name), origin);
        Ok(match one.qualifier {
            Qualifier::AtBegin => Circuit::Series(vec![active(), was_not()]),
            Qualifier::AtEnd => {
                let was = contact(&self.lowering.before(one.step, &step.name), origin);
                Circuit::Series(vec![ended(), was])
            }
            Qualifier::Limited(time) => {
                let now = Circuit::Series(vec![active(), elapsed(is_late, step, Op::Lt, time)?]);
                match so_far {
                    None => now,
                    Some(so_far) => any(vec![now, Circuit::Series(vec![ended(), was_not(), so_far])]),
                }
            }
            Qualifier::Delayed(time) => {
                let now = Circuit::Series(vec![active(), elapsed(is_late, step, Op::Ge, time)?]);
                match so_far {
                    None => now,
                    Some(so_far) => {
                        let stays = any(vec![active(), was_not()]);
                        any(vec![now, Circuit::Series(vec![stays, so_far])])
                    }
                }
            }
            _ => match so_far {
                None => active(),
                Some(so_far) => any(vec![active(), Circuit::Series(vec![was_not(), so_far])]),
            },
        })
    }

    /// What steps make of a tag, one after the other.
    fn one_by_one(&mut self, path: &Path, direct: &[&Told<'_>]) -> Result<(), String> {
        let is_late = self.lowering.counts_late;
        for one in direct {
            let step = &self.steps[one.step];
            let origin = step.origin;
            let before = self.lowering.before(one.step, &step.name);
            let active = || contact(&step.active, origin);
            let has_ended = || Circuit::Series(vec![not(&step.active, origin), contact(&before, origin)]);
            let coil = |op| block(op, [path.into()], origin);
            let (set, reset) = match one.qualifier {
                Qualifier::AtBegin => {
                    let parts = vec![active(), not(&before, origin), coil(Op::Coil)?];
                    self.networks.push(parts);
                    continue;
                }
                Qualifier::AtEnd => {
                    self.networks.push(vec![has_ended(), coil(Op::Coil)?]);
                    continue;
                }
                Qualifier::Limited(time) => {
                    let over = Circuit::Series(vec![active(), elapsed(is_late, step, Op::Ge, time)?]);
                    let set = vec![active(), elapsed(is_late, step, Op::Lt, time)?];
                    (set, any(vec![over, has_ended()]))
                }
                Qualifier::Delayed(time) => {
                    (vec![active(), elapsed(is_late, step, Op::Ge, time)?], has_ended())
                }
                _ => (vec![active()], has_ended()),
            };
            let mut parts = set;
            parts.push(coil(Op::SetCoil)?);
            self.networks.push(parts);
            self.networks.push(vec![reset, coil(Op::ResetCoil)?]);
        }
        Ok(())
    }

    /// The tags of an action that is set or reset, and what its timers do when a scan begins.
    fn memory(&mut self, name: &str, told: &[Told<'_>], act: &Act) -> Result<Memory, String> {
        let any_is = |is: fn(&Qualifier) -> bool| told.iter().any(|one| is(one.qualifier));
        let mut memory = Memory::default();
        if any_is(|one| matches!(one, Qualifier::StoredDelayed(_) | Qualifier::DelayedStored(_))) {
            memory.set = Some(self.timer(name, "begins")?);
        }
        if any_is(|one| matches!(one, Qualifier::StoredLimited(_))) {
            memory.reset = Some(self.timer(name, "ends")?);
        }
        let is_stored = any_is(|one| !is_direct(one));
        if is_stored && matches!(act, Act::Body(_)) {
            let about = format!("action {name} is stored");
            memory.stored = Some(self.lowering.tag(&format!("{name}_stored"), "BOOL", about));
        }
        Ok(memory)
    }

    /// A time that runs down from scan to scan, and the tag that is TRUE in the scan in which it has.
    fn timer(&mut self, name: &str, what: &str) -> Result<(String, String), String> {
        let left = format!("time until action {name} {what}");
        let left = self.lowering.tag(&format!("{name}_{what}_in"), "TIME", left);
        let now = format!("action {name} {what} now");
        let now = self.lowering.tag(&format!("{name}_{what}"), "BOOL", now);
        let passed = self.lowering.passed();
        let time = || Expression::from(Path::tag(&left));
        let parts = vec![
            block(Op::Gt, [time(), zero()?], None)?,
            block(Op::Sub, [time(), time(), passed], None)?,
            block(Op::Le, [time(), zero()?], None)?,
            element(Block::coil(Path::tag(&now)), None),
        ];
        self.lowering.first.push(parts);
        Ok((left, now))
    }

    /// Steps start the timers of an action, and stop them.
    fn timers(&mut self, told: &[Told<'_>], memory: &Memory) -> Result<(), String> {
        for one in told {
            let (timer, time) = match one.qualifier {
                Qualifier::StoredDelayed(time) | Qualifier::DelayedStored(time) => (&memory.set, time),
                Qualifier::StoredLimited(time) => (&memory.reset, time),
                _ => continue,
            };
            let Some((left, _)) = timer else { continue };
            let step = &self.steps[one.step];
            let origin = step.origin;
            let before = self.lowering.before(one.step, &step.name);
            let start = |time| block(Op::Mov, [Path::tag(left).into(), time], origin);
            self.networks.push(vec![
                contact(&step.active, origin),
                not(&before, origin),
                start(time.clone())?,
            ]);
            if matches!(one.qualifier, Qualifier::DelayedStored(_)) {
                let stop = start(zero()?)?;
                let parts = vec![not(&step.active, origin), contact(&before, origin), stop];
                self.networks.push(parts);
            }
        }
        Ok(())
    }

    /// What sets and resets an action; both at once reset it.
    fn stored(
        &mut self,
        path: &Path,
        told: &[Told<'_>],
        memory: &Memory,
        origin: Option<Origin>,
    ) -> Result<(), String> {
        let (mut sets, mut resets) = (Vec::new(), Vec::new());
        for one in told {
            let step = &self.steps[one.step];
            let active = contact(&step.active, step.origin);
            match one.qualifier {
                Qualifier::Stored => sets.push(active),
                Qualifier::Reset => resets.push(active),
                Qualifier::StoredLimited(_) => {
                    let before = self.lowering.before(one.step, &step.name);
                    sets.push(Circuit::Series(vec![active, not(&before, step.origin)]));
                }
                _ => {}
            }
        }
        sets.extend(memory.set.iter().map(|(_, now)| contact(now, origin)));
        resets.extend(memory.reset.iter().map(|(_, now)| contact(now, origin)));
        for (powers, op, timer) in [
            (sets, Op::SetCoil, &memory.set),
            (resets, Op::ResetCoil, &memory.reset),
        ] {
            if powers.is_empty() {
                continue;
            }
            let mut parts = vec![any(powers)];
            // Whatever does it, no timer does it again.
            if let Some((left, _)) = timer {
                parts.push(block(Op::Mov, [Path::tag(left).into(), zero()?], origin)?);
            }
            parts.push(block(op, [path.into()], origin)?);
            self.networks.push(parts);
        }
        Ok(())
    }

    /// The networks of an action, which run only if its tag is TRUE.
    fn body(&mut self, name: &str, guard: &str, items: Vec<Item>) {
        let networks = items.iter().filter(|item| matches!(item, Item::Network(_)));
        let count = networks.count();
        if count == 0 {
            return;
        }
        self.networks
            .extend(vec![Item::Blank, Item::Comment(format!("action {name}"))]);
        if count <= MOST_GUARDED && items.iter().all(needs_power) {
            let items = items.into_iter().map(|item| match item {
                Item::Network(Network {
                    comments,
                    drawing: Drawing::Circuit(circuit),
                }) => {
                    let drawing = Drawing::Circuit(Circuit::Series(vec![contact(guard, None), circuit]));
                    Item::Network(Network { comments, drawing })
                }
                other => other,
            });
            self.networks
                .extend(items.filter(|item| *item != Item::Blank).collect());
            return;
        }
        let end = self.lowering.fresh(&format!("{name}_end"));
        let skip = vec![not(guard, None), element(Block::jump(&end), None)];
        self.networks.push(skip);
        self.networks.extend(items);
        self.networks.label(end);
    }
}

/// Whether a step decides by itself in each scan whether an action runs.
const fn is_direct(qualifier: &Qualifier) -> bool {
    matches!(
        qualifier,
        Qualifier::While
            | Qualifier::AtBegin
            | Qualifier::AtEnd
            | Qualifier::Limited(_)
            | Qualifier::Delayed(_)
    )
}

/// How long a step is active, compared with a time; whole seconds may count late.
fn elapsed(is_late: bool, step: &Step, op: Op, time: &Expression) -> Result<Part, String> {
    let is_late = is_late && whole_seconds::is_whole(time);
    let op = if is_late { whole_seconds::compared(op) } else { op };
    block(op, [Path::tag(&step.elapsed).into(), time.clone()], step.origin)
}

/// Whether an item does nothing where no power enters it.
fn needs_power(item: &Item) -> bool {
    match item {
        Item::Network(Network {
            drawing: Drawing::Circuit(circuit),
            ..
        }) => all_need_power(circuit),
        Item::Comment(_) | Item::Blank => true,
        _ => false,
    }
}

fn all_need_power(circuit: &Circuit<Element>) -> bool {
    match circuit {
        Circuit::Element(element) => matches!(
            element.as_block().and_then(Block::op),
            Some(
                Op::Contact
                    | Op::NegatedContact
                    | Op::Eq
                    | Op::Ne
                    | Op::Gt
                    | Op::Ge
                    | Op::Lt
                    | Op::Le
                    | Op::Mov
                    | Op::Add
                    | Op::Sub
                    | Op::Mul
                    | Op::Div
                    | Op::Calc
                    | Op::SetCoil
                    | Op::ResetCoil
            )
        ),
        // After a set coil there is power whatever comes in.
        Circuit::Series(parts) => {
            let before = parts.len().saturating_sub(1);
            parts.iter().all(all_need_power) && !parts[..before].iter().any(has_set_coil)
        }
        Circuit::Parallel(parts) => parts.iter().all(all_need_power),
    }
}

fn has_set_coil(circuit: &Circuit<Element>) -> bool {
    match circuit {
        Circuit::Element(element) => element.as_block().and_then(Block::op) == Some(Op::SetCoil),
        Circuit::Series(parts) | Circuit::Parallel(parts) => parts.iter().any(has_set_coil),
    }
}
