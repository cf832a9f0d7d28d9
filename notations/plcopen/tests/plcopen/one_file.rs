//! The files of a folder as one project, and as the one that they come from.

use expect_test::{Expect, expect};
use ladder_format::Options;
use ladder_notation::{Notation, OneFile, Outcome, Source, convert, write_one_file};
use ladder_notation_plcopen::Plcopen;
use std::fs;
use std::path::PathBuf;

pub(crate) type Files = Vec<(String, String)>;

/// The files that a project becomes. None: it cannot be read.
pub(crate) fn folder(project: &str) -> Option<Files> {
    let source = Source::alone("cell", project.as_bytes());
    let converted = convert(&Plcopen, &source, &Options::default()).ok()?;
    let programs = converted.files.iter().filter(|file| file.name != "ladder.toml");
    let text = |bytes: &[u8]| String::from_utf8(bytes.to_vec()).expect("it is UTF-8");
    let files: Files = programs
        .map(|file| (file.name.clone(), text(&file.bytes)))
        .collect();
    if files.is_empty() {
        return Some(vec![("cell.clad".to_owned(), converted.written.text)]);
    }
    Some(files)
}

/// The projects of the corpus, each with its name. None: the corpus is not there.
fn corpus() -> Vec<(String, String)> {
    let Some(root) = std::env::var_os("LADDER_CORPUS") else {
        eprintln!("skipped: LADDER_CORPUS does not say where the files of others are");
        return Vec::new();
    };
    let (mut found, mut folders) = (Vec::new(), vec![PathBuf::from(root)]);
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(folder).expect("the folder can be read") {
            let path = entry.expect("an entry").path();
            let is_xml = path.extension().is_some_and(|extension| extension == "xml");
            if path.is_dir() {
                folders.push(path);
            } else if is_xml && let Ok(text) = fs::read_to_string(&path) {
                let is_project = Plcopen.recognises(text.as_bytes());
                found.extend(is_project.then(|| (path.display().to_string(), text)));
            }
        }
    }
    found.sort();
    found
}

fn text(written: &OneFile) -> String {
    String::from_utf8(written.bytes.clone()).expect("it is UTF-8")
}

/// The lines that are otherwise, and what there is to say.
pub(crate) fn difference(before: &str, written: &OneFile) -> String {
    let after = text(written);
    let mut out = String::new();
    for change in similar::TextDiff::from_lines(before, &after).iter_all_changes() {
        let sign = match change.tag() {
            similar::ChangeTag::Equal => continue,
            similar::ChangeTag::Delete => '-',
            similar::ChangeTag::Insert => '+',
        };
        out.push_str(&format!("{sign}{}", change.value()));
    }
    out + &told(written)
}

/// What there is to say.
pub(crate) fn told(written: &OneFile) -> String {
    let mut out = String::new();
    for (file, report) in &written.reports {
        for entry in report.remarks() {
            let (Outcome::Approximated(why) | Outcome::Refused(why)) = &entry.outcome else {
                continue;
            };
            out.push_str(&format!("{file}:{}: {}: {why}\n", entry.place, entry.element));
        }
    }
    out
}

pub(crate) fn back(project: &str, files: &Files) -> OneFile {
    let source = Source::alone("cell", project.as_bytes());
    write_one_file(&Plcopen, files, &[], "cell", Some(&source)).unwrap_or_else(|error| panic!("{error}"))
}

#[test]
fn what_is_not_edited_stays_to_the_letter() {
    let mut count = 0;
    for (name, project) in corpus() {
        let Some(mut files) = folder(&project) else {
            continue;
        };
        assert_eq!(text(&back(&project, &files)), project, "{name}");
        // A blank line is no edit.
        files[0].1.push('\n');
        let written = back(&project, &files);
        assert_eq!(text(&written), project, "{name}");
        assert_eq!(told(&written), "", "{name}");
        count += 1;
    }
    assert!(count == 0 || count > 40, "{count}");
}

/// What a project is besides its units.
fn around(project: &str) -> String {
    let mut out = String::new();
    let mut rest = project;
    while let Some(start) = rest.find("pou name=") {
        let start = rest[..start].rfind('<').expect("it is a tag");
        out.push_str(&rest[..start]);
        rest = rest[start..].split_once("pou>").map_or("", |(_, rest)| rest);
    }
    (out + rest).split_whitespace().collect()
}

/// Of each file the first contacts are made their opposites, one by one.
#[test]
fn one_contact_changes_its_unit() {
    let (mut tried, mut again) = (0, 0);
    for (name, project) in corpus() {
        let Some(files) = folder(&project) else { continue };
        let places = files.iter().enumerate().flat_map(|(number, (_, text))| {
            let contacts = text.match_indices("\n+--[ ]( ");
            contacts.map(move |(at, _)| (number, at + 4))
        });
        for (number, at) in places.take(3) {
            let mut edited = files.clone();
            edited[number].1.replace_range(at..at + 3, "[/]");
            let written = back(&project, &edited);
            tried += 1;
            if text(&written) == project {
                assert!(told(&written).contains("it stays as the file has it"), "{name}");
                continue;
            }
            assert_eq!(around(&text(&written)), around(&project), "{name}");
            again += usize::from(folder(&text(&written)) == Some(edited));
        }
    }
    assert!(tried == 0 || (tried > 40 && again > 20), "{again} of {tried}");
}

/// Two programs that call a block, a task, and a chart that is not read.
const CELL: &str = r#"<?xml version="1.0" encoding="utf-8"?>
<project xmlns="http://www.plcopen.org/xml/tc6_0201">
<fileHeader companyName="Works" productName="Line" productVersion="1"/>
<types><dataTypes/><pous>
<pou name="Pump" pouType="program"><interface>
<inputVars><variable name="go"><type><BOOL/></type></variable></inputVars>
<outputVars><variable name="run"><type><BOOL/></type></variable></outputVars></interface><body><LD>
<leftPowerRail localId="1"/>
<contact localId="2"><connectionPointIn><connection refLocalId="1"/></connectionPointIn><variable>go</variable></contact>
<coil localId="3"><connectionPointIn><connection refLocalId="2"/></connectionPointIn><variable>run</variable></coil>
</LD></body><addData/></pou>
<pou name="Valve" pouType="program"><interface>
<outputVars><variable name="shut"><type><BOOL/></type></variable></outputVars></interface><body><LD>
<leftPowerRail localId="1"/>
<contact localId="2"><connectionPointIn><connection refLocalId="1"/></connectionPointIn><variable>level</variable></contact>
<coil localId="3"><connectionPointIn><connection refLocalId="2"/></connectionPointIn><variable>shut</variable></coil>
</LD></body></pou>
</pous></types>
<instances><configurations><configuration name="Line1">
<resource name="Main"><task name="fast" interval="T#20ms" priority="1">
<pouInstance name="p" typeName="Pump"/><pouInstance name="v" typeName="Valve"/></task></resource>
<globalVars><variable name="level"><type><BOOL/></type></variable></globalVars>
</configuration></configurations></instances>
<addData><data name="library"/></addData></project>
"#;

/// Edits the ladder text of the project: in the file of this name something becomes something else.
#[track_caller]
fn check(edits: &[(&str, &str, &str)], expected: Expect) {
    let mut files = folder(CELL).expect("it can be read");
    for (name, from, to) in edits {
        let file = files.iter_mut().find(|(own, _)| own == name);
        let (_, text) = file.unwrap_or_else(|| panic!("there is no {name}"));
        assert!(text.contains(from), "{text}");
        *text = text.replacen(from, to, 1);
    }
    expected.assert_eq(&difference(CELL, &back(CELL, &files)));
}

#[test]
fn a_program_is_edited() {
    check(
        &[("Pump.clad", "[ ]( go )", "[/]( go )")],
        expect![[r#"
        -<pou name="Pump" pouType="program"><interface>
        -<inputVars><variable name="go"><type><BOOL/></type></variable></inputVars>
        -<outputVars><variable name="run"><type><BOOL/></type></variable></outputVars></interface><body><LD>
        -<leftPowerRail localId="1"/>
        -<contact localId="2"><connectionPointIn><connection refLocalId="1"/></connectionPointIn><variable>go</variable></contact>
        -<coil localId="3"><connectionPointIn><connection refLocalId="2"/></connectionPointIn><variable>run</variable></coil>
        -</LD></body><addData/></pou>
        +<pou name="Pump" pouType="program">
        +        <interface>
        +          <inputVars>
        +            <variable name="go">
        +              <type>
        +                <BOOL/>
        +              </type>
        +            </variable>
        +          </inputVars>
        +          <outputVars>
        +            <variable name="run">
        +              <type>
        +                <BOOL/>
        +              </type>
        +            </variable>
        +          </outputVars>
        +        </interface>
        +        <body>
        +          <LD>
        +            <leftPowerRail localId="1" height="40" width="10">
        +              <position x="10" y="20"/>
        +              <connectionPointOut formalParameter="">
        +                <relPosition x="10" y="20"/>
        +              </connectionPointOut>
        +            </leftPowerRail>
        +            <contact localId="2" height="20" width="30" negated="true">
        +              <position x="60" y="30"/>
        +              <connectionPointIn>
        +                <relPosition x="0" y="10"/>
        +                <connection refLocalId="1">
        +                  <position x="60" y="40"/>
        +                  <position x="20" y="40"/>
        +                </connection>
        +              </connectionPointIn>
        +              <connectionPointOut>
        +                <relPosition x="30" y="10"/>
        +              </connectionPointOut>
        +              <variable>go</variable>
        +            </contact>
        +            <coil localId="3" height="20" width="30">
        +              <position x="130" y="30"/>
        +              <connectionPointIn>
        +                <relPosition x="0" y="10"/>
        +                <connection refLocalId="2">
        +                  <position x="130" y="40"/>
        +                  <position x="90" y="40"/>
        +                </connection>
        +              </connectionPointIn>
        +              <connectionPointOut>
        +                <relPosition x="30" y="10"/>
        +              </connectionPointOut>
        +              <variable>run</variable>
        +            </coil>
        +            <rightPowerRail localId="4" height="40" width="10">
        +              <position x="200" y="20"/>
        +              <connectionPointIn>
        +                <relPosition x="0" y="20"/>
        +                <connection refLocalId="3">
        +                  <position x="200" y="40"/>
        +                  <position x="160" y="40"/>
        +                </connection>
        +              </connectionPointIn>
        +            </rightPowerRail>
        +          </LD>
        +        </body>
        +      </pou>
    "#]],
    );
}

#[test]
fn a_global_is_changed() {
    check(
        &[("globals.clad", "level : BOOL;", "level : BOOL := TRUE;")],
        expect![[r#"
            -<globalVars><variable name="level"><type><BOOL/></type></variable></globalVars>
            +<globalVars><variable name="level">
            +            <type>
            +              <BOOL/>
            +            </type>
            +            <initialValue>
            +              <simpleValue value="TRUE"/>
            +            </initialValue>
            +          </variable></globalVars>
        "#]],
    );
}

#[test]
fn programs_come_and_go() {
    let mut files = folder(CELL).expect("it can be read");
    files.push((
        "Fan.clad".to_owned(),
        "+--[ ]( level )--( )( fan )--+\n".to_owned(),
    ));
    files.retain(|(name, _)| name != "Valve.clad");
    expect![[r#"
        -<pou name="Valve" pouType="program"><interface>
        -<outputVars><variable name="shut"><type><BOOL/></type></variable></outputVars></interface><body><LD>
        -<leftPowerRail localId="1"/>
        -<contact localId="2"><connectionPointIn><connection refLocalId="1"/></connectionPointIn><variable>level</variable></contact>
        -<coil localId="3"><connectionPointIn><connection refLocalId="2"/></connectionPointIn><variable>shut</variable></coil>
        -</LD></body></pou>
        +<pou name="Fan" pouType="program">
        +        <interface>
        +          <externalVars>
        +            <variable name="level">
        +              <type>
        +                <BOOL/>
        +              </type>
        +            </variable>
        +          </externalVars>
        +          <localVars>
        +            <variable name="fan_2">
        +              <type>
        +                <BOOL/>
        +              </type>
        +            </variable>
        +          </localVars>
        +        </interface>
        +        <body>
        +          <LD>
        +            <leftPowerRail localId="1" height="40" width="10">
        +              <position x="10" y="20"/>
        +              <connectionPointOut formalParameter="">
        +                <relPosition x="10" y="20"/>
        +              </connectionPointOut>
        +            </leftPowerRail>
        +            <contact localId="2" height="20" width="30">
        +              <position x="60" y="30"/>
        +              <connectionPointIn>
        +                <relPosition x="0" y="10"/>
        +                <connection refLocalId="1">
        +                  <position x="60" y="40"/>
        +                  <position x="20" y="40"/>
        +                </connection>
        +              </connectionPointIn>
        +              <connectionPointOut>
        +                <relPosition x="30" y="10"/>
        +              </connectionPointOut>
        +              <variable>level</variable>
        +            </contact>
        +            <coil localId="3" height="20" width="30">
        +              <position x="130" y="30"/>
        +              <connectionPointIn>
        +                <relPosition x="0" y="10"/>
        +                <connection refLocalId="2">
        +                  <position x="130" y="40"/>
        +                  <position x="90" y="40"/>
        +                </connection>
        +              </connectionPointIn>
        +              <connectionPointOut>
        +                <relPosition x="30" y="10"/>
        +              </connectionPointOut>
        +              <variable>fan_2</variable>
        +            </coil>
        +            <rightPowerRail localId="4" height="40" width="10">
        +              <position x="200" y="20"/>
        +              <connectionPointIn>
        +                <relPosition x="0" y="20"/>
        +                <connection refLocalId="3">
        +                  <position x="200" y="40"/>
        +                  <position x="160" y="40"/>
        +                </connection>
        +              </connectionPointIn>
        +            </rightPowerRail>
        +          </LD>
        +        </body>
        +      </pou>
        -<pouInstance name="p" typeName="Pump"/><pouInstance name="v" typeName="Valve"/></task></resource>
        +<pouInstance name="p" typeName="Pump"/>
        +<pouInstance name="instance1" typeName="Fan"/></task></resource>
    "#]].assert_eq(&difference(CELL, &back(CELL, &files)));
}

#[test]
fn files_are_the_programs_of_a_project() {
    let files = [
        (
            "a.clad",
            "VAR_GLOBAL level : INT := 3; END_VAR\n+--[GT]( level, 2 )--[$Blink]( b, T#1s )--( )( lamp )--+\n",
        ),
        (
            "b.clad",
            "+--[LT]( level, 2 )--[$Blink]( b, T#1s )--( )( lamp )--+\n",
        ),
    ];
    let files: Files = files
        .iter()
        .map(|(name, text)| ((*name).to_owned(), (*text).to_owned()))
        .collect();
    let written =
        write_one_file(&Plcopen, &files, &[], "plant", None).unwrap_or_else(|error| panic!("{error}"));
    let again = folder(&text(&written)).expect("it can be read");
    let shown = again.iter().map(|(name, text)| match name.as_str() {
        "blocks.clad" => format!("=== {name}\n"),
        _ => format!("=== {name}\n{text}"),
    });
    expect![[r#"
        === globals.clad
        VAR_GLOBAL
            level : INT := 3;
        END_VAR
        === blocks.clad
        === a.clad
        VAR
            b       : TIME;
            lamp    : BOOL;
            Blink_2 : $Blink;  # the state of a block #
        END_VAR

        +--[GT]( level, 2 )--[$Blink]( Blink_2, high := b, low := T#1s )--( )( lamp )--+
        === b.clad
        VAR
            b_2     : TIME;
            lamp    : BOOL;
            Blink_2 : $Blink;  # the state of a block #
        END_VAR

        +--[LT]( level, 2 )--------------------[$Blink]( Blink_2, high := b_2, low := T#1s )--( )( lamp )--+
    "#]]
    .assert_eq(&(told(&written) + &shown.collect::<String>()));
}
