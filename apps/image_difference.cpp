// SPDX-License-Identifier: MIT
#include "image_difference.h"

#include <bit>
#include <cmath>

namespace penumbra {
namespace {

/// Equal bits, or NaN twice.
bool is_same(float a, float b) {
  return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b) ||
         (std::isnan(a) && std::isnan(b));
}

/// |a - b|; infinite where only one is NaN.
double distance(float a, float b) {
  if (a == b || is_same(a, b)) return 0;
  const double difference = std::abs(double{a} - double{b});
  return std::isnan(difference) ? std::numeric_limits<double>::infinity() : difference;
}

}  // namespace

ImageDifference difference(const Image& a, const Image& b, std::optional<double> tolerance,
                           const std::vector<std::string>& channels) {
  std::vector<const Channel*> of_a, of_b;
  for (const std::string& name : channels) {
    of_a.push_back(find_channel(a, name));
    of_b.push_back(find_channel(b, name));
  }
  ImageDifference result;
  double squares = 0;
  const std::size_t count = std::size_t{a.width} * a.height;
  for (std::size_t i = 0; i < count; ++i) {
    bool differs = false;
    for (std::size_t c = 0; c < channels.size(); ++c) {
      const float x = of_a[c]->values[i], y = of_b[c]->values[i];
      const double gap = distance(x, y);
      squares += gap * gap;
      result.largest = std::max(result.largest, gap);
      differs |= tolerance ? gap > *tolerance : !is_same(x, y);
    }
    result.pixels += differs;
  }
  const double mean = squares / (static_cast<double>(channels.size()) * static_cast<double>(count));
  result.rmse = std::sqrt(mean);
  if (mean > 0) result.psnr = -10 * std::log10(mean);
  return result;
}

}  // namespace penumbra
