//! Small inputs that were read wrongly once.

use super::truth::{check, read};
use expect_test::expect;

#[test]
fn a_joint_between_two_others_is_no_rail() {
    let three = include_str!("../../../../tests/corpus/field/paste_box_three_branches/input.clad");
    check(three, "Fan", &["Go", "Jog", "Fan", "Halt"], |v| {
        (v[0] || v[1] || v[2]) && !v[3]
    });
    let two = include_str!("../../../../tests/corpus/field/paste_box_three_branches/two.clad");
    check(two, "Fan", &["Go", "Fan", "Halt"], |v| (v[0] || v[1]) && !v[2]);
}

#[test]
fn a_box_that_does_not_say_what_it_is() {
    let unnamed = include_str!("../../../../tests/corpus/field/paste_box_function_block/input.clad");
    expect![[r#"
        +--[ ]( Go )--# ┤IN      Q├ #--------------------------------------( )( Fan )--+
        2:12 refused ┤IN      Q├: the box does not say which block it is: TON, TOF and TP have these pins
    "#]]
    .assert_eq(&read(unnamed));
    // With the name of its block it is read.
    check(
        &unnamed.replace("┌─────────┐", "┌── TON ──┐").replace("5s", "0s"),
        "Fan",
        &["Go"],
        |v| v[0],
    );
}

#[test]
fn contacts_without_names_are_not_taken_away() {
    let nameless = include_str!("../../../../tests/corpus/field/paste_nc_contact_is_deleted/whole.clad");
    expect![[r#"
        # from a forum #
        # ---| |---|/|---+---( )--- #
        2:4 refused | |: no name is above this contact or inside it
        2:10 refused |/|: no name is above this contact, and `/` inside tells only its kind
        2:16 refused ---| |---|/|---+---( )---: nothing joins this to a line above or below
        2:20 refused ( ): no name is above this coil or inside it
    "#]]
    .assert_eq(&read(nameless));
}
