//! What is debugged: the program with its files, its session and what is given to it.

use std::path::Path;

use ladder_analysis::program::Location;
use ladder_host::World;
use ladder_simulator::expression::Scope;
use ladder_simulator::{Activation, Inputs, Instance, Routine, Session, Simulation, Stop};
use ladder_workspace::RetentiveFile;

use crate::asked::{GivenByFiles, error, unwatched};
use crate::once::Once;
use crate::play::Play;
use crate::properties::Properties;
use crate::sources::Source;

/// A program that is debugged.
#[derive(Debug)]
pub(crate) struct Target {
    world: World,
    pub session: Session,
    /// Its files, in the order of the program model's.
    pub sources: Vec<Source>,
    pub play: Option<Play>,
    /// What a table gives, scan by scan.
    inputs: Inputs,
    given: Once,
    pub properties: Option<Properties>,
    retention: Option<RetentiveFile>,
}

impl Target {
    pub(crate) fn new(
        world: World,
        session: Session,
        sources: Vec<Source>,
        given: GivenByFiles,
        retention: Option<RetentiveFile>,
    ) -> Target {
        Target {
            world,
            session,
            sources,
            play: given.play,
            inputs: given.inputs,
            given: Once::default(),
            properties: given.properties,
            retention,
        }
    }

    pub(crate) fn simulation(&self) -> &Simulation {
        self.session.simulation()
    }

    /// Before a scan that is not open yet: what a scenario and a table of inputs give.
    pub(crate) fn give(&mut self) {
        if self.session.is_open() {
            return;
        }
        if let Some(play) = &mut self.play {
            play.give(&mut self.session);
        }
        self.give_inputs();
    }

    /// Something else is given from now on.
    pub(crate) fn gives(&mut self, given: GivenByFiles) {
        (self.play, self.inputs) = (given.play, given.inputs);
        self.properties = given.properties;
    }

    /// The program has another text, and its tags other places: what names them finds them there. What is wrong is for the
    /// person; a scenario that does not fit any more is over.
    pub(crate) fn bind_again(&mut self) -> (Vec<String>, bool) {
        let mut problems = Vec::new();
        if let Some(before) = self.properties.take() {
            let Properties { file, suite, .. } = before;
            match Properties::bind(file.again(), suite, &self.session) {
                Ok(properties) => self.properties = properties,
                Err(errors) => problems.push(unwatched(&file, &errors)),
            }
        }
        let Some(play) = &mut self.play else {
            return (problems, true);
        };
        let bound = play.bind_again(&self.session);
        let fits = bound.is_ok();
        problems.extend(bound.err().map(|errors| error(&play.file, &errors)));
        (problems, fits)
    }

    /// What was given is given again where it is due.
    pub(crate) fn give_again(&mut self) {
        self.given = Once::default();
        if let Some(play) = &mut self.play {
            play.give_again();
        }
    }

    /// What the table gives before a scan, unless the history gives it again.
    fn give_inputs(&mut self) {
        if !self.given.is_due(&self.session) {
            return;
        }
        let scan = self.session.simulation().scans();
        self.inputs.give_to_session(scan, &mut self.session);
    }

    /// Runs on to the end of the scan, up to a breakpoint.
    pub(crate) fn run_scan(&mut self) -> Option<Stop> {
        self.give();
        self.session.run_scan()
    }

    /// Between two scans: saves retentive tags if that is due.
    pub(crate) fn keep(&mut self) {
        let now = self.world.clock.now();
        if let Some(file) = &mut self.retention
            && file.is_due(now)
        {
            let _ = file.save(&self.session.simulation().retained());
        }
    }

    /// At the end: saves retentive tags and leaves their file to others; what goes wrong is for the person.
    pub(crate) fn save(&mut self) -> Option<String> {
        let mut file = self.retention.take()?;
        let saved = file.save(&self.session.simulation().retained());
        saved.err().map(|error| error.to_string())
    }

    /// Whether a path of the client means this file.
    pub(crate) fn is(&self, source: &Source, path: &Path) -> bool {
        source.is(&*self.world.disk, path)
    }

    /// The file of the program that a path of the client means, by its number.
    pub(crate) fn file_of(&self, path: &Path) -> Option<u32> {
        let file = self.sources.iter().position(|source| self.is(source, path))?;
        u32::try_from(file).ok()
    }

    pub(crate) fn source(&self, file: u32) -> &Source {
        &self.sources[file as usize]
    }

    /// The place where it is: what is open in the scan, or the first network of the next one.
    pub(crate) fn activations(&self) -> Vec<Activation> {
        let open = self.simulation().activations();
        if !open.is_empty() {
            return open;
        }
        let program = self.simulation().program();
        let first = program
            .networks
            .get(program.main.start)
            .filter(|_| !program.main.is_empty());
        let first = first.map(|network| Activation {
            routine: Routine::Main,
            network: program.main.start,
            location: network.location,
            instance: None,
        });
        first.into_iter().collect()
    }

    /// The instance that an activation runs for.
    pub(crate) fn instance_of(&self, activation: &Activation) -> Option<&Instance> {
        self.simulation().instances().get(activation.instance?)
    }

    /// Where names are looked up in a frame; without one in the innermost.
    pub(crate) fn scope(&self, frame: Option<i64>) -> Scope<'_> {
        let activations = self.activations();
        let index = frame.map_or(0, |frame| frame.saturating_sub(1));
        let activation = usize::try_from(index)
            .ok()
            .and_then(|index| activations.get(index).copied());
        let instance = activation.and_then(|activation| activation.instance);
        Scope {
            simulation: self.simulation(),
            instance: instance.and_then(|instance| self.simulation().instances().get(instance)),
        }
    }

    /// `motor.clad:3`
    pub(crate) fn place_name(&self, location: Location) -> String {
        self.source(location.file).place_name(location.range)
    }
}
