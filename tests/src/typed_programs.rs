//! Programs of any size that a user types into, and where: what an edit costs is measured and counted with them.

use std::fmt::Write as _;

/// What makes an edit dear.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Kind {
    /// Nothing: all is declared, and nothing is found.
    Clean,
    /// Every network has a warning.
    Warned,
    /// Every tag is in two networks.
    Shared,
    /// Every network names a tag twice: its boolean function is worked out.
    NamedTwice,
    /// Every network holds a user-defined block.
    UserBlocks,
    /// Every network names a tag that is not declared.
    Undeclared,
    /// Every other network names numbers that have their types from what they are compared with.
    Inferred,
    /// Every network names a tag for all files. Another file declares half of them, and of these half are in VAR_EXTERNAL.
    Globals,
    /// Every other network holds a user-defined block whose body names a tag for all files and a direct address.
    Bodies,
    /// Every input and output is declared at a direct address.
    Addressed,
    /// Every other network holds a user-defined block of another file.
    Library,
    /// Every other network resets what the one above it sets, in another case.
    Latched,
    /// A comment above every network switches a rule off, of which every other one finds nothing.
    Commented,
    /// Every other network reads what the next but one writes.
    Above,
    /// All networks are in functions, each of which jumps and returns.
    Flow,
}

/// All of them, by the names that people give.
pub const KINDS: [(&str, Kind); 15] = [
    ("clean", Kind::Clean),
    ("warned", Kind::Warned),
    ("shared", Kind::Shared),
    ("twice", Kind::NamedTwice),
    ("blocks", Kind::UserBlocks),
    ("undeclared", Kind::Undeclared),
    ("inferred", Kind::Inferred),
    ("globals", Kind::Globals),
    ("bodies", Kind::Bodies),
    ("addressed", Kind::Addressed),
    ("library", Kind::Library),
    ("latched", Kind::Latched),
    ("commented", Kind::Commented),
    ("above", Kind::Above),
    ("flow", Kind::Flow),
];

/// A program.
pub struct Program {
    /// Its text, laid out.
    pub text: String,
    /// The text of a file next to it, if there is one.
    pub next_to: Option<String>,
}

/// A letter that comes and goes.
#[derive(Clone, Copy, Debug)]
pub struct Spot {
    /// From 0.
    pub line: usize,
    /// In bytes, from 0.
    pub column: usize,
    /// What is typed there.
    pub letter: &'static str,
}

/// A block that holds what it was given.
const LATCH: &str = "FUNCTION_BLOCK [$LATCH]\nVAR_INPUT\n    off : BOOL;\nEND_VAR\nVAR_IN_OUT\n    held : BOOL;\nEND_VAR\n\
     +--\\--[ ]( EN )----\\--[/]( off )--( )( held )--+\n|  /--[ ]( held )--/                           |\nEND_FUNCTION_BLOCK\n\n";

/// A block whose body names a tag for all files, and a direct address.
const GUARD: &str = "VAR_GLOBAL\n    halted : BOOL;\nEND_VAR\n\nFUNCTION_BLOCK [$GUARD]\nVAR_OUTPUT\n    open : BOOL;\nEND_VAR\n\
     VAR\n    settle : TON;\nEND_VAR\n+--[ ]( EN )--[TON]( settle, T#7s )--[/]( halted )--[ ]( %IX0.0 )--( )( open )--+\n\
     END_FUNCTION_BLOCK\n\n+--[ ]( %IX0.1 )--( )( halted )--+\n\n";

impl Program {
    /// About this many rungs, aligned.
    pub fn new(kind: Kind, rungs: usize) -> Program {
        let mut sections: [String; 5] = Default::default();
        let mut next_to = String::new();
        let mut drawn = String::new();
        let mut calls = String::new();
        let networks = rungs / 2;
        for n in 0..networks {
            let next = (n + 1) % networks;
            let [inputs, outputs, inner, globals, external] = &mut sections;
            if kind == Kind::Addressed {
                let (byte, bit) = (n / 4, n % 4);
                let _ = writeln!(
                    inputs,
                    "    start_{n} AT %IX{byte}.{bit} : BOOL;\n    stop_{n} AT %IX{byte}.{} : BOOL;",
                    bit + 4
                );
                let _ = writeln!(
                    outputs,
                    "    run_{n} AT %QX{byte}.{bit} : BOOL;\n    ready_{n} AT %QX{byte}.{} : BOOL;",
                    bit + 4
                );
            } else {
                let _ = writeln!(inputs, "    start_{n}, stop_{n} : BOOL;");
                let _ = writeln!(outputs, "    run_{n}, ready_{n} : BOOL;");
            }
            let _ = writeln!(inner, "    timer_{n} : TON;");
            if matches!(kind, Kind::Warned | Kind::Commented | Kind::Above) {
                let _ = writeln!(inner, "    drive_{n} : BOOL;");
            }
            if kind == Kind::Globals {
                let here = if n % 2 == 0 { &mut *globals } else { &mut next_to };
                let _ = writeln!(here, "    enable_{n} : BOOL;");
                if n % 4 == 1 {
                    let _ = writeln!(external, "    enable_{n} : BOOL;");
                }
            }
            if kind == Kind::Flow && n % 4 == 0 {
                let _ = writeln!(calls, "+--<CALL>( work_{n} )--+\n");
                let _ = writeln!(
                    drawn,
                    "+--<FUN>( work_{n} )--+\n\n+--[ ]( stop_{} )--<JMP>( over )--+\n",
                    n + 1
                );
            }
            let _ = match kind {
                Kind::Clean | Kind::Addressed | Kind::Flow => writeln!(
                    drawn,
                    "+--[ ]( start_{n} )--[/]( stop_{n} )--[TON]( timer_{n}, T#5s )--( )( run_{n} )--+\n\n\
                     +--[P]( timer_{n}.Q )--( )( ready_{n} )--+\n"
                ),
                // A coil in front of a contact.
                Kind::Warned => writeln!(
                    drawn,
                    "+--[ ]( start_{n} )--( )( run_{n} )--[/]( stop_{n} )--( )( ready_{n} )--+\n\n\
                     +--[ ]( start_{n} )--( )( drive_{n} )--[TON]( timer_{n}, T#5s )--+\n"
                ),
                Kind::Shared => writeln!(
                    drawn,
                    "+--[ ]( start_{n} )--[/]( stop_{next} )--[TON]( timer_{n}, T#5s )--( )( run_{n} )--+\n\n\
                     +--[ ]( run_{n} )--[/]( stop_{n} )--[ ]( start_{next} )--( )( ready_{n} )--+\n"
                ),
                Kind::NamedTwice => writeln!(
                    drawn,
                    "+--\\--[ ]( start_{n} )--\\--[/]( stop_{n} )--[TON]( timer_{n}, T#5s )--( )( run_{n} )--+\n\
                     |  /--[ ]( run_{n} )----/                                                  |\n\n\
                     +--[ ]( start_{n} )--\\--[ ]( run_{n} )---\\--( )( ready_{n} )--+\n\
                     |                    /--[/]( start_{n} )--/                   |\n"
                ),
                Kind::UserBlocks | Kind::Library => writeln!(
                    drawn,
                    "+--[ ]( start_{n} )--[$LATCH]( stop_{n}, run_{n} )--+\n\n\
                     +--[ ]( run_{n} )--[TON]( timer_{n}, T#5s )--( )( ready_{n} )--+\n"
                ),
                Kind::Inferred => writeln!(
                    drawn,
                    "+--[GT]( start_{n}_level, 2.5 )--[MOV]( last_{n}, start_{n}_level )--[TON]( timer_{n}, T#5s )--( )( run_{n} )--+\n\n\
                     +--[ ]( start_{n} )--[/]( stop_{n} )--[LT]( last_{n}, least_{n} )--( )( ready_{n} )--+\n"
                ),
                Kind::Globals => writeln!(
                    drawn,
                    "+--[ ]( start_{n} )--[/]( stop_{n} )--[TON]( timer_{n}, T#5s )--( )( enable_{n} )--+\n\n\
                     +--[ ]( enable_{n} )--[P]( timer_{n}.Q )--( )( run_{n} )--( )( ready_{n} )--+\n"
                ),
                Kind::Bodies => writeln!(
                    drawn,
                    "+--[ ]( start_{n} )--[/]( stop_{n} )--[$GUARD]( run_{n} )--+\n\n\
                     +--[ ]( run_{n} )--[TON]( timer_{n}, T#5s )--( )( ready_{n} )--+\n"
                ),
                Kind::Latched => writeln!(
                    drawn,
                    "+--[ ]( start_{n} )--[ ]( stop_{n} )--(S)( run_{n} )--[TON]( timer_{n}, T#5s )--( )( ready_{n} )--+\n\n\
                     +--[/]( start_{n} )--[ ]( stop_{n} )--(R)( run_{n} )--+\n"
                ),
                Kind::Commented => writeln!(
                    drawn,
                    "# ladder: allow(contact-after-coil): both on one rung #\n\
                     +--[ ]( start_{n} )--( )( run_{n} )--[/]( stop_{n} )--( )( ready_{n} )--+\n\n\
                     # ladder: allow(double-coil): for tests #\n\
                     +--[ ]( start_{n} )--( )( drive_{n} )--[TON]( timer_{n}, T#5s )--+\n"
                ),
                // The last of them begins no circle.
                Kind::Above => writeln!(
                    drawn,
                    "+--[ ]( start_{n} )--[/]( {} )--[TON]( timer_{n}, T#5s )--( )( drive_{n} )--+\n\n\
                     +--[P]( timer_{n}.Q )--[ ]( stop_{n} )--( )( run_{n} )--( )( ready_{n} )--+\n",
                    if next == 0 {
                        format!("stop_{n}")
                    } else {
                        format!("drive_{next}")
                    }
                ),
                Kind::Undeclared => writeln!(
                    drawn,
                    "+--[ ]( start_{n} )--[/]( stop_{n} )--[TON]( timer_{n}, T#5s )--( )( drive_{n} )--+\n\n\
                     +--[ ]( gate_{n} )--( )( run_{n} )--( )( ready_{n} )--+\n"
                ),
            };
            if kind == Kind::Flow && n % 4 == 2 {
                drawn += "+--<LBL>( over )--+\n\n";
            } else if kind == Kind::Flow && n % 4 == 3 {
                drawn += "+--<RET>--+\n\n";
            }
        }
        let [inputs, outputs, inner, globals, external] = sections;
        let globals = if kind == Kind::Globals {
            format!("VAR_GLOBAL\n{globals}END_VAR\nVAR_EXTERNAL\n{external}END_VAR\n")
        } else {
            globals
        };
        let blocks = match kind {
            Kind::UserBlocks => LATCH,
            Kind::Bodies => GUARD,
            _ => "",
        };
        let text = format!(
            "{blocks}{globals}VAR_INPUT\n{inputs}END_VAR\nVAR_OUTPUT\n{outputs}END_VAR\nVAR\n{inner}END_VAR\n\n{calls}{drawn}"
        );
        let globals = format!("VAR_GLOBAL\n{next_to}END_VAR\n\n+--[ ]( enable_0 )--( )( enable_1 )--+\n");
        Program {
            next_to: match kind {
                Kind::Globals => Some(globals),
                Kind::Library => Some(LATCH.to_owned()),
                _ => None,
            },
            text: ladder_format::format_text(&text, &ladder_format::Options::default()),
        }
    }

    /// After a word on the line in the middle of those that hold it.
    fn after(&self, word: &str, wanted: impl Fn(&str) -> bool) -> Spot {
        let lines = self.text.lines().enumerate();
        let all: Vec<(usize, &str)> = lines.filter(|(_, line)| wanted(line)).collect();
        let (line, row) = all[all.len() / 2];
        let column = row.find(word).expect("the word is on the line") + word.len();
        Spot {
            line,
            column,
            letter: "5",
        }
    }

    /// In a name of which no place says the type: before a point, or in a comparison.
    pub fn in_a_name_without_type(&self) -> Spot {
        let with_member = |line: &str| line.contains("( timer_") && line.contains(".Q");
        let compared = |line: &str| line.contains("( last_");
        if self.text.lines().any(with_member) {
            self.after("( timer_", with_member)
        } else if self.text.lines().any(compared) {
            self.after("( last_", compared)
        } else {
            self.in_a_name()
        }
    }

    /// In the name of a tag for all files, which then is another tag.
    pub fn in_a_global(&self) -> Spot {
        let is_it = |line: &str| line.starts_with('+') && line.contains("( enable_");
        self.after("( enable_", is_it)
    }

    /// In the name of a declaration for all files.
    pub fn in_a_declaration_for_all(&self) -> Spot {
        // Every other one is declared here.
        let is_here = |name: &str| name.ends_with(['0', '2', '4', '6', '8']);
        self.after("    enable_", |line| {
            let name = line.trim_start().split([' ', ':']).next();
            line.starts_with("    enable_") && name.is_some_and(is_here)
        })
    }

    /// In the number of a preset: the program stays clean.
    pub fn in_a_number(&self) -> Spot {
        self.after("T#5", |line| line.contains("T#5"))
    }

    /// In the number of a preset in a block's body, next to names of tags that the file declares.
    pub fn in_a_body(&self) -> Spot {
        self.after("T#7", |line| line.contains("T#7"))
    }

    /// In the name of an operand, which then is not declared.
    pub fn in_a_name(&self) -> Spot {
        self.after("( start", |line| {
            line.starts_with('+') && line.contains("( start")
        })
    }

    /// In the middle of an operand: with it nothing can be read to the end of the rung.
    pub fn half_typed(&self) -> Spot {
        let spot = self.in_a_number();
        Spot { letter: "(", ..spot }
    }

    /// In the name of an operand of the first network.
    pub fn in_the_first_network(&self) -> Spot {
        let lines = self.text.lines().enumerate();
        let ends = lines.filter(|(_, line)| *line == "END_VAR");
        let drawn = ends.last().map_or(0, |(line, _)| line);
        let mut below = self.text.lines().enumerate().skip(drawn);
        let (line, row) = below
            .find(|(_, line)| line.contains("( start"))
            .expect("a network is below the declarations");
        let column = row.find("( start").map_or(0, |at| at + "( start".len());
        Spot {
            line,
            column,
            letter: "5",
        }
    }

    /// A network with a label, between two networks.
    pub fn with_a_label(&self) -> Spot {
        let spot = self.after("", str::is_empty);
        Spot {
            letter: "+--<LBL>( here )--[ ]( start_0 )--( )( run_1 )--+\n\n",
            ..spot
        }
    }

    /// A line of declarations.
    pub fn with_a_declaration(&self) -> Spot {
        let spot = self.after("", |line| line.starts_with("    start"));
        Spot {
            letter: "    fresh : BOOL;\n",
            ..spot
        }
    }

    /// In the address of a declaration, which then is another one, if there are addresses.
    pub fn in_an_address(&self) -> Spot {
        let spot = self.after("AT %IX", |line| line.starts_with("    start"));
        Spot { letter: "9", ..spot }
    }

    /// A line of declarations at an address that no other has.
    pub fn with_an_address(&self) -> Spot {
        let spot = self.with_a_declaration();
        Spot {
            letter: "    fresh AT %IW60000 : INT;\n",
            ..spot
        }
    }

    /// In the name of a declaration, which then is that of another one.
    pub fn in_a_name_declared_twice(&self) -> Spot {
        let is_it = |line: &str| line.starts_with("    start_1,") || line.starts_with("    start_1 ");
        let spot = self.after("    start_1", is_it);
        Spot { letter: "0", ..spot }
    }

    /// A line of declarations of names that others declare above it and below.
    pub fn with_names_declared_twice(&self) -> Spot {
        Spot {
            letter: "    start_0, run_1 : BOOL;\n",
            ..self.with_a_declaration()
        }
    }

    /// In the type of a declaration, which then is none.
    pub fn in_a_type(&self) -> Spot {
        let line = |line: &str| line.starts_with("    start") && line.contains("BOOL");
        self.after("BOO", line)
    }

    /// The beginning of a line of declarations.
    pub fn with_a_half_typed_declaration(&self) -> Spot {
        let spot = self.with_a_declaration();
        Spot {
            letter: "    fresh\n",
            ..spot
        }
    }

    /// In the name of a declaration.
    pub fn in_a_declaration(&self) -> Spot {
        self.after("    start", |line| line.starts_with("    start"))
    }
}
