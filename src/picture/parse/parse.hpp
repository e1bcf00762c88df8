#pragma once
/// From the words of options to values: what all front ends let people write.
///
/// Every function takes the whole text of one option and throws std::invalid_argument when it has no meaning; what() is a
/// phrase that reads well behind the option's name, such as "200 is not between 0 and 180 degrees".

#include <cstddef>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/point.hpp"
#include "linework/stroke.hpp"
#include "picture/models/models.hpp"
#include "picture/requests.hpp"
#include "scene/model/scene.hpp"

namespace ligne {

/// A finite number, "12", "-0.5", "1e3", "+2"; nothing before or behind it.
double parse_number(std::string_view text);

/// A finite number above zero.
double parse_positive(std::string_view text);

/// A number in the open interval (low, high); `unit` stands in the message.
double parse_between(std::string_view text, double low, double high, std::string_view unit);

/// A number in the closed interval [low, high].
double parse_within(std::string_view text, double low, double high, std::string_view unit);

/// A whole number in [low, high].
unsigned parse_count(std::string_view text, unsigned low, unsigned high);

/// "X,Y,Z".
Point3 parse_point(std::string_view text);

/// "X,Y,Z", not all zero.
Point3 parse_vector(std::string_view text);

/// Index of the text among the names.
std::size_t parse_choice(std::string_view text, std::span<const std::string_view> names);

Axis parse_axis(std::string_view text);

/// A comma list of class names; "feature" is all but mesh, "all" is all.
LineClasses parse_edges(std::string_view text);

/// "fit" gives nothing, "N:M" gives N / M.
std::optional<double> parse_scale(std::string_view text);

/// Length of a model unit in mm: "mm", "cm", "m", "in", or a number of mm.
double parse_unit_mm(std::string_view text);

/// A comma list of names, as patterns: \ keeps the character behind it, also a comma.
std::vector<std::string> parse_names(std::string_view text);

/// "NAME=X,Y,Z": model units, or lengths with units (mm, cm, m, in, pt).
PartMove parse_move(std::string_view text);

/// "NAME=COLOUR".
ObjectColor parse_object_color(std::string_view text);

OutputFormat parse_format(std::string_view text);

/// Format by the suffix of the file, any case.
OutputFormat format_of_suffix(const std::filesystem::path& file);

/// The name of a file, not empty.
std::string parse_file_name(const std::string& text);

/// The names as a phrase, "a, b or c".
std::string list_of(std::span<const std::string_view> names);

}  // namespace ligne
