#pragma once
/// Style sheets of an SVG: what their rules say of an element. Private to plotting.

#include <cstddef>
#include <cstdint>
#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include <pugixml.hpp>

namespace ligne::svg {

/// A part of a style sheet that is not known.
struct UnknownStyle : std::invalid_argument {
  using std::invalid_argument::invalid_argument;
};

/// Rules with selectors made of elements, classes, ids, attributes and `*`, alone or together, one inside the other ("a b",
/// "a > b"), and lists of these. Selectors of what a pointer does (:hover ...) never hold on paper; @font-face, @charset and
/// @namespace say nothing of lines.
class StyleSheet {
 public:
  struct Declaration {
    std::string name, value;
    bool important = false;
  };

  /// Throws UnknownStyle for other selectors and other @-rules, std::invalid_argument for more than 10,000 rules.
  void add(std::string_view css);

  /// What holds for an element, from the weakest to the strongest. Throws std::invalid_argument when all elements together
  /// asked for endless work.
  std::vector<const Declaration*> of(const pugi::xml_node& node) const;

  bool empty() const { return rules_.empty(); }

 private:
  /// "[name]", "[name=value]", "[name~=value]" and so on.
  struct Attribute {
    std::string name, value;
    char how = '\0';  ///< the sign before "=", '=' itself where there is none, '\0' where any value will do
  };
  /// Conditions on one element; empty ones hold for all.
  struct Compound {
    std::string element, id;
    std::vector<std::string> classes;
    std::vector<Attribute> attributes{};
    bool child = false;  ///< of the compound before it, not just inside
  };
  struct Rule {
    std::vector<Compound> path;  ///< from the outside to the element itself
    std::uint32_t weight = 0;    ///< specificity
    std::vector<Declaration> declarations;
  };

  /// Reads classes, names, attributes and states. False where they never hold: for a state that paper does not have.
  static bool take_qualifiers(std::string_view& selector, Compound& compound, Rule& rule);
  /// Reads one selector. False where it selects nothing, ever.
  static bool take_path(std::string_view selector, Rule& rule);
  void add_rule(std::string_view selectors, std::string_view body);
  bool holds(const Compound& compound, const pugi::xml_node& node) const;
  bool holds(const Rule& rule, std::size_t last, const pugi::xml_node& node) const;

  std::vector<Rule> rules_;
  std::unordered_map<std::string, std::vector<std::uint32_t>>
      by_key_;  ///< rules by "#id", ".class", "element" or "*" of the element itself
  mutable std::size_t work_ = 0;
};

/// The declarations of "name: value; name: value".
std::vector<StyleSheet::Declaration> declarations(std::string_view text);

}  // namespace ligne::svg
