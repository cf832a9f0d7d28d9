//! What tests of documents share.

use std::sync::Arc;

use ladder_workspace::SystemDisk;

use crate::neighbours::Neighbours;

/// The workspaces on the disk of the operating system.
pub(crate) fn neighbours() -> Arc<Neighbours> {
    Arc::new(Neighbours::on(Arc::new(SystemDisk)))
}
