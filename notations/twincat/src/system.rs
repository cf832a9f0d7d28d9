//! Types that the libraries of every TwinCAT project declare (Tc2_System, as the library's manual has them).

use ladder_notation::LineColumn;
use ladder_notation_plcopen::declarations::type_of;
use ladder_notation_plcopen::model::{Project, Role, Type, TypeDeclaration, Variable};

/// Other names of types.
const ALIASES: [(&str, &str); 6] = [
    ("T_MaxString", "STRING(255)"),
    ("T_AmsNetId", "STRING(23)"),
    ("T_AmsPort", "UINT"),
    ("T_IPv4Addr", "STRING(15)"),
    ("T_AmsNetIdArr", "ARRAY[0..5] OF BYTE"),
    ("T_IPv4AddrArr", "ARRAY[0..3] OF BYTE"),
];

/// The date and the time of day.
const TIME_STRUCT: [&str; 8] = [
    "wYear",
    "wMonth",
    "wDayOfWeek",
    "wDay",
    "wHour",
    "wMinute",
    "wSecond",
    "wMilliseconds",
];

/// Declares those of the types that a project names and does not declare.
pub(crate) fn types(project: &mut Project, text: &str) {
    let aliases = ALIASES.iter().map(|(name, ty)| (*name, type_of(ty)));
    let members = TIME_STRUCT.map(|name| variable(name, "WORD"));
    let structure = ("TIMESTRUCT", Type::Structure(members.into()));
    for (name, ty) in aliases.chain([structure]) {
        let is_declared = (project.types.iter()).any(|declared| declared.name.eq_ignore_ascii_case(name));
        if !is_declared && is_named(project, text, name) {
            project.types.push(TypeDeclaration {
                place: LineColumn::START,
                name: name.to_owned(),
                ty,
                initial: None,
                comment: Some("of the system's library".to_owned()),
            });
        }
    }
}

fn is_named(project: &Project, text: &str, name: &str) -> bool {
    let is_word = |word: &str| word.eq_ignore_ascii_case(name);
    let mut words = text.split(|c: char| !(c.is_alphanumeric() || c == '_'));
    let of_units = project.units.iter().flat_map(|unit| &unit.variables);
    let of_types = project.types.iter().filter_map(|declared| match &declared.ty {
        Type::Structure(members) => Some(members),
        _ => None,
    });
    let all = project.globals.iter().chain(of_units).chain(of_types.flatten());
    words.any(is_word) || all.into_iter().any(|variable| is_of(&variable.ty, name))
}

fn is_of(ty: &Type, name: &str) -> bool {
    match ty {
        Type::Named(named) => named.eq_ignore_ascii_case(name),
        Type::Array(_, of) => is_of(of, name),
        _ => false,
    }
}

fn variable(name: &str, ty: &str) -> Variable {
    Variable {
        place: LineColumn::START,
        name: name.to_owned(),
        role: Role::Local,
        qualifier: None,
        address: None,
        ty: type_of(ty),
        initial: None,
        comment: None,
    }
}
