//! The header: what a caller includes.

use crate::constants::Constants;
use crate::data::sizes;
use crate::interface::{Field, Interface};
use crate::retained;
use ladder_simulator::compiled::Compiled;
use std::collections::BTreeSet;
use std::fmt::Write;

/// Text that may stand in a comment of C.
pub(crate) fn comment(text: &str) -> String {
    text.replace("*/", "* /")
        .replace("/*", "/ *")
        .replace(['\n', '\r'], " ")
}

pub(crate) const FAULTS: [(&str, &str); 13] = [
    ("DIVISION", "a division by zero"),
    ("EXPONENT", "a whole number with a negative exponent"),
    ("SHIFT", "a shift by less than 0 places"),
    ("DOMAIN", "a function outside its domain"),
    ("INFINITE", "a real that is too large"),
    ("INDEX", "an index outside its array"),
    ("SELECTOR", "a selector that selects nothing"),
    ("RANGE", "a value that the type of the result cannot hold"),
    ("TEXT", "a text that is no number, time or BOOL"),
    ("POSITION", "a position outside a text"),
    ("LENGTHS", "ranges of different lengths"),
    ("EMPTY", "a range that ends before it begins"),
    (
        "ENDLESS",
        "a loop without an end, or calls nested too deep: no scan follows",
    ),
];

/// What the source calls the faults that the header names after the program.
pub(crate) fn faults(upper: &str) -> String {
    let names = FAULTS
        .iter()
        .flat_map(|(name, _)| ["    FAULT_", name, " = ", upper, "_FAULT_", name, ",\n"]);
    format!("enum {{\n{}}};\n\n", names.collect::<String>())
}

fn structure(name: &str, what: &str, fields: &[Field]) -> String {
    let mut out = format!("/* {what} */\ntypedef struct {name} {{\n");
    if fields.is_empty() {
        out.push_str("    bool none; /* C has no empty structures */\n");
    }
    out.extend(fields.iter().map(Field::declaration));
    let _ = write!(out, "}} {name};\n\n");
    out
}

/// The header of a library.
pub(crate) fn header(p: &str, interface: &Interface, constants: &Constants, compiled: &Compiled) -> String {
    let upper = p.to_ascii_uppercase();
    let sizes = sizes(compiled);
    let mut out = format!(
        "/* The ladder program {p} as a C library. Written by `ladder convert`: change the program, not this file.\n *\n \
         *     static {p} plant;\n *     {p}_init(&plant);\n *     for (;;) {{\n \
         *         plant.in.. = ..;                what the inputs are\n \
         *         {p}_scan(&plant, now);          now in nanoseconds, from any instant on\n \
         *         .. = plant.out..;               what the outputs are to be\n *     }}\n */\n\
         #ifndef {upper}_H\n#define {upper}_H\n\n#include <stdbool.h>\n#include <stddef.h>\n#include <stdint.h>\n\n\
         #ifdef __cplusplus\nextern \"C\" {{\n#endif\n\n"
    );
    let parts: BTreeSet<&str> = compiled
        .code
        .unread
        .iter()
        .map(|part| part.name.as_str())
        .collect();
    if !parts.is_empty() {
        let parts: Vec<String> = parts.into_iter().map(comment).collect();
        let _ = write!(
            out,
            "/* These unread parts of the program are not in it: {}. A scan runs past them. */\n\n",
            parts.join(", ")
        );
    }
    out.push_str(&structure(
        &format!("{p}_inputs"),
        "Set before each scan. TIME is in nanoseconds.",
        &interface.inputs,
    ));
    out.push_str(&structure(
        &format!("{p}_outputs"),
        "Written by each scan.",
        &interface.outputs,
    ));
    out.push_str("/* What can go wrong in a block: it has no power then, and writes nothing. */\nenum {\n");
    for (number, (name, what)) in (1..).zip(FAULTS) {
        let _ = writeln!(out, "    {upper}_FAULT_{name} = {number}, /* {what} */");
    }
    out.push_str("};\n\n");
    let _ = write!(
        out,
        "/* A running program: all that it remembers. */\ntypedef struct {p} {{\n    {p}_inputs in;\n    {p}_outputs out;\n    \
         bool ended;            /* <END> was reached: no scan follows */\n    bool stopped;          /* a fault stopped the program */\n    \
         uint32_t faults;       /* how many there were */\n    int fault;             /* the last one, 0 for none */\n    \
         uint32_t fault_line;   /* the line of the program that it was in */\n"
    );
    let ports = compiled.ports;
    if ports.serial || ports.analog.is_some() || ports.pulse.is_some() {
        out.push_str("    void *user;            /* for the functions below */\n");
    }
    if ports.serial {
        out.push_str("    int (*receive)(void *user);                 /* the next byte, or -1 */\n    void (*send)(void *user, uint8_t byte);\n");
    }
    if ports.analog.is_some() {
        out.push_str("    int64_t (*analog)(void *user, uint32_t channel); /* asked before each scan */\n");
    }
    if ports.pulse.is_some() {
        out.push_str(
            "    void (*pulse)(void *user, uint32_t channel, int64_t duty, int64_t frequency); /* told after each scan: percent, Hz */\n",
        );
    }
    let _ = write!(
        out,
        "    /* Its memory. */\n    int64_t now;\n    int64_t began;\n    uint32_t scans;\n    bool faulted;\n    uint8_t b[{}];\n    int64_t w[{}];\n",
        sizes.bits, sizes.words
    );
    if sizes.texts > 0 {
        let _ = write!(
            out,
            "    uint16_t length[{}];\n    uint8_t chars[{}];\n",
            sizes.texts,
            sizes.chars.max(1)
        );
    }
    let _ = write!(out, "}} {p};\n\n");
    out.push_str(&places(constants));
    let _ = write!(
        out,
        "/* A cold start. The functions for ports stay as they are set. */\nvoid {p}_init({p} *self);\n\n\
         /* Runs one scan; now is in nanoseconds and never goes back. False if the program has ended or a fault stopped it. */\n\
         bool {p}_scan({p} *self, int64_t now);\n"
    );
    if !compiled.retained.is_empty() {
        let _ = write!(
            out,
            "\n/* What is kept over a loss of power, in so many bytes; after `{p}_init`, and false if they are not those of this program. */\n\
             #define {upper}_RETAINED {}\nvoid {p}_save(const {p} *self, uint8_t *bytes);\nbool {p}_restore({p} *self, const uint8_t *bytes);\n",
            retained::size(compiled)
        );
    }
    out.push_str("\n#ifdef __cplusplus\n}\n#endif\n\n#endif\n");
    out
}

/// Where the tags are: for the source, a debugger, or a test.
fn places(constants: &Constants) -> String {
    let mut out = String::new();
    for (bank, tags) in [('b', &constants.bits), ('w', &constants.words)] {
        for tag in tags.values() {
            let meaning = comment(&tag.meaning);
            let _ = writeln!(out, "    {} = {}, /* in {bank}: {meaning} */", tag.name, tag.at);
        }
    }
    if out.is_empty() {
        return out;
    }
    format!("/* Where the tags are in the memory. */\nenum {{\n{out}}};\n\n")
}
