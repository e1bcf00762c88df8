#pragma once
/// The seven parts by which [Boulle1980] 1.2.1.2 describes a method, of every method of the registry. `ligne methods
/// --json`, the page of `ligne compare` and the tables in docs/methods are made from them.

#include <array>
#include <string_view>

namespace ligne {

struct MethodPart {
  std::string_view symbol;   ///< as in [Boulle1980], Greek letters by their names
  std::string_view meaning;  ///< noun phrase
};
inline constexpr std::array<MethodPart, 7> kMethodParts{{{"MD", "description model"},
                                                         {"Td", "initial sort"},
                                                         {"Psi", "elementary operations"},
                                                         {"sigma", "strategy"},
                                                         {"Ti", "intermediate sorts"},
                                                         {"RI", "intermediate representations"},
                                                         {"MV", "visibility model"}}};

/// The parts of a method in the order of kMethodParts, with names of files and types in backticks.
using SevenParts = std::array<std::string_view, kMethodParts.size()>;

/// The parts of the method with that name, or null.
const SevenParts* seven_parts_of(std::string_view method);

}  // namespace ligne
