// Finds numbers by names.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <unordered_map>

namespace slicecast {

class NameIndex {
public:
    // The name's number: this one, or the one that it has already. The name's characters must
    // outlive the index.
    std::uint32_t add(std::string_view name, std::uint32_t number);
    std::optional<std::uint32_t> find(std::string_view name) const;

private:
    std::unordered_map<std::string_view, std::uint32_t> numbers_;
};

}  // namespace slicecast
