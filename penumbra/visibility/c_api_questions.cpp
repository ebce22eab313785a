// SPDX-License-Identifier: MIT
// The C API: questions.
#include <algorithm>
#include <optional>
#include <utility>
#include <vector>

#include "penumbra/visibility/c_api_registry.h"
#include "penumbra/visibility/c_api_values.h"

namespace penumbra {
namespace {

std::shared_ptr<ApiObject> committed_object(penumbra_occluders occluders) {
  std::shared_ptr<ApiObject> object = object_of(occluders);
  if (!object->is_committed)
    throw ApiError{PENUMBRA_ERROR_INVALID_OPERATION,
                   "the occluders were never committed; call penumbra_commit first"};
  return object;
}

/// What a question of points is told, as C says it.
struct Question {
  penumbra_occluders occluders;
  const penumbra_points* points;
  const penumbra_light* light;
  const penumbra_ask_options* options;
  penumbra_counters* counters;
};

void write_counters(penumbra_counters* out, const ShadowCounters& c) {
  write_struct(out, {.struct_size = 0,
                     .lit = c.lit,
                     .penumbra = c.penumbra,
                     .umbra = c.umbra,
                     .rays = c.rays,
                     .tests = c.tests,
                     .cache_decided = c.cache_decided,
                     .set_rays = c.set_rays,
                     .set_tests = c.set_tests});
}

/// ask(occluders, points, light, options) returns the counters.
template <class Ask>
penumbra_error answer(const char* function, const Question& question, const Ask& ask) {
  return guarded(function, question.occluders, [&] {
    const std::shared_ptr<ApiObject> object = committed_object(question.occluders);
    const Points points = points_of(question.points);
    const LightShape light = light_of(question.light);
    const AskOptions options = ask_options_of(question.options);
    if (question.counters) read_struct(question.counters, "counters");
    const ShadowCounters counters = ask(std::as_const(object->occluders), points, light, options);
    if (question.counters) write_counters(question.counters, counters);
  });
}

/// Where an answer of blockers goes.
struct BlockersOut {
  std::uint32_t* shadow_class;
  penumbra_primitive* primitives;
  std::size_t capacity;
  std::size_t* count;
};

/// ask(occluders) returns the blockers.
template <class Ask>
penumbra_error answer(const char* function, penumbra_occluders occluders, const BlockersOut& out,
                      const Ask& ask) {
  return guarded(function, occluders, [&] {
    const std::shared_ptr<ApiObject> object = committed_object(occluders);
    const std::span<penumbra_primitive> room = written(out.primitives, out.capacity, "out");
    const Blockers blockers = ask(std::as_const(object->occluders));
    const std::size_t given = std::min(room.size(), blockers.primitives.size());
    std::transform(blockers.primitives.begin(),
                   blockers.primitives.begin() + static_cast<std::ptrdiff_t>(given), room.begin(),
                   [](const PrimitiveId& id) {
                     return penumbra_primitive{id.geometry, id.primitive, id.instance};
                   });
    const auto shadow_class = static_cast<std::uint32_t>(blockers.shadow_class);
    const std::size_t count = blockers.primitives.size();
    if (out.shadow_class)
      std::memcpy(static_cast<void*>(out.shadow_class), &shadow_class, sizeof shadow_class);
    if (out.count) std::memcpy(static_cast<void*>(out.count), &count, sizeof count);
  });
}

static_assert(static_cast<int>(ShadowClass::lit) == PENUMBRA_CLASS_LIT &&
              static_cast<int>(ShadowClass::penumbra) == PENUMBRA_CLASS_PENUMBRA &&
              static_cast<int>(ShadowClass::umbra) == PENUMBRA_CLASS_UMBRA);
static_assert(sizeof(ShadowClass) == sizeof(std::uint8_t));

}  // namespace

extern "C" {

penumbra_error penumbra_default_ask_options(penumbra_ask_options* options, size_t struct_size) {
  return guarded(__func__, {}, [&] {
    check_pointer(options, "options");
    check_struct_size(struct_size, sizeof *options, "options");
    const AskOptions defaults;
    write_struct(options, {.struct_size = 0,
                           .shadow_samples = defaults.shadow_samples,
                           .method = PENUMBRA_METHOD_SHAFT,
                           .light_index = 0,
                           .keys_are_final = 0,
                           .threads = defaults.threads,
                           .progress = nullptr,
                           .progress_user = nullptr});
  });
}

penumbra_error penumbra_classify(penumbra_occluders occluders, const penumbra_points* points,
                                 const penumbra_light* light, uint8_t* out, size_t count,
                                 const penumbra_ask_options* options, penumbra_counters* counters) {
  const auto ask = [&](const Occluders& of, const Points& at, const LightShape& from,
                       const AskOptions& by) {
    // Bytes may be written as what they hold: C reads them as unsigned char.
    const std::span<std::uint8_t> bytes = written(out, count, "out");
    const std::span classes(reinterpret_cast<ShadowClass*>(bytes.data()), bytes.size());
    return of.classify(at, from, classes, by);
  };
  return answer(__func__, {occluders, points, light, options, counters}, ask);
}

penumbra_error penumbra_visible_fraction(penumbra_occluders occluders,
                                         const penumbra_points* points, const penumbra_light* light,
                                         float* out, size_t count,
                                         const penumbra_ask_options* options,
                                         penumbra_counters* counters) {
  const auto ask = [&](const Occluders& of, const Points& at, const LightShape& from,
                       const AskOptions& by) {
    return of.visible_fraction(at, from, written(out, count, "out"), by);
  };
  return answer(__func__, {occluders, points, light, options, counters}, ask);
}

penumbra_error penumbra_visible_samples(penumbra_occluders occluders, const penumbra_points* points,
                                        const penumbra_light* light, uint32_t* out, size_t count,
                                        const penumbra_ask_options* options,
                                        penumbra_counters* counters) {
  const auto ask = [&](const Occluders& of, const Points& at, const LightShape& from,
                       const AskOptions& by) {
    return of.visible_samples(at, from, written(out, count, "out"), by);
  };
  return answer(__func__, {occluders, points, light, options, counters}, ask);
}

penumbra_error penumbra_visibility(penumbra_occluders occluders, const penumbra_points* points,
                                   const penumbra_light* light, penumbra_visibility_row* out,
                                   size_t count, const penumbra_ask_options* options,
                                   penumbra_counters* counters) {
  const auto ask = [&](const Occluders& of, const Points& at, const LightShape& from,
                       const AskOptions& by) {
    const std::span<penumbra_visibility_row> rows = written(out, count, "out");
    if (rows.size() != at.positions.size())
      refuse_argument("out has room for " + std::to_string(rows.size()) + " rows, but there are " +
                      std::to_string(at.positions.size()) + " points; make them as many");
    std::vector<Visibility> seen(rows.size());
    const ShadowCounters cost = of.visibility(at, from, seen, by);
    std::transform(seen.begin(), seen.end(), rows.begin(), [](const Visibility& v) {
      return penumbra_visibility_row{v.cosine_weighted, v.fraction,
                                     static_cast<std::uint32_t>(v.shadow_class), v.rays};
    });
    return cost;
  };
  return answer(__func__, {occluders, points, light, options, counters}, ask);
}

penumbra_error penumbra_blockers(penumbra_occluders occluders, const float* position,
                                 const float* normal, const penumbra_light* light,
                                 uint32_t* shadow_class, penumbra_primitive* out, size_t capacity,
                                 size_t* count) {
  return answer(__func__, occluders, {shadow_class, out, capacity, count}, [&](const auto& of) {
    return of.blockers(vector_of(position, "position"),
                       normal ? vector_of(normal, "normal") : Vec3f{}, light_of(light));
  });
}

penumbra_error penumbra_shaft(penumbra_occluders occluders, const float* lo, const float* hi,
                              const penumbra_light* light, uint32_t* shadow_class,
                              penumbra_primitive* out, size_t capacity, size_t* count) {
  return answer(__func__, occluders, {shadow_class, out, capacity, count}, [&](const auto& of) {
    return of.shaft({vector_of(lo, "lo"), vector_of(hi, "hi")}, light_of(light));
  });
}

penumbra_error penumbra_light_samples(const penumbra_light* light, const float* position,
                                      uint64_t key, uint32_t light_index, uint32_t key_is_final,
                                      float* out, size_t count) {
  return guarded(__func__, {}, [&] {
    const LightShape from = light_of(light);
    const Vec3f at = vector_of(position, "position");
    if (count > UINT32_MAX) refuse_argument("count is above 65536; ask for fewer samples");
    check_pointer(out, "out");
    const auto samples = static_cast<std::uint32_t>(count);
    const auto index = key_is_final != 0 ? std::nullopt : std::optional(light_index);
    for (const Vec3f way : light_samples(from, at, key, samples, index)) {
      write_vector(out, way, "out");
      out += 3;
    }
  });
}

uint64_t penumbra_light_key(uint64_t point_key, uint32_t light_index) {
  return light_key(point_key, light_index);
}

penumbra_error penumbra_bounds(penumbra_occluders occluders, float* lo, float* hi) {
  return guarded(__func__, occluders, [&] {
    const std::shared_ptr<ApiObject> object = committed_object(occluders);
    check_pointer(lo, "lo");
    check_pointer(hi, "hi");
    const Box box = object->occluders.bounds();
    write_vector(lo, box.lo, "lo");
    write_vector(hi, box.hi, "hi");
  });
}

penumbra_error penumbra_memory_bytes(penumbra_occluders occluders, uint64_t* out) {
  return guarded(__func__, occluders, [&] {
    const std::shared_ptr<ApiObject> object = committed_object(occluders);
    check_pointer(out, "out");
    const std::uint64_t bytes = object->occluders.memory_bytes();
    std::memcpy(static_cast<void*>(out), &bytes, sizeof bytes);
  });
}

}  // extern "C"

}  // namespace penumbra
