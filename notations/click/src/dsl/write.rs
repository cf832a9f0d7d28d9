//! A program as a Python file.

use super::super::model::{Action, Condition, Instruction, Program, Routine, Rung};
use super::spell;
use ladder_notation::Report;

/// The text of a program, and what of it the DSL cannot say.
pub(in super::super) fn write(program: &Program, report: &mut Report) -> String {
    let mut out = String::new();
    let skipped = usize::from(program.has_no_main());
    for (number, routine) in program.routines().enumerate().skip(skipped) {
        if number > skipped {
            out.push_str("\n\n");
        }
        self::routine(routine, number > 0, &mut out, report);
    }
    out
}

fn comments(lines: &[String], indent: &str, out: &mut String) {
    for line in lines.iter().flat_map(|comment| comment.lines()) {
        out.push_str(&format!("{indent}# {}\n", line.trim()));
    }
}

fn routine(routine: &Routine, is_sub: bool, out: &mut String, report: &mut Report) {
    comments(&routine.comments, "", out);
    if is_sub {
        out.push_str("@sub\n");
    }
    out.push_str(&format!("def {}():\n", routine.name));
    for (number, rung) in routine.rungs.iter().enumerate() {
        if number > 0 {
            out.push('\n');
        }
        self::rung(rung, out, report);
    }
    if routine.rungs.is_empty() {
        out.push_str("    pass\n");
    }
    if !routine.after.is_empty() {
        out.push('\n');
        comments(&routine.after, "    ", out);
    }
}

/// A rung. Where its actions have conditions of their own, there is an `if` for each.
fn rung(rung: &Rung, out: &mut String, report: &mut Report) {
    comments(&rung.comments, "    ", out);
    contacts(&rung.condition, report);
    let mut open: Option<&Condition> = None;
    for action in &rung.actions {
        if open != Some(&action.condition) {
            if open.is_some() {
                out.push('\n');
                let why = "the branches of a rung are rungs of their own in the DSL";
                report.approximated(action.place, spell::action(action), why);
            }
            open = Some(&action.condition);
            contacts(&action.condition, report);
            let whole = match (rung.condition.is_always(), action.condition.is_always()) {
                (_, true) => rung.condition.clone(),
                (true, false) => action.condition.clone(),
                (false, false) => Condition::All(vec![rung.condition.clone(), action.condition.clone()]),
            };
            out.push_str(&format!("    if {}:\n", spell::condition(&whole)));
        }
        self::action(action, out, report);
    }
    if rung.actions.is_empty() {
        out.push_str(&format!(
            "    if {}:\n        pass\n",
            spell::condition(&rung.condition)
        ));
    }
}

/// Contacts and comparisons are all in the DSL.
fn contacts(condition: &Condition, report: &mut Report) {
    match condition {
        Condition::All(parts) | Condition::Any(parts) => parts.iter().for_each(|part| contacts(part, report)),
        Condition::Contact(contact) => report.translated(contact.place, spell::condition(condition)),
        Condition::Compare(comparison) => report.translated(comparison.place, spell::condition(condition)),
    }
}

fn action(action: &Action, out: &mut String, report: &mut Report) {
    let text = spell::action(action);
    let comment = action
        .comment
        .as_deref()
        .map(|comment| format!("  # {}", comment.replace('\n', " ")));
    let comment = comment.unwrap_or_default();
    match &action.what {
        Instruction::For(_) => {
            out.push_str(&format!("        {text}:{comment}\n            pass\n"));
        }
        Instruction::Kept { text, why } => {
            report.refused(action.place, text, why.clone());
            out.push_str(&format!("        pass  # {}\n", text.replace('\n', " ")));
            return;
        }
        _ => out.push_str(&format!("        {text}{comment}\n")),
    }
    for why in lost(action) {
        report.approximated(action.place, text.clone(), why);
    }
    report.translated(action.place, text);
}

/// What of an action the DSL does not say.
fn lost(action: &Action) -> Vec<&'static str> {
    let mut out = Vec::new();
    match &action.what {
        Instruction::Out(coil) | Instruction::Set(coil) | Instruction::Reset(coil) if coil.immediate => {
            out.push("the DSL has no immediate outputs");
        }
        Instruction::For(_) if action.oneshot => out.push("the DSL has no one-shot on loops"),
        _ => {}
    }
    out
}
