//! A program that verdicts are asked for, with what surrounds it.

use ladder_analysis::{Analysis, AnalyzeOptions, Exported, analyze, exports, link};
use ladder_simulator::{Options, Simulation};
use std::fmt;
use std::sync::Arc;

/// A loop that does not end stops soon.
const WATCHDOG: u64 = 20_000;

/// Another file of the workspace.
#[derive(Debug, Clone)]
pub(crate) struct Other {
    pub(crate) name: &'static str,
    /// What the program sees of it.
    pub(crate) declares: String,
    /// What it does, which the program does not see.
    pub(crate) networks: String,
}

/// See the module.
#[derive(Debug, Clone, Default)]
pub(crate) struct Case {
    /// Directives, types and blocks.
    pub(crate) head: String,
    /// Declarations: the keyword of the section, and one declaration.
    pub(crate) declared: Vec<(&'static str, String)>,
    /// The main program, each a network or several that belong together.
    pub(crate) networks: Vec<String>,
    /// Functions.
    pub(crate) tail: String,
    pub(crate) others: Vec<Other>,
    /// What is outside of the program gives these their values: elementary tags, elements and members.
    pub(crate) inputs: Vec<String>,
    /// Those of them that are not declared, as they would be.
    pub(crate) undeclared: Vec<String>,
    /// Networks that are unread parts, with what the controller runs in their places.
    pub(crate) parts: Vec<(String, String)>,
}

impl Case {
    /// A program that is a text, whose inputs are what the analysis says. None: it has errors.
    pub(crate) fn of_text(text: &str) -> Option<Case> {
        let mut case = Case {
            networks: vec![text.to_owned()],
            ..Case::default()
        };
        let simulation = case.opened()?;
        let inputs = simulation.points().iter().filter(|point| point.is_input);
        case.inputs = inputs.map(|point| point.name.clone()).collect();
        Some(case)
    }

    /// The text of the program, as it is opened.
    pub(crate) fn text(&self) -> String {
        let mut text = self.head.clone();
        for (section, declaration) in &self.declared {
            text.push_str(&format!("{section}\n    {declaration}\nEND_VAR\n"));
        }
        for network in &self.networks {
            text.push_str(network);
            text.push('\n');
        }
        text.push_str(&self.tail);
        text
    }

    /// The program as it is opened. None: it has errors.
    pub(crate) fn opened(&self) -> Option<Simulation> {
        let others = self.others.iter();
        let others = others.map(|other| (other.name, format!("{}{}", other.declares, other.networks)));
        let files: Vec<_> = std::iter::once(("program.clad", self.text()))
            .chain(others)
            .map(|(name, text)| (name, Arc::new(ladder_syntax::parse(&text))))
            .collect();
        let offered = files.iter().map(|(name, parse)| Arc::new(exports(parse, name)));
        let exported = Arc::new(Exported::new(offered.collect()));
        let analysis = |wanted: &str| -> Option<Arc<Analysis>> {
            let (name, parse) = files.iter().find(|(name, _)| *name == wanted)?;
            Some(Arc::new(analyze(
                parse,
                AnalyzeOptions::new(name).among(&exported.others_of(name)),
            )))
        };
        let program = link(&analysis("program.clad")?, &analysis).ok()?;
        let options = Options {
            watchdog: WATCHDOG,
            ..Options::default()
        };
        Simulation::new(program, options).ok()
    }

    /// The program as the controller runs it.
    pub(crate) fn running(&self) -> Option<Simulation> {
        let mut case = self.clone();
        for network in &mut case.networks {
            for (part, real) in &self.parts {
                *network = network.replace(part, real);
            }
        }
        case.opened()
    }
}

impl fmt::Display for Case {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text())?;
        for other in &self.others {
            write!(f, "%% {}\n{}{}", other.name, other.declares, other.networks)?;
        }
        Ok(())
    }
}
