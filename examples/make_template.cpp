// Makes a glare template from a picture of a pupil, a picture of eyelashes and a lamp:
//   make_template pupil.png eyelashes.png 8 D65 template.exr
// The pictures are transmittances (white = open) and 8 mm wide; the lamp is a name that
// `glare lamps` lists, or a CSV file of wavelength_nm,power.
#include <glare/glare.h>
#include <glare/glare_io.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>

int main(int argument_count, char** arguments) {
  if (argument_count != 6) {
    std::fprintf(stderr, "usage: make_template PUPIL EYELASHES WIDTH_MM LAMP OUT.exr\n");
    return 2;
  }
  try {
    const glare::Aperture aperture =
        glare::read_aperture({arguments[1], arguments[2], std::atof(arguments[3])}).aperture;
    const glare::NamedLamp lamp = glare::lamp_from(arguments[4]);

    glare::TemplateOptions options;
    options.width = options.height = 256;
    const double shortest_nm = glare::effective_range(lamp.spectrum, options).lo_nm;
    options.field_of_view_deg =  // 5 degrees, or as far as pixels of this size can show
        std::min(5.0, glare::widest_field_of_view_deg(aperture.pixel_mm(), shortest_nm,
                                                      glare::pixel_grid(options)));

    const glare::GlareTemplate made = make_template(aperture, lamp.spectrum, options, lamp.name);
    glare::write_template(arguments[5], made);
    std::printf("%s: %d x %d pixels of %.4g degrees, 1 is %.4g per steradian\n", arguments[5],
                made.width(), made.height(), made.pixel_pitch_deg(), made.per_steradian);
  } catch (const glare::Error& error) {
    std::fprintf(stderr, "make_template: %s\n", error.what());
    return 1;
  }
}
