//! Words that a program for systems of IEC 61131-3 cannot use as names of its own.

use std::collections::HashSet;
use std::sync::LazyLock;

/// Keywords and types, of all editions and common systems.
const WORDS: &str = "ABSTRACT ACTION AND AND_THEN ANDN ANY ANY_BIT ANY_DATE ANY_DERIVED ANY_ELEMENTARY ANY_INT ANY_MAGNITUDE ANY_NUM \
    ANY_REAL ANY_STRING ARRAY AT BOOL BY BYTE CAL CALC CALCN CASE CHAR CLASS CONFIGURATION CONSTANT CONTINUE DATE DATE_AND_TIME DINT DO DT \
    DWORD ELSE ELSIF EN END_ACTION END_CASE END_CLASS END_CONFIGURATION END_FOR END_FUNCTION END_FUNCTION_BLOCK END_IF \
    END_INTERFACE END_METHOD END_NAMESPACE END_PROGRAM END_PROPERTY END_REPEAT END_RESOURCE END_STEP END_STRUCT END_TRANSITION END_TYPE \
    END_UNION END_VAR END_WHILE ENO EXIT EXTENDS F_EDGE FALSE FINAL FOR FROM FUNCTION FUNCTION_BLOCK GOTO IF IMPLEMENTS INITIAL_STEP INT \
    INTERFACE INTERNAL INTERVAL JMP JMPC JMPCN LD LDATE LDN LDT LINT LREAL LTIME LTOD LWORD METHOD MOD NAMESPACE NIL NON_RETAIN NOT NULL OF \
    ON OR OR_ELSE ORN OVERLAP OVERRIDE POINTER PRIORITY PRIVATE PROGRAM PROPERTY PROTECTED PUBLIC R_EDGE READ_ONLY READ_WRITE REAL REF REF_TO \
    REFERENCE REPEAT RESOURCE RET RETAIN RETC RETCN RETURN SINGLE SINT SIZEOF ST STEP STN STRING STRUCT SUPER TASK THEN THIS TIME \
    TIME_OF_DAY TO TOD TRANSITION TRUE TYPE UDINT UINT ULINT UNION UNTIL USING USINT VAR VAR_ACCESS VAR_CONFIG VAR_EXTERNAL VAR_GLOBAL \
    VAR_IN_OUT VAR_INPUT VAR_INST VAR_OUTPUT VAR_STAT VAR_TEMP VOID WCHAR WHILE WITH WORD WSTRING XOR XORN";

/// Functions of the standard. Compilers know most of them for one type too, as in `ADD_INT`.
const FUNCTIONS: &str = "ABS ACOS ADD ADR AND ASIN ATAN ATAN2 CEIL CONCAT CONCAT_DATE_TOD COS DELETE DIV DIVTIME EQ EXP EXPT FIND \
    FLOOR GE GT INSERT LE LEFT LEN LIMIT LN LOG LT MAX MID MIN MOD MOVE MUL MULTIME MUX NE NOT OR REPLACE RIGHT ROL ROR ROUND SEL \
    SHL SHR SIN SQRT SUB TAN TRUNC XOR";

/// Function blocks of the standard, of its annexes, and those that come with OpenPLC Editor. Compilers know counters for one type too.
const BLOCKS: &str = "CTD CTU CTUD DERIVATIVE F_TRIG HYSTERESIS INTEGRAL PID R_TRIG RAMP RS RTC SEMA SR TOF TON TP \
    ADC_CONFIG ARDUINOCAN_CONF ARDUINOCAN_READ ARDUINOCAN_WRITE ARDUINOCAN_WRITE_WORD CLOUD_ADD_BOOL CLOUD_ADD_DINT CLOUD_ADD_REAL \
    CLOUD_BEGIN DS18B20 DS18B20_2_OUT DS18B20_3_OUT DS18B20_4_OUT DS18B20_5_OUT MQTT_CONNECT MQTT_CONNECT_AUTH MQTT_DISCONNECT \
    MQTT_RECEIVE MQTT_SEND MQTT_SUBSCRIBE MQTT_UNSUBSCRIBE P1AM_INIT P1_04AD P1_08N P1_08T P1_16CDR P1_16N P1_16TR PWM_CONTROLLER \
    ROTARY_SWITCH SM_16DIN SM_16RELAY SM_4REL4IN SM_8DIN SM_8MOSFET SM_8RELAY SM_BAS SM_HOME SM_INDUSTRIAL SM_RTD STM32CAN_CONF \
    STM32CAN_READ STM32CAN_WRITE TCP_CLOSE TCP_CONNECT TCP_RECEIVE TCP_SEND";

/// Names that mean something in C, to which matiec and what is built on it translate, in capitals as they write all names.
const OF_C: &str = "BUFSIZ EOF FILE HUGE_VAL INFINITY NAN RAND_MAX";

static RESERVED: LazyLock<HashSet<&str>> = LazyLock::new(|| {
    let all = [WORDS, FUNCTIONS, BLOCKS, OF_C];
    all.into_iter().flat_map(str::split_whitespace).collect()
});

const TYPES: &[&str] = &[
    "BOOL", "BYTE", "WORD", "DWORD", "LWORD", "SINT", "INT", "DINT", "LINT", "USINT", "UINT", "UDINT",
    "ULINT", "REAL", "LREAL", "TIME", "DATE", "TOD", "DT", "STRING", "BCD",
];

/// Whether a name is a keyword, a type, a function or a function block there, or becomes one.
pub fn is_reserved_in_iec(name: &str) -> bool {
    let name = name.to_ascii_uppercase();
    if RESERVED.contains(name.as_str()) || name.starts_with("TO_") && is_of_types(&name[3..]) {
        return true;
    }
    // `ADD_INT`, `MUX_DINT_BOOL`, `CTU_UDINT`, `INT_TO_REAL`
    let Some((first, rest)) = name.split_once('_') else {
        return false;
    };
    (RESERVED.contains(first) || TYPES.contains(&first)) && is_of_types(rest)
}

/// Whether a name is one of types alone.
fn is_of_types(name: &str) -> bool {
    name.split('_')
        .all(|word| TYPES.contains(&word) || matches!(word, "TO" | "TRUNC"))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_that_mean_something_there() {
        for name in [
            "left",
            "Integral",
            "PID",
            "var_input",
            "int_to_real",
            "ADD_TIME",
            "CTU_DINT",
            "mux_int_bool",
            "to_int",
            "null",
        ] {
            assert!(is_reserved_in_iec(name), "{name}");
        }
        for name in [
            "motor",
            "left_door",
            "int_count",
            "real_speed",
            "time_left",
            "to_door",
            "pid_1",
            "add",
        ] {
            assert_eq!(is_reserved_in_iec(name), name == "add", "{name}");
        }
    }
}
