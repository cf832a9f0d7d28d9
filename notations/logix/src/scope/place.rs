//! Where a path leads: `cells[i].level.3`, an alias, a tag of another program, an input that the file does not declare.

use super::{Entry, Kind, Tags};
use crate::mnemonic::Role;
use crate::operand::{Expr, Path, Step};
use crate::types::{Elem, Ty};

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

impl Tags {
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
            let key = tag.to_ascii_uppercase();
            if let Some(Entry::Symbol(symbol)) = self.scopes[other].entries.get(&key) {
                self.symbols[*symbol].shared |= other != scope;
            }
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
                    place = self.parameter(place.text.clone(), *aoi, name)?;
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
                                number
                                    .checked_mul(*size as usize)
                                    .and_then(|row| row.checked_add(*index as usize))
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
