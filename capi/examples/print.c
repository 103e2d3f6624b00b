/* Numbers as text, without a C library. */
#include "board.h"

void board_print_integer(int32_t number)
{
    char text[12];
    char *first = text + sizeof text - 1;
    uint32_t rest = number < 0 ? 0u - (uint32_t)number : (uint32_t)number;
    *first = '\0';
    do {
        *--first = (char)('0' + rest % 10u);
        rest /= 10u;
    } while (rest != 0u);
    if (number < 0) {
        *--first = '-';
    }
    board_print(first);
}

void board_print_hex(uint64_t number)
{
    char text[17];
    int digit;
    for (digit = 15; digit >= 0; digit--) {
        text[digit] = "0123456789abcdef"[number & 15u];
        number >>= 4;
    }
    text[16] = '\0';
    board_print(text);
}
