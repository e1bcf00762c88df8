#pragma once
/// Small scenes as JSON, and what cleaning, merging and healing make of them. A scene has, of which all but vertices and
/// faces may be absent:
///
///     "vertices": [[x, y, z], ...]          null is no number
///     "faces": [[0, 1, 2], [[0, 1, 2, 3], [4, 5, 6]], ...]      corners, or contours: the outer one first
///     "flags", "materials", "details"       of corners; of faces; [face, material] each
///     "objects": [[vertices, faces], ...]   where each ends, named by its number; otherwise all is one
///     "precision"                           of the objects
///     "lights"                              their number
///
/// or "cells": rows of unit squares of a grid, from the lowest y, # where there is a face; "triangles": true cuts them,
/// "heights" are those of its columns of vertices.

#include <nlohmann/json.hpp>

#include "scene/clean/clean.hpp"
#include "scene/clean/weld.hpp"
#include "scene/heal/heal.hpp"
#include "scene/readers/reader.hpp"
#include "support/standard.hpp"

namespace ligne::reader_test {

using nlohmann::json;
using CornerList = std::vector<std::uint32_t>;

inline Scene grid_of_cells(const json& text) {
  const auto rows = text["cells"].get<std::vector<std::string>>();
  const auto columns = static_cast<std::uint32_t>(rows[0].size());
  Scene scene;
  for (std::size_t y = 0; y <= rows.size(); ++y)
    for (std::size_t x = 0; x <= columns; ++x)
      scene.vertices.emplace_back(x, y, text.contains("heights") ? text["heights"].at(x).get<double>() : 0);
  for (std::uint32_t y = 0; y < rows.size(); ++y)
    for (std::uint32_t x = 0; x < columns; ++x) {
      if (rows[y][x] != '#') continue;
      const std::uint32_t a = y * (columns + 1) + x, b = a + columns + 1;
      if (text.value("triangles", false)) {
        scene.faces.add_triangle(a, a + 1, b + 1);
        scene.faces.add_triangle(a, b + 1, b);
      } else {
        scene.faces.add_face(CornerList{a, a + 1, b + 1, b});
      }
    }
  return scene;
}

inline Scene small_scene(const json& text) {
  Scene scene = text.contains("cells") ? grid_of_cells(text) : Scene{};
  const auto number = [](const json& n) { return n.is_null() ? std::nan("") : n.get<double>(); };
  for (const json& p : text.value("vertices", json::array()))
    scene.vertices.emplace_back(number(p[0]), number(p[1]), number(p[2]));
  for (const json& face : text.value("faces", json::array())) {
    if (face[0].is_number()) {
      scene.faces.add_face(face.get<CornerList>());
    } else {
      scene.faces.add_face(face[0].get<CornerList>());
      for (std::size_t c = 1; c < face.size(); ++c) scene.faces.add_hole(face[c].get<CornerList>());
    }
  }
  scene.corner_flags = text.value("flags", std::vector<std::uint8_t>());
  scene.face_material = text.value("materials", CornerList());
  if (!scene.face_material.empty()) scene.materials.resize(1 + *std::ranges::max_element(scene.face_material));
  for (std::size_t m = 0; m < scene.materials.size(); ++m) scene.materials[m].name = std::to_string(m);
  scene.lights.resize(text.value("lights", std::size_t{0}));
  for (const json& detail : text.value("details", json::array()))
    scene.details.push_back({detail[0].get<std::uint32_t>(), detail[1].get<std::uint32_t>(), {}});
  std::uint32_t vertex = 0, face = 0;
  for (const auto& [vertices, faces] : text.value("objects", std::vector<std::pair<std::uint32_t, std::uint32_t>>())) {
    scene.objects.push_back(
        {std::to_string(scene.objects.size()), vertex, vertices, face, faces, text.value("precision", 0.0)});
    vertex = vertices, face = faces;
  }
  return scene;
}

/// "clean JSON"; "merge JSON", which is cleaned first; "weld:DISTANCE JSON", which is not; "append [JSON, JSON ...]", scenes
/// that become one.
inline Scene mended(const std::string& how, const std::string& text, Warnings& warnings) {
  Scene scene;
  if (how == "append") {
    for (const json& part : json::parse(text)) append_scene(scene, small_scene(part));
    return scene;
  }
  scene = small_scene(json::parse(text));
  if (how.starts_with("weld")) {
    weld_near_vertices(scene, std::stod(how.substr(5)));
    return scene;
  }
  finish_scene(scene, warnings);
  if (how == "merge") merge_coplanar_faces(scene);
  return scene;
}

/// Heals a scene after cleaning it, and gives the counts of the report.
inline json healed(Scene& scene, Warnings& warnings) {
  finish_scene(scene, warnings);
  Topology topology = build_topology(scene);
  const HealReport report = heal(scene, topology, {});
  const auto has = [](std::uint16_t flag) { return [flag](std::uint16_t flags) { return (flags & flag) != 0; }; };
  return {{"objects_twice", report.objects_twice},
          {"faces_twice", report.faces_twice},
          {"faces_turned", report.faces_turned},
          {"unlike_edges", std::ranges::count_if(topology.edge_flags, has(kEdgeUnlikeWound))},
          {"hidden_edges", std::ranges::count_if(topology.edge_flags, has(kEdgeFileHidden))},
          {"turned_again", heal(scene, topology, {}).faces_turned}};
}

/// The contours of a scene as points, each begun at its least one, their numbers of corners, and their areas from above.
inline void add_contours(const Scene& scene, json& all) {
  double whole = 0;
  for (std::size_t f = 0; f < scene.faces.size(); ++f) {
    json contours, corners, areas;
    for (std::size_t c = 0; c < scene.faces.contour_count(f); ++c) {
      std::vector<std::array<double, 3>> points;
      double area = 0;
      Point3 a = scene.vertices[scene.faces.contour(f, c).back()];
      for (const std::uint32_t v : scene.faces.contour(f, c)) {
        const Point3 b = scene.vertices[v];
        points.push_back({b.x, b.y, b.z});
        area += (a.x * b.y - a.y * b.x) / 2;
        a = b;
      }
      std::rotate(points.begin(), std::min_element(points.begin(), points.end()), points.end());
      contours.push_back(points);
      corners.push_back(points.size());
      areas.push_back(area);
      whole += area;
    }
    all["contours"].push_back(contours);
    all["corners"].push_back(corners);
    all["areas"].push_back(areas);
  }
  all["area"] = whole;
  all["all_triangles"] = scene.faces.all_triangles();
  all["corners_without_flags"] = std::ranges::count(scene.corner_flags, 0);
}

}  // namespace ligne::reader_test
