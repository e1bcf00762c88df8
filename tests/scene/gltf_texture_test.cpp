#include <zlib.h>

#include <filesystem>
#include <numbers>

#include "gltf_builder.hpp"
#include "reader_tools.hpp"

namespace ligne {
namespace {

using gltf_test::Builder;
using gltf_test::json;

using Rgb = std::array<std::uint8_t, 3>;
constexpr Rgb kRed{200, 0, 0}, kGreen{0, 200, 0}, kBlue{0, 0, 200}, kGrey{100, 100, 100};

/// A picture whose colours a function of the column and row gives. `shown_size` is the size in its header.
template <class ColorAt>
std::vector<std::uint8_t> png(std::uint32_t size, const ColorAt& color_at, std::uint32_t shown_size) {
  std::string rows;
  for (std::uint32_t y = 0; y < size; ++y) {
    rows += '\0';
    for (std::uint32_t x = 0; x < size; ++x) {
      for (const std::uint8_t sample : color_at(x, y)) rows += static_cast<char>(sample);
    }
  }
  uLongf packed = compressBound(rows.size());
  std::string data(packed, '\0');
  compress(reinterpret_cast<Bytef*>(data.data()), &packed, reinterpret_cast<const Bytef*>(rows.data()), rows.size());
  data.resize(packed);
  const auto word = [](std::size_t w) {
    std::string out;
    for (int shift = 24; shift >= 0; shift -= 8) out += static_cast<char>(w >> shift & 0xff);
    return out;
  };
  const auto chunk = [&](std::string text) {
    const std::size_t length = text.size() - 4;
    const uLong crc = crc32(0, reinterpret_cast<const Bytef*>(text.data()), static_cast<uInt>(text.size()));
    return word(length) + text + word(crc);
  };
  const std::string file = "\x89PNG\r\n\x1a\n" +
                           chunk("IHDR" + word(shown_size) + word(shown_size) + "\x08\x02" + std::string(3, '\0')) +
                           chunk("IDAT" + data) + chunk("IEND");
  return {file.begin(), file.end()};
}

/// Quarters of four colours.
std::vector<std::uint8_t> quarters(std::uint32_t shown_size = 8) {
  const Rgb colors[] = {kRed, kGreen, kBlue, kGrey};
  return png(
      8, [&](std::uint32_t x, std::uint32_t y) { return colors[x / 4 + y / 4 * 2]; }, shown_size);
}

/// Triangles with texture coordinates, and a texture without an image.
Builder textured(const std::vector<float>& at) {
  Builder b;
  std::vector<float> positions;
  for (std::size_t i = 0; i < at.size() / 2; ++i) {
    const auto k = static_cast<float>(i);
    positions.insert(positions.end(), {k, i % 3 == 1 ? 1.f : 0.f, i % 3 == 2 ? 1.f : 0.f});
  }
  json& primitive = b.mesh(b.accessor(positions, 3), -1);
  primitive["attributes"]["TEXCOORD_0"] = b.accessor(at, 2);
  primitive["material"] = 0;
  b.root["accessors"].back()["type"] = "VEC2";
  b.root["textures"] = {{{"source", 0}, {"sampler", 0}}};
  b.root["samplers"] = {json::object()};
  b.root["materials"] = {{{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", 0}}}}}}};
  return b;
}

Builder with_data(Builder b, const std::vector<std::uint8_t>& picture) {
  b.root["images"] = {{{"uri", "data:image/png;base64," + gltf_test::base64(picture)}}};
  return b;
}

reader_test::Result read(const std::string& text, bool binary = false, const std::filesystem::path& folder = {}) {
  reader_test::Result out;
  out.scene = read_gltf({{reader_test::bytes_of(text), "M", folder}, out.report, out.warnings}, binary);
  return out;
}

/// Colour of a face, of 255.
Point3 color_of(const Scene& scene, std::size_t face) {
  return scene.materials[scene.face_material.empty() ? 0 : scene.face_material[face]].color * 255.0;
}

void expect_color(const Point3& found, const Point3& expected) {
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(found[k], expected[k], 1e-9) << k;
}

void expect_color(const Point3& found, const Rgb& c) { expect_color(found, Point3(c[0], c[1], c[2])); }

/// A triangle that points at one place.
std::vector<float> at_place(float u, float v) { return {u, v, u, v, u, v}; }

TEST(GltfPalettes, PatchesAndGradients) {
  // A blue patch beside a gradient that begins with its colour.
  const auto picture = png(
      16,
      [](std::uint32_t x, std::uint32_t y) {
        return Rgb{0, 0, static_cast<std::uint8_t>(x < 8 ? 200 : 200 - 6 * y)};
      },
      16);
  Builder b =
      textured({0.1f, 0.1f, 0.4f, 0.1f, 0.1f, 0.9f, 0.6f, 0.f, 0.9f, 0.f, 0.75f, 1.f, 0.7f, 0.9f, 0.7f, 0.9f, 0.7f, 0.9f});
  b.root["materials"][0]["pbrMetallicRoughness"]["baseColorFactor"] = {1, 1, 0.5, 1};
  const reader_test::Result found = read(with_data(b, picture).text());
  EXPECT_EQ(found.scene.materials.size(), 2u);
  expect_color(color_of(found.scene, 0), Point3(0, 0, 100));
  // All of the gradient is one part.
  EXPECT_EQ(found.scene.face_material[1], found.scene.face_material[2]);
  EXPECT_LT(color_of(found.scene, 1).z, 90);
  EXPECT_GT(color_of(found.scene, 1).z, 55);
  EXPECT_EQ(found.warnings.left_out().of("textures"), 0u);
}

TEST(GltfPalettes, TexelsThatVaryGiveNothing) {
  const auto board = png(
      64, [](std::uint32_t x, std::uint32_t y) { return (x / 8 + y / 8) % 2 ? kRed : kBlue; }, 64);
  Builder b = textured({0, 0, 1, 0, 1, 1, 0, 0, 1, 1, 0, 1});
  const reader_test::Result found = read(with_data(b, board).text());
  EXPECT_EQ(found.scene.materials.size(), 1u);
  EXPECT_TRUE(found.scene.face_material.empty());
  expect_color(color_of(found.scene, 0), Point3(255));
  EXPECT_EQ(found.warnings.left_out().of("textures"), 1u);
}

TEST(GltfPalettes, WrappedCoordinates) {
  constexpr int kRepeat = 10497, kClamp = 33071, kMirror = 33648;
  const std::tuple<int, float, Rgb> cases[] = {{kRepeat, 1.1f, kRed}, {kRepeat, -0.1f, kGreen}, {kClamp, 1.1f, kGreen},
                                               {kClamp, -3.f, kRed},  {kMirror, 1.1f, kGreen},  {kMirror, -0.1f, kRed},
                                               {kMirror, 2.1f, kRed}, {kRepeat, 1e6f, kRed},    {kMirror, -0.9f, kGreen}};
  for (const auto& [wrap, u, color] : cases) {
    Builder b = textured(at_place(u, 0.1f));
    b.root["samplers"][0]["wrapS"] = wrap;
    expect_color(color_of(read(with_data(b, quarters()).text()).scene, 0), color);
  }
}

TEST(GltfPalettes, TransformedCoordinates) {
  // A quarter turn takes (u, v) to (v, -u); scales come before, offsets behind it.
  const std::tuple<json, Rgb> cases[] = {{{{"offset", {0.5, 0}}}, kGreen},
                                         {{{"scale", {1, 6}}}, kBlue},
                                         {{{"rotation", std::numbers::pi / 2}}, kBlue},
                                         {{{"rotation", std::numbers::pi / 2}, {"scale", {1, 6}}}, kGrey},
                                         {{{"texCoord", 1}}, Rgb{255, 255, 255}},
                                         {{{"scale", {1}}}, Rgb{255, 255, 255}}};
  for (const auto& [transform, color] : cases) {
    Builder b = textured(at_place(0.1f, 0.1f));
    b.root["materials"][0]["pbrMetallicRoughness"]["baseColorTexture"]["extensions"]["KHR_texture_transform"] = transform;
    expect_color(color_of(read(with_data(b, quarters()).text()).scene, 0), color);
  }
}

TEST(GltfPalettes, ImagesInBuffersAndFiles) {
  Builder b = textured(at_place(0.9f, 0.9f));
  b.root["images"] = {{{"bufferView", b.view(quarters())}, {"mimeType", "image/png"}}};
  expect_color(color_of(read(b.glb(), true).scene, 0), kGrey);

  const test::TemporaryFolder outer;
  const std::filesystem::path folder = outer / "model";
  std::filesystem::create_directories(folder);
  const auto picture = quarters();
  for (const char* const name : {"model/a b.png", "outside.png"})
    outer.write(name, std::string(picture.begin(), picture.end()));
  for (const auto& [uri, color] : {std::pair("a%20b.png", kGrey),
                                   {"../outside.png", {255, 255, 255}},
                                   {"absent.png", {255, 255, 255}},
                                   {"", {255, 255, 255}}}) {
    b.root["images"] = {{{"uri", uri}}};
    expect_color(color_of(read(b.glb(), true, folder).scene, 0), color);
  }
}

TEST(GltfPalettes, DamagedPictures) {
  Builder b = textured(at_place(0.9f, 0.9f));
  const auto color = [&](const std::vector<std::uint8_t>& picture) {
    return color_of(read(with_data(b, picture).text()).scene, 0);
  };
  const std::vector<std::uint8_t> good = quarters();
  expect_color(color(good), kGrey);
  for (std::size_t n = 0; n + 16 < good.size(); ++n)
    expect_color(color({good.begin(), good.begin() + std::ptrdiff_t(n)}), Point3(255));
  for (const std::uint32_t size : {0u, 9u, 60000u, 0x7fffffffu, 0xffffffffu})
    expect_color(color(quarters(size)), Point3(255));
  for (std::size_t n = 0; n < 8 * good.size(); ++n) {
    std::vector<std::uint8_t> bad = good;
    bad[n / 8] ^= static_cast<std::uint8_t>(1 << n % 8);
    color(bad);
  }
  for (const float far : {1e7f, -1e30f}) {
    expect_color(color_of(read(with_data(textured({0, 0, far, 0, 0, far}), good).text()).scene, 0), Point3(255));
  }
}

}  // namespace
}  // namespace ligne
