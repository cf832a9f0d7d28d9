//! Programs with types of their own: structures in structures, arrays of one to three dimensions, enumerations, states of timers,
//! counters and blocks as parts, computed indices wherever one may stand. What is made is a [`Typed`]: the [reference
//! evaluation](crate::reference) runs that, the simulator its text.

mod text;

use super::dice::Dice;
use std::collections::HashSet;

/// A type.
#[derive(Debug, Clone, PartialEq)]
pub enum Ty {
    /// `BOOL`
    Bool,
    /// `INT`
    Int,
    /// The enumeration.
    Phase,
    /// A structure by its number.
    Structure(usize),
    /// An array: first and last index of each dimension, and the type of an element.
    Array(Vec<(i64, i64)>, Box<Ty>),
    /// `TON`
    Ton,
    /// `CTU`
    Ctu,
    /// The state of `$Acc`.
    Acc,
}

/// An index: a number, or one of the inputs `i0` to `i2` and so much.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Index {
    /// `3`
    Number(i64),
    /// `i1 + 2`
    Input(usize, i64),
}

/// A step into a tag.
#[derive(Debug, Clone, PartialEq)]
pub enum Step {
    /// A member by its number in the structure, with its name.
    Member(usize, String),
    /// An element, by all indices of its array.
    Element(Vec<Index>),
}

/// A tag, or a part of one.
#[derive(Debug, Clone, PartialEq)]
pub struct Path {
    /// The tag by its number, with its name.
    pub tag: (usize, String),
    /// The way into it.
    pub steps: Vec<Step>,
}

/// Elements of an array in its last dimension.
#[derive(Debug, Clone)]
pub struct Span {
    /// The array.
    pub array: Path,
    /// The indices of the other dimensions, then the first and the last one meant.
    pub indices: (Vec<Index>, Index, Index),
}

/// What a rung does.
#[derive(Debug, Clone)]
pub enum Act {
    /// `[MOV]( y, a )`
    Move(Path, Path),
    /// `[SEL]( y, g, a, b )`
    Select(Path, Path, [Path; 2]),
    /// `[MUX]( y, k, a, b, c )`
    Choose(Path, Index, [Path; 3]),
    /// `[ADD]( y, a, b )`
    Add(Path, Path, i64),
    /// `[TYP]( y, a )`: from a number to the enumeration.
    ToPhase(Path, Path),
    /// `[TYP]( y, a )`: from the enumeration to a number.
    ToNumber(Path, Path),
    /// `[EQ]( a, b )` on the enumeration.
    Equal(Path, Path),
    /// `[ ]( a )`
    Contact(Path),
    /// `( )( a )`
    Coil(Path),
    /// `[FILL]( y[..], a )`
    Fill(Span, Path),
    /// `[BMOV]( y[..], a[..] )`
    Copy(Span, Span),
    /// `[TON]( t, T#20ms )`
    Ton(Path),
    /// `[CTU]( c, 2 )`
    Ctu(Path),
    /// `[$Acc]( state, x, by, total )`
    Acc(Path, [Path; 3]),
    /// `[$Poke]( cell, by )`: all of the structure that holds states, as an in-out.
    Poke(Path, Path),
}

/// A rung: an input, what it does, and a coil after it.
#[derive(Debug, Clone)]
pub struct Rung {
    /// The input that is before it, by its number.
    pub input: Option<usize>,
    /// What it does.
    pub act: Act,
}

/// A program.
#[derive(Debug, Clone)]
pub struct Typed {
    /// The enumeration's values with their numbers.
    pub phases: Vec<(String, i64)>,
    /// The members of each structure: name, type, and of a number what it starts with.
    pub structures: Vec<Vec<(String, Ty, i64)>>,
    /// The tags.
    pub tags: Vec<(String, Ty)>,
    /// The rungs; after each is a coil on `ok0`, `ok1`, ..
    pub rungs: Vec<Rung>,
}

/// The inputs: `e0` .. are BOOL, `i0` .. INT.
pub const INPUTS: usize = 3;

/// The structure that holds states, and where its members are that `$Poke` uses.
pub const CELL: usize = 2;
/// `n`, `on`, `row`, `t`, `done`, `acc`, `total` of a cell.
pub const CELL_MEMBERS: [usize; 7] = [0, 1, 2, 3, 4, 5, 6];

/// Makes a program.
pub(super) fn typed(dice: &mut Dice) -> Typed {
    let mut number = -1;
    let phases = ["IDLE", "FILLING", "MIXING", "EMPTYING"].map(|name| {
        number += dice.of(&[1, 1, 1, 4]);
        (name.to_owned(), number)
    });
    let member = |name: &str, ty: Ty, start: i64| (name.to_owned(), ty, start);
    let item = vec![
        member("n", Ty::Int, dice.between(-9, 9)),
        member("on", Ty::Bool, 0),
        member("step", Ty::Phase, 0),
    ];
    let line = vec![
        member("n", Ty::Int, dice.between(-9, 9)),
        member("item", Ty::Structure(0), 0),
        member("row", array(dice, Ty::Int), 0),
        member("items", array(dice, Ty::Structure(0)), 0),
    ];
    let cell = vec![
        member("n", Ty::Int, dice.between(-9, 9)),
        member("on", Ty::Bool, 0),
        member("row", Ty::Array(vec![bounds(dice)], Box::new(Ty::Int)), 0),
        member("t", Ty::Ton, 0),
        member("done", Ty::Bool, 0),
        member("acc", Ty::Acc, 0),
        member("total", Ty::Int, 0),
        member("line", Ty::Structure(1), 0),
    ];
    let tags = [
        ("number", Ty::Int),
        ("flag", Ty::Bool),
        ("step", Ty::Phase),
        ("steps", array(dice, Ty::Phase)),
        ("item", Ty::Structure(0)),
        ("items", Ty::Array(vec![bounds(dice)], Box::new(Ty::Structure(0)))),
        ("grid", array(dice, Ty::Structure(0))),
        ("line", Ty::Structure(1)),
        ("lines", array(dice, Ty::Structure(1))),
        ("numbers", Ty::Array(vec![bounds(dice)], Box::new(Ty::Int))),
        ("table", array(dice, Ty::Int)),
        ("timers", array(dice, Ty::Ton)),
        ("counters", array(dice, Ty::Ctu)),
        ("totals", array(dice, Ty::Acc)),
        ("cells", array(dice, Ty::Structure(CELL))),
    ];
    let mut typed = Typed {
        phases: phases.into(),
        structures: vec![item, line, cell],
        tags: tags.map(|(name, ty)| (name.to_owned(), ty)).into(),
        rungs: Vec::new(),
    };
    let mut states = HashSet::new();
    for _ in 0..2 + dice.below(10) {
        if let Some(act) = act(dice, &typed, &mut states) {
            let input = dice.one_in(2).then(|| dice.below(INPUTS));
            typed.rungs.push(Rung { input, act });
        }
    }
    typed
}

fn bounds(dice: &mut Dice) -> (i64, i64) {
    let first = dice.of(&[0, 1, 1, -1]);
    (first, first + dice.between(0, 2))
}

fn array(dice: &mut Dice, element: Ty) -> Ty {
    let dimensions = (0..=dice.below(3)).map(|_| bounds(dice)).collect();
    Ty::Array(dimensions, Box::new(element))
}

fn act(dice: &mut Dice, typed: &Typed, states: &mut HashSet<String>) -> Option<Act> {
    let path = |dice: &mut Dice, ty: &Ty| typed.path(dice, ty);
    let number = |dice: &mut Dice| typed.path(dice, &Ty::Int);
    Some(match dice.below(16) {
        0 | 1 => {
            let ty = typed.copied(dice);
            Act::Move(path(dice, &ty), path(dice, &ty))
        }
        2 => {
            let ty = typed.copied(dice);
            let y = path(dice, &ty);
            Act::Select(y, path(dice, &Ty::Bool), [path(dice, &ty), path(dice, &ty)])
        }
        3 => {
            let ty = typed.copied(dice);
            let y = path(dice, &ty);
            let values = [path(dice, &ty), path(dice, &ty), path(dice, &ty)];
            Act::Choose(y, Index::Input(dice.below(INPUTS), 0), values)
        }
        4 => Act::Add(number(dice), number(dice), dice.between(-300, 300)),
        5 => Act::ToPhase(path(dice, &Ty::Phase), number(dice)),
        6 => Act::ToNumber(number(dice), path(dice, &Ty::Phase)),
        7 => Act::Equal(path(dice, &Ty::Phase), path(dice, &Ty::Phase)),
        8 => Act::Contact(path(dice, &Ty::Bool)),
        9 => Act::Coil(path(dice, &Ty::Bool)),
        10 => {
            let (array, dimensions, element) = typed.array(dice, None)?;
            let value = path(dice, &element);
            Act::Fill(span(dice, array, &dimensions, None), value)
        }
        11 => {
            let (to, dimensions, element) = typed.array(dice, None)?;
            let (from, others, _) = typed.array(dice, Some(&element))?;
            let most = [&dimensions, &others].map(|all| all.last().map_or(0, |(first, last)| last - first));
            let more = dice.between(0, most[0].min(most[1]));
            let to = span(dice, to, &dimensions, Some(more));
            Act::Copy(to, span(dice, from, &others, Some(more)))
        }
        12 => Act::Ton(fresh(path(dice, &Ty::Ton), states)?),
        13 => Act::Ctu(fresh(path(dice, &Ty::Ctu), states)?),
        14 => {
            let given = [path(dice, &Ty::Bool), number(dice), number(dice)];
            Act::Acc(path(dice, &Ty::Acc), given)
        }
        _ => Act::Poke(path(dice, &Ty::Structure(CELL)), number(dice)),
    })
}

/// Two blocks on one timer or counter are an error, and so is one on a timer that `$Poke` has.
fn fresh(path: Path, states: &mut HashSet<String>) -> Option<Path> {
    (path.steps.len() == 1 && states.insert(path.to_string())).then_some(path)
}

fn span(dice: &mut Dice, array: Path, dimensions: &[(i64, i64)], more: Option<i64>) -> Span {
    let (&(first, last), others) = dimensions.split_last().expect("an array has a dimension");
    let others = others.iter().map(|bounds| index(dice, *bounds)).collect();
    let length = more.unwrap_or_else(|| dice.between(0, last - first));
    let from = dice.between(first, last - length);
    let ends = match (dice.one_in(2), dice.below(INPUTS)) {
        (true, input) => (Index::Input(input, 0), Index::Input(input, length)),
        (false, _) => (Index::Number(from), Index::Number(from + length)),
    };
    Span {
        array,
        indices: (others, ends.0, ends.1),
    }
}

fn index(dice: &mut Dice, (first, last): (i64, i64)) -> Index {
    if dice.one_in(2) {
        Index::Input(dice.below(INPUTS), dice.of(&[0, 0, 1, -1]))
    } else {
        Index::Number(dice.between(first, last))
    }
}

/// An array: where it is, its dimensions, the type of an element.
type ArrayOf = (Path, Vec<(i64, i64)>, Ty);

impl Typed {
    /// All parts of tags: their types, with every index a place to fill.
    fn parts(&self) -> Vec<(Path, Ty)> {
        let mut parts = Vec::new();
        for (number, (name, ty)) in self.tags.iter().enumerate() {
            let tag = (number, name.clone());
            self.add_parts(
                Path {
                    tag,
                    steps: Vec::new(),
                },
                ty,
                &mut parts,
            );
        }
        parts
    }

    fn add_parts(&self, path: Path, ty: &Ty, parts: &mut Vec<(Path, Ty)>) {
        parts.push((path.clone(), ty.clone()));
        let with = |step: Step| {
            let mut path = path.clone();
            path.steps.push(step);
            path
        };
        match ty {
            Ty::Structure(number) => {
                for (member, (name, ty, _)) in self.structures[*number].iter().enumerate() {
                    self.add_parts(with(Step::Member(member, name.clone())), ty, parts);
                }
            }
            Ty::Array(dimensions, element) => {
                let firsts = dimensions.iter().map(|(first, _)| Index::Number(*first));
                self.add_parts(with(Step::Element(firsts.collect())), element, parts);
            }
            _ => {}
        }
    }

    /// The type of a part.
    fn type_of(&self, path: &Path) -> &Ty {
        path.steps
            .iter()
            .fold(&self.tags[path.tag.0].1, |ty, step| match (step, ty) {
                (Step::Member(member, _), Ty::Structure(number)) => &self.structures[*number][*member].1,
                (Step::Element(_), Ty::Array(_, element)) => element,
                _ => ty,
            })
    }

    fn with_indices(&self, dice: &mut Dice, mut path: Path) -> Path {
        for at in 0..path.steps.len() {
            let whole = Path {
                tag: path.tag.clone(),
                steps: path.steps[..at].to_vec(),
            };
            if let (Step::Element(indices), Ty::Array(dimensions, _)) =
                (&mut path.steps[at], self.type_of(&whole))
            {
                *indices = dimensions.iter().map(|bounds| index(dice, *bounds)).collect();
            }
        }
        path
    }

    fn path(&self, dice: &mut Dice, ty: &Ty) -> Path {
        let parts: Vec<Path> = (self.parts().into_iter())
            .filter(|(_, found)| found == ty)
            .map(|(path, _)| path)
            .collect();
        let path = parts[dice.below(parts.len())].clone();
        self.with_indices(dice, path)
    }

    /// A type that is copied.
    fn copied(&self, dice: &mut Dice) -> Ty {
        let types: Vec<Ty> = (self.parts().into_iter())
            .map(|(_, ty)| ty)
            .filter(|ty| !self.keeps_state(ty))
            .collect();
        types[dice.below(types.len())].clone()
    }

    fn keeps_state(&self, ty: &Ty) -> bool {
        match ty {
            Ty::Bool | Ty::Int | Ty::Phase => false,
            Ty::Ton | Ty::Ctu | Ty::Acc => true,
            Ty::Structure(number) => (self.structures[*number].iter()).any(|(_, ty, _)| self.keeps_state(ty)),
            Ty::Array(_, element) => self.keeps_state(element),
        }
    }

    /// An array of values, perhaps of these.
    fn array(&self, dice: &mut Dice, of: Option<&Ty>) -> Option<ArrayOf> {
        let mut arrays: Vec<ArrayOf> = Vec::new();
        for (path, ty) in self.parts() {
            if let Ty::Array(dimensions, element) = ty
                && !self.keeps_state(&element)
                && of.is_none_or(|of| *of == *element)
            {
                arrays.push((path, dimensions, *element));
            }
        }
        let (path, dimensions, element) = arrays.get(dice.below(arrays.len().max(1)))?.clone();
        Some((self.with_indices(dice, path), dimensions, element))
    }
}
