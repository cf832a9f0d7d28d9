//! From tokens to a chart (SFC): `INITIAL_STEP`, `STEP`, `TRANSITION`, `ACTION`.

use super::cursor::{Cursor, Parsed};
use super::tree::{Expression, Span, Statement};

/// A chart as it is written.
#[derive(Debug, Default)]
pub(crate) struct ChartText {
    pub(crate) steps: Vec<StepText>,
    pub(crate) transitions: Vec<TransitionText>,
    pub(crate) actions: Vec<ActionText>,
}

#[derive(Debug)]
pub(crate) struct StepText {
    pub(crate) span: Span,
    pub(crate) name: String,
    pub(crate) is_initial: bool,
    pub(crate) associations: Vec<AssociationText>,
}

/// `Fill(D, T#5s);`
#[derive(Debug)]
pub(crate) struct AssociationText {
    pub(crate) span: Span,
    pub(crate) action: String,
    /// None: there is none.
    pub(crate) qualifier: Option<String>,
    pub(crate) time: Option<Expression>,
}

#[derive(Debug)]
pub(crate) struct TransitionText {
    pub(crate) span: Span,
    pub(crate) priority: Option<u32>,
    pub(crate) from: Vec<String>,
    pub(crate) to: Vec<String>,
    pub(crate) condition: Expression,
}

#[derive(Debug)]
pub(crate) struct ActionText {
    pub(crate) span: Span,
    pub(crate) name: String,
    pub(crate) body: Vec<Statement>,
}

/// The words that a part of a chart begins with.
const PARTS: [&str; 4] = ["INITIAL_STEP", "STEP", "TRANSITION", "ACTION"];

/// The qualifiers that have a time.
const TIMED: [&str; 5] = ["L", "D", "SL", "SD", "DS"];

impl Cursor<'_> {
    /// Whether a chart begins here.
    pub(super) fn is_at_chart(&self) -> bool {
        self.is_any(&["INITIAL_STEP"]) || (self.is_word("STEP") && self.ahead(2).1 == ":")
    }

    /// A chart, up to a word that is no part of one. What is wrong is reported, and the part is passed over.
    pub(super) fn chart(&mut self) -> ChartText {
        let mut chart = ChartText::default();
        while self.is_any(&PARTS) {
            let end = format!(
                "END_{}",
                self.word().to_ascii_uppercase().trim_start_matches("INITIAL_")
            );
            if self.chart_part(&mut chart).is_err() {
                while !self.is_at_end() && !self.take_word(&end) {
                    self.bump();
                }
            }
            self.take_sign(";");
        }
        chart
    }

    fn chart_part(&mut self, chart: &mut ChartText) -> Parsed<()> {
        if self.is_word("TRANSITION") {
            let transition = self.transition()?;
            chart.transitions.push(transition);
        } else if self.is_word("ACTION") {
            let span = self.span();
            self.bump();
            let name = self.name()?;
            self.expect_sign(":")?;
            let body = self.statements(&["END_ACTION"]);
            self.expect_word("END_ACTION")?;
            chart.actions.push(ActionText { span, name, body });
        } else {
            let step = self.chart_step()?;
            chart.steps.push(step);
        }
        Ok(())
    }

    fn chart_step(&mut self) -> Parsed<StepText> {
        let span = self.span();
        let is_initial = self.is_word("INITIAL_STEP");
        self.bump();
        let name = self.name()?;
        self.expect_sign(":")?;
        let mut associations = Vec::new();
        while !self.take_word("END_STEP") {
            associations.push(self.association()?);
            self.expect_sign(";")?;
        }
        Ok(StepText {
            span,
            name,
            is_initial,
            associations,
        })
    }

    fn association(&mut self) -> Parsed<AssociationText> {
        let span = self.span();
        let action = self.name()?;
        let (mut qualifier, mut time) = (None, None);
        self.expect_sign("(")?;
        if !self.is_sign(")") {
            let word = self.name()?;
            let is_timed = TIMED.iter().any(|own| own.eq_ignore_ascii_case(&word));
            qualifier = Some(word);
            if is_timed {
                self.expect_sign(",")?;
                time = Some(self.expression()?);
            }
            // Indicators change nothing.
            while self.take_sign(",") {
                self.name()?;
            }
        }
        self.expect_sign(")")?;
        Ok(AssociationText {
            span,
            action,
            qualifier,
            time,
        })
    }

    fn transition(&mut self) -> Parsed<TransitionText> {
        let span = self.span();
        self.bump();
        if !self.is_word("FROM") && !self.is_sign("(") {
            self.name()?;
        }
        let mut priority = None;
        if self.take_sign("(") {
            self.expect_word("PRIORITY")?;
            self.expect_sign(":=")?;
            let Ok(number) = self.word().parse() else {
                return self.expected("a priority");
            };
            priority = Some(number);
            self.bump();
            self.expect_sign(")")?;
        }
        self.expect_word("FROM")?;
        let from = self.step_names()?;
        self.expect_word("TO")?;
        let to = self.step_names()?;
        if self.is_sign(":") {
            let span = self.span();
            return self.problem(span, "a condition in Instruction List is not read");
        }
        self.expect_sign(":=")?;
        let condition = self.expression()?;
        self.expect_sign(";")?;
        self.expect_word("END_TRANSITION")?;
        Ok(TransitionText {
            span,
            priority,
            from,
            to,
            condition,
        })
    }

    /// `A`, `(A, B)`
    fn step_names(&mut self) -> Parsed<Vec<String>> {
        if !self.take_sign("(") {
            return Ok(vec![self.name()?]);
        }
        let mut names = vec![self.name()?];
        while self.take_sign(",") {
            names.push(self.name()?);
        }
        self.expect_sign(")")?;
        Ok(names)
    }
}
