//! The tags of a project in their scopes: how ladder text spells them, what they are, and what a path leads to.

use crate::mnemonic::Role;
use crate::model::{Project, Raw, Tag, Usage};
use crate::operand::{Expr, Path, Step, parse};
use crate::types::{Elem, Ty, Types};
use crate::values::Value;
use ladder_notation::names::Names;
use std::collections::HashMap;

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
            comment: None,
            at: None,
        }
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

/// The scope of the controller; the programs' follow, after them those of the Add-On Instructions.
pub(crate) const CONTROLLER: usize = 0;

/// Where a path leads.
#[derive(Debug, Clone)]
pub(crate) struct Place {
    pub(crate) text: String,
    pub(crate) ty: Ty,
    /// The tag, the way to the part in its value, and the bit; without computed indices.
    pub(crate) part: Option<(usize, Vec<usize>, Option<u32>)>,
    /// It is a parameter of this instance of an Add-On Instruction.
    pub(crate) parameter: Option<(String, usize, usize)>,
}

impl Place {
    pub(crate) fn elem(&self) -> Option<Elem> {
        match self.ty {
            Ty::Elem(elem) => Some(elem),
            _ => None,
        }
    }
}

/// All tags.
#[derive(Debug)]
pub(crate) struct Tags {
    pub(crate) types: Types,
    pub(crate) symbols: Vec<Symbol>,
    scopes: Vec<Scope>,
    names: Names,
    /// Inputs of instances that the program uses from outside: the tag that a call passes.
    pub(crate) passed: HashMap<(String, usize), usize>,
    /// Tags that are not declared: place, element, reason.
    pub(crate) unknown: Vec<(usize, String, String)>,
    /// Instances of Add-On Instructions with what the file says of their inputs.
    instances: Vec<(usize, Raw)>,
}

impl Tags {
    pub(crate) fn of(project: &Project) -> Tags {
        let mut tags = Tags {
            types: Types::of(project),
            symbols: Vec::new(),
            scopes: Vec::new(),
            names: Names::default(),
            passed: HashMap::new(),
            unknown: Vec::new(),
            instances: Vec::new(),
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
                own_names: Some(Names::default()),
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
        for (symbol, raw) in std::mem::take(&mut tags.instances) {
            tags.inputs_of(symbol, &raw);
        }
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
                Ok(Expr::Path(path)) => Entry::Alias(path),
                _ => Entry::Opaque(format!("it is an alias for `{target}`, which is no tag")),
            };
            self.scopes[scope].entries.insert(key, entry);
            return;
        }
        let Some(ty) = self.types.of_tag(tag) else {
            let why = format!("its type {} is not declared in the file", tag.ty);
            self.unknown
                .push((tag.at, format!("tag {}", tag.name), why.clone()));
            self.scopes[scope].entries.insert(key, Entry::Opaque(why));
            return;
        };
        let value = tag
            .value
            .as_ref()
            .and_then(|raw| Value::of(raw, &ty, &self.types));
        let kind = match tag.usage {
            Usage::Input if in_body => Kind::Input,
            Usage::Output if in_body => Kind::Output,
            Usage::InOut if in_body => Kind::InOut,
            _ if tag.constant => Kind::Constant,
            _ if tag.name.ends_with(":I") => Kind::Input,
            _ if tag.name.ends_with(":O") => Kind::Output,
            _ => Kind::Plain,
        };
        let is_instance = matches!(ty, Ty::Aoi(_));
        let symbol = self.add(Symbol {
            value,
            kind,
            required: tag.required,
            comment: tag.comment.clone(),
            at: Some(tag.at),
            ..Symbol::new(scope, &tag.name, ty)
        });
        if is_instance {
            let raw = tag.value.clone();
            self.instances.extend(raw.map(|raw| (symbol, raw)));
        }
    }

    /// Inputs of an instance that no call gives and that have another value than in other instances.
    fn inputs_of(&mut self, instance: usize, raw: &Raw) {
        let own = self.symbols[instance].clone();
        let (Ty::Aoi(aoi), Raw::Structure(_, members)) = (&own.ty, raw) else {
            return;
        };
        let scope = self.scopes.len() - self.aois() + aoi;
        for (name, raw) in members {
            let Some(symbol) = self.parameter_symbol(scope, name) else {
                continue;
            };
            let parameter = &self.symbols[symbol];
            let value = Value::of(raw, &parameter.ty, &self.types);
            if parameter.kind == Kind::Input && !parameter.required && value != parameter.value {
                self.pass(own.scope, &own.name, symbol);
                if let Some(passed) = self.passed.get(&(own.name.clone(), symbol)) {
                    self.symbols[*passed].value = value;
                }
            }
        }
    }

    /// Declares a tag, under a name of its own.
    fn add(&mut self, mut symbol: Symbol) -> usize {
        symbol.name = self.fresh(symbol.scope, &symbol.original);
        if symbol.name != symbol.original {
            let comment = symbol
                .comment
                .take()
                .map_or_else(String::new, |said| format!(": {said}"));
            symbol.comment = Some(format!("{}{comment}", symbol.original));
        }
        self.types.keep(&symbol.ty);
        let key = symbol.original.to_ascii_uppercase();
        let number = self.symbols.len();
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

    /// Declares a tag that the translation needs.
    pub(crate) fn helper(&mut self, scope: usize, like: &str, elem: Elem, comment: &str) -> String {
        let name = self.fresh(scope, like);
        let number = self.symbols.len();
        self.symbols.push(Symbol {
            name: name.clone(),
            comment: Some(comment.to_owned()),
            ..Symbol::new(scope, "", Ty::Elem(elem))
        });
        let entries = &mut self.scopes[scope].entries;
        entries
            .entry(name.to_ascii_uppercase())
            .or_insert(Entry::Symbol(number));
        name
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
        if path.steps.is_empty() && !in_body && self.entry(scope, &key).is_none() {
            if let Some(ty) = self.types.named(standard, &[]) {
                self.undeclared(&path.root, ty);
            }
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

    /// Where a path leads.
    ///
    /// # Errors
    ///
    /// If it leads nowhere: a sentence.
    pub(crate) fn place(&mut self, scope: usize, path: &Path, role: Role) -> Result<Place, String> {
        let mut scope = scope;
        let mut path = path.clone();
        if let Some(program) = path.root.strip_prefix('\\') {
            let title = format!("program {program}");
            let other = self
                .scopes
                .iter()
                .position(|scope| scope.title.eq_ignore_ascii_case(&title));
            let (Some(other), Some(Step::Member(tag))) = (other, path.steps.first().cloned()) else {
                return Err(format!("there is no program `{program}` in the file"));
            };
            scope = other;
            path.root = tag;
            path.steps.remove(0);
        }
        for _ in 0..16 {
            let key = path.root.to_ascii_uppercase();
            if let Some(system) = self.system(scope, &key, &path) {
                return Ok(system);
            }
            match self.entry(scope, &key) {
                Some((_, Entry::Symbol(symbol))) => {
                    let symbol = *symbol;
                    return self.steps(scope, symbol, &path);
                }
                Some((_, Entry::Opaque(why))) => return Err(format!("`{}`: {why}", path.root)),
                Some((of, Entry::Alias(target))) => {
                    let mut target = target.clone();
                    let is_known = self.entry(of, &target.root.to_ascii_uppercase()).is_some();
                    if !is_known && self.scopes[of].own_names.is_none() {
                        return self.alias_of_unknown(of, &path, &target, role);
                    }
                    target.steps.append(&mut path.steps);
                    (scope, path) = (of, target);
                }
                None => return self.unknown(scope, &path, role),
            }
        }
        Err(format!("`{}` is an alias of itself", path.root))
    }

    /// What the controller itself keeps.
    fn system(&self, scope: usize, key: &str, path: &Path) -> Option<Place> {
        let in_body = self.scopes[scope].own_names.is_some();
        let text = match key {
            "S:FS" => "SYS.FIRST_SCAN",
            "S:1" if path.steps == [Step::Bit(15)] => "SYS.FIRST_SCAN",
            "ENABLEIN" if in_body => "EN",
            "ENABLEOUT" if in_body => "ENO",
            _ => return None,
        };
        Some(Place {
            text: text.to_owned(),
            ty: Ty::Elem(Elem::Bool),
            part: None,
            parameter: None,
        })
    }

    /// An alias of an input or output that the file does not declare: it stands for that.
    fn alias_of_unknown(
        &mut self,
        scope: usize,
        path: &Path,
        target: &Path,
        role: Role,
    ) -> Result<Place, String> {
        let spelled = spelled(target);
        let key = spelled.to_ascii_uppercase();
        let symbol = match self.entry(scope, &key) {
            Some((_, Entry::Symbol(symbol))) => *symbol,
            _ => {
                let role = if path.steps.is_empty() { role } else { Role::Value };
                let ty = match target.steps.last() {
                    Some(Step::Bit(_)) => Ty::Elem(Elem::Bool),
                    _ => by_role(role).ok_or_else(|| format!("`{spelled}` is not declared in the file"))?,
                };
                let symbol = self.undeclared(&spelled, ty);
                let name = self.fresh(scope, &path.root);
                self.symbols[symbol].name = name;
                self.symbols[symbol].comment = Some(format!("alias for {spelled}"));
                symbol
            }
        };
        let entry = Entry::Symbol(symbol);
        self.scopes[scope]
            .entries
            .insert(path.root.to_ascii_uppercase(), entry);
        self.steps(scope, symbol, path)
    }

    /// What no tag of the file is: it becomes a tag of its own, named for the whole path.
    fn unknown(&mut self, scope: usize, path: &Path, role: Role) -> Result<Place, String> {
        if self.scopes[scope].own_names.is_some() {
            let title = &self.scopes[scope].title;
            return Err(format!("`{}` is not declared in {title}", path.root));
        }
        let whole = spelled(path);
        if path
            .steps
            .iter()
            .any(|step| matches!(step, Step::Index(_) | Step::ComputedBit(_)))
        {
            return Err(format!("`{}` is not declared in the file", path.root));
        }
        let mut steps = path.steps.clone();
        let mut name = whole.clone();
        let is_known = |tags: &Tags, name: &str| {
            let found = tags.entry(scope, &name.to_ascii_uppercase());
            matches!(found, Some((_, Entry::Symbol(_))))
        };
        let mut role = role;
        if !is_known(self, &name)
            && let Some(Step::Bit(_)) = steps.last()
        {
            steps.pop();
            name = spelled(&Path {
                root: path.root.clone(),
                steps: steps.clone(),
            });
            role = Role::Value;
        } else {
            steps.clear();
        }
        let symbol = match self.entry(scope, &name.to_ascii_uppercase()) {
            Some((_, Entry::Symbol(symbol))) => *symbol,
            _ => {
                let ty =
                    by_role(role).ok_or_else(|| format!("`{}` is not declared in the file", path.root))?;
                self.undeclared(&name, ty)
            }
        };
        let bit = match path.steps.last() {
            Some(bit @ Step::Bit(_)) if name != whole => vec![bit.clone()],
            _ => Vec::new(),
        };
        let rest = Path {
            root: String::new(),
            steps: bit,
        };
        self.steps(scope, symbol, &rest)
    }

    /// From a tag to a part of it.
    fn steps(&mut self, scope: usize, symbol: usize, path: &Path) -> Result<Place, String> {
        let own = &self.symbols[symbol];
        let mut place = Place {
            text: own.name.clone(),
            ty: own.ty.clone(),
            part: Some((symbol, Vec::new(), None)),
            parameter: None,
        };
        for step in &path.steps {
            if place
                .parameter
                .as_ref()
                .is_some_and(|(_, _, number)| *number == usize::MAX)
            {
                return Err(format!("`{}` is not reached from outside", place.text));
            }
            match (step, &place.ty) {
                (Step::Member(name), Ty::Structure(index)) => {
                    let Some((number, field)) = self.types.member(*index, name) else {
                        let of = &self.types.all[*index].original;
                        return Err(format!("{of} has no member `{name}` that can be read here"));
                    };
                    place.text.push('.');
                    place.text.push_str(&field.name);
                    let ty = field.ty.clone();
                    if let Some((_, part, _)) = &mut place.part {
                        part.push(number);
                    }
                    place.ty = ty;
                }
                (Step::Member(name), Ty::Aoi(aoi)) => {
                    place = self.parameter(place.text.clone(), *aoi, name)?
                }
                (Step::Index(indices), Ty::Array(ty, sizes)) => {
                    if indices.len() != sizes.len() {
                        let (many, text) = (sizes.len(), &place.text);
                        return Err(format!("`{text}` has {many} dimensions"));
                    }
                    let (ty, sizes) = ((**ty).clone(), sizes.clone());
                    let mut number = Some(0usize);
                    let mut texts = Vec::new();
                    for (index, size) in indices.iter().zip(&sizes) {
                        number = match (number, index) {
                            (Some(number), Expr::Int(index)) => {
                                if !(0..i64::from(*size)).contains(index) {
                                    return Err(format!("the index {index} is outside `{}`", place.text));
                                }
                                Some(number * *size as usize + *index as usize)
                            }
                            _ => None,
                        };
                        texts.push(self.formula(scope, index)?);
                    }
                    place.text = format!("{}[{}]", place.text, texts.join(", "));
                    match (&mut place.part, number) {
                        (Some((_, part, _)), Some(number)) => part.push(number),
                        (part, _) => *part = None,
                    }
                    place.ty = ty;
                }
                (Step::Bit(bit), Ty::Elem(elem)) if elem.is_integer() && *bit < elem.bits() => {
                    place.text = format!("{}.{bit}", place.text);
                    place.ty = Ty::Elem(Elem::Bool);
                    if let Some((_, _, of)) = &mut place.part {
                        *of = Some(*bit);
                    }
                }
                // An element without an index is the first one.
                (Step::Bit(_) | Step::Member(_), Ty::Array(ty, sizes)) if sizes.len() == 1 => {
                    let inner = Place {
                        text: format!("{}[0]", place.text),
                        ty: (**ty).clone(),
                        part: None,
                        parameter: None,
                    };
                    return Err(format!("`{}` is an array: say `{}`", place.text, inner.text));
                }
                (Step::ComputedBit(_), _) => {
                    return Err(format!("the bit of `{}` is computed", place.text));
                }
                _ => return Err(format!("`{}` has no such part", place.text)),
            }
        }
        Ok(place)
    }

    /// A parameter of an instance, seen from outside. An input that the program sets there is a tag that each call passes.
    fn parameter(&mut self, instance: String, aoi: usize, name: &str) -> Result<Place, String> {
        let scope = self.scopes.len() - self.aois() + aoi;
        if name.eq_ignore_ascii_case("EnableOut") || name.eq_ignore_ascii_case("EnableIn") {
            return Err(format!("`{name}` of an instance is the power of its block here"));
        }
        let entry = self.scopes[scope].entries.get(&name.to_ascii_uppercase());
        let Some(Entry::Symbol(symbol)) = entry else {
            return Err(format!(
                "`{instance}` has no parameter `{name}` that can be read here"
            ));
        };
        let own = &self.symbols[*symbol];
        match own.kind {
            Kind::Output => Ok(Place {
                text: format!("{instance}.{}", own.name),
                ty: own.ty.clone(),
                part: None,
                parameter: None,
            }),
            Kind::Input => {
                let symbol = *symbol;
                if let Some(passed) = self.passed.get(&(instance.clone(), symbol)) {
                    let passed = &self.symbols[*passed];
                    return Ok(Place {
                        text: passed.name.clone(),
                        ty: passed.ty.clone(),
                        part: None,
                        parameter: None,
                    });
                }
                Ok(Place {
                    text: format!("{instance}.{}", own.name),
                    ty: own.ty.clone(),
                    part: None,
                    parameter: Some((instance, aoi, symbol)),
                })
            }
            _ => Err(format!(
                "`{instance}.{name}` is inside the instruction, and not seen from outside"
            )),
        }
    }

    fn aois(&self) -> usize {
        self.scopes
            .iter()
            .filter(|scope| scope.own_names.is_some())
            .count()
    }

    /// Makes a tag for an input of an instance.
    pub(crate) fn pass(&mut self, scope: usize, instance: &str, parameter: usize) {
        let key = (instance.to_owned(), parameter);
        if self.passed.contains_key(&key) || instance.contains('[') {
            return;
        }
        let own = self.symbols[parameter].clone();
        let scope = if self.scopes[scope].own_names.is_some() {
            scope
        } else {
            CONTROLLER
        };
        let like = format!("{}_{}", instance.replace('.', "_"), own.name);
        let name = self.fresh(scope, &like);
        self.symbols.push(Symbol {
            name,
            original: String::new(),
            scope,
            kind: Kind::Plain,
            comment: Some(format!("input {} of {instance}", own.original)),
            at: None,
            ..own
        });
        self.passed.insert(key, self.symbols.len() - 1);
    }

    /// The tag of an input or output parameter, by the number of its Add-On Instruction.
    pub(crate) fn parameter_symbol(&self, scope: usize, name: &str) -> Option<usize> {
        match self.scopes[scope].entries.get(&name.to_ascii_uppercase()) {
            Some(Entry::Symbol(symbol)) => Some(*symbol),
            _ => None,
        }
    }
}

/// The type of a tag that is used so.
fn by_role(role: Role) -> Option<Ty> {
    Some(Ty::Elem(match role {
        Role::Bit => Elem::Bool,
        Role::Value | Role::Formula => Elem::Dint,
        Role::Text => Elem::String(82),
        _ => return None,
    }))
}

/// A path without computed parts, as the file spells it.
fn spelled(path: &Path) -> String {
    let mut out = path.root.clone();
    for step in &path.steps {
        match step {
            Step::Member(name) => out.push_str(&format!(".{name}")),
            Step::Bit(bit) => out.push_str(&format!(".{bit}")),
            Step::Index(_) | Step::ComputedBit(_) => {}
        }
    }
    out
}
