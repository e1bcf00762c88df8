#pragma once
/// Warnings about input. Includes the header of input errors.

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "files/input_error.hpp"
#include "files/message_text.hpp"
#include "files/omissions.hpp"

namespace ligne {

/// Collects warnings while a file is read: repairs and omissions, counted by kind, so that a thousand of one kind are
/// one line.
class Warnings {
 public:
  /// `kind` is a phrase such as "faces with fewer than three distinct vertices dropped".
  void add(const std::string& kind, std::size_t n = 1) {
    if (n != 0) counts_[kind] += n;
  }
  /// Counts omissions of the reader, all of which are listed in one line. `what` is a noun such as "primitives with
  /// EXT_foo".
  void leave_out(std::string_view what, std::size_t n = 1) { left_out_.count(what, n); }

  const std::map<std::string, std::size_t>& counts() const { return counts_; }
  const Omissions& left_out() const { return left_out_; }
  /// One line per kind, and one line with all omissions; `with_areas`: also those that only areas of faces would show.
  std::vector<std::string> lines(bool with_areas = true) const {
    std::vector<std::string> lines;
    for (const auto& [kind, n] : counts_) lines.push_back(counted(n, kind));
    const Omissions listed = with_areas ? left_out_ : left_out_.of_lines();
    if (!listed.empty()) lines.push_back(listed.text());
    return lines;
  }

 private:
  std::map<std::string, std::size_t> counts_;
  Omissions left_out_;
};

}  // namespace ligne
