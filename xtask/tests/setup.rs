//! The set-up on machines that do not exist: a folder of stub programs is all there is on `PATH`, and they write down
//! how they are called.
#![cfg(unix)]

use std::fs;
use std::os::unix::fs::PermissionsExt;
use std::path::PathBuf;
use std::process::{Command, Output};

const TARGETS: &str = "thumbv6m-none-eabi thumbv7m-none-eabi thumbv7em-none-eabihf \
                       thumbv8m.main-none-eabihf thumbv8m.main-none-eabi";

struct Machine {
    home: tempfile::TempDir,
}

impl Machine {
    /// With a Rust compiler as rustup installs it, without targets, and without QEMU.
    fn new() -> Self {
        let machine = Machine { home: tempfile::tempdir().expect("a temporary folder") };
        fs::create_dir_all(machine.path("bin")).expect("a folder for stubs");
        machine.stub("rustc", &format!("echo {}", machine.sysroot().display()));
        machine.stub("id", "echo 0");
        machine
    }

    fn path(&self, name: &str) -> PathBuf {
        self.home.path().join(name)
    }

    fn sysroot(&self) -> PathBuf {
        self.path("rustup/toolchains/stable")
    }

    /// Puts a program on `PATH` that notes its call and then does `script`.
    fn stub(&self, name: &str, script: &str) {
        let file = self.path("bin").join(name);
        let calls = self.path("calls");
        let note = if matches!(name, "rustc" | "id") {
            String::new()
        } else {
            format!("echo \"{name} $*\" >> '{}'\n", calls.display())
        };
        fs::write(&file, format!("#!/bin/sh\n{note}{script}\n")).expect("a stub");
        fs::set_permissions(&file, fs::Permissions::from_mode(0o755)).expect("a stub that runs");
    }

    fn with_qemu(self) -> Self {
        self.stub("qemu-system-arm", "");
        self
    }

    /// As if `target` had been added.
    fn add_target(&self, target: &str) {
        let lib = self.sysroot().join("lib/rustlib").join(target).join("lib");
        fs::create_dir_all(&lib).expect("a target's folder");
        fs::write(lib.join("libcore-0123.rlib"), "").expect("a target's core");
    }

    /// A rustup that adds the targets.
    fn with_rustup(self) -> Self {
        let lib = self.sysroot().join("lib/rustlib");
        self.stub(
            "rustup",
            &format!(
                "shift 2\nfor target; do\n/bin/mkdir -p '{lib}'/$target/lib\n: > '{lib}'/$target/lib/libcore-1.rlib\ndone",
                lib = lib.display()
            ),
        );
        self
    }

    /// A package manager, with which QEMU comes.
    fn stub_manager(&self, name: &str) {
        let qemu = self.path("bin/qemu-system-arm");
        self.stub(name, &format!(": > '{}'", qemu.display()));
    }

    fn setup(&self, environment: &[(&str, &str)]) -> Output {
        self.run(&["setup"], environment)
    }

    fn run(&self, arguments: &[&str], environment: &[(&str, &str)]) -> Output {
        let mut setup = Command::new(env!("CARGO_BIN_EXE_xtask"));
        setup.args(arguments).env_clear().env("PATH", self.path("bin")).env("CARGO_TARGET_DIR", self.path("target"));
        setup.envs(environment.iter().copied()).output().expect("the set-up starts")
    }

    /// How the stubs were called.
    fn calls(&self) -> Vec<String> {
        let calls = fs::read_to_string(self.path("calls")).unwrap_or_default();
        calls.lines().map(str::to_owned).collect()
    }
}

#[track_caller]
fn succeeded(output: &Output) {
    assert!(output.status.success(), "{}{}", text(&output.stdout), text(&output.stderr));
}

/// The set-up failed, and its last word was one sentence with all of these in it.
#[track_caller]
fn failed_with(output: &Output, words: &[&str]) {
    assert!(!output.status.success(), "{}", text(&output.stdout));
    let stderr = text(&output.stderr);
    let last = stderr.lines().last().expect("a last word");
    assert!(last.starts_with("error: "), "{stderr}");
    for word in words {
        assert!(last.contains(word), "no `{word}` in: {last}");
    }
    assert_eq!(stderr.matches("error: ").count(), 1, "{stderr}");
}

fn text(bytes: &[u8]) -> String {
    String::from_utf8_lossy(bytes).into_owned()
}

#[test]
fn rustup_adds_the_five_targets_and_only_once() {
    let machine = Machine::new().with_qemu().with_rustup();
    succeeded(&machine.setup(&[]));
    assert_eq!(machine.calls(), [format!("rustup target add {TARGETS}")]);
    succeeded(&machine.setup(&[]));
    assert_eq!(machine.calls().len(), 1, "nothing is to be done the second time");
}

#[test]
fn one_missing_target_is_enough_to_call_rustup() {
    let machine = Machine::new().with_qemu().with_rustup();
    for target in TARGETS.split_whitespace().skip(1) {
        machine.add_target(target);
    }
    succeeded(&machine.setup(&[]));
    assert_eq!(machine.calls(), [format!("rustup target add {TARGETS}")]);
}

#[test]
fn a_complete_machine_is_left_alone() {
    let machine = Machine::new().with_qemu().with_rustup();
    machine.stub_manager("apt-get");
    TARGETS.split_whitespace().for_each(|target| machine.add_target(target));
    succeeded(&machine.setup(&[]));
    assert_eq!(machine.calls(), [""; 0]);
}

#[test]
fn a_rustup_that_fails_where_debian_is_not_ends_in_one_sentence() {
    let machine = Machine::new().with_qemu();
    machine.stub("rustup", "echo 'error: no network' >&2; exit 1");
    let output = machine.setup(&[]);
    let told = text(&output.stderr).replace("error: no network", "rustup: no network");
    let output = Output { stderr: told.into_bytes(), ..output };
    failed_with(&output, &["rustup did not add them", TARGETS, "try again"]);
    assert_eq!(machine.calls(), [format!("rustup target add {TARGETS}")]);
}

#[test]
fn a_rustup_that_only_says_that_it_succeeded_is_not_believed() {
    let machine = Machine::new().with_qemu();
    machine.stub("rustup", "");
    failed_with(&machine.setup(&[]), &["rustup did not add them"]);
}

#[test]
fn neither_rustup_nor_debian_ends_in_one_sentence() {
    let machine = Machine::new().with_qemu();
    failed_with(&machine.setup(&[]), &["there is no rustup", TARGETS, "https://rustup.rs"]);
}

#[test]
fn debians_way_needs_debian() {
    let machine = Machine::new().with_qemu().with_rustup();
    failed_with(&machine.setup(&[("CAROM_THUMB", "debian")]), &["CAROM_THUMB=debian", "package manager"]);
    assert_eq!(machine.calls(), [""; 0], "Debian's way does not go to rustup");
}

#[test]
fn an_unknown_way_is_refused() {
    let machine = Machine::new().with_qemu();
    failed_with(&machine.setup(&[("CAROM_THUMB", "windows")]), &["CAROM_THUMB", "`windows`", "`debian`"]);
}

#[test]
fn qemu_comes_from_the_package_manager() {
    let managers = [
        (
            "apt-get",
            "apt-get install -y --no-install-recommends --no-remove -o DPkg::Lock::Timeout=600 qemu-system-arm",
        ),
        ("dnf", "dnf install -y qemu-system-arm"),
        ("pacman", "pacman -Sy --noconfirm --needed qemu-system-arm"),
        ("zypper", "zypper --non-interactive install qemu-arm"),
        ("apk", "apk add qemu-system-arm"),
        ("brew", "brew install qemu"),
    ];
    for (manager, call) in managers {
        let machine = Machine::new().with_rustup();
        machine.stub_manager(manager);
        let output = machine.setup(&[]);
        succeeded(&output);
        assert!(text(&output.stdout).contains("emulates the boards"), "it says why");
        assert!(machine.calls().contains(&call.to_owned()), "{:?}", machine.calls());
    }
}

#[test]
fn apt_refreshes_its_lists_and_tries_again() {
    let machine = Machine::new().with_rustup();
    let fresh = machine.path("fresh");
    let qemu = machine.path("bin/qemu-system-arm");
    let script = format!(
        "case $1 in update) : > '{fresh}' ;; install) [ -e '{fresh}' ] && : > '{qemu}' ;; esac",
        fresh = fresh.display(),
        qemu = qemu.display()
    );
    machine.stub("apt-get", &script);
    succeeded(&machine.setup(&[]));
    let verbs: Vec<String> = machine
        .calls()
        .iter()
        .filter_map(|call| call.strip_prefix("apt-get ")?.split(' ').next().map(str::to_owned))
        .collect();
    assert_eq!(verbs, ["install", "update", "install"]);
}

#[test]
fn who_is_not_root_needs_sudo() {
    let machine = Machine::new().with_rustup();
    machine.stub("id", "echo 1000");
    machine.stub_manager("apt-get");
    failed_with(&machine.setup(&[]), &["there is no sudo", "apt-get install", "qemu-system-arm"]);
    machine.stub("sudo", "\"$@\"");
    succeeded(&machine.setup(&[]));
    assert!(machine.calls().iter().any(|call| call.starts_with("sudo apt-get install")), "{:?}", machine.calls());
}

#[test]
fn no_qemu_and_no_package_manager_ends_in_one_sentence() {
    let machine = Machine::new().with_rustup();
    failed_with(&machine.setup(&[]), &["qemu-system-arm is missing", "package manager"]);
}

#[test]
fn a_package_without_qemu_in_it_is_noticed() {
    let machine = Machine::new().with_rustup();
    machine.stub("dnf", "");
    failed_with(&machine.setup(&[]), &["installed no qemu-system-arm"]);
}

#[test]
fn risc_v_has_an_emulator_and_a_target_of_its_own() {
    let stage = ["test", "--only", "riscv", "--yes"];
    let machine = Machine::new().with_qemu();
    TARGETS.split_whitespace().for_each(|target| machine.add_target(target));
    machine.add_target("riscv32imac-unknown-none-elf");
    let output = machine.run(&stage, &[]);
    assert!(text(&output.stderr).contains("qemu-system-riscv32 is missing"), "{}", text(&output.stderr));
    for (manager, call) in [
        (
            "apt-get",
            "apt-get install -y --no-install-recommends --no-remove -o DPkg::Lock::Timeout=600 qemu-system-misc",
        ),
        ("pacman", "pacman -Sy --noconfirm --needed qemu-system-riscv"),
        ("apk", "apk add qemu-system-riscv32"),
    ] {
        let machine = Machine::new().with_qemu();
        machine.stub("rustup", "exit 1");
        machine.add_target("riscv32imac-unknown-none-elf");
        machine.stub_manager(manager);
        let output = machine.run(&stage, &[]);
        assert!(text(&output.stderr).contains("installed no qemu-system-riscv32"), "{}", text(&output.stderr));
        assert!(machine.calls().contains(&call.to_owned()), "{:?}", machine.calls());
    }
    let machine = Machine::new().with_qemu().with_rustup();
    TARGETS.split_whitespace().for_each(|target| machine.add_target(target));
    machine.run(&stage, &[]);
    assert_eq!(machine.calls(), ["rustup target add riscv32imac-unknown-none-elf"]);
}
