//! Bodies with shapes in memory of the caller's.

use carom::world::Filter;

use super::export;
use super::pointer::{List, Mirror, check, read, write};
use super::room::enter;
use crate::number::{self, Number};
use crate::status::carom_status;
use crate::types::*;

#[cfg(feature = "fixed")]
use fixed::types::{I12F20, I16F16};

macro_rules! worlds {
    ($p:ident, $number:ty, $raw:ty) => {
        pastey::paste! {
            /// A world: made by one of the ..._world_..._init functions in memory of yours, and only to be pointed to.
            #[allow(missing_debug_implementations)]
            pub struct [<$p _world>](());

            export! {
                /// Puts a body with that shape and material into the world, at the place and with the velocity that it has.
                fn [<$p _world_insert>](
                    world: *mut [<$p _world>],
                    body: *const [<$p _body>],
                    shape: *const [<$p _shape>],
                    material: *const [<$p _material>],
                    handle: *mut carom_body_handle,
                ) {
                    check(handle)?;
                    let (world, _) = enter::<$number, _>(world)?;
                    let body = *Mirror::<$number>::body(body)?;
                    let shape = read(shape)?.core().piece()?;
                    let material = read(material)?.core()?;
                    write(handle, world.insert(body, shape, material)?.into())
                }

                /// Takes a body out, and writes it to `body`, which may be null. What it touched wakes up.
                fn [<$p _world_remove>](
                    world: *mut [<$p _world>],
                    handle: carom_body_handle,
                    body: *mut [<$p _body>],
                ) {
                    if !body.is_null() {
                        check(body)?;
                    }
                    let (world, _) = enter::<$number, _>(world)?;
                    let removed = world.remove(handle.into())?;
                    if body.is_null() { Ok(()) } else { Mirror::put(body, removed) }
                }

                /// Takes everything out. Handles given so far mean nothing afterwards.
                fn [<$p _world_clear>](world: *mut [<$p _world>]) {
                    enter::<$number, _>(world)?.0.clear();
                    Ok(())
                }

                /// Writes the body as it is now to `body`.
                fn [<$p _world_get_body>](
                    world: *mut [<$p _world>],
                    handle: carom_body_handle,
                    body: *mut [<$p _body>],
                ) {
                    let (world, _) = enter::<$number, _>(world)?;
                    Mirror::put(body, *world.body(handle.into())?)
                }

                /// Makes the body what `body` is: moved, pushed or changed. It wakes up, with all that it touches.
                fn [<$p _world_set_body>](
                    world: *mut [<$p _world>],
                    handle: carom_body_handle,
                    body: *const [<$p _body>],
                ) {
                    let (world, _) = enter::<$number, _>(world)?;
                    let body = *Mirror::<$number>::body(body)?;
                    body.check()?;
                    *world.body_mut(handle.into())? = body;
                    Ok(())
                }

                /// Gives the body another shape.
                fn [<$p _world_set_shape>](
                    world: *mut [<$p _world>],
                    handle: carom_body_handle,
                    shape: *const [<$p _shape>],
                ) {
                    let (world, _) = enter::<$number, _>(world)?;
                    let shape = read(shape)?.core().piece()?;
                    world.set_shape(handle.into(), shape)
                }

                /// Gives the body another material.
                fn [<$p _world_set_material>](
                    world: *mut [<$p _world>],
                    handle: carom_body_handle,
                    material: *const [<$p _material>],
                ) {
                    let (world, _) = enter::<$number, _>(world)?;
                    let material = read(material)?.core()?;
                    Ok(world.set_material(handle.into(), material)?)
                }

                /// Makes a sensor of the body, or a body of the sensor: a sensor notices what overlaps it, and stops nothing.
                fn [<$p _world_set_sensor>](
                    world: *mut [<$p _world>],
                    handle: carom_body_handle,
                    sensor: bool,
                ) {
                    let (world, _) = enter::<$number, _>(world)?;
                    Ok(world.set_sensor(handle.into(), sensor)?)
                }

                /// Says which bodies it meets: two meet where the groups of each are among those that the other meets. At first a body
                /// is in group 1 and meets all (0xffff).
                fn [<$p _world_set_filter>](
                    world: *mut [<$p _world>],
                    handle: carom_body_handle,
                    groups: u16,
                    meets: u16,
                ) {
                    let (world, _) = enter::<$number, _>(world)?;
                    Ok(world.set_filter(handle.into(), Filter { groups, meets })?)
                }

                /// Whether the body sleeps.
                fn [<$p _world_is_asleep>](
                    world: *mut [<$p _world>],
                    handle: carom_body_handle,
                    asleep: *mut bool,
                ) {
                    let (world, _) = enter::<$number, _>(world)?;
                    write(asleep, world.is_asleep(handle.into())?)
                }

                /// Whether bodies that have been still for half a second fall asleep. They do unless told otherwise.
                fn [<$p _world_set_sleeping>](world: *mut [<$p _world>], on: bool) {
                    enter::<$number, _>(world)?.0.set_sleeping(on);
                    Ok(())
                }

                /// Another gravity from the next step on, m/s^2.
                fn [<$p _world_set_gravity>](world: *mut [<$p _world>], gravity: *const [<$p _vec3>]) {
                    let (_, settings) = enter::<$number, _>(world)?;
                    settings.gravity = number::finite(read(gravity)?.core())?;
                    Ok(())
                }

                /// Other settings from the next step on: length of a step, sub-steps, gravity.
                fn [<$p _world_set_settings>](world: *mut [<$p _world>], settings: *const [<$p _settings>]) {
                    let (_, kept) = enter::<$number, _>(world)?;
                    *kept = read(settings)?.core()?;
                    Ok(())
                }

                /// Moves everything on by one step. `report` may be null.
                fn [<$p _world_step>](world: *mut [<$p _world>], report: *mut carom_world_report) {
                    if !report.is_null() {
                        check(report)?;
                    }
                    let (world, settings) = enter::<$number, _>(world)?;
                    let told = world.step(settings);
                    if report.is_null() { Ok(()) } else { write(report, told.into()) }
                }

                /// Everything that touches after the last step, then what does not any more: up to `capacity` of it to `touching`
                /// (which may be null where that is zero), and to `count` how many there are, more than `capacity` perhaps.
                fn [<$p _world_contacts>](
                    world: *mut [<$p _world>],
                    touching: *mut [<$p _touching>],
                    capacity: usize,
                    count: *mut usize,
                ) {
                    let mut list = List::new(touching, capacity, count)?;
                    let (world, _) = enter::<$number, _>(world)?;
                    world.contacts(&mut |touching| list.push(touching));
                    list.finish()
                }

                /// The contacts whose surfaces met in the last step: who hit whom, how fast and how hard. As for contacts.
                fn [<$p _world_impacts>](
                    world: *mut [<$p _world>],
                    touching: *mut [<$p _touching>],
                    capacity: usize,
                    count: *mut usize,
                ) {
                    let mut list = List::new(touching, capacity, count)?;
                    let (world, _) = enter::<$number, _>(world)?;
                    world.contacts(&mut |touching| {
                        if touching.approach_speed > <$number as carom::Scalar>::ZERO {
                            list.push(touching);
                        }
                    });
                    list.finish()
                }

                /// The first body that a ray meets, of those in a group of `meets` (0xffff: all). Sensors are looked through.
                fn [<$p _world_cast_ray>](
                    world: *mut [<$p _world>],
                    ray: *const [<$p _ray>],
                    meets: u16,
                    hit: *mut [<$p _ray_hit>],
                ) {
                    let (world, _) = enter::<$number, _>(world)?;
                    let ray = read(ray)?.core()?;
                    let sight = world.cast_ray(&ray, Filter { groups: u16::MAX, meets });
                    let told = sight.map_or_else(Default::default, |sight| [<$p _ray_hit>] {
                        body: sight.body.into(),
                        distance: sight.hit.distance.raw(),
                        normal: sight.hit.normal.into(),
                    });
                    write(hit, told)
                }

                /// One number for the state of all bodies: equal on all machines after the same steps.
                fn [<$p _world_hash>](world: *mut [<$p _world>], hash: *mut u64) {
                    let (world, _) = enter::<$number, _>(world)?;
                    write(hash, world.hash())
                }
            }
        }
    };
}

#[cfg(feature = "f32")]
worlds!(carom_f32, f32, f32);
#[cfg(feature = "fixed")]
worlds!(carom_q16, I16F16, i32);
#[cfg(feature = "fixed")]
worlds!(carom_q20, I12F20, i32);
