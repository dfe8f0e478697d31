// The library's exceptions as Python's.

#include <regex>
#include <string>

#include "bindings.h"
#include "glare/base/error.h"

namespace glare::python {

namespace py = pybind11;

namespace {

/// Kept for the whole life of the process, as the exceptions of extension modules are.
struct ErrorTypes {
  PyObject *error, *input, *option, *output, *memory, *cancelled;
};
ErrorTypes types;

PyObject* add_error(py::module_& module, const char* name, const char* meaning,
                    const py::tuple& bases) {
  const std::string whole_name = std::string("glare.") + name;
  PyObject* const type =
      PyErr_NewExceptionWithDoc(whole_name.c_str(), meaning, bases.ptr(), nullptr);
  if (type == nullptr) throw py::error_already_set();
  module.attr(name) = py::handle(type);
  return type;
}

/// The command's options, "--width-mm", as the keywords they are here.
std::string with_keywords(const std::string& message) {
  static const std::regex option("(^|[ (])--([a-z][a-z0-9-]*)");
  std::string result;
  auto rest = message.cbegin();
  for (std::sregex_iterator match(message.begin(), message.end(), option), end; match != end;
       ++match) {
    std::string name = (*match)[2];
    for (char& c : name)
      if (c == '-') c = '_';
    result.append(rest, (*match)[0].first).append((*match)[1]).append(name);
    rest = (*match)[0].second;
  }
  return result.append(rest, message.cend());
}

void translate(std::exception_ptr thrown) {
  try {
    if (thrown) std::rethrow_exception(thrown);
  } catch (const OptionError& error) {
    PyErr_SetString(types.option, with_keywords(error.what()).c_str());
  } catch (const InputError& error) {
    PyErr_SetString(types.input, error.what());
  } catch (const OutputError& error) {
    PyErr_SetString(types.output, error.what());
  } catch (const MemoryError& error) {
    PyErr_SetString(types.memory, error.what());
  } catch (const Cancelled& error) {
    PyErr_SetString(types.cancelled, error.what());
  } catch (const Error& error) {
    PyErr_SetString(types.error, error.what());
  }
}

}  // namespace

void add_errors(py::module_& module) {
  const auto with = [](PyObject* base, PyObject* other) {
    return py::make_tuple(py::handle(base), py::handle(other));
  };
  types.error = add_error(module, "Error", "Base of every exception that Glare raises.",
                          py::make_tuple(py::handle(PyExc_Exception)));
  types.input =
      add_error(module, "InputError", "An input can't be read or isn't what it should be.",
                with(types.error, PyExc_ValueError));
  types.option = add_error(module, "OptionError",
                           "An option's value is out of range, unknown, or contradicts another.",
                           with(types.error, PyExc_ValueError));
  types.output = add_error(module, "OutputError", "A file can't be written.",
                           with(types.error, PyExc_OSError));
  types.memory = add_error(module, "MemoryLimitError",
                           "More memory would be needed than is allowed; nothing was done.",
                           with(types.error, PyExc_MemoryError));
  types.cancelled = add_error(module, "Cancelled", "The progress callback returned False.",
                              py::make_tuple(py::handle(types.error)));
  py::register_exception_translator(&translate);
}

}  // namespace glare::python
