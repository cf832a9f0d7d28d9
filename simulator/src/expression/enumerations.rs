//! The enumerations whose values an expression may name: those of the program's tags.

use ladder_analysis::program::Program;
use ladder_analysis::values::compound::Enumeration;
use ladder_analysis::values::types::Scalar;
use ladder_syntax::Name;
use std::collections::HashSet;
use std::sync::Arc;

/// Each once, in the order of the tags. Two of one name cannot be told apart in a text: the first counts.
pub(super) fn of_program(program: &Program) -> Vec<Arc<Enumeration>> {
    let (mut seen, mut names) = (HashSet::new(), HashSet::new());
    let scalars = program.tags.iter().filter_map(|tag| tag.ty.element_scalar());
    let numbers = scalars.filter_map(|scalar| match scalar {
        Scalar::Enum(number) if seen.insert(number) => Some(number.get()),
        _ => None,
    });
    numbers
        .filter(|enumeration| names.insert(Name::new(&enumeration.name)))
        .collect()
}

/// The one that a text names a value of: `Phase.IDLE`, or `IDLE` alone.
pub(super) fn with_value<'e>(all: &'e [Arc<Enumeration>], text: &str) -> Option<&'e Enumeration> {
    let (ty, value) = match text.split_once('.') {
        Some((ty, value)) => (Some(Name::new(ty)), value),
        None => (None, text),
    };
    let mut of_type = all
        .iter()
        .filter(|of| ty.as_ref().is_none_or(|ty| Name::new(&of.name) == *ty));
    of_type.find(|of| of.number(value).is_some()).map(|of| &**of)
}

/// That a type has no such value, where a text names one: `Phase.DILE`.
pub(super) fn no_value(all: &[Arc<Enumeration>], text: &str) -> Option<String> {
    let (ty, value) = text.split_once('.')?;
    let ty = Name::new(ty);
    let of = all.iter().find(|of| Name::new(&of.name) == ty)?;
    let names: Vec<&str> = of.values.iter().map(|(name, _)| name.as_str()).collect();
    Some(format!(
        "{} has no value `{value}`: its values are {}",
        of.name,
        names.join(" ")
    ))
}

/// That nothing asks for a value where a text names one.
pub(super) fn not_asked_for(all: &[Arc<Enumeration>], text: &str) -> Option<String> {
    let of = &with_value(all, text)?.name;
    let value = text.rsplit('.').next().unwrap_or(text);
    Some(format!(
        "`{text}` is a value of {of}, and nothing here asks for one; compare a tag with it, as in: tag = {of}.{value}"
    ))
}

/// The section that declares them.
pub(super) fn declaration(all: &[Arc<Enumeration>]) -> String {
    if all.is_empty() {
        return String::new();
    }
    let lines = all.iter().map(|of| {
        let values = of
            .values
            .iter()
            .map(|(name, number)| format!("{name} := {number}"));
        let values: Vec<String> = values.collect();
        format!("{} : ({});\n", of.name, values.join(", "))
    });
    format!("TYPE\n{}END_TYPE\n", lines.collect::<String>())
}
