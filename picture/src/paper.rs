//! The sheet that is drawn on: gathers shapes into a picture.

use super::shapes::{Anchor, At, Block, BlockKind, Element, Form, PathStep, Picture, Placed, Role, Shape};
use super::style::Look;

/// A picture that is being drawn.
#[derive(Debug, Default)]
pub(super) struct Paper {
    picture: Picture,
    /// The part of the program that is drawn at present.
    element: Option<Element>,
    /// Whether a user will show the state of a running program on it.
    live: bool,
    /// The parts whose power the shapes drawn at present show.
    power: Vec<Element>,
    /// The operand of the element that is drawn at present.
    operand: Option<usize>,
    /// The right end of what the present block draws.
    right: i32,
    /// The first shape of the present block.
    first: usize,
}

impl Paper {
    /// A sheet; `live` for the state of a running program.
    pub(super) fn new(live: bool) -> Paper {
        Paper {
            live,
            ..Paper::default()
        }
    }

    /// What is drawn from now on shows the power of these parts.
    pub(super) fn powered_by(&mut self, parts: &[Element]) {
        if self.live {
            self.power.clear();
            self.power.extend_from_slice(parts);
        }
    }

    /// What is drawn from now on names this operand.
    pub(super) fn operand(&mut self, operand: Option<usize>) {
        if self.live {
            self.operand = operand;
        }
    }

    /// The gap of a contact or the inside of a coil, which a live drawing fills.
    pub(super) fn gate(&mut self, steps: impl Into<Vec<PathStep>>) {
        if self.live {
            self.path(Look::Gate, steps);
        }
    }

    /// Room for the value of the present operand.
    pub(super) fn value(&mut self, at: At, anchor: Anchor, width: i32) {
        if self.live {
            let text = String::new();
            let form = Form::Text {
                at,
                anchor,
                width,
                text,
            };
            self.shape(Look::Value, Role::Symbol, form);
        }
    }

    /// What is drawn from now on shows this part of the program.
    pub(super) fn of(&mut self, element: Option<Element>) {
        self.element = element;
    }

    /// The present element takes this place.
    pub(super) fn place(&mut self, columns: (i32, i32), wire: i32, rows: (i32, i32)) {
        if let Some(element) = self.element {
            self.picture.placed.push(Placed {
                element,
                columns,
                wire,
                rows,
            });
        }
    }

    pub(super) fn line(&mut self, look: Look, from: At, to: At) {
        self.shape(look, Role::Symbol, Form::Line(from, to));
    }

    /// A wire to the right. One without length is none.
    pub(super) fn wire(&mut self, look: Look, from: At, to: At) {
        if from != to {
            self.shape(look, Role::Wire, Form::Line(from, to));
        }
    }

    /// A wire down to the next rung.
    pub(super) fn node(&mut self, look: Look, from: At, to: At) {
        self.shape(look, Role::Node, Form::Line(from, to));
    }

    pub(super) fn rail(&mut self, from: At, to: At) {
        self.shape(Look::Rail, Role::Rail, Form::Line(from, to));
    }

    pub(super) fn path(&mut self, look: Look, steps: impl Into<Vec<PathStep>>) {
        self.shape(look, Role::Symbol, Form::Path(steps.into()));
    }

    pub(super) fn rect(&mut self, look: Look, at: At, width: i32, height: i32) {
        self.shape(look, Role::Symbol, Form::Rect { at, width, height });
    }

    pub(super) fn dot(&mut self, look: Look, at: At) {
        self.shape(look, Role::Symbol, Form::Dot(at));
    }

    /// A text on one line; `width` is what it takes, in pixels.
    pub(super) fn text(&mut self, look: Look, at: At, anchor: Anchor, width: i32, text: &str) {
        if text.is_empty() {
            return;
        }
        let text = text.to_owned();
        let form = Form::Text {
            at,
            anchor,
            width,
            text,
        };
        self.shape(look, Role::Symbol, form);
    }

    fn shape(&mut self, look: Look, role: Role, form: Form) {
        let shape = Shape {
            look,
            role,
            element: self.element,
            power: self.power.clone(),
            operand: self.operand,
            form,
        };
        self.right = self.right.max(shape.extent().right);
        self.picture.shapes.push(shape);
    }

    /// Ends a network, comment or heading: all shapes since the one before.
    pub(super) fn end_block(&mut self, kind: BlockKind, top: i32, bottom: i32) {
        let shapes = self.first..self.picture.shapes.len();
        self.picture.blocks.push(Block {
            kind,
            shapes,
            rows: top..bottom,
            right: self.right,
        });
        self.first = self.picture.shapes.len();
        self.picture.width = self.picture.width.max(self.right);
        self.right = 0;
    }

    /// What has been drawn, by itself.
    pub(super) fn into_shapes(self) -> Vec<Shape> {
        self.picture.shapes
    }

    /// The picture, with a border to the right of and below it.
    pub(super) fn finish(mut self, bottom: i32, margin: i32, least_width: i32) -> Picture {
        self.picture.width = (self.picture.width + margin).max(least_width);
        self.picture.height = bottom + margin;
        self.picture
    }
}
