// Makes the OpenEXR files named in README.md, in the current folder. Not part of the build:
//   c++ -std=c++20 make_exr_samples.cpp $(pkg-config --cflags --libs OpenEXR) -o make_exr_samples
#include <ImfChannelList.h>
#include <ImfDeepFrameBuffer.h>
#include <ImfDeepScanLineOutputPart.h>
#include <ImfDoubleAttribute.h>
#include <ImfFloatAttribute.h>
#include <ImfFloatVectorAttribute.h>
#include <ImfIntAttribute.h>
#include <ImfMultiPartOutputFile.h>
#include <ImfOutputFile.h>
#include <ImfOutputPart.h>
#include <ImfPartType.h>
#include <ImfPreviewImage.h>
#include <ImfStandardAttributes.h>
#include <ImfTiledOutputFile.h>
#include <ImfTiledOutputPart.h>

#include <cmath>
#include <list>
#include <string>
#include <vector>

using Imath::Box2i, Imath::V2f, Imath::V2i, Imath::half;

struct Channel {
  std::string name;
  Imf::PixelType type;
  int x_sampling = 1, y_sampling = 1;
};

const Box2i kDisplay(V2i(0, 0), V2i(9, 7)), kOverscan(V2i(-4, -2), V2i(11, 9)),
    kCrop(V2i(2, 3), V2i(8, 6));
const std::vector<Channel> kChannels = {{"R", Imf::HALF},          {"G", Imf::HALF},
                                        {"B", Imf::FLOAT},         {"A", Imf::HALF},
                                        {"Z", Imf::FLOAT},         {"id", Imf::UINT},
                                        {"diffuse.R", Imf::FLOAT}, {"diffuse.G", Imf::FLOAT},
                                        {"diffuse.B", Imf::HALF},  {"right.R", Imf::HALF}};

/// Channels of a picture: smooth values, of another height each.
struct Pixels {
  std::list<std::vector<char>> bytes;
  Imf::FrameBuffer slices;

  Pixels(const std::vector<Channel>& channels, const Box2i& window) {
    float height = 0.5f;
    for (const Channel& c : channels) {
      const int step = c.type == Imf::HALF ? 2 : 4;
      const int width = (window.max.x - window.min.x + 1) / c.x_sampling + 1;
      const int rows = (window.max.y - window.min.y + 1) / c.y_sampling + 1;
      char* const first = bytes.emplace_back(width * rows * step).data();
      height *= 1.5f;
      for (int i = 0; i < width * rows; ++i) {
        const float value = height * (1.5f + std::sin(0.13f * i));
        if (c.type == Imf::HALF) reinterpret_cast<half*>(first)[i] = value;
        if (c.type == Imf::FLOAT) reinterpret_cast<float*>(first)[i] = value;
        if (c.type == Imf::UINT) reinterpret_cast<unsigned*>(first)[i] = 4000000000u + i;
      }
      slices.insert(c.name, Imf::Slice(c.type,
                                       first - window.min.x / c.x_sampling * step -
                                           window.min.y / c.y_sampling * width * step,
                                       step, width * step, c.x_sampling, c.y_sampling));
    }
  }
};

Imf::Header header_of(const Box2i& window, const std::vector<Channel>& channels,
                      Imf::Compression compression, Imf::LineOrder order = Imf::INCREASING_Y) {
  Imf::Header h(kDisplay, window, 1.25f, V2f(0.1f, 0.2f), 1, order, compression);
  for (const Channel& c : channels)
    h.channels().insert(c.name, Imf::Channel(c.type, c.x_sampling, c.y_sampling, c.name == "G"));
  return h;
}

void add_attributes(Imf::Header& h) {
  addComments(h, "a comment");
  addKeyCode(h, Imf::KeyCode(1, 2, 3, 4, 5, 6, 20));
  addTimeCode(h, Imf::TimeCode(1, 2, 3, 4));
  addFramesPerSecond(h, Imf::Rational(24000, 1001));
  addMultiView(h, {"left", "right"});
  addWhiteLuminance(h, 100);
  h.insert("double", Imf::DoubleAttribute(3.25));
  h.insert("floats", Imf::FloatVectorAttribute({1, 2, 3}));
  h.insert("box2f", Imf::Box2fAttribute({{1, 2}, {3, 4}}));
  h.insert("m33f", Imf::M33fAttribute(Imath::M33f()));
  h.insert("m44d", Imf::M44dAttribute(Imath::M44d()));
  h.insert("v3i", Imf::V3iAttribute({1, 2, 3}));
  h.insert("v3d", Imf::V3dAttribute({1, 2, 3}));
  h.insert("a_name_of_more_than_thirty_one_characters", Imf::IntAttribute(7));
  const Imf::PreviewRgba preview[6] = {};
  h.setPreviewImage(Imf::PreviewImage(3, 2, preview));
}

void write_rows(const char* path, Imf::Header h, const std::vector<Channel>& channels) {
  const Box2i w = h.dataWindow();
  Pixels pixels(channels, w);
  Imf::OutputFile file(path, h);
  file.setFrameBuffer(pixels.slices);
  file.writePixels(w.max.y - w.min.y + 1);
}

void write_tiles(const char* path, Imf::Header h, Imf::LevelMode mode) {
  h.setTileDescription({8, 4, mode});
  Pixels pixels(kChannels, {{0, 0}, {20, 20}});
  Imf::TiledOutputFile file(path, h);
  file.setFrameBuffer(pixels.slices);
  for (int l = 0; l < file.numLevels(); ++l)
    file.writeTiles(0, file.numXTiles(l) - 1, 0, file.numYTiles(l) - 1, l);
}

void write_deep(Imf::MultiPartOutputFile& file, int part) {
  Imf::DeepScanLineOutputPart output(file, part);
  const int width = kCrop.max.x - kCrop.min.x + 1, rows = kCrop.max.y - kCrop.min.y + 1;
  const int count = width * rows, before = kCrop.min.x + kCrop.min.y * width;
  std::vector<unsigned> samples(count, 2);
  std::vector<float> depths(2 * count, 1.5f);
  std::vector<char*> places(count);
  for (int i = 0; i < count; ++i) places[i] = reinterpret_cast<char*>(&depths[2 * i]);
  Imf::DeepFrameBuffer slices;
  slices.insertSampleCountSlice(
      Imf::Slice(Imf::UINT, reinterpret_cast<char*>(samples.data() - before), 4, 4 * width));
  slices.insert("Z", Imf::DeepSlice(Imf::FLOAT, reinterpret_cast<char*>(places.data() - before), 8,
                                    8 * width, 4));
  output.setFrameBuffer(slices);
  output.writePixels(rows);
}

void write_parts() {
  std::vector<Imf::Header> headers = {header_of(kOverscan, kChannels, Imf::NO_COMPRESSION),
                                      header_of(kCrop, kChannels, Imf::NO_COMPRESSION),
                                      header_of(kCrop, {{"Z", Imf::FLOAT}}, Imf::ZIPS_COMPRESSION),
                                      header_of(kOverscan, kChannels, Imf::DWAB_COMPRESSION)};
  const char* const names[] = {"rows", "tiles", "deep", "lossy"};
  const std::string types[] = {Imf::SCANLINEIMAGE, Imf::TILEDIMAGE, Imf::DEEPSCANLINE,
                               Imf::SCANLINEIMAGE};
  for (int i = 0; i < 4; ++i) headers[i].setName(names[i]), headers[i].setType(types[i]);
  headers[0].setView("left"), headers[1].setView("right");
  headers[1].setTileDescription({4, 4});
  Imf::MultiPartOutputFile file("kept_parts.exr", headers.data(), 4);
  Pixels overscan(kChannels, kOverscan), crop(kChannels, kCrop);
  Imf::OutputPart rows(file, 0), lossy(file, 3);
  rows.setFrameBuffer(overscan.slices), rows.writePixels(12);
  Imf::TiledOutputPart tiles(file, 1);
  tiles.setFrameBuffer(crop.slices);
  tiles.writeTiles(0, tiles.numXTiles() - 1, 0, tiles.numYTiles() - 1);
  write_deep(file, 2);
  lossy.setFrameBuffer(overscan.slices), lossy.writePixels(12);
}

int main() {
  std::vector<Channel> subsampled = kChannels;
  subsampled.push_back({"quarter", Imf::HALF, 2, 2});
  Imf::Header rows = header_of(kOverscan, subsampled, Imf::NO_COMPRESSION);
  add_attributes(rows);
  write_rows("kept_rows.exr", rows, subsampled);
  write_rows("kept_upwards_zip.exr",
             header_of(kOverscan, kChannels, Imf::ZIP_COMPRESSION, Imf::DECREASING_Y), kChannels);
  Imf::Header lossy = header_of(kOverscan, kChannels, Imf::DWAA_COMPRESSION);
  lossy.insert("dwaCompressionLevel", Imf::FloatAttribute(20));
  write_rows("kept_dwaa.exr", lossy, kChannels);
  write_rows("kept_b44.exr", header_of(kCrop, kChannels, Imf::B44_COMPRESSION), kChannels);
  write_rows("kept_pxr24.exr", header_of(kCrop, kChannels, Imf::PXR24_COMPRESSION), kChannels);
  write_tiles("kept_tiles.exr", header_of(kCrop, kChannels, Imf::NO_COMPRESSION), Imf::ONE_LEVEL);
  write_tiles("kept_tiles_piz.exr",
              header_of(kCrop, kChannels, Imf::PIZ_COMPRESSION, Imf::RANDOM_Y), Imf::ONE_LEVEL);
  write_tiles("kept_mipmap.exr", header_of(kCrop, kChannels, Imf::ZIP_COMPRESSION),
              Imf::MIPMAP_LEVELS);
  write_parts();
}
