// SPDX-License-Identifier: MIT
// A disk as a receiver sees it: the cone over it is elliptic, its directions fill a spherical
// ellipse (I. Guillén, C. Ureña, A. King, M. Fajardo, I. Georgiev, J. López-Moreno, A. Jarabo,
// Area-Preserving Parameterizations for Spherical Ellipses, EGSR 2017).
#pragma once

#include "penumbra/geometry/light_shape.h"
#include "penumbra/geometry/vec.h"

namespace penumbra {

/// Relative to the receiver p, in double. With chi the angle around the axis, the rim is seen at
///   sin_a cos(chi) x + sin_b sin(chi) y + c(chi) z,  c² = cos_a² cos²(chi) + cos_b² sin²(chi),
/// and the solid angle between the axis and an arc d chi of it is sin_a sin_b d chi / (1 + c). The
/// last is between half and all of sin_a sin_b d chi, however eccentric the ellipse.
struct SeenDisk {
  Vec3d center;  ///< of the disk
  Vec3d normal;  ///< unit, away from p
  Vec3d inward;  ///< unit, in the disk's plane, away from the foot of p
  double radius = 0;
  double height = 0;                 ///< of p over the plane; y and z are meaningless where it is 0
  double aside = 0;                  ///< distance from the foot of p to the centre
  double nearest = 0, farthest = 0;  ///< distances of p to the rim's points along `inward`
  Vec3d x, y, z;  ///< x across, y in the plane of `normal` and `inward`, z the ellipse's axis
  double sin_a = 0, cos_a = 1;  ///< half angle along x, the larger
  double sin_b = 0, cos_b = 1;  ///< half angle along y
};

SeenDisk seen_from(const DiskLight& light, Vec3f p);

/// Solid angle in steradians, to 10⁻¹³ of itself however small; 0 where p lies in the plane. Cost:
/// 0.5 microseconds, more where p nearly touches the rim.
double solid_angle(const SeenDisk& seen);

}  // namespace penumbra
