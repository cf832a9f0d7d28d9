//! Which frames go out to a Logix controller: those that read, each understood to its last byte.
//!
//! A service has its meaning by what it is asked of: 4E closes a connection of the connection manager, and writes into a tag;
//! 52 passes a message on, and reads a tag. So a message is decided by its service *and* its path, those within messages as
//! well. What is not in the table of [`message`], or is longer or shorter than it says, is refused.

use std::fmt;

/// Why a frame is refused.
type Checked<T = ()> = Result<T, String>;

const REGISTER_SESSION: u16 = 0x65;
const UNREGISTER_SESSION: u16 = 0x66;
const LIST_IDENTITY: u16 = 0x63;
pub(super) const SEND_RR_DATA: u16 = 0x6F;
pub(super) const SEND_UNIT_DATA: u16 = 0x70;

const IDENTITY: u32 = 0x01;
const MESSAGE_ROUTER: u32 = 0x02;
const CONNECTION_MANAGER: u32 = 0x06;
const PROGRAM_NAME: u32 = 0x64;
const SYMBOL: u32 = 0x6B;
const TEMPLATE: u32 = 0x6C;
/// Its attributes tell whether the tags have changed.
const CONTROLLER: u32 = 0xAC;

/// The message router, where every connection of ours ends: one that ended at inputs and outputs could take them over.
const END_OF_CONNECTION: [u8; 4] = [0x20, MESSAGE_ROUTER as u8, 0x24, 1];
/// Requests and answers, class 3: no connection for inputs and outputs.
const REQUESTS: u8 = 0xA3;

/// Whether a frame only reads.
///
/// # Errors
/// It does not, or it is not understood: why.
pub(super) fn check(frame: &[u8]) -> Checked {
    let mut rest = Bytes(frame);
    let (command, length) = (rest.word()?, rest.word()?);
    // Session, status, context and options.
    rest.take(20)?;
    if rest.0.len() != usize::from(length) {
        return Err("its length is wrong".to_owned());
    }
    match command {
        REGISTER_SESSION => {
            rest.take(4)?;
            rest.end()
        }
        UNREGISTER_SESSION | LIST_IDENTITY => rest.end(),
        SEND_RR_DATA => message(packet(rest, (0x00, 0), 0xB2)?, Way::Unconnected),
        SEND_UNIT_DATA => {
            let mut rest = packet(rest, (0xA1, 4), 0xB1)?;
            // The sequence count.
            rest.word()?;
            message(rest, Way::Connected)
        }
        _ => Err(format!("command {command:02X}")),
    }
}

/// The message of a packet of two items: where it goes, of a kind and length, and the message, of a kind.
fn packet(mut rest: Bytes<'_>, (address, length): (u16, u16), data: u16) -> Checked<Bytes<'_>> {
    let interface = [rest.word()?, rest.word()?];
    // A timeout.
    rest.word()?;
    let items = [rest.word()?, rest.word()?, rest.word()?];
    rest.take(usize::from(length))?;
    let message = [rest.word()?, rest.word()?];
    if interface != [0, 0] || items != [2, address, length] || message[0] != data {
        return Err("its packet is of another kind".to_owned());
    }
    if rest.0.len() != usize::from(message[1]) {
        return Err("its message's length is wrong".to_owned());
    }
    Ok(rest)
}

/// How a message travels. None can be within one of its own kind: so messages are at most three deep.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Way {
    Unconnected,
    Connected,
    /// Within an Unconnected Send.
    Routed,
    /// Within a Multiple Service Packet.
    Packed,
}

/// Everything that may be asked for.
fn message(mut rest: Bytes<'_>, way: Way) -> Checked {
    let service = rest.byte()?;
    let words = usize::from(rest.byte()?);
    let target = Target::of(Bytes(rest.take(2 * words)?))?;
    let object = |class| Target::Object { class, instance: 1 };
    match (service, target) {
        // Get Attributes All.
        (0x01, _) if target == object(IDENTITY) || target == object(PROGRAM_NAME) => rest.end(),
        // Get Attribute List.
        (0x03, _) if target == object(CONTROLLER) => attributes(rest),
        (0x03, Target::Object { class: TEMPLATE, .. }) => attributes(rest),
        // Get Instance Attribute List: the names of tags.
        (0x55, Target::Symbol) => attributes(rest),
        // Read Tag: how many elements.
        (0x4C, Target::Tag | Target::Symbol) => rest.of_length(2),
        // Read Tag Fragmented: how many elements, from where.
        (0x52, Target::Tag | Target::Symbol) => rest.of_length(6),
        // Read Template: from where, how much.
        (0x4C, Target::Object { class: TEMPLATE, .. }) => rest.of_length(6),
        // Multiple Service Packet.
        (0x0A, _) if target == object(MESSAGE_ROUTER) && way != Way::Packed => packed(rest),
        (_, _) if target == object(CONNECTION_MANAGER) && way == Way::Unconnected => match service {
            // Unconnected Send.
            0x52 => routed(rest),
            // Forward Open and Large Forward Open.
            0x54 => opening(rest, 2),
            0x5B => opening(rest, 4),
            // Forward Close.
            0x4E => closing(rest),
            _ => Err(format!("service {service:02X} of {target}")),
        },
        _ => Err(format!("service {service:02X} of {target}")),
    }
}

/// A count, and as many numbers of attributes.
fn attributes(mut rest: Bytes<'_>) -> Checked {
    let count = usize::from(rest.word()?);
    rest.of_length(2 * count)
}

/// The messages of a Multiple Service Packet: they follow each other without gaps.
fn packed(rest: Bytes<'_>) -> Checked {
    let whole = rest.0;
    let mut starts = rest;
    let count = usize::from(starts.word()?);
    let mut starts = Bytes(starts.take(2 * count)?);
    let mut from = 2 + 2 * count;
    if count == 0 || usize::from(starts.word()?) != from {
        return Err("its messages do not begin where they should".to_owned());
    }
    for nth in 1..=count {
        let to = if nth == count {
            whole.len()
        } else {
            usize::from(starts.word()?)
        };
        let one = whole.get(from..to).ok_or("its messages overlap")?;
        message(Bytes(one), Way::Packed)?;
        from = to;
    }
    Ok(())
}

/// The message of an Unconnected Send, and its route.
fn routed(mut rest: Bytes<'_>) -> Checked {
    // How long it may take.
    rest.take(2)?;
    let length = usize::from(rest.word()?);
    let inner = rest.take(length)?;
    rest.padding(length)?;
    let words = usize::from(rest.byte()?);
    rest.padding(1)?;
    let route = rest.take(2 * words)?;
    rest.end()?;
    ports(Bytes(route))?;
    message(Bytes(inner), Way::Routed)
}

/// The parameters of a connection, whose sizes are numbers of so many bytes.
fn opening(mut rest: Bytes<'_>, size: usize) -> Checked {
    // How long it may take, numbers of the connection, factor of the timeout.
    rest.take(22)?;
    // Interval and size, there and back.
    rest.take(2 * (4 + size))?;
    if rest.byte()? != REQUESTS {
        return Err("a connection that is not for requests".to_owned());
    }
    let words = usize::from(rest.byte()?);
    end_at_router(rest, 2 * words)
}

/// Which connection is closed.
fn closing(mut rest: Bytes<'_>) -> Checked {
    // How long it may take, numbers of the connection.
    rest.take(10)?;
    let words = usize::from(rest.byte()?);
    rest.padding(1)?;
    end_at_router(rest, 2 * words)
}

/// A path through ports to the message router, which is the last thing there is.
fn end_at_router(mut rest: Bytes<'_>, length: usize) -> Checked {
    let path = rest.take(length)?;
    rest.end()?;
    let route = path.strip_suffix(&END_OF_CONNECTION);
    ports(Bytes(
        route.ok_or("a connection that does not end at the message router")?,
    ))
}

/// Nothing but ports.
fn ports(mut rest: Bytes<'_>) -> Checked {
    while !rest.0.is_empty() {
        let before = rest.0.len();
        let first = rest.byte()?;
        let (port, is_long) = (first & 0x0F, first & 0x10 != 0);
        if first & 0xE0 != 0 || port == 0 {
            return Err("a route through something that is not a port".to_owned());
        }
        let length = if is_long { usize::from(rest.byte()?) } else { 1 };
        if port == 0x0F {
            rest.word()?;
        }
        rest.take(length)?;
        rest.padding(before - rest.0.len())?;
    }
    Ok(())
}

/// What a message is asked of.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Target {
    /// An instance of a class.
    Object { class: u32, instance: u32 },
    /// An instance of the class of symbols: a tag by its number, or where a list of names begins.
    Symbol,
    /// A tag, or a part of one.
    Tag,
}

impl fmt::Display for Target {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Target::Object { class, instance } => write!(f, "class {class:02X} instance {instance}"),
            Target::Symbol => write!(f, "a symbol"),
            Target::Tag => write!(f, "a tag"),
        }
    }
}

/// A segment of a path.
enum Segment {
    Class(u32),
    Instance(u32),
    Element,
    Name,
}

impl Target {
    fn of(mut path: Bytes<'_>) -> Checked<Target> {
        let strange = || "its path is of another kind".to_owned();
        let mut first = segment(&mut path)?;
        // The name of a program may come before the number of a tag, and before where a list begins.
        let is_named = matches!(first, Segment::Name);
        if is_named && path.0.first().is_some_and(|byte| matches!(byte, 0x20..=0x22)) {
            first = segment(&mut path)?;
        }
        let mut target = match first {
            Segment::Name => Target::Tag,
            Segment::Class(class) => match segment(&mut path)? {
                Segment::Instance(_) if class == SYMBOL => Target::Symbol,
                Segment::Instance(instance) if !is_named => Target::Object { class, instance },
                _ => return Err(strange()),
            },
            Segment::Instance(_) | Segment::Element => return Err(strange()),
        };
        while !path.0.is_empty() {
            let is_part = matches!(segment(&mut path)?, Segment::Element | Segment::Name);
            if !is_part || matches!(target, Target::Object { .. }) {
                return Err(strange());
            }
            target = Target::Tag;
        }
        Ok(target)
    }
}

fn segment(path: &mut Bytes<'_>) -> Checked<Segment> {
    let kind = path.byte()?;
    if kind == 0x91 {
        let length = usize::from(path.byte()?);
        if length == 0 {
            return Err("a name without letters".to_owned());
        }
        path.take(length)?;
        path.padding(length)?;
        return Ok(Segment::Name);
    }
    let number = match kind & 0x03 {
        0 => u32::from(path.byte()?),
        1 => {
            path.padding(1)?;
            u32::from(path.word()?)
        }
        2 => {
            path.padding(1)?;
            u32::from(path.word()?) | u32::from(path.word()?) << 16
        }
        _ => return Err("its path is of another kind".to_owned()),
    };
    match kind & !0x03 {
        0x20 => Ok(Segment::Class(number)),
        0x24 => Ok(Segment::Instance(number)),
        0x28 => Ok(Segment::Element),
        _ => Err("its path is of another kind".to_owned()),
    }
}

/// What is left of a frame.
#[derive(Clone, Copy)]
struct Bytes<'a>(&'a [u8]);

impl<'a> Bytes<'a> {
    fn take(&mut self, count: usize) -> Checked<&'a [u8]> {
        let (taken, rest) = self.0.split_at_checked(count).ok_or("it is cut")?;
        self.0 = rest;
        Ok(taken)
    }

    fn byte(&mut self) -> Checked<u8> {
        Ok(self.take(1)?[0])
    }

    fn word(&mut self) -> Checked<u16> {
        let bytes = self.take(2)?;
        Ok(u16::from_le_bytes([bytes[0], bytes[1]]))
    }

    /// After an odd number of bytes there is one more, which is zero.
    fn padding(&mut self, count: usize) -> Checked {
        if count % 2 == 1 && self.byte()? != 0 {
            return Err("something where nothing should be".to_owned());
        }
        Ok(())
    }

    fn end(self) -> Checked {
        self.of_length(0)
    }

    fn of_length(self, length: usize) -> Checked {
        if self.0.len() == length {
            Ok(())
        } else {
            Err("its length is wrong".to_owned())
        }
    }
}

#[cfg(test)]
mod tests;
