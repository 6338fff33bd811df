#include "scene/legend.h"

#include "scene/limits.h"

#include <algorithm>
#include <cstdio>

namespace slicecast {
namespace {

constexpr std::size_t kMostReportedPerRow = 16;  // different characters

// A character as a message shows it.
std::string shownCharacter(char32_t c) {
    if (c == ' ') return "a space";
    if (isPrintable(c)) return "'" + toUtf8(c) + "'";
    char digits[16];
    std::snprintf(digits, sizeof digits, "U+%04X", static_cast<unsigned>(c));
    return std::string("the invisible character ") + digits;
}

}  // namespace

Legend::Legend(std::uint16_t dot, std::uint16_t space) {
    ascii_.fill(kNone);
    ascii_['.'] = dot;
    ascii_[' '] = space;
}

void Legend::set(char32_t character, std::uint16_t id) {
    if (!find(character)) order_.push_back(character);
    if (character < ascii_.size()) {
        ascii_[character] = id;
    } else {
        others_[character] = id;
    }
}

std::optional<std::uint16_t> Legend::find(char32_t character) const {
    if (character < ascii_.size()) {
        if (ascii_[character] != kNone) return static_cast<std::uint16_t>(ascii_[character]);
    } else {
        const auto other = others_.find(character);
        if (other != others_.end()) return other->second;
    }
    if (takesAny_) return std::uint16_t{0};
    return std::nullopt;
}

std::string Legend::characters() const {
    constexpr std::size_t kMostShown = 24;
    std::string list;
    for (std::size_t i = 0; i < std::min(order_.size(), kMostShown); ++i) list += shownCharacter(order_[i]) + ", ";
    if (order_.size() > kMostShown) list += "..., ";
    return list + "'.' or a space";
}

void readLegend(Checker& checker, JsonValue value, const NameTable& names, const std::string& what, Legend& legend) {
    if (!value.isObject()) {
        checker.add(value, checker.shown(value), "a legend: an object with a " + what + "'s name for each character");
        legend.takeAny();
        return;
    }
    if (value.count() > kMaxLegend) {
        checker.add(value, counted(static_cast<std::int64_t>(value.count()), "character"), "at most " + std::to_string(kMaxLegend));
        legend.takeAny();
        return;
    }
    for (const JsonValue member : value) {
        const std::string_view key = member.key();
        std::size_t end = 0;
        const char32_t character = key.empty() ? 0 : takeCodePoint(key, end);
        const bool isSingle = !key.empty() && end == key.size();
        const bool isReserved = key == "." || key == " ";
        if (isReserved) {
            checker.addAtKey(member, "the key " + quoted(key), "another character; '.' and the space have a meaning of their own");
        } else if (isSingle && !isPrintable(character)) {
            checker.addAtKey(member, "a key that is " + shownCharacter(character), "a single character that can be seen");
        } else if (!isSingle) {
            checker.addAtKey(member, "the key " + quoted(key), "a single character that can be seen");
        }
        const std::uint16_t id = checker.name(member, names, what).value_or(0);
        // A character of a faulty key, or with a faulty meaning, is known all the same: its uses in the grids are no faults of their own.
        for (std::size_t offset = 0; offset < key.size() && !isReserved;) {
            const char32_t meant = takeCodePoint(key, offset);
            if (isSingle || !legend.find(meant)) legend.set(meant, id);
        }
    }
}

void readRow(Checker& checker, JsonValue value, int row, int width, const Legend& legend, std::vector<std::uint16_t>& ids) {
    const std::string_view text = value.text();
    std::vector<char32_t> reported;
    std::size_t offset = 0;
    int x = 0;
    for (; offset < text.size(); ++x) {
        const char32_t character = takeCodePoint(text, offset);
        const std::optional<std::uint16_t> id = legend.find(character);
        if (id) {
            if (x < width) ids[static_cast<std::size_t>(x)] = *id;
        } else if (reported.size() < kMostReportedPerRow && std::find(reported.begin(), reported.end(), character) == reported.end()) {
            // Once per row: a character that was forgotten in the legend would fill the list otherwise.
            reported.push_back(character);
            checker.addInRow(value, row, x, shownCharacter(character), "a character of the legend: " + legend.characters());
        }
    }
    if (x != width) {
        checker.addInRow(value, row, std::min(x, width), "a row of " + counted(x, "character"), counted(width, "character") + ", as in the other rows");
    }
}

}  // namespace slicecast
