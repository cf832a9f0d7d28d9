//! Definitions of blocks as Add-On Instructions.

use super::data::Comments;
use super::native::Known;
use super::{Scope, Writer};
use crate::model::{Aoi, Routine, Rung, Tag, Usage};
use ladder_analysis::names::scope::Origin;
use ladder_syntax::Name;
use std::collections::HashMap;

impl Writer<'_> {
    /// Keeps the comment above a definition.
    pub(super) fn described(&mut self, body: usize, waiting: &mut Vec<String>) {
        let told = std::mem::take(waiting).join("\n");
        self.data.body_comments.insert(body, told);
    }

    /// A name that a definition sees.
    ///
    /// # Errors
    ///
    /// If it is a tag of the program, or one that cannot be declared there.
    pub(super) fn visible(&mut self, name: &str) -> super::Result<()> {
        let scopes = &self.input.analysis.context.scopes;
        let scope = scopes.iter().find(|scope| scope.block == self.scope.body);
        let tag = scope.and_then(|scope| scope.tags.get(scope.find(&Name::new(name))?));
        let Some(tag) = tag else { return Ok(()) };
        if tag.is_alias() || tag.origin == Origin::Shared {
            return match self.scope.body {
                Some(_) => Err(format!(
                    "an Add-On Instruction does not see the tag `{name}` of the program"
                )),
                None => Ok(()),
            };
        }
        match tag.ty.map(|ty| self.ty(ty)) {
            Some(Err(why)) => Err(format!("`{name}` cannot be declared: {why}")),
            _ => Ok(()),
        }
    }

    /// The Add-On Instructions, those that others use first.
    pub(super) fn definitions(
        &mut self,
        bodies: &mut HashMap<usize, Vec<Rung>>,
        locals: &mut HashMap<usize, Scope>,
        told: &Comments,
    ) -> Vec<Aoi> {
        let mut users: Vec<usize> = self.facts.body_of.keys().copied().collect();
        users.sort_by_key(|user| self.facts.body_of[user]);
        let mut out = Vec::new();
        for user in users {
            let Some(Known::Own(name)) = self.facts.known.get(&user).cloned() else {
                continue;
            };
            let body = self.facts.body_of[&user];
            let rungs = bodies.remove(&body).unwrap_or_default();
            let local = locals.remove(&body).unwrap_or_default();
            let first = self.first_scan_rung(&local.first_scan);
            let aoi = self.definition(user, body, name, rungs, first, local.made, told);
            out.push(aoi);
        }
        out
    }

    #[allow(clippy::too_many_arguments)]
    fn definition(
        &mut self,
        user: usize,
        body: usize,
        name: String,
        rungs: Vec<Rung>,
        first: Option<Rung>,
        made: Vec<Tag>,
        told: &Comments,
    ) -> Aoi {
        let block = self.input.program.blocks[user].name.clone();
        let analysis = self.input.analysis;
        let scope = analysis
            .context
            .scopes
            .iter()
            .find(|scope| scope.block == Some(body));
        self.scope.body = Some(body);
        let tags = scope
            .map(|scope| self.tags(scope, &block, told))
            .unwrap_or_default();
        self.scope.body = None;
        let program = self.input.program;
        let mut required = Vec::new();
        for (parameter, (tag, _)) in program.blocks[user].parameters.iter().enumerate() {
            if self.is_given(user, parameter) {
                let own = &program.tags[tag.0 as usize].name;
                let own = own.rsplit_once('.').map_or(own.as_str(), |(_, own)| own);
                self.scope.body = Some(body);
                required.push(self.root(own));
                self.scope.body = None;
            }
        }
        let system = |name: &str, usage: Usage| Tag {
            name: name.to_owned(),
            ty: "BOOL".to_owned(),
            usage,
            ..Tag::default()
        };
        let mut parameters = vec![
            system("EnableIn", Usage::Input),
            system("EnableOut", Usage::Output),
        ];
        let mut locals = Vec::new();
        for (_, mut tag) in tags {
            tag.required = required.contains(&tag.name) && tag.usage != Usage::Local;
            if tag.usage == Usage::Local {
                locals.push(tag);
            } else {
                parameters.push(tag);
            }
        }
        locals.extend(made);
        let comment = self
            .data
            .body_comments
            .get(&body)
            .filter(|told| !told.is_empty())
            .cloned();
        let comment = comment.map(|told| match told.strip_prefix("Add-On Instruction ") {
            Some(rest) => rest
                .split_once('\n')
                .map_or("", |(_, told)| told)
                .trim()
                .to_owned(),
            None => told,
        });
        let mut routines = routines(rungs, first);
        for routine in &mut routines {
            let rungs = std::mem::take(&mut routine.rungs);
            (routine.rungs, routine.foreign) = self.in_one_language(rungs);
        }
        Aoi {
            name,
            parameters,
            locals,
            routines,
            comment: comment.filter(|told| !told.is_empty()),
            ..Aoi::default()
        }
    }
}

/// The routines of a definition: what runs with live power and with dead power. A body runs with either, unless it begins
/// as the reader writes it.
fn routines(mut rungs: Vec<Rung>, first: Option<Rung>) -> Vec<Routine> {
    let routine = |name: &str, rungs: Vec<Rung>| Routine {
        name: name.to_owned(),
        rungs,
        ..Routine::default()
    };
    let text = |at: usize| rungs.get(at).map(|rung| rung.text.as_str());
    let with_first = |mut rungs: Vec<Rung>| {
        if let Some(first) = &first {
            rungs.insert(0, first.clone());
        }
        rungs
    };
    if text(0) == Some("XIO(EnableIn)TND();") {
        rungs.remove(0);
        return vec![routine("Logic", with_first(rungs))];
    }
    let label = text(0).and_then(|text| text.strip_prefix("XIC(EnableIn)JMP(")?.strip_suffix(");"));
    if let Some(label) = label {
        let begin = format!("LBL({label});");
        let end = (1..rungs.len()).find(|at| text(*at) == Some("TND();") && text(at + 1) == Some(&begin));
        if let Some(end) = end {
            let logic = rungs.split_off(end + 2);
            rungs.truncate(end);
            rungs.remove(0);
            return vec![
                routine("EnableInFalse", with_first(rungs)),
                routine("Logic", with_first(logic)),
            ];
        }
    }
    let rungs = with_first(rungs);
    vec![routine("EnableInFalse", rungs.clone()), routine("Logic", rungs)]
}
