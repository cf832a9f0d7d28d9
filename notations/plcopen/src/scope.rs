//! What names mean: the variables of a unit and of the project, its types, its blocks.

use super::along;
use super::brought;
use super::model::{Body, Evaluation, Initial, Project, Role, Type, Unit, UnitKind, Variable};
use super::own;
use super::standard::{self, StandardBlock};
use ladder_format::program::{Path, Qualifier};
use ladder_notation::address::several;
use ladder_notation::{BlockNames, Names};
use std::cell::RefCell;
use std::collections::{HashMap, HashSet};

/// A variable as it is called here.
#[derive(Debug, Clone)]
pub(crate) struct Known {
    /// Its tag; of a variable that stands for one of `SYS`, that.
    pub(crate) path: Path,
    pub(crate) ty: Type,
}

/// The variables of one unit, or those of the project.
#[derive(Debug, Clone, Default)]
pub(crate) struct Scope {
    known: HashMap<String, Known>,
    names: Names,
    taken: HashSet<String>,
    /// Whether one of the names is more than a word, as `pump 1`.
    has_odd: bool,
    /// How many tags were made for each name.
    numbers: HashMap<String, u32>,
    /// The steps of the unit's chart, by their names in small letters: what says whether each is active, and for how long.
    steps: HashMap<String, (Path, Path)>,
}

/// What the whole project knows.
pub(crate) struct Shared<'p> {
    pub(crate) globals: Scope,
    /// What constants begin with, by their names here in small letters.
    pub(crate) constants: HashMap<String, &'p str>,
    /// The addresses that several variables have, in capital letters.
    pub(crate) several: HashSet<String>,
    /// The types, by their names in small letters: how each is spelled, and what it is.
    pub(crate) types: HashMap<String, (String, &'p Type)>,
    /// The types that are not declared here, by their names in small letters, and why: found out once, for types are made of others.
    pub(crate) not_declared: RefCell<HashMap<String, String>>,
    /// The names of members that are more than a word, in small letters.
    pub(crate) odd_members: HashSet<String>,
    /// How a network is run there.
    pub(crate) evaluation: Evaluation,
    /// What is compiled as Beremiz and OpenPLC do: a function without power at EN has 0.
    pub(crate) is_compiled: bool,
    /// The functions and function blocks, by their names in small letters.
    pub(crate) blocks: HashMap<String, BlockOf<'p>>,
}

/// A unit that others use.
pub(crate) struct BlockOf<'p> {
    /// `$Motor`
    pub(crate) name: String,
    pub(crate) unit: &'p Unit,
    pub(crate) scope: Scope,
}

impl Scope {
    /// Takes names that are others' already.
    pub(crate) fn next_to(globals: &Scope) -> Scope {
        Scope {
            known: HashMap::new(),
            names: globals.names.clone(),
            taken: globals.taken.clone(),
            has_odd: false,
            numbers: globals.numbers.clone(),
            steps: HashMap::new(),
        }
    }

    /// Takes a step of a chart in: the tags that `name.X` and `name.T` are.
    pub(crate) fn step(&mut self, name: &str, active: Path, elapsed: Path) {
        self.steps.insert(name.to_lowercase(), (active, elapsed));
    }

    /// All steps, by their names in small letters.
    pub(crate) fn steps(&self) -> impl Iterator<Item = (&String, &(Path, Path))> {
        self.steps.iter()
    }

    /// A member of a step, and its type.
    pub(crate) fn of_step(&self, name: &str, member: &str) -> Option<(Path, Type)> {
        let (active, elapsed) = self.steps.get(&name.to_lowercase())?;
        let (path, ty) = match member {
            "X" | "x" => (active, "BOOL"),
            "T" | "t" => (elapsed, "TIME"),
            _ => return None,
        };
        Some((path.clone(), Type::Named(ty.to_owned())))
    }

    /// The variable of a name.
    pub(crate) fn get(&self, name: &str) -> Option<&Known> {
        self.known.get(&name.to_lowercase())
    }

    /// All variables, by their names in small letters.
    pub(crate) fn all(&self) -> impl Iterator<Item = (&String, &Known)> {
        self.known.iter()
    }

    /// The names that are taken.
    pub(crate) fn names_mut(&mut self) -> &mut Names {
        &mut self.names
    }

    /// Whether one of the variables has a name that is more than a word.
    pub(crate) fn has_odd(&self) -> bool {
        self.has_odd
    }

    /// A name for something that the source has no variable for.
    pub(crate) fn fresh(&mut self, like: &str) -> String {
        let like = short(like);
        // Of many that are alike the next number is known.
        let count = self.numbers.entry(like.to_lowercase()).or_default();
        *count += 1;
        let name = match *count {
            1 => self.names.fresh(like),
            count => self.names.fresh(&format!("{like}_{count}")),
        };
        self.taken.insert(name.to_lowercase());
        name
    }

    /// Takes a variable in; where its name is another's already, its owner is put before it.
    pub(crate) fn declare(&mut self, name: &str, ty: &Type, owner: &str) {
        if self.get(name).is_some() {
            return;
        }
        let like = match trigger(ty) {
            Some(_) => format!("{name}_Q"),
            None => name.to_owned(),
        };
        let spelled = if self.taken.contains(&like.to_lowercase()) && !owner.is_empty() {
            self.fresh(&format!("{owner}_{like}"))
        } else {
            self.fresh(&like)
        };
        self.has_odd |= !is_plain(name);
        self.alias(name, Path::tag(spelled), ty);
    }

    /// Takes in what a unit says is declared elsewhere, and what the project does not have.
    fn elsewhere(&mut self, unit: &Unit, globals: &Scope) {
        let external = unit.variables.iter().filter(|one| one.role == Role::External);
        for variable in external.filter(|one| globals.get(&one.name).is_none()) {
            let ty = Type::Other("a global that the project does not have".to_owned());
            self.alias(&variable.name, Path::tag(&variable.name), &ty);
        }
    }

    fn alias(&mut self, name: &str, path: Path, ty: &Type) {
        let ty = ty.clone();
        self.known.insert(name.to_lowercase(), Known { path, ty });
    }
}

/// Whether a type is that of an edge detector, which needs no state of its own here.
pub(crate) fn trigger(ty: &Type) -> Option<StandardBlock> {
    let Type::Named(name) = ty else { return None };
    standard::block(name).filter(|block| !matches!(block, StandardBlock::Stateful(..)))
}

impl<'p> Shared<'p> {
    pub(crate) fn of(project: &'p Project) -> Shared<'p> {
        let mut names = Names::default();
        let mut types = HashMap::new();
        for declared in &project.types {
            let spelled = names.fresh(short(&declared.name));
            types
                .entry(declared.name.to_lowercase())
                .or_insert((spelled, &declared.ty));
        }
        let mut globals = Scope::default();
        for variable in &project.globals {
            match along::system(variable) {
                Some(tag) => globals.alias(&variable.name, Path::system(tag.name()), &variable.ty),
                None => globals.declare(&variable.name, &variable.ty, ""),
            }
        }
        let constants = project.globals.iter().filter_map(|variable| {
            let is_constant = variable.qualifier == Some(Qualifier::Constant);
            match (&variable.initial, globals.get(&variable.name)) {
                (Some(Initial::Simple(text)), Some(known)) if is_constant => {
                    Some((known.path.root.to_lowercase(), text.as_str()))
                }
                _ => None,
            }
        });
        let constants = constants.collect();
        let declared = project.globals.iter().chain(project.units.iter().flat_map(local));
        let mut blocks = HashMap::new();
        let mut taken = BlockNames::default();
        for unit in &project.units {
            if unit.kind == UnitKind::Program || blocks.contains_key(&unit.name.to_lowercase()) {
                continue;
            }
            let name = match &unit.body {
                Body::Ladder(text) => brought::name(text).unwrap_or(&unit.name),
                _ => &unit.name,
            };
            let name = format!("${}", taken.free(short(name), "B"));
            let mut scope = Scope::next_to(&globals);
            let power = Type::Named("BOOL".to_owned());
            scope.alias("EN", Path::tag("EN"), &power);
            scope.alias("ENO", Path::tag("ENO"), &power);
            scope.elsewhere(unit, &globals);
            for variable in local(unit) {
                match own::power(variable) {
                    Some(name) => scope.alias(&variable.name, Path::tag(name), &power),
                    None => scope.declare(&variable.name, &variable.ty, ""),
                }
            }
            if let Some(returns) = &unit.returns {
                scope.declare(&unit.name, returns, "");
            }
            blocks.insert(unit.name.to_lowercase(), BlockOf { name, unit, scope });
        }
        Shared {
            odd_members: odd_members(project),
            evaluation: project.evaluation,
            is_compiled: project.evaluation == Evaluation::EachOutput && !project.is_own,
            constants,
            several: several(declared.filter_map(|variable| variable.address.as_deref())),
            not_declared: RefCell::default(),
            globals,
            types,
            blocks,
        }
    }

    /// The scope of a program; `others` is that of programs in the same file.
    pub(crate) fn program(&self, unit: &Unit, others: Option<&Scope>) -> Scope {
        let mut scope = others.map_or_else(|| Scope::next_to(&self.globals), Scope::next_to);
        scope.elsewhere(unit, &self.globals);
        for variable in local(unit) {
            scope.declare(&variable.name, &variable.ty, &unit.name);
        }
        scope
    }

    /// The members of a type, if it is a structure.
    pub(crate) fn members<'s>(&'s self, ty: &'s Type) -> Option<&'s [Variable]> {
        match self.real(ty) {
            Type::Structure(members) => Some(members),
            _ => None,
        }
    }

    /// What a name for a type stands for, in the end.
    pub(crate) fn real<'s>(&'s self, ty: &'s Type) -> &'s Type {
        let mut ty = ty;
        for _ in 0..16 {
            let Type::Named(name) = ty else { break };
            match self.types.get(&name.to_lowercase()) {
                Some((_, real)) => ty = real,
                None => break,
            }
        }
        ty
    }

    /// Whether a block of the project has this name, with its `$`.
    pub(crate) fn has_block(&self, name: &str) -> bool {
        self.blocks
            .values()
            .any(|block| block.name.eq_ignore_ascii_case(name))
    }

    /// The unit that a type is an instance of.
    pub(crate) fn block_of(&self, ty: &Type) -> Option<&BlockOf<'p>> {
        let Type::Named(name) = ty else { return None };
        self.blocks.get(&name.to_lowercase())
    }
}

/// The members of types and units whose names are more than a word.
fn odd_members(project: &Project) -> HashSet<String> {
    let of_types = project.types.iter().flat_map(|declared| match &declared.ty {
        Type::Structure(members) => &members[..],
        _ => &[],
    });
    let of_units = project.units.iter().flat_map(local);
    of_types
        .chain(of_units)
        .filter(|variable| !is_plain(&variable.name))
        .map(|variable| variable.name.to_lowercase())
        .collect()
}

/// Whether a name is a word of letters, digits and `_`.
pub(crate) fn is_plain(name: &str) -> bool {
    let is_digit = name.starts_with(|c: char| c.is_ascii_digit());
    !is_digit && name.chars().all(|c| c.is_alphanumeric() || c == '_')
}

/// The variables that a unit declares, without those that are elsewhere.
pub(crate) fn local(unit: &Unit) -> impl Iterator<Item = &Variable> {
    unit.variables
        .iter()
        .filter(|variable| variable.role != Role::External)
}

/// The name of a member: structures have a room of their own for names.
pub(crate) fn member(name: &str) -> String {
    Names::default().spell(short(name)).to_owned()
}

/// Names are no longer: each is drawn wherever it is used.
pub(crate) const LONGEST: usize = 100;

/// The first characters of a name.
pub(crate) fn short(name: &str) -> &str {
    let end = name
        .char_indices()
        .nth(LONGEST)
        .map_or(name.len(), |(end, _)| end);
    &name[..end]
}
