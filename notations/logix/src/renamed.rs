//! Tags that got another name in ladder text: what only the export says of them stays theirs.

use roxmltree::{Document, Node};
use std::collections::{HashMap, HashSet};

/// The new names of tags, by the owner of their list and their old name.
type Renamed = HashMap<(String, String), String>;

/// An export, and what was written of it before, with the names that tags have in what is written now. None if they are the same.
pub(crate) fn with_new_names(original: &str, old: &str, new: &str) -> Option<[String; 2]> {
    let [own, was, is] = [original, old, new].map(|text| Document::parse(text).ok());
    let (own, was, is) = (own?, was?, is?);
    let renamed = renamed(&was, &is);
    (!renamed.is_empty()).then(|| [replaced(&own, &renamed), replaced(&was, &renamed)])
}

/// The lists of tags, each with its owner: the controller, a program.
fn lists<'a, 't>(document: &'a Document<'t>) -> impl Iterator<Item = (String, Vec<Node<'a, 't>>)> {
    let lists = document.descendants().filter(|node| node.has_tag_name("Tags"));
    lists.map(|list| {
        let owner = list.parent().filter(|owner| owner.has_tag_name("Program"));
        let owner = owner
            .and_then(|owner| owner.attribute("Name"))
            .unwrap_or_default();
        let tags = list.children().filter(|node| node.has_tag_name("Tag"));
        (owner.to_owned(), tags.collect())
    })
}

/// Tags of which all but the name is as it was, at the place where the other one was.
fn renamed(was: &Document<'_>, is: &Document<'_>) -> Renamed {
    let now: HashMap<String, Vec<Node<'_, '_>>> = lists(is).collect();
    let mut renamed = Renamed::new();
    for (owner, old) in lists(was) {
        let Some(new) = now.get(&owner) else { continue };
        let [known, left] = [&old, new].map(|tags| {
            let names = tags.iter().filter_map(|tag| tag.attribute("Name"));
            names.collect::<HashSet<_>>()
        });
        for (before, after) in old.iter().zip(new) {
            if let (Some(from), Some(to)) = (before.attribute("Name"), after.attribute("Name"))
                && !left.contains(from)
                && !known.contains(to)
                && rest(*before) == rest(*after)
            {
                renamed.insert((owner.clone(), from.to_owned()), to.to_owned());
            }
        }
    }
    renamed
}

/// All that a tag says of itself but its name.
fn rest<'a>(tag: Node<'a, '_>) -> (Vec<(&'a str, &'a str)>, &'a str) {
    let attributes = tag.attributes().filter(|attribute| attribute.name() != "Name");
    let attributes = attributes.map(|attribute| (attribute.name(), attribute.value()));
    let inside = tag.first_child().map_or("", |first| {
        &tag.document().input_text()[first.range().start..tag.range().end]
    });
    (attributes.collect(), inside)
}

/// The text of a document with the new names where tags are defined.
fn replaced(document: &Document<'_>, renamed: &Renamed) -> String {
    let mut text = document.input_text().to_owned();
    let mut edits = Vec::new();
    for (owner, tags) in lists(document) {
        for name in tags.iter().filter_map(|tag| tag.attribute_node("Name")) {
            if let Some(new) = renamed.get(&(owner.clone(), name.value().to_owned())) {
                edits.push((name.range_value(), new));
            }
        }
    }
    for (range, new) in edits.into_iter().rev() {
        text.replace_range(range, new);
    }
    text
}
