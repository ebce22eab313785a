// SPDX-License-Identifier: MIT
#include "tests/visibility/api_answers.h"

#include <bit>
#include <cstdio>
#include <cstring>
#include <vector>

namespace penumbra::fuzz {
namespace {

using Answers = std::vector<penumbra_visibility_row>;

/// One question, to be asked again and again.
class Question {
 public:
  Question(penumbra_occluders occluders, const Arrays& arrays, Random& random)
      : occluders_(occluders), light_(random_light(arrays, random)) {
    const std::size_t count = 1 + random.below(100);
    for (std::size_t i = 0; i < count; ++i) {
      positions_.push_back(nasty::random_point(random) * random.power(-1, 0.5f));
      normals_.push_back(Vec3f(random.direction()));
    }
    points_.struct_size = sizeof points_;
    points_.positions = {positions_.data(), count, 0};
    if (random.one_in(2)) points_.normals = {normals_.data(), count, 0};
    points_.has_offset = 1;  // of 0: as blockers are asked for
    points_.first_key = random.below(1000);
    penumbra_default_ask_options(&options_, sizeof options_);
    options_.shadow_samples = 1 + random.below(70);
    options_.threads = random.below(3);
  }

  bool floats() const { return points_.normals.count == 0; }

  /// Nothing where the light is none.
  std::optional<Answers> ask(std::uint32_t method) {
    options_.method = method;
    Answers answers(positions_.size());
    const penumbra_error code = penumbra_visibility(occluders_, &points_, &light_, answers.data(),
                                                    answers.size(), &options_, nullptr);
    if (code == PENUMBRA_OK) return answers;
    return {};
  }

  bool has_samples_of(const Answers& answers) {
    const std::uint32_t d = options_.shadow_samples, words = (d + 31) / 32;
    std::vector<std::uint32_t> samples(answers.size() * words);
    if (penumbra_visible_samples(occluders_, &points_, &light_, samples.data(), samples.size(),
                                 &options_, nullptr) != PENUMBRA_OK)
      return false;
    for (std::size_t i = 0; i < answers.size(); ++i) {
      int seen = 0;
      for (std::uint32_t w = 0; w < words; ++w) seen += std::popcount(samples[i * words + w]);
      if (static_cast<float>(seen) / static_cast<float>(d) != answers[i].fraction) return false;
    }
    return true;
  }

  bool fits(std::uint32_t shadow_class, float fraction) const {
    return !(shadow_class == PENUMBRA_CLASS_UMBRA && fraction != 0) &&
           !(shadow_class == PENUMBRA_CLASS_LIT && floats() && fraction != 1);
  }

  /// Says what differs at a point, and so that it does.
  bool complain(std::size_t i, const char* who, std::uint32_t shadow_class, float fraction) const {
    const Vec3f p = positions_[i];
    std::fprintf(stderr, "%s: class %u, fraction %.9g, of (%.9g, %.9g, %.9g), light kind %u\n", who,
                 shadow_class, double(fraction), double(p.x), double(p.y), double(p.z),
                 light_.kind);
    return false;
  }

  /// What is proven of points is so of their samples.
  bool proves_nothing_else_than(const Answers& answers) {
    std::vector<std::uint8_t> classes(answers.size());
    if (penumbra_classify(occluders_, &points_, &light_, classes.data(), classes.size(), &options_,
                          nullptr) != PENUMBRA_OK)
      return false;
    for (std::size_t i = 0; i < classes.size(); ++i) {
      std::uint32_t shadow_class = 0;
      std::size_t count = 0;
      const float* const normal = floats() ? nullptr : &normals_[i].x;
      if (penumbra_blockers(occluders_, &positions_[i].x, normal, &light_, &shadow_class, nullptr,
                            0, &count) != PENUMBRA_OK)
        return false;
      const float fraction = answers[i].fraction;
      if (!fits(classes[i], fraction)) return complain(i, "classify", classes[i], fraction);
      if (!fits(shadow_class, fraction)) return complain(i, "blockers", shadow_class, fraction);
      if (count == 0 && floats() && fraction != 1)
        return complain(i, "no blockers", shadow_class, fraction);
    }
    return true;
  }

 private:
  penumbra_occluders occluders_;
  penumbra_light light_;
  std::vector<Vec3f> positions_, normals_;
  penumbra_points points_{};
  penumbra_ask_options options_{};
};

bool same(const Answers& a, const Answers& b) {
  for (std::size_t i = 0; i < a.size(); ++i)
    if (std::memcmp(&a[i].fraction, &b[i].fraction, sizeof(float)) != 0 ||
        std::memcmp(&a[i].cosine_weighted, &b[i].cosine_weighted, sizeof(float)) != 0)
      return false;
  return true;
}

std::nullopt_t differ(const char* what) {
  std::fprintf(stderr, "%s; last error: %s\n", what, penumbra_last_error_message());
  return std::nullopt;
}

bool build_anew(penumbra_occluders occluders) {
  const penumbra_commit_options options{sizeof options, 0};
  penumbra_commit_report report{};
  report.struct_size = sizeof report;
  return penumbra_commit(occluders, &options, &report) == PENUMBRA_OK && report.is_refitted == 0;
}

}  // namespace

std::optional<std::uint64_t> compare_answers(penumbra_occluders occluders, const Arrays& arrays,
                                             Random& random) {
  Question question(occluders, arrays, random);
  const auto truth = question.ask(PENUMBRA_METHOD_STOCHASTIC);
  const auto fast = question.ask(PENUMBRA_METHOD_SHAFT);
  if (truth.has_value() != fast.has_value()) return differ("one method takes the light");
  if (!truth) return 0;
  if (!same(*truth, *fast)) return differ("shaft and stochastic differ");
  if (!question.has_samples_of(*truth)) return differ("samples and fractions differ");
  if (!question.proves_nothing_else_than(*truth)) return differ("a proof is wrong");
  if (!build_anew(occluders)) return differ("what was committed cannot be built anew");
  const auto again = question.ask(PENUMBRA_METHOD_SHAFT);
  if (!again || !same(*truth, *again)) return differ("differs when built anew");
  return truth->size();
}

}  // namespace penumbra::fuzz
