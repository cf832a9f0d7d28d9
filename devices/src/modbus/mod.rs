//! Modbus TCP: tags as coils and registers.
//!
//! ```text
//! [serve.modbus] --ToServe--> Map (which tag is where, what may be written) --Image (values of one scan)--> Server
//! [[device]] --Device--> Wired (which tag is where) --Devices (one task each)--> other servers
//! [online] --Map--> Modbus --guard: functions 1 to 4--> a controller that is watched
//! ```
//!
//! Numbers of places are those of the protocol, from 0. Functions 1 to 6, 15 and 16 are served, and nothing else.

mod bind;
mod blocks;
mod client;
mod device;
mod freeze;
mod guard;
mod image;
mod place;
mod registers;
mod server;
mod settings;
mod watched;

pub use crate::wrong::Wrong;
pub use bind::{Layout, Map, Named, Places, Reading};
pub use device::{Device, Devices, Wired, bind};
pub use freeze::freeze;
pub use image::{Hold, Image, Refused, TIMEOUT};
pub use place::{Place, Table};
pub use registers::Words;
pub use server::{ADDRESS, Listening, Rules, Subnet, serve};
pub use settings::{NOTHING, ToServe, devices, map, misfits};
pub use watched::Modbus;
