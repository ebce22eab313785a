/* SPDX-License-Identifier: MIT */
/* c_api: the shadow of a ball that hovers over a floor, drawn with letters; then the ball moves,
 * and the light. Everything of penumbra that C programs need: arrays that stay yours, one commit,
 * questions about many points at once, errors. */
#include <penumbra/penumbra_c.h>
#include <stdio.h>

enum { columns = 64, rows = 24, count = columns * rows };

/* Called with every error of the occluders that it is set for. */
static void say(void* user, penumbra_error code, const char* message) {
  fprintf((FILE*)user, "penumbra's error %d: %s\n", (int)code, message);
}

/* A letter a point: the darker the less of the light it sees. */
static int draw(penumbra_occluders scene, const penumbra_points* points,
                const penumbra_light* light) {
  static float seen[count];
  static uint8_t classes[count];
  penumbra_counters counters = {.struct_size = sizeof counters};
  penumbra_ask_options options;
  int row, column;

  penumbra_default_ask_options(&options, sizeof options);
  options.shadow_samples = 64;
  if (penumbra_visible_fraction(scene, points, light, seen, count, &options, &counters) ||
      penumbra_classify(scene, points, light, classes, count, NULL, NULL))
    return 0; /* `say` has said why. */
  for (row = 0; row < rows; ++row) {
    for (column = 0; column < columns; ++column) {
      const int i = row * columns + column;
      if (classes[i] == PENUMBRA_CLASS_UMBRA) /* proven: nothing of the light is seen */
        putchar('@');
      else
        putchar("%*+=-:. "[(int)(7.99f * seen[i])]);
    }
    putchar('\n');
  }
  printf("%d points: %d lit and %d in umbra for sure, %d sampled\n\n", count, (int)counters.lit,
         (int)counters.umbra, (int)counters.penumbra);
  return 1;
}

int main(void) {
  static float floor_points[count][3];
  static const float up[3] = {0, 0, 1};
  float center[3] = {-0.8f, 0, 1.2f};
  const float radius = 0.7f;
  const penumbra_rows center_rows = {center, 1, 0}, radius_rows = {&radius, 1, 0};
  penumbra_points points = {.struct_size = sizeof points};
  penumbra_light light = {.struct_size = sizeof light};
  penumbra_occluders scene;
  penumbra_geometry ball;
  int i, is_drawn;

  if (penumbra_c_api_version() != PENUMBRA_C_API_VERSION || penumbra_create(&scene)) {
    fprintf(stderr, "no such penumbra: %s\n", penumbra_last_error_message());
    return 1;
  }
  penumbra_set_error_function(scene, say, stderr);

  for (i = 0; i < count; ++i) {
    floor_points[i][0] = (float)(i % columns) * 4.0f / (columns - 1) - 2;
    floor_points[i][1] = 1.5f - (float)(i / columns) * 3.0f / (rows - 1);
  }
  points.positions.data = floor_points;
  points.positions.count = count;
  points.normals.data = up; /* one for all */
  points.normals.count = count;
  points.normals.stride = PENUMBRA_STRIDE_REPEAT;

  light.kind = PENUMBRA_LIGHT_BALL;
  light.center[0] = -1.5f;
  light.center[2] = 6;
  light.radius = 1;

  is_drawn = !penumbra_add_spheres(scene, center_rows, radius_rows, &ball) &&
             !penumbra_commit(scene, NULL, NULL) && draw(scene, &points, &light);

  /* The ball lies in this program's own array: the next commit reads where it is now. */
  center[0] = 0.6f;
  light.kind = PENUMBRA_LIGHT_SUN;
  light.u[0] = -0.3f; /* towards it */
  light.u[2] = 1;
  light.diameter_deg = 20;
  is_drawn = is_drawn && !penumbra_commit(scene, NULL, NULL) && draw(scene, &points, &light);

  /* What cannot be meant is an error, and changes nothing. */
  light.diameter_deg = -1;
  if (penumbra_classify(scene, &points, &light, NULL, 0, NULL, NULL) == PENUMBRA_OK) return 1;

  penumbra_release(scene);
  return is_drawn ? 0 : 1;
}
