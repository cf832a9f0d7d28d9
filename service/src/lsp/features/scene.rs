//! `ladder.scene`: a drawing of the machine for a page that shows it, at rest or with the values of a simulation.
//! `docs/protocol.md` shows the messages.

use std::sync::Arc;

use ladder_documents::membership::Membership;
use ladder_documents::{Kind, Revision, address};
use ladder_live::messages::{SceneAsked, SceneShown};
use ladder_live::{Action, Answer, Failure, argument_of};
use ladder_picture::scene::{Bound, Scene};
use ladder_workspace::is_scene;
use tower_lsp::jsonrpc::Result;
use tower_lsp::ls_types::{ExecuteCommandParams, LSPAny};

use super::simulate;
use crate::lsp::answers::{error, json};
use crate::lsp::documents::companions::{scene_of, simulated};
use crate::lsp::session::shared::Shared;
use crate::lsp::transport::blocking::blocking;

/// The command.
pub(crate) const SCENE: &str = "ladder.scene";

pub(crate) async fn execute(shared: &Arc<Shared>, params: ExecuteCommandParams) -> Result<LSPAny> {
    let SceneAsked { uri, session } = argument_of(SCENE, params.arguments).map_err(error)?;
    let revision = revision_of(shared, &uri).map_err(|message| error(Failure::Failed(message)))?;
    let next_to = shared.clone();
    let is_at_rest = session.is_none();
    let (scene, program, at_rest) = blocking(&*shared.host, move |_| {
        let scene = scene_of(&revision, &revision.text());
        let program = program_of(&next_to, &revision, &scene);
        let at_rest = is_at_rest.then(|| at_rest(&next_to, &revision, &scene));
        (scene, program, at_rest)
    })
    .await?;
    let shown = match (session, at_rest) {
        (Some(session), _) => {
            let session = shared.sessions.get(&session).map_err(error)?;
            match simulate::answer(&session, Action::Scene(uri, Box::new(scene))).await? {
                Answer::Scene(shown) => *shown,
                _ => return Err(error(Failure::Failed("the scene cannot be shown".to_owned()))),
            }
        }
        (None, shown) => {
            shown.unwrap_or_else(|| SceneShown::of(uri, &scene, &Bound::default(), Vec::new(), &[]))
        }
    };
    json(&SceneShown { program, ..shown })
}

/// The file as the editor shows it, else as it is on disk.
fn revision_of(shared: &Shared, uri: &str) -> std::result::Result<Arc<Revision>, String> {
    let open = shared.companions.get(uri);
    if let Some(revision) = open.filter(|revision| revision.kind() == Kind::Scene) {
        if !revision.fits() {
            return Err(format!("{} is too large", revision.name()));
        }
        return Ok(revision);
    }
    let path = address::path_of(uri).filter(|path| is_scene(path));
    let path = path.ok_or_else(|| format!("{uri} is not a scene: its name ends in .scene.svg"))?;
    let text = shared
        .world()
        .disk
        .read(&path)
        .map_err(|error| error.to_string())?;
    let place = Membership::new(path, &shared.neighbours);
    let encoding = shared.agreed().encoding;
    Ok(Arc::new(Revision::on_disk(uri, encoding, &text, place)))
}

/// The address of the program that a scene is about, if that is there.
fn program_of(shared: &Shared, revision: &Revision, scene: &Scene) -> Option<String> {
    let path = address::path_of(&revision.uri)?;
    let disk = &shared.world().disk;
    let (name, _) = scene.program.as_ref()?;
    let program = disk.locate(&disk.named_in(&path, name)).ok()?;
    Some(address::uri_of(&program))
}

/// The scene as it is at the start of its program, or as it is drawn where that does not run.
fn at_rest(shared: &Shared, revision: &Revision, scene: &Scene) -> SceneShown {
    let uri = revision.uri.to_string();
    match simulated(shared, revision, &scene.suite()) {
        Some(Ok(simulation)) => {
            let (mut bound, findings) = scene.bind(&simulation);
            let values = bound.values(&simulation);
            SceneShown::of(uri, scene, &bound, values, &findings)
        }
        Some(Err(why)) => {
            let mut shown = SceneShown::of(uri, scene, &Bound::default(), Vec::new(), &[]);
            shown.findings.push(format!("error: {}", String::from(why)));
            shown
        }
        None => SceneShown::of(uri, scene, &Bound::default(), Vec::new(), &[]),
    }
}
