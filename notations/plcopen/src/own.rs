//! What the writer adds to a project so that it means the same there, and the reader takes out again. The remark on a
//! variable says so, for people and for the reader.

/// The remark on the input of a block that is its EN: an IEC block without power does not run at all, one of ladder text
/// always does.
pub(crate) const POWER_IN: &str = "EN of the block in ladder text";

/// The remark on the output that is its ENO.
pub(crate) const POWER_OUT: &str = "ENO of the block in ladder text";

/// The remark on a variable that power ends in. Generators run a block when something after it asks for it.
pub(crate) const SINK: &str = "takes power that nothing else takes, so that its block runs in its turn";
