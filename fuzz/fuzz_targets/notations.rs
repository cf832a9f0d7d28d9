#![no_main]

libfuzzer_sys::fuzz_target!(|data: &[u8]| ladder_invariants::check("notations", data));
