//! Signals that ask the program to end.

use super::failure::Failure;
use std::sync::{Arc, atomic::AtomicBool};

/// Becomes true on Ctrl-C, SIGTERM or SIGHUP, instead of the program ending at once.
pub fn end_requested() -> Result<Arc<AtomicBool>, Failure> {
    let is_over = Arc::new(AtomicBool::new(false));
    #[cfg(unix)]
    for signal in [signal_hook::consts::SIGINT, signal_hook::consts::SIGTERM, signal_hook::consts::SIGHUP] {
        signal_hook::flag::register(signal, Arc::clone(&is_over)).map_err(|e| Failure::io("signals", &e))?;
    }
    Ok(is_over)
}
