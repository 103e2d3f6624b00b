//! Placeholder: prints a few integers on the host and on boards.
#![cfg_attr(target_os = "none", no_std, no_main)]

mod board;

use board::Exit;

board::entry!(run);

fn run() -> Exit {
    for (index, arg) in board::args().enumerate() {
        board::println!("argument {index}: {arg}");
    }
    for n in 1..=3_i32 {
        board::println!("{n} squared is {}", kernel_square(n));
    }
    if board::option("--scalar") == Some("fail") {
        return Exit::Failure;
    }
    Exit::Success
}

#[inline(never)]
fn kernel_square(n: i32) -> i32 {
    n.saturating_mul(n)
}
