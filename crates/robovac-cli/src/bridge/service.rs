//! What systemd wants to know of a service of `Type=notify`: that it is ready, and that it isn't stuck (`sd_notify`(3)).

/// Time between two signs of life, ms.
const EVERY_MS: u64 = 100;

/// The manager of services that started this program, if there is one.
pub struct Service {
    #[cfg(unix)]
    socket: Option<std::os::unix::net::UnixDatagram>,
    told_ms: u64,
}

impl Service {
    /// Connects to it by the environment. Without one, nothing is ever sent.
    pub fn from_environment() -> Self {
        Self {
            #[cfg(unix)]
            socket: std::env::var_os("NOTIFY_SOCKET").and_then(|name| connect(name.as_encoded_bytes()).ok()),
            told_ms: 0,
        }
    }

    /// The robot is stopped, and clients may connect.
    pub fn ready(&self) {
        self.tell("READY=1");
    }

    /// Still there; to be called in every round of the program, so that a program that is stuck falls silent.
    pub fn alive(&mut self, now_ms: u64) {
        if now_ms.saturating_sub(self.told_ms) >= EVERY_MS {
            self.told_ms = now_ms;
            self.tell("WATCHDOG=1");
        }
    }

    #[cfg(unix)]
    fn tell(&self, text: &str) {
        if let Some(socket) = &self.socket {
            // It isn't waited for: a manager that reads late gets the next one.
            let _ = socket.send(text.as_bytes());
        }
    }

    #[cfg(not(unix))]
    fn tell(&self, _text: &str) {}
}

/// Connects to a socket by its path, or by its abstract name if that begins with "@".
#[cfg(unix)]
fn connect(name: &[u8]) -> std::io::Result<std::os::unix::net::UnixDatagram> {
    use std::os::unix::{ffi::OsStrExt, net::UnixDatagram};
    let socket = UnixDatagram::unbound()?;
    socket.set_nonblocking(true)?;
    match name.strip_prefix(b"@") {
        #[cfg(target_os = "linux")]
        Some(name) => {
            use std::os::linux::net::SocketAddrExt;
            socket.connect_addr(&std::os::unix::net::SocketAddr::from_abstract_name(name)?)?;
        }
        _ => socket.connect(std::ffi::OsStr::from_bytes(name))?,
    }
    Ok(socket)
}
