//! Frames, and whether they go out.

use super::*;
use expect_test::{Expect, expect};
use proptest::prelude::*;

/// Bytes written as hexadecimal numbers.
fn hex(text: &str) -> Vec<u8> {
    let digits: String = text.split_whitespace().collect();
    let byte = |at| u8::from_str_radix(&digits[at..at + 2], 16).expect("hexadecimal digits");
    (0..digits.len()).step_by(2).map(byte).collect()
}

fn words(number: usize) -> [u8; 2] {
    (number as u16).to_le_bytes()
}

fn frame(command: u16, data: &[u8]) -> Vec<u8> {
    [&command.to_le_bytes()[..], &words(data.len()), &[0; 20], data].concat()
}

fn unconnected(message: &[u8]) -> Vec<u8> {
    let data = [
        &hex("00000000 0A00 0200 0000 0000 B200")[..],
        &words(message.len()),
        message,
    ]
    .concat();
    frame(SEND_RR_DATA, &data)
}

fn connected(message: &[u8]) -> Vec<u8> {
    let head = hex("00000000 0A00 0200 A100 0400 01020304 B100");
    let data = [&head[..], &words(message.len() + 2), &[7, 0], message].concat();
    frame(SEND_UNIT_DATA, &data)
}

/// A Multiple Service Packet.
fn packed(messages: &[Vec<u8>]) -> Vec<u8> {
    let mut packet = hex("0A 02 2002 2401");
    packet.extend(words(messages.len()));
    let mut at = 2 + 2 * messages.len();
    for message in messages {
        packet.extend(words(at));
        at += message.len();
    }
    packet.extend(messages.concat());
    packet
}

/// An Unconnected Send to slot 0.
fn routed(message: &[u8]) -> Vec<u8> {
    let mut packet = hex("52 02 2006 2401 0A04");
    packet.extend(words(message.len()));
    packet.extend(message);
    packet.extend(vec![0; message.len() % 2]);
    packet.extend(hex("01 00 0100"));
    packet
}

fn tag(service: u8, name: &str, data: &[u8]) -> Vec<u8> {
    let mut path = vec![0x91, name.len() as u8];
    path.extend(name.bytes());
    path.extend(vec![0; name.len() % 2]);
    [&[service, (path.len() / 2) as u8][..], &path, data].concat()
}

/// Read Tag of one element.
fn read() -> Vec<u8> {
    tag(0x4C, "run", &[1, 0])
}

const OPEN: &str = "0A04 00000000 27000000 0427 0910 09101971 07 000000 01402000 A00F0042 01402000 A00F0042";

fn check(frame: &[u8], expected: Expect) {
    expected.assert_eq(&match super::check(frame) {
        Ok(()) => "allowed".to_owned(),
        Err(why) => why,
    });
}

#[test]
fn what_an_upload_and_reads_need() {
    let allowed = || expect!["allowed"];
    check(&frame(REGISTER_SESSION, &hex("01000000")), allowed());
    check(&frame(LIST_IDENTITY, &[]), allowed());
    check(&frame(UNREGISTER_SESSION, &[]), allowed());
    // Who it is, and the name of its program.
    check(&unconnected(&hex("01 02 2001 2401")), allowed());
    check(&unconnected(&routed(&hex("01 02 2001 2401"))), allowed());
    check(&connected(&hex("01 02 2064 2401")), allowed());
    // Whether its tags have changed.
    check(
        &connected(&hex("03 02 20AC 2401 0500 0100 0200 0300 0400 0A00")),
        allowed(),
    );
    // Names of the controller, from the first and from number 0x1234 on, and of a program.
    check(&connected(&hex("55 02 206B 2400 0200 0100 0200")), allowed());
    check(&connected(&hex("55 03 206B 2500 3412 0200 0100 0200")), allowed());
    check(
        &connected(&hex("55 09 910C 50726F6772616D3A4D61696E 206B 2400 0100 0100")),
        allowed(),
    );
    // A structure's size and members.
    check(
        &connected(&hex("03 03 206C 2500 0101 0400 0400 0500 0200 0100")),
        allowed(),
    );
    check(&connected(&hex("4C 03 206C 2500 0101 00000000 4000")), allowed());
    // Tags: by name, by number, with elements and members, of a program, in pieces.
    check(&connected(&read()), allowed());
    check(&connected(&hex("4C 02 206B 2405 0100")), allowed());
    check(
        &connected(&hex("4C 07 206B 2405 2803 9105 7370656564 00 0100")),
        allowed(),
    );
    check(
        &connected(&hex("4C 09 910C 50726F6772616D3A4D61696E 206B 2405 0100")),
        allowed(),
    );
    check(&connected(&tag(0x52, "table", &hex("E803 00000000"))), allowed());
    check(
        &connected(&packed(&[read(), read(), hex("4C 02 206B 2405 0100")])),
        allowed(),
    );
    check(&unconnected(&routed(&packed(&[read()]))), allowed());
    // Connections for requests, through the backplane and through another rack, large and small.
    check(
        &unconnected(&hex(&format!("5B 02 2006 2401 {OPEN} A3 03 0100 2002 2401"))),
        allowed(),
    );
    let far = "A3 09 0101 12 08 31302E302E302E35 0100 2002 2401";
    check(
        &unconnected(&hex(&format!("5B 02 2006 2401 {OPEN} {far}"))),
        allowed(),
    );
    let small = OPEN.replace("A00F0042", "F443");
    check(
        &unconnected(&hex(&format!("54 02 2006 2401 {small} A3 03 0100 2002 2401"))),
        allowed(),
    );
    check(
        &unconnected(&hex(
            "4E 02 2006 2401 0A04 0427 0910 09101971 03 00 0100 2002 2401",
        )),
        allowed(),
    );
}

#[test]
fn what_changes_something() {
    check(
        &connected(&tag(0x4D, "run", &hex("C100 0100 01"))),
        expect!["service 4D of a tag"],
    );
    check(
        &connected(&tag(0x53, "run", &hex("C100 0100 00000000 01"))),
        expect!["service 53 of a tag"],
    );
    // The same number closes a connection of class 06.
    check(
        &connected(&tag(0x4E, "run", &hex("0100 01 FF"))),
        expect!["service 4E of a tag"],
    );
    check(
        &connected(&hex("4D 02 206B 2405 C100 0100 01")),
        expect!["service 4D of a symbol"],
    );
    check(
        &connected(&hex("4E 02 206B 2405 0100 01 FF")),
        expect!["service 4E of a symbol"],
    );
    check(
        &connected(&hex("10 03 2001 2401 3007 0100")),
        expect!["its path is of another kind"],
    );
    check(
        &connected(&hex("10 02 2001 2401 0100")),
        expect!["service 10 of class 01 instance 1"],
    );
    check(
        &connected(&hex("02 02 2001 2401 0100")),
        expect!["service 02 of class 01 instance 1"],
    );
    check(
        &connected(&hex("04 02 208B 2401 0100 0600")),
        expect!["service 04 of class 8B instance 1"],
    );
    check(
        &connected(&hex("05 02 2001 2401")),
        expect!["service 05 of class 01 instance 1"],
    );
    check(
        &connected(&hex("06 02 2064 2401")),
        expect!["service 06 of class 64 instance 1"],
    );
    check(
        &connected(&hex("07 02 2064 2401")),
        expect!["service 07 of class 64 instance 1"],
    );
    check(
        &connected(&hex("08 02 20B2 2400 0000")),
        expect!["service 08 of class B2 instance 0"],
    );
    check(
        &connected(&hex("09 02 20B2 2401")),
        expect!["service 09 of class B2 instance 1"],
    );
    check(
        &connected(&hex("4B 02 2067 2401 07 0910 09101971 0F00")),
        expect!["service 4B of class 67 instance 1"],
    );
    // Reading a file of the controller, and a tag of a trend, are not needed.
    check(
        &connected(&hex("4C 02 2037 2401 0100")),
        expect!["service 4C of class 37 instance 1"],
    );
    check(
        &connected(&hex("4C 02 20B2 2401 0100")),
        expect!["service 4C of class B2 instance 1"],
    );
    // Security, and messages that are encrypted.
    check(
        &connected(&hex("4B 02 205D 2401")),
        expect!["service 4B of class 5D instance 1"],
    );
    check(&frame(0xC8, &[]), expect!["command C8"]);
    check(&frame(0x00, &[]), expect!["command 00"]);
    check(&frame(0x04, &[]), expect!["command 04"]);
}

#[test]
fn connections_that_could_move_something() {
    let opens = |rest: &str| unconnected(&hex(&format!("5B 02 2006 2401 {OPEN} {rest}")));
    // Class 1: inputs and outputs. An assembly. Something after the router.
    check(
        &opens("01 03 0100 2002 2401"),
        expect!["a connection that is not for requests"],
    );
    check(
        &opens("A3 05 0100 2004 2465 2C66 2C64"),
        expect!["a connection that does not end at the message router"],
    );
    check(
        &opens("A3 04 0100 2002 2401 2C01"),
        expect!["a connection that does not end at the message router"],
    );
    check(
        &opens("A3 04 0100 2004 2002 2401"),
        expect!["a route through something that is not a port"],
    );
    check(
        &connected(&hex(&format!("5B 02 2006 2401 {OPEN} A3 03 0100 2002 2401"))),
        expect!["service 5B of class 06 instance 1"],
    );
}

#[test]
fn what_is_within() {
    let write = tag(0x4D, "run", &hex("C100 0100 01"));
    check(
        &connected(&packed(&[read(), write.clone()])),
        expect!["service 4D of a tag"],
    );
    check(&unconnected(&routed(&write)), expect!["service 4D of a tag"]);
    check(
        &unconnected(&routed(&packed(&[write]))),
        expect!["service 4D of a tag"],
    );
    check(
        &connected(&packed(&[packed(&[read()])])),
        expect!["service 0A of class 02 instance 1"],
    );
    check(
        &unconnected(&routed(&routed(&read()))),
        expect!["service 52 of class 06 instance 1"],
    );
    check(
        &connected(&routed(&read())),
        expect!["service 52 of class 06 instance 1"],
    );
    // Messages that share bytes, leave some out, or are none.
    check(
        &connected(&hex("0A 02 2002 2401 0200 0600 0600 4C02206B24050100")),
        expect!["it is cut"],
    );
    check(
        &connected(&hex("0A 02 2002 2401 0200 0600 0400 4C02206B24050100")),
        expect!["its messages overlap"],
    );
    check(
        &connected(&hex("0A 02 2002 2401 0100 0600 0000 4C02206B24050100")),
        expect!["its messages do not begin where they should"],
    );
    check(
        &connected(&hex("0A 02 2002 2401 0000")),
        expect!["its messages do not begin where they should"],
    );
}

#[test]
fn what_is_not_understood() {
    // A service between two: a path of a tag does not make it one of class 06.
    check(
        &connected(&hex("52 02 2006 2402 0000")),
        expect!["service 52 of class 06 instance 2"],
    );
    check(
        &connected(&tag(0x4C, "run", &[1, 0, 0])),
        expect!["its length is wrong"],
    );
    check(
        &connected(&tag(0x52, "run", &[1, 0])),
        expect!["its length is wrong"],
    );
    check(
        &connected(&hex("4C 01 9100 0100")),
        expect!["a name without letters"],
    );
    check(
        &connected(&hex("4C 02 9101 6141 0100")),
        expect!["something where nothing should be"],
    );
    check(
        &connected(&hex("4C 02 206C 2401 0100 2401")),
        expect!["its length is wrong"],
    );
    check(&connected(&hex("4C 01 0100 0100")), expect!["it is cut"]);
    check(
        &connected(&hex("4C 02 3405 0000 0100")),
        expect!["its path is of another kind"],
    );
    check(&connected(&hex("4C 00 0100")), expect!["it is cut"]);
    check(&[], expect!["it is cut"]);
    let mut longer = frame(LIST_IDENTITY, &[]);
    longer.push(0);
    check(&longer, expect!["its length is wrong"]);
    let mut other = unconnected(&read());
    other[30] = 3;
    check(&other, expect!["its packet is of another kind"]);
}

/// Frames that are allowed, of all kinds.
fn any_allowed() -> impl Strategy<Value = Vec<u8>> {
    let one = prop_oneof![
        "[A-Za-z_]{1,20}".prop_map(|name| tag(0x4C, &name, &[1, 0])),
        "[A-Za-z_]{1,20}".prop_map(|name| tag(0x52, &name, &[1, 0, 0, 0, 0, 0])),
        any::<u8>().prop_map(|number| [&hex("4C 02 206B 24")[..], &[number, 1, 0]].concat()),
        Just(hex("03 03 206C 2500 0101 0400 0400 0500 0200 0100")),
        Just(hex("4C 03 206C 2500 0101 00000000 4000")),
        Just(hex("55 02 206B 2400 0200 0100 0200")),
    ];
    let message = prop_oneof![
        one.clone(),
        proptest::collection::vec(one, 1..6).prop_map(|messages| packed(&messages)),
    ];
    (message, 0..3).prop_map(|(message, way)| match way {
        0 => connected(&message),
        1 => unconnected(&message),
        _ => unconnected(&routed(&message)),
    })
}

/// Services that change something, or whose meaning is not known here.
const NOT_READS: [u8; 20] = [
    0x02, 0x04, 0x05, 0x06, 0x07, 0x08, 0x09, 0x0D, 0x0E, 0x10, 0x15, 0x16, 0x19, 0x1A, 0x4B, 0x4D, 0x4E,
    0x4F, 0x53, 0x5C,
];

proptest! {
    #[test]
    fn cut_frames_are_refused(frame in any_allowed(), part in 0.0..1.0) {
        prop_assert_eq!(super::check(&frame), Ok(()));
        let cut = &frame[..(frame.len() as f64 * part) as usize];
        prop_assert!(super::check(cut).is_err());
        // With a length that is right for what is left as well.
        if cut.len() >= 24 {
            let mut cut = cut.to_vec();
            let length = words(cut.len() - 24);
            cut[2..4].copy_from_slice(&length);
            prop_assert!(super::check(&cut).is_err());
        }
    }

    #[test]
    fn one_write_anywhere_refuses_all(
        service in proptest::sample::select(&NOT_READS[..]),
        is_tag in any::<bool>(),
        class in any::<u8>(),
        data in proptest::collection::vec(any::<u8>(), 0..12),
        before in 0..4_usize,
        after in 0..4_usize,
        way in 0..5,
    ) {
        let object = [&[service, 2, 0x20, class, 0x24, 1][..], &data].concat();
        let write = if is_tag { tag(service, "run", &data) } else { object };
        // Closing a connection by itself is not one of them.
        let write = if write.starts_with(&hex("4E 02 2006 2401")) { tag(0x4E, "run", &data) } else { write };
        let all = [vec![read(); before], vec![write.clone()], vec![read(); after]].concat();
        let frame = match way {
            0 => connected(&write),
            1 => unconnected(&write),
            2 => unconnected(&routed(&write)),
            3 => connected(&packed(&all)),
            _ => unconnected(&routed(&packed(&all))),
        };
        prop_assert!(super::check(&frame).is_err());
    }

    #[test]
    fn nothing_crashes(frame in proptest::collection::vec(any::<u8>(), 0..200)) {
        let _ = super::check(&frame);
    }

    /// A byte changed at will makes no frame that writes: whatever passes has services that read only.
    #[test]
    fn no_change_makes_a_write(frame in any_allowed(), at in any::<proptest::sample::Index>(), byte in any::<u8>()) {
        let mut frame = frame;
        let at = at.index(frame.len());
        frame[at] = byte;
        if super::check(&frame).is_ok() {
            let is_connected = frame[0] == SEND_UNIT_DATA as u8;
            let service = frame.get(if is_connected { 46 } else { 40 });
            if let Some(service) = service {
                prop_assert!([0x01, 0x03, 0x0A, 0x4C, 0x52, 0x55].contains(service), "{service:02X}");
            }
        }
    }
}
