/// Faults that every format can have, and that are told alike in all of them: coordinates that are no finite numbers, and
/// files without a face. docs/scene-format.md, "Faults".

#include "gltf_builder.hpp"
#include "reader_tools.hpp"
#include "support/standard.hpp"

namespace ligne::reader_test {
namespace {

constexpr float kNan = std::numeric_limits<float>::quiet_NaN(), kInfinity = std::numeric_limits<float>::infinity();

/// The y of the second of three vertices: as a text may have it, and as a binary file may.
struct BadNumber {
  std::string text;
  float value;
};
const BadNumber kGood{"0", 0}, kBadNumbers[] = {{"nan", kNan}, {"-inf", -kInfinity}, {"1e999", kInfinity}};

/// A triangle of one format, or its vertices alone.
struct Format {
  const char* name;
  ModelFormat format;
  std::string place;  ///< of the vertex, in errors
  std::function<std::string(const BadNumber& y, bool with_face)> write;
};

std::string stl_bytes(float y, std::uint32_t n) {
  std::string out(80, ' ');
  const auto put = [&out](auto value) {
    char raw[sizeof value];
    std::memcpy(raw, &value, sizeof value);
    out.append(raw, sizeof value);
  };
  put(n);
  for (std::uint32_t i = 0; i < n; ++i) {
    for (const float v : {0.f, 0.f, 1.f, 0.f, 0.f, 0.f, 1.f, y, 0.f, 0.f, 1.f, 0.f}) put(v);
    put(std::uint16_t{0});
  }
  return out;
}

std::string ply_header(const char* encoding, bool with_face) {
  return std::string("ply\nformat ") + encoding +
         " 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face " +
         (with_face ? "1" : "0") + "\nproperty list uchar int vertex_indices\nend_header\n";
}

std::string ply_bytes(float y, bool with_face) {
  std::string out = ply_header("binary_little_endian", with_face);
  const float numbers[] = {0, 0, 0, 1, y, 0, 0, 1, 0};
  out.append(reinterpret_cast<const char*>(numbers), sizeof numbers);
  const std::int32_t corners[] = {0, 1, 2};
  if (with_face) out.append(1, '\3').append(reinterpret_cast<const char*>(corners), sizeof corners);
  return out;
}

gltf_test::Builder gltf(float y, bool with_face) {
  gltf_test::Builder b;
  const int positions = b.accessor<float>({0, 0, 0, 1, y, 0, 0, 1, 0}, 3);
  b.mesh(positions, -1, with_face ? 4 : 0);
  return b;
}

const Format kFormats[] = {
    {"Obj", ModelFormat::obj, "M:2: ",
     [](const BadNumber& y, bool with_face) {
       return "v 0 0 0\nv 1 " + y.text + " 0\nv 0 1 0\n" + (with_face ? "f 1 2 3\n" : "");
     }},
    {"StlText", ModelFormat::stl_ascii, "M:5: ",
     [](const BadNumber& y, bool with_face) {
       const std::string facet =
           "facet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 " + y.text + " 0\nvertex 0 1 0\nendloop\nendfacet\n";
       return "solid a\n" + (with_face ? facet : "") + "endsolid a\n";
     }},
    {"StlBinary", ModelFormat::stl_binary,
     "M: triangle 0 of 1: ", [](const BadNumber& y, bool with_face) { return stl_bytes(y.value, with_face ? 1 : 0); }},
    {"PlyText", ModelFormat::ply, "M:11: ",
     [](const BadNumber& y, bool with_face) {
       return ply_header("ascii", with_face) + "0 0 0\n1 " + y.text + " 0\n0 1 0\n" + (with_face ? "3 0 1 2\n" : "");
     }},
    {"PlyBinary", ModelFormat::ply,
     "M: vertex 1 of 3: ", [](const BadNumber& y, bool with_face) { return ply_bytes(y.value, with_face); }},
    {"Gltf", ModelFormat::gltf, "M: accessor 0: position 1 ",
     [](const BadNumber& y, bool with_face) { return gltf(y.value, with_face).text(); }},
    {"Glb", ModelFormat::glb, "M: accessor 0: position 1 ",
     [](const BadNumber& y, bool with_face) { return gltf(y.value, with_face).glb(); }},
    {"Asc", ModelFormat::asc_3d_studio, "M:5: ",
     [](const BadNumber& y, bool with_face) {
       return std::string("Named object: \"a\"\nTri-mesh, Vertices: 3 Faces: ") + (with_face ? "1" : "0") +
              "\nVertex list:\nVertex 0: X: 0 Y: 0 Z: 0\nVertex 1: X: 1 Y: " + y.text +
              " Z: 0\nVertex 2: X: 0 Y: 1 Z: 0\nFace list:\n" + (with_face ? "Face 0: A:0 B:1 C:2\n" : "");
     }},
    {"LigneScene", ModelFormat::ligne_scene, "M:3: ", [](const BadNumber& y, bool with_face) {
       return "{\"format\":\"ligne-scene\",\"version\":1,\"objects\":[\n{\"vertices\":[[0,0,0],\n[1," + y.text +
              ",0],[0,1,0]],\n\"faces\":[" + (with_face ? "{\"outer\":[0,1,2]}" : "") + "]}]}";
     }}};

/// The error line; else the warnings, one a line, and the number of faces that are left.
std::string outcome(const Format& format, const std::string& file) {
  Warnings warnings;
  try {
    const Scene scene = read_scene({bytes_of(file), "M"}, format.format, {}, warnings);
    std::string text;
    for (const auto& [kind, count] : warnings.counts()) text += std::to_string(count) + " " + kind + "; ";
    return text + std::to_string(scene.faces.size()) + " faces";
  } catch (const InputError& error) {
    return error.what();
  }
}

TEST(Faults, AGoodTriangleIsRead) {
  for (const Format& format : kFormats) EXPECT_EQ(outcome(format, format.write(kGood, true)), "1 faces") << format.name;
}

TEST(Faults, CoordinatesThatAreNotFiniteAreErrorsThatNameThePlace) {
  for (const Format& format : kFormats) {
    for (const BadNumber& bad : kBadNumbers) {
      for (const bool used : {true, false}) {
        if (!used && std::string(format.name).starts_with("Stl")) continue;  // no vertex without a face
        if (!used && std::string(format.name).starts_with("Gl")) continue;   // positions of points are not read
        const std::string line = outcome(format, format.write(bad, used));
        EXPECT_TRUE(line.starts_with(format.place)) << format.name << ", " << bad.text << ": " << line;
      }
    }
  }
}

TEST(Faults, FilesWithoutAFaceAreErrors) {
  for (const Format& format : kFormats) {
    // A glTF names points as such.
    const bool points = std::string(format.name).starts_with("Gl");
    EXPECT_EQ(outcome(format, format.write(kGood, false)),
              std::string("M: holds no faces") + (points ? "; left out: 1 primitives of points" : ""))
        << format.name;
  }
}

TEST(Faults, FilesOfFacesWithoutAnAreaAreErrors) {
  const BadNumber first_again{"0", 0};
  for (const Format& format : kFormats) {
    std::string file = format.write(first_again, true);
    // The second vertex is moved onto the first.
    if (std::string(format.name) == "StlBinary") {
      std::memset(file.data() + 84 + 24, 0, 4);
    } else if (std::string(format.name) == "PlyBinary") {
      std::memset(file.data() + ply_header("binary_little_endian", true).size() + 12, 0, 4);
    } else if (std::string(format.name).starts_with("Gl")) {
      gltf_test::Builder b;
      b.mesh(b.accessor<float>({0, 0, 0, 0, 0, 0, 0, 1, 0}, 3), -1);
      file = format.format == ModelFormat::glb ? b.glb() : b.text();
    } else {
      const std::string one[] = {"v 1", "vertex 1", "\n1 0", "X: 1", "[1,"},
                        zero[] = {"v 0", "vertex 0", "\n0 0", "X: 0", "[0,"};
      for (std::size_t k = 0; k < 5; ++k) {
        if (const std::size_t at = file.find(one[k]); at != std::string::npos) {
          file.replace(at, one[k].size(), zero[k]);
          break;
        }
      }
    }
    EXPECT_EQ(outcome(format, file), "M: none of its 1 faces has an area: they are lines or points") << format.name;
  }
}

TEST(Faults, ATransformBeyondAllNumbersIsAnError) {
  gltf_test::Builder b = gltf_test::square();
  b.root["nodes"][0]["scale"] = {1e308, 1, 1};
  b.root["nodes"][0]["translation"] = {1e308, 0, 0};
  const Format& format = kFormats[5];
  EXPECT_EQ(outcome(format, b.text()), "M: vertex 0 of 4: a coordinate is beyond 1.6e60, too large to compute with");
}

}  // namespace
}  // namespace ligne::reader_test
