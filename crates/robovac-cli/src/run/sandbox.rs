//! A sandbox for programs of strangers: nothing to read but the system and the program, nothing to write, no network, no other
//! processes. Bubblewrap builds them (<https://github.com/containers/bubblewrap>); a filter of system calls closes what it
//! leaves open. Where it can't, [`Sandbox::probe`] says why.

use super::language::Language;
use std::{
    path::{Path, PathBuf},
    process::{Command, Stdio},
};

/// What is in the way of most faults.
const MEND: &str = "install bubblewrap (Debian, Ubuntu: apt install bubblewrap); if it is installed, the system may \
                    forbid it: on Ubuntu, \"sudo sysctl -w kernel.apparmor_restrict_unprivileged_userns=0\" allows it \
                    until the next start";
/// Where the program's own files are inside.
const INSIDE: &str = "/robovac";

/// Limits of programs, with or without a sandbox.
pub struct Sandbox {
    /// Whether there are any but limits of time, memory and files to write.
    is_whole: bool,
}

impl Sandbox {
    /// Only what every system has: limits of time, memory and the size of files. The program can read files, reach the
    /// network and start others.
    pub fn limits_only() -> Self {
        Self { is_whole: false }
    }

    /// All of it, if bubblewrap works here; else why not, and what helps.
    pub fn probe() -> Result<Self, String> {
        if !cfg!(target_os = "linux") {
            return Err(
                "strangers' programs can be kept from files and network only on Linux; run this in a virtual machine \
                 with Linux"
                    .to_owned(),
            );
        }
        let mut command = Command::new("bwrap");
        command.args(["--unshare-all", "--die-with-parent", "--ro-bind", "/", "/", "--", "/bin/sh", "-c", "exit 0"]);
        let output = command
            .stdin(Stdio::null())
            .output()
            .map_err(|error| format!("bwrap can't be started ({error}); {MEND}"))?;
        if !output.status.success() {
            let why = String::from_utf8_lossy(&output.stderr);
            return Err(format!("bwrap fails ({}); {MEND}", why.lines().last().unwrap_or("without a word").trim()));
        }
        filter()?;
        Ok(Self { is_whole: true })
    }

    /// What is held, and what isn't, in words.
    pub fn words(&self) -> &'static str {
        if self.is_whole {
            "programs run without files, network and other processes (bubblewrap)"
        } else {
            "programs can read your files and use the network; only time, memory and writing are limited"
        }
    }

    /// The command that runs `language` in the sandbox, with at most `memory_mb` and `seconds` of processor time.
    pub fn command(&self, language: &Language, memory_mb: u64, seconds: u64) -> Result<Command, String> {
        let mut command = Command::new("sh");
        // The limits are set before anything else runs, so nothing comes in between. Files can't grow, which holds for
        // the memory behind /dev/shm, too.
        let limits = format!(
            "ulimit -c 0; ulimit -f 0; ulimit -d {}; ulimit -t {}; ulimit -S -t {seconds}",
            memory_mb << 10,
            seconds + 2
        );
        if !self.is_whole {
            command.args(["-c", &format!("{limits}; exec \"$@\""), "sh"]).args(language.words());
            command.envs(language.variables());
            return Ok(command);
        }
        let folder = language.folder().ok_or("the program's language is unknown")?;
        let rules = folder.join("system-calls");
        if !rules.exists() {
            std::fs::write(&rules, filter()?).map_err(|error| format!("{}: {error}", rules.display()))?;
        }
        let script = format!("{limits}; rules=$1; shift; exec \"$@\" 9<\"$rules\"");
        command.args(["-c", &script, "sh"]).arg(&rules);
        command.args(
            "bwrap --unshare-all --die-with-parent --new-session --clearenv --seccomp 9 --ro-bind /usr /usr".split(' '),
        );
        for place in ["/bin", "/sbin", "/lib", "/lib64"] {
            match std::fs::read_link(place) {
                Ok(target) => command.arg("--symlink").arg(target).arg(place),
                Err(_) => command.args(["--ro-bind-try", place, place]),
            };
        }
        command.args("--ro-bind-try /etc/ld.so.cache /etc/ld.so.cache --dev /dev".split(' '));
        let Some((name, arguments)) = language.words().split_first() else {
            return Err("there is no command".to_owned());
        };
        let (binary, home) = interpreter(name)?;
        if !home.starts_with("/usr") {
            command.arg("--ro-bind").args([&home, &home]);
        }
        command.arg("--ro-bind").args([folder, Path::new(INSIDE)]);
        let inside = |path: &Path| {
            path.strip_prefix(folder).map_or_else(|_| path.to_owned(), |rest| Path::new(INSIDE).join(rest))
        };
        for (key, value) in language.variables() {
            command.arg("--setenv").arg(key).arg(inside(value));
        }
        command.args(["--remount-ro", "/", "--chdir", "/", "--"]).arg(binary);
        command.args(arguments.iter().map(|word| inside(Path::new(word))));
        Ok(command)
    }
}

/// Where an interpreter really is, and the folder with all that belongs to it.
fn interpreter(name: &str) -> Result<(PathBuf, PathBuf), String> {
    let question: &[&str] = if name == "node" {
        &["-p", "process.execPath"]
    } else {
        &["-I", "-c", "import os, sys; print(os.path.realpath(sys.executable))"]
    };
    let absent = format!("\"{name}\" isn't installed; install it to run programs in its language");
    let output = Command::new(name).args(question).stdin(Stdio::null()).output().map_err(|_| absent.clone())?;
    let binary = PathBuf::from(String::from_utf8_lossy(&output.stdout).trim());
    // It is in "bin" of its home.
    let home = binary.parent().and_then(Path::parent).filter(|home| home.parent().is_some());
    home.map(|home| (binary.clone(), home.to_owned())).ok_or(absent)
}

/// Instructions of the kernel's filter: load a word, jump if equal, if at least, if a bit is set, return.
const LOAD: u16 = 0x20;
const IF_EQUAL: u16 = 0x15;
const IF_AT_LEAST: u16 = 0x35;
const IF_SET: u16 = 0x45;
const RETURN: u16 = 0x06;
/// Results: go on; fail with "operation not permitted"; with "no such system call"; end the process.
const ALLOW: u32 = 0x7fff_0000;
const REFUSE: u32 = 0x0005_0001;
const UNKNOWN: u32 = 0x0005_0026;
const END: u32 = 0x8000_0000;
/// The flag of a new thread, as opposed to a new process.
const THREAD: u32 = 0x0001_0000;

/// Numbers of the system calls that the filter is about, on one architecture.
struct Calls {
    audit: u32,
    clone: u32,
    clone3: u32,
    /// Sockets, processes, and what programs in sandboxes have broken out with: traces, mounts, name spaces, keys, BPF,
    /// rings, faults handled in user space.
    refused: &'static [u32],
}

/// From the kernel's tables, `arch/x86/entry/syscalls/syscall_64.tbl` and `include/uapi/asm-generic/unistd.h`.
fn calls() -> Option<Calls> {
    match std::env::consts::ARCH {
        "x86_64" => Some(Calls {
            audit: 0xc000_003e,
            clone: 56,
            clone3: 435,
            // socket, socketpair, fork, vfork, ptrace, mount, umount2, unshare, setns, add_key, request_key, keyctl, bpf,
            // perf_event_open, userfaultfd, io_uring_setup
            refused: &[41, 53, 57, 58, 101, 165, 166, 272, 308, 248, 249, 250, 321, 298, 323, 425],
        }),
        "aarch64" => Some(Calls {
            audit: 0xc000_00b7,
            clone: 220,
            clone3: 435,
            refused: &[198, 199, 117, 40, 39, 97, 268, 217, 218, 219, 280, 241, 282, 425],
        }),
        _ => None,
    }
}

/// The filter as the kernel reads it: `struct sock_filter` for each instruction.
fn filter() -> Result<Vec<u8>, String> {
    let Some(Calls { audit, clone, clone3, refused }) = calls() else {
        return Err(format!(
            "there is no filter of system calls for {}; use a computer with x86-64 or ARM",
            std::env::consts::ARCH
        ));
    };
    let mut rules: Vec<(u16, u8, u8, u32)> = vec![
        (LOAD, 0, 0, 4),
        (IF_EQUAL, 1, 0, audit),
        (RETURN, 0, 0, END),
        (LOAD, 0, 0, 0),
        // The other numbering of x86.
        (IF_AT_LEAST, 0, 1, 0x4000_0000),
        (RETURN, 0, 0, REFUSE),
        // Its flags can't be read here; libraries then take `clone`.
        (IF_EQUAL, 0, 1, clone3),
        (RETURN, 0, 0, UNKNOWN),
        (IF_EQUAL, 0, 4, clone),
        (LOAD, 0, 0, 16),
        (IF_SET, 1, 0, THREAD),
        (RETURN, 0, 0, REFUSE),
        (RETURN, 0, 0, ALLOW),
    ];
    rules.extend(refused.iter().flat_map(|&call| [(IF_EQUAL, 0, 1, call), (RETURN, 0, 0, REFUSE)]));
    rules.push((RETURN, 0, 0, ALLOW));
    Ok(rules
        .into_iter()
        .flat_map(|(code, yes, no, value)| {
            let [a, b] = code.to_ne_bytes();
            let [c, d, e, f] = value.to_ne_bytes();
            [a, b, yes, no, c, d, e, f]
        })
        .collect())
}
