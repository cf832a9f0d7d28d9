//! Networks as the archive of the editor: its own objects with all their fields, in its order, and the types of them.

use super::tree::{Call, Item, Network, Target, Tree};
use ladder_notation::xml::escape;
use std::collections::BTreeSet;

/// The types of objects, each with what it is called in the list of types.
const TYPES: [(&str, &str); 16] = [
    ("Boolean", "System.Boolean"),
    ("BoxTreeAssign", "{9873c309-1f09-4ebf-9078-42d8057ef11b}"),
    ("BoxTreeBox", "{acfc6f68-8e3a-4af5-bf81-3dd512095a46}"),
    ("BoxTreeDemux", "{b1d55618-017c-4bc5-990a-55c2f27d9d3a}"),
    ("BoxTreeOperand", "{9de7f100-1b87-424c-a62e-45b0cfc85ed2}"),
    ("BoxTreeTerminator", "{5f9848d3-568d-4cc5-9e31-8e28e9607ff1}"),
    ("Flags", "{668066f2-6069-46b3-8962-8db8d13d7db2}"),
    ("Int32", "System.Int32"),
    ("Int64", "System.Int64"),
    ("Network", "{d9a99d73-b633-47db-b876-a752acb25871}"),
    (WHOLE, "{25e509de-33d4-4447-93f8-c9e4ea381c8b}"),
    ("Operand", "{c9b2f165-48a2-4a45-8326-3952d8a3d708}"),
    ("Operator", "{bffb3c53-f105-4e85-aba2-e30df579d75f}"),
    ("OutputItemList", "{f40d3e09-c02c-4522-a88c-dac23558cfc4}"),
    ("ParamList", "{71496971-9e0c-4677-a832-b9583b571130}"),
    ("String", "System.String"),
];

/// Those that stand in every archive.
const ALWAYS: [&str; 5] = ["Boolean", "Int32", "Int64", WHOLE, "String"];

/// What holds all networks.
const WHOLE: &str = "NWLImplementationObject";

/// The functions of a library: the inputs of all others, which are operators, have no names.
const FUNCTIONS: [&str; 9] = [
    "LEN", "LEFT", "RIGHT", "MID", "CONCAT", "INSERT", "DELETE", "REPLACE", "FIND",
];

/// The element `NWL` of a unit; `wire` is a number that no wire has.
pub(super) fn body(networks: &[Network], wire: usize) -> String {
    let mut archive = Archive {
        out: String::new(),
        depth: 3,
        id: 0,
        types: BTreeSet::from(ALWAYS),
    };
    archive.line("<XmlArchive>");
    archive.inside(|archive| {
        archive.line("<Data>");
        archive.inside(|archive| archive.whole(networks, wire));
        archive.line("</Data>");
        archive.line("<TypeList>");
        let used = TYPES.iter().filter(|(name, _)| archive.types.contains(name));
        let used: Vec<String> = used
            .map(|(name, what)| format!("<Type n=\"{name}\">{what}</Type>"))
            .collect();
        archive.inside(|archive| {
            for line in &used {
                archive.line(line);
            }
        });
        archive.line("</TypeList>");
    });
    archive.line("</XmlArchive>");
    archive.out
}

/// The file on its way.
struct Archive {
    out: String,
    depth: usize,
    /// The last number that an object got.
    id: u64,
    types: BTreeSet<&'static str>,
}

impl Archive {
    fn line(&mut self, line: &str) {
        self.out.extend(std::iter::repeat_n("  ", self.depth + 1));
        self.out.push_str(line);
        self.out.push('\n');
    }

    fn inside(&mut self, inside: impl FnOnce(&mut Archive)) {
        self.depth += 1;
        inside(self);
        self.depth -= 1;
    }

    /// A field that holds a text.
    fn text(&mut self, name: &str, text: &str) {
        let mut escaped = String::new();
        // The signs around a text are its ends, and nothing stands for one inside.
        escape(&mut escaped, &text.replace('"', "'"));
        self.line(&format!("<v n=\"{name}\">\"{escaped}\"</v>"));
    }

    fn value(&mut self, name: &str, value: impl ToString) {
        self.line(&format!("<v n=\"{name}\">{}</v>", value.to_string()));
    }

    fn nothing(&mut self, name: &str) {
        self.line(&format!("<n n=\"{name}\" />"));
    }

    fn id(&mut self) {
        self.id += 1;
        self.value("Id", format!("{}L", self.id));
    }

    /// An object: in a field, or in a list that says its type for it.
    fn object(&mut self, field: Option<&str>, ty: Option<&'static str>, inside: impl FnOnce(&mut Archive)) {
        let field = field.map(|field| format!(" n=\"{field}\"")).unwrap_or_default();
        let told = ty.map(|ty| format!(" t=\"{ty}\"")).unwrap_or_default();
        self.types.extend(ty);
        self.line(&format!("<o{field}{told}>"));
        self.inside(inside);
        self.line("</o>");
    }

    /// A list of objects. The list has their type where all are of one.
    fn list<T>(
        &mut self,
        field: &str,
        items: &[T],
        ty: impl Fn(&T) -> Option<&'static str>,
        write: impl Fn(&mut Archive, &T, Option<&'static str>),
    ) {
        if items.is_empty() {
            self.line(&format!("<l2 n=\"{field}\" />"));
            return;
        }
        let mut known = items.iter().filter_map(&ty);
        let first = known.next();
        let common = first.filter(|first| known.all(|other| other == *first));
        self.types.extend(common);
        let told = common.map(|ty| format!(" cet=\"{ty}\"")).unwrap_or_default();
        self.line(&format!("<l2 n=\"{field}\"{told}>"));
        self.inside(|archive| {
            for item in items {
                match ty(item) {
                    Some(own) => write(archive, item, common.is_none().then_some(own)),
                    None => archive.line("<n />"),
                }
            }
        });
        self.line("</l2>");
    }

    fn words(&mut self, field: &str, words: &[&str]) {
        let write = |archive: &mut Archive, word: &&str, _: Option<&'static str>| {
            let mut escaped = String::new();
            escape(&mut escaped, word);
            archive.line(&format!("<v>{escaped}</v>"));
        };
        self.list(field, words, |_| Some("String"), write);
    }

    fn whole(&mut self, networks: &[Network], wire: usize) {
        self.line(&format!("<o xml:space=\"preserve\" t=\"{WHOLE}\">"));
        self.inside(|archive| {
            archive.text("NetworkListComment", "");
            archive.text("DefaultViewMode", "Ld");
            archive.list("NetworkList", networks, |_| Some("Network"), Archive::network);
            archive.value("BranchCounter", wire);
            archive.value("ValidIds", true);
        });
        self.line("</o>");
    }

    fn network(&mut self, network: &Network, ty: Option<&'static str>) {
        self.object(None, ty, |archive| {
            for name in ["ILActive", "FBDValid", "ILValid"] {
                archive.value(name, false);
            }
            archive.line("<l2 n=\"ILLines\" />");
            archive.text("Comment", &network.comment);
            archive.text("Title", "");
            archive.text("Label", &network.label);
            archive.value("OutCommented", false);
            let of_item = |item: &Item| match item {
                Item::Assign(..) => Some("BoxTreeAssign"),
                Item::Tree(tree) => Some(of_tree(tree)),
            };
            archive.list("NetworkItems", &network.items, of_item, Archive::item);
            archive.line("<l2 n=\"Connectors\" />");
            archive.id();
        });
    }

    fn item(&mut self, item: &Item, ty: Option<&'static str>) {
        let (targets, tree) = match item {
            Item::Assign(targets, tree) => (targets, tree),
            Item::Tree(tree) => return self.tree(tree, None, ty),
        };
        self.object(None, ty, |archive| {
            archive.object(Some("OutputItems"), Some("OutputItemList"), |archive| {
                let write = |archive: &mut Archive, target: &Target, ty| {
                    let ty_there = if target.is_boolean { "BOOL" } else { "" };
                    let flags = [true, target.is_boolean, false];
                    archive.object(None, ty, |archive| {
                        archive.operand(Some(&target.text), ty_there, target.flags, flags);
                    });
                };
                archive.list("OutputItems", targets, |_| Some("Operand"), write);
            });
            archive.flags(0, false);
            archive.tree(tree, Some("RValue"), Some(of_tree(tree)));
            archive.id();
        });
    }

    fn flags(&mut self, flags: u32, is_fixed: bool) {
        self.object(Some("Flags"), Some("Flags"), |archive| {
            archive.value("Flags", flags);
            archive.value("Fixed", is_fixed);
            archive.value("Extensible", false);
        });
    }

    /// The fields of an operand; the last are whether it is written, whether it is a contact or coil, and whether an instance.
    fn operand(&mut self, text: Option<&str>, ty: &str, flags: u32, is: [bool; 3]) {
        match text {
            Some(text) => self.text("Operand", text),
            None => self.nothing("Operand"),
        }
        self.text("Type", ty);
        for name in ["Comment", "SymbolComment", "Address"] {
            self.text(name, "");
        }
        let [is_written, is_boolean, is_instance] = is;
        self.flags(flags, is_boolean);
        self.value("LValue", is_written);
        self.value("Boolean", is_boolean);
        self.value("IsInstance", is_instance);
        self.id();
    }

    fn tree(&mut self, tree: &Tree, field: Option<&str>, ty: Option<&'static str>) {
        self.object(field, ty, |archive| match tree {
            Tree::Rail => {
                archive.nothing("Input");
                archive.flags(0, false);
                archive.id();
            }
            Tree::Operand(operand) => {
                let ty = if operand.is_boolean { "BOOL" } else { "" };
                archive.object(Some("Operand"), Some("Operand"), |archive| {
                    let is = [false, operand.is_boolean, false];
                    archive.operand(Some(&operand.text), ty, operand.flags, is);
                });
                archive.id();
            }
            Tree::Wire(number, input) => {
                archive.value("VarId", number);
                match input {
                    Some(input) => archive.tree(input, Some("Input"), Some(of_tree(input))),
                    None => archive.nothing("Input"),
                }
                archive.id();
            }
            Tree::Box(call) => archive.call(call),
        });
    }

    fn call(&mut self, call: &Call) {
        self.text("BoxType", &call.name);
        self.object(Some("Instance"), Some("Operand"), |archive| {
            archive.operand(call.instance.as_deref(), "", 0, [false, false, true]);
        });
        self.object(Some("OutputItems"), Some("OutputItemList"), |archive| {
            let write = |archive: &mut Archive, (_, taker): &(String, Option<String>), ty| {
                archive.object(None, ty, |archive| {
                    archive.operand(taker.as_deref(), "", 0, [true, false, false]);
                });
            };
            let of_output = |(_, taker): &(String, Option<String>)| taker.as_ref().map(|_| "Operand");
            archive.list("OutputItems", &call.outputs, of_output, write);
        });
        self.flags(0, call.instance.is_some());
        self.nothing("InputFlags");
        let of_input = |(_, tree): &(String, Tree)| Some(of_tree(tree));
        self.list("InputItems", &call.inputs, of_input, |archive, (_, tree), ty| {
            archive.tree(tree, None, ty);
        });
        let is_operator = call.instance.is_none() && !FUNCTIONS.contains(&call.name.as_str());
        let given = call.inputs.iter().map(|(name, _)| name.as_str());
        let given: Vec<&str> = given.filter(|name| !is_operator || *name == "EN").collect();
        self.parameters("InputParam", &given);
        let outputs: Vec<&str> = call.outputs.iter().map(|(name, _)| name.as_str()).collect();
        self.parameters("OutputParam", &outputs);
        let kind = match &call.instance {
            Some(_) => Some("FunctionBlock".to_owned()),
            None => Some(capitalised(&call.name)).filter(|name| is_operator && !name.contains('_')),
        };
        if let Some(kind) = kind {
            self.types.insert("Operator");
            self.line(&format!("<v n=\"CallType\" t=\"Operator\">{kind}</v>"));
        }
        for name in ["EN", "ENO"] {
            if call.is_gate() {
                self.nothing(name);
            } else {
                self.value(name, call.has_enable());
            }
        }
        self.nothing("STSnippet");
        self.value("ContainsExtensibleInputs", false);
        self.value("ProvidesSTSnippet", false);
        self.id();
    }

    fn parameters(&mut self, field: &str, names: &[&str]) {
        self.object(Some(field), Some("ParamList"), |archive| {
            archive.words("Names", names);
            // The editor finds the types by itself.
            archive.words("Types", &vec![""; names.len()]);
        });
    }
}

fn of_tree(tree: &Tree) -> &'static str {
    match tree {
        Tree::Rail => "BoxTreeTerminator",
        Tree::Operand(_) => "BoxTreeOperand",
        Tree::Wire(..) => "BoxTreeDemux",
        Tree::Box(_) => "BoxTreeBox",
    }
}

/// `Move` of `MOVE`.
fn capitalised(name: &str) -> String {
    let (first, rest) = name.split_at(1);
    format!("{first}{}", rest.to_ascii_lowercase())
}
