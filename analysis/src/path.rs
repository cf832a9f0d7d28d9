//! Tags as people name them from outside a program: on a command line, in the header of a file, in an editor.
//!
//! The names are those of the language: `run`, `warmup.ET`, `level[3]`, `word.5`, `%IX0.3`, `SYS.SCAN`. Only
//! what a single value stands in has a name here, and an index is a number.

use crate::infer;
use crate::program::{Expr, ExprKind, Place, Program, SystemTag, TagId};
use crate::rules::did_you_mean;
use crate::types::{Scalar, Type};
use crate::value::Value;
use ladder_instructions::StateType;
use ladder_syntax::{Name, TextRange};

/// The place that a name means, and its type. Tags in the bodies of user-defined blocks have no name outside.
///
/// # Errors
/// Why the name means no single value, in words for the person who wrote it.
pub fn find(program: &Program, path: &str) -> Result<(Place, Scalar), String> {
    let path = path.trim();
    // The dot of `%IX0.3` belongs to the address.
    if let Some(tag) = tag(program, path) {
        return whole(program, tag);
    }
    let (base, word) = match path.rsplit_once('.') {
        Some((base, word)) if !path.ends_with(']') => (base.trim_end(), word.trim_start()),
        _ => return element_or_unknown(program, path),
    };
    if base.eq_ignore_ascii_case("SYS") {
        let tag = SystemTag::from_name(word).ok_or_else(|| format!("there is no system tag SYS.{word}"))?;
        return Ok((Place::System(tag), tag.ty()));
    }
    if let Some(id) = tag(program, base)
        && let Type::State(state) = program.tags[id.0 as usize].ty
    {
        let member = infer::member(state, word).ok_or_else(|| {
            let members = members(state);
            format!(
                "`{base}` is a {} and has no member `{word}`; it has {members}",
                state.name()
            )
        })?;
        return Ok((Place::Member(id, member), member.ty()));
    }
    let (place, ty) = find(program, base)?;
    bit(place, ty, base, word)
}

/// Says why a place cannot be set from outside, if it cannot.
pub fn check_writable(program: &Program, place: &Place) -> Result<(), String> {
    match place {
        Place::System(_) => Err("system tags can only be read".to_owned()),
        Place::Bit(base, ..) => check_writable(program, base),
        Place::Tag(id) | Place::Element(id, _) | Place::Member(id, _) => {
            let tag = &program.tags[id.0 as usize];
            if tag.constant {
                return Err(format!("`{}` is a constant", tag.name));
            }
            Ok(())
        }
    }
}

/// The names of the program's own tags: those that [`find`] knows, alone or with an index or a member.
pub fn names(program: &Program) -> impl Iterator<Item = &str> {
    program
        .tags
        .iter()
        .filter(|tag| tag.block.is_none())
        .map(|tag| tag.name.as_str())
}

fn tag(program: &Program, name: &str) -> Option<TagId> {
    let wanted = Name::new(name);
    let index = program
        .tags
        .iter()
        .position(|tag| tag.block.is_none() && Name::new(&tag.name) == wanted)?;
    Some(TagId(index as u32))
}

fn whole(program: &Program, id: TagId) -> Result<(Place, Scalar), String> {
    let tag = &program.tags[id.0 as usize];
    let name = &tag.name;
    match tag.ty {
        Type::Scalar(ty) => Ok((Place::Tag(id), ty)),
        Type::Array { first, last, .. } => Err(format!(
            "`{name}` is an array: name one of its elements, {name}[{first}] to {name}[{last}]"
        )),
        Type::State(state) => Err(format!(
            "`{name}` is a {}: name one of its members, {}",
            state.name(),
            members(state)
        )),
    }
}

/// `a[3]`
fn element_or_unknown(program: &Program, path: &str) -> Result<(Place, Scalar), String> {
    let Some((base, index)) = path.strip_suffix(']').and_then(|open| open.split_once('[')) else {
        return Err(unknown(program, path));
    };
    let (base, index) = (base.trim(), index.trim());
    let id = tag(program, base).ok_or_else(|| unknown(program, base))?;
    let Type::Array { first, last, element } = program.tags[id.0 as usize].ty else {
        return Err(format!("`{base}` is no array: it has no elements"));
    };
    let index = index
        .parse::<i64>()
        .map_err(|_| format!("`{index}` is no index: write a number from {first} to {last}"))?;
    if !(first..=last).contains(&index) {
        return Err(format!(
            "`{base}` has the elements {first} to {last}, there is no {index}"
        ));
    }
    let index = Expr {
        ty: Scalar::Lint,
        kind: ExprKind::Constant(Value::Int(index)),
        range: TextRange::default(),
    };
    Ok((Place::Element(id, Box::new(index)), element))
}

/// `word.3`
fn bit(place: Place, ty: Scalar, base: &str, word: &str) -> Result<(Place, Scalar), String> {
    if !ty.is_integer() && !ty.is_bits() {
        return Err(format!("`{base}` is {ty} and has no members"));
    }
    match word.parse::<u8>() {
        Ok(bit) if u32::from(bit) < ty.width() => Ok((Place::Bit(Box::new(place), ty, bit), Scalar::Bool)),
        _ => Err(format!(
            "`{base}` is {ty} and has the bits 0 to {}, there is no `{word}`",
            ty.width() - 1
        )),
    }
}

fn unknown(program: &Program, name: &str) -> String {
    match did_you_mean::closest(name, names(program)) {
        Some(near) => format!("there is no tag `{name}`; did you mean `{near}`?"),
        None => format!("there is no tag `{name}`"),
    }
}

fn members(state: StateType) -> &'static str {
    match state {
        StateType::Sr | StateType::Rs => "Q1",
        StateType::Ctud => "CU CD R LD PV CV QU QD Q",
        state if state.is_counter() => "CU CD R LD PV CV Q",
        _ => "IN PT R Q ET",
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use expect_test::{Expect, expect};
    use std::sync::Arc;

    const PROGRAM: &str = "\
VAR start : BOOL; level : ARRAY[0..9] OF INT; status : WORD; END_VAR
VAR CONSTANT limit : INT := 80; END_VAR
+--[ ]( start )--[TON]( warmup, T#5s )--[MOV]( status, 1 )--( )( run )--+
+--[ ]( %IX0.3 )--[MOV]( level[1], limit )--( )( %QX0.0 )--+
";

    fn check(paths: &[&str], expected: Expect) {
        let parse = Arc::new(ladder_syntax::parse(PROGRAM));
        let program = crate::analyze(&parse, "test.clad").program.expect("no errors");
        let shown: Vec<String> = paths
            .iter()
            .map(|path| match find(&program, path) {
                Ok((place, ty)) => {
                    let writable = check_writable(&program, &place).err().unwrap_or_default();
                    format!("{path}: {ty} {writable}").trim_end().to_owned()
                }
                Err(problem) => format!("{path}: {problem}"),
            })
            .collect();
        expected.assert_eq(&(shown.join("\n") + "\n"));
    }

    #[test]
    fn every_form_of_a_name() {
        check(
            &[
                "start",
                "RUN",
                "warmup.ET",
                "warmup.dn",
                "level[0]",
                " level [ 9 ] ",
                "status.15",
                "level[3].2",
                "%IX0.3",
                "SYS.SCAN",
                "sys.on",
                "limit",
            ],
            expect![[r#"
                start: BOOL
                RUN: BOOL
                warmup.ET: TIME
                warmup.dn: BOOL
                level[0]: INT
                 level [ 9 ] : INT
                status.15: BOOL
                level[3].2: BOOL
                %IX0.3: BOOL
                SYS.SCAN: DINT system tags can only be read
                sys.on: BOOL system tags can only be read
                limit: INT `limit` is a constant
            "#]],
        );
    }

    #[test]
    fn names_that_mean_no_value() {
        check(
            &[
                "strat",
                "pump",
                "",
                "level",
                "warmup",
                "warmup.CV",
                "level[10]",
                "level[i]",
                "start[1]",
                "status.16",
                "status.x",
                "start.0",
                "SYS.CLOCK",
                "SYS",
                "strat.Q",
                "lvel[2]",
                "level[1",
                ".",
                "a.b.c",
            ],
            expect![[r#"
                strat: there is no tag `strat`; did you mean `start`?
                pump: there is no tag `pump`
                : there is no tag ``
                level: `level` is an array: name one of its elements, level[0] to level[9]
                warmup: `warmup` is a TON: name one of its members, IN PT R Q ET
                warmup.CV: `warmup` is a TON and has no member `CV`; it has IN PT R Q ET
                level[10]: `level` has the elements 0 to 9, there is no 10
                level[i]: `i` is no index: write a number from 0 to 9
                start[1]: `start` is no array: it has no elements
                status.16: `status` is WORD and has the bits 0 to 15, there is no `16`
                status.x: `status` is WORD and has the bits 0 to 15, there is no `x`
                start.0: `start` is BOOL and has no members
                SYS.CLOCK: there is no system tag SYS.CLOCK
                SYS: there is no tag `SYS`
                strat.Q: there is no tag `strat`; did you mean `start`?
                lvel[2]: there is no tag `lvel`; did you mean `level`?
                level[1: there is no tag `level[1`; did you mean `level`?
                .: there is no tag ``
                a.b.c: there is no tag `a`
            "#]],
        );
    }
}
