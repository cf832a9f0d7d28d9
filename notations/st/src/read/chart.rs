//! A chart in Structured Text as networks.

use super::chart_syntax::{AssociationText, ChartText};
use super::lower::{Piece, Surroundings, What, constant, lower_pieces};
use super::tree::{Expression as Tree, ExpressionKind};
use super::{Body, Scope};
use ladder_analysis::values::types::Scalar;
use ladder_format::program::{Drawing, Expression, Item, Network, Path};
use ladder_notation::chart::{
    self, Act, Action, Association, Chart, Clock, Condition, Qualifier, Step, Transition,
};
use ladder_notation::{Names, Outcome, UnreadParts};
use std::collections::HashMap;

/// The networks of a chart. Its steps are taken into the scope.
///
/// # Errors
///
/// What keeps it from being read.
pub(super) fn body(
    text: &ChartText,
    around: &Surroundings<'_>,
    clock: Clock,
    names: &mut Names,
    unread: &mut UnreadParts,
) -> Result<Body, String> {
    let mut scope = around.scope.clone();
    let mut steps = Vec::new();
    for step in &text.steps {
        if scope.known(&step.name).is_some() {
            return Err(format!("a step and a variable are called {}", step.name));
        }
        let active = names.fresh(&step.name);
        let elapsed = names.fresh(&format!("{}_T", step.name));
        scope.step(&step.name, Path::tag(&active), Path::tag(&elapsed));
        steps.push((active, elapsed));
    }
    let around = Surroundings {
        scope: &scope,
        text: around.text,
        lines: around.lines,
        dialect: around.dialect,
        unit: around.unit,
        comments: around.comments,
        instructions: around.instructions,
        first_origin: around.first_origin,
        first_label: around.first_label,
    };
    let conditions = text.transitions.iter().map(|one| What::Condition(&one.condition));
    let bodies = text.actions.iter().map(|one| What::Statements(&one.body));
    let pieces: Vec<Piece<'_>> = conditions
        .chain(bodies)
        .map(|what| Piece {
            around: &around,
            what,
        })
        .collect();
    let mut all = Body::default();
    let mut networks = Vec::new();
    for body in lower_pieces(&pieces, names, unread)? {
        all.tags.extend(body.tags);
        all.origins.extend(body.origins);
        all.entries.extend(body.entries);
        all.used.extend(body.used);
        all.last_label = body.last_label;
        networks.push(body.items);
    }
    let mut networks = networks.into_iter();
    let mut origin = |at: usize| {
        all.origins.push(at);
        Some(around.first_origin + all.origins.len() as u32 - 1)
    };
    let by_name: HashMap<String, usize> = text
        .steps
        .iter()
        .enumerate()
        .map(|(number, step)| (step.name.to_lowercase(), number))
        .collect();
    let mut chart = Chart {
        counts_late: true,
        ..Chart::default()
    };
    for transition in &text.transitions {
        let ends = |names: &[String]| -> Result<Vec<usize>, String> {
            let ends = names.iter().map(|name| {
                let found = by_name.get(&name.to_lowercase()).copied();
                found.ok_or_else(|| format!("there is no step {name}"))
            });
            ends.collect()
        };
        chart.transitions.push(Transition {
            from: ends(&transition.from)?,
            to: ends(&transition.to)?,
            priority: transition.priority,
            condition: condition(networks.next().unwrap_or_default())?,
            origin: origin(transition.span.start),
        });
        all.entries.push((transition.span.clone(), Outcome::Translated));
    }
    let mut actions: HashMap<String, usize> = HashMap::new();
    for action in &text.actions {
        if scope.known(&action.name).is_some() {
            return Err(format!("an action and a variable are called {}", action.name));
        }
        let known = actions.insert(action.name.to_lowercase(), chart.actions.len());
        if known.is_some() {
            return Err(format!("two actions are called {}", action.name));
        }
        chart.actions.push(Action {
            name: action.name.clone(),
            act: Act::Body(networks.next().unwrap_or_default()),
            origin: origin(action.span.start),
        });
    }
    for (step, (active, elapsed)) in text.steps.iter().zip(steps) {
        let mut associations = Vec::new();
        for association in &step.associations {
            let key = association.action.to_lowercase();
            let action = match actions.get(&key) {
                Some(action) => *action,
                None => {
                    let path = variable(&association.action, &scope)?;
                    chart.actions.push(Action {
                        name: association.action.clone(),
                        act: Act::Variable(path),
                        origin: origin(association.span.start),
                    });
                    actions.insert(key, chart.actions.len() - 1);
                    chart.actions.len() - 1
                }
            };
            associations.push(Association {
                action,
                qualifier: qualifier(association, &scope)?,
            });
        }
        chart.steps.push(Step {
            name: step.name.clone(),
            active,
            elapsed,
            is_initial: step.is_initial,
            associations,
            origin: origin(step.span.start),
        });
        all.entries.push((step.span.clone(), Outcome::Translated));
    }
    let lowered = chart::lower(chart, clock, &mut |like| names.fresh(like))?;
    all.items = lowered.items;
    all.tags.extend(lowered.tags);
    Ok(all)
}

/// What has power if a condition holds, after what has to run first.
fn condition(mut items: Vec<Item>) -> Result<Condition, String> {
    let Some(Item::Network(Network {
        drawing: Drawing::Circuit(circuit),
        ..
    })) = items.pop()
    else {
        return Err("a condition is not known".to_owned());
    };
    items.retain(|item| *item != Item::Blank);
    Ok(Condition {
        before: items,
        power: vec![circuit],
    })
}

/// The BOOL that an action is.
fn variable(name: &str, scope: &Scope) -> Result<Path, String> {
    let known = scope.known(name);
    let known = known.filter(|known| known.ty.scalar() == Some(Scalar::Bool) && !known.is_constant);
    known
        .map(|known| known.path.clone())
        .ok_or_else(|| format!("`{name}` is neither an action nor a BOOL"))
}

fn qualifier(association: &AssociationText, scope: &Scope) -> Result<Qualifier, String> {
    let Some(written) = &association.qualifier else {
        return Err(format!("the action {} has no qualifier", association.action));
    };
    let time = association.time.as_ref().map(|time| time_of(time, scope));
    Qualifier::read(written, time.transpose()?)
}

/// A TIME: a literal, or a variable.
fn time_of(time: &Tree, scope: &Scope) -> Result<Expression, String> {
    if let ExpressionKind::Place(place) = &time.kind
        && place.steps.is_empty()
        && let Some(known) = scope.known(&place.root)
    {
        let is_time = known.ty.scalar() == Some(Scalar::Time);
        let why = || format!("`{}` is not a TIME", place.root);
        return is_time.then(|| known.path.clone().into()).ok_or_else(why);
    }
    let text = constant(time, Scalar::Time, scope)?;
    Ok(Expression::literal(text)?)
}
