#include "glare/io/template_file.h"

#include <OpenEXR/ImfChannelList.h>
#include <OpenEXR/ImfChromaticitiesAttribute.h>
#include <OpenEXR/ImfFloatAttribute.h>
#include <OpenEXR/ImfFrameBuffer.h>
#include <OpenEXR/ImfHeader.h>
#include <OpenEXR/ImfIO.h>
#include <OpenEXR/ImfInputFile.h>
#include <OpenEXR/ImfIntAttribute.h>
#include <OpenEXR/ImfOutputFile.h>
#include <OpenEXR/ImfStandardAttributes.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfThreading.h>
#include <OpenEXR/ImfVecAttribute.h>
#include <OpenEXR/ImfVersion.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <numbers>
#include <sstream>
#include <thread>

#include "glare/base/error.h"
#include "glare/io/atomic_file.h"

namespace glare {

namespace {

constexpr int kFormatVersion = 1;
constexpr int kLargestSide = 65535;
constexpr std::uint64_t kLargestFile_bytes = 64ull << 30;

using ChannelNames = std::array<const char*, 3>;

ChannelNames channel_names(bool xyz) {
  return xyz ? ChannelNames{"X", "Y", "Z"} : ChannelNames{"R", "G", "B"};
}

/// A file in memory, written by OpenEXR.
class MemoryOutput : public Imf::OStream {
 public:
  MemoryOutput() : Imf::OStream("memory") {}

  void write(const char* data, int count) override {
    const auto size = static_cast<std::size_t>(count);
    if (bytes_.size() < position_ + size) bytes_.resize(position_ + size);
    std::memcpy(bytes_.data() + position_, data, size);
    position_ += size;
  }
  uint64_t tellp() override { return position_; }
  void seekp(uint64_t position) override { position_ = position; }
  const std::vector<std::byte>& bytes() const { return bytes_; }

 private:
  std::vector<std::byte> bytes_;
  std::size_t position_ = 0;
};

/// A file in memory, read by OpenEXR.
class MemoryInput : public Imf::IStream {
 public:
  MemoryInput(const std::string& name, std::vector<std::byte> bytes)
      : Imf::IStream(name.c_str()), bytes_(std::move(bytes)) {}

  bool read(char* data, int count) override {
    const auto size = static_cast<std::size_t>(count);
    if (count < 0 || size > bytes_.size() - std::min(position_, bytes_.size()))
      throw InputError("", "ends too early");
    std::memcpy(data, bytes_.data() + position_, size);
    position_ += size;
    return position_ < bytes_.size();
  }
  uint64_t tellg() override { return position_; }
  void seekg(uint64_t position) override { position_ = position; }

 private:
  std::vector<std::byte> bytes_;
  std::size_t position_ = 0;
};

/// OpenEXR compresses in its own, global pool of threads; lends it some for a while.
class CompressionThreads {
 public:
  explicit CompressionThreads(int threads)
      : before_(Imf::globalThreadCount()),
        count_(threads > 0 ? threads
                           : static_cast<int>(std::max(1u, std::thread::hardware_concurrency()))) {
    if (before_ < count_) Imf::setGlobalThreadCount(count_);
  }
  ~CompressionThreads() {
    if (before_ < count_) Imf::setGlobalThreadCount(before_);
  }
  CompressionThreads(const CompressionThreads&) = delete;
  CompressionThreads& operator=(const CompressionThreads&) = delete;
  int count() const { return count_; }

 private:
  int before_;
  int count_;
};

Imath::V2f vector_of(double x, double y) {
  return {static_cast<float>(x), static_cast<float>(y)};
}

Imf::Chromaticities chromaticities_of(const RgbColorSpace& space) {
  const auto primaries = space.primaries();
  const Chromaticity white = chromaticity(space.white_xyz());
  return {vector_of(primaries[0].x, primaries[0].y), vector_of(primaries[1].x, primaries[1].y),
          vector_of(primaries[2].x, primaries[2].y), vector_of(white.x, white.y)};
}

void insert_float(Imf::Header& header, const char* name, double value) {
  header.insert(name, Imf::FloatAttribute(static_cast<float>(value)));
}

void insert_string(Imf::Header& header, const char* name, const std::string& value) {
  header.insert(name, Imf::StringAttribute(value));
}

void insert_attributes(Imf::Header& header, const GlareTemplate& t) {
  const auto center = t.center_px();
  header.insert("glare:formatVersion", Imf::IntAttribute(kFormatVersion));
  insert_float(header, "glare:pixelPitch_deg", t.pixel_pitch_deg());
  header.insert("glare:center_px", Imf::V2fAttribute(vector_of(center[0], center[1])));
  insert_string(header, "glare:colorSpace", t.color_space.name());
  insert_string(header, "glare:normalization", to_string(t.normalization));
  insert_float(header, "glare:perSteradian", t.per_steradian);
  insert_float(header, "glare:capturedEnergy", t.captured_energy);
  header.insert("glare:lampXYZ", Imf::V3fAttribute({static_cast<float>(t.lamp_xyz[0]),
                                                    static_cast<float>(t.lamp_xyz[1]),
                                                    static_cast<float>(t.lamp_xyz[2])}));
  insert_string(header, "glare:lamp", t.lamp);
  insert_string(header, "glare:observer", t.observer);
  header.insert("glare:wavelengthRange_nm",
                Imf::V2fAttribute(vector_of(t.wavelength_range_nm.lo_nm,
                                            t.wavelength_range_nm.hi_nm)));
  insert_float(header, "glare:apertureWidth_mm", t.aperture_width_mm);
  insert_float(header, "glare:apertureArea_mm2", t.aperture_area_mm2);
  insert_string(header, "glare:recipe", t.recipe);
  insert_string(header, "glare:software", t.software);
}

Imf::Header header_of(const GlareTemplate& t, Imf::PixelType pixel_type) {
  Imf::Header header(t.width(), t.height());
  header.compression() = Imf::ZIP_COMPRESSION;
  for (const char* name : channel_names(t.color_space.is_xyz()))
    header.channels().insert(name, Imf::Channel(pixel_type));
  if (!t.color_space.is_xyz()) Imf::addChromaticities(header, chromaticities_of(t.color_space));
  insert_attributes(header, t);
  return header;
}

void require_fits_half(const GlareTemplate& t) {
  for (const auto& channel : t.channels)
    for (const float value : channel.values())
      if (std::abs(value) > kLargestHalf)
        throw OptionError(
            "half precision holds values up to 65504 and this template has larger ones; normalize "
            "it to its peak or write 32-bit floating point");
}

/// A slice whose first pixel is the first of `pixels`.
template <typename T>
Imf::Slice slice_of(Imf::PixelType type, const Image<T>& pixels, const Imath::V2i& origin) {
  const auto x_stride = sizeof(T);
  const auto y_stride = sizeof(T) * static_cast<std::size_t>(pixels.width());
  auto* const first = reinterpret_cast<char*>(const_cast<T*>(pixels.values().data()));
  return Imf::Slice(type,
                    first - static_cast<std::ptrdiff_t>(x_stride) * origin.x -
                        static_cast<std::ptrdiff_t>(y_stride) * origin.y,
                    x_stride, y_stride);
}

Image<Imath::half> halves_of(const Image<float>& image) {
  Image<Imath::half> halves(image.width(), image.height());
  std::copy(image.values().begin(), image.values().end(), halves.values().begin());
  return halves;
}

std::vector<std::byte> encoded(const GlareTemplate& t, const TemplateFileOptions& options) {
  if (options.half) require_fits_half(t);
  const Imf::PixelType type = options.half ? Imf::HALF : Imf::FLOAT;
  std::array<Image<Imath::half>, 3> halves;
  Imf::FrameBuffer frame_buffer;
  const auto names = channel_names(t.color_space.is_xyz());
  for (std::size_t k = 0; k < names.size(); ++k) {
    if (options.half) halves[k] = halves_of(t.channels[k]);
    frame_buffer.insert(names[k], options.half ? slice_of(type, halves[k], {0, 0})
                                               : slice_of(type, t.channels[k], {0, 0}));
  }
  const CompressionThreads threads(options.threads);
  MemoryOutput output;
  {
    Imf::OutputFile file(output, header_of(t, type), threads.count());
    file.setFrameBuffer(frame_buffer);
    file.writePixels(t.height());
  }
  return output.bytes();
}

/// Reads typed attributes from a header; a missing one, or one of another type, is an error.
class AttributeReader {
 public:
  AttributeReader(const Imf::Header& header, const std::string& place)
      : header_(header), place_(place) {}

  template <typename Attribute>
  const auto& value(const char* name) const {
    const auto* const attribute = header_.findTypedAttribute<Attribute>(name);
    if (attribute) return attribute->value();
    throw InputError(place_, header_.find(name) == header_.end()
                                 ? std::string("is no glare template: the attribute ") + name +
                                       " is missing"
                                 : std::string("the attribute ") + name + " is of another type, " +
                                       header_[name].typeName());
  }
  double number(const char* name) const {
    const double number = value<Imf::FloatAttribute>(name);
    if (!std::isfinite(number))
      throw InputError(place_, std::string("the attribute ") + name + " isn't finite");
    return number;
  }
  double positive(const char* name) const {
    const double positive = number(name);
    if (!(positive > 0))
      throw InputError(place_, std::string("the attribute ") + name + " isn't positive");
    return positive;
  }
  const std::string& text(const char* name) const { return value<Imf::StringAttribute>(name); }
  bool has(const char* name) const { return header_.find(name) != header_.end(); }
  const Imf::ChannelList& channels() const { return header_.channels(); }
  const std::string& place() const { return place_; }

 private:
  const Imf::Header& header_;
  std::string place_;
};

RgbColorSpace color_space_of(const AttributeReader& reader) {
  const std::string& name = reader.text("glare:colorSpace");
  if (reader.channels().findChannel("X")) return {name, identity_matrix()};
  const auto& c = reader.value<Imf::ChromaticitiesAttribute>("chromaticities");
  try {
    return {name,
            {{{c.red.x, c.red.y}, {c.green.x, c.green.y}, {c.blue.x, c.blue.y}}},
            xyz_from_chromaticity({c.white.x, c.white.y})};
  } catch (const InputError& error) {
    throw InputError(reader.place(), std::string("the attribute chromaticities: ") + error.what());
  }
}

GlareTemplate template_without_pixels(const AttributeReader& reader) {
  if (const int version = reader.value<Imf::IntAttribute>("glare:formatVersion");
      version != kFormatVersion)
    throw InputError(reader.place(), "has glare:formatVersion " + std::to_string(version) +
                                         "; this program reads version 1");
  GlareTemplate t;
  t.color_space = color_space_of(reader);
  t.pixel_pitch_rad = reader.positive("glare:pixelPitch_deg") * std::numbers::pi / 180;
  t.normalization = normalization_from(reader.text("glare:normalization"));
  t.per_steradian = reader.positive("glare:perSteradian");
  t.captured_energy = reader.number("glare:capturedEnergy");
  const auto& lamp_xyz = reader.value<Imf::V3fAttribute>("glare:lampXYZ");
  t.lamp_xyz = {lamp_xyz.x, lamp_xyz.y, lamp_xyz.z};
  t.lamp = reader.text("glare:lamp");
  t.observer = reader.text("glare:observer");
  const auto& range = reader.value<Imf::V2fAttribute>("glare:wavelengthRange_nm");
  t.wavelength_range_nm = {range.x, range.y};
  t.aperture_width_mm = reader.positive("glare:apertureWidth_mm");
  t.aperture_area_mm2 = reader.positive("glare:apertureArea_mm2");
  t.recipe = reader.text("glare:recipe");
  t.software = reader.text("glare:software");
  return t;
}

Imath::V2i size_of(const Imath::Box2i& window, const std::string& place) {
  const std::int64_t width = std::int64_t{window.max.x} - window.min.x + 1;
  const std::int64_t height = std::int64_t{window.max.y} - window.min.y + 1;
  if (width < 1 || height < 1 || width > kLargestSide || height > kLargestSide)
    throw InputError(place, "has a data window of an absurd size");
  return {static_cast<int>(width), static_cast<int>(height)};
}

void require_center(const AttributeReader& reader, const GlareTemplate& t) {
  const auto& center = reader.value<Imf::V2fAttribute>("glare:center_px");
  const auto expected = t.center_px();
  if (center.x != static_cast<float>(expected[0]) || center.y != static_cast<float>(expected[1]))
    throw InputError(reader.place(), "glare:center_px isn't (width / 2, height / 2)");
}

void read_pixels(Imf::InputFile& file, GlareTemplate& t, const std::string& place) {
  const Imath::Box2i window = file.header().dataWindow();
  const Imath::V2i size = size_of(window, place);
  Imf::FrameBuffer frame_buffer;
  const auto names = channel_names(t.color_space.is_xyz());
  for (std::size_t k = 0; k < names.size(); ++k) {
    const Imf::Channel* const channel = file.header().channels().findChannel(names[k]);
    if (!channel) throw InputError(place, std::string("has no channel ") + names[k]);
    if (channel->xSampling != 1 || channel->ySampling != 1)
      throw InputError(place, std::string("has a subsampled channel ") + names[k]);
    t.channels[k] = Image<float>(size.x, size.y);
    frame_buffer.insert(names[k], slice_of(Imf::FLOAT, t.channels[k], window.min));
  }
  file.setFrameBuffer(frame_buffer);
  file.readPixels(window.min.y, window.max.y);
}

void require_openexr(const std::vector<std::byte>& bytes, const std::string& place) {
  if (bytes.size() < 8 || !Imf::isImfMagic(reinterpret_cast<const char*>(bytes.data())))
    throw InputError(place, "is not an OpenEXR file");
}

/// Opens an OpenEXR file and hands it on; OpenEXR's exceptions become `InputError`.
template <typename Use>
auto with_openexr(const std::filesystem::path& path, const Use& use) {
  const std::string place = path.string();
  auto bytes = read_file(path, kLargestFile_bytes);
  require_openexr(bytes, place);
  try {
    MemoryInput input(place, std::move(bytes));
    Imf::InputFile file(input);
    return use(file);
  } catch (const InputError& error) {
    if (!error.place().empty()) throw;
    throw InputError(place, error.what());
  } catch (const Error& error) {
    throw InputError(place, error.what());
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    throw InputError(place, std::string("can't be read as OpenEXR: ") + error.what());
  }
}

std::string text_of_pixel_type(Imf::PixelType type) {
  return type == Imf::HALF ? "half" : type == Imf::FLOAT ? "float" : "uint";
}

template <typename Vector>
std::string joined(const Vector& vector, unsigned int count) {
  std::ostringstream text;
  text.precision(9);
  for (unsigned int i = 0; i < count; ++i) text << (i ? " " : "") << vector[static_cast<int>(i)];
  return text.str();
}

std::string number_text(double number) {
  std::ostringstream text;
  text.precision(9);
  text << number;
  return text.str();
}

/// The value of an attribute as text; empty for types that are not written out.
std::string text_of(const Imf::Attribute& attribute) {
  if (const auto* a = dynamic_cast<const Imf::StringAttribute*>(&attribute)) return a->value();
  if (const auto* a = dynamic_cast<const Imf::FloatAttribute*>(&attribute))
    return number_text(a->value());
  if (const auto* a = dynamic_cast<const Imf::IntAttribute*>(&attribute))
    return std::to_string(a->value());
  if (const auto* a = dynamic_cast<const Imf::V2fAttribute*>(&attribute))
    return joined(a->value(), 2);
  if (const auto* a = dynamic_cast<const Imf::V3fAttribute*>(&attribute))
    return joined(a->value(), 3);
  if (const auto* a = dynamic_cast<const Imf::ChromaticitiesAttribute*>(&attribute)) {
    const Imf::Chromaticities& c = a->value();
    return joined(c.red, 2) + " " + joined(c.green, 2) + " " + joined(c.blue, 2) + " " +
           joined(c.white, 2);
  }
  return "";
}

}  // namespace

void write_template(const std::filesystem::path& path, const GlareTemplate& glare_template,
                    const TemplateFileOptions& options) {
  std::vector<std::byte> bytes;
  try {
    bytes = encoded(glare_template, options);
  } catch (const Error&) {
    throw;
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception& error) {
    throw OutputError(path.string(), std::string("can't be encoded: ") + error.what());
  }
  write_file_atomically(path, bytes, options.keep_going);
}

GlareTemplate read_template(const std::filesystem::path& path) {
  return with_openexr(path, [&](Imf::InputFile& file) {
    const AttributeReader reader(file.header(), path.string());
    GlareTemplate t = template_without_pixels(reader);
    read_pixels(file, t, path.string());
    require_center(reader, t);
    return t;
  });
}

std::vector<HeaderAttribute> read_header(const std::filesystem::path& path) {
  return with_openexr(path, [&](Imf::InputFile& file) {
    std::vector<HeaderAttribute> result;
    const Imf::Header& header = file.header();
    for (auto a = header.begin(); a != header.end(); ++a)
      result.push_back({a.name(), a.attribute().typeName(), text_of(a.attribute())});
    for (auto c = header.channels().begin(); c != header.channels().end(); ++c)
      result.push_back({std::string("channel ") + c.name(), "chlist",
                        text_of_pixel_type(c.channel().type)});
    return result;
  });
}

}  // namespace glare
