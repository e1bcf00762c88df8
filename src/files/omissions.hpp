#pragma once
/// Collects what a reader omits from its file, for one line: "left out: 3 primitives with EXT_foo, 2 textures".

#include <cstddef>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace ligne {

class Omissions {
 public:
  /// Counts `n` items of a kind. `what` is a plural noun with the name that the file uses: "primitives with EXT_foo".
  /// It is made printable.
  void count(std::string_view what, std::size_t n = 1);

  bool empty() const { return counts_.empty(); }
  /// Kinds with their counts, in the order of their first occurrence. Kinds beyond the first 16 are counted together.
  const std::vector<std::pair<std::string, std::size_t>>& counts() const { return counts_; }
  /// Count of a kind; 0 if nothing of it was left out.
  std::size_t of(std::string_view what) const;
  /// "3 primitives with EXT_foo, 2 textures"; empty if nothing was left out. Of many kinds, it names the most frequent
  /// ones.
  std::string list() const;
  /// The omissions that can change a line: all but textures, which only areas of faces would show.
  Omissions of_lines() const;
  /// "left out: " and the list; empty if nothing was left out.
  std::string text() const;

 private:
  std::vector<std::pair<std::string, std::size_t>> counts_;
};

}  // namespace ligne
