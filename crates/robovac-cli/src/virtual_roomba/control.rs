//! Control commands on standard input, one a line: buttons, lifting, charger, cable.

use roomba_oi::Buttons;
use std::{
    io::BufRead,
    sync::mpsc::{Receiver, TryRecvError, channel},
    thread,
};

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
        let (sender, receiver) = channel();
        thread::spawn(move || {
            for line in std::io::stdin().lock().lines().map_while(Result::ok) {
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
    fn orders_are_words_and_others_are_named() {
        assert_eq!(parse(" brc  low "), Ok(Order::Brc(true)));
        assert_eq!(parse("press spot"), Ok(Order::Press(Buttons::from_byte(2))));
        assert!(parse("press").is_err_and(|why| why.contains("\"press\"")));
        assert!(parse("").is_err());
    }
}
