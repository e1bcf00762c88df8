#pragma once
/// Semi-sharp creases and corners that a file defines for a control mesh.

#include <cstdint>
#include <vector>

namespace ligne {

/// The tags of a file, by its own vertex numbers from 0.
struct CreaseTags {
  struct Edge {
    std::uint32_t v0 = 0, v1 = 0;  ///< ascending
    float sharpness = 0;
  };
  struct Corner {
    std::uint32_t vertex = 0;
    float sharpness = 0;
  };
  std::vector<Edge> edges;                 ///< after sort(): ascending by vertices, each pair once
  std::vector<Corner> corners;             ///< after sort(): ascending, each vertex once
  std::vector<std::uint32_t> file_vertex;  ///< per vertex of the scene: vertex of the file; empty: they are equal

  bool empty() const { return edges.empty() && corners.empty(); }
  /// Sorts the tags. Of several tags for one edge or vertex, the sharpest counts.
  void sort();
  /// Sharpness of the edge between two vertices of the scene, and of a vertex; 0 without a tag. Call sort() first.
  float of_edge(std::uint32_t a, std::uint32_t b) const;
  float of_vertex(std::uint32_t v) const;

 private:
  std::uint32_t in_file(std::uint32_t v) const { return file_vertex.empty() ? v : file_vertex[v]; }
};

}  // namespace ligne
