//! The weighing, on hand-made firmware of a chip: each lacks one thing, or has one too many.

use super::part::{PARTS, Part};

const FLASH: u32 = 0x0800_0000;
const RAM: u32 = 0x2000_0000;
const RAM_END: u32 = RAM + 128 * 1024;
const RESET: u32 = FLASH + 0x101;

/// Whether a section is stored in flash, or only takes RAM.
#[derive(Clone, Copy)]
enum Kind {
    Stored,
    Zeroed,
}

/// A section's place, size and first words.
type Section<'a> = (Kind, u32, u32, &'a [u32]);

const VECTORS: Section<'_> = (Kind::Stored, FLASH, 0x400, &[RAM_END, RESET]);
const DATA: Section<'_> = (Kind::Stored, RAM, 0x20, &[]);
const BSS: Section<'_> = (Kind::Zeroed, RAM + 0x20, 0x100, &[]);

fn words(words: &[u32]) -> Vec<u8> {
    words.iter().flat_map(|word| word.to_le_bytes()).collect()
}

/// An ELF file for Arm with the sections, one symbol `_stack_start` and the tables for both.
fn firmware(sections: &[Section<'_>], stack: u32) -> Vec<u8> {
    const HEADER: u32 = 52;
    let mut body = Vec::new();
    // An empty section comes first.
    let mut table = words(&[0; 10]);
    let mut add = |kind: u32, flags: u32, address: u32, size: u32, data: &[u8], [link, info, entry]: [u32; 3]| {
        let at = HEADER + body.len() as u32;
        body.extend_from_slice(data);
        body.resize(body.len().next_multiple_of(4), 0);
        table.extend(words(&[0, kind, flags, address, at, size, link, info, 4, entry]));
    };
    for &(kind, address, size, first) in sections {
        let mut data = words(first);
        data.resize(size as usize, 0);
        match kind {
            Kind::Stored => add(1, 2, address, size, &data, [0; 3]),
            Kind::Zeroed => add(8, 3, address, size, &[], [0; 3]),
        }
    }
    let names = b"\0_stack_start\0";
    add(3, 0, 0, names.len() as u32, names, [0; 3]);
    let strings = sections.len() as u32 + 1;
    // Nothing, then a name, a value, and: global, in no section.
    let symbols = words(&[0, 0, 0, 0, 1, stack, 0, 0xfff1_0010]);
    add(2, 0, 0, symbols.len() as u32, &symbols, [strings, 1, 16]);

    let mut file = vec![0x7f, b'E', b'L', b'F', 1, 1, 1, 0, 0, 0, 0, 0, 0, 0, 0, 0, 2, 0, 40, 0];
    file.extend(words(&[1, RESET, 0, HEADER + body.len() as u32, 0]));
    let count = sections.len() as u16 + 3;
    file.extend([52, 32, 0, 40, count, strings as u16].iter().flat_map(|half: &u16| half.to_le_bytes()));
    file.extend(body);
    file.extend(table);
    file
}

fn discovery() -> &'static Part {
    PARTS.iter().find(|part| part.board == "stm32f4-discovery").expect("it is one of them")
}

#[track_caller]
fn refused(sections: &[Section<'_>], stack: u32, why: &str) {
    let error = discovery().weigh(&firmware(sections, stack)).expect_err("it must not pass");
    assert!(error.to_string().contains(why), "{error}");
}

#[test]
fn what_fits() {
    let sizes = discovery().weigh(&firmware(&[VECTORS, DATA, BSS], RAM_END)).expect("it fits");
    // What is in RAM from the start is stored in flash, too.
    let wanted =
        format!("{:>7} bytes of flash, {:>5} of RAM, {:>6} left for the stack", 0x420, 0x120, 0x2_0000 - 0x120);
    assert_eq!(sizes.to_string(), wanted);
}

#[test]
fn sections_beside_the_memory() {
    refused(&[VECTORS, (Kind::Stored, FLASH + 0x400, 1024 * 1024, &[])], RAM_END, "lies in no memory");
    refused(&[VECTORS, (Kind::Zeroed, RAM, 128 * 1024 + 4, &[])], RAM_END, "lies in no memory");
    refused(&[VECTORS, (Kind::Zeroed, FLASH + 0x400, 4, &[])], RAM_END, "lies in no memory");
}

#[test]
fn more_than_the_flash_holds() {
    let code = (Kind::Stored, FLASH + 0x400, 1024 * 1024 - 0x400, &[][..]);
    assert!(discovery().weigh(&firmware(&[VECTORS, code], RAM_END)).is_ok());
    refused(&[VECTORS, code, DATA], RAM_END, "do not fit the flash");
}

#[test]
fn a_stack_in_the_wrong_place() {
    refused(&[VECTORS, BSS], RAM_END + 8, "the stack begins");
    refused(&[VECTORS, BSS], RAM + 0x20, "the stack begins");
}

#[test]
fn vectors_that_start_nothing() {
    refused(&[(Kind::Stored, FLASH + 0x400, 0x400, &[RAM_END, RESET])], RAM_END, "no vector table");
    refused(&[(Kind::Stored, FLASH, 0x400, &[RAM, RESET])], RAM_END, "the vector table begins");
    refused(&[(Kind::Stored, FLASH, 0x400, &[RAM_END, RESET - 1])], RAM_END, "the vector table begins");
    refused(&[(Kind::Stored, FLASH, 0x400, &[RAM_END, RAM + 1])], RAM_END, "the vector table begins");
}

#[test]
fn what_the_rom_wants() {
    let part = |name| PARTS.iter().find(|part| part.board == name).expect("it is one of them");
    const XIP: u32 = 0x1000_0000;
    let top = RAM + 256 * 1024;
    let (boot, vectors) = ((Kind::Stored, XIP, 256, &[][..]), (Kind::Stored, XIP + 256, 256, &[top, XIP + 0x201][..]));
    assert!(part("pico").weigh(&firmware(&[boot, vectors], top)).is_ok());
    assert!(part("pico").weigh(&firmware(&[vectors], top)).is_err());
    let vectors = |mark| [top, XIP + 0x201, mark];
    let image = |mark| firmware(&[(Kind::Stored, XIP, 256, &vectors(mark))], top);
    assert!(part("pico2").weigh(&image(0xffff_ded3)).is_ok());
    assert!(part("pico2").weigh(&image(0xffff_ded4)).is_err());
}
