//! Where a path leads: `cells[i].level.3`, an alias, a tag of another program, an input that the file does not declare.

use super::{Entry, Kind, Tags};
use crate::mnemonic::Role;
use crate::operand::{Expr, Path, Step};
use crate::types::{Elem, Ty};
use ladder_format::program;

/// Where a path leads.
#[derive(Debug, Clone)]
pub(crate) struct Place {
    /// As it is here.
    pub(crate) path: program::Path,
    pub(crate) ty: Ty,
    /// The tag, the way to the part in its value, and the bit; without computed indices.
    pub(crate) part: Option<(usize, Vec<usize>, Option<u32>)>,
    /// It is an output of an instance of an Add-On Instruction, or a part of one: only the instruction writes it.
    pub(crate) is_output: bool,
}

impl Place {
    /// A place of which no more is known than its type.
    pub(crate) const fn of(path: program::Path, ty: Ty) -> Place {
        Place {
            path,
            ty,
            part: None,
            is_output: false,
        }
    }

    /// Whether the controller keeps it, and no program writes it.
    pub(crate) fn is_system(&self) -> bool {
        self.path.root == "SYS"
    }

    pub(crate) fn elem(&self) -> Option<Elem> {
        match self.ty {
            Ty::Elem(elem) => Some(elem),
            _ => None,
        }
    }
}

impl Tags {
    /// Where a path leads.
    ///
    /// # Errors
    ///
    /// If it leads nowhere: a sentence.
    pub(crate) fn place(&mut self, scope: usize, path: &Path, role: Role) -> Result<Place, String> {
        let (mut scope, mut path) = self.in_its_scope(scope, path)?;
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
                    // A member of what a module has is a tag of its own, as where no alias leads there.
                    if !is_known && matches!(path.steps.first(), Some(Step::Member(_))) {
                        target.steps.append(&mut path.steps);
                        return self.unknown(of, &target, role);
                    }
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

    /// A path without the name of another program, and the scope that it is in. A tag that another program uses is noted as shared.
    pub(super) fn in_its_scope(&mut self, scope: usize, path: &Path) -> Result<(usize, Path), String> {
        let Some(program) = path.root.strip_prefix('\\') else {
            return Ok((scope, path.clone()));
        };
        let title = format!("program {program}");
        let mut scopes = self.scopes.iter();
        let other = scopes.position(|scope| scope.title.eq_ignore_ascii_case(&title));
        let (Some(other), Some((Step::Member(tag), steps))) = (other, path.steps.split_first()) else {
            return Err(format!("there is no program `{program}` in the file"));
        };
        let key = tag.to_ascii_uppercase();
        if let Some(Entry::Symbol(symbol)) = self.scopes[other].entries.get(&key) {
            self.symbols[*symbol].shared |= other != scope;
        }
        let path = Path {
            root: tag.clone(),
            steps: steps.to_vec(),
        };
        Ok((other, path))
    }

    /// What the controller itself keeps.
    fn system(&self, scope: usize, key: &str, path: &Path) -> Option<Place> {
        let in_body = self.scopes[scope].own_names.is_some();
        let path = match key {
            "S:FS" => program::Path::system("FIRST_SCAN"),
            "S:1" if path.steps == [Step::Bit(15)] => program::Path::system("FIRST_SCAN"),
            "ENABLEIN" if in_body => program::Path::tag("EN"),
            "ENABLEOUT" if in_body => program::Path::tag("ENO"),
            _ => return None,
        };
        Some(Place::of(path, Ty::Elem(Elem::Bool)))
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
        if path
            .steps
            .iter()
            .any(|step| matches!(step, Step::Index(_) | Step::ComputedBit(_)))
        {
            return Err(format!("`{}` is not declared in the file", path.root));
        }
        let (mut word, mut rest, mut role) = (path.clone(), Path::tag(""), role);
        let whole = self.entry(scope, &spelled(path).to_ascii_uppercase());
        if !matches!(whole, Some((_, Entry::Symbol(_)))) && matches!(path.steps.last(), Some(Step::Bit(_))) {
            rest.steps.extend(word.steps.pop());
            role = Role::Value;
        }
        let name = spelled(&word);
        let symbol = match self.entry(scope, &name.to_ascii_uppercase()) {
            Some((_, Entry::Symbol(symbol))) => *symbol,
            _ => {
                let ty =
                    by_role(role).ok_or_else(|| format!("`{}` is not declared in the file", path.root))?;
                self.undeclared(&name, ty)
            }
        };
        self.steps(scope, symbol, &rest)
    }

    /// From a tag to a part of it.
    fn steps(&mut self, scope: usize, symbol: usize, path: &Path) -> Result<Place, String> {
        let own = &self.symbols[symbol];
        let mut place = Place {
            part: Some((symbol, Vec::new(), None)),
            ..Place::of(program::Path::tag(&own.name), own.ty.clone())
        };
        for step in &path.steps {
            match (step, &place.ty) {
                (Step::Member(name), Ty::Structure(index)) => {
                    let Some((number, field)) = self.types.member(*index, name) else {
                        let of = &self.types.all[*index].original;
                        return Err(format!("{of} has no member `{name}` that can be read here"));
                    };
                    place.path = place.path.member(&field.name);
                    let ty = field.ty.clone();
                    if let Some((_, part, _)) = &mut place.part {
                        part.push(number);
                    }
                    place.ty = ty;
                }
                (Step::Member(name), Ty::Aoi(aoi)) => {
                    place = self.parameter(place.path, *aoi, name)?;
                }
                (Step::Index(indices), Ty::Array(ty, sizes)) => {
                    if indices.len() != sizes.len() {
                        let (many, path) = (sizes.len(), &place.path);
                        return Err(format!("`{path}` has {many} dimensions"));
                    }
                    let (ty, sizes) = ((**ty).clone(), sizes.clone());
                    let mut number = Some(0usize);
                    let mut own = Vec::new();
                    for (index, size) in indices.iter().zip(&sizes) {
                        number = match (number, index) {
                            (Some(number), Expr::Int(index)) => {
                                if !(0..i64::from(*size)).contains(index) {
                                    return Err(format!("the index {index} is outside `{}`", place.path));
                                }
                                number
                                    .checked_mul(*size as usize)
                                    .and_then(|row| row.checked_add(*index as usize))
                            }
                            _ => None,
                        };
                        own.push(self.formula(scope, index)?);
                    }
                    place.path = place.path.index(own);
                    match (&mut place.part, number) {
                        (Some((_, part, _)), Some(number)) => part.push(number),
                        (part, _) => *part = None,
                    }
                    place.ty = ty;
                }
                (Step::Bit(bit), Ty::Elem(elem)) if elem.is_integer() && *bit < elem.bits() => {
                    place.path = place.path.bit(*bit);
                    place.ty = Ty::Elem(Elem::Bool);
                    if let Some((_, _, of)) = &mut place.part {
                        *of = Some(*bit);
                    }
                }
                // An element without an index is the first one.
                (Step::Bit(_) | Step::Member(_), Ty::Array(_, sizes)) if sizes.len() == 1 => {
                    let path = &place.path;
                    return Err(format!("`{path}` is an array: say `{path}[0]`"));
                }
                (Step::ComputedBit(_), _) => {
                    return Err(format!("the bit of `{}` is computed", place.path));
                }
                _ => return Err(format!("`{}` has no such part", place.path)),
            }
        }
        Ok(place)
    }

    /// A parameter of an instance, seen from outside.
    fn parameter(&mut self, instance: program::Path, aoi: usize, name: &str) -> Result<Place, String> {
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
        let path = instance.clone().member(&own.name);
        match own.kind {
            Kind::Input | Kind::Output => Ok(Place {
                is_output: own.kind == Kind::Output,
                ..Place::of(path, own.ty.clone())
            }),
            _ => Err(format!(
                "`{instance}.{name}` is inside the instruction, and not seen from outside"
            )),
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
