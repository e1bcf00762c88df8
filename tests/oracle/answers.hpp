#pragma once
/// All that the oracle says of the lines of a scene in one view, kept between runs of the tests: exact arithmetic takes most
/// of the time of a small scene.

#include "oracle/oracle.hpp"

namespace oracle {

struct Answers {
  std::vector<Edge> edges;
  std::vector<std::vector<Interval>> edge_intervals;  ///< by edge
  std::vector<Intersection> intersections;
  std::vector<std::vector<Interval>> intersection_intervals;  ///< by intersection
  friend bool operator==(const Answers&, const Answers&) = default;
};

/// Asks the oracle.
Answers answers_of(const Oracle& oracle);

/// Reads the answers from the folder that LIGNE_ORACLE_CACHE names, or asks the oracle and writes them there. Without that
/// variable it asks each time.
Answers answers_of(const ligne::Scene& scene, const View& view, double crease_degrees, Glass glass);

/// The name of the file of these answers: a hash of all that the oracle reads of the scene and the view, and of its source.
std::string answers_name(const ligne::Scene& scene, const View& view, double crease_degrees, Glass glass);

/// The answers in the file; false where it is not there or not whole.
bool read_answers(const std::filesystem::path& file, Answers& answers);
/// Writes beside the file and renames, so that programs that write it at once do not disturb each other. A failure leaves no
/// file.
void write_answers(const std::filesystem::path& file, const Answers& answers);

}  // namespace oracle
