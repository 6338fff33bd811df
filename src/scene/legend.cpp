#include "scene/legend.h"

#include "base/number_text.h"
#include "scene/limits.h"

#include <algorithm>

namespace slicecast {
namespace {

constexpr std::size_t kMostReportedPerRow = 16;  // different characters

// A character as a message shows it.
std::string shownCharacter(char32_t c) {
    if (c == ' ') return "a space";
    if (isPrintable(c)) return words("'", toUtf8(c), "'");
    std::string digits(hexText(c, c > 0xfffff ? 6 : c > 0xffff ? 5 : 4));
    for (char& digit : digits) {
        if (digit >= 'a') digit = static_cast<char>(digit - 'a' + 'A');
    }
    return words("the invisible character U+", digits);
}

}  // namespace

Legend::Legend(std::uint16_t dot, std::uint16_t space) : dot_(dot), space_(space) {
    ascii_.fill(kNone);
}

std::int32_t Legend::entryOf(char32_t character) const {
    if (character < ascii_.size()) return ascii_[character];
    const auto other =
        std::lower_bound(others_.begin(), others_.end(), std::pair(character, std::int32_t{0}));
    return other != others_.end() && other->first == character ? other->second : kNone;
}

void Legend::set(char32_t character, std::uint16_t id) {
    const std::int32_t known = entryOf(character);
    if (known != kNone) {
        entries_[static_cast<std::size_t>(known)].second = id;
        return;
    }
    const auto entry = static_cast<std::int32_t>(entries_.size());
    entries_.emplace_back(character, id);
    if (character < ascii_.size()) {
        ascii_[character] = entry;
    } else {
        const std::pair other(character, entry);
        others_.insert(std::lower_bound(others_.begin(), others_.end(), other), other);
    }
}

std::optional<std::uint16_t> Legend::find(char32_t character) const {
    if (character == U'.') return dot_;
    if (character == U' ') return space_;
    const std::int32_t entry = entryOf(character);
    if (entry != kNone) return entries_[static_cast<std::size_t>(entry)].second;
    if (takesAny_) return std::uint16_t{0};
    return std::nullopt;
}

std::string Legend::characters() const {
    constexpr std::size_t kMostShown = 24;
    std::string list;
    for (std::size_t i = 0; i < std::min(entries_.size(), kMostShown); ++i)
        add(list, {shownCharacter(entries_[i].first), ", "});
    if (entries_.size() > kMostShown) list += "..., ";
    return words(list, "'.' or a space");
}

void readLegend(Checker& checker, JsonValue value, const NameTable& names, const char* what,
                Legend& legend) {
    if (!value.isObject()) {
        checker.refuse(value, {"a legend: an object with a ", what, "'s name for each character"});
        legend.takeAny();
        return;
    }
    if (value.count() > kMaxLegend) {
        checker.add(value, Counted{static_cast<std::int64_t>(value.count()), "character"},
                    {"at most ", kMaxLegend});
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
            checker.addAtKey(member, {"the key ", quoted(key)},
                             "another character: '.' and the space already have a meaning");
        } else if (isSingle && !isPrintable(character)) {
            checker.addAtKey(member, {"a key that is ", shownCharacter(character)},
                             "a single visible character");
        } else if (!isSingle) {
            checker.addAtKey(member, {"the key ", quoted(key)}, "a single visible character");
        }
        const std::uint16_t id = checker.name(member, names, what).value_or(0);
        // Characters of faulty entries count as known, so that their uses in grids are not reported
        // too.
        std::size_t offset = 0;
        for (std::size_t taken = 0; offset < key.size() && taken < kMaxNameLength && !isReserved;
             ++taken) {
            const char32_t meant = takeCodePoint(key, offset);
            if (isSingle || !legend.find(meant)) legend.set(meant, id);
        }
    }
}

void readRow(Checker& checker, JsonValue value, int row, int width, const Legend& legend,
             std::vector<std::uint16_t>& ids) {
    const std::string_view text = value.text();
    std::vector<char32_t> reported;
    std::size_t offset = 0;
    int x = 0;
    for (; offset < text.size(); ++x) {
        const char32_t character = takeCodePoint(text, offset);
        const std::optional<std::uint16_t> id = legend.find(character);
        if (id) {
            if (x < width) ids[static_cast<std::size_t>(x)] = *id;
        } else if (reported.size() < kMostReportedPerRow &&
                   std::find(reported.begin(), reported.end(), character) == reported.end()) {
            // Once per row, or a character that the legend lacks would fill the list.
            reported.push_back(character);
            checker.addInRow(value, row, x, shownCharacter(character),
                             {"a character of the legend: ", legend.characters()});
        }
    }
    if (x != width) {
        checker.addInRow(value, row, std::min(x, width), {"a row of ", Counted{x, "character"}},
                         {Counted{width, "character"}, ", as in the other rows"});
    }
}

}  // namespace slicecast
