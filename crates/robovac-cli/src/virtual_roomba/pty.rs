//! A pseudo-terminal with a symbolic link to it, which other programs open as a serial port.
//!
//! It is raw before the link appears: no byte is echoed, translated or held back until a line is complete. Programs may come
//! and go; what the robot sends while none has it open is lost, as at a real port. (Not noticed is a program that closes it
//! and another that opens it within two milliseconds.) Its rate is the one that a program sets, and a rate that isn't the
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
    /// The robot's end.
    robot: OwnedFd,
    /// The host's end, which the link leads to.
    path: PathBuf,
    /// Whether a program has it open.
    has_host: bool,
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
        let path = PathBuf::from(ptsname(&robot, Vec::new())?.to_string_lossy().into_owned());
        let host = open_host(&path)?;
        let mut settings = tcgetattr(&host)?;
        settings.make_raw();
        settings.set_speed(BAUD)?;
        tcsetattr(&host, OptionalActions::Now, &settings)?;
        place(&path, link)?;
        Ok(Self { robot, path, has_host: false })
    }

    /// A program has opened it, or the last one has closed it. Unread bytes go: they are from before.
    fn host_changed(&mut self, has_host: bool) -> Result<(), Errno> {
        if has_host && !self.has_host {
            tcflush(open_host(&self.path)?, QueueSelector::IFlush)?;
        }
        self.has_host = has_host;
        Ok(())
    }
}

/// Opens the host's end.
fn open_host(path: &Path) -> Result<OwnedFd, Errno> {
    open(path, OFlags::RDWR | OFlags::NOCTTY | OFlags::CLOEXEC, Mode::empty())
}

/// Makes the link in one go. One that leads nowhere, as of a program that was killed, is replaced; anything else is in the
/// way.
fn place(path: &Path, link: &Path) -> Result<(), Error> {
    match symlink(path, link) {
        Err(error) if error.kind() == ErrorKind::AlreadyExists => {}
        result => return result,
    }
    let in_the_way = |why: String| Err(Error::new(ErrorKind::AlreadyExists, why));
    match fs::read_link(link) {
        Err(_) => return in_the_way("the path exists and isn't a symbolic link".to_owned()),
        Ok(end) if end != path && fs::exists(link)? => {
            return in_the_way(format!(
                "the link leads to {}, which another virtual Roomba may be using: end that one, remove the link, or use \
                 another path",
                end.display()
            ));
        }
        Ok(_) => {}
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
        let settings = self.ends.as_ref().and_then(|ends| tcgetattr(&ends.robot).ok());
        // Zero hangs up: no rate has been set.
        settings.map(|settings| settings.output_speed()).filter(|&baud| baud > 0).unwrap_or(BAUD)
    }

    fn has_host(&self) -> bool {
        self.ends.as_ref().is_some_and(|ends| ends.has_host)
    }

    fn read(&mut self, most: usize, bytes: &mut Vec<u8>) -> Result<bool, Failure> {
        let Some(ends) = &mut self.ends else { return Ok(true) };
        let mut buffer = [0; 512];
        let changed = match read(&ends.robot, buffer.get_mut(..most.min(512)).unwrap_or_default()) {
            // No program has it open.
            Ok(0) | Err(Errno::IO) => ends.host_changed(false),
            Ok(count) => {
                bytes.extend(buffer.get(..count).unwrap_or_default());
                ends.host_changed(true)
            }
            Err(Errno::AGAIN) => ends.host_changed(true),
            Err(Errno::INTR) => Ok(()),
            Err(error) => Err(error),
        };
        changed.map(|()| true).map_err(|error| self.fail(error))
    }

    fn write(&mut self, bytes: &[u8]) -> Result<(), Failure> {
        let Some(ends) = self.ends.as_ref().filter(|ends| ends.has_host) else { return Ok(()) };
        let mut rest = bytes;
        let mut is_flushed = false;
        while !rest.is_empty() {
            match write(&ends.robot, rest) {
                Ok(count) => rest = rest.get(count..).unwrap_or_default(),
                Err(Errno::INTR) => {}
                // Unread bytes are dropped, as newer ones replace them.
                Err(Errno::AGAIN) if !is_flushed => {
                    let host = open_host(&ends.path).map_err(|e| self.fail(e))?;
                    tcflush(host, QueueSelector::IFlush).map_err(|e| self.fail(e))?;
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
