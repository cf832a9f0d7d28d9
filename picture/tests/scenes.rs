//! Scenes: what is taken of a drawing, what values do to it, and what an attacker may try.

use expect_test::{Expect, expect};
use ladder_analysis::analyze;
use ladder_picture::scene::{self, Bound, MOST_BYTES, NodeKind, Scene, still};
use ladder_simulator::{Options, Simulation, value_text};
use ladder_syntax::parse;
use std::sync::Arc;

const PROGRAM: &str = "\
VAR_INPUT
    start, near : BOOL;
END_VAR
VAR_OUTPUT
    run : BOOL;
END_VAR
VAR
    level, zero : INT;
    speed : REAL;
    wait  : TIME := 1500ms;
    name  : STRING := 'a & b';
END_VAR
VAR CONSTANT
    MOST : INT := 200;
END_VAR
+--[ ]( start )--( )( run )--+
+--[ ]( near )--[CALC]( speed, level / 2 )--+
";

fn simulation() -> Simulation {
    let analysis = analyze(&Arc::new(parse(PROGRAM)), "main.clad");
    let program = analysis.program().expect("a program without errors").clone();
    Simulation::new(program, Options::default()).expect("it compiles")
}

/// An SVG file around elements.
fn drawing(inside: &str) -> String {
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" xmlns:l=\"{}\" viewBox=\"0 0 9 9\"><title>t</title><desc>d</desc>{inside}</svg>",
        scene::NAMESPACE
    )
}

/// A scene with these tags given, its findings before it.
fn shown(inside: &str, given: &[(&str, &str)]) -> String {
    let text = drawing(inside);
    let scene = scene::read(&text);
    let mut simulation = simulation();
    for (tag, value) in given {
        let point = simulation.resolve(tag).expect("a tag");
        let value = value_text::parse(value, point.ty).expect("a value");
        simulation.set(&point, value).expect("it takes it");
    }
    let (mut bound, more) = scene.bind(&simulation);
    let mut out = String::new();
    for finding in scene.findings.iter().chain(&more) {
        let place = &text[finding.range];
        out.push_str(&format!(
            "{} at `{place}`: {}\n",
            finding.severity.name(),
            finding.message
        ));
    }
    let values = bound.values(&simulation);
    let picture = still(&scene, &bound.slots, &values);
    let lines = picture.lines().skip(4);
    out.push_str(&lines.collect::<Vec<_>>().join("\n"));
    out.trim_end().trim_end_matches("</svg>").to_owned()
}

fn check(inside: &str, given: &[(&str, &str)], expected: Expect) {
    expected.assert_eq(&shown(inside, given));
}

#[test]
fn values_change_what_is_drawn() {
    check(
        "<g l:show=\"near\"><rect/></g>\
         <circle fill=\"red\" l:fill=\"run: #2b2; start: var(--ladder-on); #888\" l:alt=\"motor\"/>\
         <rect style=\"fill:#123;stroke:blue\" l:stroke=\"near: red\" l:alt=\"sensor\"/>\
         <rect transform=\"scale(2)\" l:move-x=\"level * 2\" l:move-y=\"0 - level\" l:rotate=\"speed\" l:at=\"1 2\" l:scale-y=\"level / 20.0\"/>\
         <text>0 mm<tspan x=\"1\">rest</tspan></text>\
         <text l:text=\"level\" l:format=\"000.0\" l:unit=\"mm\"><tspan>0 mm</tspan></text>\
         <text l:text=\"wait\"/><text l:text=\"name\"/>\
         <g l:opacity=\"speed\"/>",
        &[("level", "10"), ("start", "1"), ("speed", "0.25")],
        expect![[r##"
            <desc>d</desc>
            <g display="none">
            <g>
            <rect></rect></g></g>
            <circle fill="#1a8f3c" aria-label="motor, start" role="img"></circle>
            <rect fill="#123" stroke="blue" aria-label="sensor, off" role="img"></rect>
            <g transform="translate(20 -10) rotate(0.25 1 2) translate(1 2) scale(1 0.5) translate(-1 -2)">
            <rect transform="scale(2)"></rect></g>
            <text>0 mm<tspan x="1">rest</tspan></text>
            <text><tspan>010.0 mm</tspan></text>
            <text>T#1s500ms</text>
            <text>a &amp; b</text>
            <g opacity="0.25">
            <g></g></g>"##]],
    );
}

#[test]
fn expressions_are_checked() {
    check(
        "<g l:show=\"nobody\"/><g l:show=\"level\"/><g l:move-x=\"wait\"/><g l:move-x=\"start\"/><g l:show=\"level &gt;= 5 and\"/>\
         <g l:press=\"run\" l:alt=\"r\"/><g l:press=\"MOST\" l:alt=\"m\"/><g l:toggle=\"level > 1\" l:alt=\"x\"/>\
         <g l:set=\"level = 5\" l:alt=\"s\"/><g l:set=\"level := 1.5\" l:alt=\"s\"/><g l:set=\"level := level + 1\" l:alt=\"more\"/><g l:set=\"level := 0\" l:move-x=\"1\" l:alt=\"none\"/>\
         <g l:fill=\"near: gren; red; blue\" l:alt=\"c\"/><g l:colour=\"red\"/><g l:show=\"\"/><g l:blink=\"fast\"/>\
         <text l:text=\"name\" l:format=\"0\"/><text l:text=\"level\" l:format=\"#.#\"/><g l:rotate=\"level\" l:at=\"1\"/>",
        &[],
        expect![[r#"
            error at `level = 5`: l:set has no `:=`
            error at `gren`: `gren` is not a colour
            error at `red`: `red` has no condition, and so what follows is never seen
            error at `red`: there is no attribute l:colour
            error at ``: l:show is empty
            error at `fast`: `fast` is not a time of 100 ms or more
            error at `#.#`: `#.#` is not a form of numbers
            error at `1`: `1` is not a point
            error at `nobody`: there is no tag `nobody` in this program
            error at `level`: a condition is TRUE or FALSE, and this is of type INT
            error at `wait`: a number is wanted here, and this is of type TIME
            error at `start`: a number is wanted here, and this is of type BOOL
            error at `level &gt;= 5 and`: a value is missing next to this operator
            warning at `run`: run is an output: the program writes it in each scan
            error at `MOST`: a condition is TRUE or FALSE, and this is of type INT
            error at `level > 1`: `level > 1` is not a tag
            error at `1.5`: this is of type LREAL, and level of type INT
            error at `name`: this is of type STRING, and l:format is for numbers
            <desc>d</desc>
            <g>
            <g></g></g>
            <g>
            <g></g></g>
            <g>
            <g></g></g>
            <g>
            <g></g></g>
            <g>
            <g></g></g>
            <g aria-label="r" role="button" tabindex="0"></g>
            <g aria-label="m" role="button" tabindex="0"></g>
            <g aria-label="x" role="switch" tabindex="0"></g>
            <g aria-label="s" role="img"></g>
            <g aria-label="s" role="button" tabindex="0"></g>
            <g aria-label="more" role="button" tabindex="0"></g>
            <g aria-label="none" role="button" tabindex="0" transform="translate(1 0)">
            <g></g></g>
            <g aria-label="c, off" role="img" fill="red"></g>
            <g></g>
            <g></g>
            <g></g>
            <text>a &amp; b</text>
            <text>0</text>
            <g>
            <g></g></g>"#]],
    );
}

#[test]
fn who_does_not_see_it_is_told() {
    check(
        "<g l:press=\"start\" l:alt=\"start\"/><g l:toggle=\"near\" l:alt=\"near sensor\"/><g l:press=\"start\"><text>go</text></g>\
         <g l:press=\"start\"/><rect l:fill=\"near: red; blue\"/>\
         <g l:alt=\"lamp\"><path/><circle l:fill=\"near: red; blue\"/></g>\
         <g l:show=\"start\" role=\"alert\" l:alt=\"late\"/><g l:alt=\"level\" l:scale-y=\"level\"><text l:text=\"level\">0</text></g>",
        &[("near", "1")],
        expect![[r#"
            info at `<g`: this can be pressed and has no name
            info at `near: red; blue`: l:fill tells its state by a colour alone
            <desc>d</desc>
            <g aria-label="start" role="button" tabindex="0"></g>
            <g aria-label="near sensor" role="switch" tabindex="0" aria-checked="true"></g>
            <g role="button" tabindex="0">
            <text>go</text></g>
            <g role="button" tabindex="0"></g>
            <rect fill="red"></rect>
            <g aria-label="lamp, on" role="img">
            <path></path>
            <circle fill="red"></circle></g>
            <g role="alert" aria-label="late" display="none">
            <g></g></g>
            <g aria-label="level, 0" role="img" transform="translate(0 0) scale(1 0) translate(0 0)">
            <g>
            <text>0</text></g></g>"#]],
    );
    let bare = scene::read("<svg xmlns=\"http://www.w3.org/2000/svg\"/>");
    let messages: Vec<&str> = bare.findings.iter().map(|it| it.message.as_str()).collect();
    assert_eq!(messages, ["the scene has no `title`", "the scene has no `desc`"]);
}

#[test]
fn a_fault_shows_what_is_drawn() {
    check(
        "<g l:move-x=\"level / zero\" l:alt=\"box\"/><text l:text=\"level / zero\">0</text>",
        &[("level", "1")],
        expect![[r#"
            <desc>d</desc>
            <g aria-label="box" role="img">
            <g></g></g>
            <text>?</text>"#]],
    );
}

/// Of classes the rule that is written last counts, in whatever order an element has them, and a value that is left out changes nothing.
#[test]
fn the_last_rule_counts() {
    check(
        "<style>.a{fill:#111} .b{fill:#222} .a{stroke:#333} .b{stroke:url(https://evil.example/a.svg#x)}</style>\
         <rect class=\"b a b\"/><style>.a{fill:#444}</style><rect class=\"a c\"/>",
        &[],
        expect![[r##"
            warning at `<rect`: `stroke` is left out
            <desc>d</desc>
            <rect fill="#444" stroke="#333"></rect>
            <rect fill="#444" stroke="#333"></rect>"##]],
    );
}

#[test]
fn styles_become_attributes() {
    check(
        "<style>/* a */ .lamp, .dark{fill:#111;stroke-width:2} #one{fill:#222} rect{opacity:.5}</style>\
         <rect id=\"one\" class=\"lamp\" style=\"-inkscape-stroke:none;stroke:#333 !important\"/><circle class=\"big dark\"/>",
        &[],
        expect![[r##"
            <desc>d</desc>
            <rect id="scene-one" opacity=".5" fill="#222" stroke-width="2" stroke="#333"></rect>
            <circle fill="#111" stroke-width="2"></circle>"##]],
    );
    let long = ".a{fill:red}".repeat(10_000);
    for sheet in [
        long.as_str(),
        "@import url(http://evil.example/a.css);",
        "@font-face { src: url(http://evil.example/f) }",
        "a b { fill: red }",
        "rect { fill: u\\72l(http://evil.example) }",
    ] {
        let scene = scene::read(&drawing(&format!("<style>{sheet}</style><rect/>")));
        assert_eq!(scene.findings.len(), 1, "{sheet}: {:?}", scene.findings);
    }
}

/// What no scene may have in it, however it is written.
const FORBIDDEN: [&str; 16] = [
    "script",
    "onload",
    "onclick",
    "javascript",
    "evil",
    "foreignobject",
    "<image",
    "iframe",
    "animate",
    "<set",
    "<a ",
    "<a>",
    "style",
    "xml:base",
    "@import",
    "data:",
];

#[test]
fn attacks_leave_nothing_in_the_picture() {
    for attack in [
        "<script>alert(1)</script>",
        "<script href=\"https://evil.example/x.js\"/>",
        "<SCRIPT>alert(1)</SCRIPT>",
        "<h:script xmlns:h=\"http://www.w3.org/1999/xhtml\">alert(1)</h:script>",
        "<rect onload=\"alert(1)\"/>",
        "<rect ONCLICK=\"alert(1)\" onfocusin=\"alert(1)\"/>",
        "<foreignObject><div xmlns=\"http://www.w3.org/1999/xhtml\" onclick=\"x\">evil</div></foreignObject>",
        "<image href=\"https://evil.example/a.png\"/>",
        "<image href=\"data:image/svg+xml,%3Csvg onload='alert(1)'/%3E\"/>",
        "<a href=\"javascript:alert(1)\"><rect/></a>",
        "<use href=\"https://evil.example/a.svg#x\"/>",
        "<use href=\"javascript:alert(1)\"/>",
        "<use href=\" data:image/svg+xml,evil#x\"/>",
        "<use xmlns:x=\"http://www.w3.org/1999/xlink\" x:href=\"https://evil.example/a.svg#x\"/>",
        "<use href=\"//evil.example/a.svg#x\"/>",
        "<animate attributeName=\"href\" to=\"javascript:alert(1)\"/>",
        "<set attributeName=\"onload\" to=\"alert(1)\"/>",
        "<iframe src=\"https://evil.example\"/>",
        "<rect fill=\"url(https://evil.example/a.svg#x)\"/>",
        "<rect fill=\"URL(https://evil.example/a.svg#x)\"/>",
        "<rect fill=\"u\\72l(https://evil.example/a.svg#x)\"/>",
        "<rect fill=\"url(#a) url(https://evil.example)\"/>",
        "<rect mask=\"image-set('https://evil.example/a.png' 1x)\"/>",
        "<rect mask=\"image-set/**/('https://evil.example/a.png' 1x)\"/>",
        "<rect clip-path=\"url('https://evil.example/a.svg#x')\"/>",
        "<rect marker-end=\"url( 'https://evil.example/a.svg#x' )\"/>",
        "<rect cursor=\"url(https://evil.example/c.cur), auto\"/>",
        "<rect filter=\"url(https://evil.example/f.svg#x)\"/>",
        "<rect style=\"fill:url(https://evil.example/a.svg#x)\"/>",
        "<rect style=\"background:url(https://evil.example/a.png)\"/>",
        "<rect style=\"fill:expression(alert(1))\"/>",
        "<rect style=\"filter:url(https://evil.example/f.svg#x)\"/>",
        "<style>rect{fill:url(https://evil.example/a.svg#x)}</style><rect/>",
        "<style>@import 'https://evil.example/a.css';</style>",
        "<g xml:base=\"https://evil.example/\"><use href=\"#a\"/></g>",
        "<rect font-family=\"x; } body { background: url(evil)\"/>",
        "<rect l:fill=\"near: url(https://evil.example/a.svg#x); red\" l:alt=\"a\"/>",
        "<rect l:fill=\"near: red; javascript:evil\" l:alt=\"a\"/>",
        "<rect class=\"evil\" data-evil=\"1\" type=\"evil\"/>",
        "<rect role=\"evil\"/>",
        "<filter id=\"evil\"><feImage href=\"https://evil.example/a.png\"/></filter>",
        "<?xml-stylesheet href=\"https://evil.example/a.css\"?>",
        "<![CDATA[<script>alert(1)</script>]]>",
    ] {
        let text = drawing(attack);
        let scene = scene::read(&text);
        let (bound, _) = bind(&scene);
        let picture = still(&scene, &bound.slots, &[]).to_lowercase();
        for word in FORBIDDEN {
            assert!(!picture.contains(word), "{attack}: {word}\n{picture}");
        }
        let (mut bound, _) = bind(&scene);
        let values = bound.values(&simulation()).join(" ").to_lowercase();
        assert!(!values.contains("evil"), "{attack}: {values}");
    }
}

fn bind(scene: &Scene) -> (Bound, usize) {
    let (bound, findings) = scene.bind(&simulation());
    (bound, findings.len())
}

/// A value of the program is text, whatever is in it.
#[test]
fn texts_stay_texts() {
    let shown = shown(
        "<text l:text=\"name\"/>",
        &[("name", "'</text><script>alert(1)</script>'")],
    );
    assert!(shown.contains("&lt;/text&gt;&lt;script&gt;"), "{shown}");
}

/// Why nothing of a file is shown.
fn refused(text: &str) -> String {
    let scene = scene::read(text);
    assert_eq!(scene.nodes, [], "{:?}", scene.findings);
    let findings = scene.findings.iter().map(|it| it.message.as_str());
    findings.collect::<Vec<_>>().join("; ")
}

#[test]
fn limits_are_kept() {
    let many = "<g/>".repeat(20_001);
    let deep = format!("{}{}", "<g>".repeat(70), "</g>".repeat(70));
    let long = format!("<!--{}-->", "x".repeat(MOST_BYTES));
    // Ten times ten times ten ...
    let bomb = (0..12)
        .map(|n| {
            format!(
                "<g id=\"a{n}\">{}</g>",
                format!("<use href=\"#a{}\"/>", n + 1).repeat(10)
            )
        })
        .collect::<Vec<_>>()
        .concat();
    let chain = (0..5000)
        .map(|n| format!("<g id=\"a{n}\"><use href=\"#a{}\"/></g>", n + 1))
        .collect::<Vec<_>>()
        .concat();
    let pattern = "<pattern id=\"p\"><rect fill=\"url(#p)\"/></pattern><rect fill=\"url(#p)\"/>";
    let markers = format!(
        "<marker id=\"m\">{}</marker><path marker-mid=\"url(#m)\" d=\"{}\"/>",
        "<g/>".repeat(1000),
        "M0 0".repeat(1000)
    );
    let entities = "<!DOCTYPE svg [<!ENTITY a \"aaaa\"><!ENTITY b \"&a;&a;&a;\">]><svg>&b;</svg>";
    let outside = "<!DOCTYPE svg [<!ENTITY x SYSTEM \"file:///etc/passwd\">]><svg>&x;</svg>";
    let shown: Vec<String> = [
        drawing(&many),
        drawing(&deep),
        drawing(&long),
        drawing(&bomb),
        drawing(&chain),
        drawing("<g id=\"a\"><use href=\"#a\"/></g>"),
        drawing(pattern),
        drawing(&markers),
        drawing(&format!("<g {}/>", "a='' ".repeat(500_000))),
        entities.to_owned(),
        outside.to_owned(),
        "<svg xmlns=\"http://www.w3.org/2000/svg\"><rect".to_owned(),
        "<svg xmlns=\"http://www.w3.org/2000/svg\"><rect l:show=\"a\"/></svg>".to_owned(),
        "<html xmlns=\"http://www.w3.org/1999/xhtml\"/>".to_owned(),
        "<svg/>".to_owned(),
        String::new(),
        "\u{0}".to_owned(),
    ]
    .iter()
    .map(|text| refused(text))
    .collect();
    expect![[r#"
        the drawing has more than 20000 elements
        elements are more than 64 deep in each other
        the file has 4194444 bytes, and a scene at most 4194304
        the drawing repeats parts of itself without end, or more than 200000 times
        the drawing repeats parts of itself without end, or more than 200000 times
        the drawing repeats parts of itself without end, or more than 200000 times
        the drawing repeats parts of itself without end, or more than 200000 times
        the drawing repeats parts of itself without end, or more than 200000 times
        an element has more than 256 attributes
        the file has a document type (`<!DOCTYPE`)
        the file has a document type (`<!DOCTYPE`)
        this is not XML as it must be: the root node was opened but never closed
        the prefix `l` is not declared
        this is `html`, and not a drawing
        this is `svg`, and not a drawing
        this is not XML as it must be: the document does not have a root node
        this is not XML as it must be: unknown token"#]]
    .assert_eq(&shown.join("\n"));
}

/// A text that is cut anywhere is read without trouble, and each place of a finding is in it.
#[test]
fn cut_texts_are_read() {
    let text = drawing(
        "<g l:show=\"level &gt;= 5\" l:fill=\"near: red; ä: blue\"><text l:text=\"name\">ü</text></g>",
    );
    for cut in (0..text.len()).filter(|at| text.is_char_boundary(*at)) {
        for finding in scene::read(&text[..cut]).findings {
            assert!(
                text[..cut]
                    .get(std::ops::Range::<usize>::from(finding.range))
                    .is_some(),
                "{cut}: {finding:?}"
            );
        }
    }
}

/// Whatever is changed in a file, its picture is one that can be read, and nothing leads out of it.
#[test]
fn random_changes_make_no_broken_picture() {
    let whole = drawing(
        "<style>.a{fill:url(#g)}</style><linearGradient id=\"g\"><stop offset=\"1\"/></linearGradient>\
         <g class=\"a\" l:show=\"level &gt;= 5\" l:fill=\"near: red; url(#g)\" style=\"stroke:#123\"><use href=\"#g\"/>\
         <text l:text=\"name\" l:unit=\"ä\">ü<tspan>x</tspan></text></g>",
    );
    let signs: Vec<char> = "<>&\"'/=;:()#\\ \u{0}\u{7f}\u{2028}axl@{}".chars().collect();
    let simulation = simulation();
    let mut dice = 1u64;
    let mut next = |most: usize| {
        dice = dice
            .wrapping_mul(6_364_136_223_846_793_005)
            .wrapping_add(1_442_695_040_888_963_407);
        (dice >> 33) as usize % most
    };
    for _ in 0..3000 {
        let mut text: Vec<char> = whole.chars().collect();
        for _ in 0..=next(3) {
            let at = next(text.len());
            text[at] = signs[next(signs.len())];
        }
        let text: String = text.into_iter().collect();
        let scene = scene::read(&text);
        if scene.nodes.is_empty() {
            continue;
        }
        let (mut bound, _) = scene.bind(&simulation);
        let values = bound.values(&simulation);
        let picture = still(&scene, &bound.slots, &values);
        let read = roxmltree::Document::parse(&picture);
        assert!(read.is_ok(), "{text:?}: {read:?}\n{picture}");
        for url in picture.split("url(").skip(1) {
            assert!(url.starts_with("#scene-"), "{text:?}\n{picture}");
        }
    }
}

#[test]
fn what_it_names_is_where_it_says() {
    let text = drawing(
        "<g l:show=\"level &gt;= 5 and near\" l:fill=\"start: red; blue\" l:set=\"level := speed\"/>",
    );
    let scene = scene::of_file("tank", &text);
    assert_eq!(
        scene.program.as_ref().map(|(name, _)| name.as_str()),
        Some("tank.clad")
    );
    for written in scene.suite().assumptions {
        assert_eq!(written.text.len(), usize::from(written.range.len()));
        let plain = text[written.range].replace("&gt;", "   >");
        assert_eq!(written.text, plain);
    }
}

#[test]
fn only_what_has_changed_is_told() {
    let text = drawing("<g l:show=\"start\"/><g l:move-x=\"level\"/>");
    let scene = scene::read(&text);
    let mut simulation = simulation();
    let (mut bound, _) = scene.bind(&simulation);
    let mut changes = scene::Changes::default();
    assert_eq!(changes.to(bound.values(&simulation)).len(), bound.slots.len());
    assert_eq!(changes.to(bound.values(&simulation)), []);
    let level = simulation.resolve("level").expect("a tag");
    simulation
        .set(&level, value_text::parse("3", level.ty).expect("a value"))
        .expect("it takes it");
    let changed = changes.to(bound.values(&simulation));
    let values: Vec<&str> = changed.iter().map(|(_, value)| value.as_str()).collect();
    assert_eq!(values, ["3", "translate(3 0)"]);
}

#[test]
fn groups_are_put_around_what_moves() {
    let scene = scene::read(&drawing(
        "<rect id=\"r\" transform=\"scale(2)\" l:move-x=\"level\" l:blink=\"500ms\"/>",
    ));
    let names = scene.nodes.iter().filter_map(|node| match &node.kind {
        NodeKind::Element { name, blink, .. } => Some(format!("{name} {:?} {blink:?}", node.parent)),
        NodeKind::Text(_) => None,
    });
    assert_eq!(
        names.collect::<Vec<_>>(),
        [
            "svg None None",
            "title Some(0) None",
            "desc Some(0) None",
            "g Some(0) Some(500)",
            "rect Some(5) None"
        ]
    );
}
