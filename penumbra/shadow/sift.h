// SPDX-License-Identifier: MIT
// Sixteen tests at once, in float: which candidates surely block no sample, and which spheres
// surely hide the whole light. A candidate is dropped if float arithmetic, with room for its
// errors, the samples' and the intersector's, shows one of these:
//   (1) all of the shape lies below the receiver's horizon (samples there are not active);
//   (2) the ball, or capsule, around it lies outside the cone from p around the light (design: the
//   shaft's cross-section at t has radius t R around p + t (c - p));
//   (3) triangles: p and the light lie on one side of the plane, or the light lies outside of the
//   pyramid from p through the triangle.
// Receivers must be certain. Cost: 5 to 50 ns for sixteen.
#pragma once

#include <cstdint>
#include <vector>

#include "penumbra/kernel/traverse.h"
#include "penumbra/shadow/candidates.h"
#include "penumbra/shadow/seen_light.h"

namespace penumbra {

/// What is left of a list for one receiver.
struct Sifted {
  std::vector<std::uint32_t> record;  ///< those that may block an active sample
  std::uint32_t cover = no_record;    ///< a sphere that surely blocks every sample; ends the sift
};
void sift(const CandidateList& list, const SeenLight& light, Sifted& out);

/// For all receivers of a group at once, by (1) and (2): `out` gets the columns that are left.
/// Returns a sphere that blocks every sample of all of them, or `no_record`; then `out` is of no
/// use.
std::uint32_t sift_for_all(const CandidateList& list, const SeenLight& light, CandidateList& out);

/// For each receiver of a group, with lanes of receivers. Bits: receiver `first + i` of the rows.
struct SiftedRows {
  struct Candidate {
    std::uint32_t record;
    std::uint64_t kept;  ///< receivers whose samples it may block
  };
  std::vector<Candidate> candidate;  ///< those that are kept for any
  std::uint64_t covered = 0;         ///< receivers whose every sample a sphere surely blocks
  std::uint64_t kept = 0;            ///< receivers with any candidate
};
void sift_rows(const CandidateList& list, const LightForm& light, const ReceiverGroup& group,
               SiftedRows& out);

}  // namespace penumbra
