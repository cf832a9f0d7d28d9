//! Expressions over the tags of a running program, in the language's own grammar.
//!
//! An expression is compiled by the engine itself: what it names is replaced by tags of a small program of its own, which has
//! the one block `[CALC]( result, expression )`. To evaluate it these tags are given what the running program holds, and
//! the small program runs one scan. So arithmetic, conversions and faults are those of the language.

use std::sync::Arc;

use ladder_analysis::analyze;
use ladder_analysis::program::Program;
use ladder_analysis::types::{Scalar, Type};
use ladder_analysis::value::Value;
use ladder_instructions::Profile;
use ladder_simulator::{Instance, Options, Point, Simulation, value_text};
use ladder_syntax::{Name, SyntaxKind, SyntaxNode, TextRange, TextSize, parse};

/// What stands before the expression in the small program.
const BEFORE: &str = "+--[CALC]( result, ";
const BEHIND: &str = " )--+\n";

/// No expression reads more elements of arrays than this.
const MOST_ELEMENTS: i64 = 100_000;

/// Why an expression cannot be evaluated, in words.
pub(super) type Problem = String;

/// Where names are looked up: in a body first among its own tags.
#[derive(Debug, Clone, Copy)]
pub(super) struct Scope<'s> {
    pub simulation: &'s Simulation,
    pub instance: Option<&'s Instance>,
}

impl Scope<'_> {
    /// The place that a text names.
    pub(super) fn resolve(self, text: &str) -> Result<Point, Problem> {
        if let Some(instance) = self.instance {
            let own = self.simulation.resolve_within(instance, text);
            // What is no tag of the body may be a global.
            if let Ok(point) = own {
                return Ok(point);
            }
        }
        self.simulation.resolve(text).map_err(|unknown| unknown.message)
    }

    /// A whole tag by its name, and the name that its parts begin with.
    pub(super) fn tag(self, text: &str) -> Option<(String, Type)> {
        let program = self.simulation.program();
        let (instance, rest) = match text.trim().rsplit_once('.') {
            Some((place, rest)) if place.starts_with('$') => {
                let place = Name::new(place);
                let mut all = self.simulation.instances().iter();
                (all.find(|instance| Name::new(&instance.name) == place), rest)
            }
            _ => (self.instance, text.trim()),
        };
        let wanted = Name::new(rest);
        let of_instance = instance.and_then(|instance| {
            let mut tags = instance.tags().map(|tag| &program.tags[tag.0 as usize]);
            let tag = tags.find(|tag| Name::new(&tag.name) == wanted)?;
            Some((format!("{}.{}", instance.name, tag.name), tag.ty))
        });
        of_instance.or_else(|| {
            let mut tags = program.tags.iter().filter(|tag| tag.block.is_none());
            let tag = tags.find(|tag| Name::new(&tag.name) == wanted)?;
            Some((tag.name.clone(), tag.ty))
        })
    }
}

/// An expression that can be evaluated again and again.
#[derive(Debug)]
pub(super) struct Watch {
    kind: Kind,
}

#[derive(Debug)]
enum Kind {
    /// One value.
    Point(Box<Point>),
    /// More than that.
    Computed {
        small: Box<Simulation>,
        /// What is read, and the tag of the small program that it goes to.
        inputs: Vec<(Point, Point)>,
        result: Box<Point>,
    },
}

/// A value with its type.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Typed {
    pub value: Value,
    pub ty: Scalar,
}

impl Typed {
    /// As people write it.
    pub(super) fn shown(&self) -> String {
        value_text::display(&self.value, self.ty)
    }
}

impl Watch {
    /// Compiles an expression.
    pub(super) fn new(text: &str, scope: Scope<'_>) -> Result<Watch, Problem> {
        let text = text.trim();
        if text.is_empty() {
            return Err("write an expression, such as count > 5".into());
        }
        if let Ok(point) = scope.resolve(text) {
            return Ok(Watch {
                kind: Kind::Point(Box::new(point)),
            });
        }
        Small::of(text, scope)?.compile(text)
    }

    /// The place that the expression is, if it is one.
    pub(super) fn point(&self) -> Option<&Point> {
        match &self.kind {
            Kind::Point(point) => Some(point),
            Kind::Computed { .. } => None,
        }
    }

    /// What it is now.
    pub(super) fn evaluate(&mut self, simulation: &Simulation) -> Result<Typed, Problem> {
        match &mut self.kind {
            Kind::Point(point) => Ok(Typed {
                value: simulation.value(point),
                ty: point.ty,
            }),
            Kind::Computed {
                small,
                inputs,
                result,
            } => {
                small.reset();
                for (from, to) in inputs {
                    // A real that is not finite is refused.
                    small
                        .set(to, simulation.value(from))
                        .map_err(|refused| refused.message.replace(&to.name, &from.name))?;
                }
                small.scan();
                match small.take_faults().into_iter().next() {
                    Some(fault) => Err(fault.message),
                    None => Ok(Typed {
                        value: small.value(result),
                        ty: result.ty,
                    }),
                }
            }
        }
    }

    /// Whether it is true. An expression that is no BOOL is a mistake.
    pub(super) fn holds(&mut self, simulation: &Simulation) -> Result<bool, Problem> {
        match self.evaluate(simulation)? {
            Typed {
                value: Value::Bool(high),
                ..
            } => Ok(high),
            Typed { ty, .. } => Err(format!("a condition is TRUE or FALSE, and this is of type {ty}")),
        }
    }
}

/// The small program while it is written.
struct Small<'s> {
    scope: Scope<'s>,
    /// The expression with the names of the small program.
    expression: String,
    declarations: String,
    inputs: Vec<(Point, String)>,
    /// How many tags it has.
    tags: usize,
    /// The types that the result may have, the likelier first.
    types: Vec<Scalar>,
    /// The names of its tags, and what stands for them in the expression.
    names: Vec<(String, String)>,
}

impl<'s> Small<'s> {
    fn of(text: &str, scope: Scope<'s>) -> Result<Small<'s>, Problem> {
        let mut small = Small {
            scope,
            expression: String::new(),
            declarations: String::new(),
            inputs: Vec::new(),
            tags: 0,
            types: vec![Scalar::Bool],
            names: Vec::new(),
        };
        let text = small.without_instances(text)?;
        let whole = format!("{BEFORE}{text}{BEHIND}");
        let tree = parse(&whole).syntax();
        let range = TextRange::at(TextSize::of(BEFORE), TextSize::of(text.as_str()));
        let is_list = |node: &SyntaxNode| node.kind() == SyntaxKind::OPERAND_LIST;
        let list = tree.descendants().find(is_list);
        let operands: Vec<SyntaxNode> = list.map_or(Vec::new(), |list| list.children().collect());
        let [_, expression] = &*operands else {
            return Err(format!("`{text}` is no expression"));
        };
        if expression.text_range() != range {
            return Err(format!("`{text}` is no expression"));
        }
        let mut replaced = Vec::new();
        small.names_in(expression, &mut replaced)?;
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

    /// Names of places of user-defined blocks are no names of the grammar: `$RAMP#2.level` becomes a tag at once.
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
        // One line: what stands behind a line end would be another.
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
                    Err(_) if node.kind() == INDEX_EXPR => self.array(node, replaced),
                    Err(problem) => Err(problem),
                }
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

    /// An array with an index that is a tag, or with a range.
    fn array(&mut self, node: &SyntaxNode, replaced: &mut Vec<(TextRange, String)>) -> Result<(), Problem> {
        let mut parts = node.children();
        let array = parts
            .next()
            .map_or(String::new(), |array| array.text().to_string());
        let array: String = array.split_whitespace().collect();
        let found = self.scope.tag(&array);
        let Some((whole, Type::Array { first, last, element })) = found else {
            return self.scope.resolve(&array).map(|_| ());
        };
        if last - first >= MOST_ELEMENTS {
            return Err(format!(
                "{whole} is too large for an expression with an index that is no number"
            ));
        }
        let name = self.name(&whole, element);
        self.declarations
            .push_str(&format!("{name} : ARRAY[{first}..{last}] OF {element};\n"));
        for index in first..=last {
            let point = self.scope.simulation.resolve(&format!("{whole}[{index}]"));
            let point = point.map_err(|unknown| unknown.message)?;
            self.inputs.push((point, format!("{name}[{index}]")));
        }
        if let Some(array) = node.children().next() {
            replaced.push((array.text_range(), name));
        }
        for index in parts {
            self.names_in(&index, replaced)?;
        }
        Ok(())
    }

    fn scalar(&mut self, point: Point) -> String {
        let name = self.name(&point.name, point.ty);
        self.declarations.push_str(&format!("{name} : {};\n", point.ty));
        self.inputs.push((point, name.clone()));
        name
    }

    fn name(&mut self, stands_for: &str, ty: Scalar) -> String {
        self.tags += 1;
        let name = format!("operand_{}", self.tags);
        self.names.push((name.clone(), stands_for.to_owned()));
        if !self.types.contains(&ty) {
            self.types.push(ty);
        }
        name
    }

    /// The first type in which the expression makes sense is its own.
    fn compile(self, text: &str) -> Result<Watch, Problem> {
        let mut problem = None;
        let profile = self.scope.simulation.program().profiles.first().copied();
        for &ty in &self.types {
            match self.program(ty, profile.unwrap_or_default()) {
                Ok(program) => return self.finish(program),
                // What is wrong in the type that is likeliest.
                Err(wrong) if problem.is_none() || ty == self.likeliest() => problem = Some(wrong),
                Err(_) => {}
            }
        }
        Err(problem.unwrap_or_else(|| format!("`{text}` is no expression")))
    }

    fn likeliest(&self) -> Scalar {
        self.inputs.first().map_or(Scalar::Bool, |(point, _)| point.ty)
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
        let text =
            format!("{directive}VAR\n{declarations}result : {ty};\nEND_VAR\n{BEFORE}{expression}{BEHIND}");
        let analysis = analyze(&Arc::new(parse(&text)), "expression");
        if let Some(error) = analysis.errors().next() {
            let mut message = error.message.clone();
            for (name, stands_for) in self.names.iter().rev() {
                message = message.replace(name, stands_for);
            }
            return Err(message);
        }
        analysis
            .program()
            .cloned()
            .ok_or_else(|| "the expression cannot be evaluated".to_owned())
    }

    fn finish(self, program: Arc<Program>) -> Result<Watch, Problem> {
        let small = Simulation::new(program, Options::default()).map_err(|error| error.message)?;
        let resolve = |name: &str| small.resolve(name).map_err(|unknown| unknown.message);
        let inputs = self
            .inputs
            .into_iter()
            .map(|(point, name)| Ok((point, resolve(&name)?)))
            .collect::<Result<_, Problem>>()?;
        let result = Box::new(resolve("result")?);
        Ok(Watch {
            kind: Kind::Computed {
                small: Box::new(small),
                inputs,
                result,
            },
        })
    }
}
