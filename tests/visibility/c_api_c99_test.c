/* SPDX-License-Identifier: MIT */
/* The header as C99 reads it, and a program of it: a plate between a floor and a light. */
#include "penumbra/penumbra_c.h"

#include <stdio.h>

static void print_error(void* user, penumbra_error code, const char* message) {
  (void)user;
  fprintf(stderr, "error %d: %s\n", (int)code, message);
}

static int failures = 0;

static void expect(int is_true, const char* what) {
  if (is_true) return;
  fprintf(stderr, "not so: %s\n", what);
  ++failures;
}

/* A plate of 2 x 2, one above the floor. */
static penumbra_error add_plate(penumbra_occluders scene, penumbra_geometry* plate) {
  static const float corners[4][3] = {{-1, 1, -1}, {1, 1, -1}, {1, 1, 1}, {-1, 1, 1}};
  static const uint32_t triangles[2][3] = {{0, 1, 2}, {0, 2, 3}};
  const penumbra_rows positions = {corners, 4, sizeof corners[0]};
  const penumbra_rows faces = {triangles, 2, sizeof triangles[0]};
  return penumbra_add_triangles(scene, positions, faces, plate);
}

/* Points on the floor from below the plate to far from it. */
static penumbra_error ask(penumbra_occluders scene, float fractions[3], uint8_t classes[3]) {
  static const float floor_points[3][3] = {{0, 0, 0}, {1.1f, 0, 0}, {9, 0, 0}};
  static const float up[3] = {0, 1, 0};
  penumbra_points points = {0};
  penumbra_light light = {0};
  penumbra_error error;
  points.struct_size = sizeof points;
  points.positions.data = floor_points;
  points.positions.count = 3;
  points.normals.data = up;
  points.normals.count = 3;
  points.normals.stride = PENUMBRA_STRIDE_REPEAT;
  light.struct_size = sizeof light;
  light.kind = PENUMBRA_LIGHT_BALL;
  light.center[1] = 10;
  light.radius = 1;
  error = penumbra_visible_fraction(scene, &points, &light, fractions, 3, NULL, NULL);
  if (error != PENUMBRA_OK) return error;
  return penumbra_classify(scene, &points, &light, classes, 3, NULL, NULL);
}

int main(void) {
  penumbra_occluders scene = {0};
  penumbra_geometry plate = {0};
  float fractions[3] = {-1, -1, -1};
  uint8_t classes[3] = {9, 9, 9};
  expect(penumbra_c_api_version() == PENUMBRA_C_API_VERSION, "library and header agree");
  expect(penumbra_create(&scene) == PENUMBRA_OK, "create");
  expect(penumbra_set_error_function(scene, print_error, NULL) == PENUMBRA_OK, "error function");
  expect(add_plate(scene, &plate) == PENUMBRA_OK, "add");
  expect(penumbra_commit(scene, NULL, NULL) == PENUMBRA_OK, "commit");
  expect(ask(scene, fractions, classes) == PENUMBRA_OK, "ask");
  expect(fractions[0] == 0, "all is hidden below the plate");
  expect(fractions[1] > 0 && fractions[1] < 1, "a part is hidden at its edge");
  expect(fractions[2] == 1, "nothing is hidden far from it");
  expect(classes[1] == PENUMBRA_CLASS_PENUMBRA, "penumbra at the edge");
  expect(classes[2] == PENUMBRA_CLASS_LIT, "lit far from it");
  expect(penumbra_remove_geometry(scene, plate) == PENUMBRA_OK, "remove");
  expect(penumbra_commit(scene, NULL, NULL) == PENUMBRA_OK, "commit of nothing");
  expect(ask(scene, fractions, classes) == PENUMBRA_OK, "ask again");
  expect(fractions[0] == 1, "nothing is hidden where nothing is");
  expect(penumbra_release(scene) == PENUMBRA_OK, "release");
  expect(penumbra_release(scene) == PENUMBRA_ERROR_INVALID_HANDLE, "releasing twice is an error");
  expect(penumbra_last_error() == PENUMBRA_ERROR_INVALID_HANDLE, "which is remembered");
  return failures != 0;
}
