/* Glare from C, or from any language that calls C: lamps, templates, and pictures with their glare.
 *
 * - Every function that can fail returns a `glare_status`, and tells more in the caller's
 *   `glare_error`, its last argument, which may be NULL. Where one fails, the handle that it was to
 *   make is NULL and other results are untouched.
 *   A NULL or a size that can't be is GLARE_ERROR_OPTION, not a crash; but every pointer that isn't
 *   NULL must point to what its type says. Nothing is thrown and nothing printed.
 * - Handles are made by `..._make...`, `..._find`, `..._read` and given back by `..._free`, which
 *   takes NULL too. They don't change but by `glare_template_set_recipe`: several threads may use
 *   one at once, and there is no state beside them. A filter keeps what it needs of its template.
 * - Buffers and texts are the caller's and not kept: texts are UTF-8, ended by a zero byte.
 * - Structures of options are first filled by their `..._init`, with the caller's sizeof: so a
 *   program goes on working with a later library, whose structures have further fields.
 * - Whatever has `threads` gives the same values for any number of them; 0: all of the machine.
 *   `memory_limit_bytes` of 0: three quarters of the machine's.
 */
#ifndef GLARE_C_H
#define GLARE_C_H

#include <stddef.h>
#include <stdint.h>

#if defined(__GNUC__)
#define GLARE_C_API __attribute__((visibility("default")))
#else
#define GLARE_C_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* ---- Errors: the numbers are the program's exit statuses. ---- */

typedef int32_t glare_status;
enum {
  GLARE_OK = 0,
  GLARE_ERROR_INTERNAL = 1, /* Failed for another reason. */
  GLARE_ERROR_OPTION = 2,   /* An argument or option is missing, unknown or out of range. */
  GLARE_ERROR_INPUT = 3,    /* An input can't be read or isn't what it should be. */
  GLARE_ERROR_OUTPUT = 4,   /* A file can't be written; none was left. */
  GLARE_ERROR_MEMORY = 5,   /* More memory is needed than there is or than is allowed. */
  GLARE_ERROR_CANCELLED = 6 /* The progress function said so. */
};

typedef struct glare_error {
  glare_status status;
  char message[1020]; /* One line for a person, cut if need be; empty for GLARE_OK. */
} glare_error;

/* "0.1.0", of the library that runs; valid for ever. Libraries that agree in the first two numbers
 * have the same functions, and structures of options and facts that at most grew. */
GLARE_C_API const char* glare_version(void);

/* Called now and then in long work, from one thread at a time but not always the caller's, with the
 * share that is done, 0 to 1. 0 stops the work. Must return: no exception, no longjmp. */
typedef int32_t (*glare_progress)(double fraction_done, void* user);

/* ---- Lamps. ---- */

typedef struct glare_lamp glare_lamp;

/* A built-in lamp's name, "blackbody:KELVIN", or a CSV file of wavelength_nm,power. */
GLARE_C_API glare_status glare_lamp_find(const char* name_or_file, glare_lamp** lamp,
                                         glare_error* error);
/* Relative power at `count` (at least 2) different wavelengths in nm, in any order; linear between
 * them and 0 beyond. `name` is what templates tell of it; may be NULL. */
GLARE_C_API glare_status glare_lamp_make(const double* wavelengths_nm, const double* power,
                                         size_t count, const char* name, glare_lamp** lamp,
                                         glare_error* error);
GLARE_C_API void glare_lamp_free(glare_lamp* lamp);

/* Texts go to a buffer of `size` bytes, cut if need be and ended by a zero byte. `needed`, unless
 * NULL, becomes the bytes of all of it; a buffer may be NULL where its size is 0. */
enum { GLARE_LAMP_NAME = 0, GLARE_LAMP_ALIAS = 1, GLARE_LAMP_DESCRIPTION = 2 };
GLARE_C_API int32_t glare_built_in_lamp_count(void);
GLARE_C_API glare_status glare_built_in_lamp_text(int32_t index, int32_t which, char* buffer,
                                                  size_t size, size_t* needed, glare_error* error);

/* ---- Pictures in the caller's memory. ---- */

/* 32-bit floats, scene-linear. Channel k of pixel (x, y), rows from the top, is
 * buffer[first + x pixel_stride + y row_stride + k channel_stride]; strides count floats, may be
 * negative, and no two values may share a place. What lies between isn't touched. */
typedef struct glare_pixels {
  float* buffer;
  size_t buffer_floats; /* No place from here on is touched. */
  size_t first;
  int32_t width, height, channels; /* 1 to 65535 pixels; 3 channels, or 1: grey. */
  ptrdiff_t pixel_stride, row_stride, channel_stride;
} glare_pixels;

/* Pixel after pixel, each of `floats_per_pixel`: 1 is grey, from 3 on the first three are RGB. */
GLARE_C_API glare_status glare_pixels_interleaved(glare_pixels* pixels, float* buffer,
                                                  size_t buffer_floats, int32_t width,
                                                  int32_t height, int32_t floats_per_pixel,
                                                  glare_error* error);
/* Channel after channel, 1 or 3 of them. */
GLARE_C_API glare_status glare_pixels_planar(glare_pixels* pixels, float* buffer,
                                             size_t buffer_floats, int32_t width, int32_t height,
                                             int32_t channels, glare_error* error);

/* ---- Templates. ---- */

typedef struct glare_template glare_template;

enum { GLARE_NORMALIZE_PEAK = 0, GLARE_NORMALIZE_ENERGY = 1, GLARE_NORMALIZE_ABSOLUTE = 2 };
enum { GLARE_WHITE_NONE = 0, GLARE_WHITE_LAMP = 1 };
enum { GLARE_GAMUT_KEEP = 0, GLARE_GAMUT_DESATURATE = 1 };
enum { GLARE_SCATTER_NONE = 0, GLARE_SCATTER_CIE = 1 };

/* As the options of `glare template`, with its defaults. */
typedef struct glare_template_options {
  size_t struct_size;
  int32_t width, height;                     /* 512 x 512 */
  double field_of_view_deg;                  /* 5; across the width, in direction sine */
  double wavelength_lo_nm, wavelength_hi_nm; /* 380, 780 */
  const char* observer;                      /* NULL: cie1931-2deg */
  const char* color_space;                   /* NULL: lin_rec709 */
  const char* ocio_config;                   /* NULL: the variable OCIO's, if any */
  int32_t white, normalization, gamut;       /* GLARE_WHITE_NONE, ..._PEAK, ..._KEEP */
  int32_t scatter;                           /* GLARE_SCATTER_NONE */
  double age_years, pigment;                 /* 35, 0.5; of the eye that scatters */
  int32_t threads;
  uint64_t memory_limit_bytes;
  glare_progress progress; /* NULL: none */
  void* user;              /* Handed to `progress`. */
} glare_template_options;

/* The built-in eye. */
typedef struct glare_eye_options {
  size_t struct_size;
  double pupil_diameter_mm; /* 6.5; 1 to 10 */
  double lid_opening_mm;    /* 7.6; 0.1 to 14 */
  double time_s;            /* 0; 0 to 1e6 */
  uint64_t seed;            /* 1 */
} glare_eye_options;

GLARE_C_API glare_status glare_template_options_init(glare_template_options* options, size_t size,
                                                     glare_error* error);
GLARE_C_API glare_status glare_eye_options_init(glare_eye_options* eye, size_t size,
                                                glare_error* error);

/* The built-in eye's template. `eye` and `options` may be NULL: all by default. */
GLARE_C_API glare_status glare_template_make_eye(const glare_eye_options* eye,
                                                 const glare_lamp* lamp,
                                                 const glare_template_options* options,
                                                 glare_template** made, glare_error* error);
/* That of an aperture: `width` x `height` amplitude transmittances, 0 to 1, rows from the top;
 * `width_mm` is the whole picture's. */
GLARE_C_API glare_status glare_template_make_aperture(const float* transmittance, int32_t width,
                                                      int32_t height, double width_mm,
                                                      const glare_lamp* lamp,
                                                      const glare_template_options* options,
                                                      glare_template** made, glare_error* error);
/* That of pictures of a pupil and of eyelashes, one of which may be NULL; `width_mm` of 0: as the
 * files tell. */
GLARE_C_API glare_status glare_template_make_files(const char* pupil, const char* eyelashes,
                                                   double width_mm, const glare_lamp* lamp,
                                                   const glare_template_options* options,
                                                   glare_template** made, glare_error* error);
GLARE_C_API glare_status glare_template_read(const char* path, glare_template** read,
                                             glare_error* error);
/* OpenEXR; all or nothing. `half`: 16-bit floats if not 0. */
GLARE_C_API glare_status glare_template_write(const glare_template* of, const char* path,
                                              int32_t half, glare_error* error);
GLARE_C_API void glare_template_free(glare_template* made);

/* What the file says, docs/file-format.md. */
typedef struct glare_template_facts {
  int32_t width, height, center_x, center_y; /* Pixels; the axis is that pixel's centre. */
  double pixel_pitch_deg, pixel_pitch_rad;   /* Direction sine. */
  double per_steradian;                      /* A luminance of 1 in the template, per steradian. */
  double captured_energy;                    /* Share of the light on the pixels, 0 to 1. */
  double scattered_energy;                   /* Share of the light that is straylight. */
  double lamp_xyz[3], light_xyz[3]; /* Y = 1; of the lamp, and of the light as pixels have it. */
  double wavelength_lo_nm, wavelength_hi_nm;
  double aperture_width_mm, aperture_area_mm2;
  int32_t normalization, has_scatter;
} glare_template_facts;

/* `size` is the caller's sizeof. */
GLARE_C_API glare_status glare_template_get_facts(const glare_template* of,
                                                  glare_template_facts* facts, size_t size,
                                                  glare_error* error);
enum {
  GLARE_TEXT_LAMP = 0,
  GLARE_TEXT_OBSERVER = 1,
  GLARE_TEXT_COLOR_SPACE = 2,
  GLARE_TEXT_RECIPE = 3,
  GLARE_TEXT_SOFTWARE = 4
};
GLARE_C_API glare_status glare_template_text(const glare_template* of, int32_t which, char* buffer,
                                             size_t size, size_t* needed, glare_error* error);
/* What the file will tell of its making. */
GLARE_C_API glare_status glare_template_set_recipe(glare_template* of, const char* recipe,
                                                   glare_error* error);
/* Copies the pixels to `pixels`, 3 channels of the template's size. */
GLARE_C_API glare_status glare_template_copy_pixels(const glare_template* of,
                                                    const glare_pixels* pixels, glare_error* error);

/* ---- Pictures with their glare. ---- */

typedef struct glare_filter glare_filter;

enum { GLARE_EDGE_BLACK = 0, GLARE_EDGE_EXTEND = 1 };
enum { GLARE_LAMP_COLOR_DIVIDED_OUT = 0, GLARE_LAMP_COLOR_KEPT = 1 };

/* The pictures: their size, scale and colours. */
typedef struct glare_filter_options {
  size_t struct_size;
  int32_t width, height;   /* 0, 0: to be set; 1 to 65535. */
  double fov_deg;          /* 0; across the width, */
  double pixel_deg;        /* 0; or of a pixel. One of them is to be set. */
  int32_t perspective;     /* 0; not 0: `fov_deg` is a pinhole camera's. */
  double pixel_aspect;     /* 1; width over height of a pixel. */
  const char* color_space; /* NULL: lin_rec709; the pictures'. */
  const char* ocio_config; /* NULL: the variable OCIO's, if any. */
  int32_t lamp_color;      /* GLARE_LAMP_COLOR_DIVIDED_OUT */
  int32_t grey;            /* 0; not 0: the kernel of luminance, for pictures of 1 or 3 channels. */
  int32_t edge;            /* GLARE_EDGE_BLACK: nothing beyond the border; else its own values. */
  int32_t threads;
  uint64_t memory_limit_bytes;
} glare_filter_options;

typedef struct glare_apply_options {
  size_t struct_size;
  double exposure_stops; /* 0 */
  double threshold;      /* 0: all light is spread; else what is above this luminance. */
  double knee;           /* 0.5; half the soft step's width over the threshold, 0 to 1. */
  double strength;       /* 1; 0 to 1000 */
  int32_t only_glare;    /* 0; not 0: the change alone. */
  int32_t threads;
  glare_progress progress;
  void* user;
} glare_apply_options;

/* Pixels that gave no light, each counted once. */
typedef struct glare_unusable_pixels {
  uint64_t nan, infinite, negative;
} glare_unusable_pixels;

GLARE_C_API glare_status glare_filter_options_init(glare_filter_options* options, size_t size,
                                                   glare_error* error);
GLARE_C_API glare_status glare_apply_options_init(glare_apply_options* options, size_t size,
                                                  glare_error* error);

/* A template made ready for pictures of one size: made once, for any number of pictures. */
GLARE_C_API glare_status glare_filter_make(const glare_template* of,
                                           const glare_filter_options* options,
                                           glare_filter** filter, glare_error* error);
GLARE_C_API void glare_filter_free(glare_filter* filter);
/* Shares of each channel's light that the template spreads and that stay where they are. */
GLARE_C_API glare_status glare_filter_shares(const glare_filter* filter, double captured[3],
                                             double kept[3], glare_error* error);

/* Puts the glare into a picture, in place: light is moved, not made. One channel needs a filter
 * that is `grey`. `options` and `unusable` may be NULL. The pixels stay as they were on failure. */
GLARE_C_API glare_status glare_filter_apply(const glare_filter* filter,
                                            const glare_apply_options* options,
                                            const glare_pixels* pixels,
                                            glare_unusable_pixels* unusable, glare_error* error);

/* A point of light: its place (0, 0 is the first pixel's centre), and its value times pixels. */
typedef struct glare_point {
  double x_px, y_px;
  float light[3];
} glare_point;

/* Adds the glare of few points, placed between the pixels. Of `options` all but the edge and the
 * memory limit count; its size is the picture's. `points_are_new` of 0: the picture shows them
 * already, and the light that is spread is taken from there. Points may lie beyond the border. Of a
 * grey picture's points the luminance counts. */
GLARE_C_API glare_status glare_add_points(const glare_template* of,
                                          const glare_filter_options* options,
                                          const glare_point* points, size_t count, double strength,
                                          int32_t points_are_new, const glare_pixels* pixels,
                                          glare_error* error);

#ifdef __cplusplus
}
#endif

#endif
