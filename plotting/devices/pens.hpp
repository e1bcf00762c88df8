#pragma once
/// Pens, and which of them draws what.

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ligne {

struct Pen {
  unsigned number = 1;
  std::string name;  ///< shown to whoever puts the pen in; may be empty
  std::array<double, 3> color{0, 0, 0};
  std::optional<double> width_mm;    ///< nothing: that of the lines
  bool skip = false;                 ///< "%": the software of the machine leaves the layer out
  bool pause = false;                ///< "!": it waits before the layer
  std::optional<unsigned> speed;     ///< "+S": percent
  std::optional<unsigned> height;    ///< "+H": percent
  std::optional<unsigned> delay_ms;  ///< "+D"
  std::string label;                 ///< of its layer, where that has one already; empty: made of the above
};

inline constexpr unsigned kMostPens = 1000, kMostPenShades = 4, kMostPercent = 100, kMostDelayMs = 600'000;

/// Name of a pen's layer in an SVG as Inkscape, vpype and the AxiDraw software read it: "2 name", with the signs before the
/// number and the settings behind it.
std::string layer_label(const Pen& pen);

/// The pen that the name of a layer asks for, in the words of pens. A layer whose name begins with "%" is not plotted.
struct LayerLabel {
  unsigned number = 0;  ///< 0: it tells none
  bool skip = false, pause = false;
  std::optional<unsigned> speed, height, delay_ms;
  std::string name;  ///< what is left
};
LayerLabel parse_layer_label(std::string_view label);

/// The pens, and for layers their number. What is not named goes to pen `rest`.
struct PenTable {
  std::map<unsigned, Pen> pens;
  std::map<std::string, unsigned, std::less<>> pen_of_layer;
  std::map<std::string, unsigned, std::less<>> pen_of_material;
  std::vector<std::pair<std::string, unsigned>> pen_of_object;  ///< by patterns of names as of a shell; the last that fits
  std::map<unsigned, unsigned> pen_of_shade;                    ///< of hatching: degrees of darkness from 1, the darkest
  unsigned rest = 1;
  bool names_rest = false;  ///< somebody said which pen that is: then numbers in names of layers do not count

  bool empty() const { return pens.empty(); }
  /// Number of the pen that the table names for a layer; nothing where it names none.
  std::optional<unsigned> named_pen_of(std::string_view layer, std::string_view material, unsigned shade = 0,
                                       const std::string& object = {}) const;
  /// Number of the pen of a layer: by its shade, its object, its material, its name, whatever is named, in this order. A
  /// layer that nothing is said of and whose name begins with a number has the pen of that number.
  unsigned pen_of(std::string_view layer, std::string_view material, unsigned shade = 0,
                  const std::string& object = {}) const;
  /// The pen of that number, also when the table does not describe it.
  Pen pen(unsigned number) const;
};

/// "#rgb", "#rrggbb" or one of the sixteen names of CSS 1. Throws std::invalid_argument.
std::array<double, 3> parse_color(std::string_view text);
/// The code of a colour, "#rrggbb".
std::string color_code(const std::array<double, 3>& color);

/// "CLASS=N", "CLASS=N,COLOUR" or "CLASS=N,COLOUR,WIDTH"; CLASS is a layer, "object:NAME", "material:NAME", "shade:N" or
/// "rest" for all others. Throws std::invalid_argument.
void add_pen(PenTable& table, std::string_view text);

/// A table of pens as TOML, docs/plotting.md. Throws std::runtime_error, "FILE:LINE: what is wrong".
PenTable read_pens(std::string_view toml, const std::string& name);

}  // namespace ligne
