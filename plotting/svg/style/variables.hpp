#pragma once
/// Custom properties of CSS ("--name: value"), and var() of them. Private to plotting.

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace ligne::svg {

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
