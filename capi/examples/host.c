/* The board that is a PC. */
#include "board.h"
#include <stdio.h>
#include <stdlib.h>

void board_print(const char *text)
{
    fputs(text, stdout);
}

void board_exit(int status)
{
    exit(status == 0 ? EXIT_SUCCESS : EXIT_FAILURE);
}
