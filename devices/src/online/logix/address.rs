//! Where a Logix controller is: `10.0.0.5`, `10.0.0.5/0`, `10.0.0.5:44818/bp/1/enet/10.1.1.1/bp/0`.

use ciplink::epath::{encode_epath, parse_connection_path};

/// Whether it is the address of a controller.
///
/// # Errors
/// It is not: what is wrong, and what it should be.
pub(super) fn check(address: &str) -> Result<(), String> {
    let (host, _, route) =
        parse_connection_path(address, true).map_err(|error| wrong(address, &error.to_string()))?;
    if host.is_empty() || address.contains(|letter: char| letter.is_whitespace() || letter.is_control()) {
        return Err(wrong(address, "it names no host"));
    }
    encode_epath(&route, true, true, true)
        .map(|_| ())
        .map_err(|_| wrong(address, "what follows the host is neither a slot nor a route"))
}

/// What is wrong with an address, and what is right.
pub(super) fn wrong(address: &str, why: &str) -> String {
    format!(
        "{address:?} is not the address of a Logix controller ({why}): write HOST/SLOT, as 10.0.0.5/0 for the processor in slot 0, or a route as 10.0.0.5/bp/1/enet/10.1.1.1/bp/0"
    )
}

#[cfg(test)]
mod tests {
    use super::check;

    #[test]
    fn addresses() {
        for right in [
            "10.0.0.5",
            "10.0.0.5/0",
            "plc.example:44818/3",
            "10.0.0.5/bp/1/enet/10.1.1.1/bp/0",
            "10.0.0.5/1/2",
        ] {
            assert_eq!(check(right), Ok(()));
        }
        for wrong in [
            "",
            "/0",
            "10.0.0.5/x",
            "10.0.0.5/256",
            "10.0.0.5:0",
            "10.0.0.5:99999",
            "a b/0",
            "10.0.0.5/bp/1/2",
            "::1",
        ] {
            let why = check(wrong).expect_err(wrong);
            assert!(why.contains("HOST/SLOT"), "{why}");
        }
    }
}
