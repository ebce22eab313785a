/* SPDX-License-Identifier: MIT */
/* square_shadow.cpp in C. */
#include <penumbra/penumbra_c.h>
#include <penumbra/version.h>
#include <stdio.h>

int main(void) {
  static const float corners[4][3] = {{-1, 1, -1}, {1, 1, -1}, {1, 1, 1}, {-1, 1, 1}};
  static const uint32_t triangles[2][3] = {{0, 1, 2}, {0, 2, 3}};
  static const float positions[3][3] = {{0, 0, 0}, {1.1f, 0, 0}, {5, 0, 0}};
  const penumbra_rows corner_rows = {corners, 4, 0}, triangle_rows = {triangles, 2, 0};
  penumbra_points points = {0};
  penumbra_light light = {0};
  penumbra_occluders occluders;
  penumbra_geometry square;
  uint8_t classes[3];
  float seen[3];
  int i;

  points.struct_size = sizeof points;
  points.positions.data = positions;
  points.positions.count = 3;
  light.struct_size = sizeof light;
  light.kind = PENUMBRA_LIGHT_BALL;
  light.center[1] = 9;
  light.radius = 0.5f;
  if (penumbra_create(&occluders) ||
      penumbra_add_triangles(occluders, corner_rows, triangle_rows, &square) ||
      penumbra_commit(occluders, NULL, NULL) ||
      penumbra_classify(occluders, &points, &light, classes, 3, NULL, NULL) ||
      penumbra_visible_fraction(occluders, &points, &light, seen, 3, NULL, NULL)) {
    fprintf(stderr, "penumbra %s: %s\n", PENUMBRA_VERSION, penumbra_last_error_message());
    return 1;
  }
  for (i = 0; i < 3; ++i) printf("%d %g\n", classes[i], (double)seen[i]);

  light.kind = PENUMBRA_LIGHT_POLYGON;
  light.corners.data = corners;
  light.corners.count = 2;
  if (penumbra_classify(occluders, &points, &light, classes, 3, NULL, NULL))
    printf("refused: %s\n", penumbra_last_error_message());
  return penumbra_release(occluders) != PENUMBRA_OK;
}
