/* A marble finds its way through a maze that a hand tilts: walls from a table in flash, gravity from an accelerometer. In float.
 *
 * Lengths are decimetres.
 */
#include "board.h"
#include "carom.h"
#include "tilt.h"

enum { RATE = 120, STEPS_OF_SAMPLE = RATE / TILT_RATE };

/* The maze in centimetres, from the middle of one outer wall to the middle of the other. */
#define WIDTH 20
#define DEPTH 16
#define RADIUS 0.12f

/* Where the walls inside begin and end, in centimetres from the lower left corner. */
static const struct {
    int16_t left, lower, right, upper;
} walls[] = {{0, 12, 12, 12}, {12, 8, 12, 12}, {8, 8, 12, 8}, {4, 4, 4, 8}, {4, 4, 16, 4}, {16, 4, 16, 16}};
enum { WALLS = sizeof walls / sizeof walls[0] };

/* Room for 16 bodies: the floor, four walls outside, six inside, the goal, the marble. */
static uint64_t memory[CAROM_F32_WORLD_16X12_SIZE / sizeof(uint64_t)];

static const carom_f32_settings settings = {
    .gravity = {0, 0, -98.1f}, /* dm/s^2, until the first sample */
    .seconds_numerator = 1,
    .seconds_denominator = RATE,
    .sub_steps = 2,
};
static const carom_f32_material glass = {.restitution = 0.3f, .friction = 0.25f};
static const carom_f32_shape marble_shape = {.kind = CAROM_SPHERE, .radius = RADIUS};

static void check(carom_status status)
{
    if (status != CAROM_OK) {
        board_print(carom_status_text(status));
        board_print("\n");
        board_exit(1);
    }
}

/* Numbers in thousandths, by the library: rounded once, and alike on all machines. */
static float milli(int32_t number)
{
    float result = 0;
    check(carom_f32_ratio(number, 1000, &result));
    return result;
}

/* Thousandths of a decimetre from the middle, for centimetres from the corner. */
static int32_t across(int32_t x)
{
    return 100 * x - 50 * WIDTH;
}

static int32_t along(int32_t y)
{
    return 100 * y - 50 * DEPTH;
}

/* Puts something that nothing moves into the world. */
static carom_body_handle build(carom_f32_world *world, const carom_f32_shape *shape, int32_t x, int32_t y, int32_t z)
{
    carom_body_handle handle = CAROM_NO_BODY;
    carom_f32_body body;
    check(carom_f32_body_immovable(&body));
    body.position.x = milli(x);
    body.position.y = milli(y);
    body.position.z = milli(z);
    check(carom_f32_world_insert(world, &body, shape, &glass, &handle));
    return handle;
}

static void build_plane(carom_f32_world *world, int32_t x, int32_t y, float normal_x, float normal_y, float normal_z)
{
    carom_f32_shape shape = {.kind = CAROM_HALF_SPACE};
    shape.normal.x = normal_x;
    shape.normal.y = normal_y;
    shape.normal.z = normal_z;
    build(world, &shape, x, y, 0);
}

static void build_wall(carom_f32_world *world, int32_t left, int32_t lower, int32_t right, int32_t upper)
{
    carom_f32_shape shape = {.kind = CAROM_CUBOID};
    shape.half_extents.x = milli(50 * (right - left) + 50);
    shape.half_extents.y = milli(50 * (upper - lower) + 50);
    shape.half_extents.z = milli(100);
    build(world, &shape, across((left + right) / 2), along((lower + upper) / 2), 100);
}

/* The sensor shows the opposite of gravity, in thousandths of 9.81 m/s^2. */
static void tilt(carom_f32_world *world, const int16_t sample[3])
{
    carom_f32_vec3 gravity;
    check(carom_f32_ratio(sample[0] * -981, 10000, &gravity.x));
    check(carom_f32_ratio(sample[1] * -981, 10000, &gravity.y));
    check(carom_f32_ratio(sample[2] * -981, 10000, &gravity.z));
    check(carom_f32_world_set_gravity(world, &gravity));
}

/* Whether the marble has just come into the goal, the only sensor there is. */
static bool is_in_goal(carom_f32_world *world)
{
    carom_f32_touching touching[8];
    size_t count, number;
    check(carom_f32_world_contacts(world, touching, sizeof touching / sizeof touching[0], &count));
    for (number = 0; number < count && number < sizeof touching / sizeof touching[0]; number++) {
        if (touching[number].sensor != 0 && touching[number].phase == CAROM_BEGAN) {
            return true;
        }
    }
    return false;
}

int main(void)
{
    carom_f32_world *world = NULL;
    carom_f32_body marble;
    carom_body_handle handle = CAROM_NO_BODY;
    const int32_t x = 50 * WIDTH - 50, y = 50 * DEPTH - 50;
    int32_t step, reached = 0;
    uint64_t hash;
    size_t wall;

    check(carom_f32_world_16x12_init(memory, sizeof memory, &settings, &world));
    build_plane(world, 0, 0, 0, 0, 1);
    build_plane(world, -x, 0, 1, 0, 0);
    build_plane(world, x, 0, -1, 0, 0);
    build_plane(world, 0, -y, 0, 1, 0);
    build_plane(world, 0, y, 0, -1, 0);
    for (wall = 0; wall < WALLS; wall++) {
        build_wall(world, walls[wall].left, walls[wall].lower, walls[wall].right, walls[wall].upper);
    }
    handle = build(world, &marble_shape, across(18), along(14), 120);
    check(carom_f32_world_set_sensor(world, handle, true));
    check(carom_f32_body_dynamic(&marble_shape, 1, &marble));
    marble.position.x = milli(across(2));
    marble.position.y = milli(along(14));
    marble.position.z = milli(120);
    check(carom_f32_world_insert(world, &marble, &marble_shape, &glass, &handle));

    for (step = 0; step < TILT_SAMPLES * STEPS_OF_SAMPLE; step++) {
        tilt(world, tilt_samples[step / STEPS_OF_SAMPLE]);
        check(carom_f32_world_step(world, NULL));
        if (reached == 0 && is_in_goal(world)) {
            reached = step + 1;
        }
    }
    if (reached == 0) {
        board_print("the marble does NOT reach the goal\n");
        return 1;
    }
    board_print("the marble reaches the goal after ");
    board_print_integer(reached * 1000 / RATE);
    board_print(" ms\n");
    check(carom_f32_world_hash(world, &hash));
    board_print("state ");
    board_print_hex(hash);
    board_print("\n");
    return 0;
}
