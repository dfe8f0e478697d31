// A program that needs the numbers only: it uses FFTW and the threads, and no file is read.
#include <glare/glare.h>

int main() {
  const glare::Aperture eye = glare::draw_eye({}, 0.02);
  glare::TemplateOptions options;
  options.width = options.height = 32;
  options.field_of_view_deg = 1;
  return glare::make_template(eye, *glare::find_lamp("D65"), options).captured_energy > 0 ? 0 : 1;
}
