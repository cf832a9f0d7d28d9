//! What the names of types mean in a file: its own, and those that other files declare.

use super::limits;
use super::problem::NameProblem;
use crate::other_files::others::Others;
use crate::values::compound::{
    ArrayType, Compound, EnumId, Enumeration, MOST_PARTS, MemberType, Structure, TypeId,
};
use crate::values::types::{Scalar, Type};
use crate::values::value::Value;
use crate::written::constant;
use crate::written::type_spec::DeclaredType;
use crate::written::type_spec::{self, Declared, SpecKind, TypeSpec};
use ladder_syntax::{Name, TextRange};
use rustc_hash::{FxHashMap, FxHashSet, FxHasher};
use smol_str::SmolStr;
use std::hash::{Hash, Hasher};
use std::sync::Arc;

/// Types inside types nest no deeper than this.
const DEEPEST: usize = 50;

/// The types that a file can name. Of those of other files only what was asked for is known here: each file of a workspace has
/// types, and few of them concern another one.
#[derive(Debug, Clone, Default)]
pub struct NamedTypes {
    /// The file's own in the order of the text, then those of other files.
    list: Vec<NamedType>,
    by_name: FxHashMap<Name, Vec<u32>>,
    /// How many are its own.
    own: usize,
    /// The names that were looked for in the other files.
    loaded: FxHashSet<Name>,
    others: Others,
    /// Stands for its own enumerations by their names.
    enumerations: u64,
    /// The names of the values of its own enumerations.
    values: FxHashSet<Name>,
    /// The names that the file's own declarations mention.
    pub(crate) mentioned: FxHashSet<Name>,
    /// Whether a type that was read has limits.
    pub(crate) have_limits: bool,
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
    is_read: bool,
}

impl NamedType {
    fn unread(declaration: DeclaredType, file: Option<&Arc<str>>) -> NamedType {
        NamedType {
            declaration,
            file: file.cloned(),
            ty: None,
            initial: None,
            is_read: false,
        }
    }
}

/// What a declaration means: a type, and the values at the start where something says so.
pub(crate) type Meaning = (Type, Option<Arc<[Value]>>);

impl NamedTypes {
    /// Those of a file and of the others. What is wrong with its own goes to `out`.
    pub(crate) fn new(own: Vec<DeclaredType>, others: &Others, out: &mut Vec<NameProblem>) -> NamedTypes {
        let mut types = NamedTypes {
            own: own.len(),
            others: others.clone(),
            ..NamedTypes::default()
        };
        types.list.extend(
            own.into_iter()
                .map(|declaration| NamedType::unread(declaration, None)),
        );
        for (index, ty) in (0..).zip(&types.list) {
            let same = types.by_name.entry(ty.declaration.key.clone()).or_default();
            if let Some(first) = same.first() {
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
            state: vec![State::Open; types.own],
            out,
            way: Vec::new(),
        };
        for index in 0..types.own {
            reading.read(&mut types, index);
        }
        let mut hasher = FxHasher::default();
        for ty in types.own() {
            if let Some(Type::Scalar(Scalar::Enum(id))) = ty.ty {
                (&ty.declaration.key, id).hash(&mut hasher);
            }
        }
        types.enumerations = hasher.finish();
        let enumerations = types.own().iter().filter_map(|ty| match ty.ty {
            Some(Type::Scalar(Scalar::Enum(id))) => Some(id.get()),
            _ => None,
        });
        let values = enumerations.flat_map(|enumeration| {
            let values = enumeration.values.iter().map(|(name, _)| Name::new(name));
            values.collect::<Vec<_>>()
        });
        types.values = values.collect();
        types
    }

    /// Looks for a name in the other files, if that was not done.
    fn load(&mut self, key: &Name) {
        if !self.loaded.insert(key.clone()) {
            return;
        }
        for (exports, ty) in self.others.types(key) {
            let same = self.by_name.entry(key.clone()).or_default();
            same.push(self.list.len() as u32);
            self.list.push(NamedType::unread(ty.clone(), Some(&exports.file)));
        }
    }

    /// Reads what a name means that nothing but an operand may mention. What is wrong with it is reported where it is declared.
    pub(crate) fn read(&mut self, name: &str) {
        self.load(&Name::new(name));
        if let Some(index) = self.position(name, None) {
            Reading::of_known(self, &mut Vec::new()).read(self, index);
        }
    }

    /// Whether there is an enumeration.
    pub(crate) fn have_values(&self) -> bool {
        !self.values.is_empty() || self.others.type_values().have_values()
    }

    /// Adds all that operands can mean by the name of a type.
    pub(crate) fn stamp(&self, hasher: &mut impl Hasher) {
        (self.enumerations, self.others.type_values().stamp).hash(hasher);
    }

    /// Whether an enumeration has a value of this name.
    pub fn has_value(&self, name: &Name) -> bool {
        self.values.contains(name) || self.others.type_values().contains(name)
    }

    /// The type of a name, as the file sees it.
    pub fn find(&self, name: &str) -> Option<&NamedType> {
        self.position(name, None).map(|index| &self.list[index])
    }

    /// The file's own, in the order of the text.
    pub fn own(&self) -> &[NamedType] {
        &self.list[..self.own]
    }

    /// Those of other files that its declarations and operands mention.
    pub fn of_others(&self) -> &[NamedType] {
        &self.list[self.own..]
    }

    /// All that the file can name, with the files that others are declared in.
    pub fn all(&self) -> impl Iterator<Item = (&DeclaredType, Option<&Arc<str>>)> {
        let own = self.own().iter().map(|ty| (&ty.declaration, None));
        let others = self.others.all_types();
        own.chain(others.map(|(exports, ty)| (ty, Some(&exports.file))))
    }

    /// What the declaration of a name says, as a file sees it; and the file that declares it, if it is another one.
    pub(crate) fn declaration(
        &self,
        name: &str,
        file: Option<&Arc<str>>,
    ) -> Option<(&TypeSpec, Option<&Arc<str>>)> {
        let found = &self.list[self.position(name, file)?];
        Some((&found.declaration.declared.spec, found.file.as_ref()))
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
        Reading::of_known(self, out).declared(self, declared, None)
    }

    /// Says so if a name means types of several other files.
    fn ambiguous(&mut self, key: &Name, name: &SmolStr, at: TextRange, out: &mut Vec<NameProblem>) {
        self.load(key);
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

    /// What a declaration of another file means; what is wrong with it is reported there.
    pub(crate) fn meaning_in(&mut self, declared: &Declared, file: &Arc<str>) -> Option<Meaning> {
        let mut unsaid = Vec::new();
        Reading::of_known(self, &mut unsaid).declared(self, declared, Some(file))
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

impl<'o> Reading<'o> {
    /// Where all that was asked for is read: what is asked for later is not.
    fn of_known(types: &NamedTypes, out: &'o mut Vec<NameProblem>) -> Reading<'o> {
        let state = |ty: &NamedType| if ty.is_read { State::Done } else { State::Open };
        Reading {
            state: types.list.iter().map(state).collect(),
            out,
            way: Vec::new(),
        }
    }
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
        let meaning = meaning.map(|meaning| self.with_initial(types, &declared, meaning, file.as_ref()));
        if let Some((ty, initial)) = meaning {
            types.list[index].ty = Some(ty);
            types.list[index].initial = initial;
        }
        types.list[index].is_read = true;
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
        Some(self.with_initial(types, declared, meaning, file))
    }

    /// A type with the values that its declaration says.
    fn with_initial(
        &mut self,
        types: &mut NamedTypes,
        declared: &Declared,
        (ty, default): Meaning,
        file: Option<&Arc<str>>,
    ) -> Meaning {
        let Some(initial) = &declared.initial else {
            return (ty, default);
        };
        let element = self.of_element(types, &declared.spec, file);
        match constant::initial_values(&initial.node, ty, element.as_deref()) {
            Ok(values) => {
                if file.is_none() {
                    let start = initial.start;
                    limits::check_initial(types, &declared.spec, &initial.node, &mut |problem| {
                        self.out.push(NameProblem::InitialValue(problem.moved_by(start)));
                    });
                }
                (ty, Some(values.into()))
            }
            Err(problem) => {
                let start = initial.start;
                self.say(file, || NameProblem::InitialValue(problem.moved_by(start)));
                (ty, default)
            }
        }
    }

    /// The values that the type of an array's elements says.
    fn of_element(
        &mut self,
        types: &mut NamedTypes,
        spec: &TypeSpec,
        file: Option<&Arc<str>>,
    ) -> Option<Arc<[Value]>> {
        match &spec.kind {
            SpecKind::Array(_, element) => self.type_of(types, element, "", file)?.1,
            SpecKind::Named(name) => {
                let index = types
                    .position(name, file)
                    .filter(|index| self.state[*index] == State::Done)?;
                let named = &types.list[index];
                let (declared, file) = (Arc::clone(&named.declaration.declared), named.file.clone());
                self.of_element(types, &declared.spec, file.as_ref())
            }
            _ => None,
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
            SpecKind::Subrange(scalar, (low, _)) => {
                types.have_limits = true;
                Some((Type::Scalar(*scalar), Some(type_spec::one(*low as i64))))
            }
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
                let mut is_whole = true;
                for member in specs {
                    match self.declared(types, &member.declared, file) {
                        Some((ty, initial)) => members.push(MemberType {
                            name: member.name.clone(),
                            key: Name::new(&member.name),
                            ty,
                            initial,
                            element: self.of_element(types, &member.declared.spec, file),
                        }),
                        None => is_whole = false,
                    }
                }
                if members.is_empty() {
                    return None;
                }
                let structure = Structure {
                    name: name.into(),
                    members: members.into(),
                    is_whole,
                };
                let id = self.of(Compound::Structure(structure), spec.range, file)?;
                Some((Type::Compound(id), None))
            }
            SpecKind::Unread => None,
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
        types.load(&Name::new(name));
        self.state.resize(types.list.len(), State::Open);
        let Some(index) = types.position(name, file) else {
            let near = file.is_none().then(|| {
                let all = types.all().map(|(declaration, _)| declaration.name.as_str());
                type_spec::nearest_type(name, all).map(SmolStr::from)
            });
            let near = near.flatten();
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
