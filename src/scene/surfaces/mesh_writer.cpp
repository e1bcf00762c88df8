#include "scene/surfaces/mesh_writer.hpp"

#include <array>
#include <cassert>
#include <charconv>
#include <cstdint>
#include <string_view>

#include "files/json_text.hpp"

namespace ligne {
namespace {

template <class Number>
void append(std::string& out, Number value) {
  std::array<char, 32> buffer{};
  const auto [end, error] = std::to_chars(buffer.data(), buffer.data() + buffer.size(), value);
  out.append(buffer.data(), end);
}

void append_point(std::string& out, const Point3& p, char separator) {
  for (int axis = 0; axis < 3; ++axis) {
    if (axis > 0) out += separator;
    append(out, p[axis]);
  }
}

std::string_view axis_name(Axis axis) { return axis == Axis::x ? "x" : axis == Axis::y ? "y" : "z"; }

void append_contour(std::string& out, std::span<const std::uint32_t> contour, std::uint32_t first_vertex) {
  out += '[';
  for (std::size_t k = 0; k < contour.size(); ++k) {
    if (k > 0) out += ',';
    append(out, contour[k] - first_vertex);
  }
  out += ']';
}

void append_face(std::string& out, const PolygonFaces& faces, std::size_t f, std::uint32_t first_vertex) {
  out += "{\"outer\":";
  append_contour(out, faces.contour(f, 0), first_vertex);
  for (std::size_t c = 1; c < faces.contour_count(f); ++c) {
    out += c == 1 ? ",\"holes\":[" : ",";
    append_contour(out, faces.contour(f, c), first_vertex);
  }
  out += faces.contour_count(f) > 1 ? "]}" : "}";
}

/// Makes a name fit on its own line.
std::string plain(std::string_view name) {
  std::string text(name);
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < 0x20) c = ' ';
  }
  return text;
}

}  // namespace

std::string write_ligne_scene(const Scene& scene) {
  std::string out =
      "{\"format\":\"ligne-scene\",\"version\":1,\"up\":\"" + std::string(axis_name(scene.up_axis)) + "\",\n\"objects\":[";
  for (std::size_t o = 0; o < scene.objects.size(); ++o) {
    const Object& object = scene.objects[o];
    out += o == 0 ? "\n" : ",\n";
    out += "{\"name\":" + json_string(object.name) + ",\"precision\":";
    append(out, object.precision);
    out += ",\n\"vertices\":[";
    for (std::uint32_t v = object.vertex_begin; v < object.vertex_end; ++v) {
      out += v == object.vertex_begin ? "\n[" : ",\n[";
      append_point(out, scene.vertices[v], ',');
      out += ']';
    }
    out += "],\n\"faces\":[";
    for (std::uint32_t f = object.face_begin; f < object.face_end; ++f) {
      out += f == object.face_begin ? "\n" : ",\n";
      append_face(out, scene.faces, f, object.vertex_begin);
    }
    out += "]}";
  }
  return out + "\n]}\n";
}

std::string write_obj(const Scene& scene) {
  std::string out = "# " + std::string(axis_name(scene.up_axis)) + " is up\n";
  for (const Object& object : scene.objects) {
    out += "o " + plain(object.name) + "\n";
    for (std::uint32_t v = object.vertex_begin; v < object.vertex_end; ++v) {
      out += "v ";
      append_point(out, scene.vertices[v], ' ');
      out += '\n';
    }
    for (std::uint32_t f = object.face_begin; f < object.face_end; ++f) {
      assert(scene.faces.contour_count(f) == 1);
      out += 'f';
      for (const std::uint32_t v : scene.faces.contour(f, 0)) {
        out += ' ';
        append(out, std::uint64_t{v} + 1);
      }
      out += '\n';
    }
  }
  return out;
}

}  // namespace ligne
