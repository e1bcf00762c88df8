#include "view/axes/axes_box.hpp"

namespace ligne {

std::array<BoxEdge, kBoxEdges> box_edges() {
  std::array<BoxEdge, kBoxEdges> edges;
  std::size_t n = 0;
  for (unsigned axis = 0; axis < 3; ++axis) {
    for (unsigned corner = 0; corner < 8; ++corner) {
      if (!(corner >> axis & 1u)) edges[n++] = {axis, corner};
    }
  }
  return edges;
}

BoxSides back_sides(const AxesBox& box, const Camera& camera) {
  BoxSides back{};
  for (int k = 0; k < 3; ++k) {
    if (camera.perspective) {
      back[k] = {camera.eye[k] > box.low[k], camera.eye[k] < box.high[k]};
      if (box.low[k] == box.high[k] && camera.eye[k] == box.low[k]) back[k][0] = true;
    } else {
      back[k][1] = camera.forward[k] > 0;
      back[k][0] = !back[k][1];
    }
  }
  return back;
}

bool is_back(const BoxEdge& edge, const BoxSides& back) {
  for (unsigned k = 0; k < 3; ++k) {
    if (k != edge.axis && back[k][edge.from >> k & 1u]) return true;
  }
  return false;
}

Scene box_scene(const AxesBox& box) {
  Scene scene;
  for (unsigned i = 0; i < 8; ++i) scene.vertices.push_back(box.corner(i));
  for (unsigned k = 0; k < 3; ++k) {
    const unsigned i = 1u << (k + 1) % 3, j = 1u << (k + 2) % 3;
    for (const unsigned side : {0u, 1u << k}) {
      scene.faces.add_triangle(side, side | i, side | i | j);
      scene.faces.add_triangle(side, side | i | j, side | j);
    }
  }
  return scene;
}

}  // namespace ligne
