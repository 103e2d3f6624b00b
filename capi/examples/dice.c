/* Two dice of 16 mm are thrown onto a table, tumble, and are read once they lie: Q16.16, on any Cortex-M or PC.
 *
 * Lengths are decimetres: a format of 32 bits holds a scene best whose numbers are neither tiny nor huge.
 */
#include "board.h"
#include "carom.h"

enum { DICE = 2, RATE = 120, STEPS = 5 * RATE, SEED = 20261122 };

/* The world lives here: room for 4 bodies and 12 points of contact. */
static uint64_t memory[CAROM_Q16_WORLD_4X12_SIZE / sizeof(uint64_t)];

static const carom_q16_settings settings = {
    .gravity = {0, 0, CAROM_Q16(-98.1)}, /* dm/s^2 */
    .seconds_numerator = 1,
    .seconds_denominator = RATE,
    .sub_steps = 4,
};
static const carom_q16_material surface = {.restitution = CAROM_Q16(0.4), .friction = CAROM_Q16(0.3)};
static const carom_q16_shape table = {.kind = CAROM_HALF_SPACE, .normal = {0, 0, CAROM_Q30(1)}};
static const carom_q16_shape die = {
    .kind = CAROM_CUBOID,
    .half_extents = {CAROM_Q16(0.08), CAROM_Q16(0.08), CAROM_Q16(0.08)},
};

/* Every call answers with a status. Here one that is not CAROM_OK ends the program with its text. */
static void check(carom_status status)
{
    if (status != CAROM_OK) {
        board_print(carom_status_text(status));
        board_print("\n");
        board_exit(1);
    }
}

/* Numbers that look random and are the same everywhere (xorshift, Marsaglia, 2003): an integer in low to high - 1. */
static int32_t random_integer(int32_t low, int32_t high)
{
    static uint32_t state = SEED;
    static int warm;
    do { /* the first numbers of seeds that are close to each other are, too */
        state ^= state << 13;
        state ^= state >> 17;
        state ^= state << 5;
    } while (warm++ < 8);
    return low + (int32_t)((state >> 16) * (uint32_t)(high - low) >> 16);
}

static int32_t ratio(int32_t numerator, int32_t denominator)
{
    int32_t number = 0;
    check(carom_q16_ratio(numerator, denominator, &number));
    return number;
}

/* Every orientation as likely as every other: the directions of points in a ball of four dimensions. */
static carom_q16_quat random_orientation(void)
{
    carom_q16_quat orientation;
    int32_t w, x, y, z, square;
    do {
        w = random_integer(-512, 512);
        x = random_integer(-512, 512);
        y = random_integer(-512, 512);
        z = random_integer(-512, 512);
        square = w * w + x * x + y * y + z * z;
    } while (square < 1 || square > 512 * 512);
    orientation.w = w * (CAROM_Q30(1) / 1024);
    orientation.x = x * (CAROM_Q30(1) / 1024);
    orientation.y = y * (CAROM_Q30(1) / 1024);
    orientation.z = z * (CAROM_Q30(1) / 1024);
    check(carom_q16_quat_normalize(&orientation));
    return orientation;
}

/* A die as it leaves the hand. */
static carom_body_handle throw_die(carom_q16_world *world, int32_t number)
{
    carom_body_handle handle = CAROM_NO_BODY;
    carom_q16_quat orientation;
    carom_q16_body body;
    check(carom_q16_body_dynamic(&die, CAROM_Q16(1), &body));
    body.position.x = ratio(random_integer(-3200, -2800), 1000);
    body.position.y = ratio(500 * number - 250, 1000);
    body.position.z = CAROM_Q16(1.2);
    body.linear_velocity.x = ratio(random_integer(9000, 15000), 1000);
    body.linear_velocity.y = ratio(random_integer(-2000, 2000), 1000);
    body.angular_velocity.x = ratio(random_integer(-20 * 1024, 20 * 1024), 1024);
    body.angular_velocity.y = ratio(random_integer(-20 * 1024, 20 * 1024), 1024);
    body.angular_velocity.z = ratio(random_integer(-20 * 1024, 20 * 1024), 1024);
    orientation = random_orientation();
    check(carom_q16_body_set_orientation(&body, &orientation));
    check(carom_q16_world_insert(world, &body, &die, &surface, &handle));
    return handle;
}

/* The face that looks up most. Opposite faces add up to seven. */
static int32_t face_on_top(carom_q16_world *world, carom_body_handle handle)
{
    static const carom_q16_vec3 axes[3] = {{CAROM_Q16(1), 0, 0}, {0, CAROM_Q16(1), 0}, {0, 0, CAROM_Q16(1)}};
    carom_q16_body body;
    carom_q16_vec3 axis;
    int32_t face = 0, highest = 0, number;
    check(carom_q16_world_get_body(world, handle, &body));
    for (number = 0; number < 3; number++) {
        check(carom_q16_body_arm(&body, &axes[number], &axis));
        if (axis.z > highest) {
            highest = axis.z;
            face = number + 1;
        } else if (-axis.z > highest) {
            highest = -axis.z;
            face = 6 - number;
        }
    }
    return face;
}

int main(void)
{
    carom_q16_world *world = NULL;
    carom_q16_body ground;
    carom_body_handle handle, dice[DICE];
    carom_world_report report;
    int32_t number, step = 0, impacts = 0;
    size_t met;
    uint64_t hash;

    check(carom_q16_world_4x12_init(memory, sizeof memory, &settings, &world));
    check(carom_q16_body_immovable(&ground));
    check(carom_q16_world_insert(world, &ground, &table, &surface, &handle));
    for (number = 0; number < DICE; number++) {
        dice[number] = throw_die(world, number);
    }
    do {
        check(carom_q16_world_step(world, &report));
        check(carom_q16_world_impacts(world, NULL, 0, &met));
        impacts += (int32_t)met;
        step++;
    } while (step < STEPS && report.asleep < DICE);

    board_print("at rest after ");
    board_print_integer(step * 1000 / RATE);
    board_print(" ms and ");
    board_print_integer(impacts);
    board_print(" impacts\n");
    for (number = 0; number < DICE; number++) {
        board_print("a ");
        board_print_integer(face_on_top(world, dice[number]));
        board_print("\n");
    }
    check(carom_q16_world_hash(world, &hash));
    board_print("state ");
    board_print_hex(hash);
    board_print("\n");
    return 0;
}
