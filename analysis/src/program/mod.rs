//! The program model: what a checked program does, without its text.
//!
//! The simulator compiles it, importers and exporters go by way of it, and rules about power read it. Names are
//! resolved, operands typed and brought to the type that the instruction works in, and each network's elements
//! are in their order of evaluation (LANGUAGE §6).

mod access;
mod loops;
mod operand;
mod system_tag;
mod unread;

use crate::values::types::{Scalar, Type};
use crate::values::value::Value;
pub use access::Access;
use ladder_instructions::{Instruction, Operand, Profile, Semantics, Shape};
use ladder_syntax::{Name, TextRange};
pub use loops::{DEEPEST_LOOP, LoopEnds, loops};
pub use operand::{
    Argument, BinaryOperator, Chosen, Expr, ExprKind, Member, Place, RangeRef, Row, Subscript, UnaryOperator,
};
use std::ops::Range;
use std::sync::Arc;
pub use system_tag::{Clock, SystemTag};
pub use unread::{Unread, UnreadDirective, root_of, unread_name, unread_note, without_blanks};

/// A place in the text of one of the program's files.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Location {
    /// Index into [`Program::files`].
    pub file: u32,
    /// Bytes from the start of the file.
    pub range: TextRange,
}

/// A tag's index in [`Program::tags`].
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct TagId(pub u32);

/// A program that can run.
#[derive(Debug, Clone, Default)]
pub struct Program {
    /// Names of the files it is made of, the program's own first.
    pub files: Vec<String>,
    /// The time from one scan to the next that it is made for, in nanoseconds, where its own file says so.
    pub cycle: Option<i64>,
    /// Of each file whose arithmetic and timing its blocks have.
    pub profiles: Vec<Profile>,
    /// The tags, in the order of their declaration or first use. What several names at one direct address mean is one tag.
    pub tags: Vec<Tag>,
    /// The names that tags at direct addresses have besides their own.
    pub other_names: Vec<OtherName>,
    /// The first address on whose names the files do not agree: such a program must not run.
    pub disagreement: Option<Disagreement>,
    /// All networks: those of the program's file first, from top to bottom.
    pub networks: Vec<Network>,
    /// The networks of the main program: all before the first `<FUN>`.
    pub main: Range<usize>,
    /// The functions that the program can reach.
    pub functions: Vec<Function>,
    /// The tags that are the states of user-defined blocks.
    pub instances: Vec<Instance>,
    /// The user-defined blocks that the program can reach.
    pub blocks: Vec<UserBlock>,
    /// Every label with the network that holds it, in the order of the networks.
    pub labels: Vec<(Name, usize)>,
    /// The models of its machine that run before the main program in each scan, in their order (LANGUAGE §9).
    pub plants: Vec<Plant>,
    /// The networks that are nowhere drawn and run before the main program: they hand its outputs to the plants, call these, and
    /// hand theirs to it.
    pub wiring: Range<usize>,
}

impl Program {
    /// Whose arithmetic and timing the blocks of a place's file have.
    pub fn profile(&self, place: Location) -> Profile {
        let profile = self.profiles.get(place.file as usize).copied();
        profile.unwrap_or_default()
    }

    /// Whether it is a project, whose tasks run the main programs of several files at the rates of those: its
    /// [cycle](Program::cycle) is not to be changed.
    pub fn has_tasks(&self) -> bool {
        self.functions.iter().any(|function| function.every.is_some())
    }

    /// The plant that the tag of a name belongs to.
    pub fn plant_of(&self, name: &str) -> Option<&Plant> {
        self.plants.iter().find(|plant| plant.tag_in(name).is_some())
    }

    /// Whether anything is connected with a plant.
    pub fn is_connected(&self) -> bool {
        let mut plants = self.plants.iter();
        plants.any(|plant| !plant.inputs.is_empty() || !plant.outputs.is_empty())
    }

    /// The inputs of plants that no tag of the program drives: disturbances.
    pub fn undriven(&self) -> impl Iterator<Item = &Tag> {
        let inputs = self.tags.iter().filter(|tag| tag.is_input);
        inputs.filter(|tag| self.plant_of(&tag.name).is_some())
    }

    /// What they do otherwise.
    pub fn semantics(&self, place: Location) -> &'static Semantics {
        self.profile(place).semantics()
    }

    /// The names that tags have besides their own: those that are seen everywhere, or in the body of a block.
    pub fn other_names_in(&self, block: Option<usize>) -> impl Iterator<Item = (&str, &Tag)> {
        let names = self.other_names.iter().filter(move |name| name.block == block);
        names.map(|name| (name.name.as_str(), &self.tags[name.tag.0 as usize]))
    }

    /// The type of a member of a tag.
    pub fn member_type(&self, tag: &Tag, member: Member) -> Scalar {
        member.ty(self.semantics(tag.location))
    }
}

/// A function (`<FUN>`).
#[derive(Debug, Clone)]
pub struct Function {
    /// As written.
    pub name: String,
    /// Its networks; the first holds the `<FUN>`, but where it is the main program of a file that a task runs.
    pub networks: Range<usize>,
    /// How many scans there are from one run to the next, where it is such a main program.
    pub every: Option<u32>,
}

/// A model of the machine, which runs beside the program: a program as any other, whose outputs are inputs of this one.
#[derive(Debug, Clone)]
pub struct Plant {
    /// What is before the names of its tags: `plant` in `plant.level`.
    pub name: String,
    /// Its file, an index into [`Program::files`].
    pub file: u32,
    /// Its main program, an index into [`Program::functions`].
    pub function: usize,
    /// Its tags that take what a tag of the program holds.
    pub inputs: Vec<Connection>,
    /// The inputs of the program that take what its tags hold.
    pub outputs: Vec<Connection>,
}

/// A tag that takes the value of another one before each scan.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Connection {
    /// Whose value it is.
    pub from: TagId,
    /// The tag that takes it.
    pub to: TagId,
}

impl Plant {
    /// What a tag of this name is called in the plant's own file; none if it is not one of its tags.
    pub fn tag_in<'n>(&self, name: &'n str) -> Option<&'n str> {
        let start = name.get(..self.name.len())?;
        let rest = start
            .eq_ignore_ascii_case(&self.name)
            .then(|| &name[self.name.len()..])?;
        rest.strip_prefix('.')
    }
}

/// A tag that is the state of a user-defined block.
#[derive(Debug, Clone)]
pub struct Instance {
    /// The tag.
    pub tag: TagId,
    /// The block: index into [`Program::blocks`].
    pub block: usize,
    /// The tags of the block's body, each with the one that holds it for this state.
    pub tags: Vec<(TagId, TagId)>,
}

/// A user-defined block (LANGUAGE §5.7).
#[derive(Debug, Clone)]
pub struct UserBlock {
    /// As written, with the `$`.
    pub name: String,
    /// The shape that its header shows.
    pub shape: Shape,
    /// Its parameters in the order of their declaration: tags of its body.
    pub parameters: Vec<(TagId, ParameterKind)>,
    /// Of each parameter that is a structure or an array, and not passed as one tag, its parts in the body: the elementary values
    /// of one that is copied, the columns of one that is passed by reference. In their order goes what is given.
    pub parts: Vec<Vec<Place>>,
    /// The tags `EN` and `ENO` of its body.
    pub en: TagId,
    /// See `en`.
    pub eno: TagId,
    /// The networks of its body.
    pub networks: Range<usize>,
    /// What is known of it where it is an unread part: then its body is not run.
    pub unread: Option<Arc<Unread>>,
}

/// How a parameter of a user-defined block is passed.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum ParameterKind {
    /// Copied in before the body runs.
    Input,
    /// Copied out after it.
    Output,
    /// The caller's tag itself.
    InOut,
}

/// What a tag is for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Role {
    /// Fed from outside.
    Input,
    /// Shown to the outside.
    Output,
    /// Neither.
    Internal,
}

/// A tag: a variable of the program.
#[derive(Debug, Clone)]
pub struct Tag {
    /// As declared, or as first written. A tag of another file has that file's stem before it (`library.count`),
    /// unless it is a VAR_GLOBAL tag or a direct address.
    pub name: String,
    /// Its type.
    pub ty: Type,
    /// Input, output or neither, by its declaration, its name, or how its file uses it.
    pub role: Role,
    /// It is an input of the program: what is outside gives it any value of its type before each scan. Whatever runs, tests, proves,
    /// compares or translates a program asks this and nothing else (see `resolve/inputs.rs`).
    pub is_input: bool,
    /// Keeps its value over a warm restart.
    pub retain: bool,
    /// Never written by the program.
    pub constant: bool,
    /// It is not a tag of its file alone: VAR_GLOBAL, a direct address, or not declared.
    pub shared: bool,
    /// Its value at a cold start, one for each element; empty for zero, FALSE, the empty text.
    pub initial: Vec<Value>,
    /// Where it is one of the elementary parts of a declared tag: how elements are named and counted.
    pub column: Option<std::sync::Arc<ColumnOf>>,
    /// The direct address that it is declared at, or that it is.
    pub address: Option<String>,
    /// The user-defined block whose body it belongs to (index into [`Program::blocks`]).
    pub block: Option<usize>,
    /// Where it is declared, or first used.
    pub location: Location,
}

/// How the elements of a tag are named that is an elementary part of a declared one.
#[derive(Debug, Clone, PartialEq)]
pub struct ColumnOf {
    /// First and last index of each array around the part, the outermost first. In the tag's name each has its place: `[]`.
    pub dimensions: Box<[(i64, i64)]>,
    /// How many elements the longest array around the part has. An array of arrays is one array, as `a[1][2]` is `a[1, 2]`.
    pub longest_array: u64,
    /// How many bytes of the tag's name are that of the tag as it is declared, and the type of that.
    pub declared: (usize, Type),
    /// How many bytes are the name of the tag of the program that it is in: for a tag in the state of a block that of the instance.
    pub root: usize,
}

impl Tag {
    /// The name of an element, by its index in the tag.
    pub fn element_name(&self, index: i64) -> String {
        match &self.column {
            Some(column) => element_name(&self.name, &column.dimensions, index),
            None => format!("{}[{index}]", self.name),
        }
    }
}

/// The name of an element of a column: each `[]` in the name of that is the place of an index.
pub fn element_name(column: &str, dimensions: &[(i64, i64)], index: i64) -> String {
    let mut indices = Vec::with_capacity(dimensions.len());
    if let &[_] = dimensions {
        indices.push(index);
    } else {
        let mut rest = index;
        for (first, last) in dimensions.iter().rev() {
            let count = last - first + 1;
            indices.push(first + rest.rem_euclid(count));
            rest = rest.div_euclid(count);
        }
        indices.reverse();
    }
    let mut parts = column.split("[]");
    let mut name = parts.next().unwrap_or_default().to_owned();
    // Two pairs of brackets in a row are one: `g[1, 2]`.
    let mut is_after_index = false;
    for (part, index) in parts.zip(indices) {
        if is_after_index {
            name.pop();
            name.push_str(&format!(", {index}]"));
        } else {
            name.push_str(&format!("[{index}]"));
        }
        name.push_str(part);
        is_after_index = part.is_empty();
    }
    name
}

/// Another name of a tag at a direct address.
#[derive(Debug, Clone, PartialEq, Eq, Hash)]
pub struct OtherName {
    /// As declared, with the file's stem before it where the name of a tag of that file has it.
    pub name: String,
    /// The tag.
    pub tag: TagId,
    /// The user-defined block whose body declares it.
    pub block: Option<usize>,
}

/// What is reported of a direct address in one place, and otherwise in another.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Disagreement {
    /// What is wrong and what to do.
    pub message: String,
    /// Where it is reported otherwise.
    pub location: Location,
}

/// A network, ready to run.
#[derive(Debug, Clone)]
pub struct Network {
    /// From its first rung to its last.
    pub location: Location,
    /// Its elements in the order of evaluation. A step's index is the number of the power that it gives.
    pub steps: Vec<Step>,
    /// The blocks on its rungs.
    pub blocks: Vec<Block>,
    /// What can be shown as live or dead, with the step whose power it carries.
    pub elements: Vec<Element>,
}

/// One step of a network's evaluation. Each gives one power, numbered by its index; it uses only powers of
/// steps before it.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Step {
    /// A segment begins: at the left rail with the rail's power, elsewhere with none.
    Start {
        /// Whether it begins with the line's `+`.
        rail: bool,
    },
    /// A block is evaluated; gives its ENO.
    Block {
        /// Index into [`Network::blocks`].
        block: usize,
        /// The step whose power is EN.
        en: usize,
    },
    /// A pair of connectors; gives the OR of both wires that enter it.
    Join {
        /// The power that comes along the upper line.
        upper: usize,
        /// The power that comes along the lower line.
        lower: usize,
    },
}

/// A part of the drawing that carries power.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Element {
    /// What it is.
    pub kind: ElementKind,
    /// Where it is drawn, in the network's file.
    pub range: TextRange,
    /// Index of the step whose power it shows: for a block the power that leaves it.
    pub step: usize,
}

/// What an [`Element`] is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum ElementKind {
    /// Dashes, or a comment that joins.
    Wire,
    /// `+`
    Rail,
    /// `\` or `/`
    Connector,
    /// A block.
    Block,
}

/// What a block on a rung is.
#[derive(Debug, Clone, Copy)]
pub enum BlockKind {
    /// A row of the instruction table.
    Instruction(&'static Instruction),
    /// A user-defined block: index into [`Program::blocks`].
    User(usize),
}

/// A block on a rung, with its operands.
#[derive(Debug, Clone)]
pub struct Block {
    /// What it is.
    pub kind: BlockKind,
    /// Where it is.
    pub location: Location,
    /// Its operands: those by place in their order, then named ones. For a user-defined block in the order of
    /// its parameters.
    pub arguments: Vec<Bound>,
    /// The type that it works in: the result's (`[ADD]` on INT), or the one that a comparison is made in
    /// (LINT for integers of different types, which compare by value). None where no type is chosen.
    pub works_in: Option<Scalar>,
    /// Of an unread part its operands as they are written.
    pub unread: Option<Box<str>>,
}

/// An argument with the operand that it is given for.
#[derive(Debug, Clone)]
pub struct Bound {
    /// The row's operand; none in a user-defined block.
    pub operand: Option<&'static Operand>,
    /// For a user-defined block the index of the parameter.
    pub parameter: Option<usize>,
    /// What is given.
    pub argument: Argument,
    /// Where it is.
    pub range: TextRange,
}

impl Bound {
    /// The places that it names, with where they are written.
    pub fn places(&self) -> Vec<(&Place, TextRange)> {
        let mut found = Vec::new();
        match &self.argument {
            Argument::Value(expression) => expression.each_read(&mut |place, at| found.push((place, at))),
            Argument::Place(place, _) => found.push((place, self.range)),
            _ => {}
        }
        found
    }
}
