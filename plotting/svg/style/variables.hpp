#pragma once
/// Custom properties of CSS ("--name: value"), and var() of them. Private to plotting.

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>

namespace ligne::svg {

struct Variables;
/// Those that hold for an element; nullptr: none.
using VariablesPointer = std::shared_ptr<const Variables>;

struct Variables {
  std::map<std::string, std::string, std::less<>> values{};
  VariablesPointer outer{};  ///< of the elements around
};

/// Adds those that an element defines, with the var() in their values resolved. Those that lead back to themselves, or to
/// none, are as if they were not there.
VariablesPointer with_variables(VariablesPointer outer, std::map<std::string, std::string, std::less<>> defined);

/// The value with all var(--name, otherwise) replaced; nothing where one has neither a value nor another in its place, and
/// where the value would become longer than 64 KiB.
std::optional<std::string> resolved(std::string_view value, const VariablesPointer& variables);

}  // namespace ligne::svg
