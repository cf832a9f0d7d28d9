//! What the names of types mean in a file: its own, and those that other files declare.

use super::problem::NameProblem;
use super::type_spec::DeclaredType;
use super::type_spec::{self, Declared, SpecKind, TypeSpec};
use crate::other_files::others::Others;
use crate::values::compound::{
    ArrayType, Compound, EnumId, Enumeration, MOST_PARTS, MemberType, Structure, TypeId,
};
use crate::values::constant;
use crate::values::types::{Scalar, Type};
use crate::values::value::Value;
use ladder_syntax::{Name, TextRange};
use rustc_hash::{FxHashMap, FxHashSet, FxHasher};
use smol_str::SmolStr;
use std::hash::{Hash, Hasher};
use std::sync::Arc;

/// Types inside types nest no deeper than this.
const DEEPEST: usize = 50;

/// The types that a file can name.
#[derive(Debug, Clone, Default)]
pub struct NamedTypes {
    /// The file's own in the order of the text, then those of other files.
    list: Vec<NamedType>,
    by_name: FxHashMap<Name, Vec<u32>>,
    /// How many are its own.
    own: usize,
    /// Stands for all enumerations by their names.
    enumerations: u64,
    /// The names of the values of all enumerations.
    values: FxHashSet<Name>,
    /// The names that the file's own declarations mention.
    pub(crate) mentioned: FxHashSet<Name>,
}

/// A declared type.
#[derive(Debug, Clone)]
pub struct NamedType {
    /// Its declaration.
    pub declaration: DeclaredType,
    /// The file that declares it, if it is another one. Then places are those of that file.
    pub file: Option<Arc<str>>,
    /// What it is; none if that cannot be read.
    pub ty: Option<Type>,
    /// The values that its elementary parts start with, where a declaration says so.
    pub initial: Option<Arc<[Value]>>,
}

/// What a declaration means: a type, and the values at the start where something says so.
pub(crate) type Meaning = (Type, Option<Arc<[Value]>>);

impl NamedTypes {
    /// Those of a file and of the others. What is wrong with its own goes to `out`.
    pub(crate) fn new(own: Vec<DeclaredType>, others: &Others, out: &mut Vec<NameProblem>) -> NamedTypes {
        let named = |declaration: DeclaredType, file: Option<&Arc<str>>| NamedType {
            declaration,
            file: file.cloned(),
            ty: None,
            initial: None,
        };
        let mut types = NamedTypes {
            own: own.len(),
            ..NamedTypes::default()
        };
        types.list.extend(own.into_iter().map(|own| named(own, None)));
        let foreign = others.all_types();
        types
            .list
            .extend(foreign.map(|(exports, ty)| named(ty.clone(), Some(&exports.file))));
        for (index, ty) in (0..).zip(&types.list) {
            let same = types.by_name.entry(ty.declaration.key.clone()).or_default();
            if index > 0
                && (index as usize) < types.own
                && let Some(first) = same.first()
            {
                let first = &types.list[*first as usize].declaration;
                out.push(NameProblem::TypeTwice {
                    name: ty.declaration.name.clone(),
                    at: ty.declaration.at,
                    first_at: first.at,
                });
            }
            same.push(index);
        }
        let mut reading = Reading {
            state: vec![State::Open; types.list.len()],
            out,
            way: Vec::new(),
        };
        for index in 0..types.list.len() {
            reading.read(&mut types, index);
        }
        let mut hasher = FxHasher::default();
        for ty in &types.list {
            if let Some(Type::Scalar(Scalar::Enum(id))) = ty.ty {
                (&ty.declaration.key, id).hash(&mut hasher);
            }
        }
        types.enumerations = hasher.finish();
        let enumerations = types.list.iter().filter_map(|ty| match ty.ty {
            Some(Type::Scalar(Scalar::Enum(id))) => Some(id.get()),
            _ => None,
        });
        for enumeration in enumerations {
            let values = enumeration.values.iter().map(|(name, _)| Name::new(name));
            types.values.extend(values);
        }
        types
    }

    /// Whether there is an enumeration.
    pub(crate) fn have_values(&self) -> bool {
        !self.values.is_empty()
    }

    /// Adds all that operands can mean by the name of a type.
    pub(crate) fn stamp(&self, hasher: &mut impl Hasher) {
        self.enumerations.hash(hasher);
    }

    /// Whether an enumeration has a value of this name.
    pub fn has_value(&self, name: &Name) -> bool {
        self.values.contains(name)
    }

    /// The type of a name, as the file sees it.
    pub fn find(&self, name: &str) -> Option<&NamedType> {
        self.position(name, None).map(|index| &self.list[index])
    }

    /// The file's own, in the order of the text.
    pub fn own(&self) -> &[NamedType] {
        &self.list[..self.own]
    }

    /// All that the file can name.
    pub fn all(&self) -> &[NamedType] {
        &self.list
    }

    /// The type of a name as a file sees it: one of its own, else the first of the others.
    fn position(&self, name: &str, file: Option<&Arc<str>>) -> Option<usize> {
        let same = self.by_name.get(&Name::new(name))?;
        let is_own = |index: &&u32| self.list[**index as usize].file.as_ref() == file;
        let found = same.iter().find(is_own).or_else(|| same.first());
        found.map(|index| *index as usize)
    }

    /// The enumeration of a name, if it is that of one.
    pub fn enumeration(&self, name: &str) -> Option<EnumId> {
        match self.find(name)?.ty? {
            Type::Scalar(Scalar::Enum(id)) => Some(id),
            _ => None,
        }
    }

    /// What a declaration of the file itself means. What is wrong with it goes to `out`.
    pub(crate) fn meaning(&mut self, declared: &Declared, out: &mut Vec<NameProblem>) -> Option<Meaning> {
        let mut mentioned = Vec::new();
        declared
            .spec
            .each_name(&mut |name, at| mentioned.push((Name::new(name), name.clone(), at)));
        for (key, name, at) in mentioned {
            self.ambiguous(&key, &name, at, out);
            self.mentioned.insert(key);
        }
        let mut reading = Reading {
            state: vec![State::Done; self.list.len()],
            out,
            way: Vec::new(),
        };
        reading.declared(self, declared, None)
    }

    /// Says so if a name means types of several other files.
    fn ambiguous(&self, key: &Name, name: &SmolStr, at: TextRange, out: &mut Vec<NameProblem>) {
        let Some(same) = self.by_name.get(key) else { return };
        let all = || same.iter().map(|index| &self.list[*index as usize]);
        let differ = |other: &NamedType| {
            all()
                .next()
                .is_some_and(|first| first.declaration.declared != other.declaration.declared)
        };
        if all().all(|ty| ty.file.is_some()) && all().any(differ) {
            let files = all().filter_map(|ty| Some((ty.file.clone()?, ty.declaration.at)));
            out.push(NameProblem::TypeOfFiles {
                name: name.clone(),
                at,
                files: files.collect(),
            });
        }
    }

    /// What a declaration of another file means; what is wrong with it is said there.
    pub(crate) fn meaning_in(&mut self, declared: &Declared, file: &Arc<str>) -> Option<Meaning> {
        let mut unsaid = Vec::new();
        let mut reading = Reading {
            state: vec![State::Done; self.list.len()],
            out: &mut unsaid,
            way: Vec::new(),
        };
        reading.declared(self, declared, Some(file))
    }
}

/// How far a type is read.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum State {
    Open,
    Reading,
    Done,
}

/// Types that are being read.
struct Reading<'o> {
    state: Vec<State>,
    out: &'o mut Vec<NameProblem>,
    /// The types that are open, the outermost first.
    way: Vec<usize>,
}

impl Reading<'_> {
    /// Reads a type, if that is not done.
    fn read(&mut self, types: &mut NamedTypes, index: usize) {
        if self.state[index] != State::Open {
            return;
        }
        self.state[index] = State::Reading;
        self.way.push(index);
        let NamedType {
            declaration, file, ..
        } = &types.list[index];
        let (name, declared, file) = (
            declaration.name.clone(),
            Arc::clone(&declaration.declared),
            file.clone(),
        );
        if file.is_none() {
            let mut mentioned = Vec::new();
            declared
                .spec
                .each_name(&mut |name, at| mentioned.push((Name::new(name), name.clone(), at)));
            for (key, name, at) in mentioned {
                types.ambiguous(&key, &name, at, self.out);
                types.mentioned.insert(key);
            }
        }
        let meaning = self.type_of(types, &declared.spec, &name, file.as_ref());
        let meaning = meaning.map(|meaning| self.with_initial(&declared, meaning, file.as_ref()));
        if let Some((ty, initial)) = meaning {
            types.list[index].ty = Some(ty);
            types.list[index].initial = initial;
        }
        self.way.pop();
        self.state[index] = State::Done;
    }

    fn say(&mut self, file: Option<&Arc<str>>, problem: impl FnOnce() -> NameProblem) {
        if file.is_none() {
            self.out.push(problem());
        }
    }

    /// What a declaration of a tag or member means.
    fn declared(
        &mut self,
        types: &mut NamedTypes,
        declared: &Declared,
        file: Option<&Arc<str>>,
    ) -> Option<Meaning> {
        let meaning = self.type_of(types, &declared.spec, "", file)?;
        Some(self.with_initial(declared, meaning, file))
    }

    /// A type with the values that its declaration says.
    fn with_initial(
        &mut self,
        declared: &Declared,
        (ty, default): Meaning,
        file: Option<&Arc<str>>,
    ) -> Meaning {
        let Some(initial) = &declared.initial else {
            return (ty, default);
        };
        match constant::initial_values(&initial.node, ty) {
            Ok(values) => (ty, Some(values.into())),
            Err(problem) => {
                let start = initial.start;
                self.say(file, || NameProblem::InitialValue(problem.moved_by(start)));
                (ty, default)
            }
        }
    }

    /// The type that is written so, under this name, with the values at the start that its parts say.
    fn type_of(
        &mut self,
        types: &mut NamedTypes,
        spec: &TypeSpec,
        name: &str,
        file: Option<&Arc<str>>,
    ) -> Option<Meaning> {
        match &spec.kind {
            SpecKind::Known(ty) => Some((*ty, None)),
            SpecKind::Subrange(scalar, low) => Some((Type::Scalar(*scalar), Some(type_spec::one(*low)))),
            SpecKind::Block(block) => {
                let id = TypeId::of(Compound::Block(block.clone()))?;
                Some((Type::Compound(id), None))
            }
            SpecKind::Named(named) => self.named(types, named, spec.range, file),
            SpecKind::Enumeration(values) => {
                let values = values.iter().map(|(name, _, number)| (name.clone(), *number));
                let id = EnumId::of(Enumeration {
                    name: name.into(),
                    values: values.collect(),
                });
                Some((Type::Scalar(Scalar::Enum(id)), None))
            }
            SpecKind::Array(dimensions, element) => {
                let (element, default) = self.type_of(types, element, "", file)?;
                let ty = match (dimensions.as_slice(), element) {
                    (&[(first, last)], Type::Scalar(element)) => Type::Array { first, last, element },
                    _ => {
                        let array = ArrayType {
                            dimensions: dimensions.as_slice().into(),
                            element,
                        };
                        Type::Compound(self.of(Compound::Array(array), spec.range, file)?)
                    }
                };
                let count = (ty.value_count() / element.value_count().max(1)) as usize;
                Some((
                    ty,
                    default.map(|one| std::iter::repeat_n(&one[..], count).flatten().cloned().collect()),
                ))
            }
            SpecKind::Structure(specs) => {
                let mut members = Vec::with_capacity(specs.len());
                let mut is_whole = !specs.is_empty();
                for member in specs {
                    match self.declared(types, &member.declared, file) {
                        Some((ty, initial)) => members.push(MemberType {
                            name: member.name.clone(),
                            key: Name::new(&member.name),
                            ty,
                            initial,
                        }),
                        None => is_whole = false,
                    }
                }
                let structure = Structure {
                    name: name.into(),
                    members: members.into(),
                };
                let id = self.of(Compound::Structure(structure), spec.range, file)?;
                is_whole.then_some((Type::Compound(id), None))
            }
        }
    }

    /// The number of a type, which may be too large.
    fn of(&mut self, ty: Compound, range: TextRange, file: Option<&Arc<str>>) -> Option<TypeId> {
        let id = TypeId::of(ty);
        if id.is_none() {
            let message = format!("the type has more than {MOST_PARTS} parts: make it smaller");
            self.say(file, || NameProblem::Meaningless(range, message));
        }
        id
    }

    fn named(
        &mut self,
        types: &mut NamedTypes,
        name: &SmolStr,
        range: TextRange,
        file: Option<&Arc<str>>,
    ) -> Option<Meaning> {
        let Some(index) = types.position(name, file) else {
            let near = types.list.iter().map(|ty| ty.declaration.name.as_str());
            let near = type_spec::nearest_type(name, near).map(SmolStr::from);
            let name = name.clone();
            self.say(file, || NameProblem::UnknownType {
                name,
                at: range,
                near,
            });
            return None;
        };
        match self.state[index] {
            State::Done => {}
            State::Open if self.way.len() < DEEPEST => self.read(types, index),
            State::Open => {
                let message = format!("types are nested deeper than {DEEPEST} here: make `{name}` smaller");
                self.say(file, || NameProblem::Meaningless(range, message));
                return None;
            }
            State::Reading => {
                let from = self.way.iter().position(|open| *open == index).unwrap_or(0);
                let around = self.way[from..].iter();
                let names: Vec<SmolStr> = around
                    .map(|open| types.list[*open].declaration.name.clone())
                    .collect();
                self.say(file, || NameProblem::RecursiveType { names, at: range });
                return None;
            }
        }
        let found = &types.list[index];
        Some((found.ty?, found.initial.clone()))
    }
}
