//! The controllers that LDmicro 2.2 knows, and the pins of their serial port and pulse output (from their data sheets).

/// A controller.
#[derive(Debug, Clone, Copy)]
pub(super) struct Chip {
    /// As `MICRO=` names it.
    pub(super) name: &'static str,
    /// The pin that receives; 0: it has no serial port.
    pub(super) receives: u32,
    /// The pin that sends.
    pub(super) sends: u32,
    /// The pin with the pulses; 0: none.
    pub(super) pulses: u32,
}

const fn chip(name: &'static str, receives: u32, sends: u32, pulses: u32) -> Chip {
    Chip {
        name,
        receives,
        sends,
        pulses,
    }
}

const CHIPS: &[Chip] = &[
    chip("Atmel AVR ATmega128 64-TQFP", 27, 28, 17),
    chip("Atmel AVR ATmega64 64-TQFP", 27, 28, 17),
    chip("Atmel AVR ATmega162 40-PDIP", 10, 11, 2),
    chip("Atmel AVR ATmega32 40-PDIP", 14, 15, 21),
    chip("Atmel AVR ATmega16 40-PDIP", 14, 15, 21),
    chip("Atmel AVR ATmega8 28-PDIP", 2, 3, 17),
    chip("Microchip PIC16F628 18-PDIP or 18-SOIC", 7, 8, 9),
    chip("Microchip PIC16F88 18-PDIP or 18-SOIC", 8, 11, 6),
    chip("Microchip PIC16F819 18-PDIP or 18-SOIC", 0, 0, 8),
    chip("Microchip PIC16F877 40-PDIP", 26, 25, 16),
    chip("Microchip PIC16F876 28-PDIP or 28-SOIC", 18, 17, 12),
    chip("Microchip PIC16F887 40-PDIP or 44-TQFP", 26, 25, 16),
    chip("Microchip PIC16F886 28-PDIP or 28-SOIC", 18, 17, 12),
    chip("ANSI C Code", 0, 0, 0),
    chip("Interpretable Byte Code", 0, 0, 0),
];

/// The controller with this name. The fork knows more of them; for LDmicro 2.2 those are none.
pub(super) fn by_name(name: &str) -> Option<&'static Chip> {
    CHIPS.iter().find(|chip| chip.name == name)
}
