//! Findings as SARIF 2.1.0, the form that code scanning services take in.

use super::concise::in_part;
use super::place::place;
use super::source::Source;
use ladder_analysis::{Diagnostic, Fix, Rule, Severity};
use ladder_syntax::TextRange;
use serde_json::{Value, json};

/// The document of a run with these results.
pub(crate) fn document(results: Vec<Value>) -> Value {
    let rules: Vec<Value> = ladder_analysis::rules::ALL.iter().copied().map(rule).collect();
    json!({
        "$schema": "https://json.schemastore.org/sarif-2.1.0.json",
        "version": "2.1.0",
        "runs": [{
            "tool": { "driver": {
                "name": "ladder",
                "version": env!("CARGO_PKG_VERSION"),
                "semanticVersion": env!("CARGO_PKG_VERSION"),
                "rules": rules,
            }},
            "columnKind": "unicodeCodePoints",
            "results": results,
        }],
    })
}

fn rule(rule: Rule) -> Value {
    json!({
        "id": rule.name(),
        "name": rule.name(),
        "help": { "text": format!("ladder explain {} tells more", rule.name()) },
        "defaultConfiguration": { "level": level(rule.default_severity()) },
    })
}

pub(super) fn level(severity: Severity) -> &'static str {
    match severity {
        Severity::Error => "error",
        Severity::Warning => "warning",
        Severity::Info => "note",
    }
}

/// A finding as a result of a run.
pub(crate) fn result(source: &Source, finding: &Diagnostic) -> Value {
    // Viewers show the message, and few of them the logical location.
    let part = source.name_of(finding.range);
    let help = finding.help.as_deref().map(|help| format!("\n{help}"));
    let text = format!("{}{}{}", finding.message, in_part(part), help.unwrap_or_default());
    let mut result = json!({
        "ruleId": finding.rule.name(),
        "level": level(finding.severity),
        "message": { "text": text },
        "locations": [{ "physicalLocation": location(source, finding.range) }],
    });
    if let Some(part) = part {
        result["locations"][0]["logicalLocations"] = logical(part);
    }
    if !finding.related.is_empty() {
        let related = finding.related.iter().enumerate().map(|(id, related)| {
            let elsewhere = related.file.as_ref().and_then(|file| source.other(file));
            let source = elsewhere.as_ref().unwrap_or(source);
            json!({
                "id": id,
                "message": { "text": related.message },
                "physicalLocation": location(source, related.range),
            })
        });
        result["relatedLocations"] = related.collect();
    }
    if let Some(found) = finding.fixes.first() {
        result["fixes"] = json!([fix(source, found)]);
    }
    result
}

fn fix(source: &Source, fix: &Fix) -> Value {
    let replacements = fix.edits.iter().map(|edit| {
        json!({
            "deletedRegion": region(source, edit.range),
            "insertedContent": { "text": edit.text },
        })
    });
    json!({
        "description": { "text": fix.title },
        "properties": { "applicability": fix.applicability.name() },
        "artifactChanges": [{
            "artifactLocation": { "uri": uri(&source.file) },
            "replacements": replacements.collect::<Value>(),
        }],
    })
}

fn location(source: &Source, range: TextRange) -> Value {
    json!({
        "artifactLocation": { "uri": uri(&source.file) },
        "region": region(source, range),
    })
}

/// What another system calls the place.
pub(super) fn logical(part: &str) -> Value {
    json!([{ "fullyQualifiedName": part }])
}

fn region(source: &Source, range: TextRange) -> Value {
    let place = place(source, range);
    json!({
        "startLine": place.line,
        "startColumn": place.column,
        "endLine": place.end_line,
        "endColumn": place.end_column,
    })
}

/// A file as a relative URI reference (or, where it was named by its whole path, as one with the scheme).
pub(super) fn uri(file: &str) -> String {
    let mut uri = String::with_capacity(file.len());
    for byte in file.replace('\\', "/").bytes() {
        match byte {
            b'A'..=b'Z' | b'a'..=b'z' | b'0'..=b'9' | b'-' | b'.' | b'_' | b'~' | b'/' => {
                uri.push(byte.into());
            }
            _ => uri.push_str(&format!("%{byte:02X}")),
        }
    }
    if uri.starts_with('/') {
        uri.insert_str(0, "file://");
    }
    uri
}
