/* What the examples need of a board: a place to print to, and an end. board.c is QEMU or a debug probe (semihosting), host.c a PC. */
#ifndef BOARD_H
#define BOARD_H

#include <stdint.h>

void board_print(const char *text);
void board_print_integer(int32_t number);
void board_print_hex(uint64_t number); /* sixteen digits */

/* Ends the program: 0 is success. */
void board_exit(int status);

#endif
