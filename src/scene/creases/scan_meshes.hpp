#pragma once
/// Recognises objects that are meshed like scans, and constructed parts that were decimated.

#include <cstdint>
#include <span>
#include <vector>

#include "scene/creases/bend.hpp"
#include "scene/creases/face_normals.hpp"
#include "scene/model/scene.hpp"
#include "scene/model/topology.hpp"
#include "scene/patches/borders/patch_edges.hpp"

namespace ligne {

/// A mesh with what is known of its edges.
struct CreaseMesh {
  const Scene& scene;
  const Topology& topology;
  const MeshAngles& angles;
  std::span<const double> sizes;              ///< per object: diagonal of its box
  std::span<const std::uint8_t> is_freeform;  ///< per face
  std::span<const PatchEdge> patch_edges;     ///< per edge
};

/// An object that is meshed like a scan, with its edges in the topology.
struct ScanObject {
  std::uint32_t face_begin = 0, face_end = 0;
  std::uint32_t edge_begin = 0, edge_end = 0;
  bool is_decimated = false;  ///< a part of which a program removed most triangles
};

/// Whether the mesh of an object looks like a scan or a remeshed surface: without planes and without vertices placed on
/// its corners. `bends` are the classes of the edges by their angles, and `precision` is that of the object's coordinates.
bool is_scan(const CreaseMesh& mesh, const std::vector<Bend>& bends, const ScanObject& object, double precision);

/// Whether a constructed part was decimated so far that its edges became rows of teeth: of the creases beside free forms,
/// which are as short as triangles are, many fork, and many turn back and forth.
bool is_decimated(const CreaseMesh& mesh, const std::vector<Bend>& bends, const ScanObject& object);

/// Per edge of a decimated object: 1 if it is a crease between recognised surfaces, or one of a straight or curved line of
/// creases that is long for the object, or on a small ring of corners.
std::vector<std::uint8_t> sure_creases(const CreaseMesh& mesh, const std::vector<Bend>& bends, const ScanObject& object);

}  // namespace ligne
