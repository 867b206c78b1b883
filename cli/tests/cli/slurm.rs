//! The job array of experiments/slurm, carried out by a Slurm of its own: two nodes on this
//! machine.
//!
//! Skipped where Slurm is not installed or the test is not run by root, which Slurm's daemons need
//! to be. They listen on 127.0.0.1 alone, and end with the test or after three minutes.

use std::collections::BTreeMap;
use std::fs::Permissions;
use std::net::TcpListener;
use std::os::unix::fs::{MetadataExt, PermissionsExt};
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use crate::experiment_text::experiment;
use crate::repeatable::repeatable;
use tempfile::TempDir;
use triquad_lab::experiment::Results;

const PARTS: usize = 3;

const EXPERIMENT: &str = experiment!(
    "tiny",
    "convert",
    r#"["botijo", "B5"]"#,
    r#"algorithms = ["ps", "tq"]
        augmentations = ["tarjan", "local"]
        repetitions = { full = 3, small = 3, demo = 3 }"#,
    r#"algorithms = ["lrs few-flips"]
        augmentations = ["local"]
        repetitions = { full = 1, small = 1, demo = 1 }"#,
);
/// Two meshes, four jobs three times and one once.
const RUNS: usize = 2 * (4 * 3 + 1);

/// A `triquad` that has part 2 killed and queued again the first time that it runs: half of its
/// blocks are done then, and the process that goes on from there stands still in the midst of the
/// other half.
const INTERRUPTED: &str = r#"#!/usr/bin/env bash
if [[ $1 != run || $SLURM_ARRAY_TASK_ID != 2 || -n ${SLURM_RESTART_COUNT:-} ]]; then
    exec TRIQUAD "$@"
fi
TRIQUAD "${@//2\/3/2\/6}"
TRIQUAD "$@" &
sleep 0.1
kill -STOP $! || true
SLURM_CONF=CONFIGURATION scontrol requeue "$SLURM_JOB_ID"
sleep 60
"#;

/// One host's Slurm, stopped when it is dropped.
struct Slurm {
    folder: TempDir,
    daemons: Vec<Child>,
}

impl Slurm {
    /// Whether this machine can have one; if not, says why.
    fn is_possible() -> bool {
        let found = |program: &&str| {
            let folders = std::env::var_os("PATH").unwrap_or_default();
            std::env::split_paths(&folders).any(|folder| folder.join(program).is_file())
        };
        let needed = ["munged", "slurmctld", "slurmd", "sbatch", "scontrol", "scancel", "timeout"];
        let missing: Vec<_> = needed.iter().filter(|program| !found(program)).collect();
        let is_root = std::fs::metadata("/proc/self").is_ok_and(|process| process.uid() == 0);
        if !missing.is_empty() {
            eprintln!("skipped: {missing:?} not found (apt-get install slurm-wlm munge)");
        } else if !is_root {
            eprintln!("skipped: only root can start Slurm's daemons");
        }
        missing.is_empty() && is_root
    }

    fn start() -> Self {
        let mut slurm = Self { folder: tempfile::tempdir().unwrap(), daemons: Vec::new() };
        std::fs::set_permissions(slurm.folder.path(), Permissions::from_mode(0o755)).unwrap();
        slurm.start_munge();
        std::fs::write(slurm.path("slurm.conf"), slurm.configuration()).unwrap();
        slurm.start_daemon("slurmctld", &["-D".into(), "-c".into()]);
        for node in ["n1", "n2"] {
            slurm.start_daemon("slurmd", &["-D".into(), "-N".into(), node.into()]);
        }
        slurm.wait("idle nodes", |slurm| {
            let nodes = slurm.said("scontrol", &["show", "node", "-o"]);
            nodes.matches(" State=IDLE ").count() == 2
        });
        slurm
    }

    fn path(&self, name: &str) -> PathBuf {
        self.folder.path().join(name)
    }

    /// What Slurm's parts prove to each other who they are with.
    fn start_munge(&mut self) {
        // Only this test's daemons ever hear of it.
        let key: Vec<u8> = (0..1024_u32).map(|i| (i * i % 251) as u8).collect();
        std::fs::write(self.path("munge.key"), key).unwrap();
        std::fs::set_permissions(self.path("munge.key"), Permissions::from_mode(0o400)).unwrap();
        let file = |option: &str, name: &str| format!("--{option}={}", self.path(name).display());
        let arguments = [
            "--foreground".into(),
            file("key-file", "munge.key"),
            file("socket", "munge.socket"),
            file("pid-file", "munge.pid"),
            file("log-file", "munge.log"),
            file("seed-file", "munge.seed"),
        ];
        self.start_daemon("munged", &arguments);
        self.wait("munge's socket", |slurm| slurm.path("munge.socket").exists());
    }

    fn configuration(&self) -> String {
        let hostname = std::fs::read_to_string("/proc/sys/kernel/hostname").unwrap();
        let hostname = hostname.trim();
        let folder = self.folder.path().display();
        let [controller, first, second] = free_ports();
        // A job that is queued again waits until its credential has expired.
        format!(
            "ClusterName=test\n\
             SlurmctldHost=localhost(127.0.0.1)\n\
             AuthType=auth/munge\n\
             AuthInfo=socket={folder}/munge.socket,cred_expire=5\n\
             CredType=cred/munge\n\
             SlurmUser=root\n\
             SlurmdUser=root\n\
             SlurmctldPort={controller}\n\
             CommunicationParameters=NoCtldInAddrAny,NoInAddrAny\n\
             StateSaveLocation={folder}/state\n\
             SlurmctldPidFile={folder}/slurmctld.pid\n\
             SlurmctldLogFile={folder}/slurmctld.log\n\
             SlurmdSpoolDir={folder}/spool-%n\n\
             SlurmdPidFile={folder}/slurmd-%n.pid\n\
             SlurmdLogFile={folder}/slurmd-%n.log\n\
             ProctrackType=proctrack/linuxproc\n\
             TaskPlugin=task/none\n\
             SwitchType=switch/none\n\
             MpiDefault=none\n\
             KillWait=2\n\
             ReturnToService=2\n\
             SelectType=select/cons_tres\n\
             SelectTypeParameters=CR_Core\n\
             SchedulerParameters=sched_interval=1,batch_sched_delay=0,bf_interval=1\n\
             JobAcctGatherType=jobacct_gather/none\n\
             AccountingStorageType=accounting_storage/none\n\
             NodeName=n1 NodeAddr=127.0.0.1 NodeHostname={hostname} Port={first} RealMemory=2048\n\
             NodeName=n2 NodeAddr=127.0.0.1 NodeHostname={hostname} Port={second} RealMemory=2048\n\
             PartitionName=main Nodes=n1,n2 Default=YES State=UP\n"
        )
    }

    /// Starts a daemon that ends by itself if this test is killed.
    fn start_daemon(&mut self, program: &str, arguments: &[String]) {
        let name = format!("{program}-{}.out", self.daemons.len());
        let output = std::fs::File::create(self.path(&name)).unwrap();
        let mut command = self.command("timeout");
        command.args(["--kill-after=5", "180", program]).args(arguments);
        command.stdout(output.try_clone().unwrap()).stderr(output);
        self.daemons.push(command.spawn().unwrap());
    }

    fn command(&self, program: &str) -> Command {
        let mut command = Command::new(program);
        command.env("SLURM_CONF", self.path("slurm.conf")).current_dir(self.folder.path());
        command.stdin(Stdio::null());
        command
    }

    /// What a program prints, or nothing if it fails.
    fn said(&self, program: &str, arguments: &[&str]) -> String {
        let output = self.command(program).args(arguments).output().unwrap();
        String::from_utf8(output.stdout).unwrap()
    }

    fn wait(&self, what: &str, is_there: impl Fn(&Self) -> bool) {
        let start = Instant::now();
        while !is_there(self) {
            assert!(start.elapsed() < Duration::from_secs(120), "no {what}:\n{}", self.logs());
            std::thread::sleep(Duration::from_millis(100));
        }
    }

    /// The ends of all logs.
    fn logs(&self) -> String {
        let mut logs = String::new();
        for folder in [self.path("."), self.path("out/logs")] {
            let entries = std::fs::read_dir(folder).into_iter().flatten();
            for path in entries.map(|entry| entry.unwrap().path()) {
                if path.extension().is_some_and(|end| end == "log" || end == "out") {
                    let text = std::fs::read_to_string(&path).unwrap_or_default();
                    let lines: Vec<_> = text.lines().collect();
                    let end = lines[lines.len().saturating_sub(15)..].join("\n");
                    logs += &format!("== {}\n{end}\n", path.display());
                }
            }
        }
        logs
    }

    /// The fields that Slurm shows of a job and, for an array, of each of its tasks.
    fn jobs(&self, id: &str) -> Vec<BTreeMap<String, String>> {
        let text = self.said("scontrol", &["show", "job", "-o", id]);
        let fields = |line: &str| {
            let fields = line.split_whitespace().filter_map(|field| field.split_once('='));
            fields.map(|(name, value)| (name.to_owned(), value.to_owned())).collect()
        };
        text.lines().map(fields).collect()
    }
}

impl Drop for Slurm {
    fn drop(&mut self) {
        self.said("scancel", &["--quiet", "--user=root"]);
        let start = Instant::now();
        while !self.said("squeue", &["--noheader"]).is_empty()
            && start.elapsed() < Duration::from_secs(10)
        {
            std::thread::sleep(Duration::from_millis(100));
        }
        // The last first: nodes, controller, munge. `timeout` passes the signal on and waits.
        for mut daemon in self.daemons.drain(..).rev() {
            let _ = Command::new("kill").args(["-TERM", &daemon.id().to_string()]).status();
            let _ = daemon.wait();
        }
    }
}

/// Ports that nobody listens on.
fn free_ports() -> [u16; 3] {
    let listeners = [(); 3].map(|()| TcpListener::bind("127.0.0.1:0").unwrap());
    listeners.map(|listener| listener.local_addr().unwrap().port())
}

fn repeatable_rows(folder: &Path) -> Vec<String> {
    let records = Results::read(folder).unwrap().records;
    let mut rows: Vec<_> = records.iter().map(|row| format!("{:?}", repeatable(row))).collect();
    rows.sort();
    rows
}

/// Puts the experiment and the program into the folder of `slurm`.
fn prepare(slurm: &Slurm) {
    std::fs::write(slurm.path("tiny.toml"), EXPERIMENT).unwrap();
    let program = INTERRUPTED
        .replace("TRIQUAD", env!("CARGO_BIN_EXE_triquad"))
        .replace("CONFIGURATION", slurm.path("slurm.conf").to_str().unwrap());
    std::fs::write(slurm.path("triquad"), program).unwrap();
    std::fs::set_permissions(slurm.path("triquad"), Permissions::from_mode(0o755)).unwrap();
}

/// Submits the array and tells its id and that of the job that puts the parts together.
fn submit(slurm: &Slurm, out: &str, jobs: &str, options: &[&str]) -> [String; 2] {
    let script = Path::new(env!("CARGO_MANIFEST_DIR")).join("../experiments/slurm/submit.sh");
    let mut command = slurm.command("bash");
    command.arg(script).args(options).env("OUT", out).env("JOBS", jobs);
    command.env("SCALE", "demo").env("EXPERIMENTS", "tiny.toml");
    command.env("DATA", "").env("CACHE", "cache");
    command.env("TRIQUAD", slurm.path("triquad")).env("PARTS", PARTS.to_string());
    command.env("TIME", "3").env("MEMORY_GIGABYTES", "1");
    let output = command.output().unwrap();
    let text = String::from_utf8(output.stdout).unwrap();
    let stderr = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{text}{stderr}{}", slurm.logs());
    let ids: Vec<_> = text
        .lines()
        .filter_map(|line| line.strip_prefix("job ")?.split_once(':'))
        .map(|(id, _)| id.to_owned())
        .collect();
    ids.try_into().unwrap_or_else(|_| panic!("two jobs in {text}"))
}

/// Each block has been run on one node, so that what is compared is comparable.
fn check_blocks(slurm: &Slurm) {
    let mut part_of = BTreeMap::new();
    for part in 1..=PARTS {
        let results = Results::read(&slurm.path(&format!("out/part-{part}"))).unwrap();
        assert!(!results.records.is_empty(), "part {part} did nothing");
        for record in results.records {
            let block = (record.id.mesh.name, record.repetition);
            assert_eq!(*part_of.entry(block.clone()).or_insert(part), part, "{block:?}");
        }
    }
    assert_eq!(part_of.len(), 6);
}

#[test]
fn a_job_array_gives_the_rows_of_an_undivided_run() {
    if !Slurm::is_possible() {
        return;
    }
    let slurm = Slurm::start();
    prepare(&slurm);
    let [array, finish] = submit(&slurm, "out", "1", &[]);
    let [shared, _] = submit(&slurm, "shared", "2", &["--hold"]);
    let is_shared = [&array, &shared].map(|id| slurm.jobs(id)[0]["OverSubscribe"] != "NO");
    assert_eq!(is_shared, [false, true], "nodes are shared only where rows say so");
    let mut undivided = slurm.command(env!("CARGO_BIN_EXE_triquad"));
    undivided.args(["run", "tiny.toml", "--scale", "demo", "--out", "undivided"]);
    undivided.args(["--cache", "cache"]);
    assert!(undivided.output().unwrap().status.success());
    slurm.wait("end of the jobs", |slurm| {
        let over = |state: &String| !["PENDING", "RUNNING", "COMPLETING"].contains(&&state[..]);
        slurm.jobs(&finish).iter().any(|job| over(&job["JobState"]))
    });

    for (id, tasks) in [(&array, PARTS), (&finish, 1)] {
        let jobs = slurm.jobs(id);
        assert_eq!(jobs.len(), tasks);
        for job in jobs {
            assert_eq!(job["JobState"], "COMPLETED", "{job:?}\n{}", slurm.logs());
            let restarts =
                if job.get("ArrayTaskId").is_some_and(|id| id == "2") { "1" } else { "0" };
            assert_eq!(job["Restarts"], restarts, "{job:?}");
        }
    }
    check_blocks(&slurm);
    let rows = repeatable_rows(&slurm.path("out/whole"));
    assert_eq!(rows.len(), RUNS);
    assert_eq!(rows, repeatable_rows(&slurm.path("undivided")));
    let text = std::fs::read_to_string(slurm.path("out/whole/runs.csv")).unwrap();
    assert_eq!(text.lines().count(), 1 + RUNS);
    assert!(slurm.path("out/whole/compare.csv").exists(), "{}", slurm.logs());
}
