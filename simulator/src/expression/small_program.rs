//! The small program that computes an expression over tags, while it is written.

use super::elements::Elements;
use super::enumerations;
use super::past::{Past, PastKind};
use super::{Expression, Kind, Problem, Scope, Source};
use crate::simulation::{Options, Simulation};
use crate::tags::Point;
use ladder_analysis::analyze;
use ladder_analysis::program::{Program, Tag, element_name};
use ladder_analysis::values::compound::Enumeration;
use ladder_analysis::values::types::Scalar;
use ladder_instructions::Profile;
use ladder_syntax::{SyntaxKind, SyntaxNode, TextRange, TextSize, parse};
use std::ops::Range;
use std::sync::Arc;

/// What is before the expression in the small program.
const BEFORE: &str = "+--[CALC]( result, ";
const AFTER: &str = " )--+\n";
/// What the names of its tags begin with.
const OPERAND: &str = "operand_";

/// Where the expression ends that a text begins with: what comes after it may be anything.
pub(crate) fn expression_end(text: &str) -> Option<usize> {
    let whole = format!("{BEFORE}{text}{AFTER}");
    let tree = parse(&whole).syntax();
    let list = tree
        .descendants()
        .find(|node| node.kind() == SyntaxKind::OPERAND_LIST)?;
    let range = list.children().nth(1)?.text_range();
    let end = usize::from(range.end()).checked_sub(BEFORE.len())?;
    let is_first = text[..text.len().min(end)].trim_start().len() == usize::from(range.len());
    (is_first && end <= text.len()).then_some(end)
}

/// Where an expression names something: whole paths such as `cell[2].valve.open` or `$Ramp#2.level`, and what is named within
/// their indices. In the order of the text.
pub fn names(text: &str) -> Vec<Range<usize>> {
    let (plain, mut found) = places_replaced(text);
    let whole = format!("{BEFORE}{plain}{AFTER}");
    let tree = parse(&whole).syntax();
    let list = tree
        .descendants()
        .find(|node| node.kind() == SyntaxKind::OPERAND_LIST);
    if let Some(expression) = list.and_then(|list| list.children().nth(1)) {
        add_names(&expression, &mut found);
    }
    found.retain(|range| range.end <= text.len());
    found.sort_by_key(|range| (range.start, range.end));
    found.dedup_by_key(|range| range.start);
    found
}

/// The expression with a plain name of the same length for each place of a user-defined block, and where these are.
fn places_replaced(text: &str) -> (String, Vec<Range<usize>>) {
    let mut plain = String::with_capacity(text.len());
    let mut places = Vec::new();
    let mut quoted = false;
    let mut rest = text;
    while let Some(next) = rest.chars().next() {
        quoted ^= next == '\'';
        let is_part = |c: char| c.is_alphanumeric() || matches!(c, '_' | '#' | '.' | '$');
        let length = match next {
            '$' if !quoted => rest.find(|c| !is_part(c)).unwrap_or(rest.len()),
            _ => 0,
        };
        if length > 0 {
            let start = plain.len();
            plain.extend(std::iter::repeat_n('x', length));
            places.push(start..start + length);
            rest = &rest[length..];
        } else {
            plain.push(next);
            rest = &rest[next.len_utf8()..];
        }
    }
    (plain, places)
}

fn add_names(node: &SyntaxNode, found: &mut Vec<Range<usize>>) {
    use SyntaxKind::{ADDRESS_EXPR, CALL_EXPR, INDEX_EXPR, MEMBER_EXPR, NAME_EXPR};
    match node.kind() {
        NAME_EXPR | MEMBER_EXPR | INDEX_EXPR | ADDRESS_EXPR => {
            let range = node.text_range();
            let at = |place: TextSize| usize::from(place).checked_sub(BEFORE.len());
            if let (Some(start), Some(end)) = (at(range.start()), at(range.end())) {
                found.push(start..end);
            }
            let is_index = |node: &SyntaxNode| node.kind() == INDEX_EXPR;
            let indexed = node.descendants().filter(is_index);
            for index in indexed.flat_map(|indexed| indexed.children().skip(1)) {
                add_names(&index, found);
            }
        }
        // The first part is the function's name.
        CALL_EXPR => node.children().skip(1).for_each(|part| add_names(&part, found)),
        _ => node.children().for_each(|child| add_names(&child, found)),
    }
}

/// The small program while it is written.
pub(super) struct Small<'s> {
    scope: Scope<'s>,
    /// The expression with the names of the small program.
    expression: String,
    declarations: String,
    inputs: Vec<(Source, String)>,
    /// How many tags it has.
    tags: usize,
    /// The types that the result may have, the likelier first.
    types: Vec<Scalar>,
    /// Whether it may name the past.
    with_past: bool,
    /// The names of its tags, and what stands for them in the expression.
    names: Vec<(String, String)>,
    /// Those of the program, where the expression may need them.
    enumerations: Option<Vec<Arc<Enumeration>>>,
}

impl<'s> Small<'s> {
    pub(super) fn of(text: &str, scope: Scope<'s>, with_past: bool) -> Result<Small<'s>, Problem> {
        let mut small = Small {
            scope,
            expression: String::new(),
            declarations: String::new(),
            inputs: Vec::new(),
            tags: 0,
            types: vec![Scalar::Bool],
            with_past,
            names: Vec::new(),
            enumerations: None,
        };
        let text = small.without_instances(text)?;
        let whole = format!("{BEFORE}{text}{AFTER}");
        let tree = parse(&whole).syntax();
        let range = TextRange::at(TextSize::of(BEFORE), TextSize::of(text.as_str()));
        let is_list = |node: &SyntaxNode| node.kind() == SyntaxKind::OPERAND_LIST;
        let list = tree.descendants().find(is_list);
        let operands: Vec<SyntaxNode> = list.map_or(Vec::new(), |list| list.children().collect());
        let [_, expression] = &*operands else {
            return Err(format!("`{text}` is not an expression"));
        };
        if expression.text_range() != range {
            return Err(format!("`{text}` is not an expression"));
        }
        let mut replaced = Vec::new();
        small.names_in(expression, &mut replaced)?;
        if replaced.is_empty()
            && let Some(all) = small.enumerations.as_deref()
            && let Some(problem) = enumerations::not_asked_for(all, &text)
        {
            return Err(problem);
        }
        let mut rewritten = String::new();
        let mut at = range.start();
        for (place, name) in replaced {
            rewritten.push_str(&whole[TextRange::new(at, place.start())]);
            rewritten.push_str(&name);
            at = place.end();
        }
        rewritten.push_str(&whole[TextRange::new(at, range.end())]);
        small.expression = rewritten;
        for ty in [
            Scalar::Lint,
            Scalar::Lreal,
            Scalar::Lword,
            Scalar::Time,
            Scalar::String(254),
            Scalar::Dt,
            Scalar::Date,
            Scalar::Tod,
        ] {
            if !small.types.contains(&ty) {
                small.types.push(ty);
            }
        }
        Ok(small)
    }

    /// Names of places of user-defined blocks are not names of the grammar: `$RAMP#2.level` becomes a tag at once.
    fn without_instances(&mut self, text: &str) -> Result<String, Problem> {
        let mut left = String::new();
        let mut rest = text;
        while let Some(at) = rest.find('$') {
            // In a text between quotes it escapes.
            if left.matches('\'').count() % 2 + rest[..at].matches('\'').count() % 2 == 1 {
                left.push_str(&rest[..=at]);
                rest = &rest[at + 1..];
                continue;
            }
            left.push_str(&rest[..at]);
            rest = &rest[at..];
            let is_part = |c: char| c.is_alphanumeric() || matches!(c, '_' | '#' | '.' | '$');
            let end = rest.find(|c| !is_part(c)).unwrap_or(rest.len());
            let point = self.scope.simulation.resolve(&rest[..end]);
            let point = point.map_err(|unknown| unknown.message)?;
            let name = self.scalar(point);
            left.push_str(&name);
            rest = &rest[end..];
        }
        left.push_str(rest);
        // One line: what is after a line end would be another.
        Ok(left.replace(['\r', '\n'], " "))
    }

    /// What an expression names.
    fn names_in(
        &mut self,
        node: &SyntaxNode,
        replaced: &mut Vec<(TextRange, String)>,
    ) -> Result<(), Problem> {
        use SyntaxKind::{ADDRESS_EXPR, CALL_EXPR, INDEX_EXPR, MEMBER_EXPR, NAME_EXPR};
        match node.kind() {
            NAME_EXPR | MEMBER_EXPR | INDEX_EXPR | ADDRESS_EXPR => {
                let text: String = node.text().to_string().split_whitespace().collect();
                let is_own = self.names.iter().any(|(name, _)| *name == text);
                if is_own || text.eq_ignore_ascii_case("PI") {
                    return Ok(());
                }
                match self.scope.resolve(&text) {
                    Ok(point) => {
                        let name = self.scalar(point);
                        replaced.push((node.text_range(), name));
                        Ok(())
                    }
                    Err(problem) => {
                        let is_known = enumerations::with_value(self.enumerations(), &text).is_some();
                        if is_known || self.elements(node, replaced)? {
                            return Ok(());
                        }
                        Err(enumerations::no_value(self.enumerations(), &text).unwrap_or(problem))
                    }
                }
            }
            CALL_EXPR if self.with_past && past_of(node).is_some() => {
                let name = self.past(node)?;
                replaced.push((node.text_range(), name));
                Ok(())
            }
            CALL_EXPR => {
                // The first part is the function's name.
                for argument in node.children().skip(1) {
                    self.names_in(&argument, replaced)?;
                }
                Ok(())
            }
            _ => {
                for child in node.children() {
                    self.names_in(&child, replaced)?;
                }
                Ok(())
            }
        }
    }

    /// What another expression was.
    fn past(&mut self, node: &SyntaxNode) -> Result<String, Problem> {
        let text = node.text().to_string();
        let Some((kind, Some(of))) = past_of(node) else {
            return Err(format!("`{text}` takes one expression, as in: was(level > 5)"));
        };
        let of = of.text().to_string();
        let inner = match kind {
            PastKind::Was => Expression::of_type(&of, self.scope, None)?,
            PastKind::Rises | PastKind::Falls => Expression::condition(&of, self.scope.simulation)?,
        };
        let past = Past::new(kind, inner);
        let name = self.name(&text, past.ty());
        self.declarations.push_str(&format!("{name} : {};\n", past.ty()));
        self.inputs.push((Source::Past(Box::new(past)), name.clone()));
        Ok(name)
    }

    /// Parts of an array with an index that is computed, or with a range. False: the path names none.
    fn elements(
        &mut self,
        node: &SyntaxNode,
        replaced: &mut Vec<(TextRange, String)>,
    ) -> Result<bool, Problem> {
        let Some(elements) = Elements::of(node, self.scope)? else {
            return Ok(false);
        };
        let Some(ty) = elements.points.first().map(|point| point.ty) else {
            return Ok(false);
        };
        let name = self.name(&elements.name, ty);
        let dimensions = &elements.dimensions;
        let bounds = dimensions.iter().map(|(first, last)| format!("{first}..{last}"));
        let bounds: Vec<String> = bounds.collect();
        self.declarations
            .push_str(&format!("{name} : ARRAY[{}] OF {ty};\n", bounds.join(", ")));
        for (number, point) in elements.points.into_iter().enumerate() {
            let own = element_name(&format!("{name}{}", "[]".repeat(dimensions.len())), dimensions, {
                let first = if dimensions.len() == 1 { dimensions[0].0 } else { 0 };
                first + number as i64
            });
            self.inputs.push((Source::Point(point), own));
        }
        let mut at = node.text_range().start();
        let mut between = format!("{name}[");
        for index in &elements.indices {
            let range = index.text_range();
            replaced.push((TextRange::new(at, range.start()), between));
            self.names_in(index, replaced)?;
            at = range.end();
            between = String::from(", ");
        }
        replaced.push((TextRange::new(at, node.text_range().end()), String::from("]")));
        Ok(true)
    }

    /// The enumerations of the program, which are declared from now on.
    fn enumerations(&mut self) -> &[Arc<Enumeration>] {
        let program = self.scope.simulation.program();
        self.enumerations
            .get_or_insert_with(|| enumerations::of_program(program))
    }

    fn scalar(&mut self, point: Point) -> String {
        let name = self.name(&point.name, point.ty);
        self.declarations.push_str(&format!("{name} : {};\n", point.ty));
        self.inputs.push((Source::Point(point), name.clone()));
        name
    }

    fn name(&mut self, stands_for: &str, ty: Scalar) -> String {
        self.tags += 1;
        if ty.is_enumeration() {
            self.enumerations();
        }
        let name = format!("{OPERAND}{}", self.tags);
        self.names.push((name.clone(), stands_for.to_owned()));
        if !self.types.contains(&ty) {
            self.types.push(ty);
        }
        name
    }

    /// The first type in which the expression makes sense is its own.
    pub(super) fn compile(self, text: &str, wanted: Option<Scalar>) -> Result<Expression, Problem> {
        let mut problem = None;
        let told = wanted.unwrap_or_else(|| self.likeliest());
        let profile = self.scope.simulation.program().profiles.first().copied();
        for &ty in &self.types {
            match self.program(ty, profile.unwrap_or_default()) {
                Ok(program) => return self.finish(program),
                // What is wrong in the type that is likeliest.
                Err(wrong) if problem.is_none() || ty == told => problem = Some(wrong),
                Err(_) => {}
            }
        }
        Err(problem.unwrap_or_else(|| format!("`{text}` is not an expression")))
    }

    fn likeliest(&self) -> Scalar {
        let first = self.inputs.first();
        first.map_or(Scalar::Bool, |(source, _)| match source {
            Source::Point(point) => point.ty,
            Source::Past(past) => past.ty(),
        })
    }

    fn program(&self, ty: Scalar, profile: Profile) -> Result<Arc<Program>, Problem> {
        let Small {
            declarations,
            expression,
            ..
        } = self;
        let directive = match profile {
            Profile::Iec => String::new(),
            other => format!("# ladder: profile {} #\n", other.name()),
        };
        let types = enumerations::declaration(self.enumerations.as_deref().unwrap_or_default());
        let text = format!(
            "{directive}{types}VAR\n{declarations}result : {ty};\nEND_VAR\n{BEFORE}{expression}{AFTER}"
        );
        let analysis = analyze(&Arc::new(parse(&text)), "expression");
        if let Some(error) = analysis.errors().next() {
            let mut message = error.message.clone();
            for (name, stands_for) in self.names.iter().rev() {
                message = message.replace(name, stands_for);
            }
            return Err(message);
        }
        let program = analysis.program().cloned();
        let program = program.ok_or_else(|| "the expression cannot be evaluated".to_owned())?;
        // A name that is none of its own tags is a value where nothing asks for one.
        let is_own = |tag: &&Tag| tag.name == "result" || tag.name.starts_with(OPERAND);
        if let Some(value) = program.tags.iter().find(|tag| !is_own(tag)) {
            let all = self.enumerations.as_deref().unwrap_or_default();
            return Err(enumerations::not_asked_for(all, &value.name)
                .unwrap_or_else(|| format!("there is no tag `{}` in this program", value.name)));
        }
        Ok(program)
    }

    fn finish(self, program: Arc<Program>) -> Result<Expression, Problem> {
        let small = Simulation::new(program, Options::default()).map_err(|error| error.message)?;
        let resolve = |name: &str| small.resolve(name).map_err(|unknown| unknown.message);
        let inputs = self
            .inputs
            .into_iter()
            .map(|(source, name)| Ok((source, resolve(&name)?)))
            .collect::<Result<_, Problem>>()?;
        let result = Box::new(resolve("result")?);
        Ok(Expression {
            kind: Kind::Computed {
                small: Box::new(small),
                inputs,
                result,
            },
        })
    }
}

/// The function of the past that a call names, and its only argument.
fn past_of(call: &SyntaxNode) -> Option<(PastKind, Option<SyntaxNode>)> {
    let mut parts = call.children();
    let name = parts.next()?.text().to_string();
    let kind = PastKind::from_name(name.trim())?;
    let arguments: Vec<SyntaxNode> = parts.collect();
    let only = match &*arguments {
        [one] => Some(one.clone()),
        _ => None,
    };
    Some((kind, only))
}
