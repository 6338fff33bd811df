// Values with their names in one table, so that no list has to follow the order of another:
//
//     constexpr Named<Press> kPresses[] = {{Press::hold, "hold"}, {Press::once, "press"}};
//     nameOf(kPresses, Press::once)       "press"
//     valueOf(kPresses, "hold")           Press::hold; nothing for a name that is not there
//     kJoinedNames<kPresses>.data()       "hold press"
#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string_view>
#include <type_traits>

namespace slicecast {

template <typename Value>
struct Named {
    Value value;
    const char* name;
};

// Empty for a value that is not in the table.
template <typename Value, std::size_t count>
constexpr const char* nameOf(const Named<Value> (&table)[count],
                             std::type_identity_t<Value> value) {
    for (const Named<Value>& named : table) {
        if (named.value == value) return named.name;
    }
    return "";
}

template <typename Value, std::size_t count>
constexpr std::optional<Value> valueOf(const Named<Value> (&table)[count], std::string_view name) {
    for (const Named<Value>& named : table) {
        if (named.name == name) return named.value;
    }
    return std::nullopt;
}

// The names with a space between them, and a zero at the end.
template <const auto& table>
constexpr auto kJoinedNames = [] {
    constexpr std::size_t kJoinedSize = [] {
        std::size_t size = 0;
        for (const auto& named : table) size += std::string_view(named.name).size() + 1;
        return size;
    }();
    std::array<char, kJoinedSize> text{};
    std::size_t end = 0;
    for (const auto& named : table) {
        for (const char c : std::string_view(named.name)) text[end++] = c;
        text[end++] = ' ';
    }
    text[end - 1] = '\0';
    return text;
}();

}  // namespace slicecast
