#include <algorithm>
#include <charconv>
#include <cstring>
#include <fstream>
#include <limits>
#include <stdexcept>

#include "inputs.hpp"

namespace ligne::bench {

namespace {

/// Shortest text that reads back as the same number.
template <class Number>
void put(std::string& out, Number value) {
  char text[32];
  out.append(text, std::to_chars(text, text + sizeof text, value).ptr);
}

template <class Value>
void put_bytes(std::string& out, Value value) {  // little-endian, as glTF asks for
  for (std::size_t k = 0; k < sizeof value; ++k) out.push_back(static_cast<char>(value >> (8 * k) & 0xff));
}

void put_float(std::string& out, float value) {
  std::uint32_t bits = 0;
  static_assert(sizeof bits == sizeof value);
  std::memcpy(&bits, &value, sizeof bits);
  put_bytes(out, bits);
}

void pad(std::string& out, char with) {
  while (out.size() % 4 != 0) out.push_back(with);
}

void write_file(const std::filesystem::path& file, const std::string& bytes) {
  std::ofstream out(file, std::ios::binary);
  out.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  out.close();
  if (!out) throw std::runtime_error(file.string() + ": can not be written");
}

std::string nodes_json(const std::vector<Placement>& placements) {
  if (placements.empty()) return R"("scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}])";
  std::string roots, nodes;
  for (std::size_t i = 0; i < placements.size(); ++i) {
    if (i != 0) roots += ',', nodes += ',';
    put(roots, i);
    nodes += R"({"mesh":0,"matrix":[)";
    const Placement& p = placements[i];
    for (std::size_t column = 0; column < 4; ++column) {
      for (std::size_t row = 0; row < 4; ++row) {
        const double corner = column == 3 ? 1.0 : 0.0;
        const double value = row == 3 ? corner : column == 3 ? p.shift[row] : p.rows[row][column];
        if (column + row != 0) nodes += ',';
        put(nodes, static_cast<float>(value));
      }
    }
    nodes += "]}";
  }
  return R"("scenes":[{"nodes":[)" + roots + R"(]}],"nodes":[)" + nodes + "]";
}

}  // namespace

void write_glb(const std::filesystem::path& file, const TriangleMesh& mesh, const std::vector<Placement>& placements) {
  constexpr int kU16 = 5123, kU32 = 5125;
  // The largest value of an index type restarts a primitive, so it is no vertex.
  const bool small = mesh.positions.size() < std::numeric_limits<std::uint16_t>::max();
  std::string binary;
  std::array<float, 3> low, high;
  low.fill(std::numeric_limits<float>::infinity());
  high.fill(-std::numeric_limits<float>::infinity());
  for (const Vec3& p : mesh.positions) {
    for (std::size_t k = 0; k < 3; ++k) {
      const float c = static_cast<float>(p[k]);
      low[k] = std::min(low[k], c), high[k] = std::max(high[k], c);
      put_float(binary, c);
    }
  }
  const std::size_t index_begin = binary.size();
  for (const Corner3& t : mesh.triangles) {
    for (const std::uint32_t v : t) {
      if (small)
        put_bytes(binary, static_cast<std::uint16_t>(v));
      else
        put_bytes(binary, v);
    }
  }
  const std::size_t index_bytes = binary.size() - index_begin;
  pad(binary, '\0');

  const auto triple = [](const std::array<float, 3>& v) {
    std::string text;
    for (const float c : v) {
      if (!text.empty()) text += ',';
      put(text, c);
    }
    return "[" + text + "]";
  };
  std::string json = R"({"asset":{"version":"2.0","generator":"ligne_bench_inputs"},"scene":0,)" + nodes_json(placements);
  json += R"(,"meshes":[{"primitives":[{"attributes":{"POSITION":0},"indices":1}]}],"accessors":[)";
  json += R"({"bufferView":0,"componentType":5126,"count":)" + std::to_string(mesh.positions.size()) +
          R"(,"type":"VEC3","min":)" + triple(low) + R"(,"max":)" + triple(high) + "},";
  json += R"({"bufferView":1,"componentType":)" + std::to_string(small ? kU16 : kU32) + R"(,"count":)" +
          std::to_string(3 * mesh.triangles.size()) + R"(,"type":"SCALAR"}],"bufferViews":[)";
  json += R"({"buffer":0,"byteLength":)" + std::to_string(index_begin) + R"(,"target":34962},)";
  json += R"({"buffer":0,"byteOffset":)" + std::to_string(index_begin) + R"(,"byteLength":)" + std::to_string(index_bytes) +
          R"(,"target":34963}],"buffers":[{"byteLength":)" + std::to_string(binary.size()) + "}]}";
  pad(json, ' ');

  constexpr std::uint32_t kGltf = 0x46546c67, kJson = 0x4e4f534a, kBin = 0x004e4942;
  std::string out;
  const auto word = [&](std::size_t v) { put_bytes(out, static_cast<std::uint32_t>(v)); };
  word(kGltf), word(2), word(12 + 8 + json.size() + 8 + binary.size());
  word(json.size()), word(kJson);
  out += json;
  word(binary.size()), word(kBin);
  out += binary;
  write_file(file, out);
}

void write_cube_scene(const std::filesystem::path& file, const std::vector<CubeCorners>& cubes) {
  std::string faces;
  for (const auto& face : kCubeFaces) {
    if (!faces.empty()) faces += ',';
    faces += R"({"outer":[)";
    for (std::size_t k = 0; k < 4; ++k) {
      if (k != 0) faces += ',';
      put(faces, face[k]);
    }
    faces += "]}";
  }
  std::string out = R"({"format":"ligne-scene","version":1,"up":"z","objects":[)";
  for (std::size_t i = 0; i < cubes.size(); ++i) {
    out += (i == 0 ? "\n" : ",\n") + (R"({"name":"cube )" + std::to_string(i)) + R"(","vertices":[)";
    for (std::size_t v = 0; v < 8; ++v) {
      if (v != 0) out += ',';
      out += '[';
      for (std::size_t k = 0; k < 3; ++k) {
        if (k != 0) out += ',';
        put(out, cubes[i][v][k]);
      }
      out += ']';
    }
    out += R"(],"faces":[)" + faces + "]}";
  }
  write_file(file, out + "\n]}\n");
}

}  // namespace ligne::bench
