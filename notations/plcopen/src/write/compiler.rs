//! What projects are written for.

/// The compiler of a project that is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Compiler {
    /// Of Beremiz and OpenPLC. Generators before it read all that feeds a coil again for each coil.
    Matiec,
    /// Of TwinCAT and CODESYS: it takes instances, structures and arrays of them anywhere, functions for values of any type, and names
    /// of bits. It has no counters of DINT.
    TwinCat,
}

impl Compiler {
    /// A value of an enumeration, with the name of its type.
    pub(super) fn enumerator(self, ty: &str, value: &str) -> String {
        match self {
            Compiler::Matiec => format!("{ty}#{value}"),
            Compiler::TwinCat => format!("{ty}.{value}"),
        }
    }
}
