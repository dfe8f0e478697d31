#include "template_object.h"

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace glare::python {

namespace py = pybind11;

namespace {

void forbid_writing(py::array& array) { array.attr("setflags")(py::arg("write") = false); }

}  // namespace

TemplateObject::TemplateObject(GlareTemplate made)
    : facts_(std::move(made)),
      planes_(std::vector<py::ssize_t>{3, facts_.height(), facts_.width()}) {
  for (std::size_t k = 0; k < 3; ++k) {
    const auto values = facts_.channels[k].values();
    std::copy(values.begin(), values.end(),
              planes_.mutable_data(static_cast<py::ssize_t>(k), 0, 0));
    facts_.channels[k] = {};
  }
  forbid_writing(planes_);
}

py::array TemplateObject::rgb() const {
  const auto stride = [this](int axis) { return planes_.strides(axis); };
  py::array view(py::dtype::of<float>(), {planes_.shape(1), planes_.shape(2), planes_.shape(0)},
                 {stride(1), stride(2), stride(0)}, planes_.data(), planes_);
  forbid_writing(view);
  return view;
}

py::array_t<float> TemplateObject::luminance() const {
  const Vector3& weights = facts_.color_space.xyz_from_rgb()[1];
  py::array_t<float> result(std::vector<py::ssize_t>{height(), width()});
  const std::size_t count = static_cast<std::size_t>(result.size());
  const float* const planes = planes_.data();
  for (std::size_t i = 0; i < count; ++i)
    result.mutable_data()[i] =
        static_cast<float>(weights[0] * planes[i] + weights[1] * planes[count + i] +
                           weights[2] * planes[2 * count + i]);
  return result;
}

GlareTemplate TemplateObject::whole() const {
  GlareTemplate result = facts_;
  const std::size_t count = static_cast<std::size_t>(width()) * static_cast<std::size_t>(height());
  const float* plane = planes_.data();
  for (Image<float>& channel : result.channels) {
    channel = Image<float>::uninitialized(width(), height());
    std::copy(plane, plane + count, channel.values().begin());
    plane += count;
  }
  return result;
}

}  // namespace glare::python
