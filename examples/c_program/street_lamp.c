/* A street lamp in a picture of 160 x 90 pixels, 8 degrees across, with the glare of an eye. */
#include <glare/glare_c.h>
#include <stdio.h>
#include <stdlib.h>

enum { WIDTH = 160, HEIGHT = 90 };

static void check(glare_status status, const glare_error* error) {
  if (status == GLARE_OK) return;
  fprintf(stderr, "street_lamp: %s\n", error->message);
  exit(status);
}

int main(int argument_count, char** arguments) {
  static float picture[HEIGHT][WIDTH][3]; /* Linear light, in cd/m2. */
  glare_error error;
  if (argument_count != 2) {
    fprintf(stderr, "usage: street_lamp OUT.exr\n");
    return GLARE_ERROR_OPTION;
  }

  /* What an eye sees around a lamp: once for all pictures. */
  glare_lamp* lamp = NULL;
  glare_template* eye = NULL;
  glare_template_options made_of;
  check(glare_lamp_find("D65", &lamp, &error), &error);
  check(glare_template_options_init(&made_of, sizeof made_of, &error), &error);
  made_of.width = made_of.height = 128;
  made_of.field_of_view_deg = 6;
  check(glare_template_make_eye(NULL, lamp, &made_of, &eye, &error), &error);
  check(glare_template_write(eye, arguments[1], 0, &error), &error);

  /* Ready for pictures of one size: once for all frames. */
  glare_filter* filter = NULL;
  glare_filter_options frames;
  check(glare_filter_options_init(&frames, sizeof frames, &error), &error);
  frames.width = WIDTH;
  frames.height = HEIGHT;
  frames.fov_deg = 8;
  check(glare_filter_make(eye, &frames, &filter, &error), &error);

  for (int k = 0; k < 3; ++k) picture[HEIGHT / 2][WIDTH / 2][k] = 1e6F;
  glare_pixels pixels;
  check(glare_pixels_interleaved(&pixels, &picture[0][0][0], sizeof picture / sizeof(float), WIDTH,
                                 HEIGHT, 3, &error),
        &error);
  check(glare_filter_apply(filter, NULL, &pixels, NULL, &error), &error);

  for (int x = WIDTH / 2; x < WIDTH; x += 10)
    printf("%.2f degrees from the lamp: %8.3g cd/m2\n", (x - WIDTH / 2) * 8.0 / WIDTH,
           (double)picture[HEIGHT / 2][x][1]);
  glare_filter_free(filter);
  glare_template_free(eye);
  glare_lamp_free(lamp);
  return 0;
}
