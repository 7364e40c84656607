//! A pseudo-terminal with a symbolic link to it, which other programs open as a serial port.
//!
//! It is raw before the link appears: no byte is echoed, translated or held back until a line is complete. This side keeps the
//! terminal open, so that programs may come and go. Its rate is the one that a program sets, and a rate that isn't the
//! robot's garbles bytes as on a real line. It has no modem lines: RTS, and so BRC, can't be reached through it.

use super::line::HostLine;
use crate::failure::Failure;
use rustix::{
    fs::{Mode, OFlags, open},
    io::{Errno, ioctl_fionbio, read, write},
    pty::{OpenptFlags, grantpt, openpt, ptsname, unlockpt},
    termios::{OptionalActions, QueueSelector, tcflush, tcgetattr, tcsetattr},
};
use std::{
    fs,
    io::{Error, ErrorKind},
    os::{fd::OwnedFd, unix::fs::symlink},
    path::{Path, PathBuf},
    process,
};

/// The rate before any program has set one.
const BAUD: u32 = 115_200;

/// A pseudo-terminal; none while its cable is pulled out.
pub struct Pty {
    link: PathBuf,
    ends: Option<PtyEnds>,
}

struct PtyEnds {
    /// The robot's.
    robot: OwnedFd,
    /// The host's, kept open.
    host: OwnedFd,
    /// The terminal that the link leads to.
    path: PathBuf,
}

impl Pty {
    pub fn open(link: &Path) -> Result<Self, Failure> {
        let ends = PtyEnds::open(link).map_err(|e| Failure::io(link.display(), &e))?;
        Ok(Self { link: link.to_owned(), ends: Some(ends) })
    }

    fn fail(&self, error: Errno) -> Failure {
        Failure::io(self.link.display(), &error.into())
    }

    /// Takes the link away, if it is still the one that was made here.
    fn unlink(&mut self) {
        if let Some(ends) = self.ends.take()
            && fs::read_link(&self.link).is_ok_and(|path| path == ends.path)
        {
            let _ = fs::remove_file(&self.link);
        }
    }
}

impl PtyEnds {
    fn open(link: &Path) -> Result<Self, Error> {
        let robot = openpt(OpenptFlags::RDWR | OpenptFlags::NOCTTY | OpenptFlags::CLOEXEC)?;
        grantpt(&robot)?;
        unlockpt(&robot)?;
        ioctl_fionbio(&robot, true)?;
        let name = ptsname(&robot, Vec::new())?;
        let host = open(name.as_c_str(), OFlags::RDWR | OFlags::NOCTTY | OFlags::CLOEXEC, Mode::empty())?;
        let mut settings = tcgetattr(&host)?;
        settings.make_raw();
        settings.set_speed(BAUD)?;
        tcsetattr(&host, OptionalActions::Now, &settings)?;
        let path = PathBuf::from(name.to_string_lossy().into_owned());
        place(&path, link)?;
        Ok(Self { robot, host, path })
    }
}

/// Makes the link in one go. One that is left from before is replaced; anything else is in the way.
fn place(path: &Path, link: &Path) -> Result<(), Error> {
    if fs::symlink_metadata(link).is_ok_and(|found| !found.is_symlink()) {
        return Err(Error::new(ErrorKind::AlreadyExists, "the path exists and isn't a symbolic link"));
    }
    let mut name = link.file_name().unwrap_or_default().to_owned();
    name.push(format!(".{}", process::id()));
    let fresh = link.with_file_name(name);
    symlink(path, &fresh)?;
    fs::rename(&fresh, link).inspect_err(|_| drop(fs::remove_file(&fresh)))
}

impl HostLine for Pty {
    fn name(&self) -> String {
        self.link.display().to_string()
    }

    fn baud(&self) -> u32 {
        let settings = self.ends.as_ref().and_then(|ends| tcgetattr(&ends.host).ok());
        // Zero hangs up: no rate has been set.
        settings.map(|settings| settings.output_speed()).filter(|&baud| baud > 0).unwrap_or(BAUD)
    }

    fn read(&mut self, bytes: &mut Vec<u8>) -> Result<bool, Failure> {
        let Some(ends) = &self.ends else { return Ok(true) };
        let mut buffer = [0; 512];
        match read(&ends.robot, &mut buffer) {
            Ok(count) => bytes.extend(buffer.get(..count).unwrap_or_default()),
            // No host at present; some systems report this although this side holds the terminal open.
            Err(Errno::AGAIN | Errno::INTR | Errno::IO) => {}
            Err(error) => return Err(self.fail(error)),
        }
        Ok(true)
    }

    fn write(&mut self, bytes: &[u8]) -> Result<(), Failure> {
        let Some(ends) = &self.ends else { return Ok(()) };
        let mut rest = bytes;
        let mut is_flushed = false;
        while !rest.is_empty() {
            match write(&ends.robot, rest) {
                Ok(count) => rest = rest.get(count..).unwrap_or_default(),
                Err(Errno::INTR) => {}
                // Unread bytes are dropped, as newer ones replace them.
                Err(Errno::AGAIN) if !is_flushed => {
                    tcflush(&ends.host, QueueSelector::IFlush).map_err(|e| self.fail(e))?;
                    is_flushed = true;
                }
                Err(Errno::AGAIN | Errno::IO) => return Ok(()),
                Err(error) => return Err(self.fail(error)),
            }
        }
        Ok(())
    }

    fn plug(&mut self, is_plugged: bool) -> Result<bool, Failure> {
        if !is_plugged {
            self.unlink();
        } else if self.ends.is_none() {
            *self = Self::open(&self.link)?;
        }
        Ok(true)
    }
}

impl Drop for Pty {
    fn drop(&mut self) {
        self.unlink();
    }
}
