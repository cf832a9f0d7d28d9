//! The body of a unit as the editor of TwinCAT has it: networks, each a list of trees.

/// A network.
#[derive(Debug, Default)]
pub(super) struct Network {
    pub(super) comment: String,
    pub(super) label: String,
    pub(super) items: Vec<Item>,
}

/// What is in a network by itself.
#[derive(Debug)]
pub(super) enum Item {
    /// Coils, or a jump, and the power that they have.
    Assign(Vec<Target>, Tree),
    /// A box, or a wire that begins here.
    Tree(Tree),
}

/// What takes power or a value.
#[derive(Debug)]
pub(super) struct Target {
    pub(super) text: String,
    pub(super) flags: u32,
    /// It is a coil.
    pub(super) is_boolean: bool,
}

impl Target {
    /// A variable that takes a value.
    pub(super) fn variable(text: String) -> Target {
        Target {
            text,
            flags: 0,
            is_boolean: false,
        }
    }
}

/// Power or a value.
#[derive(Debug)]
pub(super) enum Tree {
    /// The left rail.
    Rail,
    /// A contact, or a value at a pin.
    Operand(Target),
    Box(Box<Call>),
    /// A wire with its number; with what feeds it where it begins.
    Wire(usize, Option<Box<Tree>>),
}

/// A box.
#[derive(Debug)]
pub(super) struct Call {
    pub(super) name: String,
    /// Of a function block.
    pub(super) instance: Option<String>,
    /// With the names of the pins.
    pub(super) inputs: Vec<(String, Tree)>,
    /// The outputs, with the variables that take them.
    pub(super) outputs: Vec<(String, Option<String>)>,
}

impl Call {
    /// Whether it does not run without power.
    pub(super) fn has_enable(&self) -> bool {
        self.inputs.first().is_some_and(|(name, _)| name == "EN")
    }

    /// Whether it is contacts in series or branches.
    pub(super) fn is_gate(&self) -> bool {
        matches!(self.name.as_str(), "AND" | "OR") && !self.has_enable()
    }
}

impl Tree {
    /// `AND` or `OR` of these: one box, where there are boxes of that name among them; of one, that.
    pub(super) fn gate(name: &str, mut parts: Vec<Tree>) -> Tree {
        if parts.len() == 1 {
            return parts.remove(0);
        }
        let mut inputs = Vec::new();
        for part in parts {
            match part {
                Tree::Box(call) if call.is_gate() && call.name == name => inputs.extend(call.inputs),
                other => inputs.push((String::new(), other)),
            }
        }
        Tree::Box(Box::new(Call {
            name: name.to_owned(),
            instance: None,
            inputs,
            outputs: Vec::new(),
        }))
    }
}
