//! The text of a scene becomes its elements, within bounds.

use super::allow::{self, Refused, can_be_wrapped};
use super::binding::Binding;
use super::expansion::{self, MOST_DRAWN};
use super::finding::Finding;
use super::names::{one_line, own_names};
use super::refused::{not_xml, refused, too_many};
use super::source::Raw;
use super::style::Sheet;
use super::{
    MOST_BYTES, MOST_DEPTH, MOST_ELEMENTS, NAMESPACE, Node, NodeKind, Scene, accessible, text_range,
};
use ladder_simulator::scenario::{PlantLine, plant_named};
use ladder_syntax::TextRange;
use ladder_syntax::xml::{MOST_ATTRIBUTES, is_crowded};
use roxmltree::{Attribute, Document, Node as Xml, ParsingOptions};
use std::collections::HashSet;

const SVG: &str = "http://www.w3.org/2000/svg";
const XHTML: &str = "http://www.w3.org/1999/xhtml";
const INKSCAPE: &str = "http://www.inkscape.org/namespaces/inkscape";

/// Reads a scene. It never fails: where nothing can be shown there are findings and no elements.
pub fn read(text: &str) -> Scene {
    let whole = || text_range(0..text.find('\n').unwrap_or(text.len()));
    if text.len() > MOST_BYTES {
        return refused(
            whole(),
            format!(
                "the file has {} bytes, and a scene at most {MOST_BYTES}",
                text.len()
            ),
            "leave pictures within the drawing out, and simplify its paths",
        );
    }
    if is_crowded(text) {
        return refused(
            whole(),
            format!("an element has more than {MOST_ATTRIBUTES} attributes"),
            "simplify the drawing: save it as plain SVG",
        );
    }
    let options = ParsingOptions {
        // With the texts between them.
        nodes_limit: u32::try_from(MOST_ELEMENTS * 3).unwrap_or(u32::MAX),
        ..ParsingOptions::default()
    };
    let document = match Document::parse_with_options(text, options) {
        Ok(document) => document,
        Err(error) => return not_xml(text, &error),
    };
    let root = document.root_element();
    let elements = root.descendants().filter(Xml::is_element);
    if elements.count() > MOST_ELEMENTS {
        return too_many(whole());
    }
    if !is_svg(root) || root.tag_name().name() != "svg" {
        return refused(
            place_of(root),
            format!("this is `{}`, and not a drawing", root.tag_name().name()),
            "a scene is an SVG file: its first element is <svg xmlns=\"http://www.w3.org/2000/svg\">",
        );
    }
    let mut reader = Reader {
        text,
        scene: Scene::default(),
        sheet: Sheet::default(),
        told: HashSet::new(),
        is_too_deep: false,
    };
    reader.styles(root);
    reader.of_root(root);
    reader.element(root, None, (0, false));
    let Reader {
        mut scene,
        is_too_deep,
        ..
    } = reader;
    if is_too_deep {
        return refused(
            place_of(root),
            format!("elements are more than {MOST_DEPTH} deep in each other"),
            "ungroup what is in so many groups",
        );
    }
    if expansion::is_too_large(&scene.nodes) {
        return refused(
            place_of(root),
            format!("the drawing repeats parts of itself without end, or more than {MOST_DRAWN} times"),
            "an element with href=\"#..\" may not lead back to where it is, nor to too much of the same",
        );
    }
    accessible::name(&mut scene, place_of(root));
    scene.findings.sort_by_key(|finding| finding.range.start());
    scene
}

fn is_svg(node: Xml<'_, '_>) -> bool {
    node.tag_name().namespace() == Some(SVG)
}

/// Where an element begins, up to the end of its name.
fn place_of(node: Xml<'_, '_>) -> TextRange {
    let start = node.range().start;
    text_range(start..start + 1 + node.tag_name().name().len())
}

struct Reader<'t> {
    text: &'t str,
    scene: Scene,
    sheet: Sheet,
    /// What has been told once.
    told: HashSet<String>,
    is_too_deep: bool,
}

impl<'t> Reader<'t> {
    /// The same thing in each of a thousand elements is one finding.
    fn warn(&mut self, range: TextRange, message: String, help: &'static str) {
        if self.told.insert(message.clone()) {
            self.scene.findings.push(Finding::warning(range, message, help));
        }
    }

    fn styles(&mut self, root: Xml<'_, 't>) {
        let is_sheet = |node: &Xml<'_, '_>| is_svg(*node) && node.tag_name().name() == "style";
        for node in root.descendants().filter(is_sheet) {
            let sheet: String = node.children().filter_map(|child| child.text()).collect();
            match self.sheet.add(&sheet) {
                Ok(()) => {}
                Err(help) => self.warn(place_of(node), "a style sheet is left out".to_owned(), help),
            }
        }
    }

    /// What the root says of the program.
    fn of_root(&mut self, root: Xml<'_, 't>) {
        for attribute in root.attributes().filter(|it| it.namespace() == Some(NAMESPACE)) {
            let raw = self.raw(&attribute).trimmed();
            match attribute.name() {
                "program" => self.scene.program = Some((raw.value(), raw.range())),
                "plant" => {
                    for part in raw
                        .split(';')
                        .into_iter()
                        .map(Raw::trimmed)
                        .filter(|part| !part.is_empty())
                    {
                        let value = part.value();
                        let (file, name) = plant_named(&value);
                        self.scene.plants.push(PlantLine {
                            file: file.to_owned(),
                            range: part.range(),
                            name: name.to_owned(),
                        });
                    }
                }
                _ => {}
            }
        }
    }

    fn raw(&self, attribute: &Attribute<'_, '_>) -> Raw<'t> {
        Raw::new(self.text, attribute.range_value())
    }

    /// Adds an element with all that is in it. `is_named`: one that it is in says what it is.
    fn element(&mut self, xml: Xml<'_, 't>, parent: Option<usize>, (depth, is_named): (usize, bool)) {
        if depth >= MOST_DEPTH {
            self.is_too_deep = true;
            return;
        }
        let written = xml.tag_name().name();
        if !is_svg(xml) {
            // What editors keep for themselves is in namespaces of their own.
            if xml.tag_name().namespace() == Some(XHTML) {
                self.left_out(xml, written);
            }
            return;
        }
        let Some(name) = allow::element(written) else {
            return self.left_out(xml, written);
        };
        let parent_name = parent.and_then(|at| self.name_of(at));
        let mut binding = self.binding(xml, parent.is_none());
        let is_wrapped = can_be_wrapped(name, parent_name) && binding.wants_group();
        if binding.wants_group() && !is_wrapped {
            self.cannot_move(xml, name, &mut binding);
        }
        let outer = is_wrapped.then(|| self.add(parent, "g", Vec::new(), binding.blink));
        let attributes = self.attributes(xml, name);
        let inner = self.add(outer.or(parent), name, attributes, None);
        for child in xml.children() {
            if child.is_element() {
                self.element(child, Some(inner), (depth + 1, is_named || binding.alt.is_some()));
            } else if let Some(text) = child.text().filter(|_| child.is_text() && holds_text(name)) {
                self.scene.nodes.push(Node {
                    parent: Some(inner),
                    kind: NodeKind::Text(one_line(text)),
                });
            }
        }
        if !binding.is_empty() {
            (binding.inner, binding.outer) = (inner, outer.unwrap_or(inner));
            binding.text = self.text_of(inner);
            binding.name = self.called(xml, &binding, inner);
            accessible::describe(&mut self.scene.nodes, &binding);
            let has_text = xml
                .descendants()
                .any(|it| it.is_text() && it.text().is_some_and(|it| !it.trim().is_empty()));
            accessible::lacks(
                &binding,
                (has_text, is_named),
                place_of(xml),
                &mut self.scene.findings,
            );
            self.scene.bindings.push(binding);
        }
    }

    fn add(
        &mut self,
        parent: Option<usize>,
        name: &'static str,
        attributes: Vec<(&'static str, String)>,
        blink: Option<u64>,
    ) -> usize {
        self.scene.nodes.push(Node {
            parent,
            kind: NodeKind::Element {
                name,
                attributes,
                blink,
            },
        });
        self.scene.nodes.len() - 1
    }

    fn name_of(&self, at: usize) -> Option<&'static str> {
        match self.scene.nodes[at].kind {
            NodeKind::Element { name, .. } => Some(name),
            NodeKind::Text(_) => None,
        }
    }

    fn left_out(&mut self, xml: Xml<'_, 't>, name: &str) {
        let help = match name {
            // It has been read for its rules.
            "style" | "metadata" => return,
            "script" => "a scene runs nothing: bind what is to change with l:show, l:fill and the others",
            "image" | "foreignObject" | "iframe" => "draw it: nothing else is put into a scene",
            "a" => "a scene leads nowhere: take what is drawn out of the link",
            "filter" => "shadows and blurs are not shown",
            "set" => "bind what is to change with l:show, l:fill and the others",
            name if name.starts_with("animate") => {
                "bind what is to move with l:move-x, l:rotate and the others"
            }
            _ => "the picture is drawn without it",
        };
        self.warn(
            place_of(xml),
            format!("`{name}` is left out, with what is in it"),
            help,
        );
    }

    /// The attributes that may be there, with what styles say.
    fn attributes(&mut self, xml: Xml<'_, 't>, name: &'static str) -> Vec<(&'static str, String)> {
        let mut taken: Vec<(&'static str, String)> = Vec::new();
        for attribute in xml.attributes() {
            let is_link = attribute.name() == "href";
            match attribute.namespace() {
                None => {}
                Some("http://www.w3.org/1999/xlink") if is_link => {}
                Some("http://www.w3.org/XML/1998/namespace") => {}
                Some(_) => continue,
            }
            self.take(
                attribute.name(),
                attribute.value(),
                text_range(attribute.range()),
                &mut taken,
            );
        }
        let of = |wanted| xml.attribute(wanted).unwrap_or_default();
        let sheet = std::mem::take(&mut self.sheet);
        let declared = sheet.declarations((name, of("class"), of("id")), of("style"));
        for (property, value) in declared {
            let style = xml.attributes().find(|it| it.name() == "style");
            let range = style.map_or(place_of(xml), |style| text_range(style.range()));
            self.take(property, value, range, &mut taken);
        }
        self.sheet = sheet;
        taken
    }

    fn take(&mut self, name: &str, value: &str, range: TextRange, taken: &mut Vec<(&'static str, String)>) {
        match allow::attribute(name, value) {
            Ok(name) => {
                let value = own_names(name, value);
                match taken.iter_mut().find(|(known, _)| *known == name) {
                    Some((_, old)) => *old = value,
                    None => taken.push((name, value)),
                }
            }
            Err(Refused::Silently) => {}
            Err(why) => self.warn(range, format!("`{name}` is left out"), why.help()),
        }
    }

    fn binding(&mut self, xml: Xml<'_, 't>, is_root: bool) -> Binding {
        let mut binding = Binding::default();
        for attribute in xml.attributes().filter(|it| it.namespace() == Some(NAMESPACE)) {
            if !(is_root && matches!(attribute.name(), "program" | "plant")) {
                let raw = self.raw(&attribute);
                binding.read(attribute.name(), raw, &mut self.scene.findings);
            }
        }
        binding
    }

    /// What would need a group around it stays as it is drawn.
    fn cannot_move(&mut self, xml: Xml<'_, 't>, name: &str, binding: &mut Binding) {
        self.scene.findings.push(Finding::error(
            place_of(xml),
            format!("`{name}` cannot be shown, moved, turned or dimmed by itself here"),
            "bind the element around it, or put it into a group",
        ));
        binding.blink = None;
        let mut rest = Binding::default();
        std::mem::swap(&mut rest.all, &mut binding.all);
        rest.all.retain(|one| {
            let alone = Binding {
                all: vec![one.clone()],
                ..Binding::default()
            };
            !alone.wants_group()
        });
        binding.all = rest.all;
    }

    /// The element whose text is replaced: drawing programs put a `tspan` around it.
    fn text_of(&self, inner: usize) -> usize {
        let children = self.scene.nodes.iter().enumerate().skip(inner + 1);
        let mut spans =
            children.filter(|(at, node)| node.parent == Some(inner) && self.name_of(*at) == Some("tspan"));
        match (spans.next(), spans.next()) {
            (Some((at, _)), None) => at,
            _ => inner,
        }
    }

    /// What a binding is called in a table.
    fn called(&self, xml: Xml<'_, 't>, binding: &Binding, inner: usize) -> String {
        let label = xml.attribute((INKSCAPE, "label")).map(str::to_owned);
        let id = xml.attribute("id").map(str::to_owned);
        let name = || self.name_of(inner).unwrap_or_default().to_owned();
        binding.alt.clone().or(label).or(id).unwrap_or_else(name)
    }
}

fn holds_text(name: &str) -> bool {
    matches!(name, "text" | "tspan" | "title" | "desc")
}
