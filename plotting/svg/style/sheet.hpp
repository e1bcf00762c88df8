#pragma once
/// Style sheets of an SVG: the declarations that hold for an element. Private to plotting.

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "plotting/svg/style/css_text.hpp"
#include "plotting/svg/style/selector.hpp"

namespace ligne::svg {

/// Rules of style. Selectors of pointer states (:hover ...) never hold on paper; @font-face, @charset and @namespace do
/// not affect lines. Rules hold for the media all and print, not for a screen, since a plotter draws on paper.
class StyleSheet {
 public:
  /// Called for each unknown part, with a noun in the plural: "@import rules".
  using Unknown = std::function<void(const std::string& kind)>;

  /// `media`: media of the <style> element; empty: all. Throws WorkLimitError for more than 10,000 rules.
  void add(std::string_view css, std::string_view media, const Unknown& unknown);

  /// Declarations that hold for an element, from the weakest to the strongest. Throws WorkLimitError if all elements
  /// together take too many comparisons.
  std::vector<const Declaration*> of(const pugi::xml_node& node) const;

  bool empty() const { return rules_.empty(); }
  /// Whether any rule sets the property.
  bool sets(std::string_view property) const;

 private:
  struct Rule {
    Selector selector;
    std::uint32_t declarations = 0;  ///< index in declarations_, shared by the selectors of a list
  };

  void add_statements(std::string_view text, int depth, const Unknown& unknown);
  void add_at_rule(std::string_view& text, int depth, const Unknown& unknown);
  void add_rules(std::string_view selectors, std::string_view body, const Unknown& unknown);

  std::vector<Rule> rules_;
  std::vector<std::vector<Declaration>> declarations_;
  std::unordered_map<std::string, std::vector<std::uint32_t>>
      by_key_;  ///< rules by "#id", ".class", "element" or "*" of the element itself
  mutable StyleWork work_;
};

/// Custom properties of CSS ("--name: value"), and var() of them. Private to plotting.
struct Variables;
/// Custom properties that hold for an element; nullptr: none.
using VariablesPointer = std::shared_ptr<const Variables>;

struct Variables {
  std::map<std::string, std::string, std::less<>> values{};
  VariablesPointer outer{};  ///< properties of the elements around
};

/// Adds the properties that an element defines, with var() in their values resolved. A property that leads back to
/// itself, or to a missing one, is left out.
VariablesPointer with_variables(VariablesPointer outer, std::map<std::string, std::string, std::less<>> defined);

/// The value with all var(--name, fallback) replaced; nothing if one has neither a value nor a fallback, or if the
/// value would become longer than 64 KiB.
std::optional<std::string> resolved(std::string_view value, const VariablesPointer& variables);

}  // namespace ligne::svg
