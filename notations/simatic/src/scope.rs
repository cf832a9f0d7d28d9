//! What the names of a block are here.

use crate::model::{Kind, Role, Type, Unit};
use crate::standard::{elementary, state_type};
use ladder_format::program::Path;
use ladder_notation::Names;
use std::collections::{BTreeMap, HashMap};

/// Blocks, data blocks and types by their names in small letters.
pub(crate) type Library<'l> = HashMap<String, Result<&'l Unit, String>>;

/// A name that is known.
#[derive(Debug, Clone)]
pub(crate) struct Known {
    pub(crate) spelled: String,
    pub(crate) ty: Type,
    pub(crate) is_constant: bool,
}

impl Known {
    pub(crate) fn path(&self) -> Path {
        Path::tag(&self.spelled)
    }
}

/// The names of a block.
pub(crate) struct Scope<'l> {
    pub(crate) library: &'l Library<'l>,
    names: Names,
    own: HashMap<String, Known>,
    /// What is used of other parts of the project, by how it is written in full in small letters, and as it is written.
    pub(crate) globals: BTreeMap<String, (String, Known)>,
    /// What the source does not have: name, type, what it is for.
    pub(crate) helpers: Vec<(String, String, String)>,
}

impl<'l> Scope<'l> {
    pub(crate) fn of(unit: &Unit, library: &'l Library<'l>) -> Scope<'l> {
        let mut scope = Scope {
            library,
            names: Names::default(),
            own: HashMap::new(),
            globals: BTreeMap::new(),
            helpers: Vec::new(),
        };
        for variable in &unit.variables {
            let known = Known {
                spelled: scope.names.fresh(&variable.name),
                ty: variable.ty.clone(),
                is_constant: variable.role == Role::Constant,
            };
            scope.own.entry(variable.name.to_lowercase()).or_insert(known);
        }
        if let (Some(returns), Kind::Function) = (&unit.returns, unit.kind) {
            let known = Known {
                spelled: scope.names.fresh(&unit.name),
                ty: returns.clone(),
                is_constant: false,
            };
            for name in [unit.name.to_lowercase(), "ret_val".to_owned()] {
                scope.own.entry(name).or_insert_with(|| known.clone());
            }
        }
        scope
    }

    /// A variable of the block itself.
    pub(crate) fn own(&self, name: &str) -> Option<&Known> {
        self.own.get(&name.to_lowercase())
    }

    /// The names of all its tags.
    pub(crate) const fn names_mut(&mut self) -> &mut Names {
        &mut self.names
    }

    /// A tag that the source does not have.
    pub(crate) fn helper(&mut self, like: &str, ty: &str, what: &str) -> String {
        let name = self.names.fresh(like);
        self.helpers.push((name.clone(), ty.to_owned(), what.to_owned()));
        name
    }

    /// A tag of the project that this file does not declare, under the name that it is written by.
    pub(crate) fn global(&mut self, path: &str, ty: Type) -> Known {
        let is_constant = self.unit(path).is_some_and(|unit| unit.constant().is_some());
        let names = &mut self.names;
        let (_, known) = self.globals.entry(path.to_lowercase()).or_insert_with(|| {
            let known = Known {
                spelled: names.fresh(path),
                ty,
                is_constant,
            };
            (path.to_owned(), known)
        });
        known.clone()
    }

    /// A block, data block or type of the project.
    pub(crate) fn unit(&self, name: &str) -> Option<&'l Unit> {
        self.library.get(&name.to_lowercase())?.as_ref().ok().copied()
    }

    /// The members of a type.
    pub(crate) fn members(&self, ty: &Type) -> Option<&'l [crate::model::Variable]> {
        match ty {
            Type::Named(name) => {
                let unit = self.unit(name)?;
                matches!(unit.kind, Kind::Type | Kind::FunctionBlock).then_some(&unit.variables[..])
            }
            _ => None,
        }
    }
}

/// The type as it is here, if it is elementary or holds a state.
pub(crate) fn plain(ty: &Type) -> Option<&'static str> {
    match ty {
        Type::Named(name) => elementary(name).or_else(|| state_type(name)),
        Type::Text(_) => Some("STRING"),
        _ => None,
    }
}

/// The name of the block that another one is here.
pub(crate) fn block_name(name: &str) -> String {
    format!("${}", ladder_notation::block_name(name, "B"))
}

/// A member's name as it can be written here.
pub(crate) fn member(name: &str) -> String {
    Names::default().spell(name).to_owned()
}

/// Whether a value passes from one elementary type to another by itself.
pub(crate) fn passes(from: &str, to: &str) -> bool {
    if from == to {
        return true;
    }
    let chains: [&[&str]; 5] = [
        &["SINT", "INT", "DINT", "LINT"],
        &["USINT", "UINT", "UDINT", "ULINT"],
        &["USINT", "INT", "REAL", "LREAL"],
        &["UINT", "DINT", "LREAL"],
        &["BYTE", "WORD", "DWORD", "LWORD"],
    ];
    let rises = |chain: &[&str]| {
        let at = |ty| chain.iter().position(|own| *own == ty);
        matches!((at(from), at(to)), (Some(from), Some(to)) if from < to)
    };
    let widths: [&[&str]; 4] = [
        &["BYTE", "SINT", "USINT"],
        &["WORD", "INT", "UINT"],
        &["DWORD", "DINT", "UDINT"],
        &["LWORD", "LINT", "ULINT"],
    ];
    let is_bits = |ty: &str| matches!(ty, "BYTE" | "WORD" | "DWORD" | "LWORD");
    chains.into_iter().any(rises)
        || matches!(
            (from, to),
            ("UINT", "REAL") | ("SINT", "REAL" | "LREAL") | ("UDINT", "LINT" | "LREAL")
        )
        || widths
            .iter()
            .any(|same| same.contains(&from) && same.contains(&to) && (is_bits(from) || is_bits(to)))
}
