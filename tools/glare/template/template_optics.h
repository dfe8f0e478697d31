// The aperture and its far field, as one command's lamps need them.
#pragma once

#include <optional>
#include <utility>

#include "console.h"
#include "glare/aperture/aperture.h"
#include "glare/diffraction/far_field.h"
#include "glare/io/lamp_file.h"
#include "template/template_arguments.h"

namespace glare::tool {

/// Holds one far field at a time, which serves every lamp for which it is, to the last bit, the one
/// that the lamp alone would be given: so a template's bytes don't depend on the other lamps. The
/// built-in eye is drawn as finely as the shortest wavelength needs, so it may be another one too.
class TemplateOptics {
 public:
  /// Reads the aperture's pictures, where some are given, and warns of what is odd in them. The
  /// arguments and options outlive this object.
  TemplateOptics(const TemplateArguments& arguments, const TemplateOptions& options,
                 const Console& console);

  /// The same with an aperture that isn't in files.
  TemplateOptics(const TemplateArguments& arguments, const TemplateOptions& options,
                 Aperture aperture)
      : arguments_(arguments), options_(options), aperture_(std::move(aperture)) {}

  /// Throws, before any work, what making a far field for these wavelengths would throw.
  void require_possible(const WavelengthRange& range) const;

  /// True where the far field that is held is the one for these wavelengths.
  bool serves(const WavelengthRange& range) const;

  /// Makes the far field for these wavelengths, in place of the one that is held; where aberrations
  /// shift the phase there is none for all of them, and only the aperture is made.
  void make_far_field(const WavelengthRange& range, const ProgressCallback& progress);

  const Aperture& aperture() const { return *aperture_; }
  /// True where the eye is closed and no far field could be made.
  bool is_dark() const { return dark_; }
  const FarField& far_field() const { return *far_field_; }
  const ApertureSize& aperture_size() const { return size_; }

  /// Gives memory back: after the last far field, and after its last use.
  void release_aperture() { aperture_.reset(); }
  void release_far_field() { far_field_.reset(); }

 private:
  void draw_eye(const WavelengthRange& range, const ProgressCallback& progress);

  const TemplateArguments& arguments_;
  const TemplateOptions& options_;
  std::optional<Aperture> aperture_;
  std::optional<FarField> far_field_;
  WavelengthRange range_;  ///< What the far field was made for.
  bool dark_ = false;
  ApertureSize size_;  ///< Of the aperture that it was made of.
};

/// The template of a lamp, whose wavelengths the optics serve.
GlareTemplate made_template(const TemplateOptics& optics, const NamedLamp& lamp,
                            const TemplateOptions& options);

}  // namespace glare::tool
