//! Profiles: whose arithmetic and timing a program has (LANGUAGE §5.8).

/// The system that a program behaves as on.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord, Default)]
pub enum Profile {
    /// IEC 61131-3, as the language describes it.
    #[default]
    Iec,
    /// LDmicro 2.2.
    Ldmicro,
    /// Click controllers.
    Click,
    /// iot-ladder-editor.
    Iot,
    /// Logix 5000 controllers.
    Logix,
}

impl Profile {
    /// All of them.
    pub const ALL: [Profile; 5] = [
        Profile::Iec,
        Profile::Ldmicro,
        Profile::Click,
        Profile::Iot,
        Profile::Logix,
    ];

    /// As `# ladder: profile .. #` names it.
    pub const fn name(self) -> &'static str {
        match self {
            Profile::Iec => "iec",
            Profile::Ldmicro => "ldmicro",
            Profile::Click => "click",
            Profile::Iot => "iot",
            Profile::Logix => "logix",
        }
    }

    /// The profile with this name.
    pub fn from_name(name: &str) -> Option<Profile> {
        Profile::ALL.into_iter().find(|profile| profile.name() == name)
    }
}

impl std::fmt::Display for Profile {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.write_str(self.name())
    }
}

/// Some of the profiles: those that have an instruction, or know an operand.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Profiles(u8);

impl Profiles {
    /// All of them.
    pub const ALL: Profiles = Profiles(u8::MAX);

    /// Those of this project's own: LDmicro and iot-ladder-editor have no such thing.
    pub const OWN: Profiles = Profiles::only(Profile::Iec)
        .and(Profile::Click)
        .and(Profile::Logix);

    /// All but `iot`.
    pub(crate) const WITHOUT_IOT: Profiles = Profiles::OWN.and(Profile::Ldmicro);

    /// All but `ldmicro`.
    pub(crate) const WITHOUT_LDMICRO: Profiles = Profiles::OWN.and(Profile::Iot);

    /// One alone.
    pub(crate) const fn only(profile: Profile) -> Profiles {
        Profiles(1 << profile as u8)
    }

    /// These and one more.
    #[must_use]
    pub(crate) const fn and(self, profile: Profile) -> Profiles {
        Profiles(self.0 | 1 << profile as u8)
    }

    /// Whether it is one of them.
    pub const fn contain(self, profile: Profile) -> bool {
        self.0 & (1 << profile as u8) != 0
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn sets_hold_what_they_were_made_of() {
        let some = Profiles::only(Profile::Iot).and(Profile::Click);
        let held: Vec<Profile> = Profile::ALL.into_iter().filter(|p| some.contain(*p)).collect();
        assert_eq!(held, [Profile::Click, Profile::Iot]);
        assert!(
            Profile::ALL
                .into_iter()
                .all(|profile| Profiles::ALL.contain(profile))
        );
    }

    #[test]
    fn names_lead_back() {
        for profile in Profile::ALL {
            assert_eq!(Profile::from_name(profile.name()), Some(profile));
        }
        assert_eq!(Profile::from_name("IEC"), None);
    }
}
