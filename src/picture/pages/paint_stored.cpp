#include "picture/pages/paint_stored.hpp"

#include <algorithm>
#include <utility>
#include <vector>

#include "files/message_text.hpp"
#include "picture/fills.hpp"
#include "picture/hidden_pieces.hpp"

namespace ligne {
namespace {

/// Material and light of faces, by face number. They are equal for all pieces of a face.
class FaceLooks {
 public:
  explicit FaceLooks(const ReadOrder& stored) : materials_(stored.materials), looks_(stored.pieces) {
    const auto by_face = [](const ReadOrder::Piece& a, const ReadOrder::Piece& b) { return a.face < b.face; };
    std::ranges::stable_sort(looks_, by_face);
    const auto are_of_one_face = [](const ReadOrder::Piece& a, const ReadOrder::Piece& b) { return a.face == b.face; };
    looks_.erase(std::unique(looks_.begin(), looks_.end(), are_of_one_face), looks_.end());
  }

  const ReadOrder::Piece& of(std::uint32_t face) const {
    return *std::ranges::lower_bound(looks_, face, {}, &ReadOrder::Piece::face);
  }
  const DocumentMaterial& material_of(std::uint32_t face) const { return materials_[of(face).material]; }

 private:
  const std::vector<DocumentMaterial>& materials_;
  std::vector<ReadOrder::Piece> looks_;  ///< ascending by face
};

/// Gives materials the requested colours.
void recolor(ReadOrder& stored, const StoredPaint& paint, RunReport& run) {
  std::vector<std::uint8_t> is_used(stored.materials.size(), 0);
  for (const ReadOrder::Piece& piece : stored.pieces) is_used[piece.material] = 1;
  for (const auto& [name, color] : paint.colors) {
    bool is_there = false;
    for (std::size_t m = 0; m < stored.materials.size(); ++m) {
      if (!is_used[m] || stored.materials[m].name != name) continue;
      stored.materials[m].color = color;
      is_there = true;
    }
    if (!is_there) run.warn("no face of the order has material " + shown(name, '"'));
  }
}

}  // namespace

void paint_stored(ReadDrawing& read, const StoredPaint& paint, RunReport& run) {
  ReadOrder stored = std::move(*read.order);
  read.order.reset();
  recolor(stored, paint, run);
  const FaceLooks looks(stored);
  if (!stored.tells_hidden) {
    drop_hidden_pieces(stored.order, read.page.sheet(),
                       [&](std::uint32_t face) { return looks.material_of(face).opacity >= 1; });
  }
  read.drawing = make_drawing(stored.strokes);
  for (PaintPiece& piece : stored.order.pieces) {
    const DocumentMaterial& material = looks.material_of(piece.face);
    const Point3 color{material.color[0], material.color[1], material.color[2]};
    read.drawing.fills.push_back({std::move(piece.contours),
                                  fill_color(color, looks.of(piece.face).light, piece.face, paint.kind), material.opacity,
                                  true});
  }
}

}  // namespace ligne
