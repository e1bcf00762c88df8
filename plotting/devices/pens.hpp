#pragma once
/// Pens, and the assignment of layers to pens.

#include <array>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ligne {

/// A pen and its settings. The signs in quotes encode a setting in the name of a layer (layer_label()).
struct Pen {
  unsigned number = 1;
  std::string name{};  ///< shown to the operator who inserts the pen; may be empty
  std::array<double, 3> color{0, 0, 0};
  std::optional<double> width_mm{};    ///< nothing: the width of the lines
  bool skip = false;                   ///< "%": the plotter software omits the layer
  bool pause = false;                  ///< "!": the plotter software waits before the layer
  std::optional<unsigned> speed{};     ///< "+S": pen speed, percent
  std::optional<unsigned> height{};    ///< "+H": pen height, percent
  std::optional<unsigned> delay_ms{};  ///< "+D": delay
  std::string label{};                 ///< label of its layer, if given; empty: layer_label() makes one
};

/// Largest values that are accepted: pen number, degree of darkness, percentage, delay.
inline constexpr unsigned kMostPens = 1000, kMostPenShades = 4, kMostPercent = 100, kMostDelayMs = 600'000;

/// Name of the layer of a pen in an SVG, as Inkscape, vpype and the AxiDraw software read it: "2 name", with "%" and
/// "!" before the number and the settings after it.
std::string layer_label(const Pen& pen);

/// The pen number and settings that the name of a layer contains. A layer whose name begins with "%" is not plotted.
struct LayerLabel {
  unsigned number = 0;  ///< 0: the name contains none
  bool skip = false, pause = false;
  std::optional<unsigned> speed, height, delay_ms;
  std::string name;  ///< the rest of the name
};
/// Parses the name of a layer.
LayerLabel parse_layer_label(std::string_view label);

/// The pens, and the rules that assign layers to them by pen number. Layers without a rule go to pen `rest`.
struct PenTable {
  std::map<unsigned, Pen> pens;
  std::map<std::string, unsigned, std::less<>> pen_of_layer;
  std::map<std::string, unsigned, std::less<>> pen_of_material;
  std::vector<std::pair<std::string, unsigned>> pen_of_object;  ///< by patterns of names; the last match applies
  std::map<unsigned, unsigned> pen_of_shade;                    ///< of hatching, by darkness; 1 is the darkest
  unsigned rest = 1;
  bool names_rest = false;  ///< the user set `rest`: numbers in layer names are then ignored

  bool empty() const { return pens.empty(); }
  /// Number of the pen that a rule assigns to a layer; nothing if no rule applies.
  std::optional<unsigned> named_pen_of(std::string_view layer, std::string_view material, unsigned shade = 0,
                                       const std::string& object = {}) const;
  /// Number of the pen of a layer: by the first rule for its shade, its object, its material or its name, in this
  /// order. A layer without a rule whose name begins with a number gets the pen of that number.
  unsigned pen_of(std::string_view layer, std::string_view material, unsigned shade = 0,
                  const std::string& object = {}) const;
  /// The pen of that number; one with default settings if the table does not describe it.
  Pen pen(unsigned number) const;
};

/// Parses a colour: "#rgb", "#rrggbb" or a name of CSS in lower case. Throws std::invalid_argument.
std::array<double, 3> parse_color(std::string_view text);
/// The code of a colour, "#rrggbb".
std::string color_code(const std::array<double, 3>& color);

/// Adds a rule such as "CLASS=N", "CLASS=N,COLOUR" or "CLASS=N,COLOUR,WIDTH" to a table. CLASS is a layer,
/// "object:NAME", "material:NAME", "shade:N", or "rest" for all others. Throws std::invalid_argument.
void add_pen(PenTable& table, std::string_view text);

/// Reads a table of pens in TOML (docs/plotting.md). Throws std::runtime_error, "FILE:LINE: cause".
PenTable read_pens(std::string_view toml, const std::string& name);

}  // namespace ligne
