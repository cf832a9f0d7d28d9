//! The names of the rules, their groups and default severities (LANGUAGE §7).

use std::fmt;

/// How much a finding matters.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Severity {
    /// Worth knowing.
    Info,
    /// Probably a mistake.
    Warning,
    /// The program is not simulated.
    Error,
}

impl Severity {
    /// `error`, `warning`, `info`.
    pub const fn name(self) -> &'static str {
        match self {
            Severity::Info => "info",
            Severity::Warning => "warning",
            Severity::Error => "error",
        }
    }
}

/// What a rule is about.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
#[allow(missing_docs)]
pub enum RuleGroup {
    Text,
    Connectors,
    Blocks,
    Names,
    Wiring,
    Program,
}

macro_rules! rules {
    ($($rule:ident $name:literal $group:ident $severity:ident;)+) => {
        /// A rule. Its name is stable: people write it in settings and in comments that switch it off.
        #[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
        #[allow(missing_docs)]
        pub enum Rule { $($rule),+ }

        impl Rule {
            /// Every rule, in the order of the reference.
            pub const ALL: &'static [Rule] = &[$(Rule::$rule),+];

            /// The name in kebab case.
            pub const fn name(self) -> &'static str {
                match self { $(Rule::$rule => $name),+ }
            }

            /// What it is about.
            pub const fn group(self) -> RuleGroup {
                match self { $(Rule::$rule => RuleGroup::$group),+ }
            }

            /// How much its findings matter unless set otherwise.
            pub const fn default_severity(self) -> Severity {
                match self { $(Rule::$rule => Severity::$severity),+ }
            }
        }
    };
}

rules! {
    UnclosedBlock "unclosed-block" Text Error;
    UnclosedComment "unclosed-comment" Text Error;
    UnexpectedCharacter "unexpected-character" Text Error;
    MissingWire "missing-wire" Text Warning;
    MisplacedRail "misplaced-rail" Text Error;
    BadLiteral "bad-literal" Text Error;
    BadDeclaration "bad-declaration" Text Error;
    UnpairedConnector "unpaired-connector" Connectors Error;
    MisleadingAlignment "misleading-alignment" Connectors Info;
    UnknownInstruction "unknown-instruction" Blocks Error;
    WrongShape "wrong-shape" Blocks Error;
    BadArity "bad-arity" Blocks Error;
    BadOperand "bad-operand" Blocks Error;
    TypeMismatch "type-mismatch" Blocks Error;
    LiteralOutOfRange "literal-out-of-range" Blocks Error;
    ConstantWrite "constant-write" Blocks Error;
    UndeclaredTag "undeclared-tag" Names Warning;
    DuplicateDeclaration "duplicate-declaration" Names Error;
    UnknownMember "unknown-member" Names Error;
    DuplicateTimer "duplicate-timer" Names Error;
    DuplicateCounter "duplicate-counter" Names Error;
    UnknownLabel "unknown-label" Names Error;
    DuplicateLabel "duplicate-label" Names Info;
    UnknownFunction "unknown-function" Names Error;
    DuplicateFunction "duplicate-function" Names Error;
    UnknownBlock "unknown-block" Names Error;
    DuplicateBlock "duplicate-block" Names Error;
    WrongPlace "wrong-place" Names Error;
    RecursiveBlock "recursive-block" Names Error;
    OpenWire "open-wire" Wiring Error;
    NoOutput "no-output" Wiring Warning;
    DoubleCoil "double-coil" Program Warning;
}

impl Rule {
    /// The rule of a name, compared to the letter.
    pub fn from_name(name: &str) -> Option<Rule> {
        Rule::ALL.iter().copied().find(|rule| rule.name() == name)
    }
}

impl fmt::Display for Rule {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}
