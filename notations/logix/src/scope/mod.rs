//! The tags of a project in their scopes: how ladder text spells them, and what they are.

mod instances;
mod place;

pub(crate) use instances::Begins;
pub(crate) use place::Place;

use crate::mnemonic::Role;
use crate::model::{Project, Tag, Usage};
use crate::operand::{Expr, Path, Step, parse};
use crate::types::{Elem, Ty, Types};
use crate::values::Value;
use ladder_format::program;
use ladder_notation::names::Names;
use std::collections::{HashMap, HashSet};

/// A declared tag.
#[derive(Debug, Clone)]
pub(crate) struct Symbol {
    pub(crate) name: String,
    pub(crate) original: String,
    pub(crate) scope: usize,
    pub(crate) ty: Ty,
    pub(crate) value: Option<Value>,
    pub(crate) kind: Kind,
    /// A call must give it.
    pub(crate) required: bool,
    /// Another program uses it.
    pub(crate) shared: bool,
    pub(crate) comment: Option<String>,
    /// Where the file declares it, if it does.
    pub(crate) at: Option<usize>,
}

impl Symbol {
    /// One without a value and a name.
    fn new(scope: usize, original: &str, ty: Ty) -> Symbol {
        Symbol {
            name: String::new(),
            original: original.to_owned(),
            scope,
            ty,
            value: None,
            kind: Kind::Plain,
            required: false,
            shared: false,
            comment: None,
            at: None,
        }
    }

    /// The scope whose declarations it is among: what several programs use is the controller's.
    pub(crate) fn declared_in(&self) -> usize {
        if self.shared { CONTROLLER } else { self.scope }
    }
}

/// The section that a tag is declared in.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Kind {
    Plain,
    Constant,
    Input,
    Output,
    InOut,
}

#[derive(Debug, Clone)]
enum Entry {
    Symbol(usize),
    Alias(Path),
    /// A tag that cannot be here, and why.
    Opaque(String),
}

/// What sees the same tags.
#[derive(Debug, Default)]
struct Scope {
    /// `program Main`
    title: String,
    entries: HashMap<String, Entry>,
    parent: Option<usize>,
    /// The names of an Add-On Instruction; others share those of the file.
    own_names: Option<Names>,
}

/// What the comment of a constant says whose parts are all 0.
pub(crate) const CLEARED: &str = "helper: all of it is 0";

/// The scope of the controller; the programs' follow, after them those of the Add-On Instructions.
pub(crate) const CONTROLLER: usize = 0;

/// All tags.
#[derive(Debug)]
pub(crate) struct Tags {
    pub(crate) types: Types,
    pub(crate) symbols: Vec<Symbol>,
    scopes: Vec<Scope>,
    names: Names,
    /// How many tags have a name in the file.
    pub(crate) named: usize,
    /// Inputs of instances that begin with a value of their own.
    pub(crate) begins: Vec<Begins>,
    /// Tags of types that the file does not declare: place, tag, type.
    pub(crate) opened: Vec<(usize, String, Ty)>,
    /// Names that tags of several scopes have, in capitals.
    ambiguous: HashSet<String>,
    /// What undeclared tags that become tags here are parts of, in capitals.
    undeclared: HashSet<String>,
}

impl Tags {
    pub(crate) fn of(project: &Project) -> Tags {
        let mut tags = Tags {
            types: Types::of(project),
            symbols: Vec::new(),
            scopes: Vec::new(),
            names: Names::default(),
            named: 0,
            begins: Vec::new(),
            opened: Vec::new(),
            ambiguous: ambiguous(project),
            undeclared: HashSet::new(),
        };
        tags.scopes.push(Scope {
            title: "the controller".to_owned(),
            ..Scope::default()
        });
        for program in &project.programs {
            tags.scopes.push(Scope {
                title: format!("program {}", program.name),
                parent: Some(CONTROLLER),
                ..Scope::default()
            });
        }
        for aoi in &project.aois {
            tags.scopes.push(Scope {
                title: format!("Add-On Instruction {}", aoi.name),
                own_names: Some(names_in_body()),
                ..Scope::default()
            });
        }
        tags.declare_all(CONTROLLER, &project.tags);
        for (number, program) in project.programs.iter().enumerate() {
            tags.declare_all(1 + number, &program.tags);
        }
        for (number, aoi) in project.aois.iter().enumerate() {
            let scope = 1 + project.programs.len() + number;
            tags.declare_all(scope, &aoi.parameters);
            tags.declare_all(scope, &aoi.locals);
        }
        tags.note_begins(project);
        tags
    }

    fn declare_all(&mut self, scope: usize, tags: &[Tag]) {
        for tag in tags {
            self.declare(scope, tag);
        }
    }

    fn declare(&mut self, scope: usize, tag: &Tag) {
        let key = tag.name.to_ascii_uppercase();
        let in_body = self.scopes[scope].own_names.is_some();
        if in_body && matches!(key.as_str(), "ENABLEIN" | "ENABLEOUT") {
            return;
        }
        if let Some(target) = &tag.alias {
            let entry = match parse(target) {
                Ok(Expr::Path(path)) => {
                    self.undeclared.insert(module(&path));
                    Entry::Alias(path)
                }
                _ => Entry::Opaque(format!("it is an alias for `{target}`, which is no tag")),
            };
            self.scopes[scope].entries.insert(key, entry);
            return;
        }
        let Some(ty) = self.types.of_tag(tag) else {
            let why = format!("its type {} is not declared in the file", tag.ty);
            self.scopes[scope].entries.insert(key, Entry::Opaque(why));
            return;
        };
        if self.types.is_open(&ty) {
            self.opened
                .push((tag.at, format!("tag {}", tag.name), ty.clone()));
        }
        let value = tag
            .value
            .as_ref()
            .and_then(|raw| Value::of(raw, &ty, &self.types));
        let kind = match tag.usage {
            // Programs have parameters, too.
            Usage::Input => Kind::Input,
            Usage::Output => Kind::Output,
            Usage::InOut if in_body => Kind::InOut,
            _ if tag.constant => Kind::Constant,
            _ if tag.name.ends_with(":I") => Kind::Input,
            _ if tag.name.ends_with(":O") => Kind::Output,
            _ => Kind::Plain,
        };
        self.add(Symbol {
            value,
            kind,
            required: tag.required,
            comment: tag.comment.clone(),
            at: Some(tag.at),
            ..Symbol::new(scope, &tag.name, ty)
        });
    }

    /// Declares a tag, under a name of its own.
    fn add(&mut self, mut symbol: Symbol) -> usize {
        let title = &self.scopes[symbol.scope].title;
        let like = match title.strip_prefix("program ") {
            Some(program) if self.ambiguous.contains(&symbol.original.to_ascii_uppercase()) => {
                format!("{program}_{}", symbol.original)
            }
            _ => symbol.original.clone(),
        };
        symbol.name = self.fresh(symbol.scope, &like);
        if symbol.name != symbol.original {
            let comment = symbol
                .comment
                .take()
                .map_or_else(String::new, |told| format!(": {told}"));
            symbol.comment = Some(format!("{}{comment}", symbol.original));
        }
        self.types.keep(&symbol.ty);
        let key = symbol.original.to_ascii_uppercase();
        let number = self.symbols.len();
        self.named += 1;
        self.scopes[symbol.scope]
            .entries
            .insert(key, Entry::Symbol(number));
        self.symbols.push(symbol);
        number
    }

    /// A name that nothing in the scope has.
    pub(crate) fn fresh(&mut self, scope: usize, like: &str) -> String {
        match &mut self.scopes[scope].own_names {
            Some(names) => names.fresh(like),
            None => self.names.fresh(like),
        }
    }

    /// The tags that are seen in a scope by their own names, those of the scopes around it first.
    pub(crate) fn seen(&self, scope: usize) -> Vec<&Symbol> {
        let mut scopes: Vec<usize> =
            std::iter::successors(Some(scope), |scope| self.scopes[*scope].parent).collect();
        scopes.reverse();
        let entries = scopes
            .iter()
            .flat_map(|scope| self.scopes[*scope].entries.values());
        let symbols = entries.filter_map(|entry| match entry {
            Entry::Symbol(symbol) => Some(&self.symbols[*symbol]),
            _ => None,
        });
        symbols.filter(|symbol| !symbol.original.is_empty()).collect()
    }

    /// The names that are taken in a scope.
    pub(crate) fn names(&self, scope: usize) -> Names {
        self.scopes[scope]
            .own_names
            .as_ref()
            .unwrap_or(&self.names)
            .clone()
    }

    /// Declares a tag that the translation needs.
    pub(crate) fn helper(&mut self, scope: usize, like: &str, elem: Elem, comment: &str) -> program::Path {
        let name = self.fresh(scope, like);
        let number = self.symbols.len();
        self.symbols.push(Symbol {
            name: name.clone(),
            comment: (!comment.is_empty()).then(|| comment.to_owned()),
            ..Symbol::new(scope, "", Ty::Elem(elem))
        });
        let entries = &mut self.scopes[scope].entries;
        entries
            .entry(name.to_ascii_uppercase())
            .or_insert(Entry::Symbol(number));
        program::Path::tag(name)
    }

    /// A constant whose parts are all 0. None: a part of the type is an instance.
    pub(crate) fn cleared(&mut self, scope: usize, ty: &Ty) -> Option<program::Path> {
        if self.types.holds_instance(ty, 0) {
            return None;
        }
        let known = self.symbols.iter().find(|symbol| {
            symbol.kind == Kind::Constant
                && symbol.comment.as_deref() == Some(CLEARED)
                && symbol.ty == *ty
                && symbol.scope == scope
        });
        if let Some(known) = known {
            return Some(program::Path::tag(&known.name));
        }
        let name = self.fresh(scope, "cleared");
        self.symbols.push(Symbol {
            name: name.clone(),
            kind: Kind::Constant,
            comment: Some(CLEARED.to_owned()),
            ..Symbol::new(scope, "", ty.clone())
        });
        Some(program::Path::tag(name))
    }

    /// What an operand is known as, in a scope or one around it.
    fn entry(&self, scope: usize, key: &str) -> Option<(usize, &Entry)> {
        let mut next = Some(scope);
        while let Some(scope) = next {
            if let Some(entry) = self.scopes[scope].entries.get(key) {
                return Some((scope, entry));
            }
            next = self.scopes[scope].parent;
        }
        None
    }

    /// The type of what a path begins with, and the steps from there on, those of aliases first.
    pub(crate) fn declared_type(&mut self, scope: usize, path: &Path) -> Option<(Ty, Vec<Step>)> {
        let (mut scope, mut path) = self.in_its_scope(scope, path).ok()?;
        for _ in 0..16 {
            match self.entry(scope, &path.root.to_ascii_uppercase())? {
                (_, Entry::Symbol(symbol)) => return Some((self.symbols[*symbol].ty.clone(), path.steps)),
                (of, Entry::Alias(target)) => {
                    let mut target = target.clone();
                    target.steps.append(&mut path.steps);
                    (scope, path) = (of, target);
                }
                (_, Entry::Opaque(_)) => return None,
            }
        }
        None
    }

    /// The type of a parameter of an Add-On Instruction.
    pub(crate) fn parameter_type(&self, aoi: usize, name: &str) -> Option<Ty> {
        let symbol = self.parameter_symbol(self.scopes.len() - self.aois() + aoi, name)?;
        Some(self.symbols[symbol].ty.clone())
    }

    /// The scope that declares a tag, and its name in capitals; of an alias those of the tag that it names.
    pub(crate) fn declared_as(&self, scope: usize, name: &str) -> Option<(usize, String)> {
        let (mut scope, mut key) = (scope, name.to_ascii_uppercase());
        for _ in 0..16 {
            match self.entry(scope, &key)? {
                (of, Entry::Symbol(_)) => return Some((of, key)),
                (of, Entry::Alias(target)) => (scope, key) = (of, target.root.to_ascii_uppercase()),
                (_, Entry::Opaque(_)) => return None,
            }
        }
        None
    }

    /// Notes a path that may become a tag of its own.
    pub(crate) fn note_undeclared(&mut self, scope: usize, path: &Path) {
        let is_whole = |step: &Step| matches!(step, Step::Member(_) | Step::Bit(_));
        let (mut scope, mut path) = (scope, path.clone());
        for _ in 0..16 {
            match self.entry(scope, &path.root.to_ascii_uppercase()) {
                Some((of, Entry::Alias(target))) => {
                    let mut target = target.clone();
                    target.steps.append(&mut path.steps);
                    (scope, path) = (of, target);
                }
                Some(_) => return,
                None => break,
            }
        }
        if path.steps.iter().all(is_whole) {
            self.undeclared.insert(module(&path));
        }
    }

    /// The tags here that change if what a path leads to is written. None: it is not known which.
    pub(crate) fn written(&mut self, scope: usize, path: &Path) -> Option<Vec<String>> {
        let (mut scope, mut path) = self.in_its_scope(scope, path).ok()?;
        for _ in 0..16 {
            match self.entry(scope, &path.root.to_ascii_uppercase()) {
                Some((_, Entry::Symbol(symbol))) => {
                    let own = &self.symbols[*symbol];
                    let is_constant = own.kind == Kind::Constant;
                    return Some((!is_constant).then(|| own.name.clone()).into_iter().collect());
                }
                // It is not here.
                Some((_, Entry::Opaque(_))) => return Some(Vec::new()),
                Some((of, Entry::Alias(target))) => (scope, path) = (of, target.clone()),
                None if self.undeclared.contains(&module(&path)) => return None,
                None => return Some(Vec::new()),
            }
        }
        None
    }

    /// Declares what is nowhere declared, where its first use shows what it is.
    pub(crate) fn declare_by_use(&mut self, scope: usize, path: &Path, role: Role) {
        let standard = match role {
            Role::Timer => "TIMER",
            Role::Counter => "COUNTER",
            Role::Control => "CONTROL",
            _ => return,
        };
        let key = path.root.to_ascii_uppercase();
        let in_body = self.scopes[scope].own_names.is_some();
        if path.steps.is_empty()
            && !in_body
            && self.entry(scope, &key).is_none()
            && let Some(ty) = self.types.named(standard, &[])
        {
            self.undeclared(&path.root, ty);
        }
    }

    fn undeclared(&mut self, original: &str, ty: Ty) -> usize {
        let kind = match original {
            name if name.contains(":I") || name.starts_with("I:") => Kind::Input,
            name if name.contains(":O") || name.starts_with("O:") => Kind::Output,
            _ => Kind::Plain,
        };
        self.add(Symbol {
            kind,
            ..Symbol::new(CONTROLLER, original, ty)
        })
    }

    fn aois(&self) -> usize {
        self.scopes
            .iter()
            .filter(|scope| scope.own_names.is_some())
            .count()
    }

    /// The tag of an input or output parameter, by the number of its Add-On Instruction.
    pub(crate) fn parameter_symbol(&self, scope: usize, name: &str) -> Option<usize> {
        match self.scopes[scope].entries.get(&name.to_ascii_uppercase()) {
            Some(Entry::Symbol(symbol)) => Some(*symbol),
            _ => None,
        }
    }
}

/// The names in a body, which has an `EN` and an `ENO` of its own.
fn names_in_body() -> Names {
    let mut names = Names::default();
    for own in ["EN", "ENO"] {
        names.fresh(own);
    }
    names
}

/// What an address is a part of: the module, or the word.
fn module(path: &Path) -> String {
    let word = path.root.split('/').next().unwrap_or_default();
    word.to_ascii_uppercase()
}

/// The names that tags of several scopes have, in capitals.
fn ambiguous(project: &Project) -> HashSet<String> {
    let programs = project.programs.iter().map(|program| &program.tags);
    let mut once = HashSet::new();
    let all = std::iter::once(&project.tags).chain(programs).flatten();
    let keys = all.map(|tag| tag.name.to_ascii_uppercase());
    keys.filter(|key| !once.insert(key.clone())).collect()
}
