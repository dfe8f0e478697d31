#include "glare/io/openexr/attribute_text.h"

#include <OpenEXR/ImfBoxAttribute.h>
#include <OpenEXR/ImfChannelListAttribute.h>
#include <OpenEXR/ImfChromaticitiesAttribute.h>
#include <OpenEXR/ImfCompressionAttribute.h>
#include <OpenEXR/ImfDoubleAttribute.h>
#include <OpenEXR/ImfEnvmapAttribute.h>
#include <OpenEXR/ImfFloatAttribute.h>
#include <OpenEXR/ImfFloatVectorAttribute.h>
#include <OpenEXR/ImfIntAttribute.h>
#include <OpenEXR/ImfLineOrderAttribute.h>
#include <OpenEXR/ImfMatrixAttribute.h>
#include <OpenEXR/ImfRationalAttribute.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfStringVectorAttribute.h>
#include <OpenEXR/ImfTileDescriptionAttribute.h>
#include <OpenEXR/ImfTimeCodeAttribute.h>
#include <OpenEXR/ImfVecAttribute.h>
#include <OpenEXR/ImfVersion.h>

#include <charconv>
#include <concepts>
#include <initializer_list>
#include <iterator>
#include <span>
#include <type_traits>

#include "glare/io/openexr/memory_stream.h"

namespace glare::openexr_io {

namespace {

template <typename Number>
requires std::integral<Number> || std::floating_point<Number> std::string text_of(Number number) {
  char text[32];
  return {text, std::to_chars(text, text + sizeof text, number).ptr};
}

template <typename Number>
std::string text_of(std::span<const Number> numbers) {
  std::string text;
  for (const Number& number : numbers) text.append(text.empty() ? "" : " ").append(text_of(number));
  return text;
}

template <typename Number>
std::string text_of(const Imath::Vec2<Number>& v) {
  return text_of(v.x) + " " + text_of(v.y);
}

template <typename Number>
std::string text_of(const Imath::Vec3<Number>& v) {
  return text_of(v.x) + " " + text_of(v.y) + " " + text_of(v.z);
}

template <typename Number>
std::string text_of(const Imath::Matrix33<Number>& m) {
  return text_of(std::span<const Number>(m.getValue(), 9));
}

template <typename Number>
std::string text_of(const Imath::Matrix44<Number>& m) {
  return text_of(std::span<const Number>(m.getValue(), 16));
}

template <typename Corner>
std::string text_of(const Imath::Box<Corner>& box) {
  return text_of(box.min) + " " + text_of(box.max);
}

std::string text_of(const Imf::FloatVector& numbers) {
  return text_of(std::span<const float>(numbers));
}

std::string text_of(const std::string& text) { return text; }

std::string text_of(const Imf::StringVector& texts) {
  std::string joined;
  for (const std::string& text : texts)
    joined.append(&text == &texts.front() ? "" : ", ").append(text);
  return joined;
}

std::string text_of(const Imf::Chromaticities& c) {
  return text_of(c.red) + " " + text_of(c.green) + " " + text_of(c.blue) + " " + text_of(c.white);
}

std::string text_of(const Imf::Rational& r) { return text_of(r.n) + "/" + text_of(r.d); }

std::string text_of(const Imf::ChannelList& channels) {
  std::string text;
  for (auto c = channels.begin(); c != channels.end(); ++c)
    text.append(text.empty() ? "" : ", ")
        .append(c.name())
        .append(" ")
        .append(openexr_io::text_of(c.channel().type));
  return text;
}

/// The name of an enumeration's value, or its number where it has none.
std::string name_of(int value, std::initializer_list<const char*> names) {
  const auto known = value >= 0 && static_cast<std::size_t>(value) < names.size();
  return known ? std::data(names)[value] : text_of(value);
}

std::string text_of(Imf::Compression compression) {
  return name_of(compression,
                 {"none", "rle", "zips", "zip", "piz", "pxr24", "b44", "b44a", "dwaa", "dwab"});
}

std::string text_of(Imf::LineOrder order) {
  return name_of(order, {"increasing y", "decreasing y", "random y"});
}

std::string text_of(Imf::Envmap map) { return name_of(map, {"latlong", "cube"}); }

std::string text_of(const Imf::TileDescription& tiles) {
  return text_of(tiles.xSize) + " x " + text_of(tiles.ySize) + ", " +
         name_of(tiles.mode, {"one level", "mipmap", "ripmap"}) + ", " +
         name_of(tiles.roundingMode, {"rounded down", "rounded up"});
}

/// Hours, minutes, seconds and frame, each of two digits.
std::string text_of(const Imf::TimeCode& time) {
  std::string text;
  for (const int part : {time.hours(), time.minutes(), time.seconds(), time.frame()})
    text.append(text.empty() ? "" : ":").append(part < 10 ? "0" : "").append(text_of(part));
  return text;
}

/// For all other types.
std::string size_text(const Imf::Attribute& attribute) {
  MemoryOutput value;
  attribute.writeValueTo(value, Imf::EXR_VERSION);
  return std::string("(").append(text_of(value.size())).append(" bytes)");
}

template <typename... Values>
std::string text_as_one_of(const Imf::Attribute& attribute) {
  std::string text;
  const auto is_this = [&]<typename Value>(std::type_identity<Value>) {
    const auto* const typed = dynamic_cast<const Imf::TypedAttribute<Value>*>(&attribute);
    if (typed) text = text_of(typed->value());
    return typed != nullptr;
  };
  return (is_this(std::type_identity<Values>{}) || ...) ? text : size_text(attribute);
}

}  // namespace

std::string text_of(Imf::PixelType type) { return name_of(type, {"uint", "half", "float"}); }

std::string text_of(const Imf::Attribute& attribute) {
  return text_as_one_of<
      int, float, double, std::string, Imath::V2i, Imath::V2f, Imath::V2d, Imath::V3i, Imath::V3f,
      Imath::V3d, Imath::M33f, Imath::M33d, Imath::M44f, Imath::M44d, Imath::Box2i, Imath::Box2f,
      Imf::ChannelList, Imf::Chromaticities, Imf::Compression, Imf::Envmap, Imf::FloatVector,
      Imf::LineOrder, Imf::Rational, Imf::StringVector, Imf::TileDescription, Imf::TimeCode>(
      attribute);
}

}  // namespace glare::openexr_io
