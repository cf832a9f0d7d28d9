//! Controllers on the network.

use ladder_devices::online::Controller;
use ladder_host::{Connection, Controllers};
use ladder_simulator::online::Online;
use ladder_workspace::Online as Asked;

/// The way to them that the machine has.
#[derive(Debug)]
pub(super) struct OverTheNetwork;

impl Controllers for OverTheNetwork {
    fn watch(&self, asked: &Asked, stem: &str, program: &Online) -> Result<Connection, String> {
        let controller = Controller::of(asked)
            .ok_or("[online] in ladder.toml names no controller: write logix = \"192.168.1.10/0\" or modbus = \"192.168.1.20:502\"")?;
        // Who shows it looks by itself.
        let watch = controller.watch(stem, program, || {}).map_err(|wrong| {
            let messages: Vec<String> = wrong.into_iter().map(|wrong| wrong.message).collect();
            messages.join("; ")
        })?;
        Ok((controller.to_string(), Box::new(watch)))
    }
}
