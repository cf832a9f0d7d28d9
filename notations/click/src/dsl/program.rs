//! A Python file as a program: `main`, the subroutines, and the rungs in them.

use super::super::model::{Action, Condition, Nickname, Program, Routine, Rung};
use super::act::act;
use super::arguments::is_instruction;
use super::comments::Comments;
use super::condition::{condition, shown};
use super::depth;
use super::problems::{Problems, Unread, expression, statement};
use ladder_notation::{Lines, ReadError};
use ruff_python_ast::{Expr, Stmt, StmtFunctionDef, StmtIf};
use ruff_python_parser::parse_module;
use ruff_text_size::Ranged;

/// Reads a program without nicknames.
///
/// # Errors
///
/// As [`read_with`].
pub(in super::super) fn read(text: &str) -> Result<Program, ReadError> {
    read_with(text, &[])
}

/// Reads a program. Python is parsed and never run. `nicknames` are those that the address picker knows.
///
/// # Errors
///
/// If it is not Python, too large or too deep, or has anything in it that the DSL has not.
pub(in super::super) fn read_with(text: &str, nicknames: &[Nickname]) -> Result<Program, ReadError> {
    let text = text.strip_prefix('\u{feff}').unwrap_or(text);
    depth::check(text)?;
    let parsed = parse_module(text).map_err(|error| {
        let place = Lines::of(text).place(text, error.location.start().into());
        ReadError::at(place, format!("this is not Python: {}", error.error))
    })?;
    let mut problems = Problems::new(text, nicknames);
    let mut comments = Comments::of(text, parsed.tokens());
    let mut routines = Vec::new();
    let mut header = Vec::new();
    for (number, stmt) in parsed.suite().iter().enumerate() {
        let next = parsed
            .suite()
            .get(number + 1)
            .map_or(text.len(), |next| next.start().into());
        match stmt {
            Stmt::FunctionDef(function) => {
                let mut routine = routine(&mut problems, &mut comments, function, next);
                if !header.is_empty() {
                    header.append(&mut routine.comments);
                    routine.comments = std::mem::take(&mut header);
                }
                routines.push(routine);
            }
            stmt => match docstring(stmt) {
                Some(lines) => header.extend(lines),
                None => {
                    let what = statement(stmt);
                    problems.note(stmt, format!("{what} outside a function is not in the DSL"));
                }
            },
        }
    }
    // What is at the end belongs to the last routine.
    if let Some(last) = routines.last_mut() {
        last.after.extend(comments.before(text.len() + 1));
    }
    let mut program = Program::default();
    let mut main = None;
    for routine in routines {
        match routine.name.as_str() {
            "main" if main.is_none() => main = Some(routine),
            _ => program.subroutines.push(routine),
        }
    }
    if main.is_none() && program.subroutines.is_empty() && problems.is_empty() {
        let end = Lines::of(text).place(text, text.len());
        return Err(ReadError::at(
            end,
            "a program of the DSL has `def main():`, and this one does not",
        ));
    }
    program.main = main.unwrap_or_default();
    match problems.into_error() {
        Some(error) => Err(error),
        None => Ok(program),
    }
}

/// A single action, as it is under an `if`.
pub(in super::super) fn single_action(text: &str) -> Option<Action> {
    let program = read(&format!("def main():\n    if True:\n        {text}\n")).ok()?;
    let mut rungs = program.main.rungs.into_iter();
    match (rungs.next()?.actions.pop(), rungs.next()) {
        (Some(action), None) => Some(action),
        _ => None,
    }
}

/// A text by itself at the beginning of a file or function: what Python people say about it.
fn docstring(stmt: &Stmt) -> Option<Vec<String>> {
    let Stmt::Expr(inside) = stmt else { return None };
    let Expr::StringLiteral(literal) = &*inside.value else {
        return None;
    };
    let lines = literal.value.to_str().lines().map(str::trim);
    Some(lines.filter(|line| !line.is_empty()).map(str::to_owned).collect())
}

fn routine(
    problems: &mut Problems<'_>,
    comments: &mut Comments,
    function: &StmtFunctionDef,
    next_start: usize,
) -> Routine {
    let above = comments.before(function.start().into());
    let name = function.name.as_str();
    head(problems, function, name);
    let mut routine = Routine {
        name: name.to_owned(),
        place: problems.place(&function.name),
        comments: above,
        rungs: Vec::new(),
        after: Vec::new(),
    };
    for (number, stmt) in function.body.iter().enumerate() {
        match stmt {
            Stmt::If(rung) => {
                if let Ok(rung) = self::rung(problems, comments, rung) {
                    routine.rungs.push(rung);
                }
            }
            Stmt::Pass(_) => {}
            stmt => match docstring(stmt).filter(|_| number == 0) {
                Some(lines) => routine.comments.extend(lines),
                None => _ = problems.note(stmt, outside_rung(stmt)),
            },
        }
    }
    // The comments of the next function are at the left edge.
    let next = problems.text().get(usize::from(function.end())..);
    let end = next.map_or(0, |rest| problems.text().len() - rest.len());
    let line_end = next.and_then(|rest| rest.find('\n')).unwrap_or(0);
    routine.after.extend(comments.before(end));
    routine.after.extend(comments.trailing(end + line_end));
    routine.after.extend(comments.indented_before(next_start));
    routine
}

/// What is wrong with a statement that is next to the rungs.
fn outside_rung(stmt: &Stmt) -> String {
    if let Stmt::Expr(inside) = stmt {
        return match &*inside.value {
            Expr::Call(call) if matches!(&*call.func, Expr::Name(name) if is_instruction(&name.id)) => {
                "an action is under an `if`: write `if True:` above it".to_owned()
            }
            other => format!("{} outside a rung is not in the DSL", expression(other)),
        };
    }
    match stmt {
        Stmt::Return(_) | Stmt::For(_) => {
            format!("{} is under an `if`: write `if True:` above it", statement(stmt))
        }
        _ => format!(
            "{} is not in the DSL: a function has rungs, each under an `if`",
            statement(stmt)
        ),
    }
}

/// `def main():`, or `@sub` and another name.
fn head(problems: &mut Problems<'_>, function: &StmtFunctionDef, name: &str) {
    let mut is_sub = false;
    for decorator in &function.decorator_list {
        match &decorator.expression {
            Expr::Name(it) if it.id == "sub" && name != "main" => is_sub = true,
            other => {
                let shown = shown(problems.source(other));
                let message = match name {
                    "main" => format!("the main program has no decorator, and this is @{shown}"),
                    _ => format!("@{shown} is not in the DSL: the only decorator is @sub"),
                };
                problems.note(other, message);
                is_sub = true;
            }
        }
    }
    if name != "main" && !is_sub {
        problems.note(
            &function.name,
            format!("`{name}` is not `main`, so it is a subroutine and has @sub above it"),
        );
    }
    if function.is_async {
        problems.note(function, "`async` is not in the DSL");
    }
    let parameters = &function.parameters;
    if parameters.iter().next().is_some() {
        problems.note(&**parameters, "functions of the DSL have no parameters");
    }
    if let Some(parameters) = &function.type_params {
        problems.note(&**parameters, "functions of the DSL have no type parameters");
    }
    if let Some(returns) = &function.returns {
        problems.note(&**returns, "functions of the DSL have no types");
    }
}

/// A rung of more actions is not read: its drawing grows with the square of them.
const MOST_ACTIONS: usize = 200;

fn rung(problems: &mut Problems<'_>, comments: &mut Comments, stmt: &StmtIf) -> Result<Rung, Unread> {
    let mut above = comments.before(stmt.start().into());
    let condition = condition(problems, &stmt.test);
    for clause in &stmt.elif_else_clauses {
        let message = match clause.test {
            Some(_) => "`elif` is not in the DSL: write a rung of its own",
            None => "`else` is not in the DSL: write a rung of its own with nc(..)",
        };
        problems.note(clause, message);
    }
    let mut actions: Vec<Action> = Vec::with_capacity(stmt.body.len());
    let mut failed = false;
    for inner in &stmt.body {
        // Comments on the lines above: at the end of the last action's line, or on lines of its own.
        let trailing = comments.trailing(inner.start().into());
        say(&mut actions, &mut above, trailing);
        above.extend(comments.before(inner.start().into()));
        match act(problems, inner) {
            Ok((what, oneshot)) => actions.push(Action {
                place: problems.place(inner),
                condition: Condition::ALWAYS,
                what,
                oneshot,
                comment: None,
            }),
            Err(Unread) => failed = true,
        }
        let inside = comments.before(inner.end().into());
        say(&mut actions, &mut above, inside);
    }
    let end = usize::from(stmt.end());
    let line = problems.text().get(end..).and_then(|rest| rest.find('\n'));
    let trailing = comments.trailing(line.map_or(usize::MAX, |length| end + length));
    say(&mut actions, &mut above, trailing);
    let condition = condition?;
    if actions.len() > MOST_ACTIONS {
        let message = format!(
            "more than {MOST_ACTIONS} actions under one `if` are not read: write the `if` again for the rest"
        );
        return Err(problems.note(stmt, message));
    }
    if failed {
        return Err(Unread);
    }
    Ok(Rung {
        place: problems.place(stmt),
        comments: above,
        condition,
        actions,
    })
}

/// Attaches comments to the last action, or to the rung while it has none.
fn say(actions: &mut [Action], above: &mut Vec<String>, told: Vec<String>) {
    match actions.last_mut() {
        None => above.extend(told),
        Some(_) if told.is_empty() => {}
        Some(action) => {
            let before = action.comment.take().into_iter();
            let all: Vec<String> = before.chain(told).collect();
            action.comment = Some(all.join(" "));
        }
    }
}
