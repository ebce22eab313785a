// SPDX-License-Identifier: MIT
#include "penumbra/geometry/volume_choice.h"

#include <bit>
#include <queue>
#include <tuple>

namespace penumbra::detail {
namespace {

using Bits = std::vector<std::uint64_t>;

std::size_t count_new(const Bits& bits, const Bits& covered) {
  std::size_t count = 0;
  for (std::size_t i = 0; i < bits.size(); ++i)
    count += static_cast<std::size_t>(std::popcount(bits[i] & ~(covered.empty() ? 0 : covered[i])));
  return count;
}

void cover(const Bits& bits, Bits& covered) {
  covered.resize(bits.size(), 0);
  for (std::size_t i = 0; i < bits.size(); ++i) covered[i] |= bits[i];
}

/// What a set was worth when last looked at; never less than what it is worth now.
struct Offer {
  double share, worth;
  std::uint32_t set;
  bool operator<(const Offer& other) const {
    return std::tie(worth, other.set) < std::tie(other.worth, set);
  }
};

}  // namespace

std::vector<std::uint32_t> most_useful(std::span<const PointSet> sets,
                                       std::span<const Group> groups, std::size_t most,
                                       double least) {
  std::vector<Bits> covered(groups.size());
  const auto offer_of = [&](std::uint32_t i) {
    const Group& group = groups[sets[i].group];
    const double share = static_cast<double>(count_new(sets[i].bits, covered[sets[i].group])) /
                         static_cast<double>(group.points);
    return Offer{share, share * group.weight, i};
  };
  std::priority_queue<Offer> offers;
  for (std::uint32_t i = 0; i < sets.size(); ++i) offers.push(offer_of(i));
  std::vector<std::uint32_t> chosen;
  std::size_t counted = 0;
  while (!offers.empty()) {
    const Offer old = offers.top();
    offers.pop();
    const std::uint32_t group = sets[old.set].group;
    const Offer now = offer_of(old.set);
    if (now.share < least) continue;
    if (now < old) {
      offers.push(now);
      continue;
    }
    const bool is_first = covered[group].empty();
    if (!is_first && counted >= most) continue;
    if (!is_first) ++counted;
    cover(sets[old.set].bits, covered[group]);
    chosen.push_back(old.set);
  }
  return chosen;
}

}  // namespace penumbra::detail
