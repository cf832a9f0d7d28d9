//! The one place where the server asks the language: everything else in this crate knows texts, versions and
//! messages, but nothing of ladder diagrams. All places are bytes.

use std::sync::Arc;

use ladder_analysis::{Diagnostic, analyze};
use ladder_format::{Edit, Options, format};
use ladder_ide::{Hover, hover};
use ladder_syntax::{TextSize, parse};

/// All that is known of one text.
#[derive(Debug)]
pub(crate) struct Analysis(ladder_analysis::Analysis);

impl Analysis {
    /// Analyses a text of at most 64 MiB. Messages of a running program call the file by this name.
    pub(crate) fn of(text: &str, name: &str) -> Self {
        Analysis(analyze(&Arc::new(parse(text)), name))
    }

    /// What is wrong, in the order of the places.
    pub(crate) fn diagnostics(&self) -> &[Diagnostic] {
        &self.0.diagnostics
    }

    /// What stands at an offset.
    pub(crate) fn hover(&self, offset: TextSize) -> Option<Hover> {
        hover(&self.0, offset)
    }

    /// The edits that bring the text into its canonical layout: sorted, none touching another.
    pub(crate) fn format(&self) -> Vec<Edit> {
        format(&self.0.context.parse, &Options::default())
    }
}

/// Running programs, until the scan engine is wired in here.
#[allow(dead_code, clippy::unused_self, clippy::unnecessary_wraps)]
mod engine {
    use super::Analysis;
    use crate::simulation::{Failure, messages};
    use ladder_syntax::TextRange;
    use serde_json::Value;
    use std::time::Duration;

    pub(crate) enum Scanned {
        Done,
        Ended,
        Faulted,
    }
    #[derive(Debug)]
    pub(crate) struct RunFault {
        pub message: String,
        pub range: TextRange,
        pub scan: u64,
    }
    #[derive(Debug)]
    pub(crate) struct Simulation {
        scans: u64,
        x: Value,
        forced: bool,
    }
    impl Simulation {
        pub(crate) fn start(analysis: &Analysis, _: &messages::Options) -> Result<Self, Failure> {
            if !analysis.diagnostics().is_empty() {
                return Err(Failure::Failed("errors".into()));
            }
            Ok(Simulation {
                scans: 0,
                x: Value::Bool(false),
                forced: false,
            })
        }
        pub(crate) fn places(&self) -> Vec<TextRange> {
            vec![TextRange::new(0.into(), 1.into())]
        }
        pub(crate) fn power(&self) -> impl Iterator<Item = bool> {
            [self.scans > 0].into_iter()
        }
        pub(crate) fn set(&mut self, tag: &str, value: &Value) -> Result<(), Failure> {
            if tag != "x" {
                return Err(Failure::Failed(format!("no {tag}")));
            }
            self.x = value.clone();
            Ok(())
        }
        pub(crate) fn force(&mut self, tag: &str, value: &Value) -> Result<(), Failure> {
            self.set(tag, value)?;
            self.forced = true;
            Ok(())
        }
        pub(crate) fn unforce(&mut self, _tag: Option<&str>) -> Result<(), Failure> {
            self.forced = false;
            Ok(())
        }
        pub(crate) fn reset(&mut self) {
            self.scans = 0;
        }
        pub(crate) fn scan(&mut self) -> Scanned {
            self.scans += 1;
            Scanned::Done
        }
        pub(crate) fn scans(&self) -> u64 {
            self.scans
        }
        pub(crate) fn time_ms(&self) -> f64 {
            self.scans as f64 * 10.0
        }
        pub(crate) fn interval(&self) -> Duration {
            Duration::from_millis(10)
        }
        pub(crate) fn faults(&self) -> &[RunFault] {
            &[]
        }
        pub(crate) fn tags(&self) -> Vec<messages::Tag> {
            vec![messages::Tag {
                name: "x".into(),
                kind: "BOOL".into(),
                value: self.x.clone(),
                role: messages::Role::Input,
                forced: self.forced,
            }]
        }
    }
}
pub(crate) use engine::{Scanned, Simulation};
