//! Bytes as people type them.

use super::{asked::MOST_RAW, traffic::hex};
use roomba_oi::Opcode;
use serde::Serialize;

/// Commands that move the robot, or may later.
const MOVING: [Opcode; 11] = [
    Opcode::Spot,
    Opcode::Clean,
    Opcode::Max,
    Opcode::Drive,
    Opcode::Motors,
    Opcode::SeekDock,
    Opcode::PwmMotors,
    Opcode::DriveDirect,
    Opcode::DrivePwm,
    Opcode::Buttons,
    Opcode::Schedule,
];

/// Typed bytes, and what they would do.
#[derive(Debug, Clone, PartialEq, Eq, Serialize)]
#[cfg_attr(feature = "types", derive(ts_rs::TS))]
pub struct TypedBytes {
    /// Those to be sent; none if they are refused.
    pub bytes: Vec<u8>,
    /// Commands that may move the robot, by name and opcode.
    pub moving: Vec<String>,
    /// Whether they can't be sent.
    pub is_refused: bool,
    /// What to know about them, for users.
    pub told: String,
}

impl TypedBytes {
    /// Bytes in decimal (`142 35`) or hexadecimal (`0x8e $23`), between spaces, commas or semicolons.
    ///
    /// ```
    /// use robovac_link::connection::TypedBytes;
    /// let typed = TypedBytes::read("0x89 0 100 128 0");
    /// assert_eq!(typed.bytes, [137, 0, 100, 128, 0]);
    /// assert_eq!(typed.told, "5 bytes: 89 00 64 80 00. May move it: Drive (137).");
    /// ```
    pub fn read(text: &str) -> Self {
        let bytes = match parse(text) {
            Ok(bytes) => bytes,
            Err(told) => return Self { bytes: Vec::new(), moving: Vec::new(), is_refused: true, told },
        };
        if bytes.is_empty() {
            let told = "Bytes go to the robot unchanged and may move it.".to_owned();
            return Self { bytes, moving: Vec::new(), is_refused: false, told };
        }
        let (moving, refused) = effects(&bytes);
        let count = bytes.len();
        let mut told = format!("{count} byte{}: {}.", if count == 1 { "" } else { "s" }, hex(&bytes).to_lowercase());
        if !moving.is_empty() {
            told = format!("{told} May move it: {}.", moving.join(", "));
        }
        if let Some(why) = &refused {
            told = format!("{told} {why}");
        }
        let is_refused = refused.is_some();
        Self { bytes: if is_refused { Vec::new() } else { bytes }, moving, is_refused, told }
    }
}

/// The bytes, or a sentence for users that names the word that is none.
fn parse(text: &str) -> Result<Vec<u8>, String> {
    let is_between = |c: char| c.is_whitespace() || c == ',' || c == ';';
    let mut bytes = Vec::new();
    let mut at = 0;
    for word in text.split(is_between) {
        let first = at + 1;
        at += word.chars().count() + 1;
        if word.is_empty() {
            continue;
        }
        let place = format!("Byte {} (\"{word}\", at character {first})", bytes.len() + 1);
        let value = number(word).ok_or_else(|| format!("{place} isn't a number: {}.", hint(word)))?;
        let byte = u8::try_from(value).map_err(|_| format!("{place} is too large: a byte is 0 to 255."))?;
        bytes.push(byte);
    }
    if bytes.len() > MOST_RAW {
        return Err(format!("These are {} bytes; at most {MOST_RAW} can be sent at once.", bytes.len()));
    }
    Ok(bytes)
}

/// The number that a word stands for; one that is too large for any byte may be given smaller than it is.
fn number(word: &str) -> Option<u64> {
    let digits = ["0x", "0X", "$"].into_iter().find_map(|prefix| word.strip_prefix(prefix));
    let (digits, radix) = digits.map_or((word, 10), |digits| (digits, 16));
    let value = |sum: u64, c: char| Some(sum.saturating_mul(radix.into()).saturating_add(c.to_digit(radix)?.into()));
    if digits.is_empty() { None } else { digits.chars().try_fold(0, value) }
}

/// What to write instead.
fn hint(word: &str) -> String {
    let digits = word.strip_suffix(['h', 'H']).unwrap_or(word);
    if !digits.is_empty() && digits.chars().all(|c| c.is_ascii_hexdigit()) {
        format!("write 0x{digits} for hexadecimal")
    } else {
        "write decimal numbers, or hexadecimal ones with 0x".to_owned()
    }
}

/// Commands in it that may move the robot, and why it can't be sent, if so.
fn effects(bytes: &[u8]) -> (Vec<String>, Option<String>) {
    let (mut moving, mut refused) = (Vec::new(), None);
    let mut rest = bytes;
    while let &[first, ..] = rest {
        let opcode = Opcode::from_byte(first);
        if let Some(opcode) = opcode.filter(|opcode| MOVING.contains(opcode)) {
            let name = format!("{opcode} ({first})");
            if !moving.contains(&name) {
                moving.push(name);
            }
        }
        if opcode == Some(Opcode::Baud) {
            refused = Some(
                "Baud (129) isn't sent: at another speed this page could neither receive from the robot nor stop it."
                    .to_owned(),
            );
        }
        // A count that is missing is at least 0.
        let head: Vec<u8> = rest.iter().copied().chain([0, 0]).take(3).collect();
        let length = opcode.map_or(1, |opcode| opcode.command_length(&head).unwrap_or(1));
        let Some(after) = rest.get(length..) else {
            let lacks = length - rest.len();
            refused = Some(format!(
                "The last command lacks {lacks} byte{}: the robot would read the next bytes, even a stop command, as \
                 the rest of it. Complete it.",
                if lacks > 1 { "s" } else { "" }
            ));
            break;
        };
        rest = after;
    }
    (moving, refused)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn told(text: &str) -> String {
        let typed = TypedBytes::read(text);
        assert!(typed.is_refused && typed.bytes.is_empty(), "{typed:?}");
        typed.told
    }

    #[test]
    fn decimal_and_hexadecimal_numbers_are_read() {
        let typed = TypedBytes::read(" 142,0x23;\t$FF 007 0XfF\n");
        assert_eq!((typed.bytes.as_slice(), typed.is_refused), (&[142, 35, 255, 7, 255][..], false));
        assert_eq!(TypedBytes::read("128").told, "1 byte: 80.");
        assert_eq!(TypedBytes::read("0x8E 7").told, "2 bytes: 8e 07.");
        let empty = TypedBytes::read(" ,");
        assert_eq!((empty.bytes.len(), empty.is_refused), (0, false));
        assert_eq!(empty.told, "Bytes go to the robot unchanged and may move it.");
    }

    #[test]
    fn what_is_no_byte_is_named() {
        assert_eq!(told("142 300"), "Byte 2 (\"300\", at character 5) is too large: a byte is 0 to 255.");
        assert!(told("0x99999999999999999999").contains("is too large"));
        assert_eq!(
            told("142, zz"),
            "Byte 2 (\"zz\", at character 6) isn't a number: write decimal numbers, or hexadecimal ones with 0x."
        );
        assert!(told("8e").ends_with("isn't a number: write 0x8e for hexadecimal."));
        assert!(told("35H").ends_with("write 0x35 for hexadecimal."));
        for text in ["-1", "+1", "0x", "$", "1.5", "0xg", "h"] {
            assert!(told(text).ends_with("hexadecimal ones with 0x."), "{text}");
        }
        assert_eq!(told(&"7 ".repeat(257)), "These are 257 bytes; at most 256 can be sent at once.");
        assert_eq!(TypedBytes::read(&"7 ".repeat(256)).bytes.len(), 256);
    }

    #[test]
    fn what_may_move_the_robot_is_named_once() {
        let typed = TypedBytes::read("131 137 0 100 128 0 145 0 0 0 0 137 0 0 0 0 140 0 1 137 145");
        assert_eq!(typed.moving, ["Drive (137)", "Drive Direct (145)"]);
        // Data bytes are no commands.
        assert!(TypedBytes::read("148 3 137 145 134 142 35 255").moving.is_empty());
    }

    #[test]
    fn what_is_incomplete_or_changes_the_rate_is_refused() {
        for (text, lacks) in
            [("0x89 0 100", 2), ("140", 2), ("140 0", 1), ("140 0 2 60", 3), ("148", 1), ("149 2 7", 1)]
        {
            let end = if lacks > 1 { "s" } else { "" };
            assert!(told(text).contains(&format!("The last command lacks {lacks} byte{end}: ")), "{}", told(text));
        }
        assert!(told("129 7").contains("Baud (129) isn't sent"));
    }

    #[test]
    fn the_driver_refuses_the_same() {
        for opcode in Opcode::ALL {
            for data in 0..17 {
                let mut bytes = vec![*opcode as u8];
                bytes.resize(1 + data, 0);
                let text = bytes.iter().map(u8::to_string).collect::<Vec<_>>().join(" ");
                let sent = crate::driver::Driver::new().send_raw(0.0, &bytes);
                assert_eq!(TypedBytes::read(&text).is_refused, sent.is_err(), "{text}");
            }
        }
    }
}
