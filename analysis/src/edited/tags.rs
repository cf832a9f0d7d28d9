//! The tags that an edit concerns.

use crate::company;
use crate::context::Context;
use crate::infer::Entry;
use crate::types::Type;
use ladder_syntax::Name;
use smol_str::SmolStr;

/// The tags that an edit concerns.
#[derive(Default)]
pub(crate) struct EditedTags {
    /// Those that are used at other places, or declared at others.
    pub(crate) used: Vec<(usize, Name)>,
    /// Those that have another type or spelling.
    pub(crate) retyped: Vec<(usize, Name)>,
}

impl EditedTags {
    /// Another tag of the file has this name now.
    pub(crate) fn touched(&mut self, name: &Name) {
        self.used.push((0, name.clone()));
        self.retyped.push((0, name.clone()));
    }

    /// What is said of an undeclared tag of a body depends on whether the program has one of its name.
    pub(super) fn namesakes_in_bodies(&mut self, context: &Context) {
        let of_file = self.used.iter().filter(|(scope, _)| *scope == 0);
        let named = of_file.filter(|(_, name)| context.named_in_bodies.contains(name));
        let bodies = named.flat_map(|(_, name)| (1..context.scopes.len()).map(|scope| (scope, name.clone())));
        let there: Vec<(usize, Name)> = bodies.filter(|key| context.find_tag(key).is_some()).collect();
        self.used.extend(there);
    }

    /// Infers the types that depend on places. `before`: tags with their spelling and type before the edit, which may be gone;
    /// `fresh`: tags that have come. None if they concern too many others.
    pub(crate) fn infer_again(
        &mut self,
        context: &mut Context,
        before: &[(usize, SmolStr, Option<Type>)],
        fresh: Vec<(usize, Name)>,
    ) -> Option<()> {
        let others = |context: &Context| -> Vec<(usize, Name)> {
            let named = before
                .iter()
                .map(|(scope, spelled, ty)| ((*scope, Name::new(spelled)), spelled, *ty));
            let is_other = |(key, spelled, ty): &((usize, Name), &SmolStr, Option<Type>)| {
                let tag = context.find_tag(key);
                tag.is_none_or(|tag| tag.ty != *ty || tag.name != **spelled)
            };
            named.filter(is_other).map(|(key, ..)| key).collect()
        };
        let changed = others(context).into_iter().chain(fresh);
        let changed = changed.filter_map(|(scope, name)| Some((scope, context.scopes[scope].find(&name)?)));
        let changed: Vec<Entry> = changed.collect();
        for (scope, tag) in company::infer_again(context, &changed)? {
            let name = Name::new(&context.scopes[scope].tags[tag].name);
            self.used.push((scope, name.clone()));
            self.retyped.push((scope, name));
        }
        self.retyped.extend(others(context));
        Some(())
    }
}
