//! What all units of a program share: the names of types, blocks and values, and which tags they share.

pub(crate) mod declare;
mod initial;
mod shared;
pub(crate) mod types;

use crate::names::{self, Names};
use declare::Variable;
use ladder_analysis::context::Context;
use ladder_analysis::names::named_types::NamedTypes;
use ladder_analysis::program::{
    Argument, BinaryOperator, Block, BlockKind, Chosen, Clock, Expr, ExprKind, Location, Place, Program,
    SystemTag, Tag, TagId,
};
use ladder_analysis::values::compound::{EnumId, TypeId};
use ladder_analysis::values::types::{Scalar, Type};
use ladder_analysis::values::value::Value;
use ladder_instructions::{Op, StateType};
use ladder_syntax::Parse;
use shared::Shared;
use std::collections::{BTreeMap, BTreeSet, HashMap, HashSet};
use std::ops::Range;
use types::is_block;

/// Why a program is not written: at a place, what cannot be expressed.
pub(crate) struct Stop {
    pub(crate) at: Location,
    pub(crate) why: String,
}

pub(crate) type Result<T> = std::result::Result<T, Stop>;

/// A program organisation unit.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(crate) enum UnitKind {
    Program,
    /// `<FUN>`
    Function(usize),
    /// `$Block`
    Block(usize),
}

/// What several units need and only the program counts: the clock, the tags of `SYS`, whether the program has ended.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(crate) enum Service {
    /// Time since the first scan.
    Now,
    ScanTime,
    FirstScan,
    Scan,
    /// Whether there was a fault in the scan before.
    Fault,
    /// Whether there is one in this scan.
    Faulted,
    Ended,
    Clock(u8),
}

impl Service {
    pub(crate) fn name(self) -> &'static str {
        match self {
            Service::Now => "now",
            Service::ScanTime => "scan_time",
            Service::FirstScan => "first_scan",
            Service::Scan => "scan",
            Service::Fault => "fault_before",
            Service::Faulted => "faulted",
            Service::Ended => "ended",
            Service::Clock(n) => [
                "clock_10ms",
                "clock_100ms",
                "clock_500ms",
                "clock_1s",
                "clock_1m",
                "clock_1h",
            ][usize::from(n).min(5)],
        }
    }

    /// All of them.
    fn all() -> impl Iterator<Item = Service> {
        use Service::{Clock as Wave, Ended, Fault, Faulted, FirstScan, Now, Scan, ScanTime};
        let others = [Now, ScanTime, FirstScan, Scan, Fault, Faulted, Ended];
        others.into_iter().chain((0..Clock::ALL.len() as u8).map(Wave))
    }

    pub(crate) fn ty(self) -> Scalar {
        match self {
            Service::Now | Service::ScanTime => Scalar::Time,
            Service::Scan => Scalar::Dint,
            _ => Scalar::Bool,
        }
    }

    pub(crate) fn of(tag: SystemTag) -> Option<Service> {
        Some(match tag {
            SystemTag::FirstScan => Service::FirstScan,
            SystemTag::Scan => Service::Scan,
            SystemTag::Time => Service::Now,
            SystemTag::ScanTime => Service::ScanTime,
            SystemTag::Fault => Service::Fault,
            SystemTag::Clock(clock) => {
                Service::Clock(Clock::ALL.iter().position(|other| *other == clock)? as u8)
            }
            SystemTag::On | SystemTag::Off => return None,
        })
    }
}

pub(crate) struct Project<'p> {
    pub(crate) source: Source<'p>,
    pub(crate) tags: Tags<'p>,
    pub(crate) given: Given,
    pub(crate) used: Used,
    /// In the order in which they are declared.
    pub(crate) type_order: Vec<Declared>,
    /// The tags that functions and blocks use as well.
    pub(crate) shared: Shared,
}

/// What is written.
pub(crate) struct Source<'p> {
    pub(crate) program: &'p Program,
    /// The text of the program's own file.
    pub(crate) text: &'p str,
    pub(crate) parse: &'p Parse,
    named: &'p NamedTypes,
    own_blocks: Vec<&'p str>,
    /// The time from scan to scan.
    pub(crate) cycle: i64,
}

/// What is known of its tags.
#[derive(Default)]
pub(crate) struct Tags<'p> {
    /// The names that the ladder program has for arrays.
    named_arrays: HashMap<Type, &'p str>,
    /// The types of the tags as they are declared, of each block and of the program.
    declared: HashMap<(Option<usize>, &'p str), Type>,
    /// How many bytes of the name of each tag are that of the variable that it lies in.
    roots: Vec<usize>,
    /// The parts of each of them, which hold its initial value.
    parts: HashMap<(Option<usize>, &'p str), Vec<&'p Tag>>,
    /// Timers and bistables that some block uses as the standard's do not work.
    own_states: BTreeSet<TagId>,
}

/// The names that are given out.
#[derive(Default)]
pub(crate) struct Given {
    /// Words, types, blocks, values: what no variable may be called.
    pub(crate) names: Names,
    /// Those of structures, and of arrays that are elements of arrays.
    types: HashMap<Type, String>,
    enumerations: HashMap<EnumId, String>,
    values: HashMap<(EnumId, i64), String>,
    pub(crate) blocks: Vec<String>,
    pub(crate) functions: Vec<String>,
    /// Those of what holds the state of a function.
    pub(crate) function_states: Vec<String>,
    service_names: BTreeMap<Service, String>,
}

/// What the statements that are written ask for.
#[derive(Default)]
pub(crate) struct Used {
    /// What is counted, with its name; and what functions and blocks ask for of that.
    pub(crate) services: BTreeMap<Service, String>,
    pub(crate) shared_services: BTreeSet<Service>,
    pub(crate) pieces: BTreeSet<&'static str>,
    pub(crate) enumerations_as_numbers: HashSet<EnumId>,
    pub(crate) enumerations_from_numbers: HashSet<EnumId>,
    pub(crate) faults_count: bool,
}

/// All tags with their numbers.
fn tag_ids(program: &Program) -> impl Iterator<Item = (TagId, &Tag)> {
    (0..).map(TagId).zip(&program.tags)
}

/// A type that is declared.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(crate) enum Declared {
    Structure(TypeId),
    Array(Type),
    Enumeration(EnumId),
}

/// How many bytes of the name of each tag are that of the variable that it lies in: the tag of the program that it is a part of, or the
/// timer, counter or block within that. Compilers that are built on matiec take none of these in arrays and structures, so that each has a
/// variable of its own.
fn roots(program: &Program) -> Vec<usize> {
    let length = |tag: &Tag| match &tag.column {
        Some(column) if !(is_block(tag.ty) && column.declared.0 == column.root) => column.root,
        _ => tag.name.len(),
    };
    let mut roots: Vec<usize> = program.tags.iter().map(length).collect();
    let mut around = vec![None; program.tags.len()];
    for instance in &program.instances {
        for (_, inside) in &instance.tags {
            around[inside.0 as usize] = Some(instance.tag.0 as usize);
        }
    }
    for (tag, outer) in around.iter().enumerate() {
        let mut outer = *outer;
        while let Some(instance) = outer {
            roots[tag] = roots[instance];
            outer = around[instance];
        }
    }
    roots
}

impl<'p> Project<'p> {
    pub(crate) fn new(program: &'p Program, text: &'p str, context: &'p Context) -> Project<'p> {
        let named = &context.types;
        let mut names = Names::default();
        let mut project = Project {
            source: Source {
                program,
                text,
                parse: &context.parse,
                named,
                own_blocks: context.user_blocks[..context.own_blocks]
                    .iter()
                    .map(|block| &*block.name)
                    .collect(),
                cycle: 0,
            },
            tags: Tags {
                roots: roots(program),
                ..Tags::default()
            },
            given: Given::default(),
            used: Used::default(),
            type_order: Vec::new(),
            shared: Shared::default(),
        };
        for own in named.own() {
            if let Some(ty) = own.ty.filter(|ty| ty.array().is_some()) {
                let name = own.declaration.name.as_str();
                project.tags.named_arrays.entry(ty).or_insert(name);
            }
        }
        for block in std::iter::once(None).chain((0..program.blocks.len()).map(Some)) {
            let variables = project.variables(block).into_iter();
            let types = variables.map(|variable| ((block, variable.root), variable.ty));
            project.tags.declared.extend(types);
        }
        for (id, tag) in tag_ids(program) {
            project
                .tags
                .parts
                .entry((tag.block, project.root(id)))
                .or_default()
                .push(tag);
        }
        // Variables keep their names; what is named after them stays out of their way.
        let mut tags = BTreeSet::new();
        for (id, tag) in tag_ids(program) {
            for word in tag
                .name
                .split(['.', '[', ']', ',', ' '])
                .filter(|word| !word.is_empty())
            {
                tags.insert(names::identifier(word));
            }
            tags.insert(names::identifier(project.root(id)));
        }
        tags.insert("power".to_owned());
        for tag in &tags {
            names.name(tag, "tag");
        }
        for service in Service::all() {
            let name = names.name(service.name(), "of_ladder");
            project.given.service_names.insert(service, name);
        }
        project.find_shared();
        for tag in &program.tags {
            project.add_type(tag.ty, &mut names);
            if let Some(column) = &tag.column {
                project.add_type(column.declared.1, &mut names);
            }
        }
        for network in &program.networks {
            for block in &network.blocks {
                for bound in &block.arguments {
                    if let Argument::Value(expr) = &bound.argument {
                        project.add_types_of(expr, &mut names);
                    }
                }
            }
        }
        for block in &program.blocks {
            project.given.blocks.push(names.name(&block.name, "block"));
        }
        for function in &program.functions {
            let name = names.name(&function.name, "function");
            project
                .given
                .function_states
                .push(names.name(&format!("do_{name}"), "function"));
            project.given.functions.push(name);
        }
        project.name_passed_arrays(&mut names);
        // Only what was given out here is taken for variables.
        let mut taken = Names::default();
        let given = project
            .given
            .types
            .values()
            .chain(project.given.enumerations.values());
        for name in given
            .chain(project.given.values.values())
            .chain(&project.given.blocks)
            .chain(&project.given.functions)
            .chain(&project.given.function_states)
            .chain(project.given.service_names.values())
        {
            taken.name(name, "");
        }
        project.given.names = taken;
        project.name_shared();
        project.find_own_states();
        project.used.faults_count = project.asks_for(SystemTag::Fault);
        project
    }

    /// The name of the variable that a tag lies in, as the ladder program has it.
    pub(crate) fn root(&self, tag: TagId) -> &'p str {
        &self.source.program.tags[tag.0 as usize].name[..self.tags.roots[tag.0 as usize]]
    }

    /// The number that a block has among those of the program's own file.
    pub(crate) fn own_block(&self, block: usize) -> Option<usize> {
        let name = &self.source.program.blocks[block].name;
        self.source
            .own_blocks
            .iter()
            .position(|own| own.eq_ignore_ascii_case(name))
    }

    /// The type of a variable as it is declared.
    pub(crate) fn type_of_variable(&self, variable: &Variable<'_>) -> String {
        match variable.ty {
            Type::State(state) if self.is_standard(state, variable.id) => state.name().into(),
            ty => self.type_name(ty),
        }
    }

    /// Whether a timer or bistable is the standard's block.
    pub(crate) fn is_standard(&self, state: StateType, tag: TagId) -> bool {
        matches!(
            state,
            StateType::Ton | StateType::Tof | StateType::Tp | StateType::Sr | StateType::Rs
        ) && !self.tags.own_states.contains(&tag)
    }

    /// A value as it is written.
    pub(crate) fn literal(&self, value: &Value, ty: Scalar) -> String {
        match (value, ty) {
            (Value::Int(number), Scalar::Enum(id)) => self
                .given
                .values
                .get(&(id, *number))
                .cloned()
                .unwrap_or_else(|| number.to_string()),
            _ => crate::literal::literal(value, ty),
        }
    }

    pub(crate) fn value_name(&self, id: EnumId, number: i64) -> Option<&String> {
        self.given.values.get(&(id, number))
    }

    pub(crate) fn enumeration_name(&self, id: EnumId) -> Option<&String> {
        self.given.enumerations.get(&id)
    }

    pub(crate) fn networks(&self, unit: UnitKind) -> Range<usize> {
        match unit {
            UnitKind::Program => self.source.program.main.clone(),
            UnitKind::Function(index) => self.source.program.functions[index].networks.clone(),
            UnitKind::Block(index) => self.source.program.blocks[index].networks.clone(),
        }
    }

    /// The program first, then what it can reach.
    pub(crate) fn units(&self) -> Vec<UnitKind> {
        let functions = (0..self.source.program.functions.len()).map(UnitKind::Function);
        let blocks = (0..self.source.program.blocks.len()).map(UnitKind::Block);
        std::iter::once(UnitKind::Program)
            .chain(functions)
            .chain(blocks)
            .collect()
    }

    fn blocks_of(&self, unit: UnitKind) -> impl Iterator<Item = &'p Block> {
        let program: &'p Program = self.source.program;
        program.networks[self.networks(unit)]
            .iter()
            .flat_map(|network| &network.blocks)
    }

    fn find_own_states(&mut self) {
        let mut own = BTreeSet::new();
        for unit in self.units() {
            for block in self.blocks_of(unit) {
                let BlockKind::Instruction(row) = block.kind else {
                    continue;
                };
                let state = block.arguments.first().map(|bound| &bound.argument);
                let Some(tag) = state.and_then(|state| self.state_of(state)) else {
                    continue;
                };
                let is_named = |name: &str| {
                    let mut all = block.arguments.iter();
                    all.any(|bound| bound.operand.is_some_and(|operand| operand.name == name))
                };
                let fits = match row.op {
                    Op::Ton | Op::Tof | Op::Tp => {
                        let preset = block.arguments.get(1).map(|bound| &bound.argument);
                        !is_named("R") && preset.is_some_and(|preset| self.is_positive(preset))
                    }
                    Op::Sr | Op::Rs => true,
                    _ => false,
                };
                if !fits {
                    own.insert(tag);
                }
            }
        }
        self.tags.own_states = own;
    }

    fn is_positive(&self, argument: &Argument) -> bool {
        let Argument::Value(expr) = argument else {
            return false;
        };
        self.constant(expr).is_some_and(|number| number > 0)
    }

    /// The timer, counter, bistable or block that an argument is.
    pub(crate) fn state_of(&self, argument: &Argument) -> Option<TagId> {
        match argument {
            Argument::State(tag) => Some(*tag),
            Argument::ChosenState(chosen) => self.chosen(chosen),
            _ => None,
        }
    }

    /// The tag that indices choose, where constants are all that they are made of.
    pub(crate) fn chosen(&self, chosen: &Chosen) -> Option<TagId> {
        let ExprKind::Offset(subscripts) = &chosen.number.kind else {
            return None;
        };
        let number = subscripts.iter().map(|subscript| {
            let index = self.constant(&subscript.index)?;
            let is_inside = (subscript.first..=subscript.last).contains(&index);
            is_inside.then_some((index - subscript.first) * subscript.stride)
        });
        let number = u32::try_from(number.sum::<Option<i64>>()?).ok()?;
        Some(TagId(chosen.first.0 + chosen.step * number))
    }

    /// The number that an index always is.
    fn constant(&self, expr: &Expr) -> Option<i64> {
        match &expr.kind {
            ExprKind::Constant(Value::Int(number)) => Some(*number),
            ExprKind::Pass(inner) => self.constant(inner),
            ExprKind::Binary(operator, left, right) => {
                let (left, right) = (self.constant(left)?, self.constant(right)?);
                match operator {
                    BinaryOperator::Add => left.checked_add(right),
                    BinaryOperator::Sub => left.checked_sub(right),
                    BinaryOperator::Mul => left.checked_mul(right),
                    _ => None,
                }
            }
            ExprKind::Read(Place::Tag(tag)) => match &self.source.program.tags[tag.0 as usize] {
                tag if tag.constant => match tag.initial.first() {
                    Some(Value::Int(number)) => Some(*number),
                    _ => None,
                },
                _ => None,
            },
            _ => None,
        }
    }

    fn asks_for(&self, wanted: SystemTag) -> bool {
        let mut found = false;
        for unit in self.units() {
            for block in self.blocks_of(unit) {
                for bound in &block.arguments {
                    for (place, _) in bound.places() {
                        found |= *place == Place::System(wanted);
                    }
                }
            }
        }
        found
    }

    /// The name of something that is counted, and that it is asked for here.
    pub(crate) fn service(&mut self, service: Service, unit: UnitKind) -> String {
        if unit != UnitKind::Program {
            self.used.shared_services.insert(service);
        }
        let name = self
            .given
            .service_names
            .get(&service)
            .cloned()
            .unwrap_or_default();
        self.used.services.insert(service, name.clone());
        name
    }
}
