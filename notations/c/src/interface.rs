//! What of a program is in the structures of inputs and outputs.

use crate::names::Names;
use ladder_analysis::program::{Program, Role, Tag};
use ladder_analysis::values::types::Scalar;
use ladder_simulator::compiled::{Compiled, Home, Instr};
use std::collections::HashSet;

/// A member of a structure.
#[derive(Debug, Clone)]
pub(crate) struct Field {
    pub(crate) name: String,
    /// As the program calls it, and of which type.
    pub(crate) meaning: String,
    pub(crate) ty: &'static str,
    pub(crate) home: Home,
    /// Elements, of an array.
    pub(crate) count: Option<u32>,
    /// Room of a text.
    pub(crate) room: Option<u16>,
    pub(crate) scalar: Scalar,
}

/// What a caller gives and takes.
#[derive(Debug, Default)]
pub(crate) struct Interface {
    pub(crate) inputs: Vec<Field>,
    pub(crate) outputs: Vec<Field>,
    /// Every other tag with its place in the memory: its name as a constant, and the place.
    pub(crate) others: Vec<Field>,
}

/// Of a program that has no outputs, what it writes is one.
pub(crate) fn interface(library: &str, program: &Program, compiled: &Compiled) -> Interface {
    let tags = || {
        program
            .tags
            .iter()
            .zip(&compiled.homes)
            .filter(|(tag, _)| tag.block.is_none())
    };
    let declares = tags().any(|(tag, _)| tag.role == Role::Output);
    let written = written(compiled);
    let mut interface = Interface::default();
    let [mut inputs, mut outputs, mut others] = [(); 3].map(|()| Names::of_members(library));
    for (tag, home) in tags() {
        let is_written = || match home {
            Home::Bits { at, .. } => written.contains(&(0, at.0)),
            Home::Words { at, .. } => written.contains(&(1, at.0)),
            _ => false,
        };
        let is_output = if declares || tag.constant {
            tag.role == Role::Output
        } else {
            is_written()
        };
        if tag.is_input {
            interface.inputs.extend(field(tag, *home, &mut inputs));
        }
        if is_output {
            interface.outputs.extend(field(tag, *home, &mut outputs));
        }
        if !tag.is_input && !is_output {
            interface.others.extend(field(tag, *home, &mut others));
        }
    }
    interface
}

/// The tags' slots that the program writes: bits as 0, words as 1.
fn written(compiled: &Compiled) -> HashSet<(u8, u32)> {
    let mut written = HashSet::new();
    for instr in &compiled.code.instrs {
        match *instr {
            Instr::Coil { tag, .. }
            | Instr::NegatedCoil { tag, .. }
            | Instr::Set { tag, .. }
            | Instr::Reset { tag, .. } => {
                written.insert((0, tag.0));
            }
            Instr::MoveBit { to, .. }
            | Instr::AndBit { to, .. }
            | Instr::OrBit { to, .. }
            | Instr::XorBit { to, .. }
            | Instr::NotBit { to, .. }
            | Instr::LoadBit { to, .. } => {
                written.insert((0, to.0));
            }
            Instr::Move { to, .. }
            | Instr::MoveWhen { to, .. }
            | Instr::Integer { to, .. }
            | Instr::IntegerWhen { to, .. }
            | Instr::Real { to, .. }
            | Instr::RealWhen { to, .. }
            | Instr::RealFunction { to, .. }
            | Instr::Convert { to, .. }
            | Instr::BitToWord { to, .. }
            | Instr::Turn { to, .. }
            | Instr::LoadWord { to, .. } => {
                written.insert((1, to.0));
            }
            Instr::StoreBitOf { word, .. } => {
                written.insert((1, word.0));
            }
            _ => {}
        }
    }
    // What is indexed while scanning may be written so.
    for array in &compiled.code.arrays {
        written.extend([(0, array.base), (1, array.base)]);
    }
    written
}

fn field(tag: &Tag, home: Home, names: &mut Names) -> Option<Field> {
    let scalar = match tag.ty {
        ladder_analysis::values::types::Type::Scalar(scalar) => scalar,
        ladder_analysis::values::types::Type::Array { element, .. } => element,
        _ => return None,
    };
    let is_array = matches!(tag.ty, ladder_analysis::values::types::Type::Array { .. });
    let (len, room) = match home {
        Home::Bits { len, .. } | Home::Words { len, .. } => (len, None),
        Home::Texts { len, max, .. } => (len, Some(max)),
        _ => return None,
    };
    Some(Field {
        name: names.name(&tag.name),
        meaning: format!("{} : {}", tag.name, tag.ty),
        ty: c_type(scalar),
        home,
        count: is_array.then_some(len),
        room,
        scalar,
    })
}

/// The type of C that holds a value. TIME and dates are nanoseconds.
fn c_type(scalar: Scalar) -> &'static str {
    match scalar {
        Scalar::Bool => "bool",
        Scalar::Sint => "int8_t",
        Scalar::Int => "int16_t",
        Scalar::Dint => "int32_t",
        Scalar::Usint | Scalar::Byte => "uint8_t",
        Scalar::Uint | Scalar::Word => "uint16_t",
        Scalar::Udint | Scalar::Dword => "uint32_t",
        Scalar::Ulint | Scalar::Lword => "uint64_t",
        Scalar::Real => "float",
        Scalar::Lreal => "double",
        Scalar::String(_) => "char",
        _ => "int64_t",
    }
}

impl Field {
    /// Its declaration in a structure.
    pub(crate) fn declaration(&self) -> String {
        let elements = self.count.map_or(String::new(), |count| format!("[{count}]"));
        let room = self
            .room
            .map_or(String::new(), |room| format!("[{}]", u32::from(room) + 1));
        format!(
            "    {} {}{elements}{room}; /* {} */\n",
            self.ty,
            self.name,
            crate::header::comment(&self.meaning)
        )
    }

    /// The statements that copy it from a structure to the memory.
    pub(crate) fn take(&self) -> String {
        let from = format!("self->in.{}", self.name);
        self.each(|slot, index| match self.home {
            Home::Bits { .. } => format!("self->b[{slot}] = {from}{index};"),
            Home::Words { .. } if self.scalar.is_real() => {
                format!("self->w[{slot}] = to_word((double){from}{index});")
            }
            Home::Words { .. } => format!("self->w[{slot}] = (int64_t){from}{index};"),
            _ => format!("set_text(self, {slot}, (const uint8_t *){from}{index}, strlen({from}{index}));"),
        })
    }

    /// The other way round.
    pub(crate) fn put(&self) -> String {
        let to = format!("self->out.{}", self.name);
        self.each(|slot, index| match self.home {
            Home::Bits { .. } => format!("{to}{index} = self->b[{slot}] != 0;"),
            Home::Words { .. } if self.scalar.is_real() => {
                format!("{to}{index} = ({})to_real(self->w[{slot}]);", self.ty)
            }
            Home::Words { .. } => format!("{to}{index} = ({})self->w[{slot}];", self.ty),
            _ => format!(
                "memcpy({to}{index}, text_of(self, {slot}), self->length[{slot}]); {to}{index}[self->length[{slot}]] = 0;"
            ),
        })
    }

    /// The statements that show in a structure of inputs what the memory holds.
    pub(crate) fn show(&self) -> String {
        self.put().replace("self->out.", "self->in.")
    }

    /// A statement for each element.
    fn each(&self, statement: impl Fn(&str, &str) -> String) -> String {
        let at = match self.home {
            Home::Bits { at, .. } => at.0,
            Home::Words { at, .. } => at.0,
            Home::Texts { at, .. } => at.0,
            _ => return String::new(),
        };
        match self.count {
            Some(count) => format!(
                "    for (n = 0; n < {count}; n++) {{ {} }}\n",
                statement(&format!("{at} + n"), "[n]")
            ),
            None => format!("    {}\n", statement(&at.to_string(), "")),
        }
    }

    /// The pieces of the runtime that copying needs.
    pub(crate) fn needs(&self) -> &'static [&'static str] {
        match self.home {
            Home::Texts { .. } => &["set_text", "text_of"],
            Home::Words { .. } if self.scalar.is_real() => &["to_real", "to_word"],
            _ => &[],
        }
    }
}
