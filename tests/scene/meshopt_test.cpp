// Streams of EXT_meshopt_compression: those that the specification gives, those of an independent encoder, and broken ones.

#include "gltf_builder.hpp"
#include "scene/readers/format_readers.hpp"
#include "scene/readers/gltf/meshopt_codec.hpp"

#ifdef LIGNE_HAVE_MESHOPTIMIZER
#include <meshoptimizer.h>
#endif

namespace ligne {
namespace {

using Bytes = std::vector<std::uint8_t>;

std::string decode(const Bytes& stream, const MeshoptView& view, Bytes& out) {
  std::string cause;
  const std::vector<std::byte> bytes = decode_meshopt(std::as_bytes(std::span(stream)), view, cause);
  out.resize(bytes.size());
  if (!bytes.empty()) std::memcpy(out.data(), bytes.data(), bytes.size());
  return cause;
}

/// Sixteen elements of four bytes, of which the first is the example of the specification, and the others stay as they
/// begin.
Bytes example_stream() {
  Bytes stream{0xa0, 0x02, 0x17, 0x5f, 0xf0, 0xbc, 0x77, 0xa9, 0x21, 0x00, 0x34, 0xb5, 0, 0, 0};
  stream.resize(stream.size() + 28);
  for (const std::uint8_t byte : {100, 7, 8, 9}) stream.push_back(byte);
  return stream;
}

TEST(Meshopt, ExampleOfTheSpecification) {
  Bytes out;
  ASSERT_EQ(decode(example_stream(), {.count = 16, .stride = 4}, out), "");
  std::uint8_t value = 100;
  const int deltas[16] = {-1, -4, -3, 26, -91, 0, -6, 6, -4, -4, 5, -5, 1, -1, 0, 0};
  for (std::size_t i = 0; i < 16; ++i) {
    value = static_cast<std::uint8_t>(value + deltas[i]);
    EXPECT_EQ(out[4 * i], value) << i;
    EXPECT_EQ(out[4 * i + 3], 9) << i;
  }
}

TEST(Meshopt, Filters) {
  std::int8_t normal[8] = {0, 0, 127, 5, -127, 0, 127, 6};
  apply_meshopt_filter({.filter = MeshoptFilter::octahedral, .count = 2, .stride = 4},
                       std::as_writable_bytes(std::span(normal)));
  EXPECT_EQ(normal[2], 127);
  EXPECT_EQ(normal[3], 5);
  EXPECT_EQ(normal[4], -127);
  EXPECT_EQ(normal[6], 0);
  std::int16_t turn[4] = {0, 0, 32767, static_cast<std::int16_t>((32767 & ~3) | 3)};
  apply_meshopt_filter({.filter = MeshoptFilter::quaternion, .count = 1, .stride = 8},
                       std::as_writable_bytes(std::span(turn)));
  EXPECT_EQ(turn[2], 23170);  // three places on from the largest, of sqrt(1/2)
  EXPECT_NEAR(turn[3], 23170, 1);
  std::uint32_t number[2] = {0xff000003, 0x02fffffd};
  apply_meshopt_filter({.filter = MeshoptFilter::exponential, .count = 1, .stride = 8},
                       std::as_writable_bytes(std::span(number)));
  float value[2];
  std::memcpy(value, number, sizeof value);
  EXPECT_EQ(value[0], 1.5f);
  EXPECT_EQ(value[1], -12.0f);
}

TEST(Meshopt, BrokenStreamsAreRefused) {
  Bytes out;
  const MeshoptView view{.count = 16, .stride = 4};
  const Bytes good = example_stream();
  EXPECT_EQ(decode({}, view, out), "not of this mode, or of a later version");
  EXPECT_EQ(decode(Bytes{0xa1, 0, 0}, view, out), "not of this mode, or of a later version");
  for (std::size_t n = 1; n < good.size(); ++n)
    EXPECT_NE(decode(Bytes(good.begin(), good.begin() + static_cast<std::ptrdiff_t>(n)), view, out), "") << n;
  Bytes longer = good;
  longer.insert(longer.begin() + 5, 0);
  EXPECT_NE(decode(longer, view, out), "");
  EXPECT_EQ(decode(good, {.count = 1u << 30, .stride = 4}, out), "too short for so many elements");
}

/// Whatever the bytes, decoding ends and stays in its memory (the sanitizers look).
TEST(Meshopt, RandomStreamsDoNoHarm) {
  std::mt19937 random(7);
  Bytes out;
  for (int i = 0; i < 20'000; ++i) {
    Bytes stream(1 + random() % 300);
    for (std::uint8_t& byte : stream) byte = static_cast<std::uint8_t>(random() % (i % 2 == 0 ? 256 : 16));
    MeshoptView view;
    view.mode = static_cast<MeshoptMode>(random() % 3);
    stream[0] = std::array<std::uint8_t, 3>{0xa0, 0xe1, 0xd1}[static_cast<std::size_t>(view.mode)];
    const bool attributes = view.mode == MeshoptMode::attributes;
    view.filter = attributes ? static_cast<MeshoptFilter>(random() % 4) : MeshoptFilter::none;
    view.stride = attributes ? (view.filter == MeshoptFilter::none ? 4 * (1 + random() % 64) : 8) : 2 + 2 * (random() % 2);
    view.count = 3 * (random() % 60);
    ASSERT_EQ(check_meshopt(view), "");
    decode(stream, view, out);
  }
}

TEST(Meshopt, RulesOfTheExtension) {
  EXPECT_EQ(check_meshopt({.count = 1, .stride = 12}), "");
  EXPECT_NE(check_meshopt({.count = 1, .stride = 0}), "");
  EXPECT_NE(check_meshopt({.count = 1, .stride = 260}), "");
  EXPECT_NE(check_meshopt({.filter = MeshoptFilter::quaternion, .count = 1, .stride = 4}), "");
  EXPECT_NE(check_meshopt({.mode = MeshoptMode::triangles, .count = 4, .stride = 2}), "");
  EXPECT_NE(check_meshopt({.mode = MeshoptMode::indices, .count = 4, .stride = 8}), "");
}

/// A whole file whose positions are compressed, with a buffer to fall back on that is not there.
TEST(Meshopt, ViewOfAFile) {
  gltf_test::Builder b;
  const int positions = b.accessor<float>({0, 0, 0, 0, 0, 0, 0, 0, 0}, 3);
  b.mesh(positions, -1);
  // Every delta is 0: all three positions are the one that the tail holds.
  Bytes stream{0xa0};
  stream.resize(1 + 12 + 32, 0);
  const float three = 3;
  std::memcpy(&stream[stream.size() - 4], &three, 4);
  const int view = b.view(stream);
  const gltf_test::json place = b.root["bufferViews"][view];
  const std::string whole = b.text();
  gltf_test::json root = gltf_test::json::parse(whole);
  root["buffers"].push_back({{"byteLength", 36}, {"extensions", {{"EXT_meshopt_compression", {{"fallback", true}}}}}});
  root["extensionsRequired"] = {"EXT_meshopt_compression"};
  root["bufferViews"][0] = {{"buffer", 1}, {"byteLength", 36}};
  root["bufferViews"][0]["extensions"]["EXT_meshopt_compression"] = {{"buffer", 0},
                                                                     {"byteOffset", place["byteOffset"]},
                                                                     {"byteLength", place["byteLength"]},
                                                                     {"byteStride", 12},
                                                                     {"count", 3},
                                                                     {"mode", "ATTRIBUTES"}};
  const auto read = [&] {
    ReadReport report;
    Warnings warnings;
    const std::string text = root.dump();
    return read_gltf({{std::as_bytes(std::span(text)), "M"}, report, warnings}, false);
  };
  EXPECT_EQ(read().vertices, std::vector<Point3>(3, Point3(0, 0, 3)));
  root["bufferViews"][0]["extensions"]["EXT_meshopt_compression"]["count"] = 4;
  EXPECT_THROW(read(), InputError);
}

#ifdef LIGNE_HAVE_MESHOPTIMIZER

TEST(Meshopt, AttributesOfAnotherEncoder) {
  std::mt19937 random(1);
  for (int round = 0; round < 200; ++round) {
    const std::size_t stride = 4 * (1 + random() % 16), count = 1 + random() % 700;
    Bytes data(stride * count);
    // Bytes that change by little, by much, or not at all.
    for (std::size_t i = 0; i < data.size(); ++i) {
      const unsigned kind = (i % stride) % 3, before = i < stride ? 0u : data[i - stride];
      data[i] = static_cast<std::uint8_t>(kind == 0 ? random() : kind == 1 ? before + random() % 3 : before);
    }
    Bytes stream(meshopt_encodeVertexBufferBound(count, stride));
    meshopt_encodeVertexVersion(0);
    stream.resize(meshopt_encodeVertexBuffer(stream.data(), stream.size(), data.data(), count, stride));
    Bytes out;
    ASSERT_EQ(decode(stream, {.count = count, .stride = stride}, out), "");
    ASSERT_EQ(out, data);
  }
}

TEST(Meshopt, IndicesOfAnotherEncoder) {
  std::mt19937 random(2);
  meshopt_encodeIndexVersion(1);
  for (int round = 0; round < 200; ++round) {
    // A grid of triangles, with some of them shuffled.
    const std::uint32_t n = 2 + random() % 20;
    std::vector<std::uint32_t> indices;
    for (std::uint32_t j = 0; j + 1 < n; ++j) {
      for (std::uint32_t i = 0; i + 1 < n; ++i) {
        const std::uint32_t a = j * n + i;
        for (const std::uint32_t v : {a, a + 1, a + n, a + 1, a + n + 1, a + n})
          indices.push_back(random() % 10 == 0 ? random() % (n * n) : v);
      }
    }
    Bytes stream(meshopt_encodeIndexBufferBound(indices.size(), n * n));
    stream.resize(meshopt_encodeIndexBuffer(stream.data(), stream.size(), indices.data(), indices.size()));
    Bytes sequence(meshopt_encodeIndexSequenceBound(indices.size(), n * n));
    sequence.resize(meshopt_encodeIndexSequence(sequence.data(), sequence.size(), indices.data(), indices.size()));
    for (const std::size_t stride : {2, 4}) {
      const auto decoded = [&](const Bytes& bytes, MeshoptMode mode) {
        Bytes out;
        EXPECT_EQ(decode(bytes, {.mode = mode, .count = indices.size(), .stride = stride}, out), "");
        std::vector<std::uint32_t> found(indices.size());
        for (std::size_t i = 0; i < found.size(); ++i) std::memcpy(&found[i], &out.at(stride * i), stride);
        return found;
      };
      ASSERT_EQ(decoded(sequence, MeshoptMode::indices), indices);
      // The encoder may turn a triangle so that it begins at another corner.
      const std::vector<std::uint32_t> got = decoded(stream, MeshoptMode::triangles);
      for (std::size_t t = 0; t < indices.size(); t += 3) {
        std::array<std::uint32_t, 3> corners{got[t], got[t + 1], got[t + 2]};
        const std::array<std::uint32_t, 3> wanted{indices[t], indices[t + 1], indices[t + 2]};
        for (int turn = 0; turn < 2 && corners != wanted; ++turn)
          std::rotate(corners.begin(), corners.begin() + 1, corners.end());
        ASSERT_EQ(corners, wanted) << "triangle " << t / 3;
      }
    }
  }
}

#endif

}  // namespace
}  // namespace ligne
