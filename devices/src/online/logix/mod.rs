//! Logix controllers, by EtherNet/IP.

use super::{Found, Source, Wanted};
use ladder_analysis::values::value::Value;
use std::time::Duration;

/// Not there yet.
pub struct Logix;

impl Logix {
    #[allow(missing_docs, clippy::missing_errors_doc, clippy::needless_pass_by_value)]
    pub fn new(_: &str, _: Option<String>, _: Vec<Wanted>, _: Duration) -> Result<Logix, String> {
        Ok(Logix)
    }
}

impl Source for Logix {
    fn connect(&mut self) -> Result<Vec<Found>, String> {
        Err("is not there yet".to_owned())
    }

    fn read(&mut self) -> Result<Vec<Option<Value>>, String> {
        Err("is not there yet".to_owned())
    }
}
