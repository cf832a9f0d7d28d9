//! What an assistant can read: how ladder text is written, and the pages of instructions, rules and blocks.

use super::child;
use rmcp::model::{ReadResourceResult, Resource, ResourceContents, ResourceTemplate};

/// What a client tells its assistant from the start.
pub(super) const INSTRUCTIONS: &str = "\
Ladder logic as text (.clad), drawn with characters. Read the resource ladder://guide before you write any. After each change: `format` with \
write, `check`, `test`. `simulate` shows what a program does, `prove` what it does in every run; `explain` is the reference. Answers are \
pages: `next` is where the rest begins.";

const GUIDE: &str = "ladder://guide";
const LIST: &str = "ladder://reference";
const PAGE: &str = "ladder://reference/";

/// How ladder text is written, and the errors that are made first: the same that `ladder new` puts into a folder.
const GUIDE_TEXT: &str = include_str!("../../../template/AGENTS.md");

pub(super) fn all() -> Vec<Resource> {
    let resource = |address: &str, name: &str, about: &str| {
        let mut resource = Resource::new(address, name);
        resource.description = Some(about.to_owned());
        resource.mime_type = Some("text/markdown".to_owned());
        resource
    };
    vec![
        resource(
            GUIDE,
            "How to write ladder text",
            "The language on a page, with the commonest errors",
        ),
        resource(LIST, "Instructions, rules and blocks", "All of them, a line each"),
    ]
}

pub(super) fn templates() -> Vec<ResourceTemplate> {
    let template = ResourceTemplate::new(format!("{PAGE}{{name}}"), "A page of the reference");
    vec![
        template.with_description(
            "An instruction (TON), a rule (double-coil) or a block of the library ($Alarm)",
        ),
    ]
}

/// The text of one.
///
/// # Errors
/// There is none of this address.
pub(super) async fn read(address: &str) -> Result<ReadResourceResult, String> {
    let text = match address {
        GUIDE => GUIDE_TEXT.replace("NAME", "motor"),
        LIST => explained(None).await?,
        address => {
            let name = address.strip_prefix(PAGE);
            explained(Some(
                name.ok_or_else(|| format!("there is no resource {address}"))?,
            ))
            .await?
        }
    };
    let text = ResourceContents::text(text, address).with_mime_type("text/markdown");
    Ok(ReadResourceResult::new(vec![text]))
}

async fn explained(name: Option<&str>) -> Result<String, String> {
    let words = ["explain", "--"].into_iter().chain(name);
    let words: Vec<String> = words.map(str::to_owned).collect();
    // In a folder without programs: blocks of the library are known everywhere.
    let empty = tempfile::tempdir().map_err(|error| format!("there is no place for it: {error}"))?;
    let done = child::run(empty.path(), &words).await?;
    if done.status != 0 {
        return Err(done.stderr);
    }
    Ok(String::from_utf8_lossy(&done.stdout).into_owned())
}
