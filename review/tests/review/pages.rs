//! Reports for a browser and a pull request.

use crate::harness::outline;
use ladder_review::compare;
use ladder_review::report::{Compared, html, markdown};

fn page(old: &str, new: &str) -> (String, String) {
    let (old, new) = (outline(old), outline(new));
    let compared = [Compared {
        old: Some("a<b.clad"),
        new: Some("a<b.clad"),
        renamed: false,
        comparison: compare(&old, &new),
    }];
    (html::report(&compared, &[]), markdown::report(&compared))
}

const OLD: &str = "# <b>one</b> #\n+--[ ]( a )--[ ]( b )--( )( c )--+\n\n+--[ ]( d )--( )( e )--+\n";

#[test]
fn both_pictures_with_the_elements_that_differ() {
    let new = OLD.replace("[ ]( b )", "[/]( b )--[ ]( f )");
    let (html, _) = page(OLD, &new);
    assert_eq!(html.matches("<svg ").count(), 2);
    assert_eq!(html.matches("class=\"changed\"").count(), 3, "{html}");
    assert_eq!(html.matches("tabindex").count(), 1);
    assert!(html.contains("before, line 2") && html.contains("after, line 2"));
    let open = html.find("<figure class=\"old\"").expect("it is there");
    let (_, forms) = html.split_at(open);
    let (old, new) = forms.split_once("<figure class=\"new\"").expect("it is there");
    assert_eq!(old.matches("class=\"changed\"").count(), 1);
    assert_eq!(new.matches("class=\"changed\"").count(), 2);
}

#[test]
fn nothing_of_a_program_is_markup() {
    let new = OLD.replace("one", "<script>alert(1)</script> ``` @name");
    let (html, markdown) = page(OLD, &new);
    assert!(!html.contains("<script>alert") && !html.contains("a<b"), "{html}");
    assert!(html.contains("&lt;script&gt;"));
    assert!(markdown.contains("\n````diff\n"), "{markdown}");
    let outside: Vec<&str> = markdown.split("````").step_by(2).collect();
    assert!(!outside.concat().contains("@name"), "{markdown}");
}

#[test]
fn what_is_not_a_network_is_text_with_marks() {
    let declared = |ty: &str| format!("VAR x : {ty}; END_VAR\n{OLD}");
    let (html, _) = page(&declared("BOOL"), &declared("INT"));
    assert!(html.contains("<pre>x : <mark>BOOL</mark>;\n</pre>"), "{html}");
    assert!(html.contains("<mark>INT</mark>"), "{html}");
    // A network that cannot be drawn is shown as it is written.
    let broken = OLD.replace("--( )( c )", "--\\--( )( c )");
    let (html, _) = page(OLD, &broken);
    assert!(html.contains("--<mark>\\</mark>--( )( c )"), "{html}");
}

#[test]
fn nothing_has_changed() {
    let (html, markdown) = page(OLD, OLD);
    assert!(!html.contains("<svg"));
    assert_eq!(markdown, "No network, declaration or comment has changed.\n");
}
