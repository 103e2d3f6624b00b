//! Decodes as much of the Thumb instruction set as a call graph takes.

/// What an instruction means to a call graph.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Op {
    /// Goes to that address, to come back (`bl`) or not (`b`, conditional or not).
    Jump(u32),
    /// Calls whatever a register points to.
    CallRegister,
    /// Sets a register to a 16-bit constant.
    LowHalf { register: u8, value: u16 },
    /// Sets the upper half of a register to a constant.
    HighHalf { register: u8, value: u16 },
    /// Computes with the FPU. Loads, stores and moves of FPU registers are not computing.
    Float,
    /// Anything else.
    Other,
}

/// The instruction at `address`, whose two halfwords are given, and its size in bytes.
pub fn decode(address: u32, first: u16, second: u16) -> (Op, u32) {
    // 32-bit instructions begin with 0b11101, 0b11110 or 0b11111.
    if first >> 11 >= 0b11101 { (decode_32(address, first, second), 4) } else { (decode_16(address, first), 2) }
}

fn decode_16(address: u32, code: u16) -> Op {
    let jump = |offset| Op::Jump(address.wrapping_add(4).wrapping_add(offset));
    match code {
        _ if code & 0xff87 == 0x4780 => Op::CallRegister,
        // b
        _ if code >> 11 == 0b11100 => jump(sign_extend(u32::from(code & 0x7ff) << 1, 12)),
        // b<condition>; conditions 14 and 15 are other instructions.
        _ if code >> 12 == 0b1101 && (code >> 8) & 15 < 14 => jump(sign_extend(u32::from(code & 0xff) << 1, 9)),
        _ => Op::Other,
    }
}

fn decode_32(address: u32, first: u16, second: u16) -> Op {
    let jump = |offset| Op::Jump(address.wrapping_add(4).wrapping_add(offset));
    let (hi, lo) = (u32::from(first), u32::from(second));
    let (sign, j1, j2) = ((hi >> 10) & 1, (lo >> 13) & 1, (lo >> 11) & 1);
    let branches = first >> 11 == 0b11110;

    // bl, b.w: 11110 S imm10, 1x J1 1 J2 imm11
    if branches && second & 0x9000 == 0x9000 {
        let (i1, i2) = (!(j1 ^ sign) & 1, !(j2 ^ sign) & 1);
        let offset = (sign << 24) | (i1 << 23) | (i2 << 22) | ((hi & 0x3ff) << 12) | ((lo & 0x7ff) << 1);
        return jump(sign_extend(offset, 25));
    }
    // b<condition>.w: 11110 S cond imm6, 10 J1 0 J2 imm11
    if branches && second & 0xd000 == 0x8000 && (hi >> 6) & 15 < 14 {
        let offset = (sign << 20) | (j2 << 19) | (j1 << 18) | ((hi & 0x3f) << 12) | ((lo & 0x7ff) << 1);
        return jump(sign_extend(offset, 21));
    }
    // movw, movt: 11110 i 10x100 imm4, 0 imm3 Rd imm8
    if matches!(first & 0xfbf0, 0xf240 | 0xf2c0) && second & 0x8000 == 0 {
        let value = ((first & 15) << 12) | (((first >> 10) & 1) << 11) | ((second >> 4) & 0x700) | (second & 0xff);
        let register = (second >> 8) as u8 & 15;
        return match first & 0xfbf0 {
            0xf240 => Op::LowHalf { register, value },
            _ => Op::HighHalf { register, value },
        };
    }
    // Coprocessors 10 and 11, data processing: 111x 1110 ...., .... 101x ...0 ....
    if first & 0xef00 == 0xee00 && second & 0x0e10 == 0x0a00 {
        return Op::Float;
    }
    Op::Other
}

/// The lowest `bits` bits as a signed number.
fn sign_extend(value: u32, bits: u32) -> u32 {
    ((value << (32 - bits)) as i32 >> (32 - bits)) as u32
}

#[cfg(test)]
mod tests {
    use super::*;

    #[track_caller]
    fn check(bytes: &[u8], expected: Op, size: u32) {
        let half = |at: usize| bytes.get(at..at + 2).map_or(0, |b| u16::from_le_bytes([b[0], b[1]]));
        assert_eq!(decode(0x1000, half(0), half(2)), (expected, size));
    }

    // The bytes are what an assembler makes of the line in the comment, at address 0x1000.

    #[test]
    fn calls() {
        check(&[0x00, 0xf0, 0x00, 0xf8], Op::Jump(0x1004), 4); // bl 0x1004
        check(&[0x00, 0xf0, 0x7e, 0xf8], Op::Jump(0x1100), 4); // bl 0x1100
        check(&[0xff, 0xf7, 0xfe, 0xff], Op::Jump(0x1000), 4); // bl 0x1000
        check(&[0xfe, 0xf7, 0xfe, 0xff], Op::Jump(0x0000), 4); // bl 0x0
        check(&[0xff, 0xf0, 0xfe, 0xff], Op::Jump(0x10_1000), 4); // bl 0x101000
        check(&[0x98, 0x47], Op::CallRegister, 2); // blx r3
        check(&[0x70, 0x47], Op::Other, 2); // bx lr
    }

    #[test]
    fn branches() {
        check(&[0x06, 0xe0], Op::Jump(0x1010), 2); // b 0x1010
        check(&[0xfe, 0xe7], Op::Jump(0x1000), 2); // b .
        check(&[0x7e, 0xd0], Op::Jump(0x1100), 2); // beq 0x1100
        check(&[0xfc, 0xd1], Op::Jump(0x0ffc), 2); // bne 0xffc
        check(&[0x00, 0xf0, 0x7e, 0xb8], Op::Jump(0x1100), 4); // b.w 0x1100
        check(&[0xfe, 0xf7, 0xfe, 0xbf], Op::Jump(0x0000), 4); // b.w 0x0
        check(&[0x00, 0xf0, 0x7e, 0x80], Op::Jump(0x1100), 4); // beq.w 0x1100
        check(&[0x7f, 0xf4, 0xfe, 0xaf], Op::Jump(0x1000), 4); // bne.w .
        check(&[0xfe, 0xde], Op::Other, 2); // udf #254
        check(&[0x00, 0xdf], Op::Other, 2); // svc #0
        check(&[0xbf, 0xf3, 0x4f, 0x8f], Op::Other, 4); // dsb sy
        check(&[0xef, 0xf3, 0x00, 0x80], Op::Other, 4); // mrs r0, apsr
    }

    #[test]
    fn constants() {
        let low = |register, value| Op::LowHalf { register, value };
        let high = |register, value| Op::HighHalf { register, value };
        check(&[0x41, 0xf2, 0x34, 0x20], low(0, 0x1234), 4); // movw r0, #0x1234
        check(&[0x4a, 0xf6, 0xcd, 0x3c], low(12, 0xabcd), 4); // movw r12, #0xabcd
        check(&[0xc2, 0xf2, 0x00, 0x01], high(1, 0x2000), 4); // movt r1, #0x2000
        check(&[0x01, 0x20], Op::Other, 2); // movs r0, #1
        check(&[0x4f, 0xf4, 0x80, 0x70], Op::Other, 4); // mov.w r0, #256
    }

    #[test]
    fn floats() {
        check(&[0x30, 0xee, 0x20, 0x0a], Op::Float, 4); // vadd.f32 s0, s0, s1
        check(&[0x80, 0xee, 0x20, 0x0a], Op::Float, 4); // vdiv.f32 s0, s0, s1
        check(&[0xb1, 0xee, 0xc0, 0x0a], Op::Float, 4); // vsqrt.f32 s0, s0
        check(&[0xb8, 0xee, 0xc0, 0x0a], Op::Float, 4); // vcvt.f32.s32 s0, s0
        check(&[0x00, 0xfe, 0x20, 0x0a], Op::Float, 4); // vseleq.f32 s0, s0, s1
        check(&[0x00, 0xee, 0x10, 0x0a], Op::Other, 4); // vmov s0, r0
        check(&[0x10, 0xee, 0x10, 0x0a], Op::Other, 4); // vmov r0, s0
        check(&[0x90, 0xed, 0x00, 0x0a], Op::Other, 4); // vldr s0, [r0]
        check(&[0x2d, 0xed, 0x02, 0x8b], Op::Other, 4); // vpush {d8}
    }
}
