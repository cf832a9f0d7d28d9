//! Programs with types of their own: structures in structures, arrays of one to three dimensions, enumerations, other names for
//! types, subranges, nested initial values, states of timers, counters and blocks as parts, computed indices wherever one may
//! stand. What is made is a [`Typed`]: the [reference evaluation](crate::reference) runs that, the simulator its text.

mod acts;
mod edit;
mod initial;
mod parts;
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
    /// `INT(2..5)`
    Range(i64, i64),
    /// The enumeration.
    Phase,
    /// A structure by its number.
    Structure(usize),
    /// Another name for a type, by its number.
    Alias(usize),
    /// An array: first and last index of each dimension, and the type of an element.
    Array(Vec<(i64, i64)>, Box<Ty>),
    /// `TON`
    Ton,
    /// `CTU`
    Ctu,
    /// The state of `$Acc`.
    Acc,
}

/// What a tag or a part of one starts with.
#[derive(Debug, Clone, PartialEq)]
pub enum Initial {
    /// A number; of a BOOL 0 or 1.
    Number(i64),
    /// A value of the enumeration.
    Value(String),
    /// `(n := 5, on := TRUE)`
    Members(Vec<(String, Initial)>),
    /// `[5, 2(7), 3()]`: how often, and what; without it the type's own.
    Elements(Vec<(i64, Option<Initial>)>),
}

/// A tag, a member of a structure, or another name for a type.
#[derive(Debug, Clone)]
pub struct Declared {
    /// Its name.
    pub name: String,
    /// Its type.
    pub ty: Ty,
    /// What it starts with, if that is reported.
    pub initial: Option<Initial>,
}

impl Declared {
    fn new(name: &str, ty: Ty) -> Declared {
        Declared {
            name: name.to_owned(),
            ty,
            initial: None,
        }
    }
}

/// The enumeration.
#[derive(Debug, Clone)]
pub struct Enumeration {
    /// Its name.
    pub name: String,
    /// Its values with their numbers.
    pub values: Vec<(String, i64)>,
    /// The value that it starts with, if that is reported.
    pub initial: Option<String>,
}

/// A structure.
#[derive(Debug, Clone)]
pub struct Structure {
    /// Its name.
    pub name: String,
    /// Its members.
    pub members: Vec<Declared>,
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
    /// A member.
    Member(String),
    /// An element, by all indices of its array.
    Element(Vec<Index>),
}

/// A tag, or a part of one.
#[derive(Debug, Clone, PartialEq)]
pub struct Path {
    /// The tag.
    pub tag: String,
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
    /// The number of its coil `ok0`, `ok1`, ..
    pub number: usize,
    /// The input that is before it, by its number.
    pub input: Option<usize>,
    /// What it does.
    pub act: Act,
}

/// A program.
#[derive(Debug, Clone)]
pub struct Typed {
    /// The enumeration.
    pub phase: Enumeration,
    /// The structures: none holds a later one.
    pub structures: Vec<Structure>,
    /// Other names for types.
    pub aliases: Vec<Declared>,
    /// The tags.
    pub tags: Vec<Declared>,
    /// The rungs, each with a number of its own.
    pub rungs: Vec<Rung>,
}

/// The inputs: `e0` .. are BOOL, `i0` .. INT.
pub const INPUTS: usize = 3;

/// The structure that holds states.
pub const CELL: usize = 2;

/// Its members that `$Poke` uses.
pub const POKED: [&str; 7] = ["n", "on", "row", "t", "done", "acc", "total"];

/// Makes a program.
pub(super) fn typed(dice: &mut Dice) -> Typed {
    let mut number = -1;
    let values = ["IDLE", "FILLING", "MIXING", "EMPTYING"].map(|name| {
        number += dice.of(&[1, 1, 1, 4]);
        (name.to_owned(), number)
    });
    let member = Declared::new;
    let structure = |name: &str, members: Vec<Declared>| Structure {
        name: name.to_owned(),
        members,
    };
    let item = vec![
        member("n", Ty::Int),
        member("on", Ty::Bool),
        member("step", Ty::Phase),
        member("share", Ty::Range(2, 5)),
    ];
    let line = vec![
        member("n", Ty::Alias(0)),
        member("item", Ty::Structure(0)),
        member("row", array(dice, Ty::Int)),
        member("items", array(dice, Ty::Structure(0))),
        member("first", Ty::Alias(2)),
    ];
    let cell = vec![
        member("n", Ty::Int),
        member("on", Ty::Bool),
        member("row", Ty::Array(vec![bounds(dice)], Box::new(Ty::Int))),
        member("t", Ty::Ton),
        member("done", Ty::Bool),
        member("acc", Ty::Acc),
        member("total", Ty::Int),
        member("line", Ty::Structure(1)),
    ];
    let aliases = vec![
        member("Start", Ty::Int),
        member("Row", array(dice, Ty::Int)),
        member("First", Ty::Structure(0)),
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
        ("shares", array(dice, Ty::Range(-2, 3))),
        ("start", Ty::Alias(0)),
        ("rows", array(dice, Ty::Alias(1))),
        ("timers", array(dice, Ty::Ton)),
        ("counters", array(dice, Ty::Ctu)),
        ("totals", array(dice, Ty::Acc)),
        ("cells", array(dice, Ty::Structure(CELL))),
    ];
    let mut typed = Typed {
        phase: Enumeration {
            name: "Phase".to_owned(),
            values: values.into(),
            initial: None,
        },
        structures: vec![
            structure("Item", item),
            structure("Line", line),
            structure("Cell", cell),
        ],
        aliases,
        tags: tags.map(|(name, ty)| Declared::new(name, ty)).into(),
        rungs: Vec::new(),
    };
    typed.give_initial_values(dice);
    for _ in 0..2 + dice.below(10) {
        typed.add_rung(dice);
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

impl Typed {
    /// Adds a rung at the end, if what the dice choose can be made.
    fn add_rung(&mut self, dice: &mut Dice) {
        let mut states: HashSet<String> = HashSet::new();
        for rung in &self.rungs {
            if let Act::Ton(path) | Act::Ctu(path) = &rung.act {
                states.insert(path.to_string());
            }
        }
        let Some(act) = acts::act(dice, self, &mut states) else {
            return;
        };
        let number = self.rungs.iter().map(|rung| rung.number + 1).max();
        let input = dice.one_in(2).then(|| dice.below(INPUTS));
        self.rungs.push(Rung {
            number: number.unwrap_or(0),
            input,
            act,
        });
    }
}
