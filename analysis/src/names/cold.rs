//! What few tags have.
//!
//! A program of ten thousand rungs has twenty thousand tags and more, and nearly all of them are a name with a type: for
//! those the rest takes one word.

use crate::names::scope::Entry;
use crate::values::value::Value;
use crate::written::type_spec::Declared;
use std::ops::{Deref, DerefMut};
use std::sync::Arc;

/// What few tags have: it is read through [`Cold`].
#[derive(Debug, Clone)]
pub struct ColdFacts {
    /// Initial values; empty for the type's own.
    pub initial: Vec<Value>,
    /// What its declaration says of its type, if that is more than an elementary type, a state or an array of elementary values.
    pub declared: Option<Arc<Declared>>,
    /// The address after AT, or the address itself.
    pub address: Option<Box<str>>,
    /// The tag that this entry leads to, if it is one of another scope.
    pub(crate) alias_of: Option<Entry>,
    /// The file that declares it, if it is a VAR_GLOBAL tag of another one.
    pub foreign: Option<Arc<str>>,
}

/// Of most tags.
static NONE: ColdFacts = ColdFacts::NONE;

impl ColdFacts {
    /// Nothing of it.
    pub(crate) const NONE: ColdFacts = ColdFacts {
        initial: Vec::new(),
        declared: None,
        address: None,
        alias_of: None,
        foreign: None,
    };
}

/// [`ColdFacts`] of a tag, which takes memory only where there are some.
#[derive(Debug, Clone, Default)]
pub struct Cold(Option<Box<ColdFacts>>);

impl From<ColdFacts> for Cold {
    fn from(facts: ColdFacts) -> Cold {
        let is_any = !facts.initial.is_empty()
            || facts.declared.is_some()
            || facts.address.is_some()
            || facts.alias_of.is_some()
            || facts.foreign.is_some();
        Cold(is_any.then(|| Box::new(facts)))
    }
}

impl Deref for Cold {
    type Target = ColdFacts;

    fn deref(&self) -> &ColdFacts {
        self.0.as_deref().unwrap_or(&NONE)
    }
}

impl DerefMut for Cold {
    fn deref_mut(&mut self) -> &mut ColdFacts {
        self.0.get_or_insert_with(|| Box::new(ColdFacts::NONE))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::names::scope::TagFacts;

    /// With the two counts before it a tag takes what the allocator gives for 128 bytes.
    #[test]
    fn a_tag_is_small() {
        assert!(size_of::<TagFacts>() <= 112, "{}", size_of::<TagFacts>());
    }

    #[test]
    fn nothing_takes_nothing() {
        assert!(Cold::from(ColdFacts::NONE).0.is_none());
        let mut cold = Cold::from(ColdFacts::NONE);
        cold.alias_of = Some((1, 2));
        assert_eq!(cold.alias_of, Some((1, 2)));
    }
}
