/* Nothing but the header, and its macros where constants are wanted: compiled in every language it is for, and not run. */
#include "carom.h"

static uint64_t memory[CAROM_Q20_WORLD_64X256_SIZE / sizeof(uint64_t)];
static uint64_t workspace[CAROM_F32_SOLVER_SIZE(4, 4, 16) / sizeof(uint64_t)];
static const int32_t constants[] = {CAROM_Q16(-1.5), CAROM_Q20(1.5), CAROM_Q30(1)};

extern const void *header(void);

extern const void *header(void)
{
    const carom_body_handle nobody = CAROM_NO_BODY;
    return constants[0] == 0 || nobody.bits != 0 ? (const void *)(workspace[0] != 0 ? workspace : memory) : (const void *)constants;
}
