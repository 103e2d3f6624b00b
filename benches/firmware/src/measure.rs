//! The measurement in one number type: the small operations on the first impact, the impulse on every impact.

use crate::board;
use crate::harness::{Call, counter, input, stack};
use crate::operands::Operands;
use crate::operations::Operations;

/// Measures everything, and prints it line by line:
///
/// - `counter EMPTY TICKS`: what was subtracted; ticks of the counter for a thousand instructions
/// - `operation NAME INSTRUCTIONS STACK`
/// - `result NAME WORD...`: of the first impact without friction and with it, the bits of v_a, w_a, v_b and w_b
/// - `row INDEX INSTRUCTIONS STACK INSTRUCTIONS STACK`: an impact without friction, and with it
/// - `skip INDEX`: the number type cannot hold the impact, or what comes of it
pub fn run<S: Operations>() -> Result<(), &'static str> {
    board::println!("counter {} {}", counter::empty(), counter::ticks_per_thousand());
    let path = board::option("--input").ok_or("--input FILE is missing")?;
    let mut file = board::open(path).map_err(|_| "the input cannot be opened")?;
    let mut index = 0_u32;
    while let Some(impact) = input::next(&mut file)? {
        match Operands::<S>::new(&impact) {
            Some(operands) => {
                if index == 0 {
                    small(&operands)?;
                }
                row(index, &operands)?;
            }
            None => board::println!("skip {index}"),
        }
        index += 1;
    }
    Ok(())
}

fn small<S: Operations>(start: &Operands<S>) -> Result<(), &'static str> {
    let mut operands = *start;
    for (name, call) in S::small(&mut operands) {
        let [instructions, stack] = measure(&call)?;
        board::println!("operation {name} {instructions} {stack}");
    }
    Ok(())
}

fn row<S: Operations>(index: u32, start: &Operands<S>) -> Result<(), &'static str> {
    let mut operands = *start;
    let resolve = twice(&mut operands, start, S::resolve)?;
    let clipped = operands.impact.saturated;
    if index == 0 {
        result("resolve", &operands);
    }
    let friction = twice(&mut operands, start, S::friction)?;
    if index == 0 {
        result("friction", &operands);
    }
    if clipped || operands.impact.saturated {
        board::println!("skip {index}");
    } else {
        board::println!("row {index} {} {} {} {}", resolve[0], resolve[1], friction[0], friction[1]);
    }
    Ok(())
}

fn result<S: Operations>(name: &str, operands: &Operands<S>) {
    board::print!("result {name}");
    for body in [&operands.a, &operands.b] {
        for vector in [body.linear_velocity, body.angular_velocity] {
            vector.to_array().iter().for_each(|x| board::print!(" {}", x.to_word()));
        }
    }
    board::println!();
}

/// Instructions, then stack: an impact changes its operands, and each measurement begins with the same.
fn twice<S: Operations>(
    operands: &mut Operands<S>,
    start: &Operands<S>,
    call: fn(&mut Operands<S>) -> Call,
) -> Result<[u32; 2], &'static str> {
    *operands = *start;
    let instructions = counter::instructions(&call(operands)).ok_or(TOO_LONG)?;
    *operands = *start;
    let stack = stack::bytes(&call(operands)).ok_or(TOO_DEEP)?;
    Ok([instructions, stack])
}

/// An operation that leaves its operands as they are.
fn measure(call: &Call) -> Result<[u32; 2], &'static str> {
    Ok([counter::instructions(call).ok_or(TOO_LONG)?, stack::bytes(call).ok_or(TOO_DEEP)?])
}

const TOO_LONG: &str = "an operation took longer than the counter counts";
const TOO_DEEP: &str = "an operation took more stack than is painted";
