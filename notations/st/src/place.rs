//! Places: variables, elements, members, bits.

use crate::checks::{Check, Checks, is_within};
use crate::names;
use crate::project::{Result, Service};
use crate::term::{Binding, Term};
use crate::unit::Unit;
use ladder_analysis::program::{Argument, Chosen, Expr, ExprKind, Member, Place, SystemTag, TagId};
use ladder_analysis::values::types::{Scalar, Type};
use ladder_analysis::values::value::Value;

/// Where a value goes.
pub(crate) struct Target {
    /// The variable of the unit in which it lies.
    pub(crate) variable: String,
    text: String,
    form: Form,
    /// Whether the place is known only after what is checked before.
    pub(crate) is_risky: bool,
}

enum Form {
    Plain,
    Bit(Scalar, u8),
    As(Scalar, Scalar),
}

impl Target {
    /// An element that is checked.
    pub(crate) fn element(variable: String, text: String) -> Target {
        Target {
            variable,
            text,
            form: Form::Plain,
            is_risky: true,
        }
    }

    /// The statements that write a value there.
    pub(crate) fn assign(&self, value: &Term) -> Vec<String> {
        let to = &self.text;
        match self.form {
            Form::Plain => vec![format!("{to} := {};", value.text)],
            Form::As(stored, seen) => {
                vec![format!(
                    "{to} := {};",
                    Term::call(&conversion(seen, stored), &[value]).text
                )]
            }
            Form::Bit(ty, bit) => {
                let [set, clear] = [true, false].map(|high| bit_set(to, ty, bit, high));
                match value.text.as_str() {
                    "TRUE" => vec![set],
                    "FALSE" => vec![clear],
                    value => vec![
                        format!("IF {value} THEN"),
                        format!("    {set}"),
                        "ELSE".into(),
                        format!("    {clear}"),
                        "END_IF;".into(),
                    ],
                }
            }
        }
    }

    /// Its text, if it is a variable or part of one as it stands.
    pub(crate) fn plain(&self) -> Option<&str> {
        matches!(self.form, Form::Plain).then_some(&self.text)
    }

    /// Whether it is a variable, and no part of one.
    pub(crate) fn is_whole(&self) -> bool {
        matches!(self.form, Form::Plain) && self.text == self.variable
    }
}

/// The bit string of a width.
pub(crate) fn bits_of(ty: Scalar) -> Scalar {
    match ty.width() {
        8 => Scalar::Byte,
        16 => Scalar::Word,
        32 => Scalar::Dword,
        _ => Scalar::Lword,
    }
}

/// The standard's function from one type to another.
pub(crate) fn conversion(from: Scalar, to: Scalar) -> String {
    format!("{}_TO_{}", from.name(), to.name())
}

fn bit_set(to: &str, ty: Scalar, bit: u8, high: bool) -> String {
    let bits = bits_of(ty);
    let all = u64::MAX >> (64 - bits.width());
    let mask = 1u64 << bit;
    let (operator, mask) = if high { ("OR", mask) } else { ("AND", all & !mask) };
    if ty == bits {
        return format!("{to} := {to} {operator} 16#{mask:X};");
    }
    let value = format!("{}({to}) {operator} 16#{mask:X}", conversion(ty, bits));
    format!("{to} := {}({value});", conversion(bits, ty))
}

impl Unit<'_, '_> {
    /// The value of a place.
    pub(crate) fn read(&mut self, place: &Place, checks: &mut Checks) -> Result<Term> {
        match place {
            Place::System(SystemTag::On) => Ok(Term::whole("TRUE")),
            Place::System(SystemTag::Off) => Ok(Term::whole("FALSE")),
            Place::System(tag) => {
                let Some(service) = Service::of(*tag) else {
                    return self.stop("a system tag that Structured Text does not have");
                };
                let name = self.service(service);
                Ok(Term::variable(&name))
            }
            Place::Bit(inner, ty, bit) => {
                let word = self.read(inner, checks)?;
                let bits = bits_of(*ty);
                let word = if *ty == bits {
                    word
                } else {
                    Term::call(&conversion(*ty, bits), &[&word])
                };
                let mask = Term::whole(format!("16#{:X}", 1u64 << bit));
                let masked = Term::binary(&word, "AND", &mask, Binding::And);
                Ok(Term::binary(
                    &masked,
                    "<>",
                    &Term::whole("16#0"),
                    Binding::Equality,
                ))
            }
            Place::As(inner, stored, seen) => {
                let value = self.read(inner, checks)?;
                Ok(Term::call(&conversion(*stored, *seen), &[&value]))
            }
            Place::Member(tag, member) => {
                let (variable, text) = self.path(*tag, &[]);
                self.member(*tag, *member, variable, &text)
            }
            Place::ChosenMember(chosen, member) => {
                let tag = self.chosen(chosen)?;
                let (variable, text) = self.path(tag, &[]);
                self.member(tag, *member, variable, &text)
            }
            _ => {
                let target = self.place(place, checks)?;
                let mut term = Term::whole(target.text);
                term.reads.insert(target.variable);
                term.is_risky = target.is_risky;
                Ok(term)
            }
        }
    }

    /// A place that is written.
    pub(crate) fn place(&mut self, place: &Place, checks: &mut Checks) -> Result<Target> {
        let plain = |(variable, text), is_risky| Target {
            variable,
            text,
            form: Form::Plain,
            is_risky,
        };
        match place {
            Place::Tag(tag) => Ok(plain(self.path(*tag, &[]), false)),
            Place::Element(tag, index) => {
                let before = checks.len();
                let dimensions = self.dimensions(*tag);
                let indices = self.indices(index, &dimensions, checks)?;
                Ok(plain(self.path(*tag, &indices), checks.len() > before))
            }
            Place::Chosen(chosen) => Ok(plain(self.path(self.chosen(chosen)?, &[]), false)),
            Place::Bit(inner, ty, bit) => {
                let mut target = self.place(inner, checks)?;
                if !matches!(target.form, Form::Plain) {
                    return self.stop("a bit of a tag that another type of its address names");
                }
                target.form = Form::Bit(*ty, *bit);
                Ok(target)
            }
            Place::As(inner, stored, seen) => {
                let mut target = self.place(inner, checks)?;
                target.form = Form::As(*stored, *seen);
                Ok(target)
            }
            Place::Member(..) | Place::ChosenMember(..) | Place::System(_) => {
                self.stop("Structured Text does not write a member of a timer or counter")
            }
        }
    }

    /// The tag that indices choose of timers, counters, bistables or blocks, or in them.
    fn chosen(&self, chosen: &Chosen) -> Result<TagId> {
        match self.project.chosen(chosen) {
            Some(tag) => Ok(tag),
            None => self.stop(
                "a timer, counter or block that a computed index chooses, as compilers that are built on matiec have no arrays of them: \
                 give each element a network with its index",
            ),
        }
    }

    /// The tag of a timer, counter, bistable or block.
    pub(crate) fn state_tag(&self, argument: &Argument) -> Result<TagId> {
        match argument {
            Argument::State(tag) => Ok(*tag),
            Argument::ChosenState(chosen) => self.chosen(chosen),
            _ => self.stop("a block whose state is no tag"),
        }
    }

    fn dimensions(&self, tag: TagId) -> Vec<(i64, i64)> {
        let tag = &self.project.source.program.tags[tag.0 as usize];
        match (&tag.column, tag.ty) {
            (Some(column), _) if !column.dimensions.is_empty() => column.dimensions.to_vec(),
            (_, Type::Array { first, last, .. }) => vec![(first, last)],
            _ => Vec::new(),
        }
    }

    /// The indices of an element of an array.
    fn indices(
        &mut self,
        index: &Expr,
        dimensions: &[(i64, i64)],
        checks: &mut Checks,
    ) -> Result<Vec<String>> {
        match &index.kind {
            ExprKind::Constant(Value::Int(number)) => Ok(indices_of(*number, dimensions)),
            ExprKind::Offset(subscripts) => {
                let mut all = Vec::new();
                for subscript in subscripts {
                    all.push(self.index(&subscript.index, subscript.first, subscript.last, checks)?);
                }
                Ok(all)
            }
            _ => {
                let &[(first, last)] = dimensions else {
                    return self.stop("an index over several dimensions");
                };
                Ok(vec![self.index(index, first, last, checks)?])
            }
        }
    }

    /// One index, which must lie between these.
    pub(crate) fn index(
        &mut self,
        index: &Expr,
        first: i64,
        last: i64,
        checks: &mut Checks,
    ) -> Result<String> {
        let term = self.value(index, checks)?;
        if let ExprKind::Constant(Value::Int(number)) = index.kind
            && (first..=last).contains(&number)
        {
            return Ok(term.text);
        }
        let term = if self.rungs.holds_indices {
            self.held(&term, index.ty, checks)
        } else {
            self.named(term, index.ty, checks)
        };
        if let Some(holds) = is_within(&term, first.into(), last.into(), index.ty) {
            checks.push(Check::Holds(holds));
        }
        Ok(term.text)
    }

    /// The variable that a tag lies in, and the path from there. Where the name of the tag has places for indices these go there,
    /// else over those that it has.
    pub(crate) fn path(&mut self, tag: TagId, indices: &[String]) -> (String, String) {
        let variable = self.variable(tag);
        let tag_of = &self.project.source.program.tags[tag.0 as usize];
        let name = tag_of.name.as_str();
        let root = self.project.root(tag);
        let rest = &name[root.len()..];
        let mut text = variable.clone();
        let mut ty = self.project.declared_type(tag_of.block, root);
        let mut indices = indices.iter();
        let mut open = rest;
        while let Some(c) = open.chars().next() {
            if c == '[' {
                let mut all = Vec::new();
                while let Some(inside) = open.strip_prefix('[') {
                    let (inside, after) = inside.split_once(']').unwrap_or((inside, ""));
                    for own in inside.split(',') {
                        all.push(indices.next().cloned().unwrap_or_else(|| own.trim().to_owned()));
                    }
                    open = after;
                }
                ty = index_list(&all, ty, &mut text);
            } else {
                let end = open[1..].find(['.', '[']).map_or(open.len(), |at| at + 1);
                let member = open[..end].trim_start_matches('.');
                ty = ty.and_then(|ty| self.project.member_type(ty, member));
                text.push('.');
                text.push_str(&names::member(member));
                open = &open[end..];
            }
        }
        let more: Vec<String> = indices.cloned().collect();
        index_list(&more, ty, &mut text);
        (variable, text)
    }

    fn member(&mut self, tag: TagId, member: Member, variable: String, text: &str) -> Result<Term> {
        let Type::State(state) = self.project.source.program.tags[tag.0 as usize].ty else {
            return self.stop("a member of something that has none");
        };
        let of = |name: &str| {
            let mut term = Term::whole(format!("{text}.{name}"));
            term.reads.insert(variable.clone());
            term
        };
        let standard = self.project.is_standard(state, tag);
        Ok(match member {
            Member::In | Member::Cu if standard => of("IN"),
            Member::In | Member::Cu if state.is_timer() => of("RUNS"),
            Member::In | Member::Cu => of("CU"),
            Member::Pt => of("PT"),
            Member::Q => of("Q"),
            Member::Et => of("ET"),
            Member::Cd => of("CD"),
            Member::R => of("R"),
            Member::Ld => of("LD_IN"),
            Member::Pv => of("PV"),
            Member::Cv => of("CV"),
            Member::Qu if state.is_counter() => of("Q"),
            Member::Qu => of("QU"),
            Member::Qd => of("QD"),
            Member::Q1 => of("Q1"),
            Member::Changed => of("CHANGED"),
            Member::Timing => {
                let runs = of(if standard { "IN" } else { "RUNS" });
                Term::binary(&runs, "AND", &of("Q").not(), Binding::And)
            }
        })
    }
}

/// Adds indices to a path, those of an array that is an element of another in brackets of their own. What the element is.
fn index_list(indices: &[String], mut ty: Option<Type>, path: &mut String) -> Option<Type> {
    let mut rest = indices;
    while !rest.is_empty() {
        let array = ty.and_then(Type::array);
        let own = array
            .as_ref()
            .map_or(rest.len(), |(dimensions, _)| dimensions.len());
        let (list, more) = rest.split_at(own.min(rest.len()));
        path.push_str(&format!("[{}]", list.join(", ")));
        ty = array.map(|(_, element)| element);
        rest = more;
    }
    ty
}

/// Indices from the place of an element: counted from 0 row by row where there are several dimensions.
pub(crate) fn indices_of(number: i64, dimensions: &[(i64, i64)]) -> Vec<String> {
    if dimensions.len() <= 1 {
        return vec![number.to_string()];
    }
    let mut rest = number;
    let mut all: Vec<String> = Vec::new();
    for (first, last) in dimensions.iter().rev() {
        let count = last - first + 1;
        all.push((first + rest.rem_euclid(count)).to_string());
        rest = rest.div_euclid(count);
    }
    all.reverse();
    all
}
