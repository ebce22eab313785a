// SPDX-License-Identifier: MIT
#include "notes.h"

#include <cstddef>

namespace penumbra::reproduce {

std::vector<std::string> paragraphs(std::string_view text) {
  std::vector<std::string> all;
  while (!text.empty()) {
    const std::size_t end = text.find("\n\n");
    std::string paragraph(text.substr(0, end));
    text.remove_prefix(end == text.npos ? text.size() : end + 2);
    for (char& c : paragraph)
      if (c == '\n') c = ' ';
    all.push_back(paragraph.substr(0, paragraph.find_last_not_of(' ') + 1));
  }
  return all;
}

const char* const paper_reference =
    "A. Formella, A. Łukaszewski: Fast Penumbra Calculation in Ray Tracing. Journal of WSCG 6 "
    "(1998), 238-245, hdl.handle.net/11025/15859";

const char* const what_methods_are =
    R"((a) hard: one ray from each point to the centre of each light.

(b) stochastic: d rays to each light. All others but (a) draw the same picture with fewer rays.

(c) offset: occluders grown by what the light requires, the light shrunk to its centre; where the
one ray to the centre misses all grown occluders (the shadow set), the point is lit, and no sample
is traced through the scene itself (the geometry set).

(d) reduced: the same, grown no more than distances between light, occluder and receivers require.

(e) umbra: the same, and points that one shrunk occluder hides wholly (its inner offset) need no
samples either.

shaft, ours: one query of the scene itself for a tile of points and the whole light; no shadow set.
What it finds proves lit, proves umbra, or is the short list that samples are held against.

Packets: the 32 rays of a point are traced together in vector lanes, by us or by Embree. Ray by ray:
one after the other, as in 1998.

Classes: lit (all of the light is seen), umbra (none), penumbra (neither proven: sampled). A
question is one point and one light. balls:4 is the paper's Balls4.)";

const char* const about_tables =
    R"(Which of (c) to (e) was the paper's best for each scene, the figures that we hold do not tell; it is
held against our best.

We hold of the paper: objects, times and shadow rays of (b) and of the best variant, shadow rays of
(a) for Balls4, Rings and Bust, reflected rays, the gains of Table 4's outer lights, the bound on memory,
the ratios of slopes. Cells without a figure in brackets have nothing to compare with.

The paper's row (a) of the bust has 32,136 shadow rays with 16,384 primary and no reflected rays:
more than its one light can account for. Ours has one light too, and a ray for each point that faces it.

Cylinders, Molecule and Bust are not the paper's scenes but like them: their bracketed figures show the
size of things, not a target.)";

const char* const where_we_differ =
    R"(Balls and rings are made by the recipes of Haines' Standard Procedural Databases (sizes 4, 3 and 1,
coordinates rounded to the 6 digits of its files). The generator has changed since 1998: 90 of the
7,381 balls sit elsewhere, which changes no count that we know.

Cylinders, molecule and bust were not published. Ours have the same kind and number of objects (the
bust to within 0.1 %), but other shapes, cameras and lights. The paper's 105,153 shadow rays of the
molecule at d = 32 come from at least 3,286 points and lights, far fewer than its other scenes have: as of one
light and a molecule in front of nothing. Ours has two lights and a floor.

Objects: a quad counts as two triangles, lights don't count. This gives the paper's 7,383, 822 and 62;
so would one more object that the paper does not name.

Reflected rays: through pixels' corners, at most 5 rays deep with the camera ray as the first,
geometry gives the paper's 10,976 for balls with hits in double precision; ours are in single, and
four rays on outlines fall to the other side. For rings the same rule gives some 3,132 where the paper has
2,962; four rays deep it gives 2,988. Rings reflect a fifth of the light, so that the paper's tracer
may have cut off weak rays.

Shadow rays of (a) and (b) are counted after the queue of two occluders. What it decides depends on the
order of the pixels; ours starts empty in every block of 16 × 16.

Light radii of Tables 1 to 3 are ours: that of the smallest balls, two thirds of a ring's, 1 % of
the extent; the paper's gains depend on its own. Those of Table 4 are the radii of the scene's balls.

Our hierarchy is eight wide, and boxes are tested eight at a time, for single rays too; the paper's
tracer was scalar. What a proof costs beside a ray is not what it was.

Our offsets are exact where the paper's are supersets, the inner offset is asked at any distance,
and meshes prove umbra, which the paper left open: that is why more rays are saved than in 1998.

Shadow work is timed by itself, too, on the recorded questions of the picture; a picture's time may then
come out a little below that of its shadows.)";

}  // namespace penumbra::reproduce
