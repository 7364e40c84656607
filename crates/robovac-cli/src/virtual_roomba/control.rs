//! Control commands on standard input, one a line: buttons, lifting, charger, cable.

use roomba_oi::Buttons;
use std::{
    io::{BufRead, Read},
    sync::mpsc::{Receiver, TryRecvError, sync_channel},
    thread,
};

/// Orders that are read ahead at most; whoever writes more has to wait.
const MOST_ORDERS: usize = 64;
/// Longest order, bytes; what follows on its line is ignored.
const LONGEST: u64 = 200;

/// Something to be done.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Order {
    Press(Buttons),
    Lift,
    /// Puts it down where it is.
    Drop,
    /// The charger.
    Plug(bool),
    /// The serial cable.
    Cable(bool),
    /// Low, or not.
    Brc(bool),
    State,
    Quit,
}

/// Where orders come from.
pub struct Control(Option<Receiver<String>>);

impl Control {
    pub fn new(is_wanted: bool) -> Self {
        if !is_wanted {
            return Self(None);
        }
        let (sender, receiver) = sync_channel(MOST_ORDERS);
        thread::spawn(move || {
            let mut stdin = std::io::stdin().lock();
            while let Some(line) = read_line(&mut stdin) {
                if sender.send(line).is_err() {
                    return;
                }
            }
        });
        Self(Some(receiver))
    }

    /// The next one that has come, or why it is none.
    pub fn next(&self) -> Option<Result<Order, String>> {
        match self.0.as_ref()?.try_recv() {
            Ok(line) => Some(parse(&line)),
            Err(TryRecvError::Empty) => None,
            Err(TryRecvError::Disconnected) => Some(Ok(Order::Quit)),
        }
    }
}

/// The beginning of the next line; `None` at the end of the input.
fn read_line(input: &mut impl BufRead) -> Option<String> {
    let mut line = Vec::new();
    let count = input.by_ref().take(LONGEST).read_until(b'\n', &mut line).ok()?;
    let is_whole = line.last() == Some(&b'\n') || (count as u64) < LONGEST;
    if !is_whole {
        input.skip_until(b'\n').ok()?;
    }
    (count > 0).then(|| String::from_utf8_lossy(&line).trim_end().to_owned())
}

fn parse(line: &str) -> Result<Order, String> {
    let words: Vec<&str> = line.split_ascii_whitespace().collect();
    Ok(match words[..] {
        ["press", "clean"] => Order::Press(Buttons { clean: true, ..Buttons::default() }),
        ["press", "spot"] => Order::Press(Buttons { spot: true, ..Buttons::default() }),
        ["press", "dock"] => Order::Press(Buttons { dock: true, ..Buttons::default() }),
        ["lift"] => Order::Lift,
        ["drop"] => Order::Drop,
        ["plug"] => Order::Plug(true),
        ["unplug"] => Order::Plug(false),
        ["unplug-line"] => Order::Cable(false),
        ["replug-line"] => Order::Cable(true),
        ["brc", "low"] => Order::Brc(true),
        ["brc", "high"] => Order::Brc(false),
        ["state"] => Order::State,
        ["quit"] => Order::Quit,
        _ => return Err(format!("there is no command \"{line}\"; \"robovac virtual-roomba --help\" lists them")),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lines_are_read_as_far_as_orders_can_be_long() {
        let long = "x".repeat(100_000);
        let text = format!("lift\n{long}\nstate\r\n\u{fffd}\nquit");
        let mut input = std::io::Cursor::new(text);
        let lines: Vec<String> = std::iter::from_fn(|| read_line(&mut input)).collect();
        assert_eq!(lines.len(), 5);
        assert_eq!(
            (lines[0].as_str(), lines[1].len(), lines[2].as_str(), lines[4].as_str()),
            ("lift", 200, "state", "quit")
        );
    }

    #[test]
    fn orders_are_words_and_others_are_named() {
        assert_eq!(parse(" brc  low "), Ok(Order::Brc(true)));
        assert_eq!(parse("press spot"), Ok(Order::Press(Buttons::from_byte(2))));
        assert!(parse("press").is_err_and(|why| why.contains("\"press\"")));
        assert!(parse("").is_err());
    }
}
