//! Names of values in a Logix controller: `run`, `pump.speed`, `line[2].cmd`, `grid[1, 2]`, `count.3`, `Program:Main.step`.

/// A name in its parts.
#[derive(Debug, PartialEq, Eq)]
pub(super) struct Path {
    /// The tag, with its program where the name has one.
    pub(super) tag: String,
    pub(super) pieces: Vec<Piece>,
}

/// What follows a tag.
#[derive(Debug, PartialEq, Eq)]
pub(super) enum Piece {
    /// A member, or the number of a bit.
    Name(String),
    /// An element, with an index for each dimension.
    Index(Vec<u32>),
}

/// How a controller's names of programs begin, in any case.
const PROGRAM: &str = "Program:";

impl Path {
    /// None: no value of a controller has such a name.
    pub(super) fn parse(name: &str) -> Option<Path> {
        let mut pieces = Vec::new();
        let mut rest = name.trim();
        let mut tag = take_name(&mut rest)?.to_owned();
        if is_of_program(name) {
            rest = rest.strip_prefix('.')?;
            tag = format!("{tag}.{}", take_name(&mut rest)?);
        }
        while !rest.is_empty() {
            if let Some(inside) = rest.strip_prefix('[') {
                let (indices, after) = inside.split_once(']')?;
                let indices = indices.split(',').map(|index| index.trim().parse().ok());
                pieces.push(Piece::Index(indices.collect::<Option<_>>()?));
                rest = after;
            } else {
                rest = rest.strip_prefix('.')?;
                pieces.push(Piece::Name(take_name(&mut rest)?.to_owned()));
            }
        }
        Some(Path { tag, pieces })
    }
}

/// Whether a name says of which program it is.
pub(super) fn is_of_program(name: &str) -> bool {
    (name.trim_start().get(..PROGRAM.len())).is_some_and(|begin| begin.eq_ignore_ascii_case(PROGRAM))
}

fn take_name<'n>(rest: &mut &'n str) -> Option<&'n str> {
    let end = rest.find(['.', '[']).unwrap_or(rest.len());
    let (name, after) = rest.split_at(end);
    *rest = after;
    let name = name.trim();
    (!name.is_empty() && !name.contains([']', '{', '}'])).then_some(name)
}

#[cfg(test)]
mod tests {
    use super::*;
    use expect_test::{Expect, expect};

    fn check(name: &str, expected: Expect) {
        expected.assert_eq(&match Path::parse(name) {
            None => "none".to_owned(),
            Some(path) => path.pieces.iter().fold(path.tag, |text, piece| match piece {
                Piece::Name(name) => format!("{text} | {name}"),
                Piece::Index(indices) => format!("{text} | {indices:?}"),
            }),
        });
    }

    #[test]
    fn parts_of_names() {
        check("run", expect!["run"]);
        check("t1.ACC", expect!["t1 | ACC"]);
        check("line[2].cmd.3", expect!["line | [2] | cmd | 3"]);
        check("grid[1, 2]", expect!["grid | [1, 2]"]);
        check("Program:Main.a[3]", expect!["Program:Main.a | [3]"]);
        check("program:Main.t.DN", expect!["program:Main.t | DN"]);
        check("Local:1:I.Data.4", expect!["Local:1:I | Data | 4"]);
        for wrong in [
            "",
            ".a",
            "a.",
            "a..b",
            "a[",
            "a[]",
            "a[x]",
            "a[-1]",
            "a]",
            "a{3}",
            "Program:Main",
            "a[1]b",
        ] {
            check(wrong, expect!["none"]);
        }
    }
}
