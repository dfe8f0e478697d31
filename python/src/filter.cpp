// Filters and points: what adds glare to pictures. Pictures come and go by their channels, which
// numpy copies to and from arrays of any kind.

#include <pybind11/numpy.h>
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <array>
#include <filesystem>
#include <memory>
#include <numbers>
#include <optional>
#include <string>
#include <vector>

#include "bindings.h"
#include "command_words.h"
#include "glare/base/error.h"
#include "glare/convolution/glare_filter.h"
#include "glare/convolution/pixel_kernel.h"
#include "glare/convolution/point_sources.h"
#include "glare/io/color_config.h"
#include "glare/io/memory.h"
#include "interruptible.h"
#include "template_object.h"

namespace glare::python {

namespace py = pybind11;

namespace {

constexpr int kMostPixels = 65535;

Edge edge_from(const std::string& name) {
  if (name == "black") return Edge::black;
  if (name == "extend") return Edge::extend;
  throw OptionError("edge '" + name + "': expected black or extend");
}

PixelKernelOptions::LampColor lamp_color_from(const std::string& name) {
  if (name == "divide") return PixelKernelOptions::LampColor::divided_out;
  if (name == "keep") return PixelKernelOptions::LampColor::kept;
  throw OptionError("lamp_color '" + name + "': expected divide or keep");
}

/// A picture's place in the world and its colours, as the options tell them.
struct PictureKind {
  std::optional<double> fov_deg, pixel_deg;
  bool perspective = false;
  double pixel_aspect = 1;
  std::string colorspace, ocio;
  std::string lamp_color;
  bool grey = false;

  PixelScale scale(int width) const {
    if (fov_deg.has_value() == pixel_deg.has_value())
      throw OptionError("expected either fov_deg or pixel_deg: how large the picture's pixels are");
    if (perspective && !fov_deg) throw OptionError("perspective goes with fov_deg");
    PixelScale result = perspective ? scale_of_perspective(*fov_deg, width)
                        : fov_deg   ? scale_of_field_of_view(*fov_deg, width)
                                    : PixelScale{*pixel_deg * std::numbers::pi / 180, 1};
    result.pixel_aspect = pixel_aspect;
    return result;
  }

  RgbColorSpace color_space() const {
    const auto user_config =
        ocio.empty() ? color_config_from_environment() : std::filesystem::path(ocio);
    return find_color_space(colorspace, user_config);
  }

  PixelKernelOptions kernel_options(int threads) const {
    PixelKernelOptions options;
    options.lamp_color = lamp_color_from(lamp_color);
    options.luminance_only = grey;
    options.threads = threads;
    return options;
  }
};

void require_size(py::ssize_t width, py::ssize_t height) {
  if (width < 1 || height < 1 || width > kMostPixels || height > kMostPixels)
    throw InputError("", "a picture must have 1 to 65535 pixels each way");
}

/// A picture whose channels Python fills and reads.
class PictureBuffer {
 public:
  PictureBuffer(py::ssize_t width, py::ssize_t height) {
    require_size(width, height);
    const auto needed = 3 * sizeof(float) * static_cast<std::uint64_t>(width * height);
    const std::uint64_t allowed = default_memory_limit_bytes();
    if (needed > allowed) throw MemoryError(needed, allowed);
    for (Image<float>& channel : picture.channels)
      channel = Image<float>(static_cast<int>(width), static_cast<int>(height));
  }

  /// (h, w), writable, of which `self` is the owner.
  static py::array channel(const py::object& self, std::size_t k) {
    auto& image = self.cast<PictureBuffer&>().picture.channels.at(k);
    return py::array(py::dtype::of<float>(),
                     std::vector<py::ssize_t>{image.height(), image.width()}, {},
                     image.values().data(), self);
  }

  Picture picture;
};

std::uint64_t limit_or_usual(std::uint64_t bytes) {
  return bytes != 0 ? bytes : default_memory_limit_bytes();
}

std::shared_ptr<GlareFilter> make_filter(const TemplateObject& object, int width, int height,
                                         const PictureKind& kind, const std::string& edge,
                                         int threads, std::uint64_t memory_limit_bytes) {
  require_size(width, height);
  const GlareFilterOptions options{edge_from(edge), threads, limit_or_usual(memory_limit_bytes)};
  PixelKernelOptions kernel_of = kind.kernel_options(threads);
  if (options.edge == Edge::black) {  // Else light comes from all that lies beyond the border.
    kernel_of.reach_x_px = std::max(1, width - 1);
    kernel_of.reach_y_px = std::max(1, height - 1);
  }
  std::shared_ptr<GlareFilter> filter;
  run_released(py::none(), [&](const ProgressCallback&) {
    filter = std::make_shared<GlareFilter>(
        pixel_kernel(object.whole(), kind.scale(width), kind.color_space(), kernel_of), width,
        height, options);
  });
  return filter;
}

using Counts = std::array<std::uint64_t, 3>;  ///< Pixels that are NaN, infinite, negative.

Counts apply(const GlareFilter& filter, PictureBuffer& buffer, const BrightPartOptions& bright,
             double strength, bool only_glare, int threads, const py::object& progress) {
  ApplyGlareOptions options;
  options.bright = bright;
  options.strength = strength;
  options.only_glare = only_glare;
  options.threads = threads;
  UnusablePixels unusable;
  buffer.picture.color_space = filter.kernel().color_space;
  run_released(progress, [&](const ProgressCallback& note) {
    options.progress = note;
    unusable = apply_glare(buffer.picture, filter, options);
  });
  return {unusable.nan, unusable.infinite, unusable.negative};
}

using PointArray = py::array_t<double, py::array::c_style | py::array::forcecast>;

std::vector<PointSource> points_of(const PointArray& array) {
  if (array.ndim() != 2 || array.shape(1) != 5)
    throw InputError("sources", "expected an array (n, 5): x, y, and the light in R, G, B");
  std::vector<PointSource> points(static_cast<std::size_t>(array.shape(0)));
  for (py::ssize_t i = 0; i < array.shape(0); ++i) {
    PointSource& point = points[static_cast<std::size_t>(i)];
    point.x_px = array.at(i, 0);
    point.y_px = array.at(i, 1);
    for (int k = 0; k < 3; ++k)
      point.light[static_cast<std::size_t>(k)] = static_cast<float>(array.at(i, 2 + k));
  }
  return points;
}

/// Each point's light as grey of its luminance.
void make_grey(std::vector<PointSource>& points, const RgbColorSpace& color_space) {
  const Vector3& weights = color_space.xyz_from_rgb()[1];
  for (PointSource& point : points) {
    const auto& [r, g, b] = point.light;
    point.light.fill(static_cast<float>(weights[0] * r + weights[1] * g + weights[2] * b));
  }
}

void add_points(PictureBuffer& buffer, const PointArray& sources, const TemplateObject& object,
                const PictureKind& kind, double strength, bool are_new, int threads,
                const py::object& progress) {
  std::vector<PointSource> points = points_of(sources);
  PointGlareOptions options;
  options.kernel = kind.kernel_options(threads);
  options.strength = strength;
  options.points_are_new = are_new;
  options.threads = threads;
  run_released(progress, [&](const ProgressCallback& note) {
    options.progress = note;
    buffer.picture.color_space = kind.color_space();
    if (kind.grey) make_grey(points, buffer.picture.color_space);
    add_point_glare(buffer.picture, points, object.whole(), kind.scale(buffer.picture.width()),
                    options);
  });
}

/// The few points (n, 5) that hold the light of the picture, and which pixels give none; None
/// instead of points where the whole picture is to be convolved.
py::tuple find_points(PictureBuffer& buffer, const PictureKind& kind,
                      const BrightPartOptions& bright, const std::string& edge, int threads) {
  const Edge edge_kind = edge_from(edge);
  UnusablePixels unusable;
  std::optional<std::vector<PointSource>> points;
  run_released(py::none(), [&](const ProgressCallback&) {
    buffer.picture.color_space = kind.color_space();
    Picture light;
    unusable = bright_part(buffer.picture, bright, light, threads);
    points = few_points(light, edge_kind);
  });
  const Counts counts = {unusable.nan, unusable.infinite, unusable.negative};
  if (!points) return py::make_tuple(counts, py::none());
  py::array_t<double> rows({static_cast<py::ssize_t>(points->size()), py::ssize_t{5}});
  for (py::ssize_t i = 0; i < rows.shape(0); ++i) {
    const PointSource& point = (*points)[static_cast<std::size_t>(i)];
    const auto& [r, g, b] = point.light;
    const double values[] = {point.x_px, point.y_px, r, g, b};
    for (int column = 0; column < 5; ++column) rows.mutable_at(i, column) = values[column];
  }
  return py::make_tuple(counts, rows);
}

}  // namespace

void add_filter(py::module_& module) {
  py::class_<PictureBuffer>(module, "PictureBuffer")
      .def(py::init<py::ssize_t, py::ssize_t>(), py::arg("width"), py::arg("height"))
      .def_property_readonly("channels", [](const py::object& self) {
        return py::make_tuple(PictureBuffer::channel(self, 0), PictureBuffer::channel(self, 1),
                              PictureBuffer::channel(self, 2));
      });
  py::class_<PictureKind>(module, "PictureKind")
      .def(py::init<std::optional<double>, std::optional<double>, bool, double, std::string,
                    std::string, std::string, bool>(),
           py::kw_only(), py::arg("fov_deg"), py::arg("pixel_deg"), py::arg("perspective"),
           py::arg("pixel_aspect"), py::arg("colorspace"), py::arg("ocio"), py::arg("lamp_color"),
           py::arg("grey"));
  py::class_<BrightPartOptions>(module, "BrightPart")
      .def(py::init<double, double, double>(), py::kw_only(), py::arg("exposure"),
           py::arg("threshold"), py::arg("knee"));
  py::class_<GlareFilter, std::shared_ptr<GlareFilter>>(module, "Filter")
      .def(py::init(&make_filter), py::arg("template"), py::arg("width"), py::arg("height"),
           py::kw_only(), py::arg("kind"), py::arg("edge"), py::arg("threads"),
           py::arg("memory_limit"))
      .def_property_readonly("kept", [](const GlareFilter& f) { return f.kernel().kept; })
      .def("apply", &apply, py::arg("picture"), py::kw_only(), py::arg("bright"),
           py::arg("strength"), py::arg("only_glare"), py::arg("threads"), py::arg("progress"));
  module.def("memory_bytes", &memory_bytes, py::arg("size"));
  module.def("find_points", &find_points, py::arg("picture"), py::kw_only(), py::arg("kind"),
             py::arg("bright"), py::arg("edge"), py::arg("threads"));
  module.def("add_points", &add_points, py::arg("picture"), py::arg("sources"), py::arg("template"),
             py::kw_only(), py::arg("kind"), py::arg("strength"), py::arg("are_new"),
             py::arg("threads"), py::arg("progress"));
}

}  // namespace glare::python
