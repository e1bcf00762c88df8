#pragma once
/// Collects what a reader leaves out of its file, for one line: "left out: 3 primitives with EXT_foo, 2 textures".

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ligne {

class Omissions {
 public:
  /// `what` is a noun in the plural, with the name that the file uses: "primitives with EXT_foo". It is made printable here.
  void count(std::string_view what, std::size_t n = 1);

  bool empty() const { return counts_.empty(); }
  /// Kinds in the order in which they were met, each with its number. Kinds beyond the first 16 are counted together.
  const std::vector<std::pair<std::string, std::size_t>>& counts() const { return counts_; }
  /// Number of a kind, 0 where nothing of it was left out.
  std::size_t of(std::string_view what) const;
  /// "3 primitives with EXT_foo, 2 textures"; empty where nothing was left out.
  std::string list() const;
  /// "left out: " and the list; empty where nothing was left out.
  std::string text() const;

 private:
  std::vector<std::pair<std::string, std::size_t>> counts_;
};

}  // namespace ligne
