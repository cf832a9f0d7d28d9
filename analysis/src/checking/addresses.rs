//! Which direct addresses have to do with each other: those of several tags, and those that overlap.
//!
//! In most programs there are none. They are kept from one text to the next, so that an edit looks at what is around the
//! addresses that it touches, and not at all of them.

use super::at_tags::TagKey;
use crate::address_bits::AddressBits;
use ladder_syntax::Name;
use rustc_hash::{FxHashMap, FxHashSet};
use std::collections::BTreeMap;

/// The addresses of a file's tags.
#[derive(Debug, Default)]
pub(super) struct Addresses {
    of_tags: FxHashMap<TagKey, Name>,
    /// The tags at each address, in no order.
    tags: FxHashMap<Name, Vec<TagKey>>,
    by_bits: BTreeMap<AddressBits, Name>,
    /// Those that several tags have, and those that overlap.
    involved: FxHashSet<Name>,
}

impl Addresses {
    /// A tag has this address, or none any longer.
    pub(super) fn set(&mut self, key: &TagKey, address: Option<&str>) {
        let address = address.map(Name::new);
        if self.of_tags.get(key) == address.as_ref() {
            return;
        }
        if let Some(old) = self.of_tags.remove(key) {
            self.take(&old, key);
            self.look_around(&old);
        }
        if let Some(new) = address {
            self.of_tags.insert(key.clone(), new.clone());
            self.tags.entry(new.clone()).or_default().push(key.clone());
            if let Some(bits) = AddressBits::of(new.as_str()) {
                self.by_bits.insert(bits, new.clone());
            }
            self.look_around(&new);
        }
    }

    fn take(&mut self, address: &Name, key: &TagKey) {
        let Some(tags) = self.tags.get_mut(address) else {
            return;
        };
        tags.retain(|tag| tag != key);
        if tags.is_empty() {
            self.tags.remove(address);
            if let Some(bits) = AddressBits::of(address.as_str()) {
                self.by_bits.remove(&bits);
            }
        }
    }

    /// Looks at an address that has come or gone, and at those that overlap it.
    fn look_around(&mut self, address: &Name) {
        let mut again: Vec<Name> = self.overlapping(address).cloned().collect();
        again.push(address.clone());
        for address in again {
            if self.is_involved(&address) {
                self.involved.insert(address);
            } else {
                self.involved.remove(&address);
            }
        }
    }

    fn is_involved(&self, address: &Name) -> bool {
        let tags = self.tags.get(address).map_or(0, Vec::len);
        tags > 1 || tags == 1 && self.overlapping(address).any(|other| other != address)
    }

    /// The addresses that overlap one, and that itself where it is there.
    fn overlapping<'a>(&'a self, address: &Name) -> impl Iterator<Item = &'a Name> + use<'a> {
        let bits = AddressBits::of(address.as_str());
        let holders = bits.into_iter().flat_map(AddressBits::holders);
        let holders = holders.filter_map(|holder| self.by_bits.get(&holder));
        let held = bits.into_iter().flat_map(|bits| self.by_bits.range(bits.held()));
        holders.chain(held.map(|(_, name)| name))
    }

    /// The tags at addresses that several tags have, or that overlap; in no order.
    pub(super) fn involved(&self) -> impl Iterator<Item = &TagKey> {
        let tags = self.involved.iter().filter_map(|address| self.tags.get(address));
        tags.flatten()
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn involved(addresses: &Addresses) -> Vec<&str> {
        let mut names: Vec<&str> = addresses.involved().map(|(_, name)| name.as_str()).collect();
        names.sort_unstable();
        names
    }

    #[test]
    fn addresses_that_come_and_go() {
        let mut addresses = Addresses::default();
        let key = |name: &str| (0, Name::new(name));
        for (tag, address, expected) in [
            ("a", Some("%IX0.3"), vec![]),
            ("b", Some("%IX0.4"), vec![]),
            ("c", Some("%IW0"), vec!["a", "b", "c"]),
            ("c", Some("%IW1"), vec![]),
            ("d", Some("%IL0"), vec!["a", "b", "c", "d"]),
            ("a", None, vec!["b", "c", "d"]),
            ("e", Some("%IX0.04"), vec!["b", "c", "d", "e"]),
            ("d", None, vec!["b", "e"]),
            ("b", Some("%QX0.4"), vec![]),
            ("f", Some("%MX1"), vec![]),
            ("g", Some("%MX1"), vec!["f", "g"]),
        ] {
            addresses.set(&key(tag), address);
            assert_eq!(involved(&addresses), expected, "{tag} {address:?}");
        }
    }
}
