//! What both sides changed.

use crate::outline::Kind;
use std::fmt;

/// Something that both sides changed, so that a person decides.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Conflict {
    /// What was done.
    pub clash: Clash,
    /// What it was done to.
    pub kind: Kind,
    /// The function or block that it is in; empty for the main program.
    pub place: String,
    /// The tags that it writes, or the names that it declares.
    pub title: String,
}

/// What both sides did.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Clash {
    /// Both edited it.
    BothEdited,
    /// Both added something of the same name.
    BothAdded,
    /// We removed what they edited.
    OursRemoved,
    /// They removed what we edited.
    TheirsRemoved,
}

impl fmt::Display for Conflict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self.clash {
            Clash::BothEdited => "both sides edited",
            Clash::BothAdded => "both sides added",
            Clash::OursRemoved => "ours removed, and theirs edited,",
            Clash::TheirsRemoved => "theirs removed, and ours edited,",
        })?;
        write!(f, " the {}", self.kind.text())?;
        match self.kind {
            _ if self.title.is_empty() => {}
            Kind::Network => write!(f, " that writes {}", self.title)?,
            _ => write!(f, " of {}", self.title)?,
        }
        if !self.place.is_empty() {
            write!(f, ", in {}", self.place)?;
        }
        Ok(())
    }
}
