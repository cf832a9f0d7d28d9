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

impl RuleGroup {
    /// All of them, in the order of the reference.
    pub const ALL: [RuleGroup; 6] = [
        RuleGroup::Text,
        RuleGroup::Connectors,
        RuleGroup::Blocks,
        RuleGroup::Names,
        RuleGroup::Wiring,
        RuleGroup::Program,
    ];

    /// The heading that its rules are under.
    pub const fn title(self) -> &'static str {
        match self {
            RuleGroup::Text => "Text",
            RuleGroup::Connectors => "Connectors",
            RuleGroup::Blocks => "Blocks",
            RuleGroup::Names => "Names",
            RuleGroup::Wiring => "Wiring",
            RuleGroup::Program => "The program",
        }
    }
}

macro_rules! rules {
    ($($rule:ident $name:literal $group:ident $severity:ident $($off:ident)?;)+) => {
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

            /// Whether it looks for findings unless set otherwise. What is a matter of taste is off.
            pub const fn on_by_default(self) -> bool {
                match self { $(Rule::$rule => rules!(@on $($off)?)),+ }
            }
        }
    };
    (@on) => { true };
    (@on off) => { false };
}

rules! {
    UnclosedBlock "unclosed-block" Text Error;
    UnclosedComment "unclosed-comment" Text Error;
    UnexpectedCharacter "unexpected-character" Text Error;
    MissingWire "missing-wire" Text Warning;
    MisplacedRail "misplaced-rail" Text Error;
    BadLiteral "bad-literal" Text Error;
    BadDeclaration "bad-declaration" Text Error;
    BadDirective "bad-directive" Text Warning;
    SuppressionUnused "suppression-unused" Text Info;
    UnpairedConnector "unpaired-connector" Connectors Error;
    MisleadingAlignment "misleading-alignment" Connectors Info;
    UnknownInstruction "unknown-instruction" Blocks Error;
    WrongShape "wrong-shape" Blocks Error;
    BadArity "bad-arity" Blocks Error;
    BadOperand "bad-operand" Blocks Error;
    TypeMismatch "type-mismatch" Blocks Error;
    LiteralOutOfRange "literal-out-of-range" Blocks Error;
    ConstantWrite "constant-write" Blocks Error;
    AlternativeMnemonic "alternative-mnemonic" Blocks Info off;
    ResultArrow "result-arrow" Blocks Info;
    RealEquality "real-equality" Blocks Warning;
    DivisionByZero "division-by-zero" Blocks Warning;
    ShortPreset "short-preset" Blocks Warning;
    AmbiguousSign "ambiguous-sign" Blocks Info;
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
    RecursiveCall "recursive-call" Names Warning;
    OverlappingAddress "overlapping-address" Names Warning;
    InputWritten "input-written" Names Warning;
    OpenWire "open-wire" Wiring Error;
    RungNotPowered "rung-not-powered" Wiring Warning;
    DeadEnd "dead-end" Wiring Warning;
    NoOutput "no-output" Wiring Warning;
    ShortedBranch "shorted-branch" Wiring Warning;
    DuplicateBranch "duplicate-branch" Wiring Warning;
    ConstantPower "constant-power" Wiring Warning;
    RedundantElement "redundant-element" Wiring Warning;
    ContactAfterCoil "contact-after-coil" Wiring Warning;
    LatchedPower "latched-power" Wiring Info;
    ComplexNetwork "complex-network" Wiring Info off;
    DoubleCoil "double-coil" Program Warning;
    SetAndReset "set-and-reset" Program Warning;
    SetWithoutReset "set-without-reset" Program Info;
    ResetWithoutSet "reset-without-set" Program Info;
    NeverWritten "never-written" Program Info;
    NeverRead "never-read" Program Info;
    ReadBeforeWrite "read-before-write" Program Info;
    OrderSensitive "order-sensitive" Program Info;
    Unreachable "unreachable" Program Warning;
    EndlessJump "endless-jump" Program Warning;
    UnconditionalEnd "unconditional-end" Program Warning;
    ReturnOutsideFunction "return-outside-function" Program Info;
    UnbalancedLoop "unbalanced-loop" Program Error;
    UnusedFunction "unused-function" Program Info;
    UnusedLabel "unused-label" Program Info;
    CommentedOutRung "commented-out-rung" Program Info;
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
