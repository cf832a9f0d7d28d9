//! Pages that are being filled from top to bottom.

use super::super::paper::Paper;
use super::super::shapes::{Anchor, Extent, Shape};
use super::super::style::{LINE, Look, UNIT};
use super::super::symbol::width;
use super::{Options, Orientation, Piece, Sheet};

/// Points to a pixel where nothing has to be made smaller: letters of eight points.
pub(super) const FULL: f32 = 0.62;
/// No letter is made smaller than this makes it.
pub(super) const SMALLEST: f32 = 0.42;
/// Blank at the sides of a page, in points.
const SIDE: f32 = 42.0;
/// Where the content of a page begins, and how far from the lower end it stops.
const TOP: f32 = 66.0;
const BOTTOM: f32 = 54.0;

/// Something that is not parted by the end of a page.
pub(super) struct Strip {
    pub(super) shapes: Vec<Shape>,
    /// The part of the plane that it shows.
    pub(super) window: Extent,
    pub(super) scale: f32,
    /// Points left free above it, but for the top of a page.
    pub(super) above: f32,
}

impl Strip {
    /// Shapes that begin at the corner of their plane, in full size.
    pub(super) fn of((shapes, height): (Vec<Shape>, i32), width: i32, above: f32) -> Strip {
        Strip {
            shapes,
            window: Extent {
                left: 0,
                top: 0,
                right: width,
                bottom: height,
            },
            scale: FULL,
            above,
        }
    }

    fn height(&self) -> f32 {
        (self.window.bottom - self.window.top) as f32 * self.scale
    }
}

/// The pages so far.
pub(super) struct Pages {
    size: (f32, f32),
    done: Vec<Vec<Piece>>,
    page: Vec<Piece>,
    /// Where the next strip begins.
    y: f32,
}

impl Pages {
    pub(super) fn new(options: &Options<'_>) -> Pages {
        let (short, long) = options.size.points();
        Pages {
            size: match options.orientation {
                Orientation::Portrait => (short, long),
                Orientation::Landscape => (long, short),
            },
            done: Vec::new(),
            page: Vec::new(),
            y: TOP,
        }
    }

    /// The width of the content, in points.
    pub(super) fn width(&self) -> f32 {
        self.size.0 - 2.0 * SIDE
    }

    /// The same in pixels of full size.
    pub(super) fn pixels(&self) -> i32 {
        (self.width() / FULL) as i32
    }

    /// The same in letters.
    pub(super) fn columns(&self) -> u32 {
        (self.pixels() / UNIT) as u32
    }

    /// The height of the content of a whole page, in points.
    pub(super) fn height(&self) -> f32 {
        self.size.1 - TOP - BOTTOM
    }

    /// Whether strips fit onto what is left of the page.
    pub(super) fn has_room(&self, strips: &[&Strip]) -> bool {
        let first = strips.first().map_or(0.0, |first| first.above);
        let spared = if self.is_fresh() { first } else { 0.0 };
        self.y + Pages::needed(strips) - spared <= self.size.1 - BOTTOM
    }

    /// The height that strips take below others.
    pub(super) fn needed(strips: &[&Strip]) -> f32 {
        strips.iter().map(|strip| strip.above + strip.height()).sum()
    }

    /// Whether nothing is on the page yet.
    pub(super) fn is_fresh(&self) -> bool {
        self.page.is_empty()
    }

    /// Begins the next page, unless this one is empty.
    pub(super) fn turn(&mut self) {
        if !self.is_fresh() {
            self.done.push(std::mem::take(&mut self.page));
            self.y = TOP;
        }
    }

    /// Puts a strip below the others.
    pub(super) fn place(&mut self, strip: Strip) {
        if !self.is_fresh() {
            self.y += strip.above;
        }
        let at = (SIDE, self.y);
        self.y += strip.height();
        self.page.push(Piece {
            shapes: strip.shapes,
            window: strip.window,
            at,
            scale: strip.scale,
        });
    }

    /// The pages with their heads and numbers.
    pub(super) fn finish(mut self, options: &Options<'_>) -> Vec<Sheet> {
        if !self.is_fresh() || self.done.is_empty() {
            self.done.push(std::mem::take(&mut self.page));
        }
        let count = self.done.len();
        let (page_width, page_height) = self.size;
        let right = self.pixels();
        let pages = std::mem::take(&mut self.done).into_iter().enumerate();
        pages
            .map(|(number, mut pieces)| {
                let mut head = Paper::default();
                head.text(
                    Look::Name,
                    (0, LINE - 4),
                    Anchor::Start,
                    width(options.title),
                    options.title,
                );
                let note = options.note;
                head.text(Look::Comment, (right, LINE - 4), Anchor::End, width(note), note);
                head.line(Look::Line, (0, LINE + 4), (right, LINE + 4));
                let head = Strip::of((head.into_shapes(), LINE + 6), right, 0.0);
                let place = format!("{} / {count}", number + 1);
                let foot = foot(options.block, &place, right);
                for (strip, y) in [(head, TOP - 28.0), (foot, page_height - BOTTOM + 14.0)] {
                    pieces.push(Piece {
                        shapes: strip.shapes,
                        window: strip.window,
                        at: (SIDE, y),
                        scale: strip.scale,
                    });
                }
                Sheet {
                    width: page_width,
                    height: page_height,
                    pieces,
                }
            })
            .collect()
    }
}

/// The number of a page, with the title block around it if there is one.
fn foot(block: &[String], place: &str, right: i32) -> Strip {
    /// The height of the block, and the least room that a page's number has in it.
    const HIGH: i32 = LINE + 6;
    const NUMBER: i32 = 10 * UNIT;
    let mut paper = Paper::default();
    let base = LINE - 1;
    let number = NUMBER.max(width(place) + 2 * UNIT);
    let edge = if block.is_empty() { right } else { right - UNIT };
    paper.text(Look::Text, (edge, base), Anchor::End, width(place), place);
    if let Ok(count @ 1..) = i32::try_from(block.len()) {
        let cell = (right - number) / count;
        for (index, told) in (0..).zip(block) {
            let told = shortened(told, cell - 2 * UNIT);
            let at = (index * cell + UNIT, base);
            paper.text(Look::Text, at, Anchor::Start, width(&told), &told);
        }
        for line in (1..count)
            .map(|index| index * cell)
            .chain([0, right - number, right])
        {
            paper.line(Look::Line, (line, 0), (line, HIGH));
        }
        for line in [0, HIGH] {
            paper.line(Look::Line, (0, line), (right, line));
        }
    }
    let mut strip = Strip::of((paper.into_shapes(), HIGH), right, 0.0);
    // The frame is drawn on the edge of the window.
    strip.window = Extent {
        left: -2,
        top: -2,
        right: right + 2,
        bottom: HIGH + 2,
    };
    strip
}

/// So much of a text as there is room for.
fn shortened(text: &str, room: i32) -> String {
    if width(text) <= room {
        return text.to_owned();
    }
    let mut kept = text.to_owned();
    while kept.pop().is_some() && width(&kept) + UNIT > room {}
    format!("{}…", kept.trim_end())
}
