#include "scene/legend.h"
#include "base/later_text.h"

#include "scene/limits.h"

#include <algorithm>

namespace slicecast {
namespace {

constexpr std::size_t kMostReportedPerRow = 16;  // different signs

// A sign as a message shows it; with its code points, if one cannot see them all.
std::string shownSign(std::string_view sign) {
    if (sign == " ") return "a space";
    std::size_t end = 0;
    if (!isPrintable(takeCodePoint(sign, end)))
        return words("the invisible character ", codePointsOf(sign));
    const bool isPlain = end == sign.size() && isPrintableSign(sign);
    return isPlain ? words("'", sign, "'") : words("'", sign, "' (", codePointsOf(sign), ")");
}

__attribute__((noinline)) void refuseSign(Checker& checker, JsonValue member,
                                          std::string_view first, bool isReserved, bool isSingle) {
    if (isReserved) {
        checker.addAtKey(member, {"the key ", quoted(member.key())},
                         "another character: '.' and the space already have a meaning"_later);
    } else if (isSingle) {
        checker.addAtKey(member, {"a key that is ", shownSign(first)},
                         "a single visible character"_later);
    } else {
        checker.addAtKey(member, {"the key ", quoted(member.key())},
                         "a single visible character"_later);
    }
}

}  // namespace

Legend::Legend(std::uint16_t dot, std::uint16_t space) : dot_(dot), space_(space) {
    ascii_.fill(kNone);
}

std::int32_t Legend::entryOf(std::string_view sign) const {
    if (sign.size() == 1) return ascii_[static_cast<unsigned char>(sign[0])];
    const std::optional<std::uint32_t> entry = others_.find(sign);
    return entry ? static_cast<std::int32_t>(*entry) : kNone;
}

void Legend::set(std::string_view sign, std::uint16_t id) {
    const std::int32_t known = entryOf(sign);
    if (known != kNone) {
        entries_[static_cast<std::size_t>(known)].second = id;
        return;
    }
    const auto entry = static_cast<std::int32_t>(entries_.size());
    entries_.emplace_back(sign, id);
    if (sign.size() == 1)
        ascii_[static_cast<unsigned char>(sign[0])] = entry;
    else
        others_.add(sign, static_cast<std::uint32_t>(entry));
}

std::optional<std::uint16_t> Legend::find(std::string_view sign) const {
    if (sign == ".") return dot_;
    if (sign == " ") return space_;
    const std::int32_t entry = entryOf(sign);
    if (entry != kNone) return entries_[static_cast<std::size_t>(entry)].second;
    if (takesAny_) return std::uint16_t{0};
    return std::nullopt;
}

std::string Legend::characters() const {
    constexpr std::size_t kMostShown = 24;
    std::string list;
    for (std::size_t i = 0; i < std::min(entries_.size(), kMostShown); ++i)
        add(list, {shownSign(entries_[i].first), ", "});
    if (entries_.size() > kMostShown) list += "..., ";
    return words(list, "'.' or a space");
}

void readLegend(Checker& checker, JsonValue value, const NameTable* names, const char* what,
                Legend& legend) {
    if (!value.isObject()) {
        checker.refuse(
            value, {"a legend: an object with a "_later, what, "'s name for each character"_later});
        legend.takeAny();
        return;
    }
    if (value.count() > kMaxLegend) {
        checker.add(value, Counted{static_cast<std::int64_t>(value.count()), "character"},
                    {"at most ", kMaxLegend});
        legend.takeAny();
        return;
    }
    std::uint16_t number = 0;
    for (const JsonValue member : value) {
        const std::string_view key = member.key();
        std::size_t end = 0;
        const std::string_view first = key.empty() ? key : takeSign(key, end);
        const bool isSingle = !key.empty() && end == key.size();
        const bool isReserved = key == "." || key == " ";
        if (isReserved || !isSingle || !isPrintableSign(first))
            refuseSign(checker, member, first, isReserved, isSingle);
        const std::uint16_t id = names ? checker.name(member, *names, what).value_or(0) : number++;
        // Signs of faulty entries count as known, so that their uses in grids are not reported too.
        std::size_t offset = 0;
        for (std::size_t taken = 0; offset < key.size() && taken < kMaxNameLength && !isReserved;
             ++taken) {
            const std::string_view meant = takeSign(key, offset);
            if (isSingle || !legend.find(meant)) legend.set(meant, id);
        }
    }
}

void readRow(Checker& checker, JsonValue value, int row, int width, const Legend& legend,
             std::vector<std::uint16_t>& ids, bool spacesKeep) {
    const std::string_view text = value.text();
    std::vector<std::string_view> reported;
    std::size_t offset = 0;
    int x = 0;
    for (; offset < text.size(); ++x) {
        const std::string_view sign = takeSign(text, offset);
        const std::optional<std::uint16_t> id = legend.find(sign);
        if (id) {
            if (x < width && !(spacesKeep && sign == " ")) ids[static_cast<std::size_t>(x)] = *id;
        } else if (reported.size() < kMostReportedPerRow &&
                   std::find(reported.begin(), reported.end(), sign) == reported.end()) {
            // Once per row, or a sign that the legend lacks would fill the list.
            reported.push_back(sign);
            checker.addInRow(value, row, x, shownSign(sign),
                             {"a character of the legend: "_later, legend.characters()});
        }
    }
    if (x != width) {
        checker.addInRow(value, row, std::min(x, width), {"a row of ", Counted{x, "character"}},
                         {Counted{width, "character"}, ", as in the other rows"_later});
    }
}

__attribute__((noinline)) std::uint16_t readSign(Checker& checker, JsonValue value,
                                                 const Legend& legend) {
    if (value.isText()) {
        if (const auto id = legend.find(value.text())) return *id;
    }
    checker.refuse(value, {"a character of the legend: "_later, legend.characters()});
    return 0;
}

}  // namespace slicecast
