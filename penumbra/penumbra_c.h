/* SPDX-License-Identifier: MIT */
/* The library for C99 and for what calls C: what penumbra/visibility/occluders.h has for C++, with
 * the same answers, bit for bit. What a function means is said there; here, how it is called.
 *
 *   penumbra_occluders scene;
 *   penumbra_geometry mesh;
 *   penumbra_create(&scene);
 *   penumbra_add_triangles(scene, positions, triangles, &mesh);
 *   penumbra_commit(scene, NULL, NULL);
 *   penumbra_visible_fraction(scene, &points, &light, fractions, point_count, NULL, NULL);
 *   penumbra_release(scene);
 *
 * ERRORS. Every function returns PENUMBRA_OK or says what is wrong, and then has changed nothing
 * but, where a question was cut short (cancelled, out of memory), a part of what it was to fill.
 * The thread's last error can be asked for, and a function be set that is called with each, as
 * Embree does it. No C++ exception leaves a function, nor does running out of memory end the
 * program.
 *
 * HANDLES are values. A handle that was released or removed, that is of another kind or of another
 * `penumbra_occluders`, or that was never given, is PENUMBRA_ERROR_INVALID_HANDLE.
 *
 * POINTERS. What a handle can be checked for, memory cannot: arrays are taken to be as long as is
 * said beside them. All else is checked: NULL with a count above 0, vertex numbers, numbers of
 * occluders and lights that are not finite, alignment of what is written to, sizes that disagree.
 * NULL with a count of 0 is an empty array.
 *
 * THREADS. Any function may be called from any thread at any time. Questions are answered of what
 * was committed last when they began. `penumbra_release` does not wait: what runs goes on with what
 * it has, and ends as it would have.
 *
 * ABI. Within one PENUMBRA_C_API_VERSION functions keep their signatures, and are only added;
 * constants keep their values; structs that begin with `struct_size` only grow, at their end, and
 * what is new in them means by 0 what was before; all other structs stay as they are. So a program
 * runs with any later library of its version. `struct_size` is sizeof the struct, set by the
 * caller; a size that the library does not know is an error.
 */
#pragma once

#include <stddef.h>
#include <stdint.h>

/* Of this header. */
#define PENUMBRA_C_API_VERSION 1

#if defined(__GNUC__)
/* Before what the library shows. */
#define PENUMBRA_C_API __attribute__((visibility("default")))
#else
#define PENUMBRA_C_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* PENUMBRA_C_API_VERSION of the library that runs. */
PENUMBRA_C_API uint32_t penumbra_c_api_version(void);

/* --- Errors --- */

/* PENUMBRA_OK, or what went wrong. */
typedef int32_t penumbra_error;
enum {
  PENUMBRA_OK = 0,
  PENUMBRA_ERROR_INVALID_ARGUMENT = 1,
  PENUMBRA_ERROR_INVALID_HANDLE = 2,
  /* A question or fact before the first commit; any call from within a progress function. */
  PENUMBRA_ERROR_INVALID_OPERATION = 3,
  PENUMBRA_ERROR_OUT_OF_MEMORY = 4,
  PENUMBRA_ERROR_CANCELLED = 5, /* The progress function said so. */
  PENUMBRA_ERROR_INTERNAL = 6   /* A fault of penumbra's, or a C++ exception out of a callback. */
};

/* Code of the last call of this thread that failed since this was last asked, or PENUMBRA_OK. */
PENUMBRA_C_API penumbra_error penumbra_last_error(void);

/* What was wrong with it: "function: what is wrong; what to do". "" before the first. Valid until
 * the thread's next call that fails. */
PENUMBRA_C_API const char* penumbra_last_error_message(void);

/* --- Handles --- */

/* What blocks light. */
typedef struct penumbra_occluders {
  uint64_t id;
} penumbra_occluders;

/* The lower 32 bits are the number by which `penumbra_primitive` names it: from 0, in the order of
 * adding, of each kind by itself. */
typedef struct penumbra_geometry {
  uint64_t id;
} penumbra_geometry;
/* What instances place. */
typedef struct penumbra_group {
  uint64_t id;
} penumbra_group;
/* A placement of a group. */
typedef struct penumbra_instance {
  uint64_t id;
} penumbra_instance;

/* Occluders without anything in them; what was made is released once. */
PENUMBRA_C_API penumbra_error penumbra_create(penumbra_occluders* out);
PENUMBRA_C_API penumbra_error penumbra_release(penumbra_occluders occluders);

/* Called with every error of calls that name these occluders, by the thread that called, after
 * the call has ended otherwise; `message` lives as long as it runs. With the handle {0}: with
 * those that no such function is set for. NULL for none. It may call penumbra; it is not
 * called again for what fails meanwhile. */
typedef void (*penumbra_error_function)(void* user, penumbra_error code, const char* message);
PENUMBRA_C_API penumbra_error penumbra_set_error_function(penumbra_occluders occluders,
                                                          penumbra_error_function function,
                                                          void* user);

/* --- Arrays --- */

/* `count` rows in the caller's memory, each `stride` bytes after the one before: of any sign, 0 for
 * rows without gaps. They need not be aligned. A row is 3 floats, 3 uint32_t (triangles), 1 float
 * (radii) or 1 uint64_t (keys), as the parameter says. */
typedef struct penumbra_rows {
  const void* data;
  size_t count;
  ptrdiff_t stride;
} penumbra_rows;

/* As a stride: all rows are the first. */
#define PENUMBRA_STRIDE_REPEAT PTRDIFF_MIN

/* --- What there is. Arrays are not copied: every commit reads them, of these occluders and of
 * those that they are a group of. They must be there, and not change, while one runs. --- */

PENUMBRA_C_API penumbra_error penumbra_add_triangles(penumbra_occluders occluders,
                                                     penumbra_rows positions,
                                                     penumbra_rows triangles,
                                                     penumbra_geometry* out);
PENUMBRA_C_API penumbra_error penumbra_add_spheres(penumbra_occluders occluders,
                                                   penumbra_rows centers, penumbra_rows radii,
                                                   penumbra_geometry* out);
/* `caps`: 1 for solids, 0 for sides alone. */
PENUMBRA_C_API penumbra_error penumbra_add_cones(penumbra_occluders occluders, penumbra_rows bases,
                                                 penumbra_rows apexes, penumbra_rows base_radii,
                                                 penumbra_rows apex_radii, uint32_t caps,
                                                 penumbra_geometry* out);
/* Rings where there are inner radii; {0} for none. */
PENUMBRA_C_API penumbra_error penumbra_add_disks(penumbra_occluders occluders,
                                                 penumbra_rows centers, penumbra_rows normals,
                                                 penumbra_rows radii, penumbra_rows inner_radii,
                                                 penumbra_geometry* out);

/* `shapes` may be released afterwards; its arrays must stay. */
PENUMBRA_C_API penumbra_error penumbra_add_group(penumbra_occluders occluders,
                                                 penumbra_occluders shapes, penumbra_group* out);
/* `placement`: 12 numbers, 3 rows of 4 one after the other. A point p of the group stands at
 * placement times (p, 1). */
PENUMBRA_C_API penumbra_error penumbra_add_instance(penumbra_occluders occluders,
                                                    penumbra_group group, const double* placement,
                                                    penumbra_instance* out);

/* What the arrays hold may change between commits; these give other arrays, of as many rows, for
 * positions of vertices, centres, bases; and other placements. */
PENUMBRA_C_API penumbra_error penumbra_move_geometry(penumbra_occluders occluders,
                                                     penumbra_geometry geometry,
                                                     penumbra_rows positions);
/* `geometry` is one of the occluders that the group was made of. */
PENUMBRA_C_API penumbra_error penumbra_move_group(penumbra_occluders occluders,
                                                  penumbra_group group, penumbra_geometry geometry,
                                                  penumbra_rows positions);
PENUMBRA_C_API penumbra_error penumbra_move_instance(penumbra_occluders occluders,
                                                     penumbra_instance instance,
                                                     const double* placement);

/* Their handles are invalid from then on. A group must not be placed any more. */
PENUMBRA_C_API penumbra_error penumbra_remove_geometry(penumbra_occluders occluders,
                                                       penumbra_geometry geometry);
PENUMBRA_C_API penumbra_error penumbra_remove_instance(penumbra_occluders occluders,
                                                       penumbra_instance instance);
PENUMBRA_C_API penumbra_error penumbra_remove_group(penumbra_occluders occluders,
                                                    penumbra_group group);

/* Filled with defaults by penumbra_default_commit_options. */
typedef struct penumbra_commit_options {
  size_t struct_size;
  uint32_t may_refit; /* 0 or 1; 1 by default */
} penumbra_commit_options;

/* What was committed; 0 or 1 for `is_refitted`. */
typedef struct penumbra_commit_report {
  size_t struct_size;
  uint64_t primitives, degenerate_triangles;
  uint32_t is_refitted;
} penumbra_commit_report;

/* Fills the first `struct_size` bytes with the defaults, and `struct_size` with itself. */
PENUMBRA_C_API penumbra_error penumbra_default_commit_options(penumbra_commit_options* options,
                                                              size_t struct_size);
/* `options` and `report` may be NULL. */
PENUMBRA_C_API penumbra_error penumbra_commit(penumbra_occluders occluders,
                                              const penumbra_commit_options* options,
                                              penumbra_commit_report* report);

/* --- Questions --- */

/* Surface points that ask. */
typedef struct penumbra_points {
  size_t struct_size;
  penumbra_rows positions; /* 3 floats each */
  penumbra_rows normals;   /* 3 floats; as many, or none for points that float */
  penumbra_rows keys;      /* uint64_t; as many, or none: point i has `first_key` + i */
  uint64_t first_key;
  uint32_t has_offset; /* 0: points are moved off their surface by what float has lost of it; */
  float offset;        /* 1: by this */
} penumbra_points;

enum {
  PENUMBRA_LIGHT_POINT = 1,         /* center */
  PENUMBRA_LIGHT_BALL = 2,          /* center, radius */
  PENUMBRA_LIGHT_PARALLELOGRAM = 3, /* center, u, v: half edges */
  PENUMBRA_LIGHT_DISK = 4,          /* center, u: its normal, radius */
  PENUMBRA_LIGHT_LINE = 5,          /* center, u: to one of its ends */
  PENUMBRA_LIGHT_SUN = 6,           /* u: towards it, diameter_deg: 0.533 is the Earth's */
  PENUMBRA_LIGHT_POLYGON = 7,       /* corners, in order around it; convex */
  PENUMBRA_LIGHT_HULL = 8           /* corners: their convex hull, computed at every call */
};

/* What its kind does not name is not read. */
typedef struct penumbra_light {
  size_t struct_size;
  uint32_t kind;
  float center[3], u[3], v[3];
  float radius, diameter_deg;
  penumbra_rows corners; /* 3 floats each */
} penumbra_light;

enum {
  PENUMBRA_METHOD_SHAFT = 0,
  PENUMBRA_METHOD_STOCHASTIC = 1 /* traces every sample: the judge */
};

/* Called with the finished share in [0, 1], from any thread, one call at a time. 0 ends the
 * question with PENUMBRA_ERROR_CANCELLED. */
typedef int (*penumbra_progress_function)(void* user, double share);

/* Filled with defaults by penumbra_default_ask_options. */
typedef struct penumbra_ask_options {
  size_t struct_size;
  uint32_t shadow_samples; /* d, 1 to 65536; 32 by default */
  uint32_t method;
  uint32_t light_index;
  uint32_t keys_are_final; /* 0 or 1: `light_index` is not read, as penumbra_light_key was asked */
  uint32_t threads;        /* 0: all cores */
  penumbra_progress_function progress;
  void* progress_user;
} penumbra_ask_options;

/* As of commit options. Every question takes NULL for the defaults. */
PENUMBRA_C_API penumbra_error penumbra_default_ask_options(penumbra_ask_options* options,
                                                           size_t struct_size);

/* What answers cost; every question takes NULL for `counters`. */
typedef struct penumbra_counters {
  size_t struct_size;
  uint64_t lit, penumbra, umbra, rays, tests, cache_decided, set_rays, set_tests;
} penumbra_counters;

/* Classes of points. */
enum { PENUMBRA_CLASS_LIT = 0, PENUMBRA_CLASS_PENUMBRA = 1, PENUMBRA_CLASS_UMBRA = 2 };

/* All that a point sees of a light. */
typedef struct penumbra_visibility_row {
  float cosine_weighted, fraction;
  uint32_t shadow_class, rays;
} penumbra_visibility_row;

/* `count` is how many `out` has room for, which must be what the answer takes: one a point;
 * ceil(d / 32) words a point for samples. */
PENUMBRA_C_API penumbra_error penumbra_classify(penumbra_occluders occluders,
                                                const penumbra_points* points,
                                                const penumbra_light* light, uint8_t* out,
                                                size_t count, const penumbra_ask_options* options,
                                                penumbra_counters* counters);
PENUMBRA_C_API penumbra_error penumbra_visible_fraction(
    penumbra_occluders occluders, const penumbra_points* points, const penumbra_light* light,
    float* out, size_t count, const penumbra_ask_options* options, penumbra_counters* counters);
PENUMBRA_C_API penumbra_error penumbra_visible_samples(
    penumbra_occluders occluders, const penumbra_points* points, const penumbra_light* light,
    uint32_t* out, size_t count, const penumbra_ask_options* options, penumbra_counters* counters);
PENUMBRA_C_API penumbra_error penumbra_visibility(penumbra_occluders occluders,
                                                  const penumbra_points* points,
                                                  const penumbra_light* light,
                                                  penumbra_visibility_row* out, size_t count,
                                                  const penumbra_ask_options* options,
                                                  penumbra_counters* counters);

/* Numbers as the lower 32 bits of handles; `instance` is 0xffffffff for what none places. */
typedef struct penumbra_primitive {
  uint32_t geometry, primitive, instance;
} penumbra_primitive;

/* What stands between. The first `capacity` primitives go to `out`, how many there are to `count`,
 * the class to `shadow_class`; NULL for what is not wanted. `normal` may be NULL. */
PENUMBRA_C_API penumbra_error penumbra_blockers(penumbra_occluders occluders, const float* position,
                                                const float* normal, const penumbra_light* light,
                                                uint32_t* shadow_class, penumbra_primitive* out,
                                                size_t capacity, size_t* count);
/* The same for every point of the box from `lo` to `hi`. */
PENUMBRA_C_API penumbra_error penumbra_shaft(penumbra_occluders occluders, const float* lo,
                                             const float* hi, const penumbra_light* light,
                                             uint32_t* shadow_class, penumbra_primitive* out,
                                             size_t capacity, size_t* count);

/* Ways to the light's samples, 3 floats each; `count` of them, which is d. `light_index` and
 * `key_is_final` as in penumbra_ask_options. */
PENUMBRA_C_API penumbra_error penumbra_light_samples(const penumbra_light* light,
                                                     const float* position, uint64_t key,
                                                     uint32_t light_index, uint32_t key_is_final,
                                                     float* out, size_t count);

/* What the samples of a light at a point are drawn by. */
PENUMBRA_C_API uint64_t penumbra_light_key(uint64_t point_key, uint32_t light_index);

/* --- Facts of what was committed last --- */

/* 3 floats each; lo > hi where there is nothing. */
PENUMBRA_C_API penumbra_error penumbra_bounds(penumbra_occluders occluders, float* lo, float* hi);
PENUMBRA_C_API penumbra_error penumbra_memory_bytes(penumbra_occluders occluders, uint64_t* out);

#ifdef __cplusplus
}
#endif
