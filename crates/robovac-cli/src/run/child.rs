//! A user's program as a child process, held to its time, output and memory. It never outlives this one.

use super::protocol::{Reply, Words};
use std::{
    io::{BufRead, BufReader, Read, Write},
    process::{Child, ChildStderr, ChildStdin, ChildStdout, Command, ExitStatus, Stdio},
    sync::{
        Arc, Mutex, PoisonError,
        atomic::{AtomicBool, AtomicU64, Ordering},
        mpsc::{Receiver, channel},
    },
    thread::{self, JoinHandle},
    time::{Duration, Instant},
};

/// Time in which a program answers a step, and in which it starts. An interpreter on a busy machine takes its time.
const STEP_LIMIT: Duration = Duration::from_secs(1);
const START_LIMIT: Duration = Duration::from_secs(15);
/// How many times as long it may take by the clock, where the program's own time can be told: others may be busy here, too.
const PATIENCE: u32 = 4;
/// Exit code of a program that has used up its processor time: 128 and the signal's number, as a shell says it.
const CPU_CODE: i32 = 128 + 24;
/// Time for a plan.
const PLAN_LIMIT: Duration = Duration::from_mins(1);
/// How often the times are looked at.
const LOOK: Duration = Duration::from_millis(20);
/// Longest line of a program, bytes.
const LONGEST_LINE: u64 = 1 << 20;
/// What is kept of its error output, bytes.
const MOST_ERRORS: usize = 4096;
/// Time to end by itself once nothing more is to be done.
const FAREWELL: Duration = Duration::from_millis(300);

/// What a program is being waited for.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum WaitFor {
    /// Its start.
    Start,
    /// A command for the next step.
    Step,
    /// The next cells of a plan.
    Plan,
}

/// A running program.
pub struct ProgramProcess {
    child: Arc<Mutex<Child>>,
    input: Option<ChildStdin>,
    output: BufReader<ChildStdout>,
    line: Vec<u8>,
    errors: Receiver<Vec<u8>>,
    watch: Arc<ChildWatch>,
    watcher: Option<JoinHandle<()>>,
}

/// What the watcher thread looks at.
struct ChildWatch {
    began: Instant,
    /// Milliseconds since `began` at which the present task is overdue; 0 for none.
    due: AtomicU64,
    is_over: AtomicBool,
    was_late: AtomicBool,
}

impl ProgramProcess {
    /// Starts `command`, with at most `memory_mb` of memory where the system can limit it. It is ended when `end` becomes
    /// true.
    pub fn start(mut command: Command, memory_mb: u64, end: Arc<AtomicBool>) -> Result<Self, String> {
        command.stdin(Stdio::piped()).stdout(Stdio::piped()).stderr(Stdio::piped());
        #[cfg(unix)]
        std::os::unix::process::CommandExt::process_group(&mut command, 0);
        let name = command.get_program().to_string_lossy().into_owned();
        let mut child = command.spawn().map_err(|error| match error.kind() {
            std::io::ErrorKind::NotFound => {
                format!("\"{name}\" isn't installed; install it, or name another with --command")
            }
            _ => format!("\"{name}\" can't be started: {error}"),
        })?;
        limit_memory(&child, memory_mb);
        let pipes = (child.stdin.take(), child.stdout.take(), child.stderr.take());
        let (Some(input), Some(output), Some(errors)) = pipes else { return Err("a pipe is missing".to_owned()) };
        let (tell, last_words) = channel();
        thread::spawn(move || tell.send(last_of(errors)));
        let child = Arc::new(Mutex::new(child));
        let watch = Arc::new(ChildWatch {
            began: Instant::now(),
            due: AtomicU64::new(0),
            is_over: AtomicBool::new(false),
            was_late: AtomicBool::new(false),
        });
        let watcher = thread::spawn({
            let (child, watch) = (Arc::clone(&child), Arc::clone(&watch));
            move || watch.keep(&child, &end)
        });
        Ok(Self {
            child,
            input: Some(input),
            output: BufReader::with_capacity(1 << 16, output),
            line: Vec::new(),
            errors: last_words,
            watch,
            watcher: Some(watcher),
        })
    }

    /// Sends these bytes.
    fn put(&mut self, bytes: &[u8]) -> Result<(), String> {
        let Some(input) = &mut self.input else { return Err("the program has ended".to_owned()) };
        let sent = input.write_all(bytes).and_then(|()| input.flush());
        // Its last words say more than a broken pipe.
        if sent.is_err() { Err(self.last_words("ended before the run was over")) } else { Ok(()) }
    }

    /// Sends a line and waits for the answer.
    pub fn ask(&mut self, line: &str, task: WaitFor) -> Result<Reply, String> {
        self.watch.due_in(task.limit());
        let answer = self.put(format!("{line}\n").as_bytes()).and_then(|()| self.answer(task));
        self.watch.due.store(0, Ordering::Relaxed);
        answer
    }

    /// Waits for a further line.
    pub fn next(&mut self, task: WaitFor) -> Result<Reply, String> {
        self.watch.due_in(task.limit());
        let answer = self.answer(task);
        self.watch.due.store(0, Ordering::Relaxed);
        answer
    }

    /// Sends a frame and waits for the answer, whose length is before it. Both are for a step.
    pub fn exchange(&mut self, frame: &[u8]) -> Result<&[u8], String> {
        self.watch.due_in(WaitFor::Step.limit());
        let answer = self.put(frame).and_then(|()| self.framed());
        self.watch.due.store(0, Ordering::Relaxed);
        answer.map(|()| self.line.as_slice())
    }

    fn framed(&mut self) -> Result<(), String> {
        let mut length = [0; 4];
        let read = self.output.read_exact(&mut length);
        let length = u64::from(u32::from_le_bytes(length));
        let whole = read.and_then(|()| {
            self.line.clear();
            (&mut self.output).take(length.min(LONGEST_LINE)).read_to_end(&mut self.line)
        });
        self.in_time(WaitFor::Step)?;
        match whole {
            Ok(_) if length > LONGEST_LINE => Err(too_long()),
            Ok(read) if read as u64 == length => Ok(()),
            _ => Err(self.last_words("ended before the run was over")),
        }
    }

    fn answer(&mut self, task: WaitFor) -> Result<Reply, String> {
        self.line.clear();
        let read = (&mut self.output).take(LONGEST_LINE + 1).read_until(b'\n', &mut self.line);
        self.in_time(task)?;
        if self.line.len() as u64 > LONGEST_LINE {
            return Err(too_long());
        }
        if read.is_err() || !self.line.ends_with(b"\n") {
            return Err(self.last_words("ended before the run was over"));
        }
        Reply::parse(&self.line)
    }

    /// An error if the task took too long.
    fn in_time(&self, task: WaitFor) -> Result<(), String> {
        if self.watch.was_late.load(Ordering::Relaxed) {
            let seconds = task.limit().as_secs();
            return Err(match task {
                WaitFor::Start => format!("the program didn't start within {seconds} s; does it read its input?"),
                WaitFor::Step => format!(
                    "a step took more than {seconds} s; end its loops, and wait with \"yield\" instead of sleeping"
                ),
                WaitFor::Plan => {
                    format!("the plan took more than {seconds} s without a cell; yield cells as they are found")
                }
            });
        }
        Ok(())
    }

    /// What the program wrote to its error output last, behind `what` happened.
    fn last_words(&mut self, what: &str) -> String {
        let status = self.end();
        if status.is_some_and(is_out_of_time) {
            return "the program used up its processor time; end its loops, or compute less in each step".to_owned();
        }
        // Something that it started elsewhere can hold its error output open.
        let errors = self.errors.recv_timeout(FAREWELL).unwrap_or_default();
        let text = Words::of(&errors);
        if text.is_empty() { format!("the program {what}") } else { format!("the program {what}:\n{text}") }
    }

    /// Ends it: kindly at first. How it has ended, if by itself.
    fn end(&mut self) -> Option<ExitStatus> {
        // An end of its input is how it learns that the run is over.
        self.input = None;
        let begin = Instant::now();
        while begin.elapsed() < FAREWELL {
            let ended = self.child.lock().unwrap_or_else(PoisonError::into_inner).try_wait();
            if !matches!(ended, Ok(None)) {
                return ended.ok().flatten();
            }
            thread::sleep(Duration::from_millis(1));
        }
        kill(&self.child);
        None
    }
}

impl Drop for ProgramProcess {
    fn drop(&mut self) {
        self.end();
        self.watch.is_over.store(true, Ordering::Relaxed);
        if let Some(watcher) = self.watcher.take() {
            watcher.thread().unpark();
            let _ = watcher.join();
        }
    }
}

impl ChildWatch {
    fn due_in(&self, limit: Duration) {
        let due = self.began.elapsed() + limit;
        self.due.store(due.as_millis() as u64, Ordering::Relaxed);
    }

    /// Kills the child when it is late, or when the program is to end.
    fn keep(&self, child: &Mutex<Child>, end: &AtomicBool) {
        let pid = child.lock().unwrap_or_else(PoisonError::into_inner).id();
        let (mut known, mut asked, mut used) = (0, Duration::ZERO, None);
        while !self.is_over.load(Ordering::Relaxed) {
            let due = self.due.load(Ordering::Relaxed);
            let now = self.began.elapsed();
            if due != known {
                (known, asked, used) = (due, now, processor_time(pid));
            }
            let limit = Duration::from_millis(due).saturating_sub(asked);
            let is_due = due > 0 && now.as_millis() as u64 > due;
            // What it has used itself counts, and the clock for one that sleeps.
            let own = used.and_then(|used| processor_time(pid).filter(|_| is_due).map(|now| now.saturating_sub(used)));
            let is_late = is_due && own.is_none_or(|own| own >= limit || now.saturating_sub(asked) > PATIENCE * limit);
            if is_late || end.load(Ordering::Relaxed) {
                self.was_late.store(is_late, Ordering::Relaxed);
                kill(child);
                return;
            }
            thread::park_timeout(LOOK);
        }
    }
}

/// Processor time of a process and of all that it has started, where the system tells it.
#[cfg(target_os = "linux")]
fn processor_time(pid: u32) -> Option<Duration> {
    // Ticks of 10 ms: the kernel's unit for programs, whatever its own.
    let stat = std::fs::read_to_string(format!("/proc/{pid}/stat")).ok()?;
    let fields: Vec<&str> = stat.rsplit(')').next()?.split_whitespace().collect();
    let ticks = |at: usize| fields.get(at)?.parse::<u64>().ok();
    let own = Duration::from_millis(10 * (ticks(11)? + ticks(12)?));
    let children = std::fs::read_to_string(format!("/proc/{pid}/task/{pid}/children")).unwrap_or_default();
    let started = children.split_whitespace().filter_map(|child| processor_time(child.parse().ok()?));
    Some(started.fold(own, |sum, time| sum + time))
}

#[cfg(not(target_os = "linux"))]
fn processor_time(_: u32) -> Option<Duration> {
    None
}

/// Whether a program was ended by the limit of its processor time.
fn is_out_of_time(status: ExitStatus) -> bool {
    #[cfg(unix)]
    if std::os::unix::process::ExitStatusExt::signal(&status) == Some(CPU_CODE - 128) {
        return true;
    }
    status.code() == Some(CPU_CODE)
}

impl WaitFor {
    fn limit(self) -> Duration {
        match self {
            Self::Start => START_LIMIT,
            Self::Step => STEP_LIMIT,
            Self::Plan => PLAN_LIMIT,
        }
    }
}

fn too_long() -> String {
    format!("the program wrote a line of more than {} KB; print less", LONGEST_LINE / 1024)
}

/// Kills a child with all that it has started.
fn kill(child: &Mutex<Child>) {
    let mut child = child.lock().unwrap_or_else(PoisonError::into_inner);
    #[cfg(unix)]
    if let Some(group) = i32::try_from(child.id()).ok().and_then(rustix::process::Pid::from_raw)
        && matches!(child.try_wait(), Ok(None))
    {
        let _ = rustix::process::kill_process_group(group, rustix::process::Signal::KILL);
    }
    let _ = child.kill();
    let _ = child.wait();
}

/// Limits the memory that a child may write to.
#[cfg(target_os = "linux")]
fn limit_memory(child: &Child, megabytes: u64) {
    use rustix::process::{Pid, Resource, Rlimit, prlimit};
    let pid = i32::try_from(child.id()).ok().and_then(Pid::from_raw);
    let bytes = Some(megabytes << 20);
    // Where it isn't allowed, the program runs without that limit.
    let _ = prlimit(pid, Resource::Data, Rlimit { current: bytes, maximum: bytes });
}

#[cfg(not(target_os = "linux"))]
fn limit_memory(_: &Child, _: u64) {}

/// The end of what is read.
fn last_of(mut errors: ChildStderr) -> Vec<u8> {
    let (mut kept, mut buffer) = (Vec::new(), [0; MOST_ERRORS]);
    while let Ok(count) = errors.read(&mut buffer) {
        if count == 0 {
            break;
        }
        kept.extend_from_slice(buffer.get(..count).unwrap_or_default());
        if kept.len() > 2 * MOST_ERRORS {
            kept.drain(..kept.len() - MOST_ERRORS);
        }
    }
    kept
}
