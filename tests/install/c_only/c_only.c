/* Every function of glare_c.h, in C11, in its right use and in wrong ones; run under the address
 * and leak sanitizers too. c_only FOLDER writes its files into that folder. */
#include <glare/glare_c.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#define REQUIRE(condition)                                                           \
  do {                                                                               \
    if (!(condition)) {                                                              \
      fprintf(stderr, "c_only.c:%d: %s; %s\n", __LINE__, #condition, error.message); \
      exit(1);                                                                       \
    }                                                                                \
  } while (0)
#define OK(call) REQUIRE((call) == GLARE_OK && error.status == GLARE_OK && error.message[0] == '\0')
#define FAILS(expected, call) \
  REQUIRE((call) == (expected) && error.status == (expected) && error.message[0] != '\0')

enum { APERTURE = 64, SIZE = 33, WIDTH = 40, HEIGHT = 30, FLOATS = WIDTH * HEIGHT * 4 };
static glare_error error;

static int32_t stop(double fraction_done, void* user) {
  *(double*)user = fraction_done;
  return 0;
}

static void texts(void) {
  char name[64], cut[2];
  size_t needed = 0;
  REQUIRE(strchr(glare_version(), '.') != NULL);
  REQUIRE(glare_built_in_lamp_count() > 50);
  OK(glare_built_in_lamp_text(0, GLARE_LAMP_NAME, name, sizeof name, &needed, &error));
  REQUIRE(strcmp(name, "A") == 0 && needed == 2);
  OK(glare_built_in_lamp_text(0, GLARE_LAMP_DESCRIPTION, cut, sizeof cut, &needed, &error));
  REQUIRE(strlen(cut) == 1 && needed > 2);
  OK(glare_built_in_lamp_text(0, GLARE_LAMP_ALIAS, NULL, 0, &needed, &error));
  FAILS(GLARE_ERROR_OPTION, glare_built_in_lamp_text(0, 0, NULL, 5, NULL, &error));
  FAILS(GLARE_ERROR_OPTION, glare_built_in_lamp_text(-1, 0, name, sizeof name, NULL, &error));
  FAILS(GLARE_ERROR_OPTION, glare_built_in_lamp_text(0, 3, name, sizeof name, NULL, &error));
}

static glare_lamp* lamps(void) {
  const double nm[] = {400, 550, 700}, power[] = {1, 2, 1}, bad[] = {400, 400, 700};
  glare_lamp *lamp = NULL, *none = (glare_lamp*)1;
  OK(glare_lamp_make(nm, power, 3, "a tent", &lamp, &error));
  glare_lamp_free(lamp);
  OK(glare_lamp_make(nm, power, 3, NULL, &lamp, &error));
  glare_lamp_free(lamp);
  FAILS(GLARE_ERROR_INPUT, glare_lamp_make(bad, power, 3, NULL, &none, &error));
  REQUIRE(none == NULL);
  FAILS(GLARE_ERROR_INPUT, glare_lamp_make(nm, power, 0, NULL, &none, &error));
  FAILS(GLARE_ERROR_OPTION, glare_lamp_make(nm, power, SIZE_MAX, NULL, &none, &error));
  FAILS(GLARE_ERROR_OPTION, glare_lamp_make(NULL, power, 3, NULL, &none, &error));
  FAILS(GLARE_ERROR_OPTION, glare_lamp_find("no such lamp", &none, &error));
  FAILS(GLARE_ERROR_OPTION, glare_lamp_find(NULL, &none, &error));
  FAILS(GLARE_ERROR_OPTION, glare_lamp_find("D65", NULL, &error));
  FAILS(GLARE_ERROR_INPUT, glare_lamp_find("./no/such/file.csv", &none, &error));
  REQUIRE(glare_lamp_find(NULL, &none, NULL) == GLARE_ERROR_OPTION);
  glare_lamp_free(NULL);
  OK(glare_lamp_find("D65", &lamp, &error));
  return lamp;
}

/* A round pupil of 3 mm in 4 mm. */
static glare_template* template_of(const glare_lamp* lamp) {
  static float pupil[APERTURE * APERTURE];
  double done = -1;
  glare_template *made = NULL, *none = NULL;
  glare_template_options o;
  for (int y = 0; y < APERTURE; ++y)
    for (int x = 0; x < APERTURE; ++x) {
      const double dx = x - APERTURE / 2.0, dy = y - APERTURE / 2.0;
      pupil[y * APERTURE + x] = dx * dx + dy * dy < 24 * 24 ? 1.0F : 0.0F;
    }
  OK(glare_template_options_init(&o, sizeof o, &error));
  REQUIRE(o.struct_size == sizeof o && o.width == 512 && o.field_of_view_deg == 5);
  o.width = SIZE;
  o.height = SIZE - 2;
  o.field_of_view_deg = 0.3;
  OK(glare_template_make_aperture(pupil, APERTURE, APERTURE, 4, lamp, &o, &made, &error));
  FAILS(GLARE_ERROR_OPTION,
        glare_template_make_aperture(pupil, -1, APERTURE, 4, lamp, &o, &none, &error));
  FAILS(GLARE_ERROR_OPTION,
        glare_template_make_aperture(pupil, APERTURE, APERTURE, NAN, lamp, &o, &none, &error));
  FAILS(GLARE_ERROR_OPTION,
        glare_template_make_aperture(NULL, APERTURE, APERTURE, 4, lamp, &o, &none, &error));
  FAILS(GLARE_ERROR_OPTION,
        glare_template_make_aperture(pupil, APERTURE, APERTURE, 4, NULL, &o, &none, &error));
  pupil[5] = 2;
  FAILS(GLARE_ERROR_INPUT,
        glare_template_make_aperture(pupil, APERTURE, APERTURE, 4, lamp, &o, &none, &error));
  pupil[5] = 0;
  o.progress = stop;
  o.user = &done;
  FAILS(GLARE_ERROR_CANCELLED,
        glare_template_make_aperture(pupil, APERTURE, APERTURE, 4, lamp, &o, &none, &error));
  REQUIRE(none == NULL && done >= 0 && done <= 1);
  o.progress = NULL;
  o.memory_limit_bytes = 1000;
  FAILS(GLARE_ERROR_MEMORY,
        glare_template_make_aperture(pupil, APERTURE, APERTURE, 4, lamp, &o, &none, &error));
  o.normalization = 7;
  FAILS(GLARE_ERROR_OPTION, glare_template_make_eye(NULL, lamp, &o, &none, &error));
  FAILS(GLARE_ERROR_OPTION, glare_template_make_files(NULL, NULL, 4, lamp, &o, &none, &error));
  FAILS(GLARE_ERROR_INPUT,
        glare_template_make_files("./none.png", NULL, 4, lamp, NULL, &none, &error));
  return made;
}

/* Structures of other sizes than the library's. */
static void structures(const glare_lamp* lamp) {
  struct {
    glare_eye_options eye;
    double later_field;
  } newer;
  glare_template* made = NULL;
  glare_template_options o;
  OK(glare_template_options_init(&o, sizeof o, &error));
  o.width = o.height = 16;
  OK(glare_eye_options_init(&newer.eye, sizeof newer, &error));
  REQUIRE(newer.eye.seed == 1 && newer.later_field == 0);
  OK(glare_template_make_eye(&newer.eye, lamp, &o, &made, &error));
  glare_template_free(made);
  newer.later_field = 1;
  FAILS(GLARE_ERROR_OPTION, glare_template_make_eye(&newer.eye, lamp, &o, &made, &error));
  newer.eye.struct_size = offsetof(glare_eye_options, seed); /* An older one. */
  OK(glare_template_make_eye(&newer.eye, lamp, &o, &made, &error));
  glare_template_free(made);
  newer.eye.struct_size = 0;
  FAILS(GLARE_ERROR_OPTION, glare_template_make_eye(&newer.eye, lamp, &o, &made, &error));
  FAILS(GLARE_ERROR_OPTION, glare_eye_options_init(NULL, sizeof newer, &error));
  FAILS(GLARE_ERROR_OPTION, glare_template_options_init(&o, 3, &error));
}

static void facts_and_files(glare_template* made, const char* folder) {
  char path[1024], text[100];
  glare_template_facts facts, again;
  glare_template* read = NULL;
  size_t needed = 0;
  snprintf(path, sizeof path, "%s/c_only.exr", folder);
  OK(glare_template_set_recipe(made, "c_only", &error));
  OK(glare_template_write(made, path, 0, &error));
  OK(glare_template_read(path, &read, &error));
  OK(glare_template_get_facts(made, &facts, sizeof facts, &error));
  OK(glare_template_get_facts(read, &again, sizeof again, &error));
  REQUIRE(facts.width == SIZE && facts.height == SIZE - 2 && facts.center_x == SIZE / 2);
  REQUIRE(fabs(facts.pixel_pitch_deg * SIZE - 0.3) < 1e-12); /* Two roundings. */
  REQUIRE(facts.captured_energy > 0.5 && facts.captured_energy < 1);
  REQUIRE(again.width == facts.width && again.normalization == GLARE_NORMALIZE_PEAK);
  REQUIRE(fabs(again.per_steradian / facts.per_steradian - 1) < 1e-6); /* The file has floats. */
  OK(glare_template_text(read, GLARE_TEXT_RECIPE, text, sizeof text, &needed, &error));
  REQUIRE(strcmp(text, "c_only") == 0 && needed == 7);
  OK(glare_template_text(read, GLARE_TEXT_LAMP, text, sizeof text, NULL, &error));
  REQUIRE(strcmp(text, "D65") == 0);

  static float rgb[SIZE * (SIZE - 2) * 3];
  glare_pixels pixels;
  float peak = 0;
  OK(glare_pixels_interleaved(&pixels, rgb, sizeof rgb / sizeof *rgb, SIZE, SIZE - 2, 3, &error));
  OK(glare_template_copy_pixels(read, &pixels, &error));
  for (size_t i = 1; i < sizeof rgb / sizeof *rgb; i += 3) peak = rgb[i] > peak ? rgb[i] : peak;
  REQUIRE(rgb[3 * (SIZE * (SIZE / 2 - 1) + SIZE / 2) + 1] == peak);
  pixels.width = 1;
  FAILS(GLARE_ERROR_OPTION, glare_template_copy_pixels(read, &pixels, &error));

  FAILS(GLARE_ERROR_OPTION, glare_template_text(read, 99, text, sizeof text, NULL, &error));
  FAILS(GLARE_ERROR_OPTION, glare_template_text(NULL, 0, text, sizeof text, NULL, &error));
  FAILS(GLARE_ERROR_OPTION, glare_template_get_facts(NULL, &facts, sizeof facts, &error));
  FAILS(GLARE_ERROR_OPTION, glare_template_set_recipe(made, NULL, &error));
  FAILS(GLARE_ERROR_OUTPUT, glare_template_write(made, "/no/such/folder/t.exr", 1, &error));
  FAILS(GLARE_ERROR_OPTION, glare_template_write(made, NULL, 1, &error));
  glare_template_free(read);
  FAILS(GLARE_ERROR_INPUT, glare_template_read("/no/such/t.exr", &read, &error));
  REQUIRE(read == NULL);
  glare_template_free(NULL);
}

/* One bright pixel in grey 1; RGBA, so that every fourth float is none of Glare's. */
static void fill(float* rgba) {
  for (int i = 0; i < FLOATS; ++i) rgba[i] = i % 4 == 3 ? 0.25F : 1.0F;
  for (int k = 0; k < 3; ++k) rgba[(12 * WIDTH + 20) * 4 + k] = 1000;
}

static void pictures(const glare_template* made) {
  static float rgba[FLOATS], planes[FLOATS], grey[WIDTH * HEIGHT];
  glare_filter *filter = NULL, *none = NULL;
  glare_filter_options f;
  glare_apply_options a;
  glare_unusable_pixels unusable = {9, 9, 9};
  glare_pixels p, planar;
  double captured[3], kept[3], done = -1;

  OK(glare_filter_options_init(&f, sizeof f, &error));
  FAILS(GLARE_ERROR_OPTION, glare_filter_make(made, &f, &none, &error)); /* No size. */
  f.width = WIDTH;
  f.height = HEIGHT;
  FAILS(GLARE_ERROR_OPTION, glare_filter_make(made, &f, &none, &error)); /* No scale. */
  f.fov_deg = 0.4;
  FAILS(GLARE_ERROR_OPTION, glare_filter_make(made, NULL, &none, &error));
  FAILS(GLARE_ERROR_OPTION, glare_filter_make(NULL, &f, &none, &error));
  f.threads = -1;
  FAILS(GLARE_ERROR_OPTION, glare_filter_make(made, &f, &none, &error));
  f.threads = 2;
  f.color_space = "no such space";
  FAILS(GLARE_ERROR_OPTION, glare_filter_make(made, &f, &none, &error));
  f.color_space = NULL;
  f.edge = GLARE_EDGE_EXTEND;
  OK(glare_filter_make(made, &f, &filter, &error));
  OK(glare_filter_shares(filter, captured, kept, &error));
  REQUIRE(fabs(captured[1] + kept[1] - 1) < 1e-12 && captured[1] > 0.5);

  fill(rgba);
  OK(glare_pixels_interleaved(&p, rgba, FLOATS, WIDTH, HEIGHT, 4, &error));
  OK(glare_apply_options_init(&a, sizeof a, &error));
  a.progress = stop;
  a.user = &done;
  FAILS(GLARE_ERROR_CANCELLED, glare_filter_apply(filter, &a, &p, &unusable, &error));
  REQUIRE(rgba[(12 * WIDTH + 20) * 4] == 1000 && unusable.nan == 9);
  a.progress = NULL;
  OK(glare_filter_apply(filter, &a, &p, &unusable, &error));
  REQUIRE(unusable.nan == 0 && unusable.infinite == 0 && unusable.negative == 0);
  REQUIRE(rgba[(12 * WIDTH + 20) * 4] < 999 && rgba[(12 * WIDTH + 21) * 4] > 2 && rgba[3] == 0.25F);

  /* The same picture from the bottom up and in planes: the same values. */
  fill(planes);
  static float separate[FLOATS];
  OK(glare_pixels_planar(&planar, separate, FLOATS, WIDTH, HEIGHT, 3, &error));
  planar.first = WIDTH * (HEIGHT - 1);
  planar.row_stride = -WIDTH;
  for (int y = 0; y < HEIGHT; ++y)
    for (int x = 0; x < WIDTH; ++x)
      for (int k = 0; k < 3; ++k)
        separate[(k * HEIGHT + HEIGHT - 1 - y) * WIDTH + x] = planes[(y * WIDTH + x) * 4 + k];
  OK(glare_filter_apply(filter, NULL, &planar, NULL, &error));
  for (int y = 0; y < HEIGHT; ++y)
    for (int x = 0; x < WIDTH; ++x)
      for (int k = 0; k < 3; ++k)
        REQUIRE(separate[(k * HEIGHT + HEIGHT - 1 - y) * WIDTH + x] ==
                rgba[(y * WIDTH + x) * 4 + k]);

  /* What isn't a number stays alone. */
  fill(rgba);
  rgba[0] = NAN;
  rgba[4] = INFINITY;
  rgba[8] = -1;
  OK(glare_filter_apply(filter, NULL, &p, &unusable, &error));
  REQUIRE(unusable.nan == 1 && unusable.infinite == 1 && unusable.negative == 1);
  REQUIRE(isnan(rgba[0]) && isfinite(rgba[1]) && isfinite(rgba[12]));

  /* Pictures that don't fit. */
  OK(glare_pixels_planar(&planar, grey, WIDTH * HEIGHT, WIDTH, HEIGHT, 1, &error));
  FAILS(GLARE_ERROR_OPTION, glare_filter_apply(filter, NULL, &planar, NULL, &error));
  FAILS(GLARE_ERROR_OPTION, glare_filter_apply(filter, NULL, NULL, NULL, &error));
  FAILS(GLARE_ERROR_OPTION, glare_filter_apply(NULL, NULL, &p, NULL, &error));
  glare_pixels bad = p;
  bad.row_stride = PTRDIFF_MAX / 2;
  FAILS(GLARE_ERROR_OPTION, glare_filter_apply(filter, NULL, &bad, NULL, &error));
  bad = p;
  bad.first = 4; /* The last pixel's last channel is beyond the end. */
  FAILS(GLARE_ERROR_OPTION, glare_filter_apply(filter, NULL, &bad, NULL, &error));
  bad = p;
  bad.pixel_stride = -4;
  FAILS(GLARE_ERROR_OPTION, glare_filter_apply(filter, NULL, &bad, NULL, &error));
  bad = p;
  bad.buffer_floats = SIZE_MAX;
  FAILS(GLARE_ERROR_OPTION, glare_filter_apply(filter, NULL, &bad, NULL, &error));
  bad = p;
  bad.height = HEIGHT - 1;
  FAILS(GLARE_ERROR_OPTION, glare_filter_apply(filter, NULL, &bad, NULL, &error));
  FAILS(GLARE_ERROR_OPTION,
        glare_pixels_interleaved(&bad, rgba, FLOATS - 2, WIDTH, HEIGHT, 4, &error));
  FAILS(GLARE_ERROR_OPTION, glare_pixels_interleaved(&bad, rgba, FLOATS, WIDTH, HEIGHT, 2, &error));
  FAILS(GLARE_ERROR_OPTION, glare_pixels_planar(&bad, NULL, FLOATS, WIDTH, HEIGHT, 3, &error));
  FAILS(GLARE_ERROR_OPTION,
        glare_pixels_planar(&bad, rgba, FLOATS, INT32_MAX, INT32_MAX, 3, &error));
  glare_filter_free(filter);
  glare_filter_free(NULL);

  /* Grey, and a point at a pixel's centre: as the filter makes it, to 1e-3 of what is
   * added, and to the rounding of its transforms, some 1e-6 of the brightest value. */
  f.grey = 1;
  f.edge = GLARE_EDGE_BLACK;
  OK(glare_filter_make(made, &f, &filter, &error));
  grey[12 * WIDTH + 20] = 1000;
  OK(glare_filter_apply(filter, NULL, &planar, NULL, &error));
  glare_filter_free(filter);
  static float points[WIDTH * HEIGHT];
  const glare_point point = {20, 12, {1000, 1000, 1000}};
  points[12 * WIDTH + 20] = 1000;
  planar.buffer = points;
  OK(glare_add_points(made, &f, &point, 1, 1, 0, &planar, &error));
  for (int i = 0; i < WIDTH * HEIGHT; ++i)
    REQUIRE(fabsf(points[i] - grey[i]) < 1e-3F * fabsf(grey[i]) + 1e-3F);
  REQUIRE(points[12 * WIDTH + 20] < 999 && points[12 * WIDTH + 21] > 1);
  FAILS(GLARE_ERROR_OPTION, glare_add_points(made, &f, NULL, 1, 1, 0, &planar, &error));
  FAILS(GLARE_ERROR_OPTION, glare_add_points(NULL, &f, &point, 1, 1, 0, &planar, &error));
  const glare_point lost = {NAN, 12, {1, 1, 1}};
  FAILS(GLARE_ERROR_OPTION, glare_add_points(made, &f, &lost, 1, 1, 0, &planar, &error));
}

int main(int argument_count, char** arguments) {
  if (argument_count != 2) return 2;
  texts();
  glare_lamp* lamp = lamps();
  glare_template* made = template_of(lamp);
  structures(lamp);
  facts_and_files(made, arguments[1]);
  pictures(made);
  glare_template_free(made);
  glare_lamp_free(lamp);
  puts("c_only: all as it should be");
  return 0;
}
