//! Each construct of Structured Text, with the ladder text that it becomes.

mod dialects;
mod enabled;
mod expressions;
mod files;
mod hostile;
mod parts;
mod statements;
mod tokens;

use super::dialect::Dialect;
use super::program::read;
use super::{Source, Type, read_body, units};
use expect_test::Expect;
use ladder_analysis::values::types::Scalar;
use ladder_format::program::{Path, ProgramSketch};
use ladder_notation::{Names, Outcome, UnreadParts};

/// What a file becomes, with what is reported of it.
fn check_file(text: &str, expected: &Expect) {
    let reading = read(text, Dialect::Iec, &[]).expect("it is read");
    let mut shown = reading.program.write(&ladder_format::Options::default()).text;
    for entry in reading.report.remarks() {
        let (Outcome::Refused(why) | Outcome::Approximated(why)) = &entry.outcome else {
            continue;
        };
        shown.push_str(&format!("{}: {}: {why}\n", entry.place, entry.element));
    }
    for finding in &reading.findings {
        shown.push_str(&format!("{}: {}\n", finding.place, finding.message));
    }
    expected.assert_eq(&shown);
}

/// What a body becomes. Its tags: `a` to `d` are BOOL, `i` to `n` INT, `u` and `v` DINT, `r` and `s` REAL, `w` WORD,
/// `t` is a TON, `e` an R_TRIG, `x` an array of INT.
fn check(text: &str, dialect: Dialect, expected: &Expect) {
    let mut scope = super::Scope::default();
    let mut names = Names::default();
    let mut declare = |name: &str, ty: Type| {
        let spelled = names.spell(name).to_owned();
        scope.tag(name, Path::tag(spelled), ty, false);
    };
    for (all, ty) in [
        ("abcd", Scalar::Bool),
        ("ijklmn", Scalar::Int),
        ("uv", Scalar::Dint),
        ("rs", Scalar::Real),
        ("w", Scalar::Word),
        ("pq", Scalar::Time),
    ] {
        all.chars()
            .for_each(|name| declare(&name.to_string(), Type::Scalar(ty)));
    }
    declare("t", Type::Standard("TON"));
    declare("z", Type::Standard("CTU"));
    declare("e", Type::Trigger(super::Edge::Rising));
    declare("f", Type::Trigger(super::Edge::Falling));
    declare(
        "x",
        Type::Array(
            vec![("0".into(), "7".into())],
            Box::new(Type::Scalar(Scalar::Int)),
        ),
    );
    let source = Source {
        text,
        dialect,
        unit: "Main",
        scope: &scope,
        restarted: &[],
        instructions: None,
        first_origin: 0,
        first_label: 0,
    };
    let mut unread = UnreadParts::default();
    let (.., problems) = units::body(text, dialect);
    let shown = match read_body(&source, &mut names, &mut unread, |_| 1) {
        Err(_) if !problems.is_empty() => problems.iter().fold(String::new(), |told, problem| {
            told + &format!("{:?}: {}\n", problem.span, problem.message)
        }),
        Err(why) => format!("unread: {why}\n"),
        Ok(body) => {
            let mut tags = ladder_format::program::Section::new(ladder_format::program::SectionKind::Var);
            tags.declarations = body.tags;
            let mut items: Vec<_> = unread.items().collect();
            items.push(ladder_format::program::Item::Section(tags));
            items.extend(body.items);
            ProgramSketch { items }
                .write(&ladder_format::Options::default())
                .text
        }
    };
    expected.assert_eq(&shown);
}
