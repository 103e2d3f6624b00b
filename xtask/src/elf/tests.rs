//! The checks on hand-made programs: each holds one thing that is forbidden, reached in one way.

use super::check;
use object::write::{Object, Symbol, SymbolSection};
use object::{Architecture, BinaryFormat, Endianness, SectionKind, SymbolFlags, SymbolKind, SymbolScope};

const PANIC: &str = "_ZN4core9panicking9panic_fmt17h0123456789abcdefE";
const KERNEL: &str = "_ZN5carom7impulse7resolve17h0123456789abcdefE";
const KERNEL_PANICS: &str = "a panic: carom::impulse::resolve -> core::panicking::panic_fmt";

/// A function: name, instructions, literals. Each takes a multiple of four bytes.
type Code<'a> = (&'a str, &'a [u8], &'a [u8]);

const fn returns(name: &str) -> Code<'_> {
    (name, &[0x70, 0x47, 0x00, 0xbf], &[]) // bx lr; nop
}

/// An ELF file of the functions, one behind the other from address 0.
fn program(functions: &[Code<'_>]) -> Vec<u8> {
    let mut object = Object::new(BinaryFormat::Elf, Architecture::Arm, Endianness::Little);
    let text = object.add_section(Vec::new(), b".text".to_vec(), SectionKind::Text);
    let mut bytes = Vec::new();
    for (name, code, literals) in functions {
        let start = bytes.len() as u64;
        let size = (code.len() + literals.len()) as u64;
        let function = (*name, SymbolKind::Text, start, size);
        let marks = [("$t", SymbolKind::Label, start, 0), ("$d", SymbolKind::Label, start + code.len() as u64, 0)];
        for (name, kind, value, size) in [function].into_iter().chain(marks) {
            object.add_symbol(Symbol {
                name: name.as_bytes().to_vec(),
                value,
                size,
                kind,
                scope: SymbolScope::Compilation,
                weak: false,
                section: SymbolSection::Section(text),
                flags: SymbolFlags::None,
            });
        }
        bytes.extend_from_slice(code);
        bytes.extend_from_slice(literals);
    }
    object.append_section_data(text, &bytes, 4);
    object.write().expect("an ELF file")
}

#[track_caller]
fn finds(functions: &[Code<'_>], expected: &[&str]) {
    let found = check(&program(functions), true, true).expect("a readable ELF file");
    assert_eq!(found, expected);
}

#[test]
fn nothing() {
    finds(&[returns(KERNEL), returns("main")], &[]);
}

#[test]
fn a_panic_that_only_others_reach() {
    finds(&[("main", &[0x00, 0xf0, 0x00, 0xf8], &[]), returns(PANIC), returns(KERNEL)], &[]); // bl panic_fmt
}

#[test]
fn a_panic_that_is_called_or_jumped_to() {
    for code in [
        [0x00, 0xf0, 0x00, 0xf8], // bl panic_fmt
        [0x00, 0xf0, 0x00, 0xb8], // b.w panic_fmt
        [0x00, 0xf0, 0x00, 0x80], // beq.w panic_fmt
        [0x00, 0xe0, 0x00, 0xbf], // b panic_fmt; nop
        [0x00, 0xd0, 0x00, 0xbf], // beq panic_fmt; nop
    ] {
        finds(&[(KERNEL, &code, &[]), returns(PANIC)], &[KERNEL_PANICS]);
    }
}

#[test]
fn a_panic_two_calls_away() {
    let bl_next = [0x00, 0xf0, 0x00, 0xf8];
    finds(
        &[("demo::kernel_step", &bl_next, &[]), ("middle", &bl_next, &[]), returns(PANIC)],
        &["a panic: demo::kernel_step -> middle -> core::panicking::panic_fmt"],
    );
}

#[test]
fn a_panic_whose_address_is_a_literal() {
    // panic_fmt lies at 0; its address has the lowest bit set. ldr r0, [pc]; blx r0
    finds(&[returns(PANIC), (KERNEL, &[0x00, 0x48, 0x80, 0x47], &[1, 0, 0, 0])], &[KERNEL_PANICS]);
    // The same bytes as instructions are no address.
    finds(&[returns(PANIC), (KERNEL, &[0x00, 0xbf, 0x00, 0xbf, 1, 0, 0, 0], &[])], &[]);
}

#[test]
fn a_panic_whose_address_is_put_together() {
    // movw r0, #1; movt r0, #0; blx r0; nop
    let code = [0x40, 0xf2, 0x01, 0x00, 0xc0, 0xf2, 0x00, 0x00, 0x80, 0x47, 0x00, 0xbf];
    finds(&[returns(PANIC), (KERNEL, &code, &[])], &[KERNEL_PANICS]);
}

#[test]
fn a_call_that_nobody_can_follow() {
    finds(
        &[(KERNEL, &[0x80, 0x47, 0x70, 0x47], &[])], // blx r0; bx lr
        &["a call of something unknown: carom::impulse::resolve"],
    );
}

#[test]
fn an_allocator_and_a_float_routine_anywhere() {
    finds(
        &[returns(KERNEL), returns("__rust_alloc"), returns("__addsf3")],
        &["part of an allocator: __rust_alloc", "a float routine in fixed-point firmware: __addsf3"],
    );
}

#[test]
fn a_wide_division() {
    finds(
        &[(KERNEL, &[0x00, 0xf0, 0x00, 0xf8], &[]), returns("__aeabi_uldivmod")],
        &["a division of 64 bits or more: carom::impulse::resolve -> __aeabi_uldivmod"],
    );
}

#[test]
fn fpu_arithmetic() {
    let vadd = [0x30, 0xee, 0x20, 0x0a];
    finds(&[(KERNEL, &vadd, &[])], &["FPU arithmetic in fixed-point code: carom::impulse::resolve"]);
    let found = check(&program(&[(KERNEL, &vadd, &[])]), false, false).expect("a readable ELF file");
    assert!(found.is_empty(), "floats are fine where they are meant: {found:?}");
}

#[test]
fn no_kernel_to_begin_with() {
    let found = check(&program(&[returns("main")]), true, true).expect("a readable ELF file");
    assert!(found.iter().any(|line| line.contains("nothing was checked")), "{found:?}");
}

#[test]
fn no_program_at_all() {
    assert!(check(b"text", true, true).is_err());
    assert!(check(&program(&[]), true, true).is_err(), "an ELF file without functions");
}
