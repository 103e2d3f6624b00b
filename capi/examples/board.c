/* A Cortex-M without a C library: start-up code, and semihosting, the debug channel that QEMU and debug probes serve. */
#include "board.h"
#include <stddef.h>

enum { SYS_OPEN = 0x01, SYS_WRITE = 0x05, SYS_EXIT = 0x18 };
enum { OPEN_WRITE = 4 };
enum { STOPPED_RUN_TIME_ERROR = 0x20023, STOPPED_APPLICATION_EXIT = 0x20026 };

static int32_t semihosting(uint32_t operation, uintptr_t argument)
{
    register uint32_t r0 __asm__("r0") = operation;
    register uintptr_t r1 __asm__("r1") = argument;
    __asm__ volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
    return (int32_t)r0;
}

void board_print(const char *text)
{
    static uintptr_t output;
    uintptr_t block[3];
    size_t length = 0;
    if (output == 0) {
        block[0] = (uintptr_t) ":tt";
        block[1] = OPEN_WRITE;
        block[2] = 3;
        output = (uintptr_t)semihosting(SYS_OPEN, (uintptr_t)block);
    }
    while (text[length] != '\0') {
        length++;
    }
    block[0] = output;
    block[1] = (uintptr_t)text;
    block[2] = length;
    if (semihosting(SYS_WRITE, (uintptr_t)block) != 0) {
        board_exit(1); /* what cannot be told must not look like a good run */
    }
}

void board_exit(int status)
{
    for (;;) {
        semihosting(SYS_EXIT, status == 0 ? STOPPED_APPLICATION_EXIT : STOPPED_RUN_TIME_ERROR);
    }
}

/* From board.ld. */
extern uint32_t data_start[], data_end[], data_in_flash[], bss_start[], bss_end[], stack_top[];

int main(void);
void reset(void);

void reset(void)
{
    uint32_t *to;
    const uint32_t *from = data_in_flash;
    for (to = data_start; to != data_end; to++) {
        *to = *from++;
    }
    for (to = bss_start; to != bss_end; to++) {
        *to = 0;
    }
#ifdef __ARM_FP
    /* The FPU is off at first. */
    *(volatile uint32_t *)0xe000ed88 |= 0xfu << 20;
    __asm__ volatile("dsb\n isb" ::: "memory");
#endif
    board_exit(main());
}

/* A fault is most often a stack that has grown out of the RAM: this begins with a fresh one. */
__attribute__((naked)) static void fault(void)
{
    __asm__ volatile("ldr r0, =stack_top\n mov sp, r0\n movs r0, #1\n bl board_exit\n .pool");
}

struct vectors {
    uint32_t *stack;
    void (*handlers[15])(void);
};

__attribute__((section(".vectors"), used)) static const struct vectors vectors = {
    stack_top,
    {reset, fault, fault, fault, fault, fault},
};
