//! Inputs of instances that begin with another value than their Add-On Instruction has for them.

use super::{Entry, Kind, Tags};
use crate::model::{Project, Raw, Tag};
use crate::types::{Elem, Ty};
use crate::values::Value;
use ladder_format::program::Path;

/// An input of an instance that begins with a value of its own.
#[derive(Debug, Clone)]
pub(crate) struct Begins {
    /// The tag that is the instance, or that it is in.
    pub(crate) symbol: usize,
    pub(crate) input: Path,
    pub(crate) elem: Elem,
    pub(crate) value: Value,
}

impl Tags {
    /// Notes the inputs of all instances. It goes through the tags when all of them are declared.
    pub(super) fn note_begins(&mut self, project: &Project) {
        if project.aois.is_empty() {
            return;
        }
        let scopes = std::iter::once(&project.tags)
            .chain(project.programs.iter().map(|program| &program.tags))
            .chain(project.aois.iter().map(|aoi| &aoi.locals));
        for (scope, tags) in scopes.enumerate() {
            for tag in tags {
                self.note_begins_of(scope, tag);
            }
        }
    }

    fn note_begins_of(&mut self, scope: usize, tag: &Tag) {
        let entry = self.scopes[scope].entries.get(&tag.name.to_ascii_uppercase());
        if let (Some(Entry::Symbol(symbol)), Some(raw)) = (entry, &tag.value) {
            let own = &self.symbols[*symbol];
            let mut begins = Vec::new();
            self.inputs_in(*symbol, &Path::tag(&own.name), &own.ty, raw, &mut begins);
            self.begins.append(&mut begins);
        }
    }

    fn inputs_in(&self, symbol: usize, path: &Path, ty: &Ty, raw: &Raw, out: &mut Vec<Begins>) {
        match (ty, raw) {
            (Ty::Aoi(aoi), Raw::Structure(_, members)) => {
                let scope = self.scopes.len() - self.aois() + aoi;
                for (name, raw) in members {
                    let Some(parameter) = self.parameter_symbol(scope, name) else {
                        continue;
                    };
                    let parameter = &self.symbols[parameter];
                    let value = Value::of(raw, &parameter.ty, &self.types);
                    if let Ty::Elem(elem) = parameter.ty
                        && parameter.kind == Kind::Input
                        && !parameter.required
                        && value != parameter.value
                    {
                        out.push(Begins {
                            symbol,
                            input: path.clone().member(&parameter.name),
                            elem,
                            value: value.unwrap_or(Value::Int(0)),
                        });
                    }
                }
            }
            (Ty::Structure(index), Raw::Structure(_, members)) => {
                for (name, raw) in members {
                    if let Some((_, field)) = self.types.member(*index, name) {
                        let path = path.clone().member(&field.name);
                        self.inputs_in(symbol, &path, &field.ty, raw, out);
                    }
                }
            }
            (Ty::Array(of, sizes), Raw::Array(_, _, elements)) if !matches!(**of, Ty::Elem(_)) => {
                for (number, raw) in elements.iter().enumerate() {
                    let path = path.clone().index(indices(number, sizes));
                    self.inputs_in(symbol, &path, of, raw, out);
                }
            }
            _ => {}
        }
    }
}

/// The indices of an element by its number, row by row.
fn indices(number: usize, sizes: &[u32]) -> Vec<i64> {
    let mut left = number;
    let mut indices: Vec<i64> = Vec::new();
    for size in sizes.iter().rev() {
        let size = (*size).max(1) as usize;
        indices.push((left % size) as i64);
        left /= size;
    }
    indices.reverse();
    indices
}
