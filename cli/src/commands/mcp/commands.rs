//! Calls of tools as commands of this program: their arguments, and what becomes of what they print.

use super::child::{self, Done};
use super::given::Given;
use super::pages::Answer;
use super::roots::{Roots, Within};
use super::tools::Tool;
use base64::Engine;
use serde_json::{Value, json};
use std::collections::{BTreeMap, BTreeSet};
use std::io::Write;
use std::path::PathBuf;
use tempfile::NamedTempFile;

/// Proofs of a file may take so long, in seconds: a command is ended later.
const LONGEST_PROOF: u64 = 100;

/// Does what a call asks for.
///
/// # Errors
/// A sentence for who called.
pub(super) async fn run(tool: &Tool, given: &Given, roots: &Roots) -> Result<Answer, String> {
    let call = Call { given, roots };
    match tool.name {
        "check" => call.check().await,
        "fix" => call.changed("check", &["--fix"]).await,
        "format" => call.changed("fmt", &[]).await,
        "render" => call.render().await,
        "simulate" => call.simulate().await,
        "test" => call.test().await,
        "prove" => call.prove().await,
        "why" => call.why().await,
        "diff" => call.diff().await,
        "convert" => call.convert().await,
        _ => call.explain().await,
    }
}

struct Call<'c> {
    given: &'c Given,
    roots: &'c Roots,
}

/// The arguments of a command.
struct Line(Vec<String>);

impl Line {
    fn of(words: &[&str]) -> Line {
        Line(words.iter().map(|word| (*word).to_owned()).collect())
    }

    /// An option whose value may begin as an option does.
    fn option(&mut self, name: &str, value: &str) {
        self.0.push(format!("{name}={value}"));
    }

    fn values(&mut self, name: &str, values: &[(String, String)]) {
        for (tag, value) in values {
            self.option(name, &format!("{tag}={value}"));
        }
    }

    /// The arguments that are no options.
    fn then(mut self, paths: &[String]) -> Vec<String> {
        self.0.push("--".to_owned());
        self.0.extend(paths.iter().cloned());
        self.0
    }
}

impl Call<'_> {
    fn path(&self, name: &str) -> Result<Within, String> {
        self.roots.there(self.given.needed(name)?)
    }

    /// What a command prints for people: with what it says on stderr where that is all, or worth a note.
    fn told(&self, done: &Done) -> Answer {
        let stdout = String::from_utf8_lossy(&done.stdout);
        let text = match (stdout.trim_end(), done.stderr.trim_end()) {
            (out, "") => out.to_owned(),
            ("", notes) => notes.to_owned(),
            (out, notes) => format!("{out}\n\n{notes}"),
        };
        let text = if text.is_empty() { "done".to_owned() } else { text };
        Answer::text(done.status == 0, &text, self.given.from())
    }

    async fn check(&self) -> Result<Answer, String> {
        let path = self.path("path")?;
        let line = Line::of(&["check", "--format", "json"]).then(&[path.argument()]);
        let done = finished(&path, &line).await?;
        let found = json_of(&done)?;
        let found = found.as_array().cloned().unwrap_or_default();
        Ok(Answer::list(
            done.status == 0,
            "findings",
            found,
            self.given.from(),
        ))
    }

    /// Files are changed where that is asked for; else it is shown what would change.
    async fn changed(&self, command: &str, options: &[&str]) -> Result<Answer, String> {
        let path = self.path("path")?;
        let mut line = Line::of(&[command]);
        line.0.extend(options.iter().map(|option| (*option).to_owned()));
        if self.given.is_asked("guesses") {
            line.0.push("--unsafe-fixes".to_owned());
        }
        if !self.given.is_asked("write") {
            line.0.push("--diff".to_owned());
        }
        let done = finished(&path, &line.then(&[path.argument()])).await?;
        Ok(self.told(&done))
    }

    async fn render(&self) -> Result<Answer, String> {
        let path = self.path("path")?;
        let is_picture = self.given.text("as") == Some("png");
        let mut line = Line::of(&["render", "--format", if is_picture { "png" } else { "text" }]);
        if let Some(scans) = self.given.number("scans") {
            line.option("--scans", &scans.to_string());
        }
        line.values("--set", &self.given.values("set"));
        let mut done = finished(&path, &line.then(&[path.argument()])).await?;
        if !is_picture {
            return Ok(self.told(&done));
        }
        let picture = base64::prelude::BASE64_STANDARD.encode(std::mem::take(&mut done.stdout));
        Ok(self.told(&done).with_picture(picture))
    }

    async fn simulate(&self) -> Result<Answer, String> {
        let path = self.path("path")?;
        let mut line = Line::of(&["sim", "--format", "json"]);
        line.option(
            "--scans",
            self.given.number("scans").unwrap_or(1).to_string().as_str(),
        );
        if let Some(interval) = self.given.text("interval") {
            line.option("--dt", interval);
        }
        line.values("--set", &self.given.values("set"));
        line.values("--force", &self.given.values("force"));
        let watch = self.given.texts("watch");
        if !watch.is_empty() {
            line.option("--watch", &watch.join(","));
        }
        if let Some(plant) = self.given.text("plant") {
            line.option("--plant", &self.roots.there(plant)?.whole().to_string_lossy());
        }
        for connect in self.given.texts("connect") {
            line.option("--connect", connect);
        }
        let inputs = self.given.by_scan("inputs");
        let table = (!inputs.is_empty()).then(|| inputs_table(&inputs)).transpose()?;
        if let Some(table) = &table {
            line.option("--inputs", &table.path().to_string_lossy());
        }
        let done = finished(&path, &line.then(&[path.argument()])).await?;
        let mut trace = json_of(&done)?;
        let scans = trace["scans"].take().as_array().cloned().unwrap_or_default();
        let answer = Answer::list(done.status == 0, "scans", scans, self.given.from());
        let answer = answer
            .with("tags", trace["tags"].take())
            .with("interval_ms", trace["interval_ms"].take());
        Ok(match done.stderr.trim_end() {
            "" => answer,
            notes => answer.with("notes", json!(notes)),
        })
    }

    async fn test(&self) -> Result<Answer, String> {
        let path = self.path("path")?;
        let mut line = Line::of(&["test", "--format", "json"]);
        if let Some(filter) = self.given.text("filter") {
            line.option("--filter", filter);
        }
        let done = finished(&path, &line.then(&[path.argument()])).await?;
        let mut report = json_of(&done)?;
        let (scenarios, errors) = of_files(&report, "scenarios");
        let answer = Answer::list(done.status == 0, "scenarios", scenarios, self.given.from());
        Ok(answer
            .with("errors", Value::Array(errors))
            .with("summary", report["summary"].take()))
    }

    async fn prove(&self) -> Result<Answer, String> {
        let path = self.path("path")?;
        let mut line = Line::of(&["prove", "--format", "json"]);
        if let Some(seconds) = self.given.number("seconds") {
            line.option("--time", &seconds.clamp(1, LONGEST_PROOF).to_string());
        }
        let done = finished(&path, &line.then(&[path.argument()])).await?;
        let report = json_of(&done)?;
        let (properties, errors) = of_files(&report, "properties");
        let answer = Answer::list(done.status == 0, "properties", properties, self.given.from());
        Ok(answer.with("errors", Value::Array(errors)))
    }

    async fn why(&self) -> Result<Answer, String> {
        let path = self.path("path")?;
        let rows = self.given.values("values");
        let rows = rows.into_iter().map(|(name, value)| vec![name, value]);
        let table = table(std::iter::once(vec!["name".to_owned(), "value".to_owned()]).chain(rows))?;
        let mut line = Line::of(&["why"]);
        line.option("--tags", &table.path().to_string_lossy());
        let tag = self.given.needed("tag")?.to_owned();
        let done = finished(&path, &line.then(&[path.argument(), tag])).await?;
        Ok(self.told(&done))
    }

    async fn diff(&self) -> Result<Answer, String> {
        let (old, new) = (self.side("old")?, self.side("new")?);
        let form = if self.given.is_asked("same") {
            "--same"
        } else {
            "--format=markdown"
        };
        let line = Line::of(&["diff", form]).then(&[old.1, new.1]);
        Ok(self.told(&finished(&new.0, &line).await?))
    }

    /// A file, or one of a revision, whose name need not be there any more.
    fn side(&self, name: &str) -> Result<(Within, String), String> {
        let text = self.given.needed(name)?;
        if let Ok(path) = self.roots.there(text) {
            let argument = path.whole().to_string_lossy().into_owned();
            return Ok((path, argument));
        }
        let Some((revision, file)) = text.split_once(':') else {
            return Err(self.roots.there(text).err().unwrap_or_default());
        };
        let stays = |it: std::path::Component<'_>| matches!(it, std::path::Component::Normal(_));
        if revision.starts_with('-') || !PathBuf::from(file).components().all(stays) {
            return Err(format!(
                "`{name}`: a file of a revision is named as in HEAD:motor.clad"
            ));
        }
        Ok((self.roots.there("")?, text.to_owned()))
    }

    async fn convert(&self) -> Result<Answer, String> {
        let path = self.path("path")?;
        let mut line = Line::of(&["convert"]);
        if let Some(to) = self.given.text("to") {
            line.option("--to", to);
        }
        if let Some(output) = self.given.text("output") {
            line.option(
                "--output",
                &self.roots.to_write(output)?.whole().to_string_lossy(),
            );
        }
        if self.given.is_asked("replace") {
            line.0.push("--force".to_owned());
        }
        Ok(self.told(&finished(&path, &line.then(&[path.argument()])).await?))
    }

    async fn explain(&self) -> Result<Answer, String> {
        let here = self.roots.there("")?;
        let name = self.given.text("name").map(str::to_owned);
        let line = Line::of(&["explain"]).then(&Vec::from_iter(name));
        Ok(self.told(&finished(&here, &line).await?))
    }
}

/// What a command has done, if it could do its work.
async fn finished(within: &Within, line: &[String]) -> Result<Done, String> {
    let done = child::run(&within.root, line).await?;
    if done.status == 2 {
        let told = done.stderr.trim();
        return Err(if told.is_empty() {
            "the command could not do its work".to_owned()
        } else {
            told.to_owned()
        });
    }
    Ok(done)
}

fn json_of(done: &Done) -> Result<Value, String> {
    serde_json::from_slice(&done.stdout).map_err(|_| match done.stderr.trim() {
        "" => "the answer is too long: ask for less".to_owned(),
        told => told.to_owned(),
    })
}

/// What all files of a report have under a key, each with its file; and their errors.
fn of_files(report: &Value, key: &str) -> (Vec<Value>, Vec<Value>) {
    let (mut found, mut errors) = (Vec::new(), Vec::new());
    for file in report["files"].as_array().into_iter().flatten() {
        for one in file[key].as_array().into_iter().flatten() {
            let mut one = one.clone();
            one["file"] = file["file"].clone();
            found.push(one);
        }
        errors.extend(file["errors"].as_array().cloned().unwrap_or_default());
    }
    (found, errors)
}

/// A table of inputs: a column a tag, a row a scan.
fn inputs_table(inputs: &BTreeMap<u64, BTreeMap<String, String>>) -> Result<NamedTempFile, String> {
    /// More rows make a file that nobody means.
    const MOST_SCANS: u64 = 100_000;
    let last = inputs.keys().next_back().copied().unwrap_or(0);
    if last > MOST_SCANS {
        return Err(format!("`inputs` are for the first {MOST_SCANS} scans"));
    }
    let names: BTreeSet<&String> = inputs.values().flat_map(BTreeMap::keys).collect();
    let head = names.iter().map(|name| (*name).clone()).collect();
    let rows = (0..=last).map(|scan| {
        let given = inputs.get(&scan);
        let cell = |name: &&String| given.and_then(|given| given.get(*name)).cloned();
        names.iter().map(|name| cell(name).unwrap_or_default()).collect()
    });
    table(std::iter::once(head).chain(rows))
}

/// A table in a file that goes when the command has ended.
fn table(rows: impl Iterator<Item = Vec<String>>) -> Result<NamedTempFile, String> {
    let failed =
        |error: &dyn std::fmt::Display| format!("a table for the command cannot be written: {error}");
    let mut file = tempfile::Builder::new()
        .suffix(".csv")
        .tempfile()
        .map_err(|error| failed(&error))?;
    let mut writer = csv::Writer::from_writer(&mut file);
    for row in rows {
        writer.write_record(&row).map_err(|error| failed(&error))?;
    }
    writer.flush().map_err(|error| failed(&error))?;
    drop(writer);
    file.flush().map_err(|error| failed(&error))?;
    Ok(file)
}
