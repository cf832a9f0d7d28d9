//! The scenes that a client shows of a simulation.

use ladder_picture::scene::{Bound, Changes, Scene};

use crate::engine::Engine;
use crate::messages::{SceneShown, SceneValues};

/// More scenes than this nobody looks at: the oldest is let go.
const MOST: usize = 8;

/// A scene that is shown.
#[derive(Debug)]
pub(crate) struct LiveScene {
    uri: String,
    /// None: it was bound to another program than the one that runs.
    bound: Option<Bound>,
    changes: Changes,
    /// The client has been told that.
    is_told: bool,
}

impl LiveScene {
    /// Another program runs.
    pub(crate) fn let_go(&mut self) {
        self.bound = None;
    }
}

impl Engine {
    /// Shows a scene from now on.
    pub(crate) fn show_scene(&mut self, uri: String, scene: Scene) -> SceneShown {
        let simulation = self.session.simulation();
        let (mut bound, findings) = scene.bind(simulation);
        let values = bound.values(simulation);
        let shown = SceneShown::of(uri.clone(), &scene, &bound, values.clone(), &findings);
        let mut changes = Changes::default();
        changes.to(values);
        self.scenes.retain(|live| live.uri != uri);
        if self.scenes.len() == MOST {
            self.scenes.remove(0);
        }
        self.scenes.push(LiveScene {
            uri,
            bound: Some(bound),
            changes,
            is_told: false,
        });
        shown
    }

    /// What has changed in the scenes since this was asked last.
    pub(crate) fn scene_values(&mut self) -> Vec<SceneValues> {
        let simulation = self.session.simulation();
        let values = self.scenes.iter_mut().filter_map(|live| {
            let again = live.bound.is_none();
            let values = match &mut live.bound {
                Some(bound) => live.changes.to(bound.values(simulation)),
                None => Vec::new(),
            };
            let is_news = (again && !live.is_told) || !values.is_empty();
            live.is_told = again;
            is_news.then(|| SceneValues {
                uri: live.uri.clone(),
                values,
                again,
            })
        });
        values.collect()
    }
}
