#pragma once
/// The line map: the visible lines of a drawing as a graph that rules read and edit.
///
/// Notation
///   piece    a straight part of one stroke; a stroke is one piece unless other lines end or cross there
///   end      end 2 p is the `from` of piece p, end 2 p + 1 its `to`
///   node     a place where pieces end; its degree is the number of their ends there
///   free end the only end at its node
///   contact  a free end that lies beside another line, and the node on that line (which is cut there)
///
/// A node joins ends at exactly one lattice point. Contacts join nodes that are merely near each other, so that each rule
/// can choose its own distance (see Arcs in line_groups.hpp).
///
/// Invariants: an end is linked to its node if and only if its piece is alive; the pieces of a stroke follow each other
/// without a gap, in the order of the stroke.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

#include "geometry/search/line_cells.hpp"
#include "linework/map/nodes.hpp"
#include "linework/stroke.hpp"
#include "linework/stroke_geometry.hpp"

namespace ligne {

/// Makes the source of a stroke that joins two lines. On the call, the stroke has the source of the line that it
/// continues.
using MakeSource = std::function<SourceEdge(const Stroke&)>;

/// A contact: the node `node` lies `distance` lattice steps from the node `other` of another line.
struct Contact {
  std::uint32_t node, other;
  double distance;
};

/// Ends of lines that one task looks at: there are few in a drawing. Adjustable.
inline constexpr std::size_t kEndBlock = 32;

/// Selects the points of lines that become contacts.
struct Meetings {
  double reach = 0;       ///< lattice steps; 0: no contacts
  bool any_node = false;  ///< whether nodes of several ends have contacts too, or only free ends
};

class LineMap {
 public:
  /// Takes the visible strokes of `model` for which takes_part() returns true, except strokes without length. O(n + m),
  /// where m counts the cells that lines pass. Their side is `cell`, but walked_cell() limits their number.
  /// Several threads call takes_part().
  LineMap(StrokeModel& model, const std::function<bool(const Stroke&)>& takes_part, const Meetings& meetings, double cell);
  LineMap(const LineMap&) = delete;
  LineMap& operator=(const LineMap&) = delete;

  double step_mm() const { return model_.lattice.step_mm; }
  Point2 to_mm(LatticePoint p) const { return model_.lattice.to_mm(p); }
  /// The number of pieces, dead ones included.
  std::uint32_t piece_count() const { return static_cast<std::uint32_t>(pieces_.size()); }
  bool is_alive(std::uint32_t piece) const { return pieces_[piece].alive; }
  /// The piece as a stroke.
  const Stroke& piece(std::uint32_t piece) const { return pieces_[piece].stroke; }
  std::uint32_t stroke_number(std::uint32_t piece) const { return pieces_[piece].of; }
  /// The whole stroke of the piece.
  const Stroke& stroke_of(std::uint32_t piece) const { return model_.strokes[pieces_[piece].of]; }
  StrokeTip tip(std::uint32_t end) const { return ligne::tip(pieces_[end / 2].stroke, end); }
  LatticePoint point(std::uint32_t end) const { return tip(end).p; }

  const Nodes& nodes() const { return nodes_; }
  bool is_free(std::uint32_t end) const { return nodes_.degree(nodes_.of(end)) == 1; }
  /// The other end at the node if exactly two pieces end there; otherwise kNone.
  std::uint32_t next(std::uint32_t end) const { return nodes_.other(end); }
  /// The pieces of the chain that ends at `end`, from that end on, until their total length exceeds `length`.
  std::vector<std::uint32_t> line_back(std::uint32_t end, double length) const;
  const std::vector<Contact>& contacts() const { return contacts_; }
  /// Whether the contact still holds. A contact of a free end holds until the end is joined; any contact holds until
  /// one of its lines is removed.
  bool holds(const Contact& contact) const {
    const std::uint32_t ends = nodes_.degree(contact.node);
    return nodes_.degree(contact.other) > 0 && (meetings_.any_node ? ends > 0 : ends == 1);
  }

  /// Calls visit(piece) for the living pieces within `reach` steps of a segment, for some that are farther away, and for
  /// some more than once, until it returns true. Returns whether it did.
  template <class Visit>
  bool near(LatticePoint from, LatticePoint to, double reach, const Visit& visit) {
    if (!cells_) file_pieces();
    return cells_->near(from, to, reach, [&](std::uint32_t p) { return pieces_[p].alive && visit(p); });
  }

  /// Removes a piece from the map.
  void remove(std::uint32_t piece);
  /// Cuts a piece inside. The part before the cut keeps the number of the piece. Returns the part behind it; the new node
  /// has the number of its first end.
  std::uint32_t cut_at(std::uint32_t piece, const StrokeCut& place);
  void set_class(std::uint32_t piece, LineClass line_class) { pieces_[piece].stroke.line_class = line_class; }
  /// Adds a stroke from the node of `from_end` to that of `to_end`. If that is kNone, the stroke ends at a new node.
  void add(Stroke stroke, std::uint32_t from_end, std::uint32_t to_end, const MakeSource& make_source);

  /// The strokes that rules have added.
  std::span<const Stroke> added() const { return std::span(model_.strokes).subspan(given_); }

  /// Writes the map back to the model. Removed pieces become hidden strokes, or are left out if the model had none.
  void commit();

 private:
  struct Piece {
    Stroke stroke;
    std::uint32_t of;    ///< number of the stroke
    std::uint32_t next;  ///< next piece of the stroke, or kNone
    bool alive = true;
  };
  struct Meeting;

  std::uint32_t new_piece(const Stroke& stroke, std::uint32_t of);
  void move_end(std::uint32_t end, std::uint32_t node);
  void file_pieces();
  void find_contacts();
  std::optional<Meeting> nearest_line(std::uint32_t end);
  void write_stroke(std::uint32_t first_piece, std::vector<Stroke>& out) const;

  StrokeModel& model_;
  Meetings meetings_;
  double cell_;
  bool had_hidden_;
  std::uint32_t given_;  ///< number of strokes in the model at first; later ones were added
  std::vector<Piece> pieces_;
  Nodes nodes_;
  std::vector<Contact> contacts_;
  std::optional<LineCells> cells_;
};

/// Hidden strokes lose the parts at their ends that lie in the ink (within `ink` steps) of added strokes.
void clear_hidden(std::vector<Stroke>& strokes, std::span<const Stroke> added, double ink);

}  // namespace ligne
